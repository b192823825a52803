// misconception: separating-discs-reflected
// caught by: discs approach or they do not
// seen: https://github.com/Famous/famous/pull/526 spheres that moved apart got an impulse
#include "two_discs.hpp"

namespace exercise {

bool approach(const Disc& a, const Disc& b) { return a.velocity != b.velocity; }

Velocities after_touch(const Disc& a, const Disc& b, double restitution) {
  if (!approach(a, b)) return {a.velocity, b.velocity};
  const Eigen::Vector2d n = (a.centre - b.centre).normalized();
  const double w = n.dot(a.velocity - b.velocity);
  const double j = -(1 + restitution) * w * a.mass * b.mass / (a.mass + b.mass);
  return {a.velocity + j / a.mass * n, b.velocity - j / b.mass * n};
}

}  // namespace exercise
