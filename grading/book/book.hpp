#pragma once

// The book for the command line: chapters, exercises and misconceptions, read from their folders.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "../text/near_names.hpp"

namespace contact::grading {

/// A fault in the book's own files or in the set-up, which the reader or author must correct.
class BookError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A name that belongs to no exercise or chapter.
class UnknownName : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a student may see of a test.
enum class Visibility {
  shown,            ///< everything
  after_due,        ///< name and points; everything once the due date has passed
  values_withheld,  ///< how it ended, the question and the hint; no input, no answer
  hidden            ///< nothing but that there are such tests
};

/// As in exercise.toml: "values_withheld".
std::string_view key(Visibility visibility);
std::optional<Visibility> visibility_from_key(std::string_view key);

/// One test of an exercise, as exercise.toml lists it.
struct TestSpec {
  std::string name;
  double points = 0.0;
  /// Tests that must have passed for this one to count.
  std::vector<std::string> needs;
  Visibility visibility = Visibility::shown;
  /// From an instructor's folder and not from the book.
  bool is_private = false;
  /// Processor time that the solution needs. A file names it only where it is more than this.
  double solution_seconds = 0.05;
};

struct Objective {
  std::string id;
  std::string text;
};

struct Misconception {
  std::string id;
  std::string summary;
  std::string hint;
};

struct Exercise {
  std::string chapter;
  std::string name;
  std::string title;
  std::string objective;
  std::string kind;
  std::string brief;
  double minutes = 0.0;
  std::vector<std::string> hints;
  std::vector<std::string> misconceptions;
  /// Of kind "break": the name of the given file, which is wrong; empty in other exercises.
  std::string breaks;
  /// Seconds of processor time that one test may use in grading.
  double time_limit = 5.0;
  std::vector<TestSpec> tests;

  std::filesystem::path folder;         ///< exercises/NN_slug/NAME
  std::filesystem::path contract;       ///< the header that states what is asked
  std::filesystem::path stub;           ///< the pristine starting point
  std::filesystem::path given;          ///< what is to be broken; empty if nothing is
  std::filesystem::path solution;       ///< solutions/NN_slug/NAME/NAME.cpp
  std::filesystem::path wrong_answers;  ///< solutions/NN_slug/NAME/wrong
  std::filesystem::path test_source;    ///< tests/NN_slug/NAME_test.cpp

  [[nodiscard]] std::string id() const { return chapter + "/" + name; }
  [[nodiscard]] double max_points() const;
  /// Seconds of processor time that a test may use in a check of one's own: twenty times those of
  /// the solution, at most three, and never more than in grading.
  [[nodiscard]] double check_seconds(const TestSpec& test) const;
};

struct Chapter {
  std::string slug;
  std::string title;
  std::string status;
  std::string tooltip;
  int part = 0;
  std::vector<std::string> builds_on;
  std::vector<std::string> recall;
  std::vector<std::string> exercise_names;
  std::vector<Objective> objectives;
  std::filesystem::path folder;
};

/// A file of the book that could not be read, and why.
struct BookProblem {
  std::filesystem::path file;
  std::string what;
};

/// Everything under one project root: the book's, or that of a pack of chapters and exercises that
/// are used with the book. A broken file is kept as a problem, so that the rest stays usable.
class Book {
 public:
  /// Reads the folders under `root`; the student's copies live in `work`.
  /// @param base the book itself if this is a pack (grading/book/pack.hpp), else none
  Book(std::filesystem::path root, std::filesystem::path work,
       std::shared_ptr<const Book> base = nullptr);

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  /// The folder with the program, its scripts and what all exercises share; root() except in a
  /// pack.
  [[nodiscard]] const std::filesystem::path& book_root() const {
    return base_ ? base_->root() : root_;
  }
  /// The book with which a pack is used; none for the book itself.
  [[nodiscard]] const Book* base() const { return base_.get(); }
  [[nodiscard]] const std::filesystem::path& work() const { return work_; }
  [[nodiscard]] std::filesystem::path build_dir() const { return root_ / "build" / "dev"; }

