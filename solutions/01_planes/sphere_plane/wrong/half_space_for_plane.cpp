// misconception: half-space-for-plane
// caught by: the plane has two sides
// seen: https://github.com/mrdoob/three.js/pull/7438 the absolute value was forgotten
#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  return distance <= sphere.radius;
}

bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane) {
  const double value = plane.normal.dot(sphere.centre) - plane.offset;
  return value * value <= sphere.radius * sphere.radius * plane.normal.squaredNorm();
}

}  // namespace exercise
