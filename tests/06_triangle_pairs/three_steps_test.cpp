// Right answers are computed in integers, by separating directions. Every test asks for several
// answers. The first questions about a pair each bring one mistake to light that no question before
// did, so that the mistake is known by it.
#include "three_steps.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <06_triangle_pairs/steps_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using namespace exercise_pairs::steps_with_mistakes;
using exercise::Plane;
using namespace exercise_pairs;

constexpr double kFar = 30;

Point normal_of(const Triangle& t) { return (t.b - t.a).cross(t.c - t.a); }
Plane plane_of(const Triangle& t) { return {normal_of(t), -normal_of(t).dot(t.a)}; }

void check_plane(const Triangle& t) {
  const Plane right = plane_of(t);
  const Point of_positions = t.a.cross(t.b);
  ask("What is the plane of the triangle?")
      .given("triangle", t)
      .suspect("normal-of-positions",
               [&] {
                 return Plane{of_positions, -of_positions.dot(t.a)};
               })
      .suspect("normal-reversed",
               [&] {
                 return Plane{-right.normal, -right.offset};
               })
      .suspect("face-normal-made-unit",
               [&] {
                 const Point unit = right.normal.normalized();
                 return Plane{unit, -unit.dot(t.a)};
               })
      .suspect("offset-sign",
               [&] {
                 return Plane{right.normal, -right.offset};
               })
      .answer([&] { return exercise::plane_of(t); })
      .equals(right);
}

void check_distances(const Triangle& t, const Plane& plane) {
  const auto each = [&](double offset) {
    const Point& n = plane.normal;
    return Point(n.dot(t.a) + offset, n.dot(t.b) + offset, n.dot(t.c) + offset);
  };
  const Point right = each(plane.offset);
  ask("What are the distances of the vertices, times the length of the normal?")
      .given("triangle", t)
      .given("plane", plane)
      .suspect("offset-forgotten", [&] { return each(0); })
      .suspect("offset-sign", [&] { return each(-plane.offset); })
      .suspect("distance-without-sign", [&] { return Point(right.cwiseAbs()); })
      .suspect("distance-divided-by-the-normal", [&] { return Point(right / plane.normal.norm()); })
      .answer([&] { return exercise::distances(t, plane); })
      .equals(right);
}

void check_rejects(const Point& d) {
  const bool ahead = d.minCoeff() > 0, behind = d.maxCoeff() < 0;
  ask("Do these distances show that no point of the triangle is in the plane?")
      .given("distances", d)
      .suspect("touching-rejected", [&] { return d.minCoeff() >= 0 || d.maxCoeff() <= 0; })
      .suspect("one-side-of-the-plane-alone", [&] { return ahead; })
      .suspect("one-side-of-the-plane-alone", [&] { return behind; })
      .suspect("third-vertex-not-asked", [&] { return d[0] * d[1] > 0; })
      .suspect("some-for-all-vertices", [&] { return d[0] * d[1] > 0 || d[0] * d[2] > 0; })
      .answer([&] { return exercise::rejects(d); })
      .equals(ahead || behind);
}

void check(const Triangle& first, const Triangle& second) {
  const auto with = [&](const Steps& steps) {
    return [&, steps] { return meet(first, second, steps); };
  };
  const auto by = [&](const Intervals& how) {
    return [&, how] { return intervals_overlap(first, second, how); };
  };
  ask("Do the triangles have a point in common?")
      .given("first", first)
      .given("second", second)
      .suspect("planes-for-triangles", [&] { return planes_reached(first, second); })
      .suspect("boxes-for-triangles", [&] { return boxes_meet(first, second); })
      .suspect("crossing-from-the-wrong-end", with({.from_the_start = false}))
      .suspect("interval-ends-not-sorted", by({.sorted = false}))
      .suspect("ends-of-pq-alone", with({.second_in_first = false}))
      .suspect("inside-not-asked", with({.first_in_second = false}))
      .suspect("second-crossing-not-asked", with({.all_crossings = false}))
      .suspect("last-edge-forgotten", with({.edges = 2}))
      .suspect("touching-rejected", with({.border_counts = false}))
      .suspect("touching-rejected",
               [&] { return planes_crossed(first, second) && meet(first, second); })
      .suspect("vertex-in-the-plane-missed", with({.ends_may_be_on = false}))
      .suspect("vertex-in-the-plane-alone", by({.zero_is_no_side = false}))
      .suspect("vertical-projected-along-z", with({.largest_dropped = false}))
      .suspect("line-measured-by-x", by({.coordinate = 0}))
      .suspect("absolute-epsilon", by({.epsilon = 1e-3}))
      .suspect("common-points-rounded", [&] { return meet_rounded<double>(first, second); })
      .suspect("common-points-rounded", by({}))
      .suspect("planes-in-float", [&] { return meet_rounded<float>(first, second); })
      .answer([&] { return exercise::triangles_meet(first, second); })
      .equals(meet_across_planes(first, second));
}

