// Right answers are computed in whole numbers, of polygons by rays that pass through no vertex.
// Every test asks for both answers.
#include "crossings.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <03_polygons/whole.hpp>

namespace {

using namespace contact::testing;
using whole::area;
using whole::Point;
using whole::Points;

/// Whether the line through the point crosses the edge.
bool line_crosses(const Point& p, const Point& a, const Point& b) {
  return std::min(a.y(), b.y()) <= p.y() && p.y() < std::max(a.y(), b.y());
}

/// Whether the edge meets the line to the right of the point; no edge here meets it in the point.
bool to_the_right(const Point& p, const Point& a, const Point& b) {
  return a.y() < b.y() ? area(a, b, p) > 0 : area(b, a, p) > 0;
}

bool crosses(const Point& p, const Point& a, const Point& b) {
  return line_crosses(p, a, b) && to_the_right(p, a, b);
}

int count(const Points& polygon, const Point& p, std::size_t edges) {
  int crossed = 0;
  for (std::size_t i = 0; i < edges; ++i)
    crossed += crosses(p, polygon[i], whole::after(polygon, i));
  return crossed;
}

void check_edge(const Point& p, const Point& from, const Point& to) {
  const bool right = crosses(p, from, to);
  ask("Does the ray to the right cross the edge?")
      .given("point", p)
      .given("from", from)
      .given("to", to)
      .suspect("line-for-ray", [&] { return line_crosses(p, from, to); })
      .suspect("ray-to-the-left", [&] { return line_crosses(p, from, to) && !right; })
      .suspect("edge-direction-ignored",
               [&] { return line_crosses(p, from, to) && area(from, to, p) > 0; })
      .suspect_if("upper-end-counted",
                  [&](const bool& got) {
                    return got && !right && std::max(from.y(), to.y()) == p.y() &&
                           from.y() != to.y() && to_the_right(p, from, to);
                  })
      .suspect_if(
          "lower-end-not-counted",
          [&](const bool& got) { return !got && right && std::min(from.y(), to.y()) == p.y(); })
      .suspect("epsilon-orientation",
               [&] {
                 if (!line_crosses(p, from, to)) return false;
                 const double left = static_cast<double>(area(from, to, p));
                 return (left > 1e-9 * (to - from).norm() * (p - from).norm()) == (to.y() > p.y());
               })
      .answer([&] { return exercise::crosses(p, from, to); })
      .equals(right);
}

void check(const Points& polygon, const Point& p) {
  const std::size_t n = polygon.size();
  ask("Is the point inside by the even-odd rule?")
      .given("polygon", polygon)
      .given("point", p)
      .suspect("any-crossing-is-inside", [&] { return count(polygon, p, n) > 0; })
      .suspect("last-edge-forgotten", [&] { return count(polygon, p, n - 1) % 2 == 1; })
      .suspect("non-zero-for-even-odd", [&] { return whole::winding_number(polygon, p) != 0; })
      .answer([&] { return exercise::crossings(polygon, p); })
      .equals(whole::winding_number(polygon, p) % 2 != 0);
}

/// The polygon as it is, clockwise, and with another first vertex.
void check_all_orders(Points polygon, const Point& p) {
  check(polygon, p);
  std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  check(polygon, p);
  std::reverse(polygon.begin(), polygon.end());
  check(polygon, p);
}

const Points kStar{{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}};

}  // namespace

TEST_CASE("an edge to the right is crossed and one to the left is not") {
  check_edge({0, 0}, {5, -3}, {8, 4});
  check_edge({0, 0}, {8, 4}, {5, -3});
  check_edge({0, 0}, {-5, -3}, {-8, 4});
  check_edge({0, 0}, {-8, 4}, {-5, -3});
  // Above, below, and beside an oblique edge with one end on either side.
  check_edge({0, 0}, {5, 3}, {8, 4});
  check_edge({0, 0}, {5, -3}, {8, -4});
  check_edge({0, 0}, {-4, -1}, {8, 5});
  check_edge({0, 0}, {8, 5}, {-4, -1});
  check_edge({0, 0}, {-4, -5}, {8, 1});
  check_edge({0, 0}, {8, 1}, {-4, -5});
}

