#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  //? Two edges from one vertex lie in the plane; their cross product is orthogonal to both.
  //? gap: (b - a).cross(c - a)
  const Eigen::Vector3d raw = (b - a).cross(c - a);
  //? On one line the edges are parallel, and the cross product is the zero vector.
  //? gap: raw == Eigen::Vector3d::Zero()
  // Only zero: a small cross product may belong to a small triangle.
  if (raw == Eigen::Vector3d::Zero()) {
    throw std::invalid_argument("a, b and c are on one line");
  }
  //? A unit normal makes the offset, and all later distances, lengths in metres.
  //? gap: raw / raw.norm()
  const Eigen::Vector3d normal = raw / raw.norm();
  //? Every point of the plane has the same dot product with the normal, so any of the three gives
  //? the offset.
  //? gap: normal.dot(a)
  return {normal, normal.dot(a)};
}

}  // namespace exercise
