// Right answers are computed in whole numbers. Every test asks for several answers.
#include "edge_tests.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <03_polygons/whole.hpp>

namespace {

using namespace contact::testing;
using exercise::Where;
using whole::Point;
using whole::Points;

Where truth(const Points& polygon, const Point& p) {
  if (whole::on_boundary(polygon, p)) return Where::on;
  return whole::winding_number(polygon, p) == 0 ? Where::outside : Where::inside;
}

/// The edge tests with a mistake: `ahead(a, b)` is positive in front of an edge.
template <class Ahead>
Where by_edges(const Points& polygon, std::size_t edges, Ahead&& ahead, double epsilon = 0) {
  bool on = false;
  for (std::size_t i = 0; i < edges; ++i) {
    const double distance = ahead(polygon[i], whole::after(polygon, i));
    if (distance > epsilon) return Where::outside;
    on = on || distance >= -epsilon;
  }
  return on ? Where::on : Where::inside;
}

Point outward(const Point& a, const Point& b) { return {(b - a).y(), -(b - a).x()}; }

void check_normal(const Point& from, const Point& to) {
  const Point right = outward(from, to);
  ask("What is the outward normal of the edge, as long as the edge?")
      .given("from", from)
      .given("to", to)
      .suspect("normal-inwards", [&] { return Point(-right); })
      .suspect("edge-for-normal", [&] { return Point(to - from); })
      .answer([&] { return exercise::outward_normal(from, to); })
      .equals(right);
}

void check_ahead(const Point& p, const Point& from, const Point& to) {
  const double right = outward(from, to).dot(p - from);
  ask("What is the product of the outward normal and the vector from the edge to the point?")
      .given("point", p)
      .given("from", from)
      .given("to", to)
      .suspect("vertex-not-subtracted", [&] { return outward(from, to).dot(p); })
      .suspect("normal-made-unit", [&] { return outward(from, to).normalized().dot(p - from); })
      .suspect("behind-for-ahead", [&] { return -right; })
      .answer([&] { return exercise::ahead(p, from, to); })
      .equals(right);
}

void check(const Points& polygon, const Point& p) {
  const Where right = truth(polygon, p);
  const auto ahead = [&](const Point& a, const Point& b) { return outward(a, b).dot(p - a); };
  ask("Where is the point?")
      .given("polygon", polygon)
      .given("point", p)
      .suspect("first-edge-decides", [&] { return by_edges(polygon, 1, ahead); })
      .suspect("last-edge-forgotten", [&] { return by_edges(polygon, polygon.size() - 1, ahead); })
      .suspect("absolute-epsilon",
               [&] {
                 return by_edges(
                     polygon, polygon.size(),
                     [&](const Point& a, const Point& b) {
                       return outward(a, b).normalized().dot(p - a);
                     },
                     1e-6);
               })
      .suspect_if("on-not-told-apart",
                  [&](const Where& got) { return right == Where::on && got != Where::on; })
      .suspect_if("on-the-line-of-an-edge",
                  [&](const Where& got) {
                    if (got != Where::on || right != Where::outside) return false;
                    for (std::size_t i = 0; i < polygon.size(); ++i) {
                      if (whole::area(polygon[i], whole::after(polygon, i), p) == 0) return true;
                    }
                    return false;
                  })
      .answer([&] { return exercise::edge_tests(polygon, p); })
      .equals(right);
}

const Points kTriangle{{20, 10}, {60, 20}, {30, 50}};
const Points kPentagon{{10, 4}, {18, 6}, {20, 12}, {13, 18}, {8, 10}};
/// Two of its vertices are inside an edge.
const Points kSquare{{10, 10}, {14, 10}, {18, 10}, {18, 18}, {10, 18}, {10, 14}};

}  // namespace

TEST_CASE("the normal of an edge points outwards") {
  check_normal({0, 0}, {5, 0});
  check_normal({2, 1}, {4, 8});
  check_normal({4, 8}, {2, 1});
  check_normal({-3, 7}, {-9, 7});
  check_normal({0x1p25, -0x1p25}, {-0x1p25, 0x1p25});
}

