#include "grow_sphere.hpp"

namespace exercise {

ExtremePair most_distant_extremes(const std::vector<Eigen::Vector3d>& /*points*/) {
  contact::todo();
}

contact::Sphere<double> start_sphere(const Eigen::Vector3d& /*low*/,
                                     const Eigen::Vector3d& /*high*/) {
  contact::todo();
}

contact::Sphere<double> grown_by(const contact::Sphere<double>& /*sphere*/,
                                 const Eigen::Vector3d& /*point*/) {
  contact::todo();
}

contact::Sphere<double> grow_sphere(const std::vector<Eigen::Vector3d>& /*points*/) {
  contact::todo();
}

}  // namespace exercise