  /// Chapters in the order of their numbers; of a pack, its own only.
  [[nodiscard]] const std::vector<Chapter>& chapters() const { return chapters_; }
  /// Exercises in the order of chapter.toml, chapter by chapter.
  [[nodiscard]] const std::vector<Exercise>& exercises() const { return exercises_; }
  [[nodiscard]] const std::map<std::string, Misconception>& misconceptions() const {
    return misconceptions_;
  }
  [[nodiscard]] const std::vector<BookProblem>& problems() const { return problems_; }

  [[nodiscard]] std::filesystem::path work_file(const Exercise& exercise) const;
  [[nodiscard]] bool started(const Exercise& exercise) const;

  /// The exercise meant by a short name, by NN_slug/NAME or by a path to one of its files.
  /// @throws UnknownName, with the nearest names, if there is none or more than one.
  [[nodiscard]] const Exercise& exercise(std::string_view name) const;
  [[nodiscard]] const Exercise* find_exercise(std::string_view name) const;

  /// The chapter meant by NN_slug, by its number or by its slug without the number.
  [[nodiscard]] const Chapter* find_chapter(std::string_view name) const;

  /// The chapter of exactly this slug, which a pack's chapter may build on: of the book too.
  [[nodiscard]] const Chapter* chapter_called(std::string_view slug) const;

  [[nodiscard]] std::vector<const Exercise*> exercises_of(const Chapter& chapter) const;

  /// The exercises meant by a name: the one it names, or all of the chapter that it names.
  /// @throws UnknownName, with the nearest names, if it is neither an exercise's nor a chapter's.
  [[nodiscard]] std::vector<const Exercise*> meant_by(std::string_view name) const;

  /// The exercises and chapters meant by these names, in the book's order, each exercise once; all
  /// exercises if no name is given.
  /// @throws UnknownName if a name is neither an exercise's nor a chapter's.
  [[nodiscard]] std::vector<const Exercise*> chosen(const std::vector<std::string>& names) const;

  /// The hint for a misconception, of a pack or of its book; empty if there is none.
  [[nodiscard]] std::string hint_for(const std::string& misconception) const;
  /// What goes wrong, in one clause without a full stop; empty if the book does not know it.
  [[nodiscard]] std::string summary_of(const std::string& misconception) const;

 private:
  void read_chapters();
  void read_exercises();
  void read_misconceptions();
  [[noreturn]] void throw_unknown(std::string_view name, const std::string& kind,
                                  std::vector<std::string> names) const;

  std::filesystem::path root_;
  std::filesystem::path work_;
  std::shared_ptr<const Book> base_;
  std::vector<Chapter> chapters_;
  std::vector<Exercise> exercises_;
  std::map<std::string, Misconception> misconceptions_;
  std::vector<BookProblem> problems_;
};

/// Reads one exercise folder. @throws BookError naming file and line.
Exercise read_exercise(const std::filesystem::path& root, const std::string& chapter,
                       const std::string& name);

/// The [[tests]] of a file, private or the book's; a private test is hidden unless it says
/// otherwise.
/// @throws BookError naming file and line.
std::vector<TestSpec> read_test_list(const std::filesystem::path& file, bool is_private);

/// The project root: CONTACT_ROOT if set, else the nearest folder upwards that holds chapters/ and
/// exercises/.
/// @throws BookError if there is none.
std::filesystem::path find_root();

/// Where the student's copies live: CONTACT_WORK if set, else work/ in the root.
std::filesystem::path find_work(const std::filesystem::path& root);

/// The whole file as text. @throws BookError if it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// The solution as it is shown: without its marks, the comments that begin with `//?`
/// (grading/book/marks.py). @throws BookError if it cannot be read.
std::string solution_text(const Exercise& exercise);

/// Writes beside the target and renames, so that a reader never sees half a file. @throws
/// BookError.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace contact::grading
