/// @file
/// The energy that contact impulses add, and impulses between two given ones that add none.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/contact_iterations.hpp>
#include <contact/contact_settling.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/rigid_body.hpp>
#include <contact/symmetric_sum.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The bodies after all impulses: in the order of the list, or together (apply_together()).
template <std::floating_point S>
std::vector<RigidBody<S>> after_impulses(std::vector<RigidBody<S>> bodies,
                                         const std::vector<PreparedContact<S>>& contacts,
                                         const std::vector<ImpulseComponents<S>>& impulses,
                                         bool together = false) {
  if (together) {
    apply_together(bodies, contacts, impulses);
    return bodies;
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    const Vector3<S> impulse = p.direction[0] * impulses[i][0] + p.direction[1] * impulses[i][1] +
                               p.direction[2] * impulses[i][2];
    RigidBody<S>& a = bodies[index(p.contact.a)];
    RigidBody<S>& b = bodies[index(p.contact.b)];
    a = after_impulse<S>(a, impulse, p.contact.point);
    b = after_impulse<S>(b, Vector3<S>(-impulse), p.contact.point);
  }
  return bodies;
}

/// The kinetic energy that impulses have added, less the work of immovable bodies that move: the
/// sum over contacts of the impulse times the mean of the relative velocities before and after. The
/// difference of two energies would round to more than the energy of a light body beside a heavy
/// one. A sum that may be rounding counts as 0: up to 64 ε of the sum of the magnitudes of its
/// terms.
/// @throws std::invalid_argument if it overflows
template <std::floating_point S>
S energy_made(const std::vector<RigidBody<S>>& before, const std::vector<RigidBody<S>>& after,
              const std::vector<PreparedContact<S>>& contacts,
              const std::vector<ImpulseComponents<S>>& impulses) {
  std::vector<S> made;
  std::vector<S> sizes;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    const Vector3<S> mean =
        (relative_velocity(before, p.contact) + relative_velocity(after, p.contact)) / S(2);
    const auto speeds = [&](const std::vector<RigidBody<S>>& bodies) {
      return velocity_at(bodies[index(p.contact.a)], p.contact.point).cwiseAbs().maxCoeff() +
             velocity_at(bodies[index(p.contact.b)], p.contact.point).cwiseAbs().maxCoeff();
    };
    const S speed = speeds(before) + speeds(after);
    for (std::size_t k = 0; k < 3; ++k) {
      made.push_back(impulses[i][k] * mean.dot(p.direction[k]));
      sizes.push_back(std::abs(impulses[i][k]) * speed);
    }
  }
  const S sum = symmetric_sum(made);
  const S size = symmetric_sum(sizes);
  if (!std::isfinite(size))
    throw_invalid_argument("bodies", "?", "velocities and masses are too large: energies overflow");
  return sum > S(64) * std::numeric_limits<S>::epsilon() * size ? sum : S(0);
}

// [largest-share]
/// The impulses farthest on the segment from `from` to `to` that add no energy, if those of `from`
/// do not.
///
/// They are admissible, because no pull and friction inside its cone are convex conditions. The
/// velocities are linear on the segment, so a contact closes at most as fast as at the worse of the
/// two ends. The energy is a parabola that opens upwards, so the shares that add none are an
/// interval from 0 on, whose end bisection finds.
template <std::floating_point S>
std::vector<ImpulseComponents<S>> largest_share(const std::vector<RigidBody<S>>& bodies,
                                                const std::vector<PreparedContact<S>>& contacts,
                                                const std::vector<ImpulseComponents<S>>& from,
                                                const std::vector<ImpulseComponents<S>>& to,
                                                bool together) {
  const auto blend = [&](const S& share) {
    std::vector<ImpulseComponents<S>> mixed = from;
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) mixed[i][k] += share * (to[i][k] - from[i][k]);
    }
    return mixed;
  };
  S low(0);
  S high(1);
  for (int i = 0; i < 60; ++i) {
    const S middle = (low + high) / S(2);
    const std::vector<ImpulseComponents<S>> mixed = blend(middle);
    const auto then = after_impulses(bodies, contacts, mixed, together);
    (energy_made(bodies, then, contacts, mixed) > S(0) ? high : low) = middle;
  }
  return blend(low);
}
// [/largest-share]

/// The same contacts without restitution.
template <std::floating_point S>
std::vector<PreparedContact<S>> softened(std::vector<PreparedContact<S>> prepared) {
  for (auto& p : prepared) p.contact.min_velocity = std::min(p.contact.min_velocity, S(0));
  return prepared;
}

// [keep-energy]
/// Impulses without restitution that add no energy, for any impulses: these, if they add none; else
/// the largest share of them, starting from impulses without friction.
///
/// Without friction and restitution, iterations from zero never add energy, however many they are.
/// Proof: each iteration decreases f(x) = ½ x·A x + x·(v − w) from f(0) = 0, where w are the least
/// velocities. The energy added is ½ x·A x + x·v = f(x) + x·w, and x ≥ 0, w ≤ 0. With friction this
/// fails: where a normal impulse becomes smaller, so does its cone, and friction is cut to it,
/// which may add energy; two contacts can do so in turns for ever.
/// @param impulses admissible; replaced
/// @return whether they had to be
template <std::floating_point S>
bool keep_energy(const std::vector<RigidBody<S>>& bodies,
                 const std::vector<PreparedContact<S>>& contacts, const SolverSettings<S>& limits,
                 std::vector<ImpulseComponents<S>>& impulses) {
  const auto adds = [&](const std::vector<ImpulseComponents<S>>& x) {
    const auto after = after_impulses(bodies, contacts, x, limits.jacobi);
    return energy_made(bodies, after, contacts, x) > S(0);
  };
  if (!adds(impulses)) return false;
  const std::vector<ImpulseComponents<S>> none(contacts.size(),
                                               ImpulseComponents<S>{S(0), S(0), S(0)});
  std::vector<PreparedContact<S>> smooth = softened(contacts);
  for (PreparedContact<S>& p : smooth) p.contact.friction = S(0);
  std::vector<ImpulseComponents<S>> from = none;
  iterate_until(bodies, smooth, from, limits);
  if (adds(from)) from = none;  // by rounding
  impulses = largest_share(bodies, contacts, from, impulses, limits.jacobi);
  return true;
}
// [/keep-energy]

}  // namespace detail

}  // namespace contact
