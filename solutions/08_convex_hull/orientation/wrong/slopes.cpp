// misconception: turn-by-slopes
// caught by: steep and backward paths turn as others do
// seen: https://cs.stackexchange.com/questions/74944
#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double first = (b.y() - a.y()) / (b.x() - a.x());
  const double second = (c.y() - b.y()) / (c.x() - b.x());
  return second > first ? 1 : (second < first ? -1 : 0);
}

}  // namespace exercise
