// The names of a mesh's features, and which edges are flat.
#include <contact/mesh_features.hpp>
#include <contact/mesh_shapes.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cstddef>
#include <limits>
#include <set>

namespace mesh_features_tests {

using contact::FeatureKind;
using contact::Mesh;
using contact::NamedFeature;

TEST_CASE("the diagonals of a box are inside its faces, and its edges are not") {
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {1, 2, 3});
  const contact::FeatureNames names(box);
  std::set<NamedFeature> faces, edges;
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    faces.insert(names.of(i, {}));
    for (int e = 0; e < 3; ++e) {
      const NamedFeature name = names.of(i, {FeatureKind::edge, e});
      CHECK((name.kind == FeatureKind::face) == names.is_flat(i, e));
      if (name.kind == FeatureKind::edge) edges.insert(name);
    }
  }
  CHECK(faces.size() == 6);
  CHECK(edges.size() == 12);
}

TEST_CASE("an edge is not flat if its triangles are folded, or bent by one step, or three") {
  Mesh<double> m{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  CHECK(contact::FeatureNames(m).is_flat(0, 0));
  CHECK(contact::FeatureNames(m).is_flat(1, 0));
  Mesh<double> bent = m;
  bent.vertices[3].z() = std::numeric_limits<double>::denorm_min();
  CHECK(!contact::FeatureNames(bent).is_flat(0, 0));
  Mesh<double> folded = m;
  folded.vertices[3] = {1, 1, 0};
  CHECK(!contact::FeatureNames(folded).is_flat(0, 0));
  Mesh<double> three = m;
  three.vertices.push_back({0, 0, 1});
  three.triangles.push_back({0, 1, 4});
  CHECK(!contact::FeatureNames(three).is_flat(0, 0));
}

}  // namespace mesh_features_tests
