// Right answers are the formula without rounding, rounded once. Every test asks for at least two
// different answers, so that no constant passes one, and at least once for a bounce, so that the
// velocity returned unchanged does not.
#include "floor_bounce.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Vector = Eigen::Vector3d;

Vector right_answer(const Vector& v, const Vector& n, double k) {
  Exact along;
  for (int i = 0; i < 3; ++i) along += Exact(v(i)) * Exact(n(i));
  if (along.sign() >= 0) return v;
  const auto coordinate = [&](int i) {
    return rounded<double>(Exact(v(i)) - (Exact(1.0) + Exact(k)) * along * Exact(n(i)));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

void check(const Vector& v, const Vector& n, double k) {
  // Dot product, 1 + k, two products and a difference: 24 u |v|. A normal whose length is
  // off by 4 u adds 4 u for a solution that splits the velocity into two components.
  const double bound = 32 * 0x1p-53 * v.norm();
  const double along = v.dot(n);
  ask("What is the velocity after the bounce?")
      .given("velocity", v)
      .given("normal", n)
      .given("k", k)
      .suspect("bounce-when-separating", [&]() -> Vector { return v - (1 + k) * along * n; })
      .suspect_if("still-into-the-surface",
                  [&](const Vector& got) {
                    // With 1 - k times the normal component it is another mistake.
                    const double after = got.dot(n);
                    return along < 0 && after < -4 * bound &&
                           std::abs(after - (1 - k) * along) > 4 * bound;
                  })
      .suspect("bounce-reverses-all", [&]() -> Vector { return -k * v; })
      .suspect("one-of-one-plus-k", [&]() -> Vector { return v - k * along * n; })
      .suspect("restitution-on-the-slip", [&]() -> Vector { return k * (v - 2 * along * n); })
      .answer([&] { return exercise::after_bounce(v, n, k); })
      .close_to(right_answer(v, n, k), within(Vector(bound, bound, bound)));
}

}  // namespace

TEST_CASE("a ball that falls vertically leaves with k times its speed") {
  check({0, 0, -4}, {0, 0, 1}, 0.5);
  check({0, 0, -4}, {0, 0, 1}, 1);
  check({0, 8, 0}, {0, -1, 0}, 0.25);
  check({0, 0, -4}, {0, 0, 1}, 0);
}

TEST_CASE("the tangential component is unchanged") {
  check({3, 0, -4}, {0, 0, 1}, 0.5);
  check({3, -2, -4}, {0, 0, 1}, 1);
  check({-5, 1, 2}, {1, 0, 0}, 0.75);
  check({3, 0, -4}, {0.6, 0, 0.8}, 0.5);
}

TEST_CASE("a body that moves away is left alone") {
  // Whether the formula for an approach is right, other tests ask: here the answer must only
  // differ.
  const Vector approaching(1, 2, -3);
  ask("What is the velocity after the bounce?")
      .given("velocity", approaching)
      .given("normal", Vector(0, 0, 1))
      .given("k", 0.5)
      .answer([&] { return exercise::after_bounce(approaching, Vector(0, 0, 1), 0.5); })
      .satisfies("differs from the velocity before, because the ball approaches the surface",
                 [&](const Vector& after) { return after != approaching; });
  check({1, 2, 3}, {0, 0, 1}, 0.5);
  check({-2, 0, 0}, {0, 0, 1}, 0.5);
  check({0, 7, 1}, {0.6, 0, 0.8}, 0.875);
}

TEST_CASE("random bounces agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] {
    return Vector{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
  };
  const auto possible = [](const Vector& v, const Vector& n, double k) {
    // Motion along the surface up to rounding is left out.
    return std::abs(n.squaredNorm() - 1) < 8 * 0x1p-53 && k >= 0 && k <= 1 &&
           std::abs(v.dot(n)) > 1e-9;
  };
  int bounced = 0;
  for (int asked = 0; asked < 300 || bounced < 2; ++asked) {
    const Vector v = vector();
    const Vector n = vector().normalized();
    const double k = random.uniform();
    if (!possible(v, n, k)) continue;
    bounced += v.dot(n) < 0;
    shrinkable(check, possible, v, n, k);
  }
}
