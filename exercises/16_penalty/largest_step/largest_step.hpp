/// @file
/// Exercise: a contact spring in time steps, and the longest step for which it is stable.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Where a body is along the normal of a contact, and how it moves.
struct State {
  double penetration;  ///< m; negative: a gap
  double approach;     ///< rate of change of the penetration, m/s
};

/// One step of semi-implicit Euler. The body stays attached to a spring and a damper, which push
/// and pull; no other force acts. First the velocity changes, by the force at the start of the
/// step. Then the penetration changes with the new velocity.
///
/// @param stiffness k, force against the penetration, N/m, greater than 0
/// @param damping c, force against the approach, N·s/m, 0 or more
/// @param mass kg, greater than 0
/// @param step s, greater than 0
State after_step(const State& now, double stiffness, double damping, double mass, double step);

/// The stability limit of these steps, in s. With every shorter step the body comes to rest, or
/// stays near 0 if there is no damping. With every longer step the motion grows, from almost every
/// start.
///
/// A step is a linear map with the trace T = 2 − a − b and the determinant D = 1 − b, where
/// a = h² k / m and b = h c / m. The motion does not grow as long as −T < 1 + D. The damping may be
/// a million times the critical one, 2 √(k m).
double largest_step(double stiffness, double damping, double mass);

}  // namespace exercise
