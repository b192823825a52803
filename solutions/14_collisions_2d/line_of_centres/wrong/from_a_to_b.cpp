// misconception: axis-reversed
// caught by: the axis has length 1 and points from B to A
#include "line_of_centres.hpp"

namespace exercise {

std::optional<Eigen::Vector2d> line_of_centres(const Eigen::Vector2d& centre_a,
                                               const Eigen::Vector2d& centre_b) {
  if (centre_a == centre_b) return std::nullopt;
  const Eigen::Vector2d d = centre_b - centre_a;
  return d / d.norm();
}

Parts parts(const Eigen::Vector2d& velocity, const Eigen::Vector2d& axis) {
  const double reach = axis.dot(velocity);
  const Eigen::Vector2d along = reach * axis;
  return {along, velocity - along};
}

}  // namespace exercise
