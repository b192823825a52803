#include "what_is_kept.hpp"

namespace exercise {

// Two balls act on each other with opposite impulses at one point, friction included: that changes
// no momentum and no angular momentum of both together. What is left are the forces from outside.
Kept what_is_kept(const Scene& scene) {
  //? Nothing is kept until it is proven.
  Kept kept{};
  //? Energy is lost where k is below 1, and where surfaces slide on each other with friction. Head
  //? on and without rotation nothing slides. Gravity changes kinetic into potential energy.
  //? gap: !scene.friction || scene.on_z_axis
  kept.energy = scene.elastic && (!scene.friction || scene.on_z_axis);
  //? Momentum and angular momentum are vectors: each component is a question of its own.
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    //? A force has no component along the axis if it is perpendicular to it.
    //? gap: scene.gravity(k) == 0
    bool momentum = scene.gravity(k) == 0;
    //? Wherever it acts, it has no torque about the axis if it is parallel to it, or 0.
    //? gap: scene.gravity.cross(axis).isZero(0)
    bool angular = scene.gravity.cross(axis).isZero(0);
    //? A smooth wall pushes along its normal.
    //? gap: normal(k) == 0
    //? gap: normal.cross(axis).isZero(0)
    for (const Eigen::Vector3d& normal : scene.normals) {
      momentum = momentum && normal(k) == 0;
      angular = angular && normal.cross(axis).isZero(0);
    }
    //? Balls that move along a line through the origin have no angular momentum about it at all.
    //? gap: angular || scene.on_z_axis
    kept.momentum[static_cast<std::size_t>(k)] = momentum;
    kept.angular_momentum[static_cast<std::size_t>(k)] = angular || scene.on_z_axis;
  }
  //? On a line no ball gets past another; elsewhere balls pass beside each other.
  kept.order = scene.on_z_axis;
  //? This is the answer.
  return kept;
}

}  // namespace exercise
