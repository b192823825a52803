// Right answers are computed in integers, by separating directions. Every test asks for several
// answers. The first questions each bring one mistake to light that no question before did, so that
// the mistake is known by it.
#include "coplanar.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <06_triangle_pairs/coplanar_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using namespace exercise_pairs;
using namespace exercise_pairs::coplanar_with_mistakes;

constexpr double kFar = 2000;

/// Whether the vertices of `second` are nearer to the plane of `first` than a tolerance.
bool nearly_in_plane_of(const Triangle& first, const Triangle& second) {
  const Point n = (first.b - first.a).cross(first.c - first.a);
  const std::array<Point, 3> of = vertices(second);
  return std::all_of(of.begin(), of.end(), [&](const Point& p) {
    return std::abs(n.dot(p - first.a)) <= 1e-6 * n.norm();
  });
}

void check_plane(const Triangle& first, const Triangle& second) {
  ask("Does one plane contain all six vertices?")
      .given("first", first)
      .given("second", second)
      .suspect("no-plane-is-every-plane", [&] { return in_plane_of(first, second, 3); })
      .suspect("no-plane-is-every-plane", [&] { return in_plane_of(second, first, 3); })
      .suspect("parallel-for-coplanar",
               [&] { return is_zero(cross(normal(first), normal(second))); })
      .suspect("one-vertex-for-the-plane", [&] { return in_plane_of(first, second, 1); })
      .suspect("third-vertex-not-asked", [&] { return in_plane_of(first, second, 2); })
      .suspect("absolute-epsilon", [&] { return nearly_in_plane_of(first, second); })
      .suspect("no-area-has-no-plane",
               [&] { return has_area(first) && has_area(second) && in_one_plane(first, second); })
      .answer([&] { return exercise::in_one_plane(first, second); })
      .equals(in_one_plane(first, second));
}

void check(const Triangle& first, const Triangle& second) {
  const bool right = meet_in_one_plane(first, second);
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return meet(first, second, ways); };
  };
  ask("Do the triangles have a point in common?")
      .given("first", first)
      .given("second", second)
      .suspect("coplanar-called-apart", [] { return false; })
      .suspect("coplanar-called-meeting", [] { return true; })
      .suspect("drops-smallest-dimension", with({.drop = Drop::worst}))
      .suspect("vertices-without-edges", with({.edges = false, .all_inside = true}))
      .suspect("axes-of-the-first-alone", [&] { return not_separated_by_the_first(first, second); })
      .suspect("boxes-for-triangles", [&] { return boxes_meet(first, second); })
      .suspect("last-edge-forgotten", with({.edge_count = 2}))
      .suspect("edges-without-inside", with({.one_inside = false, .other_inside = false}))
      .suspect("first-in-second-alone", with({.other_inside = false}))
      .suspect("assumes-counter-clockwise", with({.clockwise = false}))
      .suspect("touching-rejected", with({.touching = false}))
      .suspect("vertical-projected-along-z", with({.drop = Drop::z}))
      .suspect("no-area-meets-nothing",
               [&] { return has_area(first) && has_area(second) && right; })
      .suspect("parallel-edges-never-meet", with({.parallel = false}))
      .suspect("beyond-the-end-of-a-segment", with({.ends_of_lines = false}))
      .suspect("epsilon-orientation", with({.epsilon = 1e-6}))
      .answer([&] { return exercise::meet_in_one_plane(first, second); })
      .equals(right);
}

/// In both orders, and each triangle in all orders of its vertices.
void check_all_orders(const Triangle& first, const Triangle& second) {
  check(first, second);
  for (const Triangle& t : orders(first)) {
    for (const Triangle& u : orders(second)) {
      check(t, u);
      check(u, t);
    }
  }
}

/// A triangle of the plane z = 0 in another plane: x and y become steps along two vectors.
class Plane {
 public:
  Plane(Point origin, Point along_x, Point along_y)
      : origin_(std::move(origin)), x_(std::move(along_x)), y_(std::move(along_y)) {}
  Triangle operator()(const Triangle& t) const { return {at(t.a), at(t.b), at(t.c)}; }

 private:
  Point origin_, x_, y_;
  Point at(const Point& p) const { return origin_ + p.x() * x_ + p.y() * y_; }
};

}  // namespace

