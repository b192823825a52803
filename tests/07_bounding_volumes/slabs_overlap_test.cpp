// What is right is computed in integers. The first questions of a test each bring one mistake to
// light that no question before did, so that the mistake is known by it.
#include "slabs_overlap.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <07_bounding_volumes/slabs_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using slabs_with_mistakes::Apart;
using slabs_with_mistakes::Between;
using slabs_with_mistakes::Making;
using slabs_with_mistakes::Moving;
using slabs_with_mistakes::near;
using slabs_with_mistakes::Point;
using slabs_with_mistakes::Points;
using slabs_with_mistakes::Projected;
using slabs_with_mistakes::Slabs;
using slabs_with_mistakes::Start;

constexpr double kFar = 1000000, kLong = 1000;

void check_slabs(const Points& directions, const Points& vertices) {
  const Slabs right = slabs_with_mistakes::slabs_of(directions, vertices);
  const auto with = [&](const Making& making) {
    return [&, making] { return slabs_with_mistakes::slabs_of(directions, vertices, making); };
  };
  ask("Which are the narrowest slabs around the body?")
      .given("directions", directions)
      .given("vertices", vertices)
      .suspect("slab-from-zero", with({.start = Start::zero}))
      .suspect("smallest-positive-for-lowest", with({.start = Start::smallest_positive}))
      .suspect("lower-or-raise", with({.either = true}))
      .suspect("box-for-body", with({.corners = true}))
      .suspect("slabs-in-float", with({.projected = Projected::in_float}))
      .suspect("sign-of-projection-lost", with({.projected = Projected::without_sign}))
      .suspect_if("slab-direction-made-unit",
                  [&](const Slabs& got) {
                    return near(got, with({.projected = Projected::by_unit})(), right);
                  })
      .answer([&] { return exercise::slabs_of(directions, vertices); })
      .equals(right);
}

void check_between(const Points& directions, const Slabs& slabs, const Point& point) {
  const auto with = [&](const Between& ways) {
    return [&, ways] {
      return slabs_with_mistakes::between_each_pair(directions, slabs, point, ways);
    };
  };
  ask("Is the point between each pair of planes?")
      .given("directions", directions)
      .given("slabs", slabs)
      .given("point", point)
      .suspect("some-pair-is-enough", with({.some = true}))
      .suspect("one-plane-of-each-pair", with({.low = false}))
      .suspect("one-plane-of-each-pair", with({.high = false}))
      .suspect("last-direction-left-out", with({.left_out = 1}))
      .suspect("touching-rejected", with({.on_plane = false}))
      .suspect("flat-slab-empty", with({.flat = false}))
      .suspect("slab-direction-made-unit", with({.projected = Projected::by_unit}))
      .suspect("sign-of-projection-lost", with({.projected = Projected::without_sign}))
      .answer([&] { return exercise::between_each_pair(directions, slabs, point); })
      .equals(slabs_with_mistakes::between_each_pair(directions, slabs, point));
}

void check_separating(const Slabs& first, const Slabs& second) {
  const auto with = [&](Apart apart) {
    return [&, apart] { return slabs_with_mistakes::first_separating(first, second, apart); };
  };
  const auto by = [&](int (*answer)(const Slabs&, const Slabs&)) {
    return [&, answer] { return answer(first, second); };
  };
  ask("Which is the first direction in which the two bodies are apart?")
      .given("first", first)
      .given("second", second)
      .suspect("one-order-of-the-slabs", with(Apart::if_first_before_second))
      .suspect("one-order-of-the-slabs", with(Apart::if_second_before_first))
      .suspect("ends-of-one-slab", with(Apart::if_no_end_in_first))
      .suspect("ends-of-one-slab", with(Apart::if_no_end_in_second))
      .suspect("touching-rejected", with(Apart::if_touching))
      .suspect("flat-slab-empty", with(Apart::if_flat))
      .suspect("some-overlap-is-enough", by(slabs_with_mistakes::separating_everywhere))
      .suspect("last-direction-left-out", by(slabs_with_mistakes::separating_but_in_the_last))
      .suspect("last-direction-named", by(slabs_with_mistakes::last_separating))
      .suspect("widest-gap-named", by(slabs_with_mistakes::widest_gap))
      .suspect("size-for-none", by(slabs_with_mistakes::size_if_none))
      .answer([&] { return exercise::first_separating(first, second); })
      .equals(slabs_with_mistakes::first_separating(first, second));
}

