// The smallest sphere against fractions: by the conditions that only the smallest one meets, and
// for few points by trying every support.
#include <07_bounding_volumes/sphere_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/smallest_sphere.hpp>
#include <limits>
#include <map>
#include <stdexcept>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <type_traits>
#include <vector>

namespace smallest_sphere_test {
namespace {

using contact::smallest_sphere;
using contact::SmallestSphere;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using volume_families::Family;
template <class S>
using Points = std::vector<Vector3<S>>;

using volume_families::span_of;
/// Coordinates moved by an ulp or so: decisions become close, and ties break.
template <class S>
void nudge(Random& random, Points<S>& points) {
  for (auto& p : points) {
    for (S& x : p) {
      if (random.chance(0.7)) continue;
      x = std::nextafter(x, random.chance(0.5) ? S(100) : S(-100));
    }
  }
}

/// Whether a result is the smallest sphere, rounded as it promises.
template <class S>
bool is_right(const SmallestSphere<S>& found, const Points<S>& points) {
  const auto& support = found.support;
  const auto count = static_cast<std::size_t>(found.support_count);
  if (count < 1 || count > 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i >= count && support[i] != -1) return false;
    if (i > 0 && i < count && support[i] <= support[i - 1]) return false;
  }
  const auto exact = sphere_truth::exact(points);
  const auto ball = sphere_truth::certified(exact, std::span<const int>(support.data(), count));
  if (!ball) return false;
  for (int k = 0; k < 3; ++k) {
    if (found.sphere.centre(k) != sphere_truth::nearest<S>(ball->centre(k))) return false;
  }
  if (found.radius_squared != oracle::nearest(ball->radius_squared)) return false;
  return sphere_truth::is_root_rounded_up(
      found.sphere.radius,
      sphere_truth::largest_distance_squared(exact, oracle::exact(found.sphere.centre)));
}

TEMPLATE_TEST_CASE("the smallest sphere of every family meets the conditions of the smallest one",
                   "", float, double) {
  using S = TestType;
  Random random(1);
  std::array<int, 5> supports{};
  for (int i = 0; i < generators::tried(6000); ++i) {
    Points<S> points = volume_families::drawn<S>(random, i, 12);
    if (i % 3 == 0) nudge(random, points);
    const auto found = smallest_sphere(span_of(points));
    INFO("case " << i);
    REQUIRE(is_right(found, points));
    ++supports[static_cast<std::size_t>(found.support_count)];
  }
  for (const std::size_t count : {1U, 2U, 3U, 4U}) {
    INFO("supports of " << count);
    CHECK(supports[count] > generators::tried(200));
  }
}

TEST_CASE("the smallest sphere of few points is the smallest of those through some of them") {
  Random random(2);
  for (int i = 0; i < generators::tried(1000); ++i) {
    Points<double> points = volume_families::drawn<double>(random, i, 7);
    if (i % 2 == 0) nudge(random, points);
    INFO("case " << i);
    REQUIRE(smallest_sphere(span_of(points)).radius_squared ==
            oracle::nearest(sphere_truth::smallest(sphere_truth::exact(points)).radius_squared));
  }
}

TEST_CASE("the smallest sphere of any four points of a small grid is right") {
  // 27 points, with many right angles, equal distances and planes.
  const auto point = [](int i) {
    const int row = i / 3 % 3, layer = i / 9;
    return Vector3<double>(i % 3, row, layer);
  };
  const int step = generators::sanitized ? 5 : 1;
  for (int a = 0; a < 27; a += step) {
    for (int b = a; b < 27; ++b) {
      for (int c = b + 1; c < 27; ++c) {
        const int d = (a + 5 * b + 7 * c) % 27;
        const Points<double> points{point(a), point(b), point(c), point(d)};
        REQUIRE(is_right(smallest_sphere(span_of(points)), points));
      }
    }
  }
}

TEST_CASE("points that miss a common circle by far less than an ulp are decided") {
  // Whole points on a circle of radius 65, some of them lifted off its plane by 2^-30 to 2^-500.
  constexpr std::array<std::array<int, 2>, 4> found{{{65, 0}, {63, 16}, {60, 25}, {56, 33}}};
  Random random(12);
  std::array<int, 5> supports{};
  for (int i = 0; i < generators::tried(3000); ++i) {
    Points<double> points;
    const int count = random.integer(3, 8), exponent = random.integer(30, 500);
    for (int k = 0; k < count; ++k) {
      const auto& p = found[static_cast<std::size_t>(random.integer(0, 3))];
      const double x = random.chance(0.5) ? p[0] : -p[0], y = random.chance(0.5) ? p[1] : -p[1];
      const double z = random.integer(-2, 2) * std::ldexp(1.0, -exponent);
      points.push_back(random.chance(0.5) ? Vector3<double>(x, y, z) : Vector3<double>(y, x, z));
    }
    const auto result = smallest_sphere(span_of(points));
    INFO("case " << i);
    REQUIRE(is_right(result, points));
    ++supports[static_cast<std::size_t>(result.support_count)];
  }
  for (const std::size_t count : {2U, 3U, 4U}) {
    INFO("supports of " << count);
    CHECK(supports[count] > generators::tried(100));
  }
}

/// Whether a number stands for another one, times a power of two.
template <class T>
bool stands_for(const T& x, const Rational& exact, double scale) {
  Rational value = 0;
  if constexpr (std::is_same_v<T, contact::RunningError>) {
    value = oracle::exact(x.value);
  } else {
    value = oracle::exact(x.high) + oracle::exact(x.low);
  }
  return abs(value - exact * oracle::exact(scale)) <= oracle::exact(x.bound);
}

TEMPLATE_TEST_CASE("differences of points are within their bounds", "", float, double) {
  using S = TestType;
  Random random(13);
  for (int i = 0; i < generators::tried(2000); ++i) {
    Points<S> points = volume_families::drawn<S>(random, i, 4);
    if (i % 3 == 0) {
      constexpr int most = std::numeric_limits<S>::max_exponent - 45;
      points = volume_families::scaled<S>(points, std::ldexp(S(1), random.integer(-most, most)));
    }
    // Coordinates of very different magnitudes.
    if (i % 3 == 1) points.push_back(points[0] * std::ldexp(S(1), -random.integer(1, 100)));
    const contact::sphere_detail::LocalPoints<S> local{span_of(points)};
    const double scale = local.scaling().scale();
    const int last = local.size() - 1;
    const auto rough = local.template difference<contact::RunningError>(last, 0);
    const auto sharp = local.template difference<contact::BoundedDoubleDouble>(last, 0);
    INFO("case " << i);
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational exact =
          oracle::exact(local.coordinate(last, k)) - oracle::exact(local.coordinate(0, k));
      REQUIRE(stands_for(rough[k], exact, scale));
      REQUIRE(stands_for(sharp[k], exact, scale));
      const Rational here = oracle::exact(local[last](static_cast<int>(k)));
      REQUIRE(abs(here - exact * oracle::exact(scale)) <=
              abs(here) * oracle::exact(0x1p-53) + oracle::exact(0x1p-1000));
    }
  }
}

