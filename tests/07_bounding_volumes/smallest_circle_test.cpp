// Whether a point is in a circle is decided in integers, in units of 1/8 m, by the power of the
// point. The right circle is the smallest one of all those across two points or through three that
// contain all, with radii compared without rounding. Every test asks for several answers. The first
// questions each bring one mistake to light that no question before did, so that the mistake is
// known by it.
#include "smallest_circle.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <07_bounding_volumes/circles_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using namespace circles_with_mistakes;
using exercise::Circle;

constexpr double kTolerance = 1e-9;

Circle in_exercise(const Round& round) { return {round.centre, round.radius}; }

// ---------------------------------------------------------------- a circle through three points

void check_in_circle(const Point& a, const Point& b, const Point& c, const Point& p) {
  const int side = side_of_circle(a, b, c, p);
  const bool right = side >= 0;
  ask("Is the point in the circle through the three others?")
      .given("a", a)
      .given("b", b)
      .given("c", c)
      .given("p", p)
      .suspect("circle-sign-by-order",
               [&] { return side * (whole_cross(a, b, c) > 0 ? 1 : -1) >= 0; })
      .suspect("circle-sign-by-order",
               [&] { return side * (whole_cross(a, b, c) > 0 ? -1 : 1) >= 0; })
      .suspect("touching-rejected", [&] { return side > 0; })
      .suspect("rounded-distances-compared",
               [&] { return in_rounded_circle<double>(a, b, c, p, 0); })
      .suspect("circle-in-float", [&] { return in_rounded_circle<float>(a, b, c, p, 0); })
      .suspect("absolute-epsilon", [&] { return in_rounded_circle<double>(a, b, c, p, 1e-6); })
      .answer([&] { return exercise::in_circle_through(a, b, c, p); })
      .equals(right);
}

void check_in_every_order(const Point& a, const Point& b, const Point& c, const Point& p) {
  for (const auto& [x, y, z] : {std::tuple{a, b, c}, std::tuple{b, c, a}, std::tuple{c, a, b}}) {
    check_in_circle(x, y, z, p);
    check_in_circle(z, y, x, p);
  }
}

// ---------------------------------------------------------------- the smallest circle

bool is_finite(const Circle& circle) {
  return circle.centre.allFinite() && std::isfinite(circle.radius);
}
bool is_close(const Circle& a, const Circle& b) {
  return (a.centre - b.centre).cwiseAbs().maxCoeff() <= kTolerance &&
         std::abs(a.radius - b.radius) <= kTolerance;
}

void check_circle(const Points& points) {
  const Circle right = in_exercise(smallest(points));
  ask("Which is the smallest circle around the points?")
      .given("points", points)
      .suspect("circles-through-three-alone",
               [&] { return in_exercise(smallest_through_three(points)); })
      .suspect("first-enclosing-circle", [&] { return in_exercise(first_through_three(points)); })
      .suspect("farthest-pair-alone", [&] { return in_exercise(across_farthest_pair(points)); })
      .suspect("farthest-pair-kept", [&] { return in_exercise(through_farthest_pair(points)); })
      .suspect("mean-for-centre", [&] { return in_exercise(around(mean(points), points)); })
      .suspect("box-centre-for-centre",
               [&] { return in_exercise(around(box_centre(points), points)); })
      .suspect("grown-for-smallest", [&] { return in_exercise(grown(points)); })
      .suspect("rounded-distances-compared",
               [&] { return in_exercise(by_rounded_distances(points)); })
      .suspect("no-restart", [&] { return in_exercise(without_restart(points)); })
      .suspect("square-of-the-radius",
               [&] {
                 return Circle{right.centre, right.radius * right.radius};
               })
      .suspect("diameter-for-radius",
               [&] {
                 return Circle{right.centre, 2 * right.radius};
               })
      .suspect_if("one-point-without-circle",
                  [&](const Circle& got) {
                    return right.radius == 0 && got.radius == 0 && got.centre.isZero(0);
                  })
      .suspect_if("margin-too-large",
                  [&](const Circle& got) {
                    const double more = got.radius - right.radius;
                    return is_close({got.centre, 0}, {right.centre, 0}) && more > kTolerance &&
                           more <= std::max(right.radius / 10, 0.01);
                  })
      .suspect_if("division-by-zero", [](const Circle& got) { return !is_finite(got); })
      .answer([&] { return exercise::smallest_circle(points); })
      .close_to(right, within(kTolerance));
}

