// A triangle and a box: against the box's surface, in integers and in exact arithmetic.
#include <06_triangle_pairs/drawn.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <contact/exact.hpp>
#include <contact/triangle_box.hpp>
#include <limits>
#include <map>
#include <string>
#include <support/generators.hpp>

namespace triangle_box_test {
namespace {

using contact::Aabb;
using contact::Triangle;
using contact::triangle_meets_box;
using contact::triangle_meets_box_rounded;
using drawn::whole;
using generators::Random;
using Point = contact::Vector3<double>;

/// Two triangles for each face.
std::array<Triangle<double>, 12> surface(const Aabb<double>& box) {
  std::array<Triangle<double>, 12> triangles;
  std::size_t n = 0;
  for (int k = 0; k < 3; ++k) {
    for (const double x : {box.low[k], box.high[k]}) {
      const auto corner = [&](double y, double z) {
        Point p;
        p[k] = x;
        p[(k + 1) % 3] = y;
        p[(k + 2) % 3] = z;
        return p;
      };
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Point a = corner(box.low[i], box.low[j]), b = corner(box.high[i], box.low[j]),
                  c = corner(box.high[i], box.high[j]), d = corner(box.low[i], box.high[j]);
      triangles[n++] = {a, b, c};
      triangles[n++] = {a, c, d};
    }
  }
  return triangles;
}

/// A triangle that meets a box has a vertex in it or meets its surface.
template <class Meet>
bool truth(const Triangle<double>& t, const Aabb<double>& box, const Meet& meet) {
  bool inside = true;
  for (int k = 0; k < 3; ++k) inside = inside && box.low[k] <= t.a[k] && t.a[k] <= box.high[k];
  if (inside) return true;
  for (const Triangle<double>& face : surface(box)) {
    if (meet(t, face)) return true;
  }
  return false;
}
bool truth_in_integers(const Triangle<double>& t, const Aabb<double>& box) {
  return truth(t, box, [](const auto& s, const auto& f) {
    return pair_truth::meet_in_integers<double>(s, f);
  });
}
bool truth_exactly(const Triangle<double>& t, const Aabb<double>& box) {
  return truth(t, box,
               [](const auto& s, const auto& f) { return pair_truth::meet_exactly<double>(s, f); });
}

struct Case {
  Triangle<double> triangle;
  Aabb<double> box;
};
Aabb<double> box_between(const Point& p, const Point& q) { return {p.cwiseMin(q), p.cwiseMax(q)}; }

/// On a small grid: coincidences of every kind, flat boxes, triangles without area.
Case on_grid(Random& random) {
  const int size = random.integer(1, 4);
  const Triangle<double> t{whole(random, size), whole(random, size), whole(random, size)};
  const Point p = whole(random, size), q = whole(random, size);
  return {t, box_between(p, q)};
}
/// A corner of the box is in the triangle, and the box is on one side of its plane.
Case at_a_corner(Random& random, int size) {
  const Point x = whole(random, size), u = whole(random, size), v = whole(random, size);
  const Triangle<double> t{x + u, x + v, x - (u + v)};
  const Point n = u.cross(v);
  Point away = whole(random, size).cwiseAbs();
  for (int k = 0; k < 3; ++k) {
    if (n[k] < 0) away[k] = -away[k];
  }
  return {t, box_between(x, Point(x + away))};
}
/// An edge of the box and an edge of the triangle have a point in common.
Case at_an_edge(Random& random, int size) {
  const Point x = whole(random, size), u = whole(random, size);
  const Triangle<double> t{x - u, x + random.integer(1, 2) * u, whole(random, size)};
  Point p = x, q = whole(random, size);
  p[random.integer(0, 2)] = random.integer(-size, size);
  return {t, box_between(p, q)};
}
/// One of these with a coordinate of a vertex moved by 1.
Case a_step_off(Random& random, int size) {
  Case made = random.chance(0.5) ? at_a_corner(random, size) : at_an_edge(random, size);
  const double by = random.chance(0.5) ? 1 : -1;
  made.triangle.b[random.integer(0, 2)] += by;
  return made;
}
/// The same decision with each axis scaled and moved.
Case moved(Random& random, const Case& c) {
  const Point scale{double(random.integer(1, 1 << 20)), double(random.integer(1, 1 << 20)),
                    double(random.integer(1, 1 << 20))};
  const Point offset = whole(random, 1 << 30);
  const auto map = [&](const Point& p) { return Point(scale.cwiseProduct(p) + offset); };
  return {{map(c.triangle.a), map(c.triangle.b), map(c.triangle.c)},
          {map(c.box.low), map(c.box.high)}};
}

Case drawn(Random& random, int i) {
  switch (i % 5) {
    case 0:
      return on_grid(random);
    case 1:
      return moved(random, on_grid(random));
    case 2:
      return at_a_corner(random, 1 << 20);
    case 3:
      return at_an_edge(random, 1 << 30);
    default:
      return a_step_off(random, 1 << random.integer(2, 20));
  }
}

Aabb<float> in_float(const Aabb<double>& box) {
  return {generators::rounded<float>(box.low), generators::rounded<float>(box.high)};
}

TEST_CASE("a triangle meets a box as it meets the box's surface or has a vertex inside") {
  Random random(1);
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(200000); ++i) {
    const Case c = drawn(random, i);
    const bool met = triangle_meets_box(c.triangle, c.box);
    ++seen[met];
    INFO("case " << i);
    REQUIRE(met == truth_in_integers(c.triangle, c.box));
  }
  CHECK(seen[true] > generators::tried(40000));
  CHECK(seen[false] > generators::tried(40000));
}

TEST_CASE("all triangles of a small grid at all its boxes are decided without error") {
  // Vertices at 0, 1 and 2, boxes from 0 or 1 to 1 or 2, one of them flat.
  const auto point = [](int i) {
    const int row = i / 3 % 3, layer = i / 9;
    return Point{double(i % 3), double(row), double(layer)};
  };
  const std::array<Aabb<double>, 4> boxes{
      Aabb<double>{Point(0, 0, 0), Point(1, 1, 1)}, Aabb<double>{Point(0, 0, 1), Point(1, 2, 1)},
      Aabb<double>{Point(1, 0, 1), Point(1, 2, 1)}, Aabb<double>{Point(1, 1, 1), Point(1, 1, 1)}};
  const int step = generators::sanitized ? 5 : 1;
  for (int a = 0; a < 27; a += step) {
    for (int b = a; b < 27; ++b) {
      for (int c = b; c < 27; ++c) {
        const Triangle<double> t{point(a), point(b), point(c)};
        for (const Aabb<double>& box : boxes) {
          REQUIRE(triangle_meets_box(t, box) == truth_in_integers(t, box));
        }
      }
    }
  }
}

TEST_CASE("a triangle of doubles meets a box as exact arithmetic says") {
  Random random(2);
  for (int i = 0; i < generators::tried(2000); ++i) {
    Case c = drawn(random, i);
    const auto disturb = [&random](double& x) {
      x = x / 3 + random.uniform(-1, 1);
      if (random.chance(0.5)) x = std::nextafter(x, random.uniform(-1, 1) * 1e300);
    };
    for (auto* v : {&c.triangle.a, &c.triangle.b, &c.triangle.c}) {
      for (double& x : *v) disturb(x);
    }
    c.box = box_between(c.triangle.a, Point(c.box.high / 3));
    if (i % 2 == 0) c.triangle.a = c.triangle.b;
    INFO("case " << i);
    REQUIRE(triangle_meets_box(c.triangle, c.box) == truth_exactly(c.triangle, c.box));
  }
}

TEST_CASE("the thirteen axes in exact arithmetic say the same of bit patterns of any size") {
  using contact::Exact;
  Random random(3);
  const auto exact = [](const Point& p) {
    return contact::Vector3<Exact>(Exact(p.x()), Exact(p.y()), Exact(p.z()));
  };
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(1500); ++i) {
    Case c{{generators::any_vector(random), generators::any_vector(random),
            generators::any_vector(random)},
           {}};
    c.box = box_between(generators::any_vector(random), generators::any_vector(random));
    const bool met = triangle_meets_box(c.triangle, c.box);
    ++seen[met];
    INFO("case " << i);
    REQUIRE(met == triangle_meets_box_rounded<Exact>(
                       {exact(c.triangle.a), exact(c.triangle.b), exact(c.triangle.c)},
                       {exact(c.box.low), exact(c.box.high)}));
  }
  CHECK(seen[true] > 0);
  CHECK(seen[false] > 0);
}

