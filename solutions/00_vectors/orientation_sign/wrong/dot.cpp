// misconception: dot-for-cross
// caught by: left, right and straight on
// seen: https://github.com/libgdx/libgdx/issues/1657
//   asks a dot product whether vectors are on one line
#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - b;
  const double left = first.dot(second);
  return left > 0 ? 1 : left < 0 ? -1 : 0;
}

}  // namespace exercise
