/// @file
/// Rolling back to the previous free state: the end of the last slice without an overlap, and what
/// that does to a body at rest.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/sliced_steps.hpp>

namespace contact {

/// The state to which a body is put back.
template <std::floating_point S>
struct PreviousFreeState {
  S t = S(0);        ///< fraction of the step; the end of the step if no overlap was found
  bool hit = false;  ///< whether an overlap was found, so that the body is put back
};

// [previous-free-state]
/// The end of the last slice before the first at whose end the bodies touch or overlap.
///
/// It is free. Convex bodies that translate touch during one interval of time, so for them it is at
/// most one slice before the first touch; others may have touched and separated before it, between
/// two tests. It is also all that is known: the contact point is not. If the bodies touch or
/// overlap at the start, there is no free state, and t is 0.
/// @warning Misses what sliced_step() misses.
/// @param overlap overlap(t): whether the bodies touch or overlap at the fraction t of the step
/// @param slices at least 1
/// @throws std::invalid_argument if slices is less than 1
/// @see *Fundamentals of Computer Animation*, slide "How About 2 MOVING spheres?": "take the
/// previous position as the intersection point"
template <std::floating_point S, std::predicate<S> Overlap>
PreviousFreeState<S> previous_free_state(const Overlap& overlap, int slices) {
  const auto bracket = sliced_step<S>(overlap, S(1), slices);
  if (!bracket) return {S(1), false};
  return {bracket->free, true};
}
// [/previous-free-state]

/// A body that falls towards a floor and is put back to the previous free state.
template <std::floating_point S>
struct RestingFall {
  S gap = S(0);       ///< above the floor at the start, m, greater than 0
  S velocity = S(0);  ///< at the start, m per step, upwards
  S gravity = S(0);   ///< downwards, m per step², not negative
};

// [resting-body]
/// The gap above the floor after each of a number of steps, if an overlap puts the body back to the
/// previous free state and sets its velocity to 0.
///
/// If gravity is greater than 0, the body ends at rest above the floor. Once it has been put back
/// with the gap g, it starts the next step at rest and moves down by a, what gravity adds in a
/// step: in k of n slices by a k/n. If a < g, it falls freely and faster until it is put back
/// again, with a smaller gap. If a ≥ g, it is put back to g − a k/n with the largest k for which
/// that is positive, so to at most a/n. From there already the first slice overlaps, and the gap
/// stays the same in all later steps.
/// @param fall finite; gap greater than 0, gravity not negative; without gravity a body that does
/// not fall keeps its velocity for ever
/// @param slices, steps at least 1
/// @return m, `steps` numbers, all greater than 0
/// @throws std::invalid_argument if an argument does not satisfy these conditions, or the body may
/// get so fast or so far away that a number overflows
template <std::floating_point S>
std::vector<S> gaps_of_previous_free_state(const RestingFall<S>& fall, int slices, int steps) {
  require_finite("fall.velocity", fall.velocity);
  require_finite("fall.gravity", fall.gravity);
  require_finite("fall.gap", fall.gap);
  if (!(fall.gap > S(0)))
    throw_invalid_argument("fall.gap", number_text(fall.gap), "must exceed 0");
  if (fall.gravity < S(0))
    throw_invalid_argument("fall.gravity", number_text(fall.gravity), "must not be negative");
  if (steps < 1) throw_invalid_argument("steps", std::to_string(steps), "must be at least 1");
  const S fastest = std::abs(fall.velocity) + S(steps) * fall.gravity;
  if (!std::isfinite(S(2) * (fall.gap + S(steps) * fastest)))
    throw_invalid_argument("fall", number_text(fastest), "moves too far in these steps");
  std::vector<S> gaps;
  gaps.reserve(static_cast<std::size_t>(steps));
  S gap = fall.gap;
  S velocity = fall.velocity;
  for (int k = 0; k < steps; ++k) {
    velocity -= fall.gravity;  // velocity first, then position: semi-implicit Euler
    const auto gap_at = [&](S t) { return gap + velocity * t; };
    const auto state = previous_free_state<S>([&](S t) { return !(gap_at(t) > S(0)); }, slices);
    gap = gap_at(state.t);
    if (state.hit) velocity = S(0);
    gaps.push_back(gap);
  }
  return gaps;
}
// [/resting-body]

}  // namespace contact
