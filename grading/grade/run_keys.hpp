#pragma once

// What a unit's result depends on, found out before anything is graded.

#include <filesystem>
#include <string>
#include <vector>

#include "run_state.hpp"

namespace contact::grading {

/// Brings up to date what these exercises are graded with. Costs no more than some file times if
/// nothing has changed. @throws BookError as ready_to_grade() does
BuildDescription current_build(Loop& loop, const Book& book,
                               const std::vector<const Exercise*>& exercises);

/// The file that this program was started from, also if another has taken its place since.
std::filesystem::path own_program();

/// The parts of a unit's key that are the same for every submission.
class RunKeys {
 public:
  RunKeys(Loop& loop, const BuildDescription& build);

  /// All but the code. @param test_seconds what a test may take
  [[nodiscard]] UnitKey of(const Exercise& exercise, const PrivateExercise* private_tests,
                           const std::string& seed, const GradeLimits& limits,
                           double test_seconds) const;

 private:
  const BuildDescription& build_;
  /// Of what all exercises share.
  std::string grader_;
};

}  // namespace contact::grading
