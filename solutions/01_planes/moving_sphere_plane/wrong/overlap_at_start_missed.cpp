// misconception: overlap-at-start-missed
// caught by: a sphere that meets the plane at the start touches at once
// seen: https://github.com/bulletphysics/bullet3/issues/1250
//   a sweep does not reliably report what it overlaps at its start
#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double side = distance < 0 ? -1 : 1;
  const double gap = side * distance - sphere.radius;
  const double closing = -side * plane.normal.dot(displacement);
  const double t = gap / closing;
  if (!(t >= 0 && t <= 1) || gap <= 0) return std::nullopt;
  const Eigen::Vector3d centre = sphere.centre + t * displacement;
  return FirstTouch{t, centre - side * sphere.radius * plane.normal};
}

}  // namespace exercise
