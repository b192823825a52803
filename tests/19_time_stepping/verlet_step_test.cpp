// Expected answers come from the step multiplied out: x' = x (1 − z²/2) + h v and
// v' = v (1 − z²/2) − ω z x (1 − z²/4) with z = ω h. Every test asks for at least two different
// answers, so that no constant passes.
#include "verlet_step.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Swinging;

Swinging right_step(const Swinging& body, double w, double h) {
  const double z = w * h;
  return {body.position * (1 - z * z / 2) + h * body.velocity,
          body.velocity * (1 - z * z / 2) - w * z * body.position * (1 - z * z / 4)};
}

/// The step with the fraction `first` of the velocity update before the position update and `last`
/// after it, with the acceleration of the end or of the start.
Swinging pushed(const Swinging& body, double pull, double h, double first, double last,
                bool at_end) {
  const double middle = body.velocity - first * pull * body.position * h;
  const double position = body.position + middle * h;
  return {position, middle - last * pull * (at_end ? position : body.position) * h};
}

void check(const Swinging& body, double w, double h) {
  const double size = std::abs(body.position) * (1 + w) * (1 + w) + std::abs(body.velocity);
  ask("Where is it one step later, and how fast?")
      .given("body", body)
      .given("angular_frequency", w)
      .given("step", h)
      .suspect("push-from-the-start-twice", [&] { return pushed(body, w * w, h, 0.5, 0.5, false); })
      .suspect_if("force-from-the-equilibrium",
                  [&](const Swinging& got) {
                    return body.velocity == 0 && body.position * got.position > 0 &&
                           std::abs(got.position) > std::abs(body.position);
                  })
      .suspect("whole-push-twice", [&] { return pushed(body, w * w, h, 1, 1, true); })
      .suspect("euler-for-verlet", [&] { return pushed(body, w * w, h, 1, 0, true); })
      .suspect("omega-not-squared", [&] { return pushed(body, w, h, 0.5, 0.5, true); })
      .answer([&] { return exercise::verlet_step(body, w, h); })
      // z is at most 2: about ten roundings of numbers of at most a few times the size.
      .close_to(right_step(body, w, h), within(64 * 0x1p-53 * size));
}

}  // namespace

TEST_CASE("one step from the turning point") {
  check({1, 0}, 2, 0.25);
  check({-2, 0}, 3, 0.25);
}

TEST_CASE("one step through the equilibrium") {
  check({0, 1}, 2, 0.5);
  check({0, -3}, 4, 0.125);
}

TEST_CASE("a step back returns to the start") {
  // The result of one step is the input of the next, with its velocity reversed: a step back. The
  // expected answer is the start.
  generators::Random random(seed(1));
  for (int asked = 0; asked < 50; ++asked) {
    const double x = random.uniform(-2, 2);
    const double v = random.uniform(-2, 2);
    const double w = random.uniform(1.5, 3);
    const double h = random.uniform(0.1, 0.3);
    const Swinging there = right_step({x, v}, w, h);
    check({there.position, -there.velocity}, w, h);
  }
}

TEST_CASE("many steps keep the amplitude") {
  Swinging body{1, 0};
  for (int i = 0; i < 60; ++i) {
    check(body, 2, 0.25);
    body = right_step(body, 2, 0.25);
  }
}

TEST_CASE("random steps agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double x = random.uniform(-3, 3);
    const double v = random.uniform(-3, 3);
    const double w = random.uniform(0.2, 4);
    check({x, v}, w, random.uniform(0.01, 0.5));
  }
}
