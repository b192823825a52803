// Right answers need no root: the change of the relative velocity is (1 + e)(d·w)/(d·d) d with
// d = c_A − c_B, shared inversely to the masses. They are computed without rounding and rounded
// once. Every test asks for at least two different answers, so that no constant passes one.
#include "two_discs.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Disc;
using exercise::Velocities;
using Vector = Eigen::Vector2d;

Exact difference(double a, double b) { return Exact(a) - Exact(b); }

/// −d·w: positive if they approach.
Exact approach_of(const Disc& a, const Disc& b) {
  return -(difference(a.centre.x(), b.centre.x()) * difference(a.velocity.x(), b.velocity.x()) +
           difference(a.centre.y(), b.centre.y()) * difference(a.velocity.y(), b.velocity.y()));
}

Velocities exact_velocities(const Disc& a, const Disc& b, double e) {
  Velocities after{a.velocity, b.velocity};
  const Exact approach = approach_of(a, b);
  if (approach.sign() <= 0) return after;
  const Exact ma(a.mass);
  const Exact mb(b.mass);
  const Exact dx = difference(a.centre.x(), b.centre.x());
  const Exact dy = difference(a.centre.y(), b.centre.y());
  const Exact below = (ma + mb) * (dx * dx + dy * dy);
  const Exact push = (Exact(1.0) + Exact(e)) * approach;
  for (int k = 0; k < 2; ++k) {
    const Exact& d = k == 0 ? dx : dy;
    after.a(k) = quotient<double>(Exact(a.velocity(k)) * below + push * d * mb, below);
    after.b(k) = quotient<double>(Exact(b.velocity(k)) * below - push * d * ma, below);
  }
  return after;
}

/// The right formula along an axis that may be wrong.
Velocities along(const Vector& n, const Disc& a, const Disc& b, double e, double ma, double mb) {
  const double w = n.dot(a.velocity - b.velocity);
  const double j = -(1 + e) * w * a.mass * b.mass / (a.mass + b.mass);
  return {a.velocity + j / ma * n, b.velocity - j / mb * n};
}

void check_approach(const Disc& a, const Disc& b) {
  ask("Do the discs approach?")
      .given("a", a)
      .given("b", b)
      .suspect("separating-discs-reflected", [&] { return a.velocity != b.velocity; })
      .answer([&] { return exercise::approach(a, b); })
      .equals(approach_of(a, b).sign() > 0);
}

void check(const Disc& a, const Disc& b, double e) {
  const Vector d = a.centre - b.centre;
  const Vector n = d.normalized();
  // The axis is off by 6 u, a projection by 12 u of the velocity, the result by 20 u more; a change
  // of velocity is at most twice as large.
  const double bound = 128 * 0x1p-53 * (a.velocity.norm() + b.velocity.norm());
  const Vector room(bound, bound);
  ask("What are the velocities of the two discs afterwards?")
      .given("a", a)
      .given("b", b)
      .given("restitution", e)
      .suspect("separating-discs-reflected", [&] { return along(n, a, b, e, a.mass, b.mass); })
      .suspect("axis-not-normalised", [&] { return along(d, a, b, e, a.mass, b.mass); })
      .suspect_if("separates-at-a-wrong-speed",
                  [&](const Velocities& got) {
                    const double closing = -n.dot(a.velocity - b.velocity);
                    const double separation = n.dot(got.a - got.b);
                    const Vector gained =
                        a.mass * (got.a - a.velocity) + b.mass * (got.b - b.velocity);
                    // With an axis that is no unit vector it is another mistake.
                    const Velocities oblong = along(d, a, b, e, a.mass, b.mass);
                    return closing > 0 && gained.norm() <= bound * (a.mass + b.mass) &&
                           std::abs(separation - e * closing) > 4 * bound &&
                           (got.a - oblong.a).norm() + (got.b - oblong.b).norm() > 4 * bound;
                  })
      .suspect("masses-exchanged", [&] { return along(n, a, b, e, b.mass, a.mass); })
      .suspect("whole-velocity-reflected",
               [&]() -> Velocities {
                 return {-e * a.velocity, -e * b.velocity};
               })
      .suspect("restitution-on-everything",
               [&]() -> Velocities {
                 const Velocities elastic = along(n, a, b, 1, a.mass, b.mass);
                 return {e * elastic.a, e * elastic.b};
               })
      .suspect("whole-velocities-exchanged",
               [&]() -> Velocities {
                 const Vector w = a.velocity - b.velocity;
                 const double share = (1 + e) / (a.mass + b.mass);
                 return {a.velocity - share * b.mass * w, b.velocity + share * a.mass * w};
               })
      .answer([&] { return exercise::after_touch(a, b, e); })
      .close_to(exact_velocities(a, b, e), within(Velocities{room, room}));
}

}  // namespace

