// misconception: normal-not-normalised
// caught by: the length of a raw plane's normal is taken into account
// seen: https://github.com/ggambetta/computer-graphics-from-scratch/pull/10
//   a normal is used as one of length 1 and is not
#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  return std::abs(distance) <= sphere.radius;
}

bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane) {
  const double value = plane.normal.dot(sphere.centre) - plane.offset;
  return std::abs(value) <= sphere.radius;
}

}  // namespace exercise
