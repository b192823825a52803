// Coal has no rays. A segment is a capsule of radius 0, which its solver compares with the
// triangles.
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/shape/geometric_shapes.h>

#include <Eigen/Geometry>
#include <cmath>

#include "peers.hpp"

namespace {

using Model = coal::BVHModel<coal::OBBRSS>;

coal::Vec3s vector(const peers::Floats& v) { return {v[0], v[1], v[2]}; }

}  // namespace

peers::Tree peers::coal(const MeshOfFloats& mesh) {
  auto model = std::make_shared<std::shared_ptr<Model>>();
  Tree tree;
  tree.build = [model, &mesh] {
    std::vector<::coal::Vec3s> vertices;
    std::vector<::coal::Triangle> triangles;
    for (const Floats& v : mesh.vertices) vertices.push_back(vector(v));
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                             static_cast<std::size_t>(c));
    }
    *model = std::make_shared<Model>();
    (*model)->beginModel(static_cast<unsigned>(triangles.size()),
                         static_cast<unsigned>(vertices.size()));
    (*model)->addSubModel(vertices, triangles);
    (*model)->endModel();
  };
  tree.segment = [model](const RaysOfFloats& rays, Answers& answers) {
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      const ::coal::Vec3s start = vector(rays.origins[i]), end = vector(rays.ends[i]);
      const ::coal::Vec3s along = end - start;
      const ::coal::Capsule capsule(0, along.norm());
      const ::coal::Transform3s pose(
          Eigen::Quaterniond::FromTwoVectors(::coal::Vec3s::UnitZ(), along).toRotationMatrix(),
          (start + end) / 2);
      const ::coal::CollisionRequest request(::coal::CONTACT, 1);
      ::coal::CollisionResult result;
      ::coal::collide(model->get(), ::coal::Transform3s(), &capsule, pose, request, result);
      return result.isCollision();
    });
  };
  return tree;
}
