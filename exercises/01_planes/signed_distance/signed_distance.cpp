#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  // The left-hand side of the plane's equation, evaluated at the point. What is missing to make it
  // a distance?
  [[maybe_unused]] const double value = normal.dot(point) + plane.d;
  contact::todo();
}

int side(const PlaneEquation& /*plane*/, const Eigen::Vector3d& /*point*/) {
  // A sign needs less computation than a distance.
  contact::todo();
}

}  // namespace exercise