TEST_CASE("the answer of triangle and box is the same in every order and in both types") {
  Random random(4);
  for (int i = 0; i < generators::tried(20000); ++i) {
    const Case c = on_grid(random);
    const auto& [a, b, e] = c.triangle;
    const bool met = triangle_meets_box(c.triangle, c.box);
    INFO("case " << i);
    for (const Triangle<double>& t : {Triangle<double>{b, e, a}, {e, a, b}, {e, b, a}, {a, e, b}}) {
      REQUIRE(triangle_meets_box(t, c.box) == met);
    }
    REQUIRE(triangle_meets_box(generators::rounded<float>(c.triangle), in_float(c.box)) == met);
    // Small whole numbers round nowhere.
    REQUIRE(triangle_meets_box_rounded(c.triangle, c.box) == met);
    REQUIRE(triangle_meets_box_rounded(generators::rounded<float>(c.triangle), in_float(c.box)) ==
            met);
  }
}

TEST_CASE("at the largest and the smallest scale a corner on the triangle is found") {
  for (const double scale : {0x1p-1074, 1.0, 0x1p1021}) {
    INFO("scale " << scale);
    const auto at = [scale](double x, double y, double z) {
      return Point(x * scale, y * scale, z * scale);
    };
    // x + y + z = 3 contains the corner (1, 1, 1).
    const Triangle<double> t{at(3, 0, 0), at(0, 3, 0), at(0, 0, 3)};
    CHECK(triangle_meets_box(t, Aabb<double>{at(0, 0, 0), at(1, 1, 1)}));
    CHECK(triangle_meets_box(t, Aabb<double>{at(1, 1, 1), at(3, 3, 3)}));
    CHECK_FALSE(triangle_meets_box(t, Aabb<double>{at(1, 1, 2), at(3, 3, 3)}));
  }
}

TEST_CASE("a triangle or a box that is not finite meets nothing") {
  const Triangle<double> t{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  const Aabb<double> box{Point(-1, -1, -1), Point(1, 1, 1)};
  REQUIRE(triangle_meets_box(t, box));
  for (const double bad :
       {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    for (int k = 0; k < 3; ++k) {
      Triangle<double> broken = t;
      broken.b[k] = bad;
      CHECK_FALSE(triangle_meets_box(broken, box));
      Aabb<double> endless = box;
      (bad < 0 ? endless.low : endless.high)[k] = bad;
      CHECK_FALSE(triangle_meets_box(t, endless));
    }
  }
}

}  // namespace
}  // namespace triangle_box_test
