// The makers of lozenges, ellipsoids, cylinders and hulls: what they accept, refuse and keep.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace convex_bodies_test {
namespace {

using contact::Kdop;
using contact::Matrix3;
using Point = contact::Vector3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_CASE("a lozenge keeps its edges, also oblique, parallel or of length 0") {
  const Point edge{1, 2, 3};
  for (const Point& other : {Point{2, 0, 0}, edge, Point{0, 0, 0}}) {
    const auto made = contact::lozenge_from_edges<double>(Point{1, 1, 1}, edge, other, 0.5);
    CHECK(made.first_edge == edge);
    CHECK(made.second_edge == other);
    CHECK(made.radius == 0.5);
  }
}

TEST_CASE("makers of bodies refuse numbers that are not finite, negative or out of range") {
  const Point zero = Point::Zero(), one{1, 1, 1};
  const Matrix3<double> axes = Matrix3<double>::Identity();
  for (const double bad : {nan, infinity, -1.0, 0x1p251, 0x1p-251}) {
    CHECK_THROWS_AS(contact::lozenge_from_edges<double>(zero, one, one, bad),
                    std::invalid_argument);
    CHECK_THROWS_AS(contact::cylinder_from_segment<double>(zero, one, bad), std::invalid_argument);
    CHECK_THROWS_AS(contact::ellipsoid_from_axes<double>(zero, axes, Point{1, bad, 1}),
                    std::invalid_argument);
    CHECK_THROWS_AS(contact::convex_hull_from_points<double>(std::vector<Point>{zero, one}, bad),
                    std::invalid_argument);
  }
  for (const double bad : {nan, infinity, -0x1p251}) {
    const Point point{0, bad, 0};
    CHECK_THROWS_AS(contact::lozenge_from_edges<double>(point, one, one, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::lozenge_from_edges<double>(one, point, one, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::lozenge_from_edges<double>(one, one, point, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::cylinder_from_segment<double>(point, one, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::cylinder_from_segment<double>(one, point, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::ellipsoid_from_axes<double>(point, axes, one), std::invalid_argument);
    CHECK_THROWS_AS(contact::convex_hull_from_points<double>(std::vector<Point>{one, point}),
                    std::invalid_argument);
  }
}

TEST_CASE("an ellipsoid needs half lengths above 0 and axes that are a rotation") {
  const Point zero = Point::Zero();
  CHECK_THROWS_AS(
      contact::ellipsoid_from_axes<double>(zero, Matrix3<double>::Identity(), Point{1, 0, 1}),
      std::invalid_argument);
  CHECK_THROWS_AS(
      contact::ellipsoid_from_axes<double>(zero, Matrix3<double>::Identity() * 2, Point{1, 1, 1}),
      std::invalid_argument);
  Matrix3<double> mirrored = Matrix3<double>::Identity();
  mirrored(2, 2) = -1;
  CHECK_THROWS_AS(contact::ellipsoid_from_axes<double>(zero, mirrored, Point{1, 1, 1}),
                  std::invalid_argument);
}

TEST_CASE("a cylinder whose ends are equal has no direction") {
  CHECK_THROWS_AS(contact::cylinder_from_segment<double>(Point{1, 2, 3}, Point{1, 2, 3}, 1),
                  std::invalid_argument);
  CHECK(contact::cylinder_from_segment<double>(Point{1, 2, 3}, Point{1, 2, 4}, 0).radius == 0);
}

TEST_CASE("a hull keeps the vertices of its points and no others") {
  std::vector<Point> points;
  for (int k = 0; k < 27; ++k) points.push_back({double(k % 3), double(k / 3 % 3), double(k / 9)});
  const auto body = contact::convex_hull_from_points<double>(points, 0.25);
  CHECK(body.radius == 0.25);
  REQUIRE(body.vertices.size() == 8);
  for (const Point& v : body.vertices) {
    for (int i = 0; i < 3; ++i) CHECK((v(i) == 0 || v(i) == 2));
  }
  CHECK_THROWS_AS(contact::convex_hull_from_points<double>(std::span<const Point>{}),
                  std::invalid_argument);
}

TEST_CASE("a hull may be a point, a segment or a polygon") {
  const std::vector<Point> points{{1, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}, {1, 2, 0}, {2, 1, 0}};
  const std::span<const Point> all(points);
  CHECK(contact::convex_hull_from_points<double>(all.first(2)).vertices.size() == 1);
  CHECK(contact::convex_hull_from_points<double>(all.first(4)).vertices.size() == 2);
  CHECK(contact::convex_hull_from_points<double>(all).vertices.size() == 3);
}

TEST_CASE("a hull of floats has vertices that are the given points") {
  using PointF = contact::Vector3<float>;
  const std::vector<PointF> points{{0.1F, 0, 0}, {0, 0.2F, 0}, {0, 0, 0.3F}, {0.4F, 0.5F, 0.6F}};
  const auto body = contact::convex_hull_from_points<float>(points);
  CHECK(body.vertices == points);
}

TEST_CASE("a k-DOP becomes the hull of its vertices") {
  const std::vector<Point> points{{0, 0, 0}, {1, 2, 3}};
  const auto box =
      contact::kdop_of_points<double>(contact::kdop_normals<double>(6), std::span(points));
  const auto body = contact::convex_hull_from_kdop(box, 0.5);
  CHECK(body.radius == 0.5);
  CHECK(body.vertices.size() == 8);
  for (const Point& v : body.vertices) {
    CHECK(std::abs(std::abs(v.x() - 0.5) - 0.5) < 1e-14);
    CHECK(std::abs(std::abs(v.y() - 1) - 1) < 1e-14);
    CHECK(std::abs(std::abs(v.z() - 1.5) - 1.5) < 1e-14);
  }
}

TEST_CASE("a k-DOP that is empty or has no end makes no hull") {
  Kdop<double> dop;
  dop.normals = contact::kdop_normals<double>(6);
  dop.low = {0, 0, 0};
  dop.high = {1, -1, 1};
  CHECK_THROWS_AS(contact::convex_hull_from_kdop(dop), std::invalid_argument);
  dop.high = {1, infinity, 1};
  CHECK_THROWS_AS(contact::convex_hull_from_kdop(dop), std::invalid_argument);
}

}  // namespace
}  // namespace convex_bodies_test
