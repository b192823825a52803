// misconception: touching-rejected
// caught by: a sphere that touches meets the plane
// seen: L20, slide "Sphere-Plane Intersection", |n · C − k| < r
#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  return std::abs(distance) < sphere.radius;
}

bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane) {
  const double value = plane.normal.dot(sphere.centre) - plane.offset;
  return value * value < sphere.radius * sphere.radius * plane.normal.squaredNorm();
}

}  // namespace exercise
