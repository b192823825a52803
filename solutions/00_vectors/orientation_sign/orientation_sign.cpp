#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  //? Only the directions matter: from a to b, and then from b to c.
  //? gap: b - a
  const Eigen::Vector2d first = b - a;
  //? The second direction begins where the first ends, at b.
  //? gap: c - b
  const Eigen::Vector2d second = c - b;
  //? The cross product in the plane is positive if the second direction points to the left of the
  //? first.
  //? gap: first.y() * second.x()
  const double left = first.x() * second.y() - first.y() * second.x();
  //? Only the sign is asked. Its zero stays a case of its own, without a tolerance.
  //? gap: left < 0 ? -1 : 0
  return left > 0 ? 1 : left < 0 ? -1 : 0;
}

}  // namespace exercise
