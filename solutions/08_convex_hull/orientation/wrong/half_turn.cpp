// misconception: none
// caught by: steep and backward paths turn as others do
// seen: a first reader of this book
#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  if (a == b || a == c || b == c) return 0;
  const double pi = 3.14159265358979323846;
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - b;
  double angle = std::atan2(v.y(), v.x()) - std::atan2(u.y(), u.x());
  if (angle > pi) angle -= 2 * pi;
  if (angle < -pi) angle += 2 * pi;
  return angle > 0 ? 1 : (angle < 0 ? -1 : 0);
}

}  // namespace exercise
