#pragma once

// What a unit's result depends on, found out before anything is graded.

#include <filesystem>
#include <string>

#include "run_state.hpp"

namespace contact::grading {

/// The parts of a unit's key that are the same for every submission.
class RunKeys {
 public:
  /// @param program this program, beside which the launcher of boxes lies
  RunKeys(Loop& loop, const BuildDescription& build, const std::filesystem::path& program);

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
