// mesh.hpp: meshes from lists of numbers, and their triangles.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <contact/mesh.hpp>
#include <vector>

namespace mesh_test {

using contact::Vector3;

TEST_CASE("a mesh is made from flat lists, and gives its triangles") {
  const std::array<double, 12> coordinates{0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, -3};
  const std::vector<double> indices{0, 2, 1, 3, 0, 1};
  const contact::Mesh<double> mesh = contact::mesh_from_lists(coordinates, indices);
  REQUIRE(mesh.vertices.size() == 4);
  CHECK(mesh.vertices[3] == Vector3<double>(0, 0, -3));
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.triangles[0] == std::array<int, 3>{0, 2, 1});
  const contact::Triangle<double> second = contact::triangle_of(mesh, 1);
  CHECK(second.a == Vector3<double>(0, 0, -3));
  CHECK(second.b == Vector3<double>(0, 0, 0));
  CHECK(second.c == Vector3<double>(1, 0, 0));
}

TEST_CASE("what is no whole vertex or triangle is left out of a mesh from lists") {
  const contact::Mesh<double> mesh =
      contact::mesh_from_lists(std::vector<double>{1, 2, 3, 4, 5}, std::vector<int>{0, 0, 0, 1, 1});
  CHECK(mesh.vertices.size() == 1);
  CHECK(mesh.triangles.size() == 1);
  const std::vector<double> none;
  CHECK(contact::mesh_from_lists(none, none).vertices.empty());
}

}  // namespace mesh_test
