#include "patience.hpp"

#include <algorithm>

namespace contact::grading {

namespace {

/// On the clock, for a test that does nothing.
constexpr double idle_seconds = 10.0;
/// What a test has, after one that ran out of time, of what it had before.
constexpr double short_share = 0.25;
constexpr double short_idle_seconds = 1.0;
/// On the clock, for all of these tests that run out of time too.
constexpr double rest_seconds = 2.0;

}  // namespace

TestTime Patience::of(const std::string& test) const {
  double processor = 0.0;
  for (const TestSpec& spec : exercise_.tests) {
    if (!test.empty() && spec.name != test) continue;
    processor = std::max(processor, exercise_.check_seconds(spec));
  }
  if (processor == 0.0) processor = exercise_.time_limit;  // a test that the file does not list
  if (late_ == 0) return {processor, std::max(idle_seconds, processor)};
  const double less = short_share * processor;
  return {less, std::max(short_idle_seconds, 4.0 * less)};
}

void Patience::ran_out(double elapsed) {
  if (late_++ > 0) spent_ += elapsed;
}

std::string Patience::less_time() const {
  return late_ == 0 ? "" : " (it had less time because a test before it did not end)";
}

std::string Patience::enough() const {
  if (spent_ < rest_seconds) return {};
  return "not run, because " + std::to_string(late_) +
         " tests before it did not end; mend these first";
}

}  // namespace contact::grading
