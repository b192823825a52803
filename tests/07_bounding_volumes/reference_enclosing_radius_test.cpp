// Containment in a sphere and enclosing radii against fractions, and the numbers with error bounds
// that decide most of them.
#include <07_bounding_volumes/sphere_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bounded_double_double.hpp>
#include <contact/enclosing_radius.hpp>
#include <limits>
#include <map>
#include <stdexcept>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <type_traits>
#include <vector>

namespace enclosing_radius_test {
namespace {

using contact::BoundedDoubleDouble;
using contact::contains;
using contact::enclosing_radius;
using contact::Sphere;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using sphere_truth::distance_squared;

using volume_families::span_of;
/// Bit patterns of every magnitude.
template <class S>
Vector3<S> any_point(Random& random) {
  const S x = generators::any_finite<S>(random), y = generators::any_finite<S>(random);
  return {x, y, generators::any_finite<S>(random)};
}
template <class S>
bool contains_exactly(const Sphere<S>& sphere, const Vector3<S>& point) {
  const Rational r = oracle::exact(sphere.radius);
  return distance_squared(oracle::exact(point), oracle::exact(sphere.centre)) <= r * r;
}
/// The radius is a number up or down from the distance, or the nearest one to it.
template <class S>
S radius_near(Random& random, const Vector3<S>& centre, const Vector3<S>& point) {
  const double d = (point.template cast<double>() - centre.template cast<double>()).norm();
  S radius = static_cast<S>(std::min(d, static_cast<double>(std::numeric_limits<S>::max())));
  for (int k = random.integer(-1, 1); k != 0; k -= k > 0 ? 1 : -1) {
    radius = std::nextafter(radius, k > 0 ? std::numeric_limits<S>::infinity() : S(0));
  }
  return std::min(radius, std::numeric_limits<S>::max());
}

TEMPLATE_TEST_CASE("a sphere contains the points that are near enough in fractions", "", float,
                   double) {
  using S = TestType;
  Random random(1);
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(10000); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const auto points = volume_families::points<S>(random, family, 2);
    const Sphere<S> sphere{points.front(), radius_near<S>(random, points.front(), points.back())};
    const bool inside = contains(sphere, points.back());
    ++seen[inside];
    INFO("case " << i);
    REQUIRE(inside == contains_exactly(sphere, points.back()));
  }
  CHECK(seen[true] > generators::tried(3000));
  CHECK(seen[false] > generators::tried(2000));
}

TEST_CASE("a point with whole coordinates on the surface of a sphere is contained") {
  Random random(2);
  for (int i = 0; i < generators::tried(5000); ++i) {
    const auto points =
        volume_families::points<double>(random, volume_families::Family::cospherical, 1);
    // 2² + 3² + 6² = 7², and so on: times and moved by whole numbers.
    const double by = random.integer(1, 1 << 20);
    const Vector3<double> away = random.chance(0.5) ? Vector3<double>(2 * by, 3 * by, 6 * by)
                                                    : Vector3<double>(-6 * by, 2 * by, -3 * by);
    const Vector3<double> point = points.front() + away;
    INFO("case " << i);
    REQUIRE(contains<double>({points.front(), 7 * by}, point));
    REQUIRE_FALSE(contains<double>({points.front(), std::nextafter(7 * by, 0)}, point));
  }
}

TEMPLATE_TEST_CASE("containment is decided at every magnitude", "", float, double) {
  using S = TestType;
  Random random(3);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const Vector3<S> centre = any_point<S>(random), point = any_point<S>(random);
    const S radius = i % 2 == 0 ? std::abs(generators::any_finite<S>(random))
                                : radius_near<S>(random, centre, point);
    const Sphere<S> sphere{centre, radius};
    INFO("case " << i);
    REQUIRE(contains(sphere, point) == contains_exactly(sphere, point));
  }
}

