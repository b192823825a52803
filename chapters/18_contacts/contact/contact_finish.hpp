/// @file
/// Many contacts at once: what sweeps have left undone is finished by elimination.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <contact/contact_coulomb.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_rows.hpp>
#include <contact/contact_solver.hpp>
#include <contact/rigid_body.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Where something rubs, a push of more than so many times all masses at the fastest approach is no
/// answer: what is jammed may push as hard as it likes, and rounding decides where it goes.
inline constexpr double most_leverage = 0x1p10;

/// Impulses that round to more than this share of the fastest approach are no answer.
inline constexpr double most_rounding = 0x1p-10;

namespace detail {

// [eliminate]
/// Changes y in the chosen rows so that M y + c = 0 there.
///
/// M may be singular there, as for a table on four legs. A little is added to its diagonal, and
/// what that makes wrong is mended by repeating: so of all answers it is one near the y that comes
/// in.
/// @return whether that is possible
template <std::floating_point S>
bool eliminate(const ImpulseRows<S>& problem, const std::vector<bool>& chosen, Numbers<S>& y) {
  std::vector<int> number(chosen.size(), -1);
  int rows = 0;
  for (std::size_t r = 0; r < chosen.size(); ++r)
    if (chosen[r]) number[r] = rows++;
  if (rows == 0) return true;
  const S little = S(0x1p16) * std::numeric_limits<S>::epsilon();
  std::vector<Eigen::Triplet<S>> entries;
  for (int k = 0; k < problem.matrix.outerSize(); ++k) {
    for (typename Eigen::SparseMatrix<S>::InnerIterator it(problem.matrix, k); it; ++it) {
      const int row = number[static_cast<std::size_t>(it.row())];
      const int column = number[static_cast<std::size_t>(it.col())];
      if (row < 0 || column < 0) continue;
      entries.emplace_back(row, column, row == column ? it.value() + little : it.value());
    }
  }
  Eigen::SparseMatrix<S> part(rows, rows);
  part.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<S>> eliminated(part);
  if (eliminated.info() != Eigen::Success) return false;
  S last = std::numeric_limits<S>::infinity();
  for (int round = 0; round < 8; ++round) {
    const Numbers<S> wrong = problem.matrix * y + problem.constant;
    Numbers<S> right(rows);
    for (std::size_t r = 0; r < chosen.size(); ++r)
      if (chosen[r]) right(number[r]) = -wrong(static_cast<Eigen::Index>(r));
    const S left = right.cwiseAbs().maxCoeff();
    if (!(left < last / S(2))) break;
    last = left;
    const Numbers<S> change = eliminated.solve(right);
    for (std::size_t r = 0; r < chosen.size(); ++r)
      if (chosen[r]) y(static_cast<Eigen::Index>(r)) += change(number[r]);
  }
  return y.allFinite();
}
// [/eliminate]

// [go-towards]
/// Goes from y towards a target, as far as the sum ½ y·M y + c·y becomes less: all the way or a
/// half of it, a quarter, and so on. On the way who would pull does nothing. Returns whether it
/// went at all.
template <std::floating_point S>
bool go_towards(const ImpulseRows<S>& problem, const Numbers<S>& opening, const Numbers<S>& target,
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
        !(slope + change.dot(problem.matrix * change) / S(2) < slope * S(1e-4)))
      continue;
    y = next;
    return true;
  }
  return false;
}

/// Goes from y towards a target until the first stops to push. Returns whether nobody does.
template <std::floating_point S>
bool go_to_the_first(const ImpulseRows<S>& problem, const Numbers<S>& target, Numbers<S>& y) {
  S part(1);
  Eigen::Index first = -1;
  for (Eigen::Index r = 0; r < y.size(); ++r) {
    if (!problem.rows[static_cast<std::size_t>(r)].normal || !(target(r) < S(0))) continue;
    const S way = y(r) / (y(r) - target(r));
    if (!(way < part)) continue;
    part = way;
    first = r;
  }
  y += (target - y) * part;
  if (first >= 0) y(first) = S(0);
  for (Eigen::Index r = 0; r < y.size(); ++r)
    if (problem.rows[static_cast<std::size_t>(r)].normal) y(r) = std::max(S(0), y(r));
  return first < 0;
}
// [/go-towards]

/// How often push_apart() guesses.
inline constexpr int most_guesses = 400;

/// Who is solved together: all that push or close; those that push; or these and one that closes.
enum class PushGuess { bold, settle, add };

