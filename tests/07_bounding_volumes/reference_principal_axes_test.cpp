// Principal axes, the boxes along them, and how they mislead.
#include <07_bounding_volumes/box_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/principal_axes.hpp>

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

namespace principal_axes_tests {

using box_truth::Points;
using contact::Matrix3;
using contact::Mesh;
using contact::principal_axes;
using contact::principal_box;
using contact::principal_box_of_surface;
using contact::Vector3;
using generators::Random;
using Point = Vector3<double>;

using volume_families::span_of;
/// The largest angle, as a sine, between an axis and the nearest one of another frame.
double turned_away(const Matrix3<double>& axes, const Matrix3<double>& from) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    double least = 1;
    for (int j = 0; j < 3; ++j) {
      const Point a = axes.col(i), b = from.col(j);
      const Point sine = a.cross(b);
      least = std::min(least, std::sqrt(sine.dot(sine)));
    }
    worst = std::max(worst, least);
  }
  return worst;
}
/// Oblique axes.
Matrix3<double> oblique() {
  return contact::principal_axes_detail::orthonormal<double>(Point(3, 2, -1), Point(-1, 2, 2));
}
Points<double> turned(Points<double> points) {
  for (Point& p : points) p = oblique() * p;
  return points;
}
Mesh<double> turned(Mesh<double> mesh) {
  mesh.vertices = turned(mesh.vertices);
  return mesh;
}

TEMPLATE_TEST_CASE("principal axes are orthonormal to 16 u and right-handed for any points", "",
                   float, double) {
  using S = TestType;
  Random random(1);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    Points<S> points = volume_families::points<S>(random, family, random.integer(1, 30));
    if (sizeof(S) == 8) {
      const int exponent = random.integer(-1070, 900);
      points = volume_families::scaled<S>(points, S(std::ldexp(1.0, exponent)));
    }
    const Matrix3<S> axes = principal_axes<S>(span_of<S>(points));
    const Matrix3<S> off = axes.transpose() * axes - Matrix3<S>::Identity();
    INFO(volume_families::name(family) << ", case " << i);
    REQUIRE(off.cwiseAbs().maxCoeff() <= 8 * std::numeric_limits<S>::epsilon());
    REQUIRE(Vector3<S>(axes.col(0)).cross(Vector3<S>(axes.col(1))).dot(axes.col(2)) > S(0));
  }
}

TEST_CASE("principal axes diagonalise the covariance, the largest variance first") {
  Random random(2);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto family = volume_families::all[static_cast<std::size_t>(i) % 5];
    const auto points = volume_families::points<double>(random, family, 20);
    const Matrix3<double> axes = principal_axes<double>(span_of<double>(points));
    Point mean = Point::Zero();
    for (const Point& p : points) mean += p / double(points.size());
    Matrix3<double> covariance = Matrix3<double>::Zero();
    for (const Point& p : points) covariance += (p - mean) * (p - mean).transpose();
    const Matrix3<double> along = axes.transpose() * covariance * axes;
    const double room = 1e-12 * along.diagonal().maxCoeff();
    INFO(volume_families::name(family) << ", case " << i);
    REQUIRE(std::abs(along(0, 1)) <= room);
    REQUIRE(std::abs(along(0, 2)) <= room);
    REQUIRE(std::abs(along(1, 2)) <= room);
    REQUIRE(along(0, 0) >= along(1, 1) - room);
    REQUIRE(along(1, 1) >= along(2, 2) - room);
  }
}

TEST_CASE("the principal axes of a block's corners are those of the block") {
  const Mesh<double> block = turned(contact::box_mesh({-1, -2, -4}, {1, 2, 4}));
  CHECK(turned_away(principal_axes<double>(span_of<double>(block.vertices)), oblique()) < 1e-14);
  const auto box = principal_box<double>(span_of<double>(block.vertices));
  CHECK(std::abs(box_truth::meant_volume(box) / 64 - 1) < 1e-13);
}

TEST_CASE("the principal axes of equal points are those of the world") {
  const Points<double> points(5, Point(1e300, -2, 3e-320));
  CHECK(principal_axes<double>(span_of<double>(points)) == Matrix3<double>::Identity());
}

