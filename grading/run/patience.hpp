#pragma once

// How long a check waits for tests that do not end. Only a check of one's own: in grading each test
// has its whole time.

#include <string>

#include "../book/book.hpp"

namespace contact::grading {

/// What one test may take, in seconds.
struct TestTime {
  /// Of processor time, so that a busy machine fails no test.
  double processor = 0.0;
  /// On the clock, for a test that sleeps or waits.
  double elapsed = 0.0;
};

/// The time of each test of one check. The first test that runs out of time has had all of its own;
/// each of those after it has a quarter, and all of them together have two seconds. Then the rest
/// is not run, so that a function that never returns is told of within seconds.
class Patience {
 public:
  explicit Patience(const Exercise& exercise) : exercise_(exercise) {}

  /// What this test may take now. Before the first test, its name is empty.
  [[nodiscard]] TestTime of(const std::string& test) const;
  /// A test ran out of time after this many seconds on the clock.
  void ran_out(double elapsed);
  /// What to add to the reason of a test that runs out of time now; empty while each has its own.
  [[nodiscard]] std::string less_time() const;
  /// Why the rest is not run; empty while it is.
  [[nodiscard]] std::string enough() const;

 private:
  const Exercise& exercise_;
  int late_ = 0;
  double spent_ = 0.0;
};

}  // namespace contact::grading
