#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <00_vectors/hard_points.hpp>
#include <08_convex_hull/whole.hpp>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <contact/gift_wrapping.hpp>
#include <contact/hull_2d.hpp>
#include <contact/orientation.hpp>
#include <limits>
#include <map>
#include <set>

namespace {

using contact::Hull;
using contact::Vector2;
using contact::Vector3;
using generators::Random;
using hard_points::draw;
using hard_points::kKinds;
using Points = std::vector<Vector3<double>>;
using Points2 = std::vector<Vector2<double>>;

Points draw_set(Random& random, int kind, int most) {
  Points points;
  for (int n = random.integer(0, most); n > 0; --n) {
    points.push_back(draw(random, kind));
    if (random.chance(0.1)) points.push_back(points[points.size() / 2]);
  }
  return points;
}

/// The contract of a hull, checked in exact arithmetic.
void require_hull(const Points& points, const Hull& hull) {
  const auto at = [&](int i) -> const Vector3<double>& {
    return points[static_cast<std::size_t>(i)];
  };
  REQUIRE(hull.closed);
  for (const int v : hull.vertices) {
    REQUIRE((v >= 0 && v < static_cast<int>(points.size())));
    for (int i = 0; i < v; ++i) REQUIRE(at(i) != at(v));
  }
  if (hull.dimension < 2) {
    REQUIRE(hull.face_count() == 0);
    REQUIRE(static_cast<int>(hull.vertices.size()) == hull.dimension + 1);
    return;
  }
  const int corners = static_cast<int>(hull.vertices.size());
  REQUIRE(corners - hull.edge_count() + hull.face_count() == 2);
  // Every edge is shared by two faces, once in each direction; every vertex has enough faces.
  std::set<std::pair<int, int>> edges;
  std::map<int, int> faces_at;
  for (int f = 0; f < hull.face_count(); ++f) {
    const auto polygon = hull.face(f);
    const std::size_t size = polygon.size();
    REQUIRE(size >= 3);
    for (std::size_t i = 0; i < size; ++i) {
      const int a = polygon[i], b = polygon[(i + 1) % size], c = polygon[(i + 2) % size];
      REQUIRE(edges.insert({a, b}).second);
      ++faces_at[a];
      // No point is in front, tested at every vertex of the face: so the face is flat.
      REQUIRE_FALSE(contact::are_collinear(at(a), at(b), at(c)));
      for (const Vector3<double>& p : points)
        REQUIRE(contact::orient_3d(at(a), at(b), at(c), p) <= 0);
    }
  }
  for (const auto& [from, to] : edges) REQUIRE(edges.contains({to, from}));
  REQUIRE(faces_at.size() == hull.vertices.size());
  for (const int v : hull.vertices) REQUIRE(faces_at[v] >= hull.dimension);
  if (hull.dimension == 2) return;
  // Faces that share an edge lie in two planes.
  for (int f = 0; f < hull.face_count(); ++f) {
    const auto polygon = hull.face(f);
    const bool has_behind = std::any_of(hull.vertices.begin(), hull.vertices.end(), [&](int v) {
      return std::find(polygon.begin(), polygon.end(), v) == polygon.end() &&
             contact::orient_3d(at(polygon[0]), at(polygon[1]), at(polygon[2]), at(v)) == 0;
    });
    REQUIRE_FALSE(has_behind);
  }
}

/// The faces, each from its least vertex, in order.
std::set<std::vector<int>> canonical(const Hull& hull) {
  std::set<std::vector<int>> faces;
  for (int f = 0; f < hull.face_count(); ++f) {
    const auto polygon = hull.face(f);
    std::vector<int> face(polygon.begin(), polygon.end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

}  // namespace

TEST_CASE("the planes of faces have the sign that orient_3d gives, on every kind of input") {
  Random random(1);
  for (int i = 0; i < 8000; ++i) {
    const int kind = i % kKinds;
    const auto a = draw(random, kind), b = draw(random, kind), c = draw(random, kind),
               d = draw(random, kind);
    const Points set{a, b, c, d};
    const contact::ExactSides sides(set);
    REQUIRE(sides.side(sides.plane(0, 1, 2), 0, 1, 2, 3) == contact::orient_3d(a, b, c, d));
  }
}

TEST_CASE("the hull in the plane equals that of wrapping in whole numbers") {
  Random random(2);
  for (int round = 0; round < 1500; ++round) {
    const int size = round % 4 == 0 ? 1 << 25 : 1 + round % 6;
    Points2 points;
    for (int n = random.integer(0, 20); n > 0; --n) {
      const double x = random.integer(-size, size);
      points.push_back({x, double(random.integer(-size, size))});
    }
    REQUIRE(contact::convex_hull_2d(points) == whole::hull_2d(points));
  }
}

TEST_CASE("hulls satisfy their contract on every kind of set, and wrapping finds the same faces") {
  Random random(3);
  std::map<int, int> dimensions;
  for (int round = 0; round < 900; ++round) {
    const Points points = draw_set(random, round % kKinds, 16);
    const Hull hull = contact::convex_hull(points);
    require_hull(points, hull);
    ++dimensions[hull.dimension];
    const Hull wrapped = contact::gift_wrap(points);
    REQUIRE(wrapped.closed);
    REQUIRE(wrapped.dimension == hull.dimension);
    REQUIRE(wrapped.vertices == hull.vertices);
    REQUIRE(canonical(wrapped) == canonical(hull));
    if (round % 9 == 0) {
      const Hull plain = contact::convex_hull_with<contact::UnfilteredSides>(points);
      REQUIRE(canonical(plain) == canonical(hull));
    }
  }
  for (int dimension = -1; dimension <= 3; ++dimension) REQUIRE(dimensions[dimension] > 10);
}

TEST_CASE("vertices agree with planes tried one by one in whole numbers") {
  Random random(4);
  for (int round = 0; round < 200; ++round) {
    Points points;
    const int size = 1 + round % 4;
    for (int n = random.integer(0, 12); n > 0; --n) {
      const double x = random.integer(-size, size), y = random.integer(-size, size);
      points.push_back({x, y, double(random.integer(-size, size))});
    }
    REQUIRE(contact::convex_hull(points).vertices == whole::hull_vertices(points));
  }
}

TEST_CASE("a grid of any size has eight vertices and six faces") {
  Points grid;
  for (int i = 0; i < 1000; ++i)
    grid.push_back({double(i % 10), double(i / 10 % 10), double(i / 100)});
  const Hull hull = contact::convex_hull(grid);
  require_hull(grid, hull);
  REQUIRE(hull.vertices == std::vector<int>{0, 9, 90, 99, 900, 909, 990, 999});
  REQUIRE(hull.face_count() == 6);
}

TEST_CASE("points on a sphere are all vertices, and the surface closes") {
  Random random(5);
  Points points;
  for (int i = 0; i < 400; ++i) points.push_back(draw(random, 4));
  const Hull hull = contact::convex_hull(points);
  require_hull(points, hull);
  REQUIRE(hull.vertices.size() == points.size());
  REQUIRE(contact::triangles(hull).size() == 2 * points.size() - 4);
}

TEST_CASE("the hull does not depend on the order of the points") {
  Random random(6);
  for (int round = 0; round < 60; ++round) {
    Points points = draw_set(random, round % kKinds, 20);
    const Hull before = contact::convex_hull(points);
    std::vector<Vector3<double>> corners;
    for (const int v : before.vertices) corners.push_back(points[static_cast<std::size_t>(v)]);
    std::reverse(points.begin(), points.end());
    const Hull after = contact::convex_hull(points);
    REQUIRE(after.dimension == before.dimension);
    REQUIRE(after.face_count() == before.face_count());
    REQUIRE(after.vertices.size() == before.vertices.size());
    for (const int v : after.vertices) {
      REQUIRE(std::find(corners.begin(), corners.end(), points[static_cast<std::size_t>(v)]) !=
              corners.end());
    }
  }
}

TEST_CASE("wrapping by signed angles is right in general position, and unsigned ones fold back") {
  Random random(7);
  int unsigned_right = 0;
  for (int round = 0; round < 200; ++round) {
    Points points;
    for (int i = 0; i < 12; ++i) {
      const double x = random.integer(-100, 100), y = random.integer(-100, 100);
      points.push_back({x, y, double(random.integer(-100, 100))});
    }
    const Hull hull = contact::convex_hull(points);
    // General position: no two of the highest, and triangles only.
    std::vector<double> heights;
    for (const auto& p : points) heights.push_back(p.z());
    std::sort(heights.begin(), heights.end());
    if (heights[10] == heights[11]) continue;
    if (contact::triangles(hull).size() != static_cast<std::size_t>(hull.face_count())) continue;
    const auto right = contact::wrap_by_angles<double>(points, contact::FoldAngle::signed_);
    REQUIRE(right.closed);
    REQUIRE(right.triangles.size() == static_cast<std::size_t>(hull.face_count()));
    const auto folded = contact::wrap_by_angles<double>(points, contact::FoldAngle::unsigned_);
    unsigned_right += folded.closed && folded.triangles.size() == right.triangles.size();
  }
  REQUIRE(unsigned_right < 100);
}

TEST_CASE("rounded decisions always terminate") {
  Random random(8);
  int wrong = 0;
  for (int round = 0; round < 600; ++round) {
    const Points points = draw_set(random, 2 + round % 6, 24);
    const Hull right = contact::convex_hull(points);
    const Hull plain = contact::convex_hull_with<contact::RoundedSides<double>>(points);
    const Hull narrow = contact::convex_hull_with<contact::RoundedSides<float>>(points);
    const Hull near = contact::convex_hull_with<contact::RoundedSides<double>>(points, 1e-9);
    const Hull wrapped = contact::gift_wrap_with<contact::RoundedSides<double>>(points);
    (void)contact::wrap_by_angles<float>(points, contact::FoldAngle::signed_);
    (void)contact::wrap_by_angles<double>(points, contact::FoldAngle::unsigned_);
    wrong += plain.vertices != right.vertices || narrow.vertices != right.vertices ||
             near.vertices != right.vertices || wrapped.vertices != right.vertices;
  }
  REQUIRE(wrong > 100);
}

TEST_CASE("a coordinate that is not finite is refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points points{{0, 0, 0}, {1, nan, 0}};
  REQUIRE_THROWS_AS(contact::convex_hull(points), std::invalid_argument);
  REQUIRE_THROWS_AS(contact::gift_wrap(points), std::invalid_argument);
  REQUIRE_THROWS_AS(contact::convex_hull_2d({{0, 0}, {nan, 1}}), std::invalid_argument);
}
