// misconception: square-on-one-side
// caught by: the length of a raw plane's normal is taken into account
// seen: https://github.com/ggambetta/computer-graphics-from-scratch/issues/9
//   a distance is compared with the square of a radius
#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  return std::abs(distance) <= sphere.radius;
}

bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane) {
  const double value = plane.normal.dot(sphere.centre) - plane.offset;
  return std::abs(value) <= sphere.radius * plane.normal.squaredNorm();
}

}  // namespace exercise
