/// @file
/// Exercise: the force of a contact that is a spring and a damper, and that does not pull.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// A spring and a damper in parallel, which push two surfaces apart while they touch or overlap.
struct Spring {
  double stiffness;  ///< force per penetration, N/m, greater than 0
  double damping;    ///< force per speed of approach, N·s/m, 0 or more
};

/// The force along the normal, in N: positive if it pushes the surfaces apart.
///
/// - Without contact there is no force. Touching, a penetration of 0, is a contact.
/// - The damper also resists separation. Where spring and damper together would pull, the contact
///   lets go: the result is 0.
///
/// @param penetration m; negative: a gap
/// @param approach rate of change of the penetration, m/s; negative: the surfaces separate
double contact_force(double penetration, double approach, const Spring& spring);

/// The force on a ball from a half-space at rest, in N. There is no friction.
///
/// The half-space is solid: a ball with its centre inside overlaps by more than its radius.
///
/// @param ball with a radius greater than 0
/// @param velocity of its centre, m/s
/// @param surface of the half-space: normal·x = offset, with a unit normal that points out of it
Eigen::Vector3d force_on_ball(const contact::Sphere<double>& ball, const Eigen::Vector3d& velocity,
                              const contact::Plane<double>& surface, const Spring& spring);

}  // namespace exercise
