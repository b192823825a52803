// Expected answers come from formulae with the step squared. Named tests use exactly representable
// numbers. Every test asks for at least two different answers, so that no constant passes.
#include "two_eulers.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Body;
using Vector = Eigen::Vector3d;

/// x + h v + c h² a: c is 0 for explicit Euler, 1 for symplectic Euler, 1/2 for the parabola.
Body moved(const Body& body, const Vector& a, double h, double share) {
  return {body.position + h * body.velocity + share * h * h * a, body.velocity + h * a};
}

void check(const Body& body, const Vector& acceleration, double step) {
  const auto size = [&](const Vector& v) { return v.cwiseAbs().maxCoeff(); };
  // A few roundings of each number.
  const double room =
      16 * 0x1p-53 *
      (size(body.position) + (1 + step) * (size(body.velocity) + step * size(acceleration)));
  for (const bool first : {true, false}) {
    ask(first ? "Where is it one step later, by explicit Euler (position first)?"
              : "Where is it one step later, by symplectic Euler (velocity first)?")
        .given("body", body)
        .given("acceleration", acceleration)
        .given("step", step)
        .suspect(first ? "euler-orders-exchanged" : "old-velocity-in-both",
                 [&] { return moved(body, acceleration, step, first ? 1 : 0); })
        .suspect("half-a-t-squared", [&] { return moved(body, acceleration, step, 0.5); })
        .suspect("step-left-out", [&] { return moved(body, acceleration, 1, first ? 0 : 1); })
        .answer([&] {
          return first ? exercise::explicit_euler(body, acceleration, step)
                       : exercise::semi_implicit_euler(body, acceleration, step);
        })
        .close_to(moved(body, acceleration, step, first ? 0 : 1), within(room));
  }
}

}  // namespace

TEST_CASE("from rest, explicit Euler stays and symplectic Euler moves") {
  check({Vector(0, 0, 1), Vector(0, 0, 0)}, Vector(0, 0, -8), 0.5);
  check({Vector(3, 0, 0), Vector(0, 0, 0)}, Vector(1, 2, 4), 0.25);
}

TEST_CASE("the lecture's frame of two seconds") {
  check({Vector(0, 10, 0), Vector(1, 0, 0)}, Vector(0, -0.5, 0), 2);
  check({Vector(2, 9, 0), Vector(1, -1, 0)}, Vector(0, -0.5, 0), 2);
}

TEST_CASE("without a force both methods move straight") {
  check({Vector(1, 2, 3), Vector(4, -2, 1)}, Vector(0, 0, 0), 0.5);
  check({Vector(0, 0, 0), Vector(-1, 0, 6)}, Vector(0, 0, 0), 0.125);
}

TEST_CASE("random steps agree") {
  generators::Random random(seed(0));
  const auto vector = [&random] {
    return Vector{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
  };
  for (int asked = 0; asked < 300; ++asked) {
    const Vector position = vector();
    const Vector velocity = vector();
    const Vector acceleration = vector();
    check({position, velocity}, acceleration, random.uniform(0.01, 0.8));
  }
}
