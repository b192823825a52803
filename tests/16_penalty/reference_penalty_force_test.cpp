// Penalty forces on balls against fractions and square roots of fractions (classes (a) and (b) of
// the oracle). u is the unit roundoff of the type.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/penalty_force.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace penalty_force_test {

using contact::ContactRelease;
using contact::PenaltyBall;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Surd;

namespace {

template <class S>
Vector3<S> vector(Random& random, double size) {
  const S x = S(random.uniform(-size, size));
  const S y = S(random.uniform(-size, size));
  const S z = S(random.uniform(-size, size));
  return {x, y, z};
}

template <class S>
int exact_sign(const contact::Sphere<S>& a, const contact::Sphere<S>& b) {
  const oracle::Vector apart = oracle::exact(a.centre) - oracle::exact(b.centre);
  const Rational reach = oracle::exact(a.radius) + oracle::exact(b.radius);
  return oracle::sign(Rational(reach * reach - apart.dot(apart)));
}

}  // namespace

TEMPLATE_TEST_CASE("a half-space pushes a ball along its normal", "", float, double) {
  using S = TestType;
  Random random(1631);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  int touching = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const auto family = i % 3 == 0 ? generators::Family::grid : generators::Family::random;
    const auto wide = generators::plane(random, family);
    const contact::Plane<S> plane{generators::rounded<S>(wide.normal), S(wide.offset)};
    const PenaltyBall<S> ball{
        {i % 3 == 0 ? Vector3<S>(S(random.integer(-3, 3)), S(random.integer(-3, 3)),
                                 S(random.integer(-3, 3)))
                    : vector<S>(random, 2),
         S(i % 3 == 0 ? random.integer(0, 3) : random.uniform(0, 1))},
        vector<S>(random, 3)};
    const auto spring = contact::spring_damper(S(random.uniform(1, 100)), S(random.uniform(0, 9)));
    const Rational along = oracle::exact(plane.normal).dot(oracle::exact(ball.sphere.centre));
    const Rational depth =
        oracle::exact(ball.sphere.radius) - (along - oracle::exact(plane.offset));
    const Rational room =
        8 * u *
        (oracle::exact(ball.sphere.radius) +
         oracle::exact(plane.normal).cwiseAbs().dot(oracle::exact(ball.sphere.centre).cwiseAbs()) +
         abs(oracle::exact(plane.offset)));
    const auto got = contact::half_space_force(ball, plane, spring);
    if (!got.touching) {
      REQUIRE(depth <= (i % 3 == 0 ? Rational(0) : room));
      REQUIRE((i % 3 != 0 || depth < 0));  // integers: touching is a contact
      REQUIRE(got.force == Vector3<S>::Zero());
      REQUIRE(got.penetration == S(0));
      continue;
    }
    ++touching;
    REQUIRE(depth >= (i % 3 == 0 ? Rational(0) : Rational(-room)));
    REQUIRE(abs(oracle::exact(got.penetration) - depth) <= room);
    const Rational approach = -oracle::exact(plane.normal).dot(oracle::exact(ball.velocity));
    const Rational k = oracle::exact(spring.stiffness);
    const Rational c = oracle::exact(spring.damping);
    const Rational sum = k * depth + c * approach;
    // The error of the force is k times that of the penetration, plus 12 u of its terms: 4 for the
    // speed, 3 for the sum, 1 for the product with the normal, the rest is reserve. |v| is below 6.
    const Rational force_room = k * room + 12 * u * (k * abs(depth) + c * 6);
    const auto glued =
        contact::half_space_force(ball, plane, spring, ContactRelease::at_zero_penetration);
    for (int j = 0; j < 3; ++j) {
      const Rational n = oracle::exact(plane.normal(j));
      REQUIRE(abs(oracle::exact(glued.force(j)) - n * sum) <= force_room);
      REQUIRE(abs(oracle::exact(got.force(j)) - n * (sum < 0 ? Rational(0) : sum)) <= force_room);
    }
    REQUIRE(got.force.dot(plane.normal) >= S(0));
  }
  CHECK(touching > generators::tried(800));
}

TEMPLATE_TEST_CASE("whether balls touch is decided exactly", "", float, double) {
  using S = TestType;
  Random random(1632);
  int close = 0;
  int equal = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    contact::Sphere<S> a{vector<S>(random, 4), S(random.uniform(0, 2))};
    contact::Sphere<S> b{vector<S>(random, 4), S(random.uniform(0, 2))};
    if (i % 3 == 0) {  // touching up to the last bits
      b.radius = S((a.centre - b.centre).norm()) - a.radius;
      if (b.radius < S(0)) b.radius = S(0);
      for (int n = random.integer(0, 2); n > 0; --n)
        b.radius = std::nextafter(b.radius, S(random.chance(0.5) ? 0 : 9));
    } else if (i % 3 == 1) {  // 2² + 3² + 6² = 7²: exactly touching
      const int s = random.integer(1, 50);
      b.centre = Vector3<S>::Constant(S(random.integer(-9, 9)));
      a.centre = b.centre + Vector3<S>(S(2 * s), S(-3 * s), S(6 * s));
      a.radius = S(random.integer(0, 7 * s));
      b.radius = S(7 * s) - a.radius;
      if (i % 2 == 0) b.radius = std::nextafter(b.radius, S(random.chance(0.5) ? 0 : 999));
    }
    if (i % 7 == 0) {
      const S scale = S(std::ldexp(1.0, random.chance(0.5) ? -60 : 60));
      a = {a.centre * scale, a.radius * scale};
      b = {b.centre * scale, b.radius * scale};
    }
    const int right = exact_sign(a, b);
    REQUIRE(contact::overlap_sign(a, b) == right);
    REQUIRE(contact::overlap_sign(oracle::exact(a), oracle::exact(b)) == right);
    equal += right == 0;
    close += i % 3 != 2 && right != 0;
  }
  CHECK(close > generators::tried(2000));
  CHECK(equal > generators::tried(600));
}