void check_moved(const Points& directions, const Slabs& slabs, const Point& displacement) {
  const Slabs right = slabs_with_mistakes::moved(directions, slabs, displacement);
  const auto with = [&](const Moving& ways) {
    return [&, ways] { return slabs_with_mistakes::moved(directions, slabs, displacement, ways); };
  };
  ask("Which are the slabs of the body after it has moved?")
      .given("directions", directions)
      .given("slabs", slabs)
      .given("displacement", displacement)
      .suspect("displacement-not-projected", with({.by_length = true}))
      .suspect("slabs-moved-backwards", with({.sign = -1}))
      .suspect("one-plane-moved", with({.high = false}))
      .suspect("one-plane-moved", with({.low = false}))
      .suspect("swept-for-moved", with({.swept = true}))
      .suspect("sign-of-projection-lost", with({.projected = Projected::without_sign}))
      .suspect_if("slab-direction-made-unit",
                  [&](const Slabs& got) {
                    return near(got, with({.projected = Projected::by_unit})(), right);
                  })
      .answer([&] { return exercise::moved(directions, slabs, displacement); })
      .equals(right);
}

/// Both bodies first.
void check_pair(const Points& directions, const Points& a, const Points& b) {
  const Slabs first = slabs_with_mistakes::slabs_of(directions, a);
  const Slabs second = slabs_with_mistakes::slabs_of(directions, b);
  check_separating(first, second);
  check_separating(second, first);
}

Points axes() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }
Points oblique() { return {{2, -1, 0}, {1, 3, -2}, {0, 4, 1}, {-3, 1, 5}}; }
Points tetrahedron() { return {{-1, -3, 1}, {7, -2, 3}, {2, 5, -4}, {0, 1, 8}}; }
Points moved_by(const Point& d, Points points) {
  for (Point& p : points) p += d;
  return points;
}
Slabs slabs(const Points& directions, const Points& vertices) {
  return slabs_with_mistakes::slabs_of(directions, vertices);
}

}  // namespace

TEST_CASE("the slabs of a body reach its outermost vertices") {
  check_slabs(axes(), tetrahedron());
  check_slabs({{2, -1, 0}}, {{5, 1, 0}, {4, 5, 7}, {0, 2, 3}});
  check_slabs({{1, 1, 0}}, {{4, 1, 0}, {1, 4, 7}, {0, 0, 3}, {5, -1, 2}});
  check_slabs(oblique(), tetrahedron());
  check_slabs({{1, 2, 3}, {-1, -2, -3}, {1, 2, 3}, {2, 4, 6}}, tetrahedron());
}

TEST_CASE("a slab need not reach the origin") {
  check_slabs(axes(), moved_by({20, 30, 40}, tetrahedron()));
  check_slabs(axes(), moved_by({-20, -30, -40}, tetrahedron()));
  check_slabs(oblique(), moved_by({-20, -30, -40}, tetrahedron()));
  check_slabs(oblique(), {{3, -2, 4}});
}

TEST_CASE("a direction has any length") {
  check_slabs({{0, 3, 4}, {0, 0, 7}, {-2, 0, 0}, {12, 0, 5}}, tetrahedron());
  check_slabs({{kLong, -kLong, kLong - 1}, {1, kLong, 0}},
              {{kFar, -kFar, kFar - 1}, {-kFar, kFar - 3, 77}, {5, kFar, -kFar}});
}

