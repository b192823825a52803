// The right answers are an interval: from the time of impact less the tolerance to the time of
// impact, which is known by a formula. Both ends allow for the rounding of the formula, 10⁻¹³ of
// the step; tolerances are far larger. Every test asks for at least two different answers, so that
// no constant passes.
#include "roll_back.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Ball;

double impact(const Ball& ball, double gravity) {
  const double speed = std::sqrt(ball.velocity * ball.velocity + 2 * gravity * ball.height);
  return ball.velocity > 0 ? (ball.velocity + speed) / gravity
                           : 2 * ball.height / (speed - ball.velocity);
}

/// Bisection with one of its steps changed.
struct Halving {
  bool ask_end = true;
  bool right_half = true;
  bool free_end = true;
  int most = 1000;
};

double halved(const Ball& ball, double gravity, double step, double tolerance, const Halving& how) {
  const double until = impact(ball, gravity);
  if (how.ask_end && step <= until) return step;
  double free = 0;
  double blocked = step;
  for (int i = 0; i < how.most && blocked - free >= tolerance; ++i) {
    const double middle = free + (blocked - free) / 2;
    ((middle <= until) == how.right_half ? free : blocked) = middle;
  }
  return how.free_end ? free : blocked;
}

void check(const Ball& ball, double gravity, double step, double tolerance) {
  const double until = impact(ball, gravity);
  const double room = 1e-13 * step;
  const auto like = [&](const Halving& how) {
    return [&ball, gravity, step, tolerance, how] {
      return halved(ball, gravity, step, tolerance, how);
    };
  };
  // A time within the tolerance of the impact, but after it.
  const auto behind = [&](const double& t) { return t > until && t <= until + tolerance + room; };
  ask("Until when is the ball free?")
      .given("ball", ball)
      .given("gravity", gravity)
      .given("step", step)
      .given("tolerance", tolerance)
      .suspect("end-of-step-not-asked", like({false, true, true, 1000}))
      .suspect_if("returns-the-blocked-end",
                  [&](const double& t) { return step > until && behind(t); })
      .suspect("keeps-the-wrong-half", like({true, false, true, 1000}))
      .suspect_if("blocked-at-the-end",
                  [&](const double& t) { return t == step && step > until + tolerance + room; })
      .suspect_if("start-of-the-step",
                  [&](const double& t) {
                    return t == 0 && std::min(until, step) > tolerance + room &&
                           like({true, false, true, 1000})() != 0;
                  })
      .suspect_if("fixed-number-of-halvings",
                  [&](const double& t) {
                    return step > until && t >= 0 && t < until - tolerance && t > until - step / 64;
                  })
      .answer([&] { return exercise::last_free(ball, gravity, step, tolerance); })
      .satisfies(step < until ? "is the end of the step: the ball is free there"
                              : "is at most the time of the impact, and less than the tolerance "
                                "before it",
                 [&](double t) {
                   if (step < until) return t == step;
                   return t >= 0 && t <= until + room && t > until - tolerance - room;
                 });
}

}  // namespace

TEST_CASE("a step that ends in the air is used whole") {
  check({1, 0}, 8, 0.25, 0.0625);
  check({1, 4}, 8, 0.5, 0.001);
  check({2, 0}, 4, 0.75, 0.001);
}

TEST_CASE("an impact in the middle of the step") {
  check({1, 0}, 8, 1.1, 0.01);  // falls for half a second
  check({0.5, -3}, 8, 0.27, 0.01);
  check({1, 2}, 8, 1, 0.01);
}

TEST_CASE("the answer is free, whatever the tolerance") {
  check({1, 0}, 8, 1.1, 0.3);
  check({1, 0}, 8, 1.3, 0.2);
  check({2, 1}, 8, 1.9, 0.1);
}

TEST_CASE("narrow tolerances are met") {
  check({1, 0}, 8, 1.1, 1e-6);
  check({2, 1}, 8, 1.9, 1e-8);
  check({0.3, -1}, 9.81, 0.4, 1e-9);
}

TEST_CASE("random falls agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double height = random.uniform(0.1, 4);
    const double velocity = random.uniform(-5, 5);
    const double gravity = random.uniform(2, 15);
    const Ball ball{height, velocity};
    const double until = impact(ball, gravity);
    const double share = random.uniform(0.5, 3);
    if (std::abs(share - 1) < 1e-3) continue;
    check(ball, gravity, until * share, until * share * random.uniform(1e-7, 1e-4));
  }
}
