#include <07_bounding_volumes/carried_truth.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <contact/measured_shapes.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/ray_kdop.hpp>
#include <string>
#include <vector>

namespace measured_shapes_test {

using contact::MeasuredShape;
using contact::Mesh;
using Point = contact::Vector3<double>;

/// The rotation by which shapes are turned, back.
Point in_own_frame(const Point& v) {
  contact::Matrix3<double> whole;
  whole << 35, 14, 10, 10, -35, 14, 14, -10, -35;
  return whole.transpose() * v / 39;
}
MeasuredShape shape_called(const std::string& name) {
  for (const MeasuredShape& shape : contact::measured_shapes()) {
    if (shape.name == name) return shape;
  }
  FAIL("no shape is called " << name);
  return {};
}
/// The edges of the shape's box along its own axes.
Point lengths_of(const MeasuredShape& shape) {
  Point low = Point::Constant(1e9), high = -low;
  for (const Point& v : shape.mesh.vertices) {
    low = low.cwiseMin(in_own_frame(v));
    high = high.cwiseMax(in_own_frame(v));
  }
  return high - low;
}
double hull_share(const MeasuredShape& shape) {
  const contact::Hull hull = contact::convex_hull(shape.mesh.vertices);
  const Mesh<double> surface{shape.mesh.vertices, contact::triangles(hull)};
  return contact::mesh_volume(shape.mesh).value / contact::mesh_volume(surface).value;
}

TEST_CASE("the measured shapes bound solids of one component") {
  for (const MeasuredShape& shape : contact::measured_shapes()) {
    INFO(shape.name);
    const auto report = contact::check_mesh(shape.mesh);
    CHECK(report.closed);
    CHECK(report.oriented);
    CHECK(report.manifold);
    CHECK(report.euler_characteristic == 2);
    REQUIRE(report.components.size() == 1);
    CHECK(report.components[0].volume_sign == 1);
  }
}

TEST_CASE("the measured shapes do not cross themselves") {
  for (const MeasuredShape& shape : contact::measured_shapes()) {
    INFO(shape.name);
    CHECK(contact::self_meeting_triangles(shape.mesh).empty());
  }
}

TEST_CASE("the measured shapes are of 500 to 1,300 triangles and use all their vertices") {
  for (const MeasuredShape& shape : contact::measured_shapes()) {
    INFO(shape.name);
    CHECK(shape.mesh.triangles.size() >= 500);
    CHECK(shape.mesh.triangles.size() <= 1300);
    std::vector<int> used(shape.mesh.vertices.size(), 0);
    for (const auto& triangle : shape.mesh.triangles) {
      for (const int v : triangle) used[static_cast<std::size_t>(v)] = 1;
    }
    CHECK(std::count(used.begin(), used.end(), 0) == 0);
  }
}

TEST_CASE("coordinates of the measured shapes are multiples of 2^-20 below 16") {
  for (const MeasuredShape& shape : contact::measured_shapes()) {
    INFO(shape.name);
    for (const Point& v : shape.mesh.vertices) {
      for (const double x : v) {
        REQUIRE(std::abs(x) < 16);
        REQUIRE(std::ldexp(x, 20) == std::round(std::ldexp(x, 20)));
      }
    }
  }
}

TEST_CASE("ball, rod, plate and star are as large as they say") {
  const auto check = [](const char* name, const Point& right, double room) {
    INFO(name);
    CHECK((lengths_of(shape_called(name)) - right).cwiseAbs().maxCoeff() <= room);
  };
  check("ball", {10, 10, 10}, 0.2);
  check("rod", {1, 1, 10}, 1e-5);
  check("plate", {10, 10, 0.5}, 1e-5);
  check("star", {10, 10, 10}, 0.2);
}

TEST_CASE("ball, rod and plate fill their hulls, star and mesh do not") {
  for (const char* convex : {"ball", "rod", "plate"})
    CHECK(hull_share(shape_called(convex)) > 0.999);
  for (const char* concave : {"star", "mesh"}) CHECK(hull_share(shape_called(concave)) < 0.8);
}

TEST_CASE("no axis of a shape is within 26 degrees of a normal of the 26-DOP") {
  for (const Point& normal : contact::kdop_normals<double>(26)) {
    // In the shape's frame, the coordinates of a unit vector are the cosines.
    const Point cosines = in_own_frame(normal) / std::sqrt(normal.dot(normal));
    CHECK(cosines.cwiseAbs().maxCoeff() < 0.8988);
  }
}

}  // namespace measured_shapes_test