TEST_CASE("a point is between each pair of planes or not") {
  const Slabs box = slabs(axes(), tetrahedron());
  check_between(axes(), box, {3, 1, 2});
  check_between(axes(), box, {9, 9, 20});
  check_between(axes(), box, {-9, -9, -9});
  check_between(axes(), box, {3, 9, 2});
  check_between(axes(), box, {3, 1, 20});
  check_between(axes(), box, {-9, 1, 2});
  check_between(oblique(), slabs(oblique(), tetrahedron()), {2, 1, 1});
  check_between(oblique(), slabs(oblique(), tetrahedron()), {6, 4, 7});
  check_between({{3, 0, 4}, {0, 5, 12}}, slabs({{3, 0, 4}, {0, 5, 12}}, tetrahedron()), {2, 1, 11});
  check_between({{3, 0, 4}, {0, 5, 12}}, slabs({{3, 0, 4}, {0, 5, 12}}, tetrahedron()), {6, 1, 3});
  check_between({{1, 0, 0}}, {{-9, 4}}, {-6, 0, 0});
  check_between({{1, 0, 0}}, {{2, 9}}, {-6, 0, 0});
  check_between({{kLong, kLong, kLong}}, {{kLong * 3, kLong * (3 * kFar - 1)}}, {kFar, kFar, kFar});
}

TEST_CASE("a point on a plane is between") {
  const Slabs box = slabs(axes(), tetrahedron());
  check_between(axes(), box, {7, 1, 2});
  check_between(axes(), box, {3, -3, 2});
  const Points square{{0, 0, 5}, {9, 0, 5}, {9, 9, 5}, {0, 9, 5}};
  check_between(axes(), slabs(axes(), square), {4, 4, 5});
  for (const Point& p : tetrahedron()) {
    check_between(oblique(), slabs(oblique(), tetrahedron()), p);
    check_between(oblique(), slabs(oblique(), tetrahedron()), p + Point(1, 1, 1));
  }
  check_between(axes(), box, {8, 1, 2});
}

TEST_CASE("the first direction that separates two bodies is named") {
  check_separating({{0, 4}, {0, 4}}, {{7, 9}, {7, 9}});
  check_separating({{7, 9}, {7, 9}}, {{0, 4}, {0, 4}});
  check_separating({{0, 4}, {0, 4}}, {{7, 9}, {9, 10}});
  check_separating({{0, 4}, {1, 9}, {-3, 5}}, {{2, 7}, {11, 15}, {1, 8}});
  check_separating({{0, 4}, {1, 9}, {-3, 5}}, {{2, 7}, {5, 15}, {-9, -8}});
  check_separating({{0, 4}}, {{7, 9}});
  check_pair(axes(), tetrahedron(), moved_by({0, 0, 13}, tetrahedron()));
  check_pair(oblique(), tetrahedron(), moved_by({9, -8, 3}, tetrahedron()));
  check_pair(oblique(), tetrahedron(), moved_by({-5, 4, 9}, tetrahedron()));
}

TEST_CASE("slabs overlap in every direction") {
  check_separating({{0, 4}, {1, 9}, {-3, 5}}, {{2, 7}, {5, 8}, {-4, 3}});
  check_separating({{0, 9}, {1, 9}}, {{2, 7}, {5, 8}});
  check_separating({{2, 7}, {5, 8}}, {{0, 9}, {1, 9}});
  check_pair(axes(), tetrahedron(), {{2, 1, 2}, {3, 1, 2}, {3, 2, 1}});
  check_pair(axes(), tetrahedron(), moved_by({0, 9, 0}, tetrahedron()));
}

