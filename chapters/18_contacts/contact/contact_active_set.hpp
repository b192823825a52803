/// @file
/// Many contacts: an active-set solve that starts where the iterations have ended.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <contact/contact_coulomb.hpp>
#include <contact/contact_elimination.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_rows.hpp>
#include <contact/contact_solver.hpp>
#include <contact/rigid_body.hpp>
#include <contact/vector.hpp>

namespace contact {

/// With friction, a normal impulse larger than this multiple of the total mass times the fastest
/// approach is rejected: in a jam the impulses can be arbitrarily large, and rounding decides the
/// motion.
inline constexpr double max_leverage = 0x1p10;

/// Impulses whose rounding exceeds this fraction of the fastest approach have not settled: rounding
/// decides the motion.
inline constexpr double max_rounding = 0x1p-10;

namespace detail {

// [go-towards]
/// Line search from y towards a target: the first of the fractions 1, 1/2, 1/4, … that decreases
/// ½ y·M y + c·y, with negative normal impulses set to 0. Returns whether there is one.
template <std::floating_point S>
bool line_search(const ImpulseRows<S>& problem, const Numbers<S>& opening, const Numbers<S>& target,
                 Numbers<S>& y) {
  for (S part = S(1); part > S(0x1p-5); part /= S(2)) {
    Numbers<S> next = y + (target - y) * part;
    bool pulls = false;
    for (Eigen::Index r = 0; r < y.size(); ++r) {
      if (!problem.rows[static_cast<std::size_t>(r)].normal || !(next(r) < S(0))) continue;
      next(r) = S(0);
      pulls = true;
    }
    const Numbers<S> change = next - y;
    const S slope = opening.dot(change);
    if ((pulls || part < S(1)) &&
        !(slope + squared_change<S>(problem, change) / S(2) < slope * S(1e-4)))
      continue;
    y = next;
    return true;
  }
  return false;
}

/// Ratio test: moves y towards a target until the first normal impulse becomes 0. Returns whether
/// none does.
template <std::floating_point S>
bool ratio_test(const ImpulseRows<S>& problem, const Numbers<S>& target, Numbers<S>& y) {
  S part(1);
  Eigen::Index first = -1;
  for (Eigen::Index r = 0; r < y.size(); ++r) {
    if (!problem.rows[static_cast<std::size_t>(r)].normal || !(target(r) < S(0))) continue;
    const S ratio = y(r) / (y(r) - target(r));
    if (!(ratio < part)) continue;
    part = ratio;
    first = r;
  }
  y += (target - y) * part;
  if (first >= 0) y(first) = S(0);
  for (Eigen::Index r = 0; r < y.size(); ++r)
    if (problem.rows[static_cast<std::size_t>(r)].normal) y(r) = std::max(S(0), y(r));
  return first < 0;
}
// [/go-towards]

/// The largest number of active sets that projected_newton() tries.
inline constexpr int max_guesses = 400;

/// The active set: all normals that push or close; those that push; or these and one that closes.
enum class ActiveSetGuess { bold, settle, add };

// [projected-newton]
/// Minimises ½ y·M y + c·y over the free rows, with normal impulses of at least 0: a normal pushes,
/// or its impulse is 0 and the contact opens.
///
/// The inactive set is the normals with impulse 0 that open. The other rows are solved together,
/// and a line search moves y towards the solution (projected Newton; Bertsekas 1982). If that makes
/// no progress, the active set is changed one by one: first the normals that push, less those that
/// a ratio test removes; then one more, the one that closes fastest (Lawson and Hanson 1974). The
/// function never increases.
/// @param free the tangents that may change; all normals may
template <std::floating_point S>
bool projected_newton(ImpulseRows<S>& problem, const std::vector<bool>& free, Numbers<S>& y) {
  const auto count = static_cast<Eigen::Index>(problem.rows.size());
  const S rounding = S(0x1p8) * std::numeric_limits<S>::epsilon();
  ActiveSetGuess how = ActiveSetGuess::bold;
  for (int guess = 0; guess < max_guesses; ++guess) {
    const auto [opening, size] = velocities_and_sizes<S>(problem, y);
    std::vector<bool> chosen = free;
    bool settled = true;
    Eigen::Index fastest = -1;  // of the normals that close and do not push
    for (Eigen::Index r = 0; r < count; ++r) {
      const auto at = static_cast<std::size_t>(r);
      const S small = rounding * size(r);
      if (problem.rows[at].normal) {
        const bool closes = !(y(r) > S(0)) && opening(r) < -small;
        chosen[at] = y(r) > S(0) || (closes && how == ActiveSetGuess::bold);
        if (closes && (fastest < 0 || opening(r) < opening(fastest))) fastest = r;
      }
      settled = settled && !(chosen[at] && std::abs(opening(r)) > small);
    }
    if (fastest < 0 && (settled || how == ActiveSetGuess::add)) return true;
    if (how == ActiveSetGuess::add) chosen[static_cast<std::size_t>(fastest)] = true;
    Numbers<S> target = y;
    if (!eliminate<S>(problem, chosen, target)) return false;
    if (how == ActiveSetGuess::bold) {
      const Numbers<S> before = y;
      if (!line_search(problem, opening, target, y))
        how = ActiveSetGuess::settle;
      else if ((y - before).cwiseAbs().maxCoeff() <= rounding * y.cwiseAbs().maxCoeff())
        return true;
    } else if (how == ActiveSetGuess::settle) {
      if (ratio_test(problem, target, y)) how = ActiveSetGuess::add;
    } else {
      if (!(target(fastest) > S(0))) return true;  // rounding
      ratio_test(problem, target, y);
      how = ActiveSetGuess::bold;
    }
  }
  return true;
}
// [/projected-newton]

}  // namespace detail

/// The law of friction of the active-set solve.
enum class FrictionLaw {
  coulomb,  ///< opposite to the slip: see solve_friction_newton()
  cones     ///< inside its cone, while sliding contacts open: see solve_friction_cones()
};

namespace detail {

// [finish]
/// active_set_impulses() of prepared contacts.
template <std::floating_point S>
std::optional<std::vector<ContactImpulse<S>>> active_set_of(
    const std::vector<RigidBody<S>>& bodies, const std::vector<PreparedContact<S>>& prepared,
    const std::vector<ContactImpulse<S>>& start, FrictionLaw law) {
  auto problem = impulse_rows<S>(bodies, prepared);
  if (!problem) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(problem->rows.size());
  const bool has_friction = problem->rows.size() > prepared.size();
  Numbers<S> y(count);
  std::vector<bool> holds(problem->rows.size());
  for (Eigen::Index r = 0; r < count; ++r) {
    const ImpulseRow<S>& row = problem->rows[static_cast<std::size_t>(r)];
    const ContactImpulse<S>& impulse = start[row.contact];
    y(r) = (row.normal ? impulse.normal : impulse.tangential.dot(row.direction)) / row.unit;
    holds[static_cast<std::size_t>(r)] = !row.normal && impulse.normal > S(0);
  }
  if (law == FrictionLaw::cones) {
    assemble(*problem);
    solve_friction_cones<S>(*problem, false, y);
  } else {
    const Numbers<S> swept = y;
    if (!projected_newton<S>(*problem, holds, y)) return std::nullopt;
    if (has_friction && !obeys_coulomb<S>(*problem, y)) {
      y = swept;
      assemble(*problem);
      if (!solve_friction<S>(*problem, y)) return std::nullopt;
    }
  }
  std::vector<ContactImpulse<S>> found(prepared.size());
  for (Eigen::Index r = 0; r < count; ++r) {
    const ImpulseRow<S>& row = problem->rows[static_cast<std::size_t>(r)];
    ContactImpulse<S>& impulse = found[row.contact];
    if (row.normal)
      impulse.normal = y(r) * row.unit;
    else
      impulse.tangential += row.direction * (y(r) * row.unit);
  }
  return found;
}
// [/finish]

// [finish-contacts]
/// solve_active_set() of prepared contacts.
template <std::floating_point S>
std::optional<SolvedContacts<S>> solve_active_set_of(
    const std::vector<RigidBody<S>>& bodies, const std::vector<PreparedContact<S>>& prepared,
    const std::vector<ContactImpulse<S>>& start, FrictionLaw law, const S& tolerance) {
  S fastest(0);
  for (const PreparedContact<S>& p : prepared)
    fastest = std::max(fastest, std::abs(contact_velocity<S>(bodies, p.contact)));
  S mass(0);
  bool has_friction = false;
  for (const RigidBody<S>& body : bodies) mass += body.inverse_mass > S(0) ? body.mass : S(0);
  for (const PreparedContact<S>& p : prepared)
    has_friction = has_friction || p.contact.friction > S(0);
  const auto jams = [&](const ImpulseComponents<S>& impulse) {
    return has_friction && impulse[0] > S(max_leverage) * fastest * mass;
  };
  const auto closing = [&](const std::vector<RigidBody<S>>& after,
                           const std::vector<PreparedContact<S>>& wanted) {
    S most(0);
    for (const PreparedContact<S>& p : wanted)
      most = std::max(most, p.contact.min_velocity - contact_velocity<S>(after, p.contact));
    return most;
  };
  struct Found {
    std::vector<ImpulseComponents<S>> impulses;
    bool makes_energy = false;
  };
  const auto better = [&](const std::vector<PreparedContact<S>>& wanted) -> std::optional<Found> {
    const auto found = active_set_of<S>(bodies, wanted, start, law);
    if (!found) return std::nullopt;
    auto impulses = clamped_impulses<S>(prepared, *found);
    if (std::any_of(impulses.begin(), impulses.end(), jams)) return std::nullopt;
    const S rounding = std::clamp(impulse_rounding<S>(bodies, prepared, impulses),
                                  std::sqrt(std::numeric_limits<S>::epsilon()) * fastest,
                                  S(max_rounding) * fastest);
    const auto after = after_impulses<S>(bodies, prepared, impulses);
    const S left = closing(after, wanted);
    if (left > rounding) {
      const auto before = after_impulses<S>(bodies, prepared, clamped_impulses<S>(prepared, start));
      if (left > closing(before, wanted) + rounding) return std::nullopt;
    }
    const bool makes_energy = energy_made<S>(bodies, after, prepared, impulses) > S(0);
    return Found{std::move(impulses), makes_energy};
  };
  const auto found = better(prepared);
  if (!found) return std::nullopt;
  auto stopped = found;
  if (found->makes_energy) {
    stopped = better(softened(prepared));
    if (!stopped || stopped->makes_energy) return std::nullopt;
  }
  auto solved = solved_by<S>(
      bodies, prepared, found->impulses, [&] { return stopped->impulses; }, tolerance);
  if (!(solved.report.rounding <= S(max_rounding) * fastest)) solved.report.settled = false;
  for (const PreparedContact<S>& p : prepared) {
    solved.report.last_change =
        std::max(solved.report.last_change, std::min(p.contact.min_velocity, S(0)) -
                                                contact_velocity<S>(solved.bodies, p.contact));
  }
  return solved;
}
// [/finish-contacts]

}  // namespace detail

/// The impulses to which the iterations of solve_contacts() would converge, or closer to them.
///
/// One iteration carries an impulse from one body to the next, and converges slowly where a light
/// body is between two heavy ones: with masses 1 : 10⁶ it would take millions of iterations. Here
/// the set of contacts that push is guessed, and these are solved together by elimination; contacts
/// with friction that push are assumed to stick. Without friction that is the solution. With
/// friction it is the solution if sticking needs no more friction than the cones allow, and if all
/// contacts that push did so at the start.
///
/// Otherwise a contact slides. By Coulomb's law its friction is μ times its normal impulse,
/// opposite to the slip. Newton's method solves for that, starting from the result of the
/// iterations, or, if it does not converge, from impulses inside the cones. There may be several
/// solutions, and this is one of them. Not every jam is solved: the tests require four of five
/// random ones with masses 1 : 10⁶.
/// @param bodies before the impulses
/// @param start result of the iterations: the contacts that push are the first active set
/// @return one for each contact, none of them a pull. Nothing if there are more than
/// max_couplings, if two immovable bodies touch, or if Coulomb's law could not be satisfied
template <std::floating_point S>
std::optional<std::vector<ContactImpulse<S>>> active_set_impulses(
    const std::vector<RigidBody<S>>& bodies, const std::vector<BodyContact<S>>& contacts,
    const std::vector<ContactImpulse<S>>& start, FrictionLaw law = FrictionLaw::coulomb) {
  return detail::active_set_of(bodies, detail::prepared_contacts<S>(bodies, contacts), start, law);
}

/// The result to which solve_contacts() would converge, or closer to it, from the impulses of its
/// iterations.
/// @param tolerance m/s; for `settled` of the report, as for solve_contacts()
/// @return the last change is the largest speed at which a contact still closes. Nothing where
/// active_set_impulses() returns nothing or nothing better: a contact closes faster than after the
/// iterations, contacts without restitution add energy, or there is a jam (see max_leverage)
template <std::floating_point S>
std::optional<SolvedContacts<S>> solve_active_set(const std::vector<RigidBody<S>>& bodies,
                                                  const std::vector<BodyContact<S>>& contacts,
                                                  const std::vector<ContactImpulse<S>>& start,
                                                  FrictionLaw law = FrictionLaw::coulomb,
                                                  const S& tolerance = S(1e-12)) {
  return detail::solve_active_set_of(bodies, detail::prepared_contacts<S>(bodies, contacts), start,
                                     law, tolerance);
}

}  // namespace contact
