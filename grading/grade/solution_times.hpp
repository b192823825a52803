#pragma once

// What a test may take, from what the book's own solutions take here. That is measured once for a
// folder of results, so that a regrade compares like with like.

#include <functional>
#include <string>
#include <vector>

#include "run_state.hpp"

namespace contact::grading {

/// All that it depends on, but the run's seed and limits.
struct SolutionTimes {
  const Book& book;
  const BuildDescription& build;
  const Machine& machine;
  const RunFolder& folder;
  /// With their private tests.
  const std::vector<Exercise>& exercises;
  /// The previous run in the same folder; nullptr to measure all again.
  const Run* before;
  /// Solutions at a time.
  int workers;
  /// Called once if anything is to be measured.
  std::function<void()> measuring;
  /// Told that a solution hangs, as a Watchdog tells it: it must end the process.
  std::function<void(const std::string&)> out_of_time;
};

/// Grades the solutions whose times or marks are not known yet, and fills in the run's
/// min_seconds, test_seconds, unit_seconds and keys.
/// @throws BookError if a solution does not get full marks; of several, the first in the book's
/// order
void set_times(Loop& loop, const SolutionTimes& with, Run& run);

}  // namespace contact::grading