TEST_CASE("a sphere contains nothing if a number is not finite or the radius is negative") {
  const Sphere<double> sphere{Vector3<double>(1, 2, 3), 4};
  const Vector3<double> point(1, 2, 3);
  REQUIRE(contains(sphere, point));
  CHECK_FALSE(contains<double>({sphere.centre, -4}, point));
  for (const double bad :
       {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    for (int k = 0; k < 3; ++k) {
      Vector3<double> broken = point;
      broken[k] = bad;
      CHECK_FALSE(contains(sphere, broken));
      CHECK_FALSE(contains<double>({broken, 4}, point));
    }
    CHECK_FALSE(contains<double>({point, bad}, point));
  }
}

/// Sets of points of all families; every other set scaled to an extreme.
template <class S>
std::vector<Vector3<S>> drawn(Random& random, int i) {
  const auto family =
      volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
  const int count = random.integer(1, 12);
  auto points = volume_families::points<S>(random, family, count);
  constexpr int most = std::is_same_v<S, float> ? 80 : 960;
  if (i % 2 == 1) {
    const S by = std::ldexp(S(1), random.integer(-most, most));
    points = volume_families::scaled<S>(points, by);
  }
  return points;
}

TEMPLATE_TEST_CASE("the enclosing radius is the smallest number that encloses every point", "",
                   float, double) {
  using S = TestType;
  Random random(4);
  for (int i = 0; i < generators::tried(12000); ++i) {
    const auto points = drawn<S>(random, i);
    Vector3<S> centre = points[0];
    if (i % 3 == 1) centre = (points[0] + points.back()) / 2;
    if (i % 3 == 2) centre = Vector3<S>::Zero();
    const S radius = enclosing_radius(centre, span_of(points));
    INFO("case " << i);
    REQUIRE(sphere_truth::is_root_rounded_up(
        radius, sphere_truth::largest_distance_squared(sphere_truth::exact(points),
                                                       oracle::exact(centre))));
  }
}

TEMPLATE_TEST_CASE("the enclosing radius is right for numbers of every magnitude", "", float,
                   double) {
  using S = TestType;
  Random random(5);
  int in_range = 0;
  for (int i = 0; i < generators::tried(1000); ++i) {
    std::vector<Vector3<S>> points{any_point<S>(random), any_point<S>(random)};
    // Often all but the smallest numbers.
    if (i % 2 == 0) {
      for (auto& p : points) p *= std::numeric_limits<S>::min();
    }
    const Vector3<S> centre = i % 4 < 2 ? points.back() : Vector3<S>(Vector3<S>::Zero());
    points.pop_back();
    const Rational square =
        sphere_truth::largest_distance_squared(sphere_truth::exact(points), oracle::exact(centre));
    const Rational most = oracle::exact(std::numeric_limits<S>::max());
    INFO("case " << i);
    if (square > most * most) {
      REQUIRE_THROWS_AS(enclosing_radius(centre, span_of(points)), std::invalid_argument);
      continue;
    }
    ++in_range;
    REQUIRE(sphere_truth::is_root_rounded_up(enclosing_radius(centre, span_of(points)), square));
  }
  CHECK(in_range > generators::tried(500));
}

TEST_CASE("the enclosing radius does not depend on the order of the points") {
  Random random(6);
  for (int i = 0; i < generators::tried(2000); ++i) {
    auto points = drawn<double>(random, i);
    const Vector3<double> centre = points[0];
    const double radius = enclosing_radius(centre, span_of(points));
    std::reverse(points.begin(), points.end());
    INFO("case " << i);
    REQUIRE(enclosing_radius(centre, span_of(points)) == radius);
  }
}

/// Whether a sphere about a centre contains all spheres of a list.
template <class S>
bool encloses(const Vector3<S>& centre, S radius, const std::vector<Sphere<S>>& spheres) {
  for (const Sphere<S>& sphere : spheres) {
    const Rational room = oracle::exact(radius) - oracle::exact(sphere.radius);
    if (room < 0) return false;
    if (distance_squared(oracle::exact(centre), oracle::exact(sphere.centre)) > room * room) {
      return false;
    }
  }
  return true;
}

TEMPLATE_TEST_CASE("the enclosing radius of spheres is the smallest number that encloses all", "",
                   float, double) {
  using S = TestType;
  Random random(7);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto points = drawn<S>(random, i);
    const Vector3<S>& centre = points[0];
    std::vector<Sphere<S>> spheres;
    for (const auto& p : points) {
      // From far smaller than the distance to far larger.
      const S size = p.cwiseAbs().maxCoeff() * std::ldexp(S(1), random.integer(-30, 3));
      spheres.push_back({p, random.chance(0.2) ? S(0) : size});
    }
    const S radius = enclosing_radius(centre, std::span<const Sphere<S>>(spheres));
    INFO("case " << i);
    REQUIRE(encloses(centre, radius, spheres));
    if (radius > 0) REQUIRE_FALSE(encloses(centre, std::nextafter(radius, S(0)), spheres));
  }
}

