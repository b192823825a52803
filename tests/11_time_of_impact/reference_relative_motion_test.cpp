// Two moving points: the time of their closest approach, and paths that cross at other times.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/moving_spheres.hpp>
#include <contact/relative_motion.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <limits>

#include "moving_bodies.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

namespace relative_motion_test {
namespace {

using contact::closest_approach;
using contact::MovingPoint;
using contact::paths_meet;
using contact::Vector3;
using generators::Random;
using generators::tried;
using oracle::Rational;
using V = Vector3<double>;

TEMPLATE_TEST_CASE("closest approach: time and distance are those of fractions", "", float,
                   double) {
  using S = TestType;
  Random random(51);
  int inside = 0, first = 0, last = 0;
  for (int i = 0; i < tried(3000); ++i) {
    const auto any = [&]() -> Vector3<S> {
      return (i % 2 == 0 ? moving_bodies::on_integers(random, 3)
                         : V(moving_bodies::in_cube(random, 3)))
          .template cast<S>();
    };
    MovingPoint<S> a, b;
    a.start = any();
    a.displacement = any();
    b.start = any();
    b.displacement = any();
    const oracle::Vector d = oracle::exact(a.start) - oracle::exact(b.start);
    const oracle::Vector w = oracle::exact(a.displacement) - oracle::exact(b.displacement);
    const Rational square = w.dot(w);
    Rational t = square == 0 ? Rational(0) : Rational(-d.dot(w) / square);
    t = std::clamp(t, Rational(0), Rational(1));
    ++(t == 0 ? first : (t == 1 ? last : inside));
    const auto got = closest_approach(a, b);
    INFO("points " << i);
    REQUIRE(abs(Rational(oracle::exact(got.t) - t)) <= t * rounding::u<S>());
    const oracle::Vector at = d + w * t;
    const Rational squared = at.dot(at);
    const Rational distance = oracle::exact(got.distance);
    // Relative error of the square at most 8 u and a little.
    REQUIRE(abs(Rational(distance * distance - squared)) <= squared * 9 * rounding::u<S>());
  }
  CHECK(inside > tried(500));
  CHECK(first > tried(300));
  CHECK(last > tried(200));
}

TEST_CASE("paths that cross at different times meet, but the points never do") {
  const MovingPoint<double> a{V(-1, 0, 0), V(8, 0, 0)};  // at the crossing at 1/8
  const MovingPoint<double> b{V(0, -7, 0), V(0, 8, 0)};  // at 7/8
  CHECK(paths_meet(a, b, 0.0));
  CHECK(closest_approach(a, b).distance > 4);
  CHECK_FALSE(contact::spheres_touch_by<double>({a.start, 1}, a.displacement, {b.start, 1},
                                                b.displacement, 1));
}

TEST_CASE("spheres that touch in a step have paths that meet") {
  Random random(52);
  int touches = 0, only_paths = 0;
  for (int i = 0; i < tried(2000); ++i) {
    MovingPoint<double> a, b;
    a.start = moving_bodies::in_cube(random, 2);
    a.displacement = moving_bodies::in_cube(random, 4);
    b.start = moving_bodies::in_cube(random, 2);
    b.displacement = moving_bodies::in_cube(random, 4);
    const bool touch = contact::spheres_touch_by<double>({a.start, 0.5}, a.displacement,
                                                         {b.start, 0.5}, b.displacement, 1);
    const bool meet = paths_meet(a, b, 1.0);
    if (touch) CHECK(meet);
    touches += touch ? 1 : 0;
    only_paths += meet && !touch ? 1 : 0;
  }
  CHECK(touches > tried(50));
  CHECK(only_paths > tried(50));
}

TEST_CASE("swept volumes decide where one of two spheres is at rest") {
  Random random(53);
  int touches = 0, passes = 0;
  for (int i = 0; i < tried(2000); ++i) {
    const auto any = [&](double size) -> V {
      return i % 2 == 0 ? moving_bodies::on_integers(random, int(size))
                        : V(moving_bodies::in_cube(random, size));
    };
    const contact::Sphere<double> a{any(3), 1}, b{any(3), 0.5};
    const V way = any(5), rest(0, 0, 0);
    const bool touch = contact::moving_spheres_impact(a, way, b, rest).has_value();
    CHECK(contact::swept_spheres_meet(a, way, b, rest) == touch);
    ++(touch ? touches : passes);
  }
  CHECK(touches > tried(100));
  CHECK(passes > tried(300));
}

TEST_CASE("points with the same motion are closest at the start") {
  const MovingPoint<double> a{V(3, 4, 0), V(1e300, 0, 5)}, b{V(0, 0, 0), V(1e300, 0, 5)};
  const auto got = closest_approach(a, b);
  CHECK(got.t == 0);
  CHECK(got.distance == 5);
}

TEST_CASE("points of any scale are closest at the same time") {
  for (const double scale : {0x1p-1000, 0x1p-400, 0x1p400, 0x1p1000}) {
    const MovingPoint<double> a{V(-2, 1, 0) * scale, V(4, 0, 0) * scale};
    const auto got = closest_approach(a, MovingPoint<double>{});
    CHECK(got.t == 0.5);
    CHECK(got.distance == scale);
  }
}

TEST_CASE("points that are not finite have no closest approach, and their paths meet nothing") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const MovingPoint<double> none{V(nan, 0, 0), V(0, 0, 0)}, any;
  CHECK(std::isnan(closest_approach(none, any).t));
  CHECK(std::isnan(closest_approach(any, none).distance));
  CHECK_FALSE(paths_meet(none, any, 1.0));
  CHECK_FALSE(paths_meet(any, any, nan));
  CHECK_FALSE(paths_meet(any, any, -1.0));
  CHECK(paths_meet(any, any, 0.0));
}

}  // namespace
}  // namespace relative_motion_test