TEMPLATE_TEST_CASE("a principal box contains its points", "", float, double) {
  using S = TestType;
  Random random(3);
  for (int i = 0; i < generators::tried(330); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const Points<S> points = volume_families::points<S>(random, family, 10);
    INFO(volume_families::name(family) << ", case " << i);
    REQUIRE(box_truth::all_inside(principal_box<S>(span_of<S>(points)), points));
  }
}

TEST_CASE("a principal box may be any number of times larger than the axis-aligned one") {
  for (const double thickness : {0.2, 0.1, 0.05}) {
    // A rod along x. Its variance is that of the many points on a diagonal.
    Points<double> points;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-thickness / 2, thickness / 2}) {
        for (const double z : {-thickness / 2, thickness / 2}) points.push_back({x, y, z});
      }
    }
    const auto few = principal_box<double>(span_of<double>(points));
    CHECK(box_truth::meant_volume(few) < 1.0001 * thickness * thickness);
    const int copies = static_cast<int>(40 / (thickness * thickness));
    for (int i = 0; i < copies; ++i) {
      const double at = (i % 2 == 0 ? 0.5 : -0.5) * thickness;
      points.push_back({at, at, 0});
    }
    const auto many = principal_box<double>(span_of<double>(points));
    CHECK(box_truth::meant_volume(many) > 0.4 * thickness);
  }
}

TEST_CASE(
    "a vertex that is stored many times turns the principal box, but not that of the surface") {
  Mesh<double> block = turned(contact::box_mesh({-1, -2, -4}, {1, 2, 4}));
  for (int i = 0; i < 40; ++i) block.vertices.push_back(block.vertices.front());
  CHECK(turned_away(principal_axes<double>(span_of<double>(block.vertices)), oblique()) > 0.1);
  CHECK(turned_away(principal_box_of_surface(block).axes, oblique()) < 1e-13);
}

TEST_CASE("the box of a surface does not depend on how a face is cut into triangles") {
  Mesh<double> block = turned(contact::box_mesh({-1, -2, -4}, {1, 2, 4}));
  for (int i = 0; i < 200; ++i) {  // one triangle, cut again and again
    const auto [a, b, c] = block.triangles.back();
    const auto at = [&](int k) { return block.vertices[static_cast<std::size_t>(k)]; };
    const int middle = static_cast<int>(block.vertices.size());
    block.vertices.push_back(Point((at(a) + at(b) + 2 * at(c)) / 4));
    block.triangles.back() = {a, b, middle};
    block.triangles.push_back({c, a, middle});
    block.triangles.push_back({b, c, middle});
  }
  CHECK(turned_away(principal_axes<double>(span_of<double>(block.vertices)), oblique()) > 0.02);
  const auto box = principal_box_of_surface(block);
  CHECK(turned_away(box.axes, oblique()) < 1e-12);
  CHECK(box_truth::all_inside(box, block.vertices));
}

TEST_CASE("a mesh without area is bounded along the principal axes of its vertices") {
  Mesh<double> line;
  line.vertices = {Point(0, 0, 0), Point(1, 2, 3), Point(2, 4, 6)};
  line.triangles = {{0, 1, 2}};
  const auto box = principal_box_of_surface(line);
  CHECK(box_truth::all_inside(box, line.vertices));
  CHECK(std::abs(box.half_lengths[0] - std::sqrt(14.0)) < 1e-13);
  CHECK(box.half_lengths[1] < 1e-13);
}

TEST_CASE(
    "equal variances leave the axes undecided: an octahedron's box may be the cube around it") {
  // The smallest box of this octahedron has a volume of 64/27 (6 √(1/27) along two edges).
  const Mesh<double> octahedron = contact::octahedron_mesh(1);
  const auto box = principal_box<double>(span_of<double>(octahedron.vertices));
  CHECK(box_truth::meant_volume(box) > 3.3 * 64.0 / 27 * 0.999);
}

TEST_CASE("principal axes name the argument that they do not take") {
  using support::contains;
  using support::refusal;
  CHECK(contains(refusal([] { principal_axes<double>({}); }), "points = {}"));
  CHECK(contains(refusal([] { principal_box_of_surface({}); }), "points = {}"));
  const Points<double> broken{Point(0, 0, std::numeric_limits<double>::infinity())};
  CHECK(contains(refusal([&] { principal_box<double>(span_of<double>(broken)); }),
                 "points = (0, 0, inf)"));
}

}  // namespace principal_axes_tests
