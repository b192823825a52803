// The second test is the first, multiplied by the length of the normal and squared: no root, no
// division.
#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane) {
  //? The plane has a unit normal, so this is the signed distance of the centre.
  //? gap: plane.normal.dot(sphere.centre)
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  //? The half-space does not matter, so the distance is taken without its sign. Touching counts.
  //? gap: std::abs(distance)
  return std::abs(distance) <= sphere.radius;
}

bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane) {
  //? With a normal of any length this is the distance times the length of the normal.
  const double value = plane.normal.dot(sphere.centre) - plane.offset;
  //? Both members are multiplied by the length and squared; they are not negative, so the
  //? comparison stays the same.
  //? gap: plane.normal.squaredNorm()
  return value * value <= sphere.radius * sphere.radius * plane.normal.squaredNorm();
}

}  // namespace exercise
