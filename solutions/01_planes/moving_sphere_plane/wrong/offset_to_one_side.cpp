// misconception: offset-to-one-side
// caught by: a sphere can come from behind
// seen: FCA, slide "Sphere-Plane Collision", the surface is moved along its normal
#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double gap = distance - sphere.radius;
  const double closing = -plane.normal.dot(displacement);
  if (std::abs(distance) <= sphere.radius) {
    return FirstTouch{0, sphere.centre - distance * plane.normal};
  }
  const double t = gap / closing;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  return FirstTouch{t, sphere.centre + t * displacement - sphere.radius * plane.normal};
}

}  // namespace exercise
