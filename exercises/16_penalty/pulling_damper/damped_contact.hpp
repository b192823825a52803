/// @file
/// Code to break: a contact of a spring and a damper that ends where the overlap ends, as many
/// programs have it.
#pragma once

#include <cmath>

namespace given {

/// The force along the normal, in N: positive if it pushes the surfaces apart.
inline double contact_force(double penetration, double approach, double stiffness, double damping) {
  if (penetration < 0) return 0;
  return stiffness * penetration + damping * approach;
}

/// The speed with which a body leaves the surface, in m/s, by steps of a thousandth of √(m / k).
/// 0 if it has not left after a hundred √(m / k).
template <class Moment>
double rebound_speed(const Moment& start) {
  const double step = std::sqrt(start.mass / start.stiffness) / 1000;
  double penetration = start.penetration;
  double approach = start.approach;
  for (int k = 0; k < 100000; ++k) {
    const double force = contact_force(penetration, approach, start.stiffness, start.damping);
    approach -= step * force / start.mass;
    penetration += step * approach;
    if (penetration < 0) return -approach;
  }
  return 0;
}

}  // namespace given
