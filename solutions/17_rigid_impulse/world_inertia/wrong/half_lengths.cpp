// misconception: half-lengths-for-lengths
// caught by: a box is harder to turn across its length
#include "world_inertia.hpp"

namespace exercise {

Eigen::Matrix3d box_inertia(double mass, const Eigen::Vector3d& size) {
  const Eigen::Vector3d square = size.cwiseProduct(size);
  const Eigen::Vector3d about(square.y() + square.z(), square.z() + square.x(),
                              square.x() + square.y());
  return (about * mass / 3).asDiagonal();
}

Eigen::Matrix3d about_point(const Eigen::Matrix3d& central, double mass,
                            const Eigen::Vector3d& offset) {
  const Eigen::Matrix3d moved =
      offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose();
  return central + mass * moved;
}

Eigen::Matrix3d in_world(const Eigen::Matrix3d& inertia, const Eigen::Matrix3d& rotation) {
  return rotation * inertia * rotation.transpose();
}

}  // namespace exercise
