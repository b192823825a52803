/// @file
/// Bisection of a bracket: rolling back to the last free state and the first overlapping one.
#pragma once

#include <concepts>
#include <string>

#include <contact/invalid_argument.hpp>

namespace contact {

/// Two times with an impact between them.
template <std::floating_point S>
struct ImpactBracket {
  S free = S(0);  ///< fraction of the step; the bodies are separated: the last free state found
  S hit = S(0);   ///< fraction of the step; they touch or overlap. Equal to free if at the start
};

// [bisection]
/// Bisection of the bracket.
///
/// Each halving makes the bracket half as wide: after k of them the time of impact is known to (hit
/// − free) / 2^k, and `free` is the state to roll back to, where the bodies are separated, by no
/// more than their approach in that time. If bodies touch more than once in the bracket, it ends
/// around one of the times at which an overlap begins, not always the first.
/// @param overlap as for sliced_step()
/// @param bracket with overlap(hit), and without overlap(free) unless both are the same
/// @param halvings number of halvings; it stops early when no number is left between
/// @return free ≤ hit, with the same two properties
template <std::floating_point S, std::predicate<S> Overlap>
ImpactBracket<S> bisect_impact(const Overlap& overlap, ImpactBracket<S> bracket, int halvings) {
  // [bisect]
  for (int k = 0; k < halvings; ++k) {
    const S middle = bracket.free + (bracket.hit - bracket.free) / S(2);
    if (!(bracket.free < middle && middle < bracket.hit)) break;
    (overlap(middle) ? bracket.hit : bracket.free) = middle;
  }
  return bracket;
  // [/bisect]
}
// [/bisection]

/// How many halvings make a bracket no wider than a tolerance: the smallest k with (hit − free) /
/// 2^k ≤ tolerance.
///
/// The width is the computed hit − free. The tolerance is doubled in place of halving the width,
/// which would be rounded where it is subnormal: a doubling is exact, or infinite and then above
/// every width.
/// @param bracket finite, with free ≤ hit
/// @param tolerance in the same unit, finite and greater than 0
/// @return at least 0
/// @throws std::invalid_argument if the width is negative or not finite, or the tolerance is not
/// positive and finite
template <std::floating_point S>
int halvings_to(const ImpactBracket<S>& bracket, S tolerance) {
  const S width = bracket.hit - bracket.free;
  require_finite("bracket", width);
  require_finite("tolerance", tolerance);
  if (width < S(0)) throw_invalid_argument("bracket", number_text(width), "hit is before free");
  if (!(tolerance > S(0)))
    throw_invalid_argument("tolerance", number_text(tolerance), "must exceed 0");
  int halvings = 0;
  for (S reach = tolerance; width > reach; reach *= S(2)) ++halvings;
  return halvings;
}

}  // namespace contact
