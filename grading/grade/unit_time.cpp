#include "unit_time.hpp"

#include <algorithm>

#include "explain_box.hpp"

namespace contact::grading {

namespace {

/// Of the judge itself in one test, on a machine that has other work.
constexpr double judge_seconds = 40.0;
/// Compiling, linking, and linking again if a name also exists in the library.
constexpr double compile_boxes = 3.0;
/// Putting what the compiler and the linker said into words.
constexpr double explaining = compile_boxes * explain_wall_seconds;
/// Folders, files, and boxes that take a while to be gone.
constexpr double margin = 60.0;

}  // namespace

double compile_wall_seconds(const GradeLimits& limits) {
  return limits.wall_factor * limits.compile_cpu_seconds + limits.wall_extra;
}

double test_wall_seconds(const UnitSettings& settings) {
  return settings.limits.wall_factor * settings.test_cpu_seconds + settings.limits.wall_extra;
}

double judge_wall_seconds(const UnitSettings& settings) {
  return test_wall_seconds(settings) + judge_seconds;
}

JudgingTime::JudgingTime(const Exercise& exercise, const UnitSettings& settings)
    : tests_(static_cast<double>(exercise.tests.size())), test_(judge_wall_seconds(settings)) {}

double JudgingTime::next() const {
  const double all = tests_ * test_;
  return std::max(test_, std::min(all, 2.0 * all - spent_));
}

// As long as there is something left of twice the time of all tests, a process stays within it or
// takes the time of one test; so do those that come after, and each of them settles a test.
double JudgingTime::most() const { return 3.0 * tests_ * test_; }

double declared_seconds(const Exercise& exercise, const UnitSettings& settings) {
  if (settings.limits.unit_seconds > 0.0) return settings.limits.unit_seconds;
  const double programs = 1.0 + static_cast<double>(settings.more_tests.size());
  return compile_boxes * compile_wall_seconds(settings.limits) + explaining +
         programs * JudgingTime(exercise, settings).most() + margin;
}

std::string out_of_time_words(double seconds) {
  return "grading it took longer than the " + points_text(seconds) +
         " seconds on the clock that a unit of this exercise may take, so it was ended";
}

}  // namespace contact::grading
