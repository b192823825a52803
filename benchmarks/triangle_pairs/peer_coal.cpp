// Coal: the distance of two triangles by GJK, as at the leaves of its trees, and two trees of
// oriented boxes.
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/internal/shape_shape_func.h>
#include <coal/narrowphase/narrowphase.h>
#include <coal/shape/geometric_shapes.h>

#include "peers.hpp"

namespace {

using Model = coal::BVHModel<coal::OBBRSS>;

coal::Vec3s vector(const peers::Numbers& v) { return {v[0], v[1], v[2]}; }

std::shared_ptr<Model> model_of(const peers::MeshOfNumbers& mesh) {
  std::vector<coal::Vec3s> vertices;
  std::vector<coal::Triangle> triangles;
  for (const peers::Numbers& v : mesh.vertices) vertices.push_back(vector(v));
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                           static_cast<std::size_t>(c));
  }
  auto model = std::make_shared<Model>();
  model->beginModel(static_cast<unsigned>(triangles.size()),
                    static_cast<unsigned>(vertices.size()));
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

struct Both {
  std::shared_ptr<Model> first, second;
};

void collide(const Both& both, std::size_t most, coal::CollisionResult& result) {
  const coal::CollisionRequest request(coal::NO_REQUEST, most);
  coal::collide(both.first.get(), coal::Transform3s(), both.second.get(), coal::Transform3s(),
                request, result);
}

}  // namespace

std::vector<peers::PairTest> peers::coal_pairs() {
  return {pair_test(
      "Coal, GJK",
      [](const Corners& c) { return ::coal::TriangleP(vector(c[0]), vector(c[1]), vector(c[2])); },
      [](const ::coal::TriangleP& p, const ::coal::TriangleP& q) {
        const ::coal::CollisionRequest request(::coal::NO_REQUEST, 1);
        const ::coal::GJKSolver solver(request);
        const ::coal::Transform3s here;
        ::coal::Vec3s on_p, on_q, normal;
        const double distance =
            ::coal::internal::ShapeShapeDistance<::coal::TriangleP, ::coal::TriangleP>(
                &p, here, &q, here, &solver, false, on_p, on_q, normal);
        return distance <= request.collision_distance_threshold;
      })};
}

std::vector<peers::MeshTest> peers::coal_meshes(const MeshOfNumbers& first,
                                                const MeshOfNumbers& second) {
  const auto make = [&first, &second] { return Both{model_of(first), model_of(second)}; };
  return {tree_test<::coal::CollisionResult>("Coal, OBBRSS", make, collide)};
}
