// misconception: whole-velocities-exchanged
// caught by: an oblique collision changes only the normal components
// seen: https://github.com/CleverRaven/Cataclysm-DDA/pull/28540
//   a collision in a plane is computed along a velocity
#include "two_discs.hpp"

namespace exercise {

bool approach(const Disc& a, const Disc& b) {
  return (a.centre - b.centre).dot(a.velocity - b.velocity) < 0;
}

Velocities after_touch(const Disc& a, const Disc& b, double restitution) {
  if (!approach(a, b)) return {a.velocity, b.velocity};
  const Eigen::Vector2d w = a.velocity - b.velocity;
  const double share = (1 + restitution) / (a.mass + b.mass);
  return {a.velocity - share * b.mass * w, b.velocity + share * a.mass * w};
}

}  // namespace exercise