// [projected-newton]
/// Changes y in the free rows so that M y + c = 0 there, where a normal may push, or do nothing and
/// open: of all such y, the one of least ½ y·M y + c·y.
///
/// A guess is which normals do nothing: those that push nothing and open. The others are solved
/// together, and y goes towards that (projected Newton; Bertsekas 1982). Where it cannot, the guess
/// is more careful: those that push, less and less of them, until nobody pulls; then one more, that
/// which closes fastest (Lawson and Hanson 1974). So the sum never grows, and there is an end.
/// @param free the tangents that may change; of normals all may
template <std::floating_point S>
bool push_apart(const ImpulseRows<S>& problem, const std::vector<bool>& free, Numbers<S>& y) {
  const auto count = static_cast<Eigen::Index>(problem.rows.size());
  const S rounding = S(0x1p8) * std::numeric_limits<S>::epsilon();
  PushGuess how = PushGuess::bold;
  for (int guess = 0; guess < most_guesses; ++guess) {
    const Numbers<S> opening = problem.matrix * y + problem.constant;
    const Numbers<S> size = problem.matrix.cwiseAbs() * y.cwiseAbs() + problem.constant.cwiseAbs();
    std::vector<bool> chosen = free;
    bool settled = true;
    Eigen::Index fastest = -1;  // of those that close and do not push
    for (Eigen::Index r = 0; r < count; ++r) {
      const auto at = static_cast<std::size_t>(r);
      const S small = rounding * size(r);
      if (problem.rows[at].normal) {
        const bool closes = !(y(r) > S(0)) && opening(r) < -small;
        chosen[at] = y(r) > S(0) || (closes && how == PushGuess::bold);
        if (closes && (fastest < 0 || opening(r) < opening(fastest))) fastest = r;
      }
      settled = settled && !(chosen[at] && std::abs(opening(r)) > small);
    }
    if (fastest < 0 && (settled || how == PushGuess::add)) return true;
    if (how == PushGuess::add) chosen[static_cast<std::size_t>(fastest)] = true;
    Numbers<S> target = y;
    if (!eliminate<S>(problem, chosen, target)) return false;
    if (how == PushGuess::bold) {
      const Numbers<S> before = y;
      if (!go_towards(problem, opening, target, y))
        how = PushGuess::settle;
      else if ((y - before).cwiseAbs().maxCoeff() <= rounding * y.cwiseAbs().maxCoeff())
        return true;
    } else if (how == PushGuess::settle) {
      if (go_to_the_first(problem, target, y)) how = PushGuess::add;
    } else {
      if (!(target(fastest) > S(0))) return true;  // rounding
      go_to_the_first(problem, target, y);
      how = PushGuess::bold;
    }
  }
  return true;
}
// [/projected-newton]

}  // namespace detail

// [finish]
/// How friction is found where sweeps have left it.
enum class FrictionLaw {
  coulomb,  ///< against the slip: see rub_by_newton()
  cones     ///< within its cone, and so that what slides rises: see rub_in_cones()
};

