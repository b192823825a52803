/// @file
/// Exercise: one iteration of the projected Gauss–Seidel method over contacts without friction.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A rigid body that moves in a plane.
struct Body {
  double inverse_mass;       ///< 1/kg; 0: it cannot be accelerated
  double inverse_inertia;    ///< about the centre of mass, 1/(kg·m²); 0: it cannot be rotated
  Eigen::Vector2d position;  ///< of the centre of mass, m
  Eigen::Vector2d velocity;  ///< of the centre of mass, m/s
  double angular_velocity;   ///< rad/s, counter-clockwise
};

/// A contact between two bodies of a list.
struct Contact {
  int a;                   ///< index of the body to which the normal points
  int b;                   ///< index of the body from which it points; not a
  Eigen::Vector2d point;   ///< m
  Eigen::Vector2d normal;  ///< unit vector
  double min_velocity;     ///< least normal velocity afterwards, m/s
};

/// What the iterations change.
struct State {
  std::vector<Body> bodies;
  std::vector<double> impulses;  ///< of each contact: the sum so far, N·s, 0 or more
};

/// The normal velocity of a contact, in m/s: that of the point on body a, relative to the point on
/// body b, along the normal. It is negative if the surfaces approach.
double normal_velocity(const Body& a, const Body& b, const Contact& contact);

/// The change of the normal velocity for an impulse of 1 N·s along the normal on body a, and the
/// opposite one on body b; in 1/kg.
double inverse_effective_mass(const Body& a, const Body& b, const Contact& contact);

/// The state after one iteration, which visits each contact once, in the order of the list.
///
/// At its visit a contact gets the impulse that brings its normal velocity to the least one, and
/// the bodies change their velocities at once. The sum of the impulses of a contact is never
/// negative: if the visit would make it so, it becomes 0.
///
/// @param before impulses of earlier iterations have already acted on these bodies
/// @param contacts any number, perhaps none; of each, at least one body can be accelerated
State after_iteration(const State& before, const std::vector<Contact>& contacts);

}  // namespace exercise