/// Each in both directions of its vertices, beginning with each vertex, and in both orders.
void check_all_orders(const Triangle& first, const Triangle& second) {
  check(first, second);
  for (const Triangle& t : orders(first)) {
    for (const Triangle& u : orders(second)) {
      check(t, u);
      check(u, t);
    }
  }
}

}  // namespace

TEST_CASE("the plane contains the triangle, and its normal points to the front") {
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}});
  check_plane({{1, 2, 3}, {1, 7, 3}, {5, 2, 4}});
  check_plane({{-3, 7, 2}, {4, 1, -6}, {2, 2, 9}});
  check_plane({{kFar, -kFar, kFar}, {-kFar, kFar, 1 - kFar}, {-kFar, -kFar, -kFar}});
  check_plane({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
}

TEST_CASE("a distance is positive in front of the plane and negative behind it") {
  check_distances({{3, 3, 9}, {2, 8, 1}, {1, -5, -4}}, {{1, -2, 3}, -4});
  check_distances({{3, 3, 1}, {0, 0, 4}, {0, 5, -4}}, {{4, 2, 1}, -4});
  check_distances({{-3, 7, 2}, {4, 1, -6}, {2, 2, 9}}, {{0, -7, 0}, 50});
  check_distances({{kFar, kFar, kFar}, {-kFar, kFar, 1 - kFar}, {-kFar, -kFar, -kFar}},
                  {{3599, -3600, 3601}, 107999});
}

TEST_CASE("three vertices on one side reject the pair") {
  check_rejects({2, 3, 5});
  check_rejects({-2, 7, 4});
  check_rejects({-1, -7, -4});
  check_rejects({6, -1, 2});
  check_rejects({3, 9, -5});
  check_rejects({-1, 8, -3});
  check_rejects({0, 4, 7});
  check_rejects({-8, -4, 0});
  check_rejects({0, 0, 3});
  check_rejects({0, -5, 2});
  check_rejects({400000, 1, 400000});
}

TEST_CASE("reaching the plane of the other is not yet meeting it") {
  check({{2, 0, -1}, {0, 1, 1}, {-1, 0, 1}}, {{1, -1, 0}, {1, -3, -1}, {0, -2, -2}});
  check({{-1, 1, -1}, {0, -2, 0}, {0, 0, 1}}, {{1, 0, 1}, {1, 0, 4}, {0, 1, 2}});
  check({{0, 1, 0}, {0, 0, -1}, {0, 0, 1}}, {{2, 4, 1}, {-4, 3, -1}, {1, 0, 0}});
  check({{0, 0, 0}, {9, 1, 2}, {2, 8, 3}}, {{13, 3, 9}, {15, 2, -7}, {12, 6, -4}});
  check({{0, 0, 0}, {9, 1, 2}, {2, 8, 3}}, {{0, 0, 1}, {9, 1, 3}, {2, 8, 4}});
}

TEST_CASE("triangles that cross are found, whichever edges go through") {
  check({{0, -4, 0}, {1, 2, -1}, {3, 0, 1}}, {{0, 1, 2}, {1, 0, -1}, {0, 2, 0}});
  check({{3, -2, -1}, {0, 0, -2}, {0, 1, 2}}, {{1, 1, 0}, {-1, -2, 1}, {-1, -1, 0}});
  check({{-2, 1, 2}, {0, 1, 1}, {1, 0, 0}}, {{0, 2, 2}, {-1, 1, 1}, {1, -2, 0}});
  check({{-1, -1, -2}, {2, 0, 0}, {-1, -1, 0}}, {{0, 0, -1}, {-4, 3, 0}, {1, -2, 1}});
  check({{-1, -1, -1}, {2, -1, 0}, {2, -1, 2}}, {{2, 0, 0}, {0, 0, 3}, {0, -3, 1}});
  check_all_orders({{-20, 4, 3}, {25, 1, -7}, {6, 29, 8}}, {{3, 8, -30}, {1, 9, 27}, {12, 14, -9}});
  check_all_orders({{-20, 4, 3}, {25, 1, -7}, {6, 29, 8}},
                   {{-3, 8, -30}, {9, -20, 30}, {2, 4, -25}});
  check_all_orders({{-20, 4, 3}, {25, 1, -7}, {6, 29, 8}},
                   {{-3, 8, 30}, {9, -20, -30}, {30, 4, -25}});
}

TEST_CASE("the planes may have any direction") {
  check({{-3, 1, -1}, {-1, -3, 1}, {0, 3, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 2}});
  check({{1, 0, -2}, {1, -1, -3}, {-1, -3, 0}}, {{-2, -2, 0}, {0, 0, 1}, {0, -1, 0}});
  for (int axis = 0; axis < 3; ++axis) {
    const auto turned = [axis](const Point& p) {
      return Point(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
    };
    const Triangle wall{turned({0, 1, 0}), turned({0, 9, 1}), turned({0, 2, 8})};
    const auto beside = [&](const Point& p, const Point& q, const Point& r) {
      return Triangle{turned(p), turned(q), turned(r)};
    };
    check_all_orders(wall, beside({-3, 4, 3}, {5, 4, 3}, {7, 9, 9}));
    check_all_orders(wall, beside({-3, 9, 9}, {5, 9, 9}, {7, 4, 8}));
    check_all_orders(wall, beside({-3, 5, -9}, {4, 5, -9}, {1, 5, 19}));
    check_all_orders(wall, beside({-3, -5, -9}, {4, -5, -9}, {1, -5, 19}));
  }
}

TEST_CASE("touching at a point counts") {
  // A vertex of the one inside the other, on an edge, at a vertex; two edges; an edge in the plane.
  check({{0, 0, 0}, {-2, -1, -2}, {0, 1, -3}}, {{-1, 0, 0}, {0, -1, 0}, {4, 0, 0}});
  check({{2, -3, 1}, {0, 3, -1}, {1, -2, 0}}, {{1, -1, 3}, {1, -1, 0}, {-1, 0, 0}});
  check({{1, 0, 0}, {4, -4, 2}, {-1, 0, -2}}, {{0, 0, -1}, {-1, 0, 0}, {0, 0, 1}});
  const Triangle ground{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  for (const Point& at : {Point(2, 3, 0), Point(4, 0, 0), Point(5, 3, 0), Point(0, 8, 0)}) {
    check_all_orders(ground, {at, {3, 2, 5}, {6, 1, 4}});
    check_all_orders(ground, {at, {3, 2, 5}, {6, 1, -4}});
  }
  for (const Point& beside : {Point(-1, 3, 0), Point(9, 0, 0), Point(5, 4, 0), Point(0, 9, 0)})
    check_all_orders(ground, {beside, {13, 12, 5}, {16, 11, 4}});
  check_all_orders(ground, {{4, -2, -2}, {4, 2, 2}, {4, -6, 9}});
  check_all_orders(ground, {{4, -2, -3}, {4, 2, 2}, {4, -6, 9}});
  check_all_orders(ground, {{2, 2, 0}, {-3, 4, 0}, {1, 1, 7}});
  check_all_orders(ground, {{9, 2, 0}, {-3, 14, 0}, {1, 1, 7}});
  check_all_orders(ground, {{0, 8, 0}, {0, 0, 0}, {-3, 1, 7}});
  check_all_orders(ground, {{0, 9, 0}, {0, 12, 0}, {-3, 1, 7}});
}

TEST_CASE("a small gap is a gap, and a point at no stored number is a point") {
  check({{6, -6, -22}, {13, 25, 25}, {26, -9, -19}}, {{-26, -27, 28}, {-26, 10, 5}, {25, 20, -22}});
  check({{0, 0, 3}, {0, 2, -2}, {3, 0, -2}}, {{-3, 0, 1}, {-1, -2, -1}, {1, 0, 2}});
  check({{-1, -1, -1}, {0, 0, 1}, {-1, 2, 1}}, {{-1, 1, 0}, {-1, -3, 2}, {-2, -2, -2}});
  check({{-1, 1, 0}, {1, -1, 0}, {-2, 0, 3}}, {{1, -2, 1}, {1, 0, 0}, {0, -4, 1}});
}

TEST_CASE("random pairs of triangles agree with integers") {
  generators::Random random(seed(0));
  const auto judged = [](const Triangle& first, const Triangle& second) {
    return all_whole(first, second, kFar) && has_area(first) && has_area(second) &&
           !in_one_plane(first, second);
  };
  for (int asked = 0; asked < 1500;) {
    const int size = asked % 3 == 0 ? 30 : 2 + asked % 5;
    const auto point = [&] {
      const double x = random.integer(-size, size), y = random.integer(-size, size);
      return Point(x, y, random.integer(-size, size));
    };
    const auto triangle = [&] {
      const Point a = point(), b = point();
      return Triangle{a, b, point()};
    };
    const Triangle first = triangle();
    Triangle second = triangle();
    // Of every fourth pair, an edge of the second goes through a point of the first's border.
    if (asked % 4 == 0) second.b = first.a + first.b - second.a;
    if (!judged(first, second)) continue;
    ++asked;
    shrinkable(check, judged, first, second);
  }
}