TEST_CASE("one plane contains six points or not") {
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}}, {{5, 7, 4}, {-3, 2, 2}, {9, 0, 5}});
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}}, {{5, 7, 5}, {9, 7, 6}, {5, 2, 5}});
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}}, {{5, 7, 4}, {-3, 2, 1}, {9, 0, 7}});
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}}, {{5, 7, 4}, {-3, 2, 2}, {9, 0, 6}});
  const Triangle large{{-1999, -1999, 3}, {1996, -1997, 1593}, {9, 1999, -761}};
  check_plane(large, {{-1234, -228, -385}, large.b, large.c});
  check_plane({{1, 2, 3}, {3, 4, 5}, {2, 3, 4}}, {{5, 7, 4}, {-3, 2, 2}, {9, 0, 5}});
  check_plane({{5, 7, 4}, {-3, 2, 2}, {9, 0, 5}}, {{1, 2, 3}, {3, 4, 5}, {2, 3, 4}});
  check_plane({{1, 1, 1}, {4, 4, 4}, {2, 2, 2}}, {{5, 1, 0}, {3, 9, 6}, {5, 1, 0}});
  check_plane({{1, 1, 1}, {4, 4, 4}, {2, 2, 2}}, {{3, 1, 2}, {1, 3, 2}, {3, 1, 2}});
  check_plane({{7, 1, 3}, {7, 1, 3}, {7, 1, 3}}, {{3, 1, 2}, {1, 3, 2}, {3, 1, 2}});
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}}, {{5, 7, 4}, {5, 7, 4}, {5, 7, 4}});
  check_plane({{1, 2, 3}, {5, 2, 4}, {1, 7, 3}}, {{5, 7, 5}, {5, 7, 5}, {5, 7, 5}});
  check_plane({{kFar, -kFar, kFar}, {-kFar, kFar, kFar}, {kFar, kFar, -kFar}},
              {{kFar, kFar, 1 - kFar}, {kFar, -kFar, kFar}, {-kFar, kFar, kFar}});
}

TEST_CASE("triangles in one plane meet or are apart") {
  check({{-1, 0, 0}, {-3, 2, 0}, {0, 1, 0}}, {{-1, 1, 0}, {0, 0, 0}, {0, -1, 0}});
  check({{0, -3, 0}, {2, -2, 0}, {0, -2, 0}}, {{-1, 0, 0}, {3, 1, 0}, {0, -1, 0}});
  check({{0, 0, 0}, {-1, 1, 0}, {0, 1, 0}}, {{1, 1, 0}, {1, -3, 0}, {3, -1, 0}});
  check({{0, 1, -1}, {-2, 2, -2}, {1, 0, 0}}, {{1, 1, -1}, {0, -1, 1}, {-1, 0, 0}});
  check({{-1, 2, -2}, {-1, 3, -2}, {0, 0, -1}}, {{2, -1, 1}, {-1, -3, -2}, {1, -2, 0}});
  check({{0, 0, 0}, {2, -1, 0}, {2, 0, 0}}, {{-1, 0, 0}, {-2, 0, 0}, {1, -1, 0}});
  check({{-1, 1, 1}, {-1, 0, 2}, {1, 1, -1}}, {{4, 0, -3}, {0, 2, -1}, {-3, 2, 2}});
  check_all_orders({{0, 0, 5}, {90, 20, 5}, {30, 80, 5}}, {{5, 50, 5}, {95, 60, 5}, {40, -9, 5}});
  check_all_orders({{0, 0, 5}, {90, 20, 5}, {30, 80, 5}}, {{5, 50, 5}, {25, 90, 5}, {-9, 99, 5}});
}

