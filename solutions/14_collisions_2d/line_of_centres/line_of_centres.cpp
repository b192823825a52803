#include "line_of_centres.hpp"

namespace exercise {

std::optional<Eigen::Vector2d> line_of_centres(const Eigen::Vector2d& centre_a,
                                               const Eigen::Vector2d& centre_b) {
  if (centre_a == centre_b) return std::nullopt;
  const Eigen::Vector2d d = centre_a - centre_b;
  return d / d.norm();
}

Components components(const Eigen::Vector2d& velocity, const Eigen::Vector2d& axis) {
  const double normal_speed = axis.dot(velocity);
  const Eigen::Vector2d normal = normal_speed * axis;
  return {normal, velocity - normal};
}

}  // namespace exercise
