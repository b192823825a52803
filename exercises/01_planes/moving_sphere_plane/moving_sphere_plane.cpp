#include "moving_sphere_plane.hpp"

namespace exercise {

std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& /*sphere*/,
                                              const Eigen::Vector3d& /*displacement*/,
                                              const contact::Plane<double>& /*plane*/) {
  contact::todo();
}

}  // namespace exercise