TEST_CASE("points of a sphere of whole numbers are all on the surface of the smallest one") {
  Random random(3);
  for (int i = 0; i < generators::tried(200); ++i) {
    Points<double> points = volume_families::points<double>(random, Family::cospherical, 60);
    const double by = std::ldexp(1.0, random.integer(-60, 60));
    points = volume_families::scaled(points, by);
    const auto found = smallest_sphere(span_of(points));
    INFO("case " << i);
    REQUIRE(is_right(found, points));
    REQUIRE(found.radius_squared == 8109 * by * by);
  }
}

TEMPLATE_TEST_CASE("one ulp decides whether a point is outside and changes the smallest sphere", "",
                   float, double) {
  using S = TestType;
  // The third point is on the sphere about 0 with radius 7, or an ulp nearer or farther.
  for (const int steps : {-1, 0, 1}) {
    S z = S(6);
    if (steps != 0) z = std::nextafter(z, S(6 + steps));
    const Points<S> points{{S(-7), S(0), S(0)}, {S(7), S(0), S(0)}, {S(2), S(3), z}};
    const auto found = smallest_sphere(span_of(points));
    INFO("steps " << steps);
    CHECK(found.support_count == (steps > 0 ? 3 : 2));
    CHECK(is_right(found, points));
  }
}

TEMPLATE_TEST_CASE("the smallest sphere does not depend on the order of the points", "", float,
                   double) {
  using S = TestType;
  Random random(4);
  for (int i = 0; i < generators::tried(2000); ++i) {
    Points<S> points = volume_families::drawn<S>(random, i, 30);
    const auto found = smallest_sphere(span_of(points));
    for (std::size_t k = points.size() - 1; k > 0; --k) {
      const int other = random.integer(0, static_cast<int>(k));
      std::swap(points[k], points[static_cast<std::size_t>(other)]);
    }
    const auto again = smallest_sphere(span_of(points));
    INFO("case " << i);
    REQUIRE(again.sphere.centre == found.sphere.centre);
    REQUIRE(again.sphere.radius == found.sphere.radius);
    REQUIRE(again.radius_squared == found.radius_squared);
  }
}

TEMPLATE_TEST_CASE("the smallest sphere is right at every scale", "", float, double) {
  using S = TestType;
  constexpr int most = std::numeric_limits<S>::max_exponent - 6;
  Random random(5);
  for (int i = 0; i < generators::tried(1500); ++i) {
    Points<S> points = volume_families::points<S>(
        random, i % 3 == 0 ? Family::grid : (i % 3 == 1 ? Family::in_box : Family::on_ball), 9);
    const int exponent = i % 4 == 0 ? most - 2 : random.integer(-most - 20, most - 2);
    points = volume_families::scaled<S>(points, std::ldexp(S(1), exponent));
    INFO("case " << i);
    REQUIRE(is_right(smallest_sphere(span_of(points)), points));
  }
}