TEST_CASE("the product is positive in front of an edge and negative behind it") {
  check_ahead({5, 1}, {2, 3}, {8, 3});
  check_ahead({5, 7}, {2, 3}, {8, 3});
  check_ahead({9, -4}, {-3, 5}, {1, 2});
  check_ahead({0, 0}, {7, 1}, {4, 9});
  check_ahead({5, 3}, {2, 3}, {8, 3});
  check_ahead({0x1p25, 1 - 0x1p25}, {-0x1p25, 0x1p25}, {0x1p25 - 1, -0x1p25});
}

TEST_CASE("a point inside is told from one outside") {
  check(kTriangle, {35, 25});
  // Outside, in front of one edge alone: the first, the second, the last.
  check(kTriangle, {40, 12});
  check(kTriangle, {50, 40});
  check(kTriangle, {20, 30});
  check(kTriangle, {0, 0});
  check(kPentagon, {14, 10});
  for (const Point& outside :
       {Point(14, 4), Point(20, 8), Point(18, 16), Point(9, 15), Point(8, 6)})
    check(kPentagon, outside);
  check(kSquare, {12, 16});
  check(kSquare, {12, 20});
}

TEST_CASE("a point on an edge or at a vertex is on") {
  check(kSquare, {12, 16});
  check(kSquare, {16, 10});
  for (const Point& on :
       {Point(10, 10), Point(14, 10), Point(18, 18), Point(15, 18), Point(10, 12)})
    check(kSquare, on);
  check(kTriangle, {40, 15});
  check(kTriangle, {25, 30});
  check(kTriangle, {30, 50});
}

TEST_CASE("on the line of an edge is not yet on the edge") {
  check(kSquare, {16, 10});
  check(kSquare, {22, 10});
  check(kSquare, {6, 10});
  check(kSquare, {18, 4});
  check(kSquare, {10, 30});
  check(kTriangle, {0, 5});
  check(kTriangle, {90, -10});
}

TEST_CASE("a point beside a long edge is not on it") {
  constexpr double kFar = 0x1p25;
  const Points long_edges{{-kFar, -kFar}, {kFar, kFar - 1}, {-kFar, kFar}};
  check(long_edges, {0, 0});
  check(long_edges, {0, -1});
  check(long_edges, {-kFar + 1, -kFar + 1});
  check(long_edges, {kFar - 1, kFar - 1});
  check(long_edges, {kFar - 1, kFar - 2});
  // Two edges of one line but for an area of one.
  const Points thin{{-kFar, -kFar}, {0, -1}, {kFar, kFar - 1}, {-kFar, kFar}};
  check(thin, {0, -1});
  check(thin, {0, 0});
}

TEST_CASE("random convex polygons agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  const auto judged = [](const Points& polygon, const Point& p) {
    return polygon.size() >= 3 && whole::all_whole(polygon) && whole::all_whole({p}) &&
           whole::is_convex(polygon);
  };
  const Points round{{-4, -2}, {-2, -4}, {2, -4}, {4, -2}, {4, 0}, {4, 2}, {1, 5}, {-2, 4}};
  for (int asked = 0; asked < 400;) {
    // An affine image of some vertices of a convex polygon.
    const int size = asked % 2 == 0 ? 2 : 1 << 20;
    const auto number = [&](int limit) { return double(random.integer(-limit, limit)); };
    Eigen::Matrix2d map;
    map << number(size), number(size), number(size), number(size);
    if (map.determinant() <= 0) continue;
    const Point shift{number(4 * size), number(4 * size)};
    Points polygon;
    for (const Point& v : round) {
      if (random.integer(0, 3) != 0) polygon.push_back(map * v + shift);
    }
    if (polygon.size() < 3) continue;
    std::rotate(polygon.begin(),
                polygon.begin() + random.integer(0, static_cast<int>(polygon.size()) - 1),
                polygon.end());
    Point p{shift.x() + number(5 * size), shift.y() + number(5 * size)};
    if (asked % 3 == 0) p = map * Point{number(4), number(4)} + shift;
    if (!judged(polygon, p)) continue;
    ++asked;
    shrinkable(check, judged, polygon, p);
  }
}
