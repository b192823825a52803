// manifold_2d.hpp against closed forms and fractions.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/convex_polygon.hpp>
#include <contact/manifold_2d.hpp>
#include <limits>
#include <vector>

#include "09_separating_planes/random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace manifold_2d_test {
namespace {

using contact::edge_feature;
using contact::PointFeatures;
using contact::Vector2;
using contact::vertex_feature;
using generators::Random;
using generators::tried;
using oracle::Rational;

using P = contact::Polygon<double>;
using V2 = Vector2<double>;
using Exactly = std::vector<Vector2<Rational>>;

P rectangle(double left, double bottom, double right, double top) {
  return {V2(left, bottom), V2(right, bottom), V2(right, top), V2(left, top)};
}

P moved(P polygon, const V2& by) {
  for (V2& p : polygon) p += by;
  return polygon;
}

P rotated(P polygon, const V2& turn) {
  for (V2& p : polygon)
    p = V2(turn.x() * p.x() - turn.y() * p.y(), turn.y() * p.x() + turn.x() * p.y());
  return polygon;
}

/// A convex polygon with its vertices on an ellipse, counter-clockwise.
P polygon(Random& random) {
  const int count = random.integer(3, 7);
  const double wide = random.uniform(0.5, 2);
  const double high = random.uniform(0.5, 2);
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    angles.push_back((i + random.uniform(0.1, 0.9)) * 2 * std::acos(-1.0) / count);
  }
  P made;
  for (const double angle : angles)
    made.emplace_back(wide * std::cos(angle), high * std::sin(angle));
  return made;
}

Exactly exactly(const P& polygon) {
  Exactly made;
  for (const V2& p : polygon) made.emplace_back(oracle::exact(p.x()), oracle::exact(p.y()));
  return made;
}

/// The squared distance of a point and a convex polygon, exactly.
Rational squared_distance(const Vector2<Rational>& p, const Exactly& polygon) {
  bool inside = true;
  Rational least = -1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<Rational> a = polygon[i];
    const Vector2<Rational> d = polygon[(i + 1) % polygon.size()] - a;
    const Vector2<Rational> w = p - a;
    if (d.x() * w.y() - d.y() * w.x() < 0) inside = false;
    Rational t = d.dot(w) / d.dot(d);
    t = std::max(Rational(0), std::min(Rational(1), t));
    const Vector2<Rational> away = w - d * t;
    const Rational squared = away.dot(away);
    if (least < 0 || squared < least) least = squared;
  }
  return inside ? Rational(0) : least;
}

/// The signed distance of two convex polygons: of disjoint ones, or else minus the least depth.
double signed_distance(const P& a, const P& b) {
  const Exactly exact_a = exactly(a);
  const Exactly exact_b = exactly(b);
  double separation = -std::numeric_limits<double>::infinity();
  for (const bool of_a : {true, false}) {
    const Exactly& edges = of_a ? exact_a : exact_b;
    const Exactly& points = of_a ? exact_b : exact_a;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Vector2<Rational> d = edges[(i + 1) % edges.size()] - edges[i];
      Rational least = 0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Vector2<Rational> w = points[k] - edges[i];
        const Rational above = d.y() * w.x() - d.x() * w.y();
        if (k == 0 || above < least) least = above;
      }
      const double length = std::sqrt(oracle::nearest(Rational(d.dot(d))));
      separation = std::max(separation, oracle::nearest(least) / length);
    }
  }
  if (separation <= 0) return separation;
  Rational squared = -1;
  for (const auto& p : exact_a) {
    const Rational here = squared_distance(p, exact_b);
    if (squared < 0 || here < squared) squared = here;
  }
  for (const auto& p : exact_b) squared = std::min(squared, squared_distance(p, exact_a));
  return std::sqrt(oracle::nearest(squared));
}

bool same(const contact::ContactManifold2d<double>& one,
          const contact::ContactManifold2d<double>& other) {
  if (one.normal != other.normal || one.points.size() != other.points.size()) return false;
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    if (one.points[i].point != other.points[i].point) return false;
    if (one.points[i].distance != other.points[i].distance) return false;
    if (one.points[i].features != other.points[i].features) return false;
  }
  return true;
}