TEST_CASE("at the scales 1e150 and 1e-150 the smallest sphere is right") {
  Random random(6);
  for (int i = 0; i < generators::tried(500); ++i) {
    const Points<double> points = volume_families::scaled(
        volume_families::points<double>(random, i % 2 == 0 ? Family::on_ball : Family::grid, 10),
        i % 4 < 2 ? 1e150 : 1e-150);
    INFO("case " << i);
    REQUIRE(is_right(smallest_sphere(span_of(points)), points));
  }
}

TEMPLATE_TEST_CASE("the smallest sphere of numbers of every magnitude is right", "", float,
                   double) {
  using S = TestType;
  Random random(7);
  for (int i = 0; i < generators::tried(400); ++i) {
    Points<S> points;
    const int count = random.integer(2, 6);
    for (int k = 0; k < count; ++k) {
      // Halves or tiny parts of any numbers, so that no radius overflows.
      const S by = i % 2 == 0 ? S(0.25) : std::numeric_limits<S>::min() * S(1024);
      const S x = generators::any_finite<S>(random), y = generators::any_finite<S>(random),
              z = generators::any_finite<S>(random);
      points.push_back({x * by, y * by, z * by});
    }
    INFO("case " << i);
    REQUIRE(is_right(smallest_sphere(span_of(points)), points));
  }
}

TEST_CASE("the smallest sphere of many points is right") {
  Random random(8);
  const int count = generators::tried(20000);
  for (const Family family : volume_families::all) {
    const Points<double> points = volume_families::points<double>(random, family, count / 8);
    INFO(volume_families::name(family));
    CHECK(is_right(smallest_sphere(span_of(points)), points));
  }
}

TEST_CASE("the smallest sphere of one position is that position") {
  const Vector3<double> position(0.1, -2.3, 1e200);
  for (const std::size_t count : {1U, 2U, 100U}) {
    const auto found = smallest_sphere(span_of(Points<double>(count, position)));
    CHECK(found.sphere.centre == position);
    CHECK(found.sphere.radius == 0);
    CHECK(found.radius_squared == 0);
    CHECK(found.support == std::array<int, 4>{0, -1, -1, -1});
    CHECK(found.support_count == 1);
  }
}

TEST_CASE("a smallest sphere of no points, or that overflows, is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1.7e308;
  const auto of = [](const Points<double>& points) { return smallest_sphere(span_of(points)); };
  CHECK_THROWS_AS(of({}), std::invalid_argument);
  CHECK_THROWS_AS(of({{0, 0, 0}, {0, 0, nan}}), std::invalid_argument);
  CHECK_THROWS_AS(of({{0, std::numeric_limits<double>::infinity(), 0}}), std::invalid_argument);
  CHECK_THROWS_AS(of({{-huge, -huge, 0}, {huge, huge, 0}}), std::invalid_argument);
  // The squares overflow, the radius does not.
  CHECK(of({{-huge, 0, 0}, {huge, 0, 0}}).sphere.radius == huge);
  CHECK(std::isinf(of({{-huge, 0, 0}, {huge, 0, 0}}).radius_squared));
}

// ---------------------------------------------------------------- Welzl's algorithm, rounded

TEST_CASE("Welzl's sphere of points in general position is nearly the smallest") {
  Random random(9);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Points<double> points = volume_families::points<double>(random, Family::in_box, 30);
    const double radius = smallest_sphere(span_of(points)).sphere.radius;
    INFO("case " << i);
    REQUIRE(std::abs(contact::welzl_sphere(span_of(points)).radius - radius) <= 1e-9 * radius);
  }
}

TEST_CASE("Welzl's sphere is wrong by far, or none, where points repeat or are symmetric") {
  Random random(10);
  std::map<Family, int> wrong;
  const int count = generators::tried(1000);
  for (const Family family : {Family::duplicates, Family::grid, Family::mesh_vertices}) {
    for (int i = 0; i < count; ++i) {
      const Points<float> points = volume_families::points<float>(random, family, 100);
      const float radius = smallest_sphere(span_of(points)).sphere.radius;
      const float got = contact::welzl_sphere(span_of(points)).radius;
      wrong[family] += !(std::abs(got - radius) <= 0.01F * radius);
    }
  }
  CHECK(wrong[Family::duplicates] > count / 20);
  CHECK(wrong[Family::grid] > count / 100);
  CHECK(wrong[Family::mesh_vertices] > 0);
}

TEST_CASE("Welzl's sphere misses some of its points, mostly by an ulp") {
  Random random(11);
  int missed = 0;
  const int count = generators::tried(1000);
  for (int i = 0; i < count; ++i) {
    const Points<double> points = volume_families::points<double>(random, Family::in_box, 30);
    const auto sphere = contact::welzl_sphere(span_of(points));
    missed += std::any_of(points.begin(), points.end(),
                          [&](const auto& p) { return !contact::contains(sphere, p); });
  }
  CHECK(missed > count / 2);
}

TEST_CASE("Welzl's sphere of no points is refused") {
  CHECK_THROWS_AS(contact::welzl_sphere(span_of(Points<double>{})), std::invalid_argument);
}

}  // namespace
}  // namespace smallest_sphere_test
