#pragma once

// The parts of `contact dev check`: checks of the book's files and of the verdicts on all answers.

#include <functional>
#include <string>
#include <vector>

#include "../../grading/build/build.hpp"
#include "../../grading/run/run.hpp"

namespace contact::cli {

/// One checked item and its faults (none if it is correct).
struct DevResult {
  std::string kind;  ///< "chapter", "lesson", "exercise", "misconception", "stub", "solution",
                     ///< "wrong answer", "null answer", "marks", "form to order",
                     ///< "form to fill"
  std::string name;
  std::vector<std::string> problems;
  std::string said = {};  ///< What is worth a line even if all is well; mostly nothing.
};

/// Instead of an ID in a wrong answer: no known mistake, so none may be recognised.
inline constexpr const char* no_misconception = "none";

/// First lines of a wrong answer: `// misconception: ID`, `// caught by: TEST`, the first test that
/// fails, and `// seen: WHERE`, where somebody made this mistake: a public address, a lecture's
/// slide, a first reader or an earlier commit of this book, or `not found`.
struct WrongAnswer {
  std::filesystem::path file;
  std::string misconception;
  std::string caught_by;
  std::string seen;
};

/// @throws grading::BookError if one of the three lines is not there, or the third names nothing.
WrongAnswer read_wrong_answer(const std::filesystem::path& file);
/// As they are kept: whole (.cpp), or as patches against the solution (.patch).
std::vector<std::filesystem::path> wrong_answer_files(const grading::Exercise& exercise);

/// Applies the patches among the wrong answers: of each, the whole file is below `folder`
/// afterwards, or it is said here why it is not.
std::vector<DevResult> apply_patches(grading::Loop& loop, const grading::Book& book,
                                     const std::vector<const grading::Exercise*>& exercises,
                                     const std::filesystem::path& folder);

/// Checks the marks of solutions, and writes the forms made of them below `folder`.
std::vector<DevResult> write_forms(grading::Loop& loop, const grading::Book& book,
                                   const std::vector<const grading::Exercise*>& exercises,
                                   const std::filesystem::path& folder);

/// Of each lesson: the minutes that it takes, and whether it and its listings are short enough.
std::vector<DevResult> check_lessons(grading::Loop& loop, const grading::Book& book);

/// Chapters, their graph and headers; exercises and their folders; misconceptions. Reads files
/// only.
std::vector<DevResult> check_book_files(const grading::Book& book);

/// One answer to one exercise, and what it must get.
struct AnswerJob {
  std::string kind;
  std::string name;
  const grading::Exercise* exercise = nullptr;
  std::filesystem::path file;
};

/// Every stub, solution, wrong answer, form and null answer; null answers are to be written into
/// `folder`, in which applied patches and forms are already.
std::vector<AnswerJob> answer_jobs(const std::vector<const grading::Exercise*>& exercises,
                                   const std::filesystem::path& folder);

/// Checks one answer like a student's and compares the verdict with the required one. A null answer
/// is generated, one for each kind of value.
std::vector<DevResult> check_answer(grading::Loop& loop, const grading::Book& book,
                                    const grading::BuildDescription& build, const AnswerJob& job,
                                    const grading::Limits& limits);

}  // namespace contact::cli
