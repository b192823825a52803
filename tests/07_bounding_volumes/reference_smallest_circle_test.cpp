// The smallest circle against fractions, and the lecture's circle in the plane.
#include <07_bounding_volumes/sphere_truth.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/smallest_circle.hpp>
#include <limits>
#include <stdexcept>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace smallest_circle_test {
namespace {

using contact::smallest_circle;
using contact::SmallestCircle;
using contact::Vector2;
using generators::Random;
using oracle::Rational;
template <class S>
using Points = std::vector<Vector2<S>>;

template <class S>
std::span<const Vector2<S>> span_of(const Points<S>& points) {
  return points;
}
/// In turn anywhere, whole numbers, on a circle, on a line, and few positions stored many times.
template <class S>
Points<S> drawn(Random& random, int i) {
  Points<S> points;
  const int count = random.integer(1, 10);
  const double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1);
  for (int k = 0; k < count; ++k) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    Vector2<double> p(x, y);
    if (i % 5 == 1) p = (4 * p).array().round().matrix();
    if (i % 5 == 2) p = p / std::sqrt(x * x + y * y) + Vector2<double>(dx, dy);
    if (i % 5 == 3) p = Vector2<double>(dx, dy) * x;
    points.push_back(p.cast<S>());
    if (i % 5 == 4 && k > 2) points.back() = points[static_cast<std::size_t>(k % 3)];
  }
  return points;
}
std::vector<oracle::Vector> exact(const auto& points) {
  std::vector<oracle::Vector> all;
  for (const auto& p : points) all.emplace_back(oracle::exact(p.x()), oracle::exact(p.y()), 0);
  return all;
}
/// Whether a result is the smallest circle, rounded as it promises.
template <class S>
bool is_right(const SmallestCircle<S>& found, const Points<S>& points) {
  const auto count = static_cast<std::size_t>(found.support_count);
  if (count < 1 || count > 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i >= count && found.support[i] != -1) return false;
    if (i > 0 && i < count && found.support[i] <= found.support[i - 1]) return false;
  }
  const auto all = exact(points);
  const auto ball = sphere_truth::certified(all, std::span<const int>(found.support.data(), count));
  if (!ball) return false;
  for (int k = 0; k < 2; ++k) {
    if (found.circle.centre(k) != sphere_truth::nearest<S>(ball->centre(k))) return false;
  }
  const oracle::Vector centre = exact(Points<S>{found.circle.centre})[0];
  return found.radius_squared == oracle::nearest(ball->radius_squared) &&
         sphere_truth::is_root_rounded_up(found.circle.radius,
                                          sphere_truth::largest_distance_squared(all, centre));
}

TEMPLATE_TEST_CASE("the smallest circle meets the conditions of the smallest one", "", float,
                   double) {
  using S = TestType;
  Random random(1);
  std::array<int, 4> supports{};
  for (int i = 0; i < generators::tried(5000); ++i) {
    const Points<S> points = drawn<S>(random, i);
    const auto found = smallest_circle(span_of(points));
    INFO("case " << i);
    REQUIRE(is_right(found, points));
    ++supports[static_cast<std::size_t>(found.support_count)];
  }
  for (const std::size_t count : {1U, 2U, 3U}) CHECK(supports[count] > generators::tried(200));
}

TEST_CASE("the smallest circle of few points is the smallest of those through some of them") {
  Random random(2);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Points<double> points = drawn<double>(random, i);
    INFO("case " << i);
    REQUIRE(smallest_circle(span_of(points)).radius_squared ==
            oracle::nearest(sphere_truth::smallest(exact(points)).radius_squared));
  }
}

TEMPLATE_TEST_CASE("one ulp decides whether three points need a circle through all", "", float,
                   double) {
  using S = TestType;
  for (const int steps : {-1, 0, 1}) {
    S y = S(4);
    if (steps != 0) y = std::nextafter(y, S(4 + steps));
    const Points<S> points{{S(-5), S(0)}, {S(5), S(0)}, {S(3), y}};
    const auto found = smallest_circle(span_of(points));
    INFO("steps " << steps);
    CHECK(found.support_count == (steps > 0 ? 3 : 2));
    CHECK(is_right(found, points));
  }
}

TEMPLATE_TEST_CASE("the lecture's circle contains every point and no smaller radius does", "",
                   float, double) {
  using S = TestType;
  Random random(3);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const Points<S> points = drawn<S>(random, i);
    const auto circle = contact::grown_circle(span_of(points));
    const oracle::Vector centre = exact(Points<S>{circle.centre})[0];
    INFO("case " << i);
    REQUIRE(sphere_truth::is_root_rounded_up(
        circle.radius, sphere_truth::largest_distance_squared(exact(points), centre)));
  }
}

TEST_CASE("a circle of no points, or of points that are not finite, is refused") {
  const Points<double> none, bad{{0, std::numeric_limits<double>::quiet_NaN()}};
  for (const auto& points : {none, bad}) {
    CHECK_THROWS_AS(smallest_circle(span_of(points)), std::invalid_argument);
    CHECK_THROWS_AS(contact::grown_circle(span_of(points)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace smallest_circle_test
