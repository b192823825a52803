/// @file
/// Exercise: the velocity after a bounce without friction.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The velocity after a bounce off a surface without friction, in m/s. A body that moves along the
/// surface or away from it does not bounce: its velocity is returned unchanged.
///
/// @param velocity before, m/s, relative to the surface
/// @param normal unit vector that points away from the surface
/// @param k coefficient of restitution, 0 to 1
Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double k);

}  // namespace exercise
