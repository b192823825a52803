// misconception: separating-touches
// caught by: a sphere that moves away, along or not far enough does not touch
// seen: https://github.com/JakeManfre/object-physics/issues/1
//   circles that leave a wall bounce again
#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double side = distance < 0 ? -1 : 1;
  const double gap = side * distance - sphere.radius;
  if (gap <= 0) return FirstTouch{0, sphere.centre - distance * plane.normal};
  const double closing = std::abs(plane.normal.dot(displacement));
  if (gap > closing) return std::nullopt;
  const double t = gap / closing;
  const Eigen::Vector3d centre = sphere.centre + t * displacement;
  return FirstTouch{t, centre - side * sphere.radius * plane.normal};
}

}  // namespace exercise
