#pragma once

// The record of what a reader has done so far, as a document. The program keeps it in
// work/progress.json (progress.hpp), the page in the browser; see cli/README.md for the format.

#include <array>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "../verdict/verdict.hpp"

namespace contact::grading {

/// In which ways an exercise is answered: lines put in order, gaps filled, or written from the
/// stub.
inline constexpr std::array forms{"order", "fill", "write"};
bool is_form(const std::string& name);

struct ExerciseProgress {
  int attempts = 0;
  double best_points = 0.0;
  double max_points = 0.0;
  /// When every test first passed, as an ISO 8601 time in UTC; empty before.
  std::string passed;
  std::string last_checked;
  int hints_shown = 0;
  bool solution_shown = false;
  /// What the present copy began from: a key of `forms`.
  std::string form = "write";
  /// For each form in which every test has passed, when that first happened.
  std::map<std::string, std::string> passed_as;
  std::map<std::string, std::string> tests;
};

class ProgressRecord {
 public:
  /// Nothing done yet.
  ProgressRecord();
  /// @throws std::runtime_error that says why, if the document is not a record of progress.
  explicit ProgressRecord(nlohmann::json document);

  [[nodiscard]] const nlohmann::json& document() const { return data_; }

  /// What is known of an exercise; all zero if it was never checked.
  [[nodiscard]] ExerciseProgress of(const std::string& exercise) const;

  /// Counts an attempt if something was attempted, keeps the best points and the first time that
  /// all passed. `now` is an ISO 8601 time in UTC.
  void record(const Verdict& verdict, const std::string& now);
  /// Remembers that one more hint was shown and says how many that makes.
  int record_hint(const std::string& exercise);
  void record_solution_shown(const std::string& exercise);
  /// Remembers in which form the present copy began: what passes from now on passes as that.
  void record_form(const std::string& exercise, const std::string& form);

 private:
  nlohmann::json& entry_of(const std::string& exercise);

  nlohmann::json data_;
};

/// Whether a verdict counts: what does not compile, and what still says todo() everywhere, is no
/// attempt.
bool is_attempt(const Verdict& verdict);

}  // namespace contact::grading
