#pragma once

// work/progress.json: what a reader has done so far. The page exports the same format; see
// cli/README.md.

#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "verdict.hpp"

namespace contact::grading {

struct ExerciseProgress {
  int attempts = 0;
  double best_points = 0.0;
  double max_points = 0.0;
  /// When every test first passed, as an ISO 8601 time in UTC; empty before.
  std::string passed;
  std::string last_checked;
  int hints_shown = 0;
  bool solution_shown = false;
  std::map<std::string, std::string> tests;
};

class Progress {
 public:
  explicit Progress(const std::filesystem::path& work);

  /// What is known of an exercise; all zero if it was never checked.
  [[nodiscard]] ExerciseProgress of(const std::string& exercise) const;

  /// Counts an attempt if something was attempted, keeps the best points and the first time that
  /// all passed.
  void record(const Verdict& verdict);
  /// Remembers that one more hint was shown and says how many that makes.
  int record_hint(const std::string& exercise);
  void record_solution_shown(const std::string& exercise);

  /// A sentence about a broken file that was put aside; empty if all was well.
  [[nodiscard]] const std::string& notice() const { return notice_; }

 private:
  void load();
  template <typename Change>
  void change(const std::string& exercise, Change apply);

  std::filesystem::path file_;
  nlohmann::json data_;
  std::string notice_;
};

/// The present time in UTC, such as 2026-11-21T05:09:19Z.
std::string now_utc();

}  // namespace contact::grading