TEST_CASE("an enclosing radius of invalid points or spheres is refused") {
  const Vector3<double> origin(0, 0, 0), x(1, 0, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1.7e308;
  const auto of_points = [](const Vector3<double>& centre,
                            const std::vector<Vector3<double>>& points) {
    return enclosing_radius(centre, span_of(points));
  };
  const auto of_spheres = [](const Vector3<double>& centre,
                             const std::vector<Sphere<double>>& spheres) {
    return enclosing_radius(centre, std::span<const Sphere<double>>(spheres));
  };
  CHECK(of_points(origin, {x}) == 1);
  CHECK(of_spheres(origin, {{x, 2}}) == 3);
  CHECK_THROWS_AS(of_points(origin, {}), std::invalid_argument);
  CHECK_THROWS_AS(of_points(origin, {x, {0, nan, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(of_points({nan, 0, 0}, {x}), std::invalid_argument);
  CHECK_THROWS_AS(of_points({-huge, 0, 0}, {{huge, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(of_spheres(origin, {}), std::invalid_argument);
  CHECK_THROWS_AS(of_spheres(origin, {{x, -1}}), std::invalid_argument);
  CHECK_THROWS_AS(of_spheres(origin, {{x, nan}}), std::invalid_argument);
  CHECK_THROWS_AS(of_spheres(origin, {{{huge, 0, 0}, huge}}), std::invalid_argument);
}

// ---------------------------------------------------------------- numbers with error bounds

Rational value_of(const BoundedDoubleDouble& x) {
  return oracle::exact(x.high) + oracle::exact(x.low);
}
/// A sum of two doubles, the second at most half an ulp of the first, with a bound or without.
BoundedDoubleDouble any_number(Random& random, int spread) {
  const double high = random.magnitude(-spread, spread);
  const auto [sum, rest] = contact::two_sum(high, high * random.uniform(-1, 1) * 0x1p-54);
  const double bound = random.chance(0.5) ? 0 : std::abs(high) * 0x1p-90 * random.uniform();
  return {sum, rest, bound};
}
/// A number that such a one may stand for.
Rational meant(Random& random, const BoundedDoubleDouble& x) {
  return value_of(x) + oracle::exact(x.bound) * oracle::exact(random.uniform(-1, 1));
}
bool is_within(const BoundedDoubleDouble& x, const Rational& exact) {
  if (!std::isfinite(x.bound)) return true;
  return abs(value_of(x) - exact) <= oracle::exact(x.bound);
}

TEST_CASE("the bound of a double-double covers the exact result of every operation") {
  Random random(8);
  for (int i = 0; i < generators::tried(5000); ++i) {
    const int spread = i % 4 == 0 ? 480 : 20;
    const BoundedDoubleDouble x = any_number(random, spread), y = any_number(random, spread);
    const Rational p = meant(random, x), q = meant(random, y);
    INFO("case " << i);
    REQUIRE(is_within(x + y, p + q));
    REQUIRE(is_within(x - y, p - q));
    REQUIRE(is_within(x * y, p * q));
    REQUIRE(is_within(x / y, p / q));
    if (spread < 100) REQUIRE((x * y).bound <= std::abs((x * y).high) * 0x1p-85);
  }
}

TEST_CASE("the bound of a double-double covers underflow") {
  Random random(9);
  for (int i = 0; i < generators::tried(3000); ++i) {
    BoundedDoubleDouble x = any_number(random, 20), y = any_number(random, 20);
    for (double* part : {&x.high, &x.low, &x.bound}) *part *= 0x1p-500;
    for (double* part : {&y.high, &y.low, &y.bound}) *part *= 0x1p-480;
    const Rational p = value_of(x), q = value_of(y);
    INFO("case " << i);
    REQUIRE(is_within(x * y, p * q));
    REQUIRE(is_within(x * y + y, p * q + q));
  }
}

TEST_CASE("a double-double of few digits stays exact") {
  Random random(10);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const double a = random.integer(-(1 << 20), 1 << 20), b = random.integer(1, 1 << 20),
                 c = random.integer(-(1 << 20), 1 << 20);
    const BoundedDoubleDouble x(a), y(b), z(c);
    const BoundedDoubleDouble sum = x * y * z + x * x * y - z;
    INFO("case " << i);
    REQUIRE(sum.bound == 0);
    REQUIRE(value_of(sum) == Rational(a) * b * c + Rational(a) * a * b - Rational(c));
    REQUIRE((sum - sum).is_zero());
    REQUIRE((x * y / y).bound == 0);
    REQUIRE((x * y / y).high == a);
  }
}

TEST_CASE("no sign of a double-double is certain after an overflow") {
  const BoundedDoubleDouble huge(0x1p1000), more = huge * huge;
  CHECK(more.certain_sign() == 0);
  CHECK((more - more).certain_sign() == 0);
  CHECK_FALSE((more - more).is_zero());
  CHECK((BoundedDoubleDouble(1) / (huge - huge)).certain_sign() == 0);
}

}  // namespace
TEST_CASE("the radius around spheres is the smallest number also for subnormal numbers") {
  const double eta = std::numeric_limits<double>::denorm_min();
  const std::vector<Sphere<double>> one{{{3 * eta, 0, 0}, 3 * eta}};
  CHECK(contact::enclosing_radius<double>({0, 0, 0}, one) == 6 * eta);
}

}  // namespace enclosing_radius_test
