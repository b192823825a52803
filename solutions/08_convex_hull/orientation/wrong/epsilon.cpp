// misconception: epsilon-orientation
// caught by: a cross product of 1 counts on a long path
// seen: https://github.com/jhasse/poly2tri/issues/39 a tolerance takes a slight turn for none
#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double area = u.x() * v.y() - u.y() * v.x();
  if (std::abs(area) <= 1e-9 * u.norm() * v.norm()) return 0;
  return area > 0 ? 1 : -1;
}

}  // namespace exercise
