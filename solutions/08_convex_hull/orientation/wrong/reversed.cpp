// misconception: turn-reversed
// caught by: left is plus and right is minus
// seen: https://github.com/cp-algorithms/cp-algorithms/pull/632 a text had plus for clockwise
#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double area = u.y() * v.x() - u.x() * v.y();
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

}  // namespace exercise
