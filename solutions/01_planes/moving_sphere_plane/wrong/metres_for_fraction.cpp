// misconception: metres-for-fraction
// caught by: a falling sphere touches when its centre is at the distance of its radius
// seen: L20, slide "Line-Sphere Intersection"
//   D is a unit vector, later the displacement with 0 < t < 1
#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane) {
  const Eigen::Vector3d direction = displacement.normalized();
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double side = distance < 0 ? -1 : 1;
  const double gap = side * distance - sphere.radius;
  if (gap <= 0) return FirstTouch{0, sphere.centre - distance * plane.normal};
  const double t = gap / (-side * plane.normal.dot(direction));
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  return FirstTouch{t, sphere.centre + t * direction - side * sphere.radius * plane.normal};
}

}  // namespace exercise
