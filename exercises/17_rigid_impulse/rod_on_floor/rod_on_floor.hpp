/// @file
/// Exercise: a point of a body meets a rough floor.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A rigid body that moves in a vertical plane, x to the right and y up.
struct Body {
  double mass;               ///< kg, greater than 0
  double inertia;            ///< about the centre of mass, kg·m², greater than 0
  Eigen::Vector2d centre;    ///< of mass, m
  Eigen::Vector2d velocity;  ///< of the centre of mass, m/s
  double angular_velocity;   ///< angular velocity, rad/s, counter-clockwise
};

/// Its motion afterwards.
struct Motion {
  Eigen::Vector2d velocity;  ///< of the centre of mass, m/s
  double angular_velocity;   ///< rad/s
};

/// The motion after a point of the body has met the floor, with dry friction, by Stronge's law of
/// restitution.
///
/// Throughout the impact friction obeys Coulomb's law. While the point slips, each further
/// normal impulse brings μ times as much friction, against the slip. While it sticks, from the
/// first touch or later, the normal impulse brings the friction that sticking needs, at most μ
/// times itself; if that is not enough, the point slips to where the normal impulse drives it.
/// After greatest compression the normal impulse gives back e² of the work that it has absorbed.
///
/// @param body before
/// @param point of the body that touches the floor, m. If it does not move down, nothing happens
/// @param e coefficient of restitution, from 0 to 1
/// @param friction μ, not negative
Motion after_floor(const Body& body, const Eigen::Vector2d& point, double e, double friction);

}  // namespace exercise
