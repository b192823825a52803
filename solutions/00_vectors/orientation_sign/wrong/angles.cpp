// misconception: angles-subtracted
// caught by: left, right and straight on
// seen: https://github.com/pygame/pygame/pull/4689 a signed angle as the difference of two atan2
#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - b;
  const double turn = std::atan2(second.y(), second.x()) - std::atan2(first.y(), first.x());
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

}  // namespace exercise
