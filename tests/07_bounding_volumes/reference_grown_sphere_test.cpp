// Spheres from one or two passes: which pair they begin with, that those that promise it contain
// every point, and that the lecture's does not.
#include <07_bounding_volumes/sphere_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/grown_sphere.hpp>
#include <limits>
#include <stdexcept>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace grown_sphere_test {
namespace {

using contact::Sphere;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using volume_families::Family;
template <class S>
using Points = std::vector<Vector3<S>>;

using volume_families::span_of;
/// Whether a sphere contains all points, in fractions.
template <class S>
bool encloses(const Sphere<S>& sphere, const Points<S>& points) {
  const Rational r = oracle::exact(sphere.radius);
  return sphere_truth::largest_distance_squared(sphere_truth::exact(points),
                                                oracle::exact(sphere.centre)) <= r * r;
}
/// Whether, in addition, no smaller number would do as its radius.
template <class S>
bool encloses_closely(const Sphere<S>& sphere, const Points<S>& points) {
  return sphere_truth::is_root_rounded_up(
      sphere.radius, sphere_truth::largest_distance_squared(sphere_truth::exact(points),
                                                            oracle::exact(sphere.centre)));
}

TEMPLATE_TEST_CASE("the lecture's pair is extreme along its axis and no other one is farther apart",
                   "", float, double) {
  using S = TestType;
  Random random(1);
  for (int i = 0; i < generators::tried(5000); ++i) {
    const Points<S> points = volume_families::drawn<S>(random, i);
    const auto pair = contact::most_distant_extremes(span_of(points));
    const auto at = [&points](std::size_t k) { return oracle::exact(points[k]); };
    const auto low = static_cast<std::size_t>(pair.low), high = static_cast<std::size_t>(pair.high);
    const Rational found = sphere_truth::distance_squared(at(low), at(high));
    INFO("case " << i);
    for (const auto& p : points) {
      REQUIRE(points[low](pair.axis) <= p(pair.axis));
      REQUIRE(p(pair.axis) <= points[high](pair.axis));
    }
    for (int k = 0; k < 3; ++k) {
      const auto less = [k](const auto& p, const auto& q) { return p(k) < q(k); };
      const auto first_low = std::min_element(points.begin(), points.end(), less);
      const auto first_high = std::max_element(points.begin(), points.end(), less);
      REQUIRE(found >= sphere_truth::distance_squared(oracle::exact(*first_low),
                                                      oracle::exact(*first_high)));
    }
  }
}

TEST_CASE("a pair that is farther apart by one ulp is found") {
  // 1 + 2^-52 along y against 1 along x and z; and squares that overflow or underflow.
  const double more = std::nextafter(1.0, 2.0);
  for (const double scale : {1.0, 0x1p1000, 0x1p-1000}) {
    const Points<double> points{
        {0, 0, 0}, {scale, 0, 0}, {0, more * scale, 0}, {0, 0, scale}, {0, scale, 0}};
    const auto pair = contact::most_distant_extremes(span_of(points));
    INFO("scale " << scale);
    CHECK(pair.axis == 1);
    CHECK(pair.low == 0);
    CHECK(pair.high == 2);
  }
}

TEMPLATE_TEST_CASE("spheres with an enclosing radius contain every point, closely", "", float,
                   double) {
  using S = TestType;
  Random random(2);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const Points<S> points = volume_families::drawn<S>(random, i);
    INFO("case " << i);
    REQUIRE(encloses_closely(contact::grown_sphere(span_of(points)), points));
    REQUIRE(encloses_closely(contact::centroid_sphere(span_of(points)), points));
    REQUIRE(encloses_closely(contact::box_centre_sphere(span_of(points)), points));
  }
}

TEMPLATE_TEST_CASE("spheres with an enclosing radius contain every point at every scale", "", float,
                   double) {
  using S = TestType;
  constexpr int most = std::numeric_limits<S>::max_exponent - 6;
  Random random(3);
  for (int i = 0; i < generators::tried(1000); ++i) {
    Points<S> points = volume_families::points<S>(random, Family::in_box, 8);
    const int exponent = i % 2 == 0 ? most : random.integer(-most - 20, most);
    points = volume_families::scaled<S>(points, std::ldexp(S(1), exponent));
    INFO("case " << i);
    REQUIRE(encloses(contact::grown_sphere(span_of(points)), points));
    REQUIRE(encloses(contact::centroid_sphere(span_of(points)), points));
    REQUIRE(encloses(contact::box_centre_sphere(span_of(points)), points));
  }
}

