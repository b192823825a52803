// misconception: normal-not-normalised
// caught by: the normal is a unit vector
// seen: L20, slide "Triangle vs. Triangle", cross products as normals of planes, and distances
#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  const Eigen::Vector3d raw = (b - a).cross(c - a);
  if (raw == Eigen::Vector3d::Zero()) {
    throw std::invalid_argument("a, b and c are on one line");
  }
  return {raw, raw.dot(a)};
}

}  // namespace exercise