/// Two polygons near contact: A above B, at a distance of −0.1 to 0.1 or touching.
struct Pair {
  P a, b;
  double margin;
};
Pair near_pair(Random& random) {
  const P one = polygon(random);
  const P other = polygon(random);
  const double angle = random.uniform(0, 6);
  const P a = rotated(one, V2(std::cos(angle), std::sin(angle)));
  const double direction = random.uniform(0, 6);
  const V2 n(std::cos(direction), std::sin(direction));
  const V2 side = V2(-n.y(), n.x()) * random.uniform(-1, 1);
  double low = 1e9;
  double high = -1e9;
  for (const V2& p : a) low = std::min(low, n.dot(p));
  for (const V2& p : other) high = std::max(high, n.dot(p));
  const double gap = random.chance(0.2) ? 0 : random.uniform(-0.1, 0.1);
  return {moved(a, n * (high - low + gap) + side), other, random.uniform(0, 0.1)};
}

}  // namespace

TEST_CASE("a rectangle on a rectangle: the ends of the overlap, in closed form") {
  Random random(1821);
  for (int i = 0; i < tried(2000); ++i) {
    const int left = random.integer(-4, 2);
    const int right = left + random.integer(1, 5);
    const double depth = random.integer(-1, 2) / 16.0;
    const P a = rectangle(left, 2 - depth, right, 5);
    const P b = rectangle(-2, 0, 2, 2);
    const double first = std::max(left, -2);
    const double last = std::min(right, 2);
    if (last - first <= 0.125) continue;
    const auto manifold = contact::contact_manifold_2d(a, b, 0.0);
    if (depth < 0) {
      CHECK(manifold.points.empty());
      continue;
    }
    CHECK(manifold.normal == V2(0, 1));
    REQUIRE(manifold.points.size() == 2);
    std::vector<double> x{manifold.points[0].point.x(), manifold.points[1].point.x()};
    std::sort(x.begin(), x.end());
    CHECK(x[0] == first);
    CHECK(x[1] == last);
    for (const auto& p : manifold.points) {
      CHECK(p.point.y() == 2 - depth / 2);
      CHECK(p.distance == -depth);
      const int vertex = p.point.x() == left ? 0 : 1;  // of A, unless it is one of B's
      if (left > -2 && right < 2) {
        CHECK(p.features == PointFeatures{vertex_feature(vertex), edge_feature(2, 3)});
      }
    }
  }
}

TEST_CASE("two polygons have a point exactly if they are within the margin, midway between them") {
  Random random(1822);
  int one = 0;
  int two = 0;
  for (int i = 0; i < tried(1500); ++i) {
    const Pair pair = near_pair(random);
    const auto manifold = contact::contact_manifold_2d(pair.a, pair.b, pair.margin);
    const double right = signed_distance(pair.a, pair.b);
    if (right > pair.margin + 1e-14) CHECK(manifold.points.empty());
    if (right < pair.margin - 1e-14) CHECK_FALSE(manifold.points.empty());
    if (manifold.points.empty()) continue;
    (manifold.points.size() == 1 ? one : two)++;
    CHECK(std::abs(manifold.normal.dot(manifold.normal) - 1) <= 1e-15);
    double least = 1;
    const Exactly a = exactly(pair.a);
    const Exactly b = exactly(pair.b);
    for (const auto& p : manifold.points) {
      CHECK(p.distance <= pair.margin);
      least = std::min(least, p.distance);
      const V2 half = manifold.normal * (p.distance / 2);
      const Exactly ends = exactly({V2(p.point + half), V2(p.point - half)});
      CHECK(oracle::nearest(squared_distance(ends[0], a)) <= 1e-28);
      CHECK(oracle::nearest(squared_distance(ends[1], b)) <= 1e-28);
    }
    CHECK(least >= right - 1e-14);
    CHECK(least <= right + 0x1p-10 * 4);
    const P apart = moved(pair.a, V2(manifold.normal * -least));
    CHECK(std::abs(signed_distance(apart, pair.b)) <= 0x1p-10 * 4);
  }
  CHECK(one > tried(100));
  CHECK(two > tried(40));
}

TEST_CASE(
    "exchanging two polygons gives the opposite normal and the same points, to the last bit") {
  Random random(1823);
  for (int i = 0; i < tried(10000); ++i) {
    const Pair pair = near_pair(random);
    const auto manifold = contact::contact_manifold_2d(pair.a, pair.b, pair.margin);
    const auto back = contact::contact_manifold_2d(pair.b, pair.a, pair.margin);
    CHECK(same(exchanged(back), manifold));
  }
}

