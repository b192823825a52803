/// @file
/// Exercise: the impulses of two contacts at the same time, without friction.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The change of the contacts' velocities per impulse, in 1/kg: entry (i, k) is the change of the
/// upward velocity of contact i for an upward impulse of 1 N·s at contact k.
///
/// A rigid body moves in a vertical plane and meets a floor at two of its points.
///
/// @param mass kg, greater than 0
/// @param inertia about the centre of mass, kg·m², greater than 0
/// @param lever_arms how far to the right of the centre of mass the contacts are, m; negative: to
/// the left
Eigen::Matrix2d inverse_effective_masses(double mass, double inertia,
                                         const Eigen::Vector2d& lever_arms);

/// The impulses x of the two contacts, in N·s, with the velocities w = a x + b above the least
/// ones:
///
/// - no impulse pulls: each xᵢ is 0 or more;
/// - no contact is too slow: each wᵢ is 0 or more;
/// - a contact with an impulse is not too fast: of xᵢ and wᵢ at least one is 0.
///
/// Exactly one x meets all three conditions. Which of the entries of x are 0 makes four cases.
///
/// @param a symmetric and positive definite, 1/kg. The entries beside the diagonal may be negative
/// @param b velocity of each contact before the impact minus the least that it may have afterwards,
/// m/s; positive is up
Eigen::Vector2d impulses(const Eigen::Matrix2d& a, const Eigen::Vector2d& b);

}  // namespace exercise
