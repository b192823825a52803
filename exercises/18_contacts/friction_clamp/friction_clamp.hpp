/// @file
/// Exercise: one update of the impulses of a contact with friction.
///
/// A solver visits each contact again and again. It keeps the sum of the impulses that the contact
/// has got so far, and changes it at every visit.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The sum of the normal impulses after a visit, in N·s.
///
/// By itself the visit would stop the normal velocity: it would add −velocity times the effective
/// mass. But the sum is a push, so it is 0 or more.
///
/// @param sum before the visit, N·s, 0 or more
/// @param velocity along the normal at the visit, m/s; negative: the surfaces approach
/// @param effective_mass of the contact along its normal, kg, greater than 0
double normal_sum(double sum, double velocity, double effective_mass);

/// What a visit does to the friction. Vectors have components along two perpendicular tangents.
struct Friction {
  Eigen::Vector2d sum;     ///< of the friction impulses after the visit, N·s
  Eigen::Vector2d change;  ///< the impulse that the bodies get at this visit, N·s
  bool sticks;             ///< whether the whole slip is removed, as far as this contact can tell
};

/// The friction after a visit.
///
/// By itself the visit would stop the slip: it would add −slip times the effective mass. By
/// Coulomb's law the sum is no longer than μ times the normal impulse. A longer sum is replaced by
/// the nearest vector that is short enough. The contact sticks if the length before this
/// replacement is at most the largest allowed.
///
/// @param sum of the friction impulses before the visit, N·s
/// @param slip tangential velocity at the visit, m/s
/// @param effective_mass of the contact along every tangent, kg, greater than 0
/// @param mu coefficient of friction μ, 0 or more
/// @param normal sum of the normal impulses, N·s, 0 or more
Friction friction_after(const Eigen::Vector2d& sum, const Eigen::Vector2d& slip,
                        double effective_mass, double mu, double normal);

}  // namespace exercise
