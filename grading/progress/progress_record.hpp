#pragma once

// The record of what a reader has done so far, as a document. The program keeps it in
// work/progress.json (progress.hpp), the page in the browser; see cli/README.md for the format.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "../verdict/verdict.hpp"

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

/// The last answer to a question, as the page keeps it too (page/web/src/storage.ts).
struct QuestionProgress {
  std::string kind;
  /// A number with its unit as typed, an index, a list of indices, the texts of the gaps, or what
  /// the reader wrote.
  nlohmann::json answer;
  /// Never of a question to say why, which only the reader judges.
  bool right = false;
  /// Which of the criteria of a model answer the reader has marked; else empty.
  std::vector<bool> marks;
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

  /// What was last answered to a question; nothing if it never was.
  [[nodiscard]] std::optional<QuestionProgress> answer_to(const std::string& question) const;
  /// Keeps an answer and counts it. `now` is an ISO 8601 time in UTC.
  void record_answer(const std::string& question, const QuestionProgress& given,
                     const std::string& now);
  /// Keeps which criteria the reader has marked in the answer that was kept last.
  void record_marks(const std::string& question, const std::vector<bool>& marks,
                    const std::string& now);

 private:
  nlohmann::json& entry_of(const std::string& exercise);

  nlohmann::json data_;
};

/// Whether a verdict counts: what does not compile, and what still says todo() everywhere, is no
/// attempt.
bool is_attempt(const Verdict& verdict);

}  // namespace contact::grading
