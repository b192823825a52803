/// @file
/// A stage: the bounces of impacts that were taken all at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <contact/contact_solver.hpp>
#include <contact/step_solver.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

/// What pushes in the islands in which something bounces, and the impulses to begin with.
struct BouncingContacts {
  std::vector<BodyContact<double>> contacts;
  std::vector<ContactImpulse<double>> start;
};

/// @param make a body, by its place, as it would be had nothing pushed it
template <class Make>
BouncingContacts bouncing_contacts(const SteppedSetup& setup, const SteppedState& state,
                                   const StepPart& part, const Make& make) {
  std::vector<BodyContact<double>> pushed;
  for (const StepBounce& bounce : part.bounces) pushed.push_back(bounce.contact);
  BouncingContacts found;
  for (const std::vector<std::size_t>& island : islands(setup, state, pushed)) {
    const std::size_t first = found.contacts.size();
    bool bounces = false;
    for (const std::size_t i : island) {
      const StepBounce& bounce = part.bounces[i];
      BodyContact<double> contact = bounce.contact;
      if (bounce.restitution > 0) {
        // As they lie now: what has turned on the way comes a little faster or slower.
        const Vector3<double> apart = velocity_at(make(index(contact.a)), contact.point) -
                                      velocity_at(make(index(contact.b)), contact.point);
        const double came = -contact.normal.dot(apart) - bounce.falls_on;
        contact.least_velocity = std::max(bounce.restitution * came, 0.0);
        bounces = bounces || contact.least_velocity > 0;
      }
      found.contacts.push_back(contact);
      found.start.push_back(bounce.stop);
    }
    if (bounces) continue;
    found.contacts.resize(first);
    found.start.resize(first);
  }
  return found;
}

}  // namespace detail

// [bounces-stage]
/// Of impacts that were taken all at once: now that they touch, they leave as restitution says.
///
/// All that pushed is solved once more, from the velocities that were there before it pushed. A
/// pair leaves with e times the speed at which it came; had it been stopped first, to bounce would
/// have made energy. Momentum is kept to rounding. Energy is kept where nothing rubs and e is 1,
/// but for what unfinished sweeps leave; angular momentum but for how far two slide past each other
/// in the part, as if the force between them had a lever.
inline void solve_bounces(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  const auto make = [&](std::size_t place) {
    const Vector3<double> zero = Vector3<double>::Zero();
    return detail::solver_body(setup, state, place,
                               place < setup.movers ? part.free_velocity[place] : zero,
                               place < part.free_spin.size() ? part.free_spin[place] : zero);
  };
  const auto all = detail::bouncing_contacts(setup, state, part, make);
  if (all.contacts.empty()) return;
  const auto give = [&](std::size_t place, const RigidBody<double>& body) {
    state.velocity.add(place, body.velocity - part.end_velocity[place]);
    if (turned_by_contacts(setup, place)) state.spin.add(place, body.spin - part.end_spin[place]);
  };
  const auto impulses = detail::solve_islands(setup, state, all.contacts, all.start,
                                              detail::SweepsFor::bounces, make, give);
  for (std::size_t first = 0, last = 0; first < all.contacts.size(); first = last) {
    bool hit = false;
    for (; last < all.contacts.size() && all.contacts[last].a == all.contacts[first].a &&
           all.contacts[last].b == all.contacts[first].b;
         ++last)
      hit = hit || all.contacts[last].least_velocity > 0;
    if (hit) detail::note_hit(setup, state, part, all.contacts, impulses, first, last);
  }
}
// [/bounces-stage]

}  // namespace contact