TEST_CASE("an end level with the point is not above it") {
  check_edge({2, 2}, {6, 2}, {7, 9});
  check_edge({2, 2}, {7, 9}, {6, 2});
  check_edge({2, 2}, {6, 2}, {7, -9});
  check_edge({2, 2}, {7, -9}, {6, 2});
  check_edge({2, 2}, {6, 2}, {9, 2});
  check_edge({2, 2}, {-6, 2}, {-7, 9});
  check_edge({2, 2}, {-7, -9}, {-6, 2});
}

TEST_CASE("points level with a vertex are inside or outside as others are") {
  const Points diamond{{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  check(diamond, {3, 0});
  check(diamond, {-2, -1});
  // Issue 24 of point-in-polygon-hao.
  const Points reported{{0, 0}, {3, -1}, {4, 1}, {1, 2}};
  check(reported, {2, 0});
  check(reported, {1, 1});
  check(reported, {0, 1});
  check(reported, {-1, 0});
  check_all_orders(diamond, {0, 0});
  check_all_orders(diamond, {-2, 0});
  check_all_orders(diamond, {-2, 1});
  check_all_orders(diamond, {-2, -1});
  // Steps: horizontal edges, and vertices at which the boundary goes on or turns back.
  const Points steps{{0, 0}, {12, 0}, {12, 4}, {9, 8}, {6, 4}, {4, 4}, {4, 8}, {2, 4}, {0, 8}};
  for (const int y : {0, 4, 8}) {
    for (const int x : {-3, 1, 3, 5, 8, 11, 14}) {
      const Point p(x, y);
      if (!whole::on_boundary(steps, p)) check_all_orders(steps, p);
    }
  }
}

TEST_CASE("a polygon that crosses itself is judged by the even-odd rule") {
  check_all_orders(kStar, {0, 6});
  check_all_orders(kStar, {0, 0});
  check_all_orders(kStar, {-4, -6});
  check_all_orders(kStar, {0, -6});
  // Twice round.
  const Points twice{{0, 0}, {9, 1}, {8, 9}, {1, 8}, {3, 3}, {6, 4}, {6, 6}, {4, 6}};
  check_all_orders(twice, {8, 5});
  check_all_orders(twice, {5, 5});
  check_all_orders(twice, {2, 4});
}

TEST_CASE("an area of one beside a long edge decides") {
  constexpr double kFar = 0x1p25;
  check_edge({kFar - 2, kFar - 1}, {-kFar, -kFar}, {kFar - 1, kFar});
  check_edge({0, 0}, {-kFar, -kFar}, {kFar, kFar - 1});
  check_edge({0, -1}, {-kFar, -kFar}, {kFar, kFar - 1});
  check_edge({0, 0}, {kFar, kFar - 1}, {-kFar, -kFar});
  check_edge({kFar - 1, kFar - 2}, {-kFar, -kFar}, {kFar, kFar - 1});
  check_edge({kFar - 1, kFar - 2}, {kFar, kFar - 1}, {-kFar, -kFar});
  check_edge({1 - kFar, 1 - kFar}, {kFar - 1, kFar}, {-kFar, -kFar});
}

TEST_CASE("random polygons agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  const auto judged = [](const Points& polygon, const Point& p) {
    return polygon.size() >= 3 && whole::all_whole(polygon) && whole::all_whole({p}) &&
           !whole::on_boundary(polygon, p);
  };
  for (int asked = 0; asked < 400;) {
    const int size = asked % 2 == 0 ? 4 : 1 << 25;
    const auto point = [&] {
      const double x = random.integer(-size, size);
      return Point{x, double(random.integer(-size, size))};
    };
    Points polygon;
    for (int n = random.integer(3, 9); n > 0; --n) polygon.push_back(point());
    const Point p = asked % 3 == 0 ? Point(point() / 2).array().round().matrix() : point();
    if (!judged(polygon, p)) continue;
    ++asked;
    shrinkable(check, judged, polygon, p);
  }
}
