// The right displacement is the integral of the largest speed, written term by term. Named tests
// use exact numbers; random ones keep the displacement away from the thickness. Every test asks for
// at least two different answers, so that no constant passes it.
#include "nothing_passes.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Mover;
using exercise::Proof;

/// The terms of a bound.
struct Terms {
  double second = 1;     ///< share of B's path
  double direction = 1;  ///< −1: B's speed is subtracted
  double half = 0.5;     ///< of a h²
  double angular_velocity = 1;
  bool strict = false;
  double allowed = 1;  ///< multiples of the thickness
};

double bounded(const Mover& a, const Mover& b, double h, const Terms& terms) {
  const double speeds = std::abs(a.speed + terms.direction * terms.second * b.speed);
  const double gained = terms.half * (a.acceleration + terms.second * b.acceleration);
  const double turned =
      terms.angular_velocity * (a.angular_velocity * a.bounding_radius +
                                terms.second * b.angular_velocity * b.bounding_radius);
  return speeds * h + gained * h * h + turned * h;
}

void check(const Mover& a, const Mover& b, double step, double thickness) {
  const auto like = [&](const Terms& terms) {
    return [&a, &b, step, thickness, terms] {
      const double far = bounded(a, b, step, terms);
      const double most = terms.allowed * thickness;
      return Proof{far, terms.strict ? far < most : far <= most};
    };
  };
  const Proof right = like({})();
  ask("Is it proven that nothing passes through?")
      .given("a", a)
      .given("b", b)
      .given("step", step)
      .given("thickness", thickness)
      .suspect("second-mover-left-out", like({0, 1, 0.5, 1, false, 1}))
      .suspect("speeds-subtracted", like({1, -1, 0.5, 1, false, 1}))
      .suspect("acceleration-left-out", like({1, 1, 0, 1, false, 1}))
      .suspect("whole-a-t-squared", like({1, 1, 1, 1, false, 1}))
      .suspect("spin-left-out", like({1, 1, 0.5, 0, false, 1}))
      .suspect("touching-rejected", like({1, 1, 0.5, 1, true, 1}))
      .suspect("thickness-twice", like({1, 1, 0.5, 1, false, 2}))
      .answer([&] { return exercise::prove(a, b, step, thickness); })
      // Some ten roundings of terms that are not negative.
      .close_to(right, within(32 * 0x1p-53 * right.displacement));
}

const Mover wall{0, 0, 4, 0};

}  // namespace

TEST_CASE("a bullet and a wall") {
  const Mover bullet{512, 0, 0.0625, 0};
  check(bullet, wall, 0.0078125, 0.5);      // 4 m a step: not proven
  check(bullet, wall, 0.00048828125, 0.5);  // a sixteenth of that: proven
  check({64, 0, 0.0625, 0}, wall, 0.0078125, 1);
}

TEST_CASE("both move") {
  check({8, 0, 1, 0}, {8, 0, 1, 0}, 0.0625, 0.75);
  check({8, 0, 1, 0}, {2, 0, 1, 0}, 0.0625, 0.75);
  check({3, 0, 1, 0}, {16, 0, 1, 0}, 0.125, 2);
}

TEST_CASE("acceleration within the step") {
  check({1, 8, 1, 0}, wall, 0.5, 1);  // 0.5 m by its speed, 1 m by acceleration
  check({1, 8, 1, 0}, wall, 0.25, 1);
  check({0, 4, 1, 0}, {0, 12, 1, 0}, 0.5, 1.5);
  check({2, 0, 1, 0}, {0, 16, 1, 0}, 0.25, 1.25);
}

TEST_CASE("rotation") {
  const Mover bat{1, 0, 0.75, 16};  // its end is twelve times as fast as its centre
  check(bat, wall, 0.0625, 0.5);
  check(bat, wall, 0.03125, 0.5);
  check({1, 0, 0.5, 8}, {2, 0, 0.25, 4}, 0.125, 1.25);
}

TEST_CASE("a displacement equal to the thickness") {
  check({4, 0, 0.5, 0}, wall, 0.125, 0.5);
  check({4, 0, 0.5, 0}, wall, 0.125, 0.4375);
  check({1, 8, 0.5, 2}, {1, 0, 0.5, 0}, 0.5, 2.5);
}

TEST_CASE("random pairs agree") {
  generators::Random random(seed(0));
  const auto mover = [&random] {
    const double speed = random.uniform(0.5, 20);
    const double acceleration = random.uniform(5, 100);
    const double bounding_radius = random.uniform(0.1, 2);
    const double angular_velocity = random.uniform(0.5, 15);
    return Mover{speed, acceleration, bounding_radius, angular_velocity};
  };
  for (int asked = 0; asked < 300; ++asked) {
    const Mover a = mover();
    const Mover b = mover();
    const double step = random.uniform(0.01, 0.2);
    const double share = random.uniform(0.5, 2);
    if (std::abs(share - 1) < 1e-6) continue;
    check(a, b, step, bounded(a, b, step, {}) * share);
  }
}
