// FCL has no rays. A segment is a capsule of radius 0, which its solver compares with the
// triangles.
#include <fcl/fcl.h>

#include <cmath>

#include "peers.hpp"

namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

fcl::Vector3d vector(const peers::Floats& v) { return {v[0], v[1], v[2]}; }

}  // namespace

peers::Tree peers::fcl(const MeshOfFloats& mesh) {
  auto model = std::make_shared<std::shared_ptr<Model>>();
  Tree tree;
  tree.near_only = true;
  tree.build = [model, &mesh] {
    std::vector<::fcl::Vector3d> vertices;
    std::vector<::fcl::Triangle> triangles;
    for (const Floats& v : mesh.vertices) vertices.push_back(vector(v));
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                             static_cast<std::size_t>(c));
    }
    *model = std::make_shared<Model>();
    (*model)->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
    (*model)->addSubModel(vertices, triangles);
    (*model)->endModel();
  };
  tree.segment = [model](const RaysOfFloats& rays, Answers& answers) {
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      const ::fcl::Vector3d start = vector(rays.origins[i]), end = vector(rays.ends[i]);
      const ::fcl::Vector3d along = end - start;
      const double length = along.norm();
      ::fcl::Transform3d pose = ::fcl::Transform3d::Identity();
      pose.linear() =
          ::fcl::Quaterniond::FromTwoVectors(::fcl::Vector3d::UnitZ(), along).toRotationMatrix();
      pose.translation() = (start + end) / 2;
      const ::fcl::Capsuled capsule(0, length);
      const ::fcl::CollisionRequestd request(1, false);
      ::fcl::CollisionResultd result;
      ::fcl::collide(model->get(), ::fcl::Transform3d::Identity(), &capsule, pose, request, result);
      return result.isCollision();
    });
  };
  return tree;
}
