/// @file
/// One Gauss–Seidel iteration over contacts with one mistake that people make: what the test of the
/// exercise recognises.
#pragma once

#include <algorithm>
#include <cmath>

#include "gauss_seidel_contact.hpp"

namespace iteration_with_mistakes {

using exercise::Body;
using exercise::Contact;
using exercise::State;
using Vector = Eigen::Vector2d;

/// What is done wrong.
enum class Way {
  none,
  // The normal velocity.
  no_rotation,  ///< of the centres of mass
  from_b_to_a,  ///< that of b relative to a
  added,        ///< the velocities of both bodies added
  clockwise,    ///< the angular velocity counts clockwise
  from_origin,  ///< the lever arms begin at the origin
  a_alone,      ///< b counts as at rest
  // The inverse effective mass.
  masses_alone,    ///< without rotation
  moment_once,     ///< the moment of the normal is not squared
  whole_arm,       ///< the length of the lever arm in place of the moment
  mass_of_a,       ///< b does not count
  subtracted,      ///< what b does is subtracted
  effective_mass,  ///< 1 over it
  // The iteration.
  change_clamped,      ///< what a visit adds is 0 or more
  jacobi,              ///< the velocities are those before the iteration
  sum_applied,         ///< the bodies get the whole sum again
  forgets,             ///< the old sums are left out
  no_least,            ///< the least velocity is left out
  min_added,           ///< the least velocity has the wrong sign
  pushes_a_alone,      ///< b gets no impulse
  same_direction,      ///< both bodies get the same impulse
  no_turn,             ///< the impulses do not change angular velocities
  backwards,           ///< from the last contact to the first
  ends_at_separation,  ///< the iteration ends at the first contact that separates
  pulls,               ///< the sums may be negative
  not_kept,            ///< the sums are not kept
  multiplied,          ///< velocity times inverse effective mass
};

inline double moment(const Body& body, const Contact& contact, Way way = Way::none) {
  Vector arm = contact.point - body.position;
  if (way == Way::from_origin) arm = contact.point;
  return arm.x() * contact.normal.y() - arm.y() * contact.normal.x();
}

inline double velocity_along(const Body& body, const Contact& contact, Way way) {
  double turning = body.angular_velocity * moment(body, contact, way);
  if (way == Way::no_rotation) turning = 0;
  if (way == Way::clockwise) turning = -turning;
  return contact.normal.dot(body.velocity) + turning;
}

inline double normal_velocity(const Body& a, const Body& b, const Contact& contact, Way way) {
  const double of_a = velocity_along(a, contact, way), of_b = velocity_along(b, contact, way);
  if (way == Way::from_b_to_a) return of_b - of_a;
  if (way == Way::added) return of_a + of_b;
  return way == Way::a_alone ? of_a : of_a - of_b;
}

inline double inverse_mass_of(const Body& body, const Contact& contact, Way way) {
  double turned = moment(body, contact) * moment(body, contact);
  if (way == Way::masses_alone) turned = 0;
  if (way == Way::moment_once) turned = moment(body, contact);
  if (way == Way::whole_arm) turned = (contact.point - body.position).squaredNorm();
  return body.inverse_mass + turned * body.inverse_inertia;
}

inline double inverse_effective_mass(const Body& a, const Body& b, const Contact& contact,
                                     Way way) {
  const double of_a = inverse_mass_of(a, contact, way), of_b = inverse_mass_of(b, contact, way);
  if (way == Way::mass_of_a) return of_a;
  if (way == Way::subtracted) return of_a - of_b;
  return way == Way::effective_mass ? 1 / (of_a + of_b) : of_a + of_b;
}

inline void push(Body& body, const Contact& contact, double impulse, Way way) {
  body.velocity += contact.normal * (impulse * body.inverse_mass);
  if (way == Way::no_turn) return;
  body.angular_velocity += moment(body, contact) * impulse * body.inverse_inertia;
}

inline State after_iteration(const State& before, const std::vector<Contact>& contacts, Way way) {
  State now = before;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t k = way == Way::backwards ? contacts.size() - 1 - i : i;
    const Contact& contact = contacts[k];
    const auto first = static_cast<std::size_t>(contact.a);
    const auto second = static_cast<std::size_t>(contact.b);
    const State& seen = way == Way::jacobi ? before : now;
    double velocity = normal_velocity(seen.bodies[first], seen.bodies[second], contact, way);
    if (way == Way::min_added) velocity += contact.min_velocity;
    if (way != Way::no_least && way != Way::min_added) velocity -= contact.min_velocity;
    if (way == Way::ends_at_separation && velocity > 0) return now;
    const double k_n = inverse_effective_mass(now.bodies[first], now.bodies[second], contact, way);
    const double needed = way == Way::multiplied ? -velocity * k_n : -velocity / k_n;
    const double old = way == Way::forgets ? 0 : before.impulses[k];
    double sum = std::max(old + needed, 0.0);
    if (way == Way::change_clamped) sum = old + std::max(needed, 0.0);
    if (way == Way::pulls) sum = old + needed;
    const double change = way == Way::sum_applied ? sum : sum - old;
    push(now.bodies[first], contact, change, way);
    if (way != Way::pushes_a_alone)
      push(now.bodies[second], contact, way == Way::same_direction ? change : -change, way);
    if (way != Way::not_kept) now.impulses[k] = sum;
  }
  return now;
}

}  // namespace iteration_with_mistakes