TEST_CASE("slabs that touch overlap") {
  check_separating({{0, 4}, {1, 9}, {-3, 5}}, {{2, 7}, {9, 15}, {1, 8}});
  check_separating({{0, 4}, {1, 9}, {-3, 5}}, {{2, 7}, {-4, 1}, {1, 8}});
  check_separating({{5, 5}, {0, 8}}, {{2, 7}, {1, 8}});
  check_separating({{2, 7}, {0, 8}}, {{2, 2}, {1, 8}});
  check_pair(axes(), tetrahedron(), moved_by({8, 0, 0}, tetrahedron()));
  check_pair(axes(), tetrahedron(), moved_by({9, 0, 0}, tetrahedron()));
}

TEST_CASE("slabs may overlap although the bodies are apart") {
  // Two thin bodies along a diagonal, one beside the other.
  const Points one{{0, 0, 0}, {9, 9, 0}, {0, 0, 1}}, other{{4, 0, 0}, {9, 5, 0}, {4, 0, 1}};
  check_pair(axes(), one, other);
  check_pair({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}, one, other);
  check_pair({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}}, one, other);
}

TEST_CASE("the slabs of a body move with it") {
  const Slabs box = slabs(axes(), tetrahedron());
  check_moved(axes(), box, {2, -3, 6});
  check_moved(axes(), box, {-4, 0, -7});
  check_moved({{3, 0, 4}}, slabs({{3, 0, 4}}, tetrahedron()), {5, 1, 10});
  check_moved(oblique(), slabs(oblique(), tetrahedron()), {3, -5, 2});
  check_moved(oblique(), slabs(oblique(), tetrahedron()), {0, 0, 0});
  check_moved({{kLong, 1 - kLong, kLong}}, {{-5, kLong * kFar}}, {kFar, 3 - kFar, 1});
}

TEST_CASE("random bodies agree with integers") {
  generators::Random random(seed(0));
  const auto are_directions = [](const Points& directions) {
    return !directions.empty() && whole_points::all_whole(directions, kLong) &&
           std::none_of(directions.begin(), directions.end(),
                        [](const Point& n) { return n.isZero(0); });
  };
  const auto are_points = [](const Points& points) {
    return !points.empty() && whole_points::all_whole(points, kFar);
  };
  const auto judged = [&](const Points& directions, const Points& vertices, const Point& p) {
    return are_directions(directions) && are_points(vertices) && are_points({p});
  };
  const auto judged_pair = [&](const Points& directions, const Points& a, const Points& b) {
    return are_directions(directions) && are_points(a) && are_points(b);
  };
  const auto check_point = [](const Points& directions, const Points& vertices, const Point& p) {
    check_between(directions, slabs(directions, vertices), p);
  };
  const auto check_move = [](const Points& directions, const Points& vertices, const Point& d) {
    check_moved(directions, slabs(directions, vertices), d);
  };
  const auto check_vertices = [](const Points& directions, const Points& vertices, const Point&) {
    check_slabs(directions, vertices);
  };
  for (int asked = 0; asked < 400; ++asked) {
    const auto vector = [&](int limit) {
      const double x = random.integer(-limit, limit), y = random.integer(-limit, limit);
      return Point(x, y, random.integer(-limit, limit));
    };
    const int size = asked % 3 == 0 ? 900000 : 6, length = asked % 3 == 0 ? 1000 : 3;
    Points directions, a, b;
    const int n = random.integer(1, 6), of_a = random.integer(1, 5), of_b = random.integer(1, 5);
    while (std::ssize(directions) < n) {
      const Point direction = vector(length);
      if (!direction.isZero(0)) directions.push_back(direction);
    }
    const Point from = vector(size / 9);
    for (int i = 0; i < of_a; ++i) a.push_back(from + vector(size));
    const Point to = vector(size / 9);
    for (int i = 0; i < of_b; ++i) b.push_back(to + vector(size / 2));
    shrinkable(check_vertices, judged, directions, a, from);
    shrinkable(check_point, judged, directions, a, to);
    shrinkable(check_point, judged, directions, a, a.front());
    shrinkable(check_pair, judged_pair, directions, a, b);
    shrinkable(check_move, judged, directions, a, to);
  }
}
