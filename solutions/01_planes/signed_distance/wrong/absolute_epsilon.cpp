// misconception: absolute-epsilon
// caught by: a point near the plane is not on it
// seen: https://github.com/DavidArayan/ezy-slice/issues/11
//   small triangles are not cut, because of the test of the side
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  if (std::abs(value) < 1e-6) return 0;
  return value > 0 ? 1 : -1;
}

}  // namespace exercise
