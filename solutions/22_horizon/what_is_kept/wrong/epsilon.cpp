// misconception: absolute-epsilon
// caught by: the smallest component counts
// seen: https://github.com/flow123d/flow123d/issues/374 velocities below 1e-8 are taken for zero
#include "what_is_kept.hpp"

namespace exercise {

// Two balls act on each other with opposite impulses at one point, friction included: that changes
// no momentum and no angular momentum of both together. What is left are the forces from outside.
Kept what_is_kept(const Scene& scene) {
  Kept kept{};
  kept.energy = scene.elastic && (!scene.friction || scene.on_z_axis);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    bool momentum = std::abs(scene.gravity(k)) < 1e-9;
    bool angular = scene.gravity.cross(axis).isZero(1e-9);
    for (const Eigen::Vector3d& normal : scene.normals) {
      momentum = momentum && std::abs(normal(k)) < 1e-9;
      angular = angular && normal.cross(axis).isZero(1e-9);
    }
    kept.momentum[static_cast<std::size_t>(k)] = momentum;
    kept.angular_momentum[static_cast<std::size_t>(k)] = angular || scene.on_z_axis;
  }
  kept.order = scene.on_z_axis;
  return kept;
}

}  // namespace exercise