TEST_CASE("one triangle may be inside the other") {
  check({{0, -3, 1}, {-1, 0, -1}, {0, 1, 1}}, {{3, 6, 7}, {0, -5, 1}, {-2, 1, -3}});
  check({{-7, 4, 4}, {-2, -1, -1}, {2, 0, -5}}, {{-2, 1, -1}, {1, 0, -4}, {-1, 1, -2}});
  check({{-3, -2, 1}, {2, -4, 1}, {1, 1, 1}}, {{0, -1, 1}, {-2, -2, 1}, {0, 0, 1}});
  check({{-3, -2, 1}, {1, 1, 1}, {2, -4, 1}}, {{0, -1, 1}, {-2, -2, 1}, {0, 0, 1}});
  check_all_orders({{0, 0, 5}, {90, 20, 5}, {30, 80, 5}}, {{20, 20, 5}, {45, 25, 5}, {33, 41, 5}});
  check_all_orders({{0, 0, 5}, {90, 20, 5}, {30, 80, 5}}, {{80, 80, 5}, {95, 25, 5}, {73, 71, 5}});
  check_all_orders({{0, 0, 5}, {1, 2, 5}, {2, 1, 5}}, {{-9, -9, 5}, {9, -9, 5}, {0, 99, 5}});
  check({{0, 0, 5}, {30, 60, 5}, {60, 30, 5}}, {{29, 29, 5}, {29, 31, 5}, {31, 31, 5}});
}

TEST_CASE("touching at a vertex or along an edge counts") {
  check({{0, 0, 3}, {-1, 1, 4}, {0, 0, -1}}, {{1, -1, 1}, {0, 0, -1}, {2, -2, -1}});
  const Triangle ground{{0, 0, 5}, {80, 20, 5}, {20, 80, 5}};
  for (const Point& at : {Point(40, 10, 5), Point(50, 50, 5), Point(5, 20, 5), Point(80, 20, 5)})
    check_all_orders(ground, {at, at + 2 * (at - Point(30, 35, 5)), {500, -300 + at.x(), 5}});
  check_all_orders(ground, {{40, 10, 5}, {60, 15, 5}, {70, -9, 5}});
  check_all_orders(ground, {{40, 10, 5}, {120, 30, 5}, {70, -9, 5}});
  check_all_orders(ground, {{80, 20, 5}, {120, 30, 5}, {170, -9, 5}});
  check_all_orders(ground, {{84, 21, 5}, {120, 30, 5}, {170, -9, 5}});
  check_all_orders(ground, {{40, 9, 5}, {60, 14, 5}, {70, -9, 5}});
  check_all_orders(ground, {{0, 0, 5}, {20, 80, 5}, {-9, 70, 5}});
  check_all_orders(ground, ground);
}

TEST_CASE("the plane may be vertical or oblique") {
  check({{0, 0, 0}, {-4, 0, 0}, {1, 0, 1}}, {{1, 0, 2}, {-2, 0, 1}, {-1, 0, 3}});
  for (const Plane& in :
       {Plane({1, 2, 3}, {1, 0, 0}, {0, 0, 1}), Plane({7, 2, 3}, {0, 0, 1}, {0, 1, 0}),
        Plane({0, 4, -9}, {2, 1, 0}, {0, 0, 1}), Plane({0, 4, -9}, {0, 3, 1}, {4, 0, 1}),
        Plane({-5, 0, 0}, {1, 1, 1}, {-1, 2, 0})}) {
    const Triangle first = in({{0, 0, 0}, {9, 2, 0}, {3, 8, 0}});
    check_all_orders(first, in({{-1, 5, 0}, {9, 6, 0}, {4, -2, 0}}));
    check_all_orders(first, in({{-1, 5, 0}, {2, 9, 0}, {1, 8, 0}}));
    check_all_orders(first, in({{3, 2, 0}, {5, 3, 0}, {4, 5, 0}}));
    check_all_orders(first, in({{9, 2, 0}, {12, 3, 0}, {11, 0, 0}}));
  }
}

