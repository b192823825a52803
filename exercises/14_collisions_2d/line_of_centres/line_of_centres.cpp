#include "line_of_centres.hpp"

namespace exercise {

std::optional<Eigen::Vector2d> line_of_centres(const Eigen::Vector2d& /*centre_a*/,
                                               const Eigen::Vector2d& /*centre_b*/) {
  contact::todo();
}

Parts parts(const Eigen::Vector2d& velocity, const Eigen::Vector2d& axis) {
  // How far the velocity reaches along the axis: a number. What is the part along it?
  [[maybe_unused]] const double reach = axis.dot(velocity);
  contact::todo();
}

}  // namespace exercise
