// misconception: turn-reversed
// caught by: left, right and straight on
// seen: https://github.com/cp-algorithms/cp-algorithms/pull/632
//   the area's sign was stated as positive for clockwise
#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - b;
  const double left = first.y() * second.x() - first.x() * second.y();
  return left > 0 ? 1 : left < 0 ? -1 : 0;
}

}  // namespace exercise