TEST_CASE("a triangle without area is a segment or a point") {
  check({{0, -4, 0}, {0, -1, 0}, {0, -1, 0}}, {{2, -1, -2}, {-1, -2, 1}, {0, 0, 0}});
  check({{-2, 1, 2}, {3, -3, 1}, {1, 1, -1}}, {{-1, 1, 1}, {0, 1, 0}, {-1, 1, 1}});
  check({{-1, -1, 2}, {-1, 0, -1}, {-1, 0, -1}}, {{0, -1, 0}, {0, -1, 0}, {0, -1, 0}});
  const auto point = [](const Point& at) { return Triangle{at, at, at}; };
  check_all_orders({{0, 0, 5}, {1, 2, 5}, {2, 1, 5}}, point({1, 1, 5}));
  check_all_orders({{0, 0, 5}, {3, 0, 5}, {2, 1, 5}}, point({1, 1, 5}));
  for (const Plane& in :
       {Plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), Plane({7, 2, 3}, {0, 0, 1}, {0, 1, 0}),
        Plane({-5, 0, 0}, {1, 1, 1}, {-1, 2, 0})}) {
    const Triangle large = in({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}});
    for (const Point& at :
         {Point(2, 3, 0), Point(4, 0, 0), Point(8, 0, 0), Point(5, 5, 0), Point(9, 0, 0)}) {
      const Triangle there = point(in({at, at, at}).a);
      check_all_orders(large, there);
      check_all_orders(in({{2, 3, 0}, {12, 8, 0}, {6, 5, 0}}), there);
      check_all_orders(point(in({{5, 5, 0}, {0, 0, 0}, {0, 0, 0}}).a), there);
    }
    check_all_orders(large, in({{2, 3, 0}, {12, 8, 0}, {6, 5, 0}}));
    check_all_orders(large, in({{-2, 3, 0}, {18, 8, 0}, {-2, 3, 0}}));
    check_all_orders(large, in({{-2, 3, 0}, {-1, 8, 0}, {-1, 8, 0}}));
    check_all_orders(large, in({{10, 0, 0}, {13, 0, 0}, {12, 0, 0}}));
    const Triangle line = in({{0, 0, 0}, {8, 4, 0}, {2, 1, 0}});
    check_all_orders(line, in({{4, 2, 0}, {12, 6, 0}, {10, 5, 0}}));
    check_all_orders(line, in({{8, 4, 0}, {12, 6, 0}, {10, 5, 0}}));
    check_all_orders(line, in({{10, 5, 0}, {14, 7, 0}, {12, 6, 0}}));
    check_all_orders(line, in({{1, 5, 0}, {5, 1, 0}, {1, 5, 0}}));
    check_all_orders(line, in({{1, 5, 0}, {2, 4, 0}, {1, 5, 0}}));
  }
}

TEST_CASE("a thin triangle has an area") {
  for (const Plane& in :
       {Plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), Plane({0, 0, 0}, {0, 0, 1}, {1, 0, 0})}) {
    const Triangle above = in({{-kFar, -kFar, 0}, {kFar, kFar - 1, 0}, {-kFar, kFar, 0}});
    check_all_orders(above, in({{kFar - 1, kFar - 2, 0}, {kFar, -kFar, 0}, {kFar / 2, -kFar, 0}}));
    check_all_orders(above, in({{kFar, kFar - 1, 0}, {kFar, -kFar, 0}, {kFar / 2, -kFar, 0}}));
    const Triangle thin = in({{-kFar, -kFar, 0}, {kFar, kFar - 1, 0}, {1 - kFar, 1 - kFar, 0}});
    check_all_orders(thin, in({{-kFar, kFar, 0}, {3, 7, 0}, {0, 0, 0}}));
    check_all_orders(thin, in({{-kFar, kFar, 0}, {kFar, 7 - kFar, 0}, {0, kFar, 0}}));
  }
}

TEST_CASE("random triangles in one plane agree with integers") {
  generators::Random random(seed(0));
  const auto whole = [](const Triangle& first, const Triangle& second) {
    return all_whole(first, second, kFar);
  };
  const auto judged = [&](const Triangle& first, const Triangle& second) {
    return whole(first, second) && in_one_plane(first, second);
  };
  for (int asked = 0; asked < 1500;) {
    const int size = asked % 3 == 0 ? 40 : 2 + asked % 4;
    const auto vector = [&](int limit) {
      const double x = random.integer(-limit, limit), y = random.integer(-limit, limit);
      return Point(x, y, random.integer(-limit, limit));
    };
    const Point along_x = vector(asked % 3 == 0 ? 20 : 2), along_y = vector(2);
    const Plane in(vector(100), along_x, along_y);
    const auto triangle = [&] {
      const Point a = vector(size), b = vector(size);
      return in({a, random.chance(0.9) ? b : a, vector(size)});
    };
    const Triangle first = triangle(), second = triangle();
    if (!judged(first, second)) continue;
    ++asked;
    shrinkable(check, judged, first, second);
    shrinkable(check_plane, whole, first, second);
    const Triangle moved{second.a, second.b, second.c + vector(1)};
    if (whole(first, moved)) shrinkable(check_plane, whole, first, moved);
  }
}
