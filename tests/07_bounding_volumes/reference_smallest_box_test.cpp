// Small oriented boxes: containment in fractions, volumes against known ones, O'Rourke's condition
// and boxes that are easier to find.
#include <07_bounding_volumes/box_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/smallest_box.hpp>
#include <contact/smallest_rectangle.hpp>

#include <support/generators.hpp>
#include <support/refusal.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace smallest_box_tests {

using box_truth::meant_volume;
using box_truth::Points;
using contact::Matrix3;
using contact::OrientedBox;
using contact::smallest_box;
using contact::Vector3;
using generators::Random;
using Point = Vector3<double>;

using volume_families::span_of;
OrientedBox<double> smallest_of(const Points<double>& points) {
  return smallest_box<double>(span_of<double>(points));
}
Matrix3<double> rotation(Random& random) {
  const auto vector = [&random] {
    return Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  const Point x = vector(), y = vector();
  return contact::principal_axes_detail::orthonormal<double>(x, y);
}
Points<double> turned(const Matrix3<double>& axes, Points<double> points) {
  for (Point& p : points) p = axes * p;
  return points;
}
/// Of a set that is not flat, from the double: more than rounding can change.
constexpr double room = 1e-9;

TEMPLATE_TEST_CASE("a small box contains all points, as it is stored", "", float, double) {
  using S = TestType;
  Random random(1);
  for (int i = 0; i < generators::tried(264); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const int count = random.integer(1, 14);
    const Points<S> points = volume_families::points<S>(random, family, count);
    INFO(volume_families::name(family) << ", case " << i);
    REQUIRE(box_truth::all_inside(smallest_box<S>(span_of<S>(points)), points));
  }
}

TEST_CASE("a small box is not larger than the axis-aligned and the principal box") {
  Random random(2);
  for (int i = 0; i < generators::tried(220); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const auto points = volume_families::points<double>(random, family, 40);
    if (contact::convex_hull(points).dimension < 3) continue;
    const auto bounds = contact::aabb_of_points(span_of<double>(points));
    const auto hull = contact::convex_hull(points);
    Points<double> vertices;
    for (const int v : hull.vertices) vertices.push_back(points[static_cast<std::size_t>(v)]);
    const double found = meant_volume(smallest_of(points));
    INFO(volume_families::name(family) << ", case " << i);
    REQUIRE(found <= (bounds.high - bounds.low).prod() * (1 + room));
    REQUIRE(found <=
            meant_volume(contact::principal_box<double>(span_of<double>(vertices))) * (1 + room));
  }
}

TEST_CASE("a small box is not larger than any box flush with a face of a small hull") {
  Random random(3);
  for (int i = 0; i < generators::tried(48); ++i) {
    const auto family = volume_families::all[static_cast<std::size_t>(i) % 4];
    const auto points = volume_families::points<double>(random, family, 14);
    const auto hull = contact::convex_hull(points);
    if (hull.dimension < 3) continue;
    const double found = meant_volume(smallest_of(points));
    for (int f = 0; f < hull.face_count(); ++f) {
      const Point normal = contact::smallest_box_detail::area_vector(hull.face(f), points);
      const auto axes = contact::frame_on_normal<double>(Point::Zero(), normal).axes;
      std::vector<contact::Vector2<double>> flat;
      for (const Point& p : points) flat.push_back({axes.col(0).dot(p), axes.col(1).dot(p)});
      const auto r = contact::smallest_rectangle<double>(flat);
      INFO(volume_families::name(family) << ", case " << i << ", face " << f);
      REQUIRE(found <=
              4 * r.half_lengths.prod() * box_truth::extent(points, axes.col(2)) * (1 + room));
    }
  }
}

TEST_CASE("a small box of a small hull is at most 0.1 % larger than the smallest one") {
  Random random(4);
  for (int i = 0; i < generators::tried(24); ++i) {
    Points<double> points;
    const int kind = i % 3, count = random.integer(4, 8);
    for (int n = 0; n < count; ++n) {
      Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      if (kind == 1) p /= std::sqrt(p.dot(p));
      if (kind == 2) p = {double(random.integer(-3, 3)), double(random.integer(-3, 3)), p.z()};
      points.push_back(p);
    }
    if (contact::convex_hull(points).dimension < 3) continue;
    INFO("case " << i);
    REQUIRE(meant_volume(smallest_of(points)) <= 1.001 * box_truth::smallest_volume(points));
  }
}

TEST_CASE("the smallest box of a block in any orientation is the block") {
  Random random(5);
  for (const Point& size : {Point(1, 1, 1), Point(10, 1, 1), Point(5, 5, 0.2), Point(3, 2, 1),
                            Point(1, 1e-3, 1e-6), Point(1, 1, 1e-9)}) {
    const auto block = contact::box_mesh(Point::Zero(), size).vertices;
    for (int i = 0; i < generators::tried(16); ++i) {
      const auto box = smallest_of(turned(rotation(random), block));
      INFO("size " << size.transpose());
      REQUIRE(meant_volume(box) <= size.prod() * (1 + 1e-5));
      REQUIRE(meant_volume(box) >= size.prod() * (1 - 1e-5));
    }
  }
}

TEST_CASE("the smallest box of a regular tetrahedron touches its edges only") {
  // The cube of which they are diagonals. A box along a face is twice as large.
  Random random(6);
  const Points<double> tetrahedron{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  for (int i = 0; i < generators::tried(24); ++i) {
    REQUIRE(std::abs(meant_volume(smallest_of(turned(rotation(random), tetrahedron))) - 1) < 1e-4);
  }
}

TEST_CASE("the smallest box of a regular octahedron has a volume of 64/27") {
  Random random(7);
  const auto octahedron = contact::octahedron_mesh(1).vertices;
  for (int i = 0; i < generators::tried(24); ++i) {
    REQUIRE(meant_volume(smallest_of(turned(rotation(random), octahedron))) < 64.0 / 27 * 1.001);
  }
}

TEST_CASE("a set turned by any rotation gets a small box of about the same volume") {
  Random random(8);
  for (int i = 0; i < generators::tried(24); ++i) {
    const auto points = volume_families::points<double>(
        random, i % 2 == 0 ? volume_families::Family::in_box : volume_families::Family::on_ball,
        30);
    const double found = meant_volume(smallest_of(points));
    const double again = meant_volume(smallest_of(turned(rotation(random), points)));
    INFO("case " << i);
    REQUIRE(std::abs(again / found - 1) < 0.005);
  }
}

TEST_CASE("points inside and points stored twice do not change the small box") {
  Random random(9);
  for (int i = 0; i < generators::tried(24); ++i) {
    Points<double> points =
        volume_families::points<double>(random, volume_families::Family::in_box, 20);
    const auto found = smallest_of(points);
    Point mean = Point::Zero();
    for (const Point& p : points) mean += p / double(points.size());
    const Points<double> corners = points;
    for (const Point& p : corners) {
      points.push_back(p);
      points.push_back(Point((p + mean) / 2));
    }
    INFO("case " << i);
    REQUIRE(std::abs(meant_volume(smallest_of(points)) / meant_volume(found) - 1) < 0.005);
  }
}

TEST_CASE("a flat set gets a small box of the smallest area") {
  Random random(10);
  for (int i = 0; i < generators::tried(60); ++i) {
    Points<double> points;
    std::vector<contact::Vector2<double>> flat;
    for (int n = 0; n < 12; ++n) {
      const double x = random.uniform(-1, 1), y = random.integer(-2, 2);
      // In the plane z = 0, or exactly in z = x, where x is longer.
      flat.push_back({i % 2 == 0 ? x : std::sqrt(2.0) * x, y});
      points.push_back({x, y, i % 2 == 0 ? 0 : x});
    }
    const auto box = smallest_of(points);
    REQUIRE(box_truth::all_inside(box, points));
    std::array<double, 3> lengths{box.half_lengths[0], box.half_lengths[1], box.half_lengths[2]};
    std::sort(lengths.begin(), lengths.end());
    const double area = contact::smallest_rectangle<double>(flat).half_lengths.prod();
    INFO("case " << i);
    REQUIRE(lengths[0] <= 1e-13);
    REQUIRE(lengths[1] * lengths[2] <= area * (1 + 1e-6));
  }
}

TEST_CASE("a small box of a segment is as long as it, and of equal points without extent") {
  const Points<double> segment{{1, 2, 3}, {2, 4, 5}, {3, 6, 7}, {3, 6, 7}};
  const auto box = smallest_of(segment);
  CHECK(std::abs(box.half_lengths.maxCoeff() - 3) < 1e-13);
  CHECK(box.half_lengths.sum() < 3 + 2e-13);
  CHECK(box_truth::all_inside(box, segment));
  const Points<double> equal(5, Point(0.1, 1e100, -3));
  CHECK(smallest_of(equal).half_lengths == Point::Zero());
  CHECK(smallest_of(equal).centre == equal[0]);
}

TEST_CASE("a set scaled by 2^-500 or 2^500 gets a small box of about the same shape") {
  Random random(11);
  for (int i = 0; i < generators::tried(24); ++i) {
    const auto points = volume_families::points<double>(
        random, volume_families::all[static_cast<std::size_t>(i) % 4], 12);
    const double found = meant_volume(smallest_of(points));
    for (const double scale : {0x1p-500, 0x1p500}) {
      auto other = smallest_of(volume_families::scaled<double>(points, scale));
      other.half_lengths /= scale;
      INFO("case " << i << ", scale " << scale);
      REQUIRE(std::abs(meant_volume(other) - found) <= 0.005 * found);
    }
  }
}

TEST_CASE("at the smallest and the largest scales a small box contains its points") {
  Random random(12);
  for (const int exponent : {-1074, -1068, -1022, 1000, 1019}) {
    for (int i = 0; i < generators::tried(8); ++i) {
      auto points = volume_families::points<double>(random, volume_families::Family::grid, 8);
      points = volume_families::scaled<double>(points, std::ldexp(1.0, exponent));
      INFO("2^" << exponent);
      REQUIRE(box_truth::all_inside(smallest_of(points), points));
    }
  }
}

TEST_CASE("a small box of a large hull contains all points and is not larger than easy boxes") {
  Random random(13);
  const std::vector<Points<double>> sets{
      contact::ball_mesh(1, 3).vertices, contact::star_mesh(0.5, 1, 3).vertices,
      contact::torus_mesh(3, 1, 40, 20).vertices,
      volume_families::points<double>(random, volume_families::Family::on_ball, 1500)};
  for (const auto& set : sets) {
    const auto points = turned(rotation(random), set);
    const auto box = smallest_of(points);
    for (const Point& p : points) REQUIRE(contact::contains(box, p));
    const auto bounds = contact::aabb_of_points(span_of<double>(points));
    REQUIRE(meant_volume(box) <= (bounds.high - bounds.low).prod() * (1 + room));
  }
  // Of the torus it is known: 8 × 8 × 2.
  const auto torus = smallest_of(turned(rotation(random), sets[2]));
  CHECK(meant_volume(torus) < 128 * 1.0001);
}

TEST_CASE("the same points in the same order get the same small box") {
  Random random(14);
  const auto points =
      volume_families::points<double>(random, volume_families::Family::on_ball, 300);
  const auto first = smallest_of(points), second = smallest_of(points);
  CHECK(first.axes == second.axes);
  CHECK(first.centre == second.centre);
  CHECK(first.half_lengths == second.half_lengths);
}

TEST_CASE("smallest_box() names the argument that it does not take") {
  using support::contains;
  using support::refusal;
  CHECK(contains(refusal([] { smallest_box<double>({}); }), "points = {}"));
  const Points<double> broken{Point(1, 2, 3),
                              Point(1, std::numeric_limits<double>::quiet_NaN(), 3)};
  CHECK(contains(refusal([&] { smallest_of(broken); }), "points = (1, nan, 3)"));
}

TEST_CASE("a small box contains points that rounding keeps from a line") {
  for (int i = 1; i < 10; ++i) {
    for (int j = 1; j < 10; ++j) {
      for (int k = 2; k < 10; ++k) {
        const Vector3<double> v(0.1 * i, 0.1 * j, 0.3);
        const std::vector<Vector3<double>> points{Vector3<double>(0, 0, 0), v,
                                                  Vector3<double>(k * v)};
        REQUIRE(box_truth::all_inside(smallest_of(points), points));
      }
    }
  }
}

}  // namespace smallest_box_tests
