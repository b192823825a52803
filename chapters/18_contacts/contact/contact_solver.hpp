/// @file
/// Many contacts with friction: sequential impulses, iterated (projected Gauss–Seidel or Jacobi).
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <contact/contact_energy.hpp>
#include <contact/contact_iterations.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_settling.hpp>
#include <contact/friction_pyramid.hpp>
#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/rigid_body.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Bodies after the contact impulses, and these impulses.
template <Ring S>
struct SolvedContacts {
  std::vector<RigidBody<S>> bodies;         ///< in the order of the input
  std::vector<ContactImpulse<S>> impulses;  ///< one a contact
  SolverReport<S> report;                   ///< of the iterations
};

namespace detail {

/// @throws std::invalid_argument as solve_contacts() does
template <std::floating_point S>
std::vector<PreparedContact<S>> prepared_contacts(const std::vector<RigidBody<S>>& bodies,
                                                  const std::vector<BodyContact<S>>& contacts,
                                                  bool together = false,
                                                  FrictionBound bound = FrictionBound::cone) {
  std::vector<PreparedContact<S>> prepared;
  prepared.reserve(contacts.size());
  for (const BodyContact<S>& c : contacts) {
    const int count = static_cast<int>(bodies.size());
    if (c.a < 0 || c.a >= count || c.b < 0 || c.b >= count || c.a == c.b) {
      throw_invalid_argument("contacts",
                             "bodies " + std::to_string(c.a) + " and " + std::to_string(c.b),
                             "must be two of the list");
    }
    require_finite("point", c.point);
    require_finite("normal", c.normal);
    require_finite("min_velocity", c.min_velocity);
    if (!(c.friction >= S(0)) || !is_finite(c.friction)) {
      throw_invalid_argument("friction", number_text(c.friction), "must not be negative");
    }
    prepared.push_back(detail::prepared(bodies, c, together));
    prepared.back().bound = bound;
    if (!is_finite(prepared.back().inverse_normal_mass) ||
        !is_finite(prepared.back().inverse_tangent_mass)) {
      throw_invalid_argument("bodies", std::to_string(c.a) + " and " + std::to_string(c.b),
                             "are too light for so long a lever arm: effective masses underflow");
    }
  }
  return prepared;
}

/// Projects impulses onto the admissible ones: no pull, friction inside its bound, and none between
/// two immovable bodies, where no iteration could take it back. An empty list gives zeros.
template <std::floating_point S>
std::vector<ImpulseComponents<S>> clamped_impulses(const std::vector<PreparedContact<S>>& prepared,
                                                   const std::vector<ContactImpulse<S>>& start) {
  std::vector<ImpulseComponents<S>> impulses(prepared.size(),
                                             ImpulseComponents<S>{S(0), S(0), S(0)});
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (!(prepared[i].inverse_normal_mass > S(0))) continue;
    const S normal = std::max(S(0), start[i].normal);
    const S one = start[i].tangential.dot(prepared[i].direction[1]);
    const S two = start[i].tangential.dot(prepared[i].direction[2]);
    const Vector2<S> friction =
        bounded_friction<S>(prepared[i].bound, {one, two}, prepared[i].contact.friction * normal);
    impulses[i] = {normal, friction.x(), friction.y()};
  }
  return impulses;
}

/// Impulses as vectors, from their components.
template <std::floating_point S>
std::vector<ContactImpulse<S>> impulses_of(const std::vector<PreparedContact<S>>& prepared,
                                           const std::vector<ImpulseComponents<S>>& components) {
  std::vector<ContactImpulse<S>> impulses;
  impulses.reserve(prepared.size());
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    const auto& [normal, one, two] = components[i];
    impulses.push_back(
        {normal, Vector3<S>(prepared[i].direction[1] * one + prepared[i].direction[2] * two)});
  }
  return impulses;
}

/// The bodies after impulses, and their report. If restitution has added energy, it is reduced
/// until it does not. The work of immovable bodies that move does not count as added, so they make
/// no difference: energy_made() depends only on relative velocities, and so does the proof of
/// keep_energy() for the impulses without restitution.
/// @param contacts, prepared the same, as given and prepared
/// @param stop returns the impulses without restitution, which add no energy
template <std::floating_point S, class Stop>
SolvedContacts<S> solved_by(const std::vector<RigidBody<S>>& bodies,
                            const std::vector<PreparedContact<S>>& prepared,
                            std::vector<ImpulseComponents<S>> impulses, const Stop& stop,
                            const S& tolerance, bool together = false) {
  SolvedContacts<S> solved;
  solved.bodies = after_impulses(bodies, prepared, impulses, together);
  solved.report.residual = largest_residual(solved.bodies, prepared, impulses);
  bool bounces = false;
  for (const PreparedContact<S>& p : prepared) bounces = bounces || p.contact.min_velocity > S(0);
  if (bounces && energy_made(bodies, solved.bodies, prepared, impulses) > S(0)) {
    const std::vector<ImpulseComponents<S>> stopped = stop();
    const S residual = largest_residual(after_impulses(bodies, prepared, stopped, together),
                                        softened(prepared), stopped);
    if (!(residual <= solved.report.residual)) solved.report.residual = residual;
    impulses = largest_share(bodies, prepared, stopped, impulses, together);
    solved.bodies = after_impulses(bodies, prepared, impulses, together);
    solved.report.blended = true;
  }
  solved.report.rounding = impulse_rounding(bodies, prepared, impulses);
  solved.report.settled = solved.report.residual <= tolerance + solved.report.rounding;
  solved.impulses = impulses_of(prepared, impulses);
  return solved;
}

