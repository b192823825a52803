// In the room that is reflected at its walls the path is straight, and the position comes back by
// folding it. Distances are at most 1e6 m, so rounding is below 1e-9 m; the given code must be
// wrong by 0.01 m.
#include "break_one_reflection.hpp"
#include "reflect_once.hpp"

#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Step;

double straight(const Step& step) { return step.position + step.velocity * step.duration; }

int impacts(const Step& step) {
  const double end = straight(step);
  return end >= 0 ? static_cast<int>(std::floor(end)) : static_cast<int>(std::floor(-end)) + 1;
}

double right_position(const Step& step) {
  const double folded = std::fmod(std::abs(straight(step)), 2.0);
  return folded > 1 ? 2 - folded : folded;
}

Judged judged(const Step& step) {
  const double given = given::reflect_once(step.position, step.velocity, step.duration);
  const double right = right_position(step), off = std::abs(given - right);
  return {off > 0.01, contact::text_of(given), contact::text_of(right),
          "The difference is " + contact::text_of(off, {.digits = 2}) + " m, after " +
              std::to_string(impacts(step)) + (impacts(step) == 1 ? " impact." : " impacts.")};
}

BreakIt<Step> question(std::string_view text) {
  return break_it<Step>(text)
      .rule("the position is from 0 m to 1 m",
            [](const Step& step) { return step.position >= 0 && step.position <= 1; })
      .rule("the speed is at most 1000 m/s",
            [](const Step& step) { return std::abs(step.velocity) <= 1000; })
      .rule("the duration is greater than 0 s and at most 1000 s",
            [](const Step& step) { return step.duration > 0 && step.duration <= 1000; })
      .suspect_if("break-one-impact-at-most", [](const Step& step) { return impacts(step) <= 1; })
      .suspect_if("break-right-wall-first",
                  [](const Step& step) { return straight(step) >= 2 && straight(step) < 3; });
}

}  // namespace

TEST_CASE("a short step ends at the wrong position") {
  question("After which short step is the point at the wrong position?")
      .rule("the step is at most 0.1 s", [](const Step& step) { return step.duration <= 0.1; })
      .input("step", [] { return exercise::short_step(); })
      .judge(judged);
}

TEST_CASE("a slow point ends at the wrong position") {
  question("Of which slow point is the position wrong?")
      .rule("the speed is at most 1 m/s",
            [](const Step& step) { return std::abs(step.velocity) <= 1; })
      .input("step", [] { return exercise::slow_point(); })
      .judge(judged);
}

TEST_CASE("a step with two impacts ends at the wrong position") {
  question("After which step with at most two impacts is the position wrong?")
      .rule("the step has at most two impacts", [](const Step& step) { return impacts(step) <= 2; })
      .input("step", [] { return exercise::two_impacts(); })
      .judge(judged);
}
