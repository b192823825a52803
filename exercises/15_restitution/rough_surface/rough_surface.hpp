/// @file
/// Exercise: a bounce with friction, and the angle of rebound.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The velocity of a body that does not rotate after a bounce off a rough surface, in m/s. The
/// normal velocity changes as without friction. Friction changes the tangential velocity, against
/// its direction, by at most `friction` times the change of the normal velocity, and by no more
/// than what stops it (no tangential restitution). A body that moves along the surface or away from
/// it does not bounce: its velocity is returned unchanged.
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