/// The impulses that sweeps would end at, or nearer to them.
///
/// Sweeps carry a push from a body to the next, and where a light one is between two heavy ones
/// they carry little: with masses 1 : 10⁶ they would take millions. Here which contacts push is
/// guessed, and these are solved together by elimination. What pushes and rubs holds across.
/// Without friction that is the answer; with it, if no contact needs more than its cone to hold,
/// and all that push did so from the start.
///
/// If not, something slides. By Coulomb's law its friction is μ times its push, against its slip.
/// Newton's method looks for that from where the sweeps came, or, if that leads nowhere, from where
/// friction is in its cones. There may be several answers, of which this is one. It does not find
/// one for every jam: the tests hold it to four of five random ones, with masses 1 : 10⁶.
/// @param bodies before the impulses
/// @param start of the sweeps: which push is the first guess
/// @return one a contact, none of them a pull. Nothing if there are more than most_couplings, if
/// two immovable bodies touch, or if Coulomb's law is not come by
template <std::floating_point S>
std::optional<std::vector<ContactImpulse<S>>> finished_impulses(
    const std::vector<RigidBody<S>>& bodies, const std::vector<BodyContact<S>>& contacts,
    const std::vector<ContactImpulse<S>>& start, FrictionLaw law = FrictionLaw::coulomb) {
  const auto problem = detail::impulse_rows<S>(bodies, contacts);
  if (!problem) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(problem->rows.size());
  const bool rubs = problem->rows.size() > contacts.size();
  detail::Numbers<S> y(count);
  std::vector<bool> holds(problem->rows.size());
  for (Eigen::Index r = 0; r < count; ++r) {
    const detail::ImpulseRow<S>& row = problem->rows[static_cast<std::size_t>(r)];
    const ContactImpulse<S>& impulse = start[row.contact];
    y(r) = (row.normal ? impulse.normal : impulse.tangential.dot(row.direction)) / row.unit;
    holds[static_cast<std::size_t>(r)] = !row.normal && impulse.normal > S(0);
  }
  if (law == FrictionLaw::cones) {
    detail::rub_in_cones<S>(*problem, false, y);
  } else {
    const detail::Numbers<S> swept = y;
    if (!detail::push_apart<S>(*problem, holds, y)) return std::nullopt;
    if (rubs && !detail::obeys_coulomb<S>(*problem, y)) {
      y = swept;
      if (!detail::rub_by_coulomb<S>(*problem, y)) return std::nullopt;
    }
  }
  std::vector<ContactImpulse<S>> found(contacts.size());
  for (Eigen::Index r = 0; r < count; ++r) {
    const detail::ImpulseRow<S>& row = problem->rows[static_cast<std::size_t>(r)];
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
/// What solve_contacts() would end at, or nearer to it, from where its sweeps have come.
/// @return with how fast contacts still close as the last change; nothing where
/// finished_impulses() has nothing, or nothing better: a contact closes
/// faster than it does after the sweeps, what does not bounce makes energy, or something is jammed
/// (see most_leverage)
template <std::floating_point S>
std::optional<SolvedContacts<S>> finish_contacts(const std::vector<RigidBody<S>>& bodies,
                                                 const std::vector<BodyContact<S>>& contacts,
                                                 const std::vector<ContactImpulse<S>>& start,
                                                 FrictionLaw law = FrictionLaw::coulomb) {
  const auto prepared = detail::prepared_contacts<S>(bodies, contacts);
  std::vector<BodyContact<S>> soft = contacts;
  for (BodyContact<S>& c : soft) c.least_velocity = std::min(c.least_velocity, S(0));
  S fastest(0);
  for (const BodyContact<S>& c : contacts)
    fastest = std::max(fastest, std::abs(contact_velocity<S>(bodies, c)));
  S mass(0);
  bool rubs = false;
  for (const RigidBody<S>& body : bodies) mass += body.inverse_mass > S(0) ? body.mass : S(0);
  for (const BodyContact<S>& c : contacts) rubs = rubs || c.friction > S(0);
  const auto jams = [&](const detail::Parts<S>& impulse) {
    return rubs && impulse[0] > S(most_leverage) * fastest * mass;
  };
  const auto closing = [&](const std::vector<detail::Parts<S>>& impulses,
                           const std::vector<BodyContact<S>>& wanted) {
    const auto after = detail::after_parts<S>(bodies, prepared, impulses);
    S most(0);
    for (const BodyContact<S>& c : wanted)
      most = std::max(most, c.least_velocity - contact_velocity<S>(after, c));
    return most;
  };
  const auto before = detail::allowed_parts<S>(prepared, start);
  const auto better = [&](const std::vector<BodyContact<S>>& wanted)
      -> std::optional<std::vector<detail::Parts<S>>> {
    const auto found = finished_impulses<S>(bodies, wanted, start, law);
    if (!found) return std::nullopt;
    auto parts = detail::allowed_parts<S>(prepared, *found);
    if (std::any_of(parts.begin(), parts.end(), jams)) return std::nullopt;
    const S rounding = std::clamp(detail::rounding_of_parts<S>(bodies, prepared, parts),
                                  std::sqrt(std::numeric_limits<S>::epsilon()) * fastest,
                                  S(most_rounding) * fastest);
    if (closing(parts, wanted) > closing(before, wanted) + rounding) return std::nullopt;
    return parts;
  };
  const auto makes_energy = [&](const std::vector<detail::Parts<S>>& impulses) {
    const auto after = detail::after_parts<S>(bodies, prepared, impulses);
    return detail::energy_made<S>(bodies, after, prepared, impulses) > S(0);
  };
  const auto found = better(contacts);
  if (!found) return std::nullopt;
  auto stopped = found;
  if (makes_energy(*found)) {
    stopped = better(soft);
    if (!stopped || makes_energy(*stopped)) return std::nullopt;
  }
  auto solved = detail::solved_by<S>(bodies, prepared, *found, [&] { return *stopped; });
  for (const BodyContact<S>& c : soft) {
    solved.report.last_change = std::max(solved.report.last_change,
                                         c.least_velocity - contact_velocity<S>(solved.bodies, c));
  }
  return solved;
}
// [/finish-contacts]

}  // namespace contact
