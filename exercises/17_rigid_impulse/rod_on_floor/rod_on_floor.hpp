/// @file
/// Exercise: a corner of a body meets a rough floor.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A rigid body that moves in the plane, x to the right and y up.
struct Body {
  double mass;               ///< kg, greater than 0
  double inertia;            ///< about the centre of mass, kg·m², greater than 0
  Eigen::Vector2d centre;    ///< of mass, m
  Eigen::Vector2d velocity;  ///< of the centre of mass, m/s
  double spin;               ///< angular velocity, rad/s, counter-clockwise
};

/// How it moves afterwards.
struct Motion {
  Eigen::Vector2d velocity;  ///< of the centre of mass, m/s
  double spin;               ///< rad/s
};

/// The motion after a point of the body has met the floor, with dry friction, by Stronge's law of
/// restitution.
///
/// All through the impact the friction is Coulomb's: against the slip and μ times as strong as the
/// normal impulse while there is slip; while there is none, be it from the first touch or once the
/// slip has stopped, whatever keeps it so, up to μ times; and if that is not enough, the point
/// slips off the way in which the normal impulse pushes it. From the largest compression on, the
/// normal impulse gives back e² of the work that it has taken.
///
/// @param body before
/// @param point of the body that touches the floor, m. If it does not sink, nothing happens
/// @param e coefficient of restitution, from 0 to 1
/// @param friction μ, not negative
Motion after_floor(const Body& body, const Eigen::Vector2d& point, double e, double friction);

}  // namespace exercise
