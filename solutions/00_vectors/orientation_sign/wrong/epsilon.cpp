// misconception: absolute-epsilon
// caught by: a tiny path turns like a large one
// seen: https://github.com/cgogn/CGoGN_2/pull/285 a side that is compared with 1e-6
#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - b;
  const double left = first.x() * second.y() - first.y() * second.x();
  if (std::abs(left) < 1e-9) return 0;
  return left > 0 ? 1 : -1;
}

}  // namespace exercise
