// Is right, and holds a main() that the preprocessor takes out.
#include "signed_distance.hpp"

#if 0
int main() { return 0; }
#endif

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = plane.a * point.x() + plane.b * point.y() + plane.c * point.z() + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
