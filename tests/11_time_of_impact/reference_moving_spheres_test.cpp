// Moving spheres: the decision is that of fractions, and t is within its bound of the first root.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/moving_spheres.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <limits>
#include <optional>

#include "moving_bodies.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

namespace moving_spheres_impact_test {
namespace {

using contact::moving_spheres_impact;
using contact::Sphere;
using contact::Vector3;
using generators::Random;
using generators::tried;
using oracle::Rational;
using V = Vector3<double>;

template <class S>
struct Pair {
  Sphere<S> a, b;
  Vector3<S> displacement_a, displacement_b;
};

/// On integers; of any direction; grazing up to some ulps; far from the origin; almost in touch at
/// the start.
template <class S>
Pair<S> pair_of(Random& random, int family) {
  const auto any = [&](double size) -> V {
    return family == 0 ? moving_bodies::on_integers(random, int(size))
                       : V(moving_bodies::in_cube(random, size));
  };
  V p = any(3), q = any(3), u = any(4), v = any(4);
  double r = family == 0 ? random.integer(0, 2) : random.uniform(0, 1);
  const double s = family == 0 ? random.integer(0, 2) : random.uniform(0, 1);
  if (random.chance(0.5)) v = u + (p - q) * random.uniform(0.4, 1.5);
  if (family == 2) {
    // Their paths pass at the sum of the radii, up to rounding.
    const V way = u - v, away = way.cross(any(1)).normalized();
    p = q - way * random.uniform(0, 1.2) + away * (r + s);
  }
  if (family == 3) {
    const V far = any(1e6);
    p += far;
    q += far;
  }
  if (family == 4) p = q + (p - q).normalized() * ((r + s) * (1 + random.integer(-2, 2) * 0x1p-52));
  return {
      {p.cast<S>(), static_cast<S>(r)}, {q.cast<S>(), static_cast<S>(s)}, u.cast<S>(), v.cast<S>()};
}

/// The squared distance of the centres less that of touch, at a time.
struct Gap {
  oracle::Vector d, w;
  Rational reach;
  Rational at(const Rational& t) const {
    const oracle::Vector x = d + w * t;
    return x.dot(x) - reach * reach;
  }
};

template <class S>
Gap gap_of(const Pair<S>& pair) {
  return {oracle::exact(pair.a.centre) - oracle::exact(pair.b.centre),
          oracle::exact(pair.displacement_a) - oracle::exact(pair.displacement_b),
          oracle::exact(pair.a.radius) + oracle::exact(pair.b.radius)};
}

/// The time in the step at which the centres are closest.
Rational closest_time(const Gap& gap) {
  const Rational square = gap.w.dot(gap.w);
  if (square == 0) return 0;
  const Rational t = -gap.d.dot(gap.w) / square;
  return t < 0 ? Rational(0) : (t > 1 ? Rational(1) : t);
}

TEMPLATE_TEST_CASE("moving spheres in a step: no touch missed, none invented, t to 32 u", "", float,
                   double) {
  using S = TestType;
  Random random(61);
  int touches = 0, passes = 0, starts = 0;
  for (int i = 0; i < tried(10000); ++i) {
    const Pair<S> pair = pair_of<S>(random, i % 5);
    const Gap gap = gap_of(pair);
    const Rational closest = closest_time(gap);
    const bool right = gap.at(closest) <= 0;
    const auto got =
        moving_spheres_impact(pair.a, pair.displacement_a, pair.b, pair.displacement_b);
    INFO("pair " << i);
    REQUIRE(got.has_value() == right);
    if (!right) {
      ++passes;
      continue;
    }
    REQUIRE((*got == 0) == (gap.at(0) <= 0));
    REQUIRE_FALSE(std::signbit(*got));
    ++(*got == 0 ? starts : touches);
    if (*got == 0) continue;
    // The gap is open a little before, and closed a little after unless that is past the closest.
    const Rational t = oracle::exact(*got), room = t * 32 * rounding::u<S>();
    REQUIRE(t - room <= closest);
    REQUIRE(gap.at(t - room) >= 0);
    if (t + room < closest) REQUIRE(gap.at(t + room) <= 0);
  }
  CHECK(touches > tried(2000));
  CHECK(passes > tried(1500));
  CHECK(starts > tried(500));
}

TEST_CASE("moving spheres in a step agree with the first approach where that comes in the step") {
  Random random(62);
  for (int i = 0; i < tried(2000); ++i) {
    const Pair<double> pair = pair_of<double>(random, 1);
    const auto step =
        moving_spheres_impact(pair.a, pair.displacement_a, pair.b, pair.displacement_b);
    if (!step || *step == 0) continue;
    const auto time =
        contact::sphere_sphere_impact(pair.a, pair.displacement_a, pair.b, pair.displacement_b);
    REQUIRE(time.has_value());
    CHECK(std::abs(*time - *step) <= 300 * 0x1p-53 * *step);
  }
}

TEST_CASE("spheres that overlap and move apart touch at 0, and those that only touched before do") {
  CHECK(moving_spheres_impact<double>({V(0, 0, 0), 1}, V(-4, 0, 0), {V(1, 0, 0), 1}, V(4, 0, 0)) ==
        0.0);
  CHECK(moving_spheres_impact<double>({V(0, 0, 0), 1}, V(-4, 0, 0), {V(2, 0, 0), 1}, V(0, 0, 0)) ==
        0.0);
}

TEST_CASE("spheres that arrive at the end of the step touch at 1, one ulp short they do not") {
  const Sphere<double> a{V(0, 0, 0), 1}, b{V(4, 0, 0), 1};
  CHECK(moving_spheres_impact<double>(a, V(2, 0, 0), b, V(0, 0, 0)) == 1.0);
  CHECK_FALSE(moving_spheres_impact<double>(a, V(std::nextafter(2, 0), 0, 0), b, V(0, 0, 0)));
}

TEST_CASE(
    "spheres that pass at exactly the sum of their radii touch, one ulp farther they do not") {
  const Sphere<double> still{V(0, 0, 0), 1};
  CHECK(moving_spheres_impact<double>({V(-2, 2, 0), 1}, V(4, 0, 0), still, V(0, 0, 0)) == 0.5);
  CHECK_FALSE(moving_spheres_impact<double>({V(-2, std::nextafter(2, 3), 0), 1}, V(4, 0, 0), still,
                                            V(0, 0, 0)));
}

TEST_CASE("moving spheres of any scale touch at the same time") {
  for (const double scale : {0x1p-1060, 0x1p-500, 0x1p500, 0x1p1000}) {
    const V way = V(4, 0, 0) * scale;
    const auto got = moving_spheres_impact<double>({V(0, 0, 0), scale}, way,
                                                   {V(4, 0, 0) * scale, scale}, V(0, 0, 0));
    CHECK(got == 0.5);
  }
}

TEST_CASE("moving spheres with a number that is not finite touch nothing") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere<double> ball{V(0, 0, 0), 1};
  const V rest(0, 0, 0);
  CHECK_FALSE(moving_spheres_impact<double>({V(nan, 0, 0), 1}, rest, ball, rest));
  CHECK_FALSE(moving_spheres_impact<double>(ball, rest, {V(0, 0, 0), nan}, rest));
  CHECK_FALSE(moving_spheres_impact<double>(ball, V(0, nan, 0), ball, rest));
  CHECK_FALSE(moving_spheres_impact<double>(ball, rest, ball, V(0, 0, nan)));
}

}  // namespace
}  // namespace moving_spheres_impact_test
