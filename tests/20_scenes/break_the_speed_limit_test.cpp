// The right answer is the bound of nothing_passes. It counts as above the thickness only beyond
// rounding.
#include "break_the_speed_limit.hpp"
#include "slow_enough.hpp"

#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Step;

double displacement(const Step& s) {
  return (s.speed + s.acceleration * s.duration / 2 + s.angular_velocity * s.bounding_radius +
          s.wall_speed) *
         s.duration;
}

bool is_safe(const Step& s) { return displacement(s) <= s.thickness * (1 + 1e-12); }

bool called_safe(const Step& s) { return given::slow_enough(s.speed, s.duration, s.thickness); }

std::string told(bool safe) { return safe ? "safe" : "not safe"; }

Judged judged(const Step& s) {
  return {called_safe(s) && !is_safe(s), told(called_safe(s)), told(is_safe(s)),
          "Two points may approach each other by " +
              contact::text_of(displacement(s), {.digits = 3}) + " m; the wall is " +
              contact::text_of(s.thickness) + " m thick."};
}

bool none_negative(const Step& s) {
  const auto number = [](double x, double) { return x >= 0 && x <= 1000; };
  return contact::agree(s, s, number);
}

BreakIt<Step> question(std::string_view text) {
  return break_it<Step>(text)
      .rule("every number is from 0 to 1000", none_negative)
      .rule("the duration is greater than 0 s and at most 0.0167 s",
            [](const Step& s) { return s.duration > 0 && s.duration <= 0.0167; })
      .rule("the thickness is at least 0.05 m", [](const Step& s) { return s.thickness >= 0.05; })
      .suspect_if("break-step-is-safe", is_safe)
      .suspect_if("break-step-is-refused", [](const Step& s) { return !called_safe(s); });
}

}  // namespace

TEST_CASE("a body that starts at rest may pass") {
  question("Which body at rest may pass, although the code calls the step safe?")
      .rule("body and wall start at rest and nothing rotates",
            [](const Step& s) {
              return s.speed == 0 && s.wall_speed == 0 && s.angular_velocity == 0;
            })
      .input("step", [] { return exercise::starts_at_rest(); })
      .judge(judged);
}

TEST_CASE("a body at constant speed may pass") {
  question("Which body at constant speed may pass, although the code calls the step safe?")
      .rule("nothing accelerates or rotates",
            [](const Step& s) { return s.acceleration == 0 && s.angular_velocity == 0; })
      .input("step", [] { return exercise::nothing_accelerates(); })
      .judge(judged);
}

TEST_CASE("a body whose centre is at rest may pass") {
  question("Which body may pass although its centre is at rest?")
      .rule("the centre and the wall stay at rest",
            [](const Step& s) { return s.speed == 0 && s.wall_speed == 0 && s.acceleration == 0; })
      .input("step", [] { return exercise::centre_at_rest(); })
      .judge(judged);
}
