#include "offset_plane.hpp"

namespace exercise {

contact::Plane<double> offset_plane(const contact::Plane<double>& /*plane*/,
                                    const contact::Sphere<double>& /*sphere*/) {
  contact::todo();
}

std::optional<Contact> sphere_meets_plane(const contact::Sphere<double>& /*sphere*/,
                                          const Eigen::Vector3d& /*displacement*/,
                                          const contact::Plane<double>& /*plane*/,
                                          double /*rise*/) {
  contact::todo();
}

}  // namespace exercise
