// misconception: sphere-as-point
// caught by: a falling sphere touches when its centre is at the distance of its radius
// seen: https://github.com/uic-evl/omegalib/issues/68 objects are culled by their centres
#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double side = distance < 0 ? -1 : 1;
  const double gap = side * distance;
  if (gap <= 0) return FirstTouch{0, sphere.centre - distance * plane.normal};
  const double closing = -side * plane.normal.dot(displacement);
  if (gap > closing) return std::nullopt;
  const double t = gap / closing;
  return FirstTouch{t, sphere.centre + t * displacement};
}

}  // namespace exercise
