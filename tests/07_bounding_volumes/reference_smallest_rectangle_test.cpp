// The smallest rectangle around points in the plane, against all edges of the hull in fractions.
#include <07_bounding_volumes/box_truth.hpp>
#include <contact/smallest_rectangle.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>
#include <support/rounding.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace smallest_rectangle_tests {

using box_truth::FlatPoints;
using contact::Rectangle;
using contact::rectangle_with_axis;
using contact::smallest_rectangle;
using contact::Vector2;
using generators::Random;
using oracle::Rational;
using support::refusal;

template <std::floating_point S>
std::span<const Vector2<S>> span_of(const FlatPoints<S>& points) {
  return points;
}
/// By turns: anywhere, on a small grid, on a circle, on a line or an ulp off it, nearly a
/// rectangle, far from the origin.
template <std::floating_point S>
FlatPoints<S> drawn(Random& random, int kind, int count) {
  FlatPoints<S> points;
  const double angle = random.uniform(0, 1), size = random.uniform(0.5, 2);
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    Vector2<double> p(x, y);
    if (kind == 1) p = {double(random.integer(-3, 3)), double(random.integer(-3, 3))};
    if (kind == 2) p /= std::sqrt(p.dot(p));
    if (kind == 3) p = {size * x, angle * x};
    if (kind == 4) {
      const double along = random.chance(0.5) ? size : -size, up = random.chance(0.5) ? 1 : -1;
      p = {along - angle * up, up + angle * along};
    }
    if (kind == 5) p += Vector2<double>(1e6, -3e6);
    points.push_back({static_cast<S>(p.x()), static_cast<S>(p.y())});
    if (kind == 6 && i % 2 == 1) points.back() = points.front();
  }
  return points;
}

TEMPLATE_TEST_CASE("the smallest rectangle contains all points, as it is stored", "", float,
                   double) {
  using S = TestType;
  Random random(1);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const int count = random.integer(1, 12);
    const FlatPoints<S> points = drawn<S>(random, i % 7, count);
    INFO("case " << i);
    REQUIRE(box_truth::all_inside(smallest_rectangle<S>(span_of<S>(points)), points));
  }
}

TEMPLATE_TEST_CASE("the area of the smallest rectangle is that of the best edge, up to rounding",
                   "", float, double) {
  using S = TestType;
  Random random(2);
  for (int i = 0; i < generators::tried(350); ++i) {
    const int count = random.integer(2, 7);
    const FlatPoints<S> points = drawn<S>(random, i % 7, count);
    const Rectangle<S> found = smallest_rectangle<S>(span_of<S>(points));
    const Rational least = box_truth::smallest_area(points), area = box_truth::area(found);
    const Rational length =
        2 * std::max(oracle::exact(found.half_lengths[0]), oracle::exact(found.half_lengths[1]));
    // The centre is rounded, too, which the half lengths must make up for.
    const Rational centre = oracle::exact(found.centre.cwiseAbs().maxCoeff());
    INFO("case " << i);
    REQUIRE(area >= least);
    REQUIRE(area <= least + 400 * rounding::u<S>() * length * (length + centre));
  }
}

TEST_CASE("the edge of the smallest rectangle is decided exactly") {
  // Nearly rectangular: the rectangles of the four edges differ by some ulps.
  Random random(3);
  int close = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const FlatPoints<double> points = drawn<double>(random, 4, 5);
    const auto found = smallest_rectangle<double>(span_of<double>(points));
    const auto flush = box_truth::flush_rectangles(points);
    const Rational least = box_truth::smallest_area(points);
    if (flush.empty() || least == 0) continue;
    bool is_best = false;
    for (const auto& candidate : flush) {
      close += candidate.area != least && candidate.area < least * (1 + Rational(1, 1LL << 46));
      if (candidate.area != least) continue;
      // Parallel to it, to rounding: the other edges differ by less, so their length decides.
      const box_truth::ExactFlat u = box_truth::exact(found.axis);
      const Rational sine = abs(box_truth::cross(u, candidate.along));
      const Rational room = 4 * rounding::u<double>() * oracle::exact(2.0);
      is_best =
          is_best || sine * sine <= room * room * box_truth::dot(candidate.along, candidate.along);
    }
    INFO("case " << i);
    REQUIRE(is_best);
  }
  CHECK(close > generators::tried(100));
}

