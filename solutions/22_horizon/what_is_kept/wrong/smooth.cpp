// misconception: friction-costs-nothing
// caught by: impacts that lose energy
// seen: not found
#include "what_is_kept.hpp"

namespace exercise {

// Two balls act on each other with opposite impulses at one point, friction included: that changes
// no momentum and no angular momentum of both together. What is left are the forces from outside.
Kept what_is_kept(const Scene& scene) {
  Kept kept{};
  kept.energy = scene.elastic;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    bool momentum = scene.gravity(k) == 0;
    bool angular = scene.gravity.cross(axis).isZero(0);
    for (const Eigen::Vector3d& normal : scene.normals) {
      momentum = momentum && normal(k) == 0;
      angular = angular && normal.cross(axis).isZero(0);
    }
    kept.momentum[static_cast<std::size_t>(k)] = momentum;
    kept.angular_momentum[static_cast<std::size_t>(k)] = angular || scene.on_z_axis;
  }
  kept.order = scene.on_z_axis;
  return kept;
}

}  // namespace exercise
