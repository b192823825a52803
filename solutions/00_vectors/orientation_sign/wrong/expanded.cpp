// misconception: products-before-differences
// caught by: a path far from the origin turns like one near it
// seen: https://github.com/felt/tippecanoe/pull/19 areas get the wrong sign far from the origin
#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double left = (a.x() * b.y() - a.y() * b.x()) + (b.x() * c.y() - b.y() * c.x()) +
                      (c.x() * a.y() - c.y() * a.x());
  return left > 0 ? 1 : left < 0 ? -1 : 0;
}

}  // namespace exercise
