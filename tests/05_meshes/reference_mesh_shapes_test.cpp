// The meshes to try things on: closed, oriented outwards, of the right size, and what is refused.
#include <catch2/catch_test_macros.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_shapes.hpp>
#include <limits>
#include <stdexcept>
#include <support/generators.hpp>
#include <support/oracle.hpp>

namespace {

using contact::check_mesh;
using contact::Mesh;
using contact::MeshReport;
using contact::Vector3;
using oracle::Rational;

/// Nothing is wrong, one component, the front outside. Returns 6 times the volume.
Rational proper(const Mesh<double>& mesh, std::size_t triangles, int euler_characteristic) {
  const MeshReport report = check_mesh(mesh);
  CHECK(report.ok());
  CHECK(report.bounds_solid());
  CHECK(report.components.size() == 1);
  CHECK(report.euler_characteristic == euler_characteristic);
  CHECK(mesh.triangles.size() == triangles);
  Rational sum(0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = oracle::exact(triangle_of(mesh, i));
    sum += t.a.dot(t.b.cross(t.c));
  }
  CHECK(sum > 0);
  return sum;
}

/// How many edges are convex, flat and reflex, by exact signs.
std::array<int, 3> edge_kinds(const Mesh<double>& mesh) {
  std::array<int, 3> count{};
  for (const contact::MeshEdge& edge : contact::mesh_edges(mesh)) {
    const auto& other = mesh.triangles[static_cast<std::size_t>(edge.triangles[1])];
    const int tip = contact::third_vertex(other, edge.vertices);
    const auto t = triangle_of(mesh, static_cast<std::size_t>(edge.triangles[0]));
    const int side =
        contact::orient_3d(t.a, t.b, t.c, mesh.vertices[static_cast<std::size_t>(tip)]);
    ++count[static_cast<std::size_t>(side + 1)];
  }
  return count;
}

TEST_CASE("a box and an octahedron") {
  CHECK(proper(contact::box_mesh({-1, 0, 2}, {1, 3, 7}), 12, 2) == 6 * 30);
  CHECK(edge_kinds(contact::box_mesh({-1, 0, 2}, {1, 3, 7})) == std::array<int, 3>{12, 6, 0});
  CHECK(proper(contact::octahedron_mesh(3), 8, 2) == 8 * 27);
  CHECK(edge_kinds(contact::octahedron_mesh(3)) == std::array<int, 3>{12, 0, 0});
}

TEST_CASE("balls are convex, and their vertices on the sphere") {
  std::size_t triangles = 20;
  double last = 0;
  for (int subdivisions = 0; subdivisions <= 4; ++subdivisions, triangles *= 4) {
    const Mesh<double> ball = contact::ball_mesh(2, subdivisions);
    const double volume = (proper(ball, triangles, 2) / 6).convert_to<double>();
    CHECK(volume > last);
    CHECK(volume < 33.6);  // 4/3 pi 8 = 33.51
    last = volume;
    CHECK(ball.vertices.size() == triangles / 2 + 2);
    for (const Vector3<double>& v : ball.vertices) {
      CHECK(std::abs(std::sqrt(v.dot(v)) - 2) <= 0x1p-50);
    }
    CHECK(edge_kinds(ball)[0] == static_cast<int>(triangles * 3 / 2));
  }
  CHECK(last > 33.3);
}

TEST_CASE("a star is seen from its centre, and concave along the ball's edges") {
  for (int subdivisions = 0; subdivisions <= 3; ++subdivisions) {
    for (const double outer : {1.0, 1.5, 4.0}) {
      const Mesh<double> star = contact::star_mesh(1, outer, subdivisions);
      const auto triangles = static_cast<int>(star.triangles.size());
      proper(star, std::size_t{60} << (2 * subdivisions), 2);
      CHECK(edge_kinds(star)[2] == triangles / 2);
    }
    const Mesh<double> dents = contact::star_mesh(1, 0.25, subdivisions);
    proper(dents, std::size_t{60} << (2 * subdivisions), 2);
    CHECK(edge_kinds(dents)[2] > 0);
  }
  for (const Mesh<double>& mesh : {contact::star_mesh(1, 3, 2), contact::star_mesh(1, 0.1, 1)}) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto t = triangle_of(mesh, i);
      CHECK(contact::orient_3d(t.a, t.b, t.c, Vector3<double>::Zero()) < 0);
    }
  }
}

