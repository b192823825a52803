#pragma once

// work/progress.json: the record of what a reader has done, kept in a file.

#include <filesystem>
#include <string>
#include <vector>

#include "progress_record.hpp"

namespace contact::grading {

class Progress {
 public:
  explicit Progress(const std::filesystem::path& work);

  /// The record as it was read last.
  [[nodiscard]] const ProgressRecord& known() const { return record_; }
  /// What is known of an exercise; all zero if it was never checked.
  [[nodiscard]] ExerciseProgress of(const std::string& exercise) const {
    return record_.of(exercise);
  }

  /// Counts an attempt if something was attempted, keeps the best points and the first time that
  /// all passed.
  void record(const Verdict& verdict);
  /// Remembers that one more hint was shown and says how many that makes.
  int record_hint(const std::string& exercise);
  void record_solution_shown(const std::string& exercise);
  /// Keeps the last answer to a question.
  void record_answer(const std::string& question, const QuestionProgress& given);
  /// Keeps which criteria the reader has marked in the last answer.
  void record_marks(const std::string& question, const std::vector<bool>& marks);
  /// Takes in another record of the same reader. Returns the exercises of which more is known now.
  std::vector<std::string> merge(const ProgressRecord& theirs);

  /// A sentence about a broken file that was put aside; empty if all was well.
  [[nodiscard]] const std::string& notice() const { return notice_; }

 private:
  void load();
  template <typename Change>
  void change(Change apply);

  std::filesystem::path file_;
  ProgressRecord record_;
  std::string notice_;
};

/// The present time in UTC, such as 2026-11-21T05:09:19Z.
std::string now_utc(const char* format = "%Y-%m-%dT%H:%M:%SZ");

}  // namespace contact::grading
