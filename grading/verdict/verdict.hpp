#pragma once

// What a check says about one exercise. Every host (the command line, `dev check`, the page, the
// grader) hands what happened to judge(), so that a verdict, its points and its hint come from one
// place.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "../book/book.hpp"

namespace contact::grading {

enum class TestStatus {
  passed,
  failed,
  not_attempted,  ///< the function still says todo()
  stopped,        ///< crashed, ran out of time, memory or output
  skipped         ///< a test that it requires did not pass
};

/// Why a test did not pass. Any part may be empty; the parts are shown in this order.
struct Failure {
  std::string asked;
  std::vector<std::pair<std::string, std::string>> inputs;
  std::string got;
  std::string right;
  /// How far from `right` an answer may be; empty if not at all.
  std::string allowed;
  /// Every known mistake that gives this answer.
  std::vector<std::string> misconceptions;
  /// What to do about it, if exactly one mistake gives this answer.
  std::string hint;
  /// If several do: a question about each. None of them is known to be the student's.
  std::vector<std::string> questions;
  /// What stopped the test, or what else there is to say.
  std::string reason;
};

/// What is said beyond the first wrong answer to a reader who has failed the same test before, each
/// time with other code.
struct CloserLook {
  using Inputs = std::vector<std::pair<std::string, std::string>>;

  /// How many of the test's questions the code answers right, and how many wrong.
  int right = 0;
  int wrong = 0;
  /// The inputs of the first few of each, with numbers to four digits.
  std::vector<Inputs> right_inputs;
  std::vector<Inputs> wrong_inputs;
  /// The same with inputs that fit the head.
  std::optional<Failure> smaller;
  /// One of the exercise's hints, counted from 1; 0 if there is none.
  int hint_number = 0;
  std::string hint;
};

/// What a host saw happen to one test.
struct TestResult {
  std::string name;
  TestStatus status = TestStatus::not_attempted;
  Failure failure;
  double seconds = 0.0;
  /// 0 if it is not known.
  double processor_seconds = 0.0;
  std::optional<CloserLook> look;
  /// What a test that passed has to show, in the same form; `asked` is empty if nothing.
  Failure finding = {};
};

struct TestVerdict {
  std::string name;
  TestStatus status = TestStatus::not_attempted;
  double points = 0.0;
  double max_points = 0.0;
  Failure failure;
  double seconds = 0.0;
  double processor_seconds = 0.0;
  Visibility visibility = Visibility::shown;
  std::optional<CloserLook> look;
  /// The earlier test that fails for the same cause; empty if there is none.
  std::string same_as;
  Failure finding = {};
};

/// For whom a verdict is.
enum class Reader {
  student,    ///< what a test withholds is left out
  instructor  ///< everything is there, to be withheld from what a student gets
};

enum class Outcome { passed, failed, not_attempted, does_not_compile };

/// A position in the contract to which a compiler's message refers.
struct ContractLine {
  std::string file;
  int line = 0;
  std::string text;
};

/// One message of the compiler about the student's file. Lines and columns count from 1, columns in
/// characters; an unknown position is 0.
struct Remark {
  std::string file;
  int line = 0;
  int column = 0;
  int end_line = 0;
  int end_column = 0;
  std::string severity;  ///< "error" or "warning"
  /// The compiler's own words.
  std::string message;
  /// The same for a beginner.
  std::string words;
  /// The id of the mistake (diagnosis/mistakes/) if it is one of the known.
  std::string mistake;
};

/// The first compile or link error, in few words; `full` is all that the compiler said.
struct CompileError {
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;
  /// The compiler's source line and caret.
  std::string excerpt;
  /// A sentence of ours about it; empty if there is nothing to add.
  std::string explanation;
  std::vector<ContractLine> contract;
  std::string full;
};

struct Seconds {
  double compile = 0.0;
  double link = 0.0;
  double run = 0.0;
};

struct Verdict {
  std::string exercise;
  std::string file;
  Outcome outcome = Outcome::not_attempted;
  double points = 0.0;
  double max_points = 0.0;
  std::vector<TestVerdict> tests;
  std::optional<CompileError> compile_error;
  /// Names the student's text, without its blanks and comments; empty if nobody asked.
  std::string code;
  /// What the compiler warns of in the student's file.
  std::vector<std::string> warnings;
  /// Its errors and warnings there, each with its place and in words for a beginner.
  std::vector<Remark> remarks;
  /// What the student's program printed, cut at a limit.
  std::string output;
  /// Names in exercise.toml without a compiled test, and the reverse.
  std::vector<std::string> missing_tests;
  std::vector<std::string> unlisted_tests;
  /// Whether the compiled tests run in the order of exercise.toml.
  bool in_order = true;
  Seconds seconds;
};

/// Points, skips and hints from the result of each test. Tests come in the order of
/// exercise.toml; one that did not run counts as stopped, and is named in `missing_tests`.
Verdict judge(const Exercise& exercise, const Book& book, const std::vector<TestResult>& results,
              Reader reader = Reader::student);

/// The verdict on a file that does not compile: no attempt, no points.
Verdict judge_uncompiled(const Exercise& exercise, CompileError error);

/// The first test that failed or was stopped; null if none did.
const TestVerdict* first_failure(const Verdict& verdict);

/// The names of the tests that fail for the same cause as this one, which comes before them.
std::vector<std::string> same_mistake(const Verdict& verdict, const TestVerdict& test);

/// What Verdict::code is for this text.
std::string code_of(std::string_view text);

std::string_view words(TestStatus status);
std::string_view words(Outcome outcome);
/// As in JSON: "not_attempted" for "not attempted".
std::string_view key(TestStatus status);
std::string_view key(Outcome outcome);
std::optional<TestStatus> status_from_key(std::string_view key);

/// "3" for 3.0, "2.5" for 2.5.
std::string points_text(double points);

/// A closer look as a runner tells it. What is missing or of the wrong kind reads as empty.
CloserLook look_from_json(const nlohmann::json& json);
nlohmann::json to_json(const CloserLook& look);

/// A test's result as a runner's event tells it: {name, status, seconds, failure?, finding?,
/// look?}. What is missing or of the wrong kind reads as empty, an unknown status as stopped.
TestResult result_from_json(const nlohmann::json& json);
nlohmann::json to_json(const Failure& failure);
nlohmann::json to_json(const Remark& remark);
nlohmann::json to_json(const Verdict& verdict);
/// What a record of progress needs of a verdict: exercise, code, outcome, points, and the tests'
/// names, status, points and hints. @throws nlohmann::json::exception if it is no verdict.
Verdict verdict_from_json(const nlohmann::json& json);

}  // namespace contact::grading