TEST_CASE("scaling two polygons by a power of two scales their manifold, to the last bit") {
  Random random(1824);
  for (int i = 0; i < tried(2000); ++i) {
    const Pair pair = near_pair(random);
    const auto manifold = contact::contact_manifold_2d(pair.a, pair.b, pair.margin);
    for (const int power : {-498, -150, 150, 498}) {
      const auto scaled = [&](const P& p) {
        return contact::detail::times_power_of_two<double>(p, power);
      };
      auto there = contact::contact_manifold_2d(scaled(pair.a), scaled(pair.b),
                                                std::ldexp(pair.margin, power));
      for (auto& p : there.points) {
        p.point = V2(std::ldexp(p.point.x(), -power), std::ldexp(p.point.y(), -power));
        p.distance = std::ldexp(p.distance, -power);
      }
      CHECK(same(there, manifold));
    }
  }
}

TEST_CASE("a vertex above a vertex: the normal leads from one to the other") {
  const P b = rectangle(-1, -1, 0, 0);
  const P a = rectangle(0.003, 0.004, 1, 1);
  CHECK(contact::contact_manifold_2d(a, b, 0.0049).points.empty());
  const auto manifold = contact::contact_manifold_2d(a, b, 0.0051);
  REQUIRE(manifold.points.size() == 1);
  CHECK((manifold.normal - V2(0.6, 0.8)).norm() <= 1e-15);
  CHECK(std::abs(manifold.points[0].distance - 0.005) <= 1e-16);
  CHECK(manifold.points[0].features == PointFeatures{vertex_feature(0), vertex_feature(2)});
}

TEST_CASE("a vertex on a vertex: the first edge of largest separation gives the normal") {
  const P b = rectangle(-1, -1, 0, 0);
  const P a = rectangle(0, 0, 1, 1);
  const auto manifold = contact::contact_manifold_2d(a, b, 0.0);
  REQUIRE(manifold.points.size() == 1);
  CHECK(manifold.normal == V2(1, 0));
  CHECK(manifold.points[0].point == V2(0, 0));
  CHECK(manifold.points[0].distance == 0);
  CHECK(same(exchanged(contact::contact_manifold_2d(a, b, 0.0)),
             contact::contact_manifold_2d(b, a, 0.0)));
}

TEST_CASE("a rectangle that is rotated by rounding keeps two points, with the same features") {
  const P table = rectangle(-3, -1, 3, 0);
  const P flat = rectangle(-1, 0, 1, 1);
  const auto at_rest = contact::contact_manifold_2d(flat, table, 1e-6);
  REQUIRE(at_rest.points.size() == 2);
  for (const double sine : {1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8}) {
    const auto tilted = contact::contact_manifold_2d(rotated(flat, V2(1, sine)), table, 1e-6);
    REQUIRE(tilted.points.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(tilted.points[i].features == at_rest.points[i].features);
      CHECK(std::abs(tilted.points[i].distance - sine * tilted.points[i].point.x()) <= 1e-15);
    }
    // It overhangs, so the lowest vertex is not over the table.
    const P over = moved(rotated(flat, V2(1, -std::abs(sine))), V2(2.5, 0));
    CHECK(contact::contact_manifold_2d(over, table, 1e-6).points.size() == 2);
  }
}

TEST_CASE("the features of a point do not depend on which polygon has the reference edge") {
  const P table = rectangle(-3, -1, 3, 0);
  const P narrow = rectangle(-1, 0, 1, 1);
  const P wide = rectangle(-5, 0, 5, 1);
  const P half = rectangle(0, 0, 5, 1);
  for (const double sine : {0x1p-30, -0x1p-30}) {
    for (const P& above : {narrow, wide, half}) {
      const auto one = contact::contact_manifold_2d(rotated(above, V2(1, sine)), table, 1e-6);
      const auto other = contact::contact_manifold_2d(above, rotated(table, V2(1, sine)), 1e-6);
      REQUIRE(one.points.size() == 2);
      REQUIRE(other.points.size() == 2);
      const auto has = [&](const PointFeatures& f) {
        return other.points[0].features == f || other.points[1].features == f;
      };
      CHECK(has(one.points[0].features));
      CHECK(has(one.points[1].features));
    }
  }
}

namespace {

/// The polygon with vertices in the middle of its sides, up to rounding.
P with_middles(Random& random, const P& polygon) {
  P made;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const V2 next = polygon[(i + 1) % polygon.size()];
    made.push_back(polygon[i]);
    if (random.chance(0.2)) made.push_back(polygon[i]);  // twice
    const double part = random.uniform(0.1, 0.9);
    if (random.chance(0.7)) made.emplace_back(polygon[i] + (next - polygon[i]) * part);
  }
  const int first = random.integer(0, int(made.size()) - 1);
  std::rotate(made.begin(), made.begin() + first, made.end());
  return made;
}

}  // namespace

