#include "calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "unit_time.hpp"

namespace contact::grading {

namespace {

constexpr double kTimesSolution = 10.0;

std::string what_went_wrong(const Verdict& verdict) {
  if (verdict.compile_error) return verdict.compile_error->message;
  const TestVerdict* test = first_failure(verdict);
  if (test == nullptr) return "some of its tests are not attempted";
  const Failure& failure = test->failure;
  std::string why = failure.reason.empty() ? failure.got : failure.reason;
  // The author of the test reads this, and a solution is seldom the cause of a faulty test.
  if (why.starts_with("the tests could not go on")) why += "; does the test itself crash or loop?";
  return "\"" + test->name + "\" is " + std::string(words(test->status)) +
         (why.empty() ? "" : ": " + why);
}

double min_seconds(const Exercise& exercise, const UnitSettings& settings) {
  return settings.limits.test_cpu_seconds > 0.0 ? settings.limits.test_cpu_seconds
                                                : exercise.time_limit;
}

}  // namespace

double calibrate(Loop& loop, const Book& book, const BuildDescription& build,
                 const Machine& machine, const Seat& seat, const Exercise& exercise,
                 UnitSettings settings) {
  const double least = min_seconds(exercise, settings);
  settings.test_cpu_seconds = kTimesSolution * least;
  const UnitResult solution = grade_unit(loop, book, build, machine, seat, exercise,
                                         read_text(exercise.solution), settings);
  if (solution.verdict.outcome != Outcome::passed)
    throw BookError("the solution of " + exercise.id() + " gets " +
                    points_text(solution.verdict.points) + " of " +
                    points_text(solution.verdict.max_points) +
                    " points here, so nothing is graded: " + what_went_wrong(solution.verdict));
  // To a tenth of a second, so that noise changes it seldom.
  return std::max(least, std::ceil(kTimesSolution * kTimesSolution * solution.slowest_test) / 10.0);
}

double calibrating_seconds(const Exercise& exercise, UnitSettings settings) {
  settings.test_cpu_seconds = kTimesSolution * min_seconds(exercise, settings);
  return declared_seconds(exercise, settings);
}

}  // namespace contact::grading
