// misconception: angles-by-atan2
// caught by: a cross product of 1 counts on a long path
// seen: https://github.com/firemodels/fds/pull/4924 replaces an angle by a cross product
#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double pi = 3.14159265358979323846;
  double angle =
      std::atan2(c.y() - a.y(), c.x() - a.x()) - std::atan2(b.y() - a.y(), b.x() - a.x());
  if (angle > pi) angle -= 2 * pi;
  if (angle <= -pi) angle += 2 * pi;
  if (a == b || a == c || std::abs(angle) == pi) return 0;
  return angle > 0 ? 1 : (angle < 0 ? -1 : 0);
}

}  // namespace exercise
