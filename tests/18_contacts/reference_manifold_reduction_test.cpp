// manifold_reduction.hpp against all choices of four points, and in fractions.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_manifold.hpp>
#include <contact/hull_2d.hpp>
#include <contact/manifold_reduction.hpp>
#include <limits>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace manifold_reduction_test {
namespace {

using contact::reduced_manifold;
using contact::vertex_feature;
using generators::Random;
using generators::tried;
using oracle::Rational;

using V = contact::Vector3<double>;
using V2 = contact::Vector2<double>;
using Manifold = contact::ContactManifold<double>;

/// The points of a manifold whose normal is the z axis, seen along it as reduced_manifold() does.
std::vector<V2> flat(const Manifold& manifold) {
  const V right = contact::detail::perpendicular_to<double>(manifold.normal);
  const V up = manifold.normal.cross(right);
  std::vector<V2> points;
  for (const auto& p : manifold.points) points.emplace_back(right.dot(p.point), up.dot(p.point));
  return points;
}

Rational turn(const V2& a, const V2& b, const V2& c) {
  const auto x = [](const V2& p) { return oracle::exact(p.x()); };
  const auto y = [](const V2& p) { return oracle::exact(p.y()); };
  return (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
}

std::vector<V2> outline(const std::vector<V2>& points) {
  std::vector<V2> hull;
  for (const int i : contact::convex_hull_2d(points)) hull.push_back(points[std::size_t(i)]);
  return hull;
}
/// Whether the convex hull of points contains p, in fractions.
bool contains(const std::vector<V2>& points, const V2& p) {
  const std::vector<V2> hull = outline(points);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (turn(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  }
  return hull.size() > 2;
}
double area(const std::vector<V2>& points) {
  const std::vector<V2> hull = outline(points);
  Rational sum = 0;
  for (std::size_t i = 2; i < hull.size(); ++i) sum += turn(hull[0], hull[i - 1], hull[i]);
  return oracle::nearest(sum) / 2;
}

/// Points on a table, on a circle or anywhere, with random distances.
Manifold drawn(Random& random, bool on_circle) {
  Manifold manifold;
  manifold.normal = V(0, 0, 1);
  const int count = random.integer(5, 10);
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double length = std::sqrt(x * x + y * y);
    const V p = on_circle ? V(x / length, y / length, 0) : V(x, y, 0);
    manifold.points.push_back({p, random.uniform(-1, 0), {vertex_feature(i), {}}});
  }
  return manifold;
}

std::size_t deepest(const Manifold& manifold) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < manifold.points.size(); ++i) {
    if (manifold.points[i].distance < manifold.points[best].distance) best = i;
  }
  return best;
}

/// The largest area of four points with the deepest one that contain the load, by trying all.
double best_area(const Manifold& manifold, const V2& load) {
  const std::vector<V2> points = flat(manifold);
  const std::size_t n = points.size();
  const std::size_t d = deepest(manifold);
  const bool must = contains(points, load);
  double best = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i; k < n; ++k) {
      for (std::size_t l = k; l < n; ++l) {
        const std::vector<V2> chosen{points[d], points[i], points[k], points[l]};
        if (must && !contains(chosen, load)) continue;
        best = std::max(best, area(chosen));
      }
    }
  }
  return best;
}

}  // namespace