TEST_CASE("of equal rectangles the first edge from the leftmost vertex counts") {
  const FlatPoints<double> square{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  CHECK(smallest_rectangle<double>(span_of<double>(square)).axis == Vector2<double>(1, 0));
  const FlatPoints<double> diamond{{0, 2}, {2, 0}, {0, -2}, {-2, 0}};
  const auto found = smallest_rectangle<double>(span_of<double>(diamond));
  CHECK(found.axis.x() > 0);
  CHECK(found.axis.y() == -found.axis.x());
}

TEST_CASE("the order of the points does not change the smallest rectangle") {
  Random random(4);
  for (int i = 0; i < generators::tried(1000); ++i) {
    FlatPoints<double> points = drawn<double>(random, i % 7, 9);
    const auto first = smallest_rectangle<double>(span_of<double>(points));
    std::rotate(points.begin(), points.begin() + random.integer(0, 8), points.end());
    std::swap(points[0], points[static_cast<std::size_t>(random.integer(0, 8))]);
    const auto second = smallest_rectangle<double>(span_of<double>(points));
    REQUIRE(first.centre == second.centre);
    REQUIRE(first.axis == second.axis);
    REQUIRE(first.half_lengths == second.half_lengths);
  }
}

TEST_CASE("the smallest rectangle scales with powers of two from 2^-500 to 2^500") {
  Random random(5);
  for (int i = 0; i < generators::tried(700); ++i) {
    const FlatPoints<double> points = drawn<double>(random, i % 7, 8);
    const auto found = smallest_rectangle<double>(span_of<double>(points));
    for (const double scale : {0x1p-500, 0x1p500}) {
      FlatPoints<double> scaled = points;
      for (auto& p : scaled) p *= scale;
      const auto other = smallest_rectangle<double>(span_of<double>(scaled));
      REQUIRE(other.axis == found.axis);
      REQUIRE(other.centre == scale * found.centre);
      REQUIRE((other.half_lengths / scale - found.half_lengths).cwiseAbs().maxCoeff() <= 0x1p-520);
    }
  }
}

TEST_CASE("at the smallest and the largest scales the smallest rectangle contains its points") {
  Random random(6);
  for (const int exponent : {-1074, -1070, -1022, 1000, 1020}) {
    for (int i = 0; i < generators::tried(40); ++i) {
      FlatPoints<double> points = drawn<double>(random, 1, 6);
      for (auto& p : points) p *= std::ldexp(1.0, exponent);
      INFO("2^" << exponent);
      REQUIRE(box_truth::all_inside(smallest_rectangle<double>(span_of<double>(points)), points));
    }
  }
}

TEST_CASE("the smallest rectangle of equal points has no extent, and of a segment no width") {
  const FlatPoints<double> equal(4, Vector2<double>(0.1, -7e300));
  const auto point = smallest_rectangle<double>(span_of<double>(equal));
  CHECK(point.half_lengths == Vector2<double>::Zero());
  CHECK(point.centre == equal[0]);
  const FlatPoints<double> upright{{2, -1}, {2, 5}, {2, 3}, {2, 5}};
  const auto segment = smallest_rectangle<double>(span_of<double>(upright));
  CHECK(segment.axis == Vector2<double>(0, 1));
  CHECK(segment.half_lengths == Vector2<double>(3, 0));
  const FlatPoints<double> oblique{{0, 0}, {1, 3}, {3, 9}, {2, 6}};
  const auto third = smallest_rectangle<double>(span_of<double>(oblique));
  CHECK(std::abs(third.half_lengths[0] - std::sqrt(22.5)) < 1e-13);
  CHECK(third.half_lengths[1] < 1e-13);
}

TEST_CASE("a point is in a rectangle as fractions say, on its border too") {
  Random random(7);
  int on_border = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    Rectangle<double> r{{double(random.integer(-2, 2)), double(random.integer(-2, 2))},
                        {double(random.integer(-3, 3)), double(random.integer(1, 3))},
                        {double(random.integer(0, 2)), double(random.integer(0, 2))}};
    if (i % 3 == 0) r.axis /= std::sqrt(r.axis.dot(r.axis));
    const Vector2<double> p{double(random.integer(-9, 9)), double(random.integer(-9, 9))};
    REQUIRE(contact::contains(r, p) == box_truth::inside(r, p));
    const Vector2<double> corner = r.centre + r.half_lengths.x() * r.axis +
                                   r.half_lengths.y() * Vector2<double>(-r.axis.y(), r.axis.x());
    REQUIRE(contact::contains(r, corner) == box_truth::inside(r, corner));
    on_border += contact::contains(r, corner) ? 1 : 0;
  }
  CHECK(on_border > generators::tried(1500));
  const Rectangle<double> unit{{0, 0}, {1, 0}, {1, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(contact::contains(unit, Vector2<double>(nan, 0)));
  CHECK_FALSE(contact::contains(Rectangle<double>{{0, 0}, {1, 0}, {1, -1}}, Vector2<double>(0, 0)));
}

TEST_CASE("rectangles name the argument that they do not take") {
  using support::contains;
  const FlatPoints<double> points{{1, 2}, {3, 4}};
  CHECK(contains(refusal([] { smallest_rectangle<double>({}); }), "points = {}"));
  CHECK(contains(refusal([] { rectangle_with_axis<double>({1, 0}, {}); }), "points = {}"));
  CHECK(contains(refusal([&] {
                   rectangle_with_axis<double>({1, 1e-7}, span_of<double>(points));
                 }),
                 "axis = (1, "));
  const double most = std::numeric_limits<double>::max();
  const FlatPoints<double> endless{{0, most}, {1, std::numeric_limits<double>::infinity()}};
  CHECK(contains(refusal([&] { smallest_rectangle<double>(span_of<double>(endless)); }), "inf"));
  const FlatPoints<double> far{{-most, -most}, {most, most}, {0, -most}};
  CHECK(contains(refusal([&] { smallest_rectangle<double>(span_of<double>(far)); }), "overflow"));
}

}  // namespace smallest_rectangle_tests
