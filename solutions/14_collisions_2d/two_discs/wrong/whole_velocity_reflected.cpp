// misconception: whole-velocity-reflected
// caught by: head-on it is a collision on a line
// seen: https://github.com/NTaylorMullen/ShootR/issues/23 a ship bounces directly back
#include "two_discs.hpp"

namespace exercise {

bool approach(const Disc& a, const Disc& b) {
  return (a.centre - b.centre).dot(a.velocity - b.velocity) < 0;
}

Velocities after_touch(const Disc& a, const Disc& b, double restitution) {
  if (!approach(a, b)) return {a.velocity, b.velocity};
  return {-restitution * a.velocity, -restitution * b.velocity};
}

}  // namespace exercise