TEST_CASE("four points with the deepest, around the load, of the largest area of all choices") {
  Random random(1851);
  int around = 0;
  for (int i = 0; i < tried(60); ++i) {
    const Manifold manifold = drawn(random, true);  // so that all are vertices of the hull
    const V load{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const Manifold reduced = reduced_manifold(manifold, load);
    REQUIRE(reduced.points.size() <= 4);
    CHECK(reduced.points[deepest(reduced)].features == manifold.points[deepest(manifold)].features);
    Manifold at_load = manifold;
    at_load.points = {{load, 0, {}}};
    const V2 seen = flat(at_load)[0];
    CHECK(contains(flat(reduced), seen) == contains(flat(manifold), seen));
    around += contains(flat(manifold), seen) ? 1 : 0;
    CHECK(area(flat(reduced)) >= best_area(manifold, seen) * (1 - 1e-12));
  }
  CHECK(around > tried(10));
}

TEST_CASE("reducing keeps the deepest point and the load, wherever the points lie") {
  Random random(1852);
  int around = 0;
  int lost_by_depth = 0;
  for (int i = 0; i < tried(1000); ++i) {
    const Manifold manifold = drawn(random, random.chance(0.3));
    const V load{random.uniform(-1, 1), random.uniform(-1, 1), 0};
    const Manifold reduced = reduced_manifold(manifold, load);
    CHECK(reduced.points.size() <= 4);
    CHECK(reduced.points[deepest(reduced)].features == manifold.points[deepest(manifold)].features);
    Manifold at_load = manifold;
    at_load.points = {{load, 0, {}}};
    const V2 seen = flat(at_load)[0];
    if (!contains(flat(manifold), seen)) continue;
    ++around;
    CHECK(contains(flat(reduced), seen));
    // The four deepest points, as some programs take, need not hold the body.
    Manifold four = manifold;
    std::sort(four.points.begin(), four.points.end(),
              [](const auto& p, const auto& q) { return p.distance < q.distance; });
    four.points.resize(4);
    lost_by_depth += contains(flat(four), seen) ? 0 : 1;
  }
  CHECK(around > tried(300));
  CHECK(lost_by_depth > tried(50));
}

TEST_CASE("a vertex that the load needs is kept, also if its triangle's area rounds to 0") {
  const V corner(0.34917319323610124, 0.24952045885768248, 0);
  Manifold manifold;
  manifold.normal = V(0, 0, 1);
  for (const V& p : {V(0, 0, 0), corner, V(0.69626196546029240, 0.49755138272980637, 0),
                     V(0.1, 0.35, 0), V(0.3, 0.25, 0)}) {
    manifold.points.push_back({p, p == V(0, 0, 0) ? -1.0 : 0.0, {}});
  }
  for (const V& load : {corner, V(0.2, 0.25, 0)}) {
    Manifold at_load = manifold;
    at_load.points = {{load, 0, {}}};
    const V2 seen = flat(at_load)[0];
    REQUIRE(contains(flat(manifold), seen));
    CHECK(contains(flat(reduced_manifold(manifold, load)), seen));
  }
}

TEST_CASE("an octagon of any size is reduced as one of radius 1 is") {
  const auto octagon = [](double scale, std::size_t deep) {
    Manifold manifold;
    manifold.normal = V(0, 0, 1);
    for (std::size_t i = 0; i < 8; ++i) {
      const double angle = std::acos(-1.0) / 4 * double(i);
      const V p(std::cos(angle), std::sin(angle), 0);
      manifold.points.push_back({p * scale, i == deep ? -1.0 : 0.0, {vertex_feature(int(i)), {}}});
    }
    if (deep == 8) manifold.points.push_back({V(0, 0, 0), -1, {vertex_feature(8), {}}});
    return manifold;
  };
  for (const std::size_t deep : {std::size_t(0), std::size_t(3), std::size_t(8)}) {
    for (const V& load : {V(0.9, 0, 0), V(-0.6, 0.65, 0), V(3, 0, 0)}) {
      const Manifold right = reduced_manifold(octagon(1, deep), load);
      CHECK(right.points.size() == 4);
      for (const double scale : {0x1p-900, 0x1p-565, 0x1p520, 0x1p1022}) {
        const Manifold got = reduced_manifold(octagon(scale, deep), V(load * scale));
        REQUIRE(got.points.size() == right.points.size());
        for (std::size_t i = 0; i < got.points.size(); ++i) {
          CHECK(got.points[i].features == right.points[i].features);
        }
      }
    }
  }
}

TEST_CASE("of a regular octagon four points keep 1/√2 of the area") {
  Manifold manifold;
  manifold.normal = V(0, 0, 1);
  for (int i = 0; i < 8; ++i) {
    const double angle = std::acos(-1.0) / 4 * i;
    manifold.points.push_back({V(std::cos(angle), std::sin(angle), 0), 0, {vertex_feature(i), {}}});
  }
  const Manifold reduced = reduced_manifold(manifold, V(0.1, 0.2, 3));
  REQUIRE(reduced.points.size() == 4);
  CHECK(std::abs(area(flat(reduced)) / area(flat(manifold)) - std::sqrt(0.5)) <= 1e-14);
}

TEST_CASE("a box on a rotated box keeps four of eight points around its centre of mass") {
  contact::Matrix3<double> axes;
  axes << std::sqrt(0.5), -std::sqrt(0.5), 0, std::sqrt(0.5), std::sqrt(0.5), 0, 0, 0, 1;
  const contact::OrientedBox<double> below{V(0, 0, -1), contact::Matrix3<double>::Identity(),
                                           V(1, 1, 1)};
  const contact::OrientedBox<double> above{V(0, 0, 1), axes, V(1, 1, 1)};
  const auto manifold = contact::contact_manifold(above, below, 1e-6);
  REQUIRE(manifold.points.size() == 8);
  const Manifold reduced = reduced_manifold(manifold, above.centre);
  CHECK(reduced.points.size() == 4);
  CHECK(contains(flat(reduced), V2(0, 0)));
}

TEST_CASE("points on a line or at one point are reduced to the ends and the deepest") {
  Manifold manifold;
  manifold.normal = V(0, 0, 1);
  for (int i = 0; i < 6; ++i) manifold.points.push_back({V(i, 2 * i, 0), i == 2 ? -1.0 : 0.0, {}});
  const Manifold line = reduced_manifold(manifold, V(0, 0, 0));
  REQUIRE(line.points.size() == 3);
  CHECK(line.points[0].point == V(0, 0, 0));
  CHECK(line.points[1].point == V(2, 4, 0));
  CHECK(line.points[2].point == V(5, 10, 0));
  for (auto& p : manifold.points) p.point = V(1, 1, 1);
  const Manifold point = reduced_manifold(manifold, V(0, 0, 0));
  REQUIRE(point.points.size() == 1);
  CHECK(point.points[0].distance == -1);
}

TEST_CASE("a manifold of at most four points, or that is not finite, is not reduced") {
  Random random(1853);
  Manifold manifold = drawn(random, true);
  const std::size_t count = manifold.points.size();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(reduced_manifold(manifold, V(nan, 0, 0)).points.size() == count);
  Manifold bad = manifold;
  bad.points[1].point.x() = nan;
  CHECK(reduced_manifold(bad, V(0, 0, 0)).points.size() == count);
  bad = manifold;
  bad.points[2].distance = nan;
  CHECK(reduced_manifold(bad, V(0, 0, 0)).points.size() == count);
  const double large = std::numeric_limits<double>::max();
  Manifold oblique = manifold;
  oblique.normal = V(0.6, 0, 0.8);
  CHECK(reduced_manifold(oblique, V(large, large, -large)).points.size() <= count);
  manifold.points.resize(4);
  CHECK(reduced_manifold(manifold, V(5, 5, 5)).points.size() == 4);
}

}  // namespace manifold_reduction_test
