/// @file
/// Exercise: a bounce with friction, and the angle of rebound.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The velocity after a bounce off a rough surface of a body that does not turn, in m/s. The
/// surface gives it a change of velocity along the normal, and friction one against its motion
/// along the surface: up to friction times as large, and no larger than what stops that motion.
/// What moves along the surface or away from it does not bounce: its velocity comes back unchanged.
///
/// @param velocity before, m/s, relative to the surface
/// @param normal unit vector that points away from the surface
/// @param k coefficient of restitution, 0 to 1
/// @param friction coefficient, 0 or more
Eigen::Vector3d after_rough_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                                   double k, double friction);

/// The tangent of the angle of rebound of such a bounce. Both angles are from the normal.
///
/// @param incidence tangent of the angle of incidence, 0 or more
/// @param k coefficient of restitution, greater than 0, at most 1
/// @param friction coefficient, 0 or more
double rebound_tangent(double incidence, double k, double friction);

}  // namespace exercise
