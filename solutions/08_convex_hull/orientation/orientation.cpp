#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double area = u.x() * v.y() - u.y() * v.x();
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

}  // namespace exercise