/// The bodies after impulses with which iterations ended, and what they are worth: energy is kept
/// (keep_energy(), or by solved_by() where there is restitution).
/// @param report of the iterations
template <std::floating_point S>
SolvedContacts<S> solved_after(const std::vector<RigidBody<S>>& bodies,
                               const std::vector<PreparedContact<S>>& prepared,
                               std::vector<ImpulseComponents<S>> impulses,
                               const SolverReport<S>& report, const SolverSettings<S>& limits) {
  const bool bounces =
      std::any_of(prepared.begin(), prepared.end(),
                  [](const PreparedContact<S>& p) { return p.contact.min_velocity > S(0); });
  bool reduced = !bounces && keep_energy(bodies, prepared, limits, impulses);
  const auto stop = [&] {
    const auto soft = softened(prepared);
    std::vector<ImpulseComponents<S>> stopped = clamped_impulses<S>(prepared, {});
    iterate_until(bodies, soft, stopped, limits);
    reduced = keep_energy(bodies, soft, limits, stopped);
    return stopped;
  };
  SolvedContacts<S> solved =
      solved_by<S>(bodies, prepared, std::move(impulses), stop, limits.tolerance, limits.jacobi);
  solved.report.iterations = report.iterations;
  solved.report.last_change = report.last_change;
  solved.report.friction_reduced = reduced;
  solved.report.settled = solved.report.settled && !reduced;
  if (!std::all_of(solved.impulses.begin(), solved.impulses.end(),
                   [](const auto& x) { return is_finite(x.normal) && all_finite(x.tangential); })) {
    throw_invalid_argument("bodies", "?", "velocities and masses are too large: impulses overflow");
  }
  return solved;
}

}  // namespace detail

// [solve]
/// The impulses at all contacts, with friction, by sequential impulses (projected Gauss–Seidel) or
/// by simultaneous impulses (projected Jacobi).
///
/// After any number of iterations: no normal impulse pulls; the friction of each contact is inside
/// its cone, |tangential| ≤ μ normal up to rounding (or inside the pyramid of the settings, which
/// is up to √2 times as long); and momentum and angular momentum are conserved up to the rounding
/// of the velocities, because each impulse acts on A and its opposite on B at one point. The
/// velocities are computed from the impulses at the end, once, in the order of the list.
///
/// If the report says `settled` and not `blended`, no contact is slower than its least velocity,
/// contacts with an impulse are that fast (complementarity), and Coulomb's law holds (with the
/// pyramid, its own), all up to the tolerance plus the rounding of the report. If it says `settled`
/// and `blended`, this is so for two sets of impulses, those without and those with restitution, of
/// which the result is a mixture: a contact may be slower than its least velocity, but not slower
/// than the smaller of this and 0. Iterations with friction need not settle: two contacts can
/// repeat two states in turns for ever. Then the report says so.
///
/// Settled or not: if all least velocities are 0 or less, the kinetic energy has not grown, except
/// by rounding and by the work of immovable bodies that move. Where iterations that have not
/// settled would add energy, the impulses are moved towards those without friction: see
/// detail::keep_energy(). Newton's restitution can add energy even when settled: with friction, or
/// where the impulse at one contact makes another one that separates push as well; then the
/// restitution is reduced to the largest for which it does not, on the segment between the impulses
/// without and with restitution.
/// @param contacts between different bodies of the list, with unit normals
/// @param start initial impulses (warm start), for instance those of the previous step: they save
/// iterations. Empty, or one for each contact; they are projected onto the admissible impulses
/// @throws std::invalid_argument if a contact names a body that does not exist or the same body
/// twice, has negative friction, or a number that is not finite; if `start` has another length; or
/// if effective masses, impulses or energies overflow. Velocities of 1e-150 m/s work as others do;
/// where energies underflow, they count as 0
template <std::floating_point S>
SolvedContacts<S> solve_contacts(const std::vector<RigidBody<S>>& bodies,
                                 const std::vector<BodyContact<S>>& contacts,
                                 const std::vector<ContactImpulse<S>>& start = {},
                                 const SolverSettings<S>& limits = {}) {
  if (!start.empty() && start.size() != contacts.size()) {
    throw_invalid_argument("start", std::to_string(start.size()) + " impulses",
                           "must be one a contact");
  }
  const auto prepared =
      detail::prepared_contacts(bodies, contacts, limits.jacobi, limits.friction_bound);
  std::vector<detail::ImpulseComponents<S>> impulses = detail::clamped_impulses(prepared, start);
  const SolverReport<S> report = detail::iterate_until(bodies, prepared, impulses, limits);
  return detail::solved_after<S>(bodies, prepared, std::move(impulses), report, limits);
}
// [/solve]

}  // namespace contact