void check_contains(const Points& points) {
  const Circle right = in_exercise(smallest(points));
  ask("Which smallest circle contains each of the points, without rounding?")
      .given("points", points)
      .suspect_if("points-missed-by-rounding",
                  [&](const Circle& got) { return is_close(got, right); })
      .answer([&] { return exercise::smallest_circle(points); })
      .satisfies(
          "contains each point: |p - c| <= r for the numbers as you return them, where they may be "
          "1e-9 from those of the smallest circle",
          [&](const Circle& got) {
            return contained::in_ball(got.centre, got.radius, points) && is_close(got, right);
          });
}

/// In order, reversed, and beginning at each point.
void check_orders(Points points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    check_circle(points);
    check_circle(Points(points.rbegin(), points.rend()));
    std::rotate(points.begin(), points.begin() + 1, points.end());
  }
}

}  // namespace

TEST_CASE("a point is in the circle through three points, or outside") {
  check_in_circle({0, 0}, {4, 0}, {0, 4}, {1, 1});
  check_in_circle({0, 0}, {4, 0}, {0, 4}, {3, 3});
  check_in_circle({0, 0}, {4, 0}, {0, 4}, {5, 3});
  check_in_circle({-3, 1}, {5, 2}, {1, 7}, {1, -2});
  check_in_circle({-3, 1}, {5, 2}, {1, 7}, {1, -3});
  check_in_circle({16, 0}, {8, 1}, {0, 0}, {8, -30});
  check_in_circle({16, 0}, {8, 1}, {0, 0}, {8, 2});
}

TEST_CASE("the order of the three points does not matter") {
  check_in_every_order({0, 0}, {4, 0}, {0, 4}, {1, 1});
  check_in_every_order({0, 0}, {4, 0}, {0, 4}, {3, 3});
  check_in_every_order({0, 0}, {4, 0}, {0, 4}, {5, 3});
  check_in_every_order({-3.5, 1}, {5, 2.25}, {1, 7}, {1, -2});
}

TEST_CASE("a point on the circle counts, and one next to it is decided") {
  check_in_circle({0, 0}, {4, 0}, {0, 4}, {4, 4});
  // 4 nm outside, 1 um inside, and on the circle.
  check_in_circle({-46.875, 58.375}, {33, 29.625}, {-21.75, -38.25}, {14.5, 56.375});
  check_in_circle({-4, -8.5}, {71.875, -6.5}, {-78, 92.75}, {-68.75, 50.875});
  check_in_circle({-0.75, -4.25}, {3.375, 1.25}, {2.625, 3.5}, {-6.875, 1.125});
  check_in_every_order({0, 0}, {4, 0}, {0, 4}, {4, 4});
  check_in_every_order({0, 0}, {4, 0}, {0, 4}, {4, 0});
  check_in_every_order({7, 1}, {5, 5}, {1, 7}, {-5, 5});
  for (const Point& p :
       {Point(100, 99.875), Point(-100, -100), Point(0, -0.125), Point(0.125, 0)}) {
    check_in_every_order({-100, -100}, {100, 99.875}, {99.875, 99.75}, p);
    check_in_every_order({-100, -100}, {100, 99.875}, {-99, -98.875}, p);
  }
}

