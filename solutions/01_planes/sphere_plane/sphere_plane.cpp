// The second test is the first, multiplied by the length of the normal and squared: no root, no
// division.
#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  return std::abs(distance) <= sphere.radius;
}

bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane) {
  const double value = plane.normal.dot(sphere.centre) - plane.offset;
  return value * value <= sphere.radius * sphere.radius * plane.normal.squaredNorm();
}

}  // namespace exercise