TEST_CASE("a torus has a hole") {
  for (const auto& [m, n] : {std::pair{3, 3}, std::pair{12, 8}, std::pair{64, 32}}) {
    const Mesh<double> torus = contact::torus_mesh(3, 1, m, n);
    const double volume =
        (proper(torus, static_cast<std::size_t>(2 * m * n), 0) / 6).convert_to<double>();
    CHECK(volume < 59.3);  // 2 pi^2 3 = 59.22
    if (m == 64) CHECK(volume > 58);
  }
}

TEST_CASE("a prism has the polygon's area times its height") {
  const contact::Polygon<double> polygon{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}, {0, 2}};
  for (const auto& ring : {polygon, contact::reversed(polygon)}) {
    const Mesh<double> prism = contact::prism_mesh(ring, -1, 2);
    CHECK(proper(prism, 24, 2) == 6 * 7 * 3);
    CHECK(prism.vertices.size() == 14);
    CHECK(edge_kinds(prism)[2] == 1);
  }
}

TEST_CASE("moving, joining and turning inside out") {
  contact::CoordinateFrame<double> frame;
  frame.origin = {10, 20, 30};
  frame.axes.col(0) = Vector3<double>(0, 1, 0);
  frame.axes.col(1) = Vector3<double>(-1, 0, 0);
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {1, 2, 3});
  const Mesh<double> moved = contact::transformed(box, frame);
  CHECK(proper(moved, 12, 2) == 36);
  CHECK(moved.vertices[1] == Vector3<double>(10, 21, 30));
  const Mesh<double> both = contact::joined(box, moved);
  CHECK(check_mesh(both).components.size() == 2);
  CHECK(check_mesh(both).ok());
  CHECK(contact::joined(Mesh<double>{}, box).triangles == box.triangles);
  CHECK(check_mesh(contact::inside_out(box)).components.at(0).volume_sign == -1);
  const Mesh<float> single = contact::rounded_mesh<float>(contact::ball_mesh(1, 2));
  CHECK(check_mesh(single).ok());
}

TEST_CASE("what the shapes refuse") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(contact::box_mesh({0, 0, 0}, {1, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(contact::box_mesh({0, 0, 0}, {1, nan, 1}), std::invalid_argument);
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    CHECK_THROWS_AS(contact::octahedron_mesh(bad), std::invalid_argument);
    CHECK_THROWS_AS(contact::ball_mesh(bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::star_mesh(bad, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::star_mesh(1, bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(contact::torus_mesh(bad, 1, 5, 5), std::invalid_argument);
    CHECK_THROWS_AS(contact::torus_mesh(3, bad, 5, 5), std::invalid_argument);
  }
  CHECK_THROWS_AS(contact::ball_mesh(1, -1), std::invalid_argument);
  CHECK_THROWS_AS(contact::ball_mesh(1, 10), std::invalid_argument);
  CHECK_THROWS_AS(contact::star_mesh(1, 2, 9), std::invalid_argument);
  CHECK_THROWS_AS(contact::torus_mesh(1, 1, 5, 5), std::invalid_argument);
  CHECK_THROWS_AS(contact::torus_mesh(1.5e308, 1e308, 3, 3), std::invalid_argument);
  for (const Vector3<double>& v : contact::torus_mesh(1e308, 0.7e308, 7, 5).vertices) {
    CHECK(contact::all_finite(v));
  }
  CHECK_THROWS_AS(contact::torus_mesh(3, 1, 2, 5), std::invalid_argument);
  CHECK_THROWS_AS(contact::torus_mesh(3, 1, 5, 10001), std::invalid_argument);
  CHECK_THROWS_AS(contact::prism_mesh({{0, 0}, {1, 0}, {0, 1}}, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(contact::prism_mesh({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, 0, 1),
                  std::invalid_argument);
}

}  // namespace