TEST_CASE("two or three points determine the smallest circle") {
  check_circle({{0, 0}, {8, 0}, {4, 1}, {4, 3.5}});
  check_circle({{0, 12}, {9, 0}, {25, 12}, {9, 25}});
  check_circle({{0, 0}, {6, 0}, {3, 5}});
  check_circle({{0, 0}, {6, 0}, {2, 5}, {3, 1}, {3, 2}});
  check_circle({{-3, -1}, {0, 3}, {2, -1.625}, {0, -2.375}});
  // As they are rounded, the distances of the three points from the centre are not equal.
  check_circle({{-4, -8}, {1, 5}, {3, 3}, {11, -4}});
  check_circle({{12, 9}, {-1, -4}, {-6, -5}, {-3, 12}});
  check_orders({{0, 0}, {8, 0}, {4, 1}, {4, 3.5}});
  check_orders({{0, 12}, {9, 0}, {25, 12}, {9, 25}});
  check_orders({{0, 0}, {6, 0}, {3, 5}, {1, -1}});
  check_orders({{-5, 2}, {7, 1}, {0, -8.5}, {3, 3}, {1, 6}, {-2, -2}});
  check_orders({{0, 0}, {0.5, 0}, {0.25, 0.5}});
  check_circle({{100, 100}, {-100, -100}, {100, -100}, {-100, 99.875}});
}

TEST_CASE("one point, equal points and points on a line have a circle") {
  check_circle({{3, 4}});
  check_circle({{3, 4}, {3, 4}, {3, 4}});
  check_circle({{3, 4}, {-2, 1}});
  check_orders({{0, 0}, {1, 2}, {3, 6}, {2, 4}});
  check_orders({{1, 5}, {1, -3}, {1, 0.5}});
  check_orders({{0, 0}, {6, 0}, {3, 5}, {3, 5}, {0, 0}});
  check_circle({{0, 0}, {0, 0}});
  for (const Points& points : std::vector<Points>{{{3, 4}}, {{3, 4}, {3, 4}}, {{0, 0}, {1, 3}}})
    check_contains(points);
}

TEST_CASE("points on one circle have it as theirs") {
  check_circle({{5, 0}, {-3, 4}, {0, -5}, {-4, -3}});
  check_orders({{7, 1}, {5, 5}, {1, 7}, {-5, 5}});
  check_orders({{5, 0}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {0, -5}});
  check_orders({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  check_orders({{16, 63}, {33, 56}, {52, 39}, {-60, 25}, {-25, -60}, {63, -16}});
}

TEST_CASE("the circle contains every point without rounding") {
  check_contains({{0, 0}, {6, 0}, {2, 5}});
  check_contains({{0, 12}, {9, 0}, {25, 12}, {9, 25}});
  check_contains({{-3, -1}, {0, 3}, {2, -1.625}, {0, -2.375}});
  check_contains({{5, 0}, {-3, 4}, {0, -5}, {-4, -3}});
  check_contains({{99, 100}, {-98, -100}, {100, -97}, {-100, 99.875}});
  check_contains({{1, 1}, {2, 3}});
}

TEST_CASE("random points agree with integers") {
  generators::Random random(seed(0));
  const auto judged = [](const Points& points) {
    return !points.empty() && contained::is_on_grid(points, kParts, kLimit);
  };
  const auto judged_circle = [](const Point& a, const Point& b, const Point& c, const Point& p) {
    return contained::is_on_grid(Points{a, b, c, p}, kParts, kLimit) && whole_cross(a, b, c) != 0;
  };
  for (int asked = 0; asked < 300; ++asked) {
    const int size = std::array{2, 7, 800}[static_cast<std::size_t>(asked % 3)];
    const auto point = [&]() -> Point {
      const double x = random.integer(-size, size);
      return Point(x, random.integer(-size, size)) / kParts;
    };
    const int kind = random.integer(0, 4);
    const int count = asked % 60 == 59 ? 40 : random.integer(1, 9);
    Points points;
    while (static_cast<int>(points.size()) < count) {
      if (kind == 0)
        points.push_back(random.integer(-size / 2, size / 2) * Point(2, 1) / kParts);
      else if (kind == 1 && !points.empty() && random.chance(0.5))
        points.push_back(points.front());
      else
        points.push_back(point());
    }
    shrinkable(check_circle, judged, points);
    shrinkable(check_contains, judged, points);
    const Point a = point(), b = point(), c = point(), p = random.chance(0.1) ? a : point();
    if (judged_circle(a, b, c, p)) shrinkable(check_in_circle, judged_circle, a, b, c, p);
  }
}
