#pragma once

// Tests run in one process after another: a test in which the process dies costs itself only, and
// the rest run in the next. A check and grading both come here.

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../verdict/verdict.hpp"

namespace contact::grading {

/// Follows the events of one process (tests/support/runner.cpp) and knows which test is running.
class EventReader {
 public:
  using Clock = std::chrono::steady_clock;

  void feed(std::string_view text);

  [[nodiscard]] bool running() const { return !current_.empty(); }
  [[nodiscard]] const std::string& current() const { return current_; }
  [[nodiscard]] bool done() const { return done_; }
  /// The tests that began, in order.
  [[nodiscard]] const std::vector<std::string>& started() const { return started_; }
  [[nodiscard]] Clock::time_point start_time() const { return start_time_; }
  [[nodiscard]] std::vector<TestResult>& results() { return results_; }
  /// The last closer look that was told.
  [[nodiscard]] const std::optional<CloserLook>& look() const { return look_; }

 private:
  void event(const std::string& line);

  std::string buffer_;
  std::string current_;
  bool done_ = false;
  std::vector<std::string> started_;
  Clock::time_point start_time_;
  std::vector<TestResult> results_;
  std::optional<CloserLook> look_;
};

/// One process that ran tests.
struct Turn {
  EventReader reader;
  /// It did not end as a test program does that has run to its end.
  bool died = false;
  /// `why` replaces what it said itself about the test in which it died (a test library's name of a
  /// signal, say).
  bool knows_better = false;
  /// Why it died, in words for the student.
  std::string why;
  /// The tests that are left are not run, for this reason; empty: they run in the next process.
  std::string enough;
};

/// Runs the tests with these names (all, if there are none) in a new process.
using RunTurn = std::function<Turn(const std::vector<std::string>& names)>;

/// Runs processes until each test of the exercise has a result; a test that is not run is skipped.
std::vector<TestResult> run_in_turns(const Exercise& exercise, const RunTurn& run);

/// A test's name as Catch2's command line and input file must spell it.
std::string escaped_test_name(const std::string& name);

}  // namespace contact::grading
