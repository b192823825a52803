#include "world_inertia.hpp"

namespace exercise {

Eigen::Matrix3d box_inertia(double mass, const Eigen::Vector3d& size) {
  //? The moments need the squares of the edges.
  //? gap: size.cwiseProduct(size)
  const Eigen::Vector3d square = size.cwiseProduct(size);
  //? The distance from an axis has only the two other components.
  //? gap: square.y() + square.z()
  const Eigen::Vector3d about(square.y() + square.z(), square.z() + square.x(),
                              square.x() + square.y());
  //? A box has one twelfth of mass times these sums; about its own axes the products of inertia are
  //? zero.
  //? gap: about * mass / 12
  return (about * mass / 12).asDiagonal();
}

Eigen::Matrix3d about_point(const Eigen::Matrix3d& central, double mass,
                            const Eigen::Vector3d& offset) {
  //? Steiner: a point mass at the offset d has the inertia m(d² I − d dᵀ).
  //? gap: offset * offset.transpose()
  const Eigen::Matrix3d moved =
      offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose();
  //? The inertia about another point is that about the centre of mass and that of the whole mass at
  //? the offset.
  //? gap: mass * moved
  return central + mass * moved;
}

Eigen::Matrix3d in_world(const Eigen::Matrix3d& inertia, const Eigen::Matrix3d& rotation) {
  //? Rᵀ takes a vector into the body's axes, the inertia acts there, and R takes the result back.
  //? gap: inertia * rotation.transpose()
  return rotation * inertia * rotation.transpose();
}

}  // namespace exercise
