/// @file
/// Exercise: the damper with which a body bounces off a spring at a given coefficient of
/// restitution.
///
/// A body of the given mass meets a spring and a damper in parallel. No other force acts. The
/// coefficient of restitution is the speed at the end of the contact over the speed at its
/// beginning. With the damping ratio ζ = c / (2 √(k m)) it does not depend on the speed.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The damping c, in N·s/m, if the contact ends at zero penetration. Until then the damper may
/// pull. The restitution is then exp(−π ζ / √(1 − ζ²)) for ζ < 1, and 0 for ζ = 1 or more.
///
/// It throws std::invalid_argument if no damper gives this restitution.
///
/// @param restitution any number; for 0 the result is the smallest damping that gives it
/// @param stiffness k, N/m, greater than 0
/// @param mass m, kg, greater than 0
double damping_to_zero_penetration(double restitution, double stiffness, double mass);

/// The damping c, in N·s/m, if the contact ends where spring and damper would begin to pull. With
/// ζ = cos θ the restitution is then exp(−2 ζ θ / sin θ). For ζ > 1 the quotient θ / sin θ is
/// arcosh ζ / √(ζ² − 1), and for ζ = 1 it is 1. The restitution decreases with ζ, and there is no
/// closed form for its inverse.
///
/// It throws std::invalid_argument if no damper gives this restitution.
///
/// @param restitution any number; numbers between 0 and 0.0001 are not tested
/// @param stiffness k, N/m, greater than 0
/// @param mass m, kg, greater than 0
/// @return an error of a millionth of the critical damping 2 √(k m) is allowed
double damping_to_zero_force(double restitution, double stiffness, double mass);

}  // namespace exercise