TEMPLATE_TEST_CASE("the forces on two balls are opposite, and their momentum is conserved", "",
                   float, double) {
  using S = TestType;
  Random random(1633);
  const double u = double(contact::tolerance::unit_roundoff<S>);
  int touching = 0;
  int shallow = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    PenaltyBall<S> a{{vector<S>(random, 1), S(random.uniform(0.1, 1))}, vector<S>(random, 3)};
    PenaltyBall<S> b{{vector<S>(random, 1), S(random.uniform(0.1, 1))}, vector<S>(random, 3)};
    if (i % 4 == 0) {
      b.sphere.radius =
          std::max(S(0), S((a.sphere.centre - b.sphere.centre).norm() - a.sphere.radius));
    }
    const auto spring = contact::spring_damper(S(random.uniform(1, 100)), S(random.uniform(0, 9)));
    const auto got = contact::ball_ball_force(a, b, spring);
    const auto other = contact::ball_ball_force(b, a, spring);
    REQUIRE(got.force == Vector3<S>(-other.force));
    REQUIRE(got.touching == (exact_sign(a.sphere, b.sphere) >= 0));
    REQUIRE(got.penetration >= S(0));
    if (!got.touching) {
      REQUIRE(got.force == Vector3<S>::Zero());
      continue;
    }
    ++touching;
    const oracle::Vector apart = oracle::exact(a.sphere.centre) - oracle::exact(b.sphere.centre);
    const Rational reach = oracle::exact(a.sphere.radius) + oracle::exact(b.sphere.radius);
    const Rational square = apart.dot(apart);
    const Surd depth{reach, -1, square};
    // In addition to 8 u (r₁ + r₂), the difference of centres of magnitude up to 1 rounds to 2 u.
    const double room = 8 * u * oracle::nearest(reach) + 4 * u;
    REQUIRE(oracle::error(double(got.penetration), depth) <= room);
    shallow += oracle::nearest(depth) < 100 * u;
    // Along the line of centres: k d + c ḋ with ḋ = −(v · x) / |x|, so the force is
    // x (k (R/|x| − 1) − c (v · x) / |x|²), with the root of x · x.
    const Rational k = oracle::exact(spring.stiffness);
    const Rational c = oracle::exact(spring.damping);
    const Rational closing =
        -(oracle::exact(a.velocity) - oracle::exact(b.velocity)).dot(apart) / square;
    const auto glued = contact::ball_ball_force(a, b, spring, ContactRelease::at_zero_penetration);
    const double size = oracle::nearest(Rational(k * reach + c * 12));
    for (int j = 0; j < 3; ++j) {
      const Surd right{apart(j) * (c * closing - k), apart(j) * k * reach / square, square};
      // A direction has an error of a few u, more if the centres are close to each other.
      const double near = 1 + 1 / std::sqrt(oracle::nearest(square));
      REQUIRE(oracle::error(double(glued.force(j)), right) <= 40 * u * size * near);
    }
    REQUIRE(got.force.dot(Vector3<S>(a.sphere.centre - b.sphere.centre)) >= S(0));
  }
  CHECK(touching > generators::tried(1500));
  CHECK(shallow > generators::tried(300));
}

TEMPLATE_TEST_CASE("balls of any size, and concentric balls", "", float, double) {
  using S = TestType;
  const S large = std::numeric_limits<S>::max() / S(16);
  const S small = std::numeric_limits<S>::min() * S(16);
  const auto spring = contact::spring_damper(S(1), S(0));
  for (const S scale : {large, small, S(1)}) {
    const PenaltyBall<S> a{{Vector3<S>(scale, S(0), S(0)), scale}, Vector3<S>::Zero()};
    const PenaltyBall<S> b{{Vector3<S>::Zero(), scale}, Vector3<S>::Zero()};
    const auto got = contact::ball_ball_force(a, b, spring);
    CHECK(got.touching);
    CHECK(got.penetration == scale);
    CHECK(got.force == Vector3<S>(scale, S(0), S(0)));
    const auto same = contact::ball_ball_force(a, a, spring);
    CHECK(same.touching);
    CHECK(same.penetration == scale + scale);
    CHECK(same.force == Vector3<S>::Zero());
  }
}

}  // namespace penalty_force_test