TEST_CASE(
    "a box on ground with a vertex in the middle of its side has the points of its own ends") {
  for (const double depth : {1.0, 1000.0}) {
    const P ground{V2(-10, -depth), V2(10, -depth), V2(10, 0), V2(0, 0), V2(-10, 0)};
    for (const double left : {-5.0, -7.0, 2.0, -1.0}) {
      for (const double width : {2.0, 4.0, 8.0}) {
        const double right = std::min(left + width, 10.0);
        const P box = rectangle(left, 0, right, 2);
        const auto manifold = contact::contact_manifold_2d(box, ground, 0.0);
        CHECK(manifold.normal == V2(0, 1));
        REQUIRE(manifold.points.size() == 2);
        const double x = manifold.points[0].point.x();
        const double y = manifold.points[1].point.x();
        CHECK(std::min(x, y) == left);
        CHECK(std::max(x, y) == right);
        for (const auto& p : manifold.points) {
          CHECK(p.distance == 0);
          CHECK(p.features ==
                PointFeatures{vertex_feature(p.point.x() == left ? 0 : 1), edge_feature(2, 4)});
        }
      }
    }
  }
}

TEST_CASE("vertices in the middle of sides do not change the manifold, up to rounding") {
  Random random(1826);
  int two = 0;
  for (int i = 0; i < tried(3000); ++i) {
    Pair pair = near_pair(random);
    if (random.chance(0.5)) {  // a side on a side
      const V2 turn = V2(pair.b[1] - pair.b[0]).normalized();
      pair.b = rotated(rectangle(-2, -1, 2, 0), turn);
      const double left = random.uniform(-3, 1);
      pair.a = rotated(rectangle(left, 0x1p-20, left + random.uniform(0.5, 3), 1), turn);
    }
    const auto right = contact::contact_manifold_2d(pair.a, pair.b, pair.margin);
    const P a = with_middles(random, pair.a);
    const P b = with_middles(random, pair.b);
    const auto got = contact::contact_manifold_2d(a, b, pair.margin);
    if (got.points.size() != right.points.size()) {
      // Only where a distance is the margin, or two separations are equal, up to rounding.
      const double least = signed_distance(pair.a, pair.b);
      CHECK(std::abs(least - pair.margin) <= 0x1p-8);
      continue;
    }
    two += got.points.size() == 2 ? 1 : 0;
    const bool flipped = got.normal.dot(right.normal) < 0.999;
    CHECK_FALSE(flipped);
    for (const auto& p : right.points) {
      double nearest = 1;
      for (const auto& q : got.points) {
        nearest = std::min(nearest, (p.point - q.point).norm() + std::abs(p.distance - q.distance));
      }
      CHECK(nearest <= 1e-12);
    }
  }
  CHECK(two > tried(300));
}

TEST_CASE("polygons that are none have no contact") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const P good = rectangle(-1, -1, 1, 1);
  for (const P& bad : {P{}, P{V2(0, 0)}, P{V2(0, 0), V2(1, 0)}, rectangle(nan, 0, 1, 1),
                       rectangle(0, 0, infinity, 1), P{V2(0, 0), V2(0, 0), V2(0, 0)}}) {
    CHECK(contact::contact_manifold_2d(good, bad, 1.0).points.empty());
    CHECK(contact::contact_manifold_2d(bad, good, 1.0).points.empty());
  }
  CHECK(contact::contact_manifold_2d(good, rectangle(0.5, 0.5, 2, 2), nan).points.empty());
  CHECK(contact::contact_manifold_2d(good, rectangle(0.5, 0.5, 2, 2), infinity).points.empty());
}

TEST_CASE("polygons in float have the manifold of those in double, but for rounding") {
  Random random(1825);
  for (int i = 0; i < tried(1000); ++i) {
    const P b = rectangle(-2, 0, 2, 2);
    const double x = random.integer(-16, 16) / 16.0;
    const P a = rectangle(x, 2 - 1 / 64.0, x + 3, 4);
    contact::Polygon<float> fa;
    contact::Polygon<float> fb;
    for (const V2& p : a) fa.push_back(p.cast<float>());
    for (const V2& p : b) fb.push_back(p.cast<float>());
    const auto wide = contact::contact_manifold_2d(a, b, 0.0);
    const auto narrow = contact::contact_manifold_2d(fa, fb, 0.0f);
    REQUIRE(narrow.points.size() == wide.points.size());
    for (std::size_t k = 0; k < wide.points.size(); ++k) {
      CHECK(narrow.points[k].point.cast<double>() == wide.points[k].point);
    }
  }
}

}  // namespace manifold_2d_test
