// aabb.hpp and outward.hpp: boxes contain what they enclose, and are as small as possible.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/outward.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace aabb_test {

using contact::Vector3;
using generators::Random;
using oracle::Rational;

/// Each coordinate from -size to size.
template <class S>
Vector3<S> any_point(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {S(x), S(y), static_cast<S>(random.uniform(-size, size))};
}

TEMPLATE_TEST_CASE("sums are rounded outwards to the next number, and no further", "", float,
                   double) {
  using S = TestType;
  Random random(1);
  const S infinity = std::numeric_limits<S>::infinity();
  for (int i = 0; i < generators::tried(4000); ++i) {
    const int range = i % 2 == 0 ? 4 : std::numeric_limits<S>::max_exponent - 2;
    const S a = static_cast<S>(random.magnitude(-range, range));
    S b = static_cast<S>(random.magnitude(-range, range));
    if (i % 5 == 0) b = -std::nextafter(a, S(0));
    const Rational sum = oracle::exact(a) + oracle::exact(b);
    const S up = contact::sum_up(a, b);
    const S down = contact::sum_down(a, b);
    CHECK(oracle::exact(up) >= sum);
    CHECK(oracle::exact(std::nextafter(up, -infinity)) < sum);
    CHECK(oracle::exact(down) <= sum);
    CHECK(oracle::exact(std::nextafter(down, infinity)) > sum);
  }
  const S largest = std::numeric_limits<S>::max();
  CHECK(contact::sum_up(largest, largest) == infinity);
  CHECK(contact::sum_down(largest, largest) == largest);
  CHECK(contact::sum_up(-largest, -largest) == -largest);
  CHECK(contact::sum_down(-largest, -largest) == -infinity);
  CHECK(contact::sum_up(largest, std::numeric_limits<S>::denorm_min()) == infinity);
  CHECK(contact::sum_up(largest, -largest) == 0);
  const S nan = std::numeric_limits<S>::quiet_NaN();
  CHECK(std::isnan(contact::sum_up(nan, S(1))));
  CHECK(std::isnan(contact::sum_down(S(1), nan)));
  CHECK(std::isnan(contact::sum_up(infinity, -infinity)));
  CHECK(contact::sum_up(infinity, S(1)) == infinity);
}

TEMPLATE_TEST_CASE("the box of a sphere contains it, and no smaller one does", "", float, double) {
  using S = TestType;
  Random random(11);
  const S infinity = std::numeric_limits<S>::infinity();
  for (int i = 0; i < generators::tried(3000); ++i) {
    const int range = i % 3 == 0 ? 60 : 3;
    contact::Sphere<S> sphere;
    for (int k = 0; k < 3; ++k) sphere.centre(k) = static_cast<S>(random.magnitude(-range, range));
    sphere.radius = static_cast<S>(std::abs(random.magnitude(-range, range)));
    const auto box = contact::aabb_of_sphere(sphere);
    const auto exact = oracle::exact(sphere);
    for (int k = 0; k < 3; ++k) {
      const Rational low = exact.centre(k) - exact.radius;
      const Rational high = exact.centre(k) + exact.radius;
      CHECK(oracle::exact(box.low(k)) <= low);
      CHECK(oracle::exact(std::nextafter(box.low(k), infinity)) > low);
      CHECK(oracle::exact(box.high(k)) >= high);
      CHECK(oracle::exact(std::nextafter(box.high(k), -infinity)) < high);
    }
    Vector3<S> way;
    for (int k = 0; k < 3; ++k) way(k) = static_cast<S>(random.magnitude(-range, range));
    const auto swept = contact::aabb_of_swept_sphere(sphere, way);
    const S margin = sphere.radius / 3;
    const auto moved = contact::aabb_of_swept_box(box, way, margin);
    for (int k = 0; k < 3; ++k) {
      for (const Rational& t : {Rational(0), Rational(1), Rational(1) / 3}) {
        const Rational middle = exact.centre(k) + t * oracle::exact(way(k));
        CHECK(oracle::exact(swept.low(k)) <= middle - exact.radius);
        CHECK(oracle::exact(swept.high(k)) >= middle + exact.radius);
        const Rational shift = t * oracle::exact(way(k));
        CHECK(oracle::exact(moved.low(k)) <=
              oracle::exact(box.low(k)) + shift - oracle::exact(margin));
        CHECK(oracle::exact(moved.high(k)) >=
              oracle::exact(box.high(k)) + shift + oracle::exact(margin));
      }
      // Two sums rounded outwards, each by less than an ulp of its terms.
      const Rational size = abs(exact.centre(k)) + abs(oracle::exact(way(k))) + exact.radius;
      const Rational room = 4 * oracle::exact(contact::tolerance::unit_roundoff<S>) * size;
      const Rational least =
          std::min(exact.centre(k), Rational(exact.centre(k) + oracle::exact(way(k))));
      CHECK(oracle::exact(swept.low(k)) >= least - exact.radius - room);
    }
  }
}

