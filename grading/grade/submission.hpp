#pragma once

// The files of one submission, out of a folder or an archive, and which exercise each answers to.

#include <map>
#include <string>
#include <vector>

#include "../archive/archive_entries.hpp"

namespace contact::grading {

/// A student's answer to one exercise, or why there is none although there is a file.
struct TakenFile {
  /// Where it lay in the submission.
  std::string path;
  std::string text;
  std::string problem;
};

/// Files as they are found, until all of a submission are.
class SubmissionFiles {
 public:
  explicit SubmissionFiles(const Book& book) : book_(book) {}

  /// Reads a folder without following a link. @throws ArchiveError that says why it is refused.
  void add_folder(const std::filesystem::path& folder);
  /// Reads an archive. @throws ArchiveError, as above.
  void add_archive(const std::filesystem::path& file);
  /// Reads one file, for the exercise that its name says, or for `only` if that is not null.
  /// @param name what its student called it
  /// @returns whether it answers to an exercise
  bool add_file(const std::filesystem::path& file, const std::string& name, const Exercise* only);

  /// By the exercise's id; where two files answer to one exercise, the problem names them.
  [[nodiscard]] std::map<std::string, TakenFile> taken() const;
  /// Paths that answer to no exercise of the book.
  [[nodiscard]] const std::vector<std::string>& ignored() const { return ignored_; }

 private:
  struct Found {
    std::string path;
    std::string text;
    std::string problem;
  };
  class Folder;

  [[nodiscard]] const Exercise* exercise_of(const std::string& path) const;
  void add(const Exercise& exercise, Found found);

  const Book& book_;
  std::map<std::string, std::vector<Found>> found_;
  std::vector<std::string> ignored_;
};

/// Files that operating systems and tools add to folders and archives: __MACOSX, .DS_Store, .git.
bool is_junk(std::string_view name);

/// The names of exercises that only one chapter has.
std::vector<std::string> unique_names(const Book& book);

}  // namespace contact::grading
