// FCL: what it asks of two triangles, and two trees of oriented boxes.
#include <fcl/fcl.h>

#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "peers.hpp"

namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;
using Triangle = std::array<fcl::Vector3d, 3>;

fcl::Vector3d vector(const peers::Numbers& v) { return {v[0], v[1], v[2]}; }

std::shared_ptr<Model> model_of(const peers::MeshOfNumbers& mesh) {
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (const peers::Numbers& v : mesh.vertices) vertices.push_back(vector(v));
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                           static_cast<std::size_t>(c));
  }
  auto model = std::make_shared<Model>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

struct Both {
  std::shared_ptr<Model> first, second;
};

void collide(const Both& both, std::size_t most, fcl::CollisionResultd& result) {
  const fcl::CollisionRequestd request(most, false);
  fcl::collide(both.first.get(), fcl::Transform3d::Identity(), both.second.get(),
               fcl::Transform3d::Identity(), request, result);
}

}  // namespace

std::vector<peers::PairTest> peers::fcl_pairs() {
  return {pair_test(
      "FCL",
      [](const Corners& c) {
        return Triangle{vector(c[0]), vector(c[1]), vector(c[2])};
      },
      [](const Triangle& p, const Triangle& q) {
        return ::fcl::detail::Intersect<double>::intersect_Triangle(p[0], p[1], p[2], q[0], q[1],
                                                                    q[2]);
      })};
}

std::vector<peers::MeshTest> peers::fcl_meshes(const MeshOfNumbers& first,
                                               const MeshOfNumbers& second) {
  const auto make = [&first, &second] { return Both{model_of(first), model_of(second)}; };
  return {tree_test<::fcl::CollisionResultd>("FCL, OBBRSS", make, collide)};
}
