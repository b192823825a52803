#include "line_of_centres.hpp"

namespace exercise {

std::optional<Eigen::Vector2d> line_of_centres(const Eigen::Vector2d& /*centre_a*/,
                                               const Eigen::Vector2d& /*centre_b*/) {
  contact::todo();
}

Components components(const Eigen::Vector2d& velocity, const Eigen::Vector2d& axis) {
  // The component of the velocity along the axis is a number. What is the vector along it?
  [[maybe_unused]] const double normal_speed = axis.dot(velocity);
  contact::todo();
}

}  // namespace exercise