TEST_CASE("discs approach or they do not") {
  check_approach({1, {-1, 0}, {2, 0}}, {1, {0, 0}, {0, 0}});
  check_approach({1, {-1, 0}, {-2, 0}}, {1, {0, 0}, {0, 0}});
  check_approach({1, {-1, 0}, {2, 5}}, {1, {0, 0}, {3, 0}});
  check_approach({1, {0, 1}, {4, 0}}, {1, {0, 0}, {0, 0}});
  check_approach({1, {2, 1}, {4, 0}}, {1, {2, 1}, {0, 0}});
}

TEST_CASE("head-on it is a collision on a line") {
  check({1, {-0.5, 0}, {3, 0}}, {1, {0.5, 0}, {0, 0}}, 1);
  check({1, {-0.5, 0}, {3, 0}}, {1, {0.5, 0}, {-1, 0}}, 1);
  check({1, {0, -0.5}, {0, 4}}, {1, {0, 0.5}, {0, 0}}, 0.5);
}

TEST_CASE("an oblique collision changes only the normal components") {
  check({1, {-0.6, -0.8}, {5, 0}}, {1, {0, 0}, {0, 0}}, 1);
  check({1, {0.8, -0.6}, {-2, 3}}, {1, {0, 0}, {1, 1}}, 0.5);
  check({1, {-0.6, 0.8}, {1, -4}}, {1, {0, 0}, {0, 2}}, 0);
}

TEST_CASE("the size of the discs does not matter") {
  check({1, {-3, -4}, {5, 0}}, {1, {0, 0}, {0, 0}}, 1);
  check({1, {-0.0625, -0.125}, {5, 0}}, {1, {0, 0}, {0, 0}}, 1);
}

TEST_CASE("the change of velocity is inversely proportional to the mass") {
  check({1, {-0.6, -0.8}, {5, 0}}, {3, {0, 0}, {0, 0}}, 1);
  check({8, {-0.6, -0.8}, {5, 0}}, {0.5, {0, 0}, {0, -1}}, 0.25);
}

TEST_CASE("separating discs are left alone") {
  check({1, {-0.6, -0.8}, {-5, 0}}, {1, {0, 0}, {0, 0}}, 1);
  check({1, {-0.5, 0}, {1, 2}}, {2, {0.5, 0}, {4, 0}}, 0.5);
  check({1, {-0.5, 0}, {1, 2}}, {2, {0.5, 0}, {0, 0}}, 0.5);
  check({1, {0, 1}, {4, 0}}, {1, {0, 0}, {0, 0}}, 1);
  check({1, {2, 1}, {4, 0}}, {1, {2, 1}, {0, 0}}, 1);
}

TEST_CASE("random touches agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] { return Vector{random.uniform(-9, 9), random.uniform(-9, 9)}; };
  // Motion orthogonal to the line of centres, up to rounding, may be taken for an approach or not.
  const auto apart = [](const Disc& a, const Disc& b) {
    const Vector d = a.centre - b.centre;
    return a.mass > 0 && b.mass > 0 && d.norm() > 0.1 &&
           std::abs(d.normalized().dot(a.velocity - b.velocity)) > 1e-9;
  };
  const auto possible = [&](const Disc& a, const Disc& b, double e) {
    return apart(a, b) && e >= 0 && e <= 1;
  };
  for (int asked = 0; asked < 200; ++asked) {
    const Disc a{random.uniform(0.2, 9), vector(), vector()};
    const Disc b{random.uniform(0.2, 9), vector(), vector()};
    shrinkable(check_approach, apart, a, b);
    shrinkable(check, possible, a, b, random.chance(0.3) ? 1.0 : random.uniform());
  }
}