TEST_CASE("boxes that contain points and boxes") {
  const std::vector<Vector3<double>> points{{1, 5, -2}, {3, -1, 0}, {2, 2, 2}};
  const auto box = contact::aabb_of_points<double>(points);
  CHECK(box.low == Vector3<double>(1, -1, -2));
  CHECK(box.high == Vector3<double>(3, 5, 2));
  const auto both = contact::enclosing_box(box, {{0, 0, 0}, {9, 1, 1}});
  CHECK(both.low == Vector3<double>(0, -1, -2));
  CHECK(both.high == Vector3<double>(9, 5, 2));
}

TEST_CASE("an invalid box is refused, with the argument and the value") {
  using V = Vector3<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double largest = std::numeric_limits<double>::max();
  const auto says = [](auto make, const std::string& words) {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      INFO(error.what());
      CHECK(std::string(error.what()).find(words) != std::string::npos);
      return;
    }
    FAIL("nothing was thrown; expected: " << words);
  };
  using contact::aabb_from_corners;
  says([&] { aabb_from_corners<double>(V(0, nan, 0), V(1, 1, 1)); }, "low = (0, nan, 0)");
  says([&] { aabb_from_corners<double>(V(0, 0, 0), V(1, infinity, 1)); }, "high = (1, inf, 1)");
  says([&] { aabb_from_corners<double>(V(0, 2, 0), V(1, 1, 1)); }, "low = (0, 2, 0)");
  says([&] { contact::aabb_of_points<double>({}); }, "points = {}");
  says([&] { contact::aabb_of_sphere<double>({V(0, 0, 0), -1}); }, "radius = -1");
  says([&] { contact::aabb_of_sphere<double>({V(0, 0, 0), nan}); }, "radius = nan");
  says([&] { contact::aabb_of_sphere<double>({V(nan, 0, 0), 1}); }, "centre = (nan, 0, 0)");
  says([&] { contact::aabb_of_sphere<double>({V(largest, 0, 0), largest}); }, "its box overflows");
  says(
      [&] {
        contact::aabb_of_swept_sphere<double>({V(0, 0, 0), 1}, V(0, infinity, 0));
      },
      "displacement = (0, inf, 0)");
  says(
      [&] {
        contact::aabb_of_swept_sphere<double>({V(largest, 0, 0), 1}, V(largest, 0, 0));
      },
      "its box overflows");
  says([&] { contact::aabb_of_swept_box<double>({}, V(0, 0, 0), -1); }, "margin = -1");
  // A flat box and a point are boxes.
  CHECK(contact::boxes_touch(aabb_from_corners<double>(V(1, 1, 1), V(1, 1, 1)),
                             aabb_from_corners<double>(V(0, 0, 1), V(2, 2, 1))));
}

}  // namespace aabb_test
