#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  // Test the centre against the plane moved by the radius, towards the side on which the centre is
  // at the start.
  const double side = distance < 0 ? -1 : 1;
  const double gap = side * distance - sphere.radius;
  if (gap <= 0) return FirstTouch{0, sphere.centre - distance * plane.normal};
  const double closing = -side * plane.normal.dot(displacement);
  if (gap > closing) return std::nullopt;  // away, along, or not far enough
  const double t = gap / closing;
  const Eigen::Vector3d centre = sphere.centre + t * displacement;
  return FirstTouch{t, centre - side * sphere.radius * plane.normal};
}

}  // namespace exercise