TEST_CASE("the lecture's sphere as it is given misses its own points, of float more often") {
  Random random(4);
  int missed_in_float = 0, missed_in_double = 0;
  const int count = generators::tried(2000);
  for (int i = 0; i < count; ++i) {
    const auto points = volume_families::points<double>(random, Family::on_ball, 40);
    Points<float> in_float;
    for (const auto& p : points) in_float.push_back(generators::rounded<float>(p));
    missed_in_float += !encloses(contact::sphere_grown_as_given(span_of(in_float)), in_float);
    missed_in_double += !encloses(contact::sphere_grown_as_given(span_of(points)), points);
  }
  CHECK(missed_in_float > count / 4);
  CHECK(missed_in_double > count / 4);
}

TEST_CASE("the lecture's sphere is about its centre, and depends on the order of the points") {
  Random random(5);
  int different = 0;
  const int count = generators::tried(1000);
  for (int i = 0; i < count; ++i) {
    Points<double> points = volume_families::points<double>(random, Family::in_box, 20);
    const auto given = contact::sphere_grown_as_given(span_of(points));
    const auto sure = contact::grown_sphere(span_of(points));
    INFO("case " << i);
    REQUIRE((given.centre - sure.centre).norm() <= 1e-14);
    REQUIRE(std::abs(given.radius - sure.radius) <= 1e-14);
    std::reverse(points.begin(), points.end());
    const auto reversed = contact::grown_sphere(span_of(points));
    different += std::abs(reversed.radius - sure.radius) > 1e-6;
  }
  CHECK(different > count / 4);
}

TEST_CASE("a power of two scales the grown sphere and changes nothing else") {
  Random random(6);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Points<double> points = volume_families::drawn<double>(random, i);
    const auto sphere = contact::grown_sphere(span_of(points));
    for (const double by : {0x1p900, 0x1p-900}) {
      const auto scaled = contact::grown_sphere(span_of(volume_families::scaled(points, by)));
      INFO("case " << i);
      REQUIRE(scaled.radius == sphere.radius * by);
      REQUIRE(scaled.centre == sphere.centre * by);
    }
  }
}

TEST_CASE("the centroid's sphere has at most twice the smallest radius and the box's 1.74 times") {
  Random random(7);
  for (int i = 0; i < generators::tried(500); ++i) {
    const Points<double> points = volume_families::drawn<double>(random, i, 7);
    const auto smallest = sphere_truth::smallest(sphere_truth::exact(points)).radius_squared;
    const auto ratio_squared = [&smallest](const Sphere<double>& sphere) {
      const Rational r = oracle::exact(sphere.radius);
      return smallest == 0 ? Rational(0) : Rational(r * r / smallest);
    };
    // Far from the origin, the centre is rounded to a millionth of the size.
    const Rational room(10001, 10000);
    INFO("case " << i);
    REQUIRE(ratio_squared(contact::centroid_sphere(span_of(points))) <= 4 * room);
    REQUIRE(ratio_squared(contact::box_centre_sphere(span_of(points))) <= 3 * room);
  }
  // Almost all points at one end: almost twice.
  Points<double> points(99, Vector3<double>(0, 0, 0));
  points.emplace_back(1, 0, 0);
  CHECK(contact::centroid_sphere(span_of(points)).radius > 0.98);
}

TEMPLATE_TEST_CASE("the sphere of one position is that position", "", float, double) {
  using S = TestType;
  const Vector3<S> position(S(0.1), S(-2.3), S(1e20));
  for (const std::size_t count : {1U, 4U}) {
    const Points<S> points(count, position);
    for (const auto& sphere :
         {contact::grown_sphere(span_of(points)), contact::centroid_sphere(span_of(points)),
          contact::box_centre_sphere(span_of(points))}) {
      CHECK(sphere.centre == position);
      CHECK(sphere.radius == 0);
    }
  }
}

TEST_CASE("a sphere of no points, or of points that are not finite, is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const Points<double> none, bad{{0, 0, 0}, {1, nan, 0}}, endless{{infinity, 0, 0}};
  for (const auto& points : {none, bad, endless}) {
    CHECK_THROWS_AS(contact::most_distant_extremes(span_of(points)), std::invalid_argument);
    CHECK_THROWS_AS(contact::sphere_grown_as_given(span_of(points)), std::invalid_argument);
    CHECK_THROWS_AS(contact::grown_sphere(span_of(points)), std::invalid_argument);
    CHECK_THROWS_AS(contact::centroid_sphere(span_of(points)), std::invalid_argument);
    CHECK_THROWS_AS(contact::box_centre_sphere(span_of(points)), std::invalid_argument);
  }
  const double huge = 1.7e308;
  const Points<double> ends{{-huge, -huge, 0}, {huge, huge, 0}};
  CHECK_THROWS_AS(contact::grown_sphere(span_of(ends)), std::invalid_argument);
}

}  // namespace
}  // namespace grown_sphere_test
