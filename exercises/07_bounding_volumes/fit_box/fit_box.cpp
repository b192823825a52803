#include "fit_box.hpp"

namespace exercise {

contact::OrientedBox<double> fit_box(const Eigen::Matrix3d& /*axes*/,
                                     const std::vector<Eigen::Vector3d>& /*vertices*/) {
  contact::todo();
}

std::array<contact::Plane<double>, 6> face_planes(const contact::OrientedBox<double>& /*box*/) {
  contact::todo();
}

bool is_inside(const contact::OrientedBox<double>& /*box*/, const Eigen::Vector3d& /*point*/) {
  contact::todo();
}

}  // namespace exercise
