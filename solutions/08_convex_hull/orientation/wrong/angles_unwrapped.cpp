// misconception: angles-subtracted
// caught by: three points on one line give zero
#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double area = std::atan2(v.y(), v.x()) - std::atan2(u.y(), u.x());
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

}  // namespace exercise
