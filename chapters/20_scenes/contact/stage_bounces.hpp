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

inline BouncingContacts bouncing_contacts(const SteppedSetup& setup, const SteppedState& state,
                                          const StepPart& part) {
  std::vector<BodyContact<double>> pushed;
  for (const StepBounce& bounce : part.bounces) pushed.push_back(bounce.contact);
  const auto bounces = [&](std::size_t i) { return pushed[i].least_velocity > 0; };
  BouncingContacts found;
  for (const std::vector<std::size_t>& island : islands(setup, state, pushed)) {
    if (std::none_of(island.begin(), island.end(), bounces)) continue;
    for (const std::size_t i : island) {
      found.contacts.push_back(pushed[i]);
      found.start.push_back(part.bounces[i].stop);
    }
  }
  return found;
}

}  // namespace detail

// [bounces-stage]
/// Of impacts that are taken all at once: how each leaves, as restitution says.
///
/// All that pushes is solved once more, from the velocities that are there before it pushes. A pair
/// leaves with e times the speed at which it comes; had it been stopped first, to bounce would make
/// energy. Momentum is kept to rounding. Energy is kept where nothing rubs and e is 1, but for what
/// unfinished sweeps leave.
inline void solve_bounces(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  if (part.bounces.empty()) return;
  const auto all = detail::bouncing_contacts(setup, state, part);
  const auto make = [&](std::size_t place) {
    const Vector3<double> zero = Vector3<double>::Zero();
    return detail::solver_body(setup, state, place,
                               place < setup.movers ? part.free_velocity[place] : zero,
                               place < part.free_spin.size() ? part.free_spin[place] : zero);
  };
  const auto give = [&](std::size_t place, const RigidBody<double>& body) {
    part.bounced.push_back({place, body.velocity, body.spin, orientation_of(setup, state, place)});
  };
  const auto impulses = detail::solve_islands(setup, state, all.contacts, all.start, part.planned,
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

// [leaving-stage]
/// Who has bounced has come to touch by now, and leaves. What has turned meanwhile spins as before
/// in its own axes: so it has the same energy. Its angular momentum is off by what it has turned.
inline void leave_bounced(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  for (const BouncedBody& body : part.bounced) {
    state.velocity.set(body.place, body.velocity);
    if (!turned_by_contacts(setup, body.place)) continue;
    Vector3<double> spin = body.spin;
    if (!setup.bodies[body.place].round) {
      const Vector3<double> own = matrix_of(body.orientation).transpose() * spin;
      spin = matrix_of(state.orientation[body.place]) * own;
    }
    state.spin.set(body.place, spin);
  }
}
// [/leaving-stage]

}  // namespace contact
