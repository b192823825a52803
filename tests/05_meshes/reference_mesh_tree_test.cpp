#include <catch2/catch_test_macros.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <support/generators.hpp>

#include <set>

namespace {

using contact::Aabb;
using contact::Mesh;
using contact::MeshTree;
using contact::Triangle;
using contact::Vector3;
using generators::Random;

TEST_CASE("a visit finds every triangle whose box passes, each once") {
  Random random(1);
  const Mesh<double> mesh = contact::ball_mesh(1.0, 4);
  const MeshTree<double> tree(mesh);
  for (int i = 0; i < generators::tried(200); ++i) {
    const double x = random.uniform(-1.2, 1.2);
    const double y = random.uniform(-1.2, 1.2);
    const auto enters = [&](const Aabb<double>& box) {
      return box.low.x() <= x && x <= box.high.x() && box.low.y() <= y && y <= box.high.y();
    };
    std::set<int> visited;
    contact::TreeCounts counts;
    const bool stopped = tree.visit(
        enters,
        [&](int triangle) {
          REQUIRE(visited.insert(triangle).second);
          return false;
        },
        &counts);
    CHECK_FALSE(stopped);
    CHECK(counts.triangles == visited.size());
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      const auto [a, b, c] = contact::triangle_of(mesh, k);
      const Aabb<double> box{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
      if (enters(box)) REQUIRE(visited.contains(static_cast<int>(k)));
    }
    CHECK(visited.size() < mesh.triangles.size() / 4);
  }
}

}  // namespace
