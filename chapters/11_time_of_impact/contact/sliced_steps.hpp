/// @file
/// Impacts found by overlap tests at the ends of slices of a step, and interpolation between two of
/// them.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>
#include <string>

#include <contact/bisection.hpp>
#include <contact/invalid_argument.hpp>

namespace contact {

namespace detail {

/// The end of slice k of a step: duration · k / slices, rounded twice.
template <std::floating_point S>
S slice_end(S duration, int k, int slices) {
  if (k == slices) return duration;
  const S whole = duration * S(k);
  return std::isfinite(whole) ? whole / S(slices) : duration / S(slices) * S(k);
}

}  // namespace detail

// [sliced-step]
/// The first of equal slices of a step at whose end bodies touch or overlap.
///
/// @warning An overlap that begins and ends between two tests is missed: a bullet that is behind
/// the wall at the next test, or a graze. contact/tunnelling.hpp says when the former cannot be,
/// and how long a missed chord can be.
/// @param overlap overlap(t): whether the bodies touch or overlap at the time t, from 0 to duration
/// @param duration of the step, finite and not negative: 1 for times that are fractions of the step
/// @param slices at least 1
/// @return nothing if no test found an overlap. The tests are at duration · k / slices, rounded
/// twice (in float for up to 2^24 slices)
/// @throws std::invalid_argument if duration or slices does not satisfy these conditions
/// @see *Fundamentals of Computer Animation*, slide "How About 2 MOVING spheres?"
template <std::floating_point S, std::predicate<S> Overlap>
std::optional<ImpactBracket<S>> sliced_step(const Overlap& overlap, S duration, int slices) {
  require_finite("duration", duration);
  if (duration < S(0)) {
    throw_invalid_argument("duration", number_text(duration), "must not be negative");
  }
  if (slices < 1) throw_invalid_argument("slices", std::to_string(slices), "must be at least 1");
  // [slices]
  if (overlap(S(0))) return ImpactBracket<S>{S(0), S(0)};
  ImpactBracket<S> bracket;
  for (int k = 1; k <= slices; ++k) {
    bracket.hit = detail::slice_end(duration, k, slices);
    if (overlap(bracket.hit)) return bracket;
    bracket.free = bracket.hit;
  }
  return std::nullopt;
  // [/slices]
}
// [/sliced-step]

// [interpolation]
/// Linear interpolation (regula falsi): the time in the bracket at which the gap would close if it
/// shrank at a constant rate.
///
/// For a gap that is twice differentiable in time, with |gap''| ≤ M and closing at least at the
/// rate c > 0 throughout the bracket, the error is at most M (hit − free)² / (8 c).
/// @param bracket from sliced_step() or bisect_impact()
/// @param gap_free at bracket.free, m, greater than 0
/// @param gap_hit at bracket.hit, m, not greater than 0
/// @return a time in the bracket, in its unit
template <std::floating_point S>
S interpolated_impact(const ImpactBracket<S>& bracket, S gap_free, S gap_hit) {
  if (!(gap_free > S(0))) return bracket.free;
  const S share = gap_free / (gap_free - gap_hit);
  const S t = bracket.free + (bracket.hit - bracket.free) * share;
  return t < bracket.hit ? t : bracket.hit;
}
// [/interpolation]

}  // namespace contact
