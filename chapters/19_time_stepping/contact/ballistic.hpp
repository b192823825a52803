/// @file
/// Motion under a constant acceleration, without steps: position and velocity after a time, and the
/// time at which a gap closes.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/exact.hpp>
#include <contact/integrators.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [ballistic]
/// Position and velocity after the time t under a constant acceleration: x + (v + a t/2) t and
/// v + a t. The formula is exact for every t.
/// @param acceleration m/s²
/// @param t s
/// @return the position with an error of at most about 4 u (|x| + |v t| + |a t²/2|)
template <class V, Scalar S>
MotionState<V> ballistic_motion(const MotionState<V>& now, const V& acceleration, const S& t) {
  const V middle = now.velocity + acceleration * (t / S(2));
  const V position = now.position + middle * t;
  const V velocity = now.velocity + acceleration * t;
  return {position, velocity};
}
// [/ballistic]

// [straight-gap]
/// The time at which a gap that changes at a constant rate closes: gap / (−rate).
/// @param gap m; a gap of 0 or less is closed
/// @param rate rate of change of the gap, m/s
/// @return s; 0 for a closed gap that shrinks. Nothing if the gap does not shrink: bodies that
/// separate do not collide, even where they touch or overlap
template <Scalar S>
std::optional<S> straight_closing_time(const S& gap, const S& rate) {
  if (!(rate < S(0))) return std::nullopt;
  if (!(gap > S(0))) return S(0);
  return S(gap / -rate);
}
// [/straight-gap]

namespace detail {

/// √(rate² − 2 a gap) times 2^−power, and whether the exact radicand is at least 0. Where rounding
/// could change that sign, it is computed exactly.
template <std::floating_point S>
struct ClosingRoot {
  S root = S(0);  ///< of the radicand, divided by 2^power
  S rate = S(0);  ///< divided by 2^power
  int power = 0;
  bool real = true;
};

template <std::floating_point S>
ClosingRoot<S> closing_root(const S& gap, const S& rate, const S& a) {
  ClosingRoot<S> result;
  int of_rate = 0;
  int of_gap = 0;
  int of_a = 0;
  const S v = std::frexp(rate, &of_rate);
  const S h = std::frexp(gap, &of_gap);
  const S c = std::frexp(a, &of_a);
  const int of_product = of_gap + of_a + 1;
  const bool no_product = h == S(0) || c == S(0);
  const int half = of_product >= 0 ? (of_product + 1) / 2 : -(-of_product / 2);
  result.power = no_product ? of_rate : v == S(0) ? half : std::max(of_rate, half);
  result.rate = std::ldexp(v, of_rate - result.power);
  const S square = result.rate * result.rate;
  const S product = no_product ? S(0) : std::ldexp(h * c, of_product - 2 * result.power);
  S difference = square - product;
  if (product > S(0) && S(16) * std::abs(difference) < square) {
    const auto exact = [](const S& x) { return Exact(static_cast<double>(x)); };
    const Exact true_difference = exact(rate) * exact(rate) - exact(S(2)) * exact(a) * exact(gap);
    result.real = true_difference.sign() >= 0;
    const Exact unit = exact(std::ldexp(S(1), result.power));
    difference = quotient<S>(true_difference, unit * unit);
  } else {
    result.real = difference >= S(0);
  }
  result.root = result.real ? std::sqrt(std::max(difference, S(0))) : S(0);
  return result;
}

}  // namespace detail

// [closing-time]
/// The time at which a gap under a constant acceleration closes: the first t ≥ 0 at which
/// gap + rate t + a t²/2 is 0 or less and the gap shrinks.
///
/// For a closed gap that shrinks, the time is 0. For a gap of 0 or less that grows, it is the time
/// at which the gap closes again, if it does. A gap whose minimum is exactly 0 closes: touching
/// counts.
/// @param gap m
/// @param rate rate of change of the gap at the start, m/s
/// @param a rate of change of that rate, m/s²; negative if the two are pulled together
/// @return s; nothing if the gap never closes, or only after the largest finite time. Whether it
/// closes is decided exactly for every finite input with exponents within ±250 (±30 for float); the
/// time has a relative error of at most 16 u, unless it underflows
template <std::floating_point S>
std::optional<S> closing_time(const S& gap, const S& rate, const S& a) {
  const bool closing = rate < S(0) || (rate == S(0) && a < S(0));
  if (!(gap > S(0))) {
    if (closing) return S(0);
    if (!(a < S(0))) return std::nullopt;
    // The gap grows. An overlap that never opens closes when it stops growing.
    const auto root = detail::closing_root(gap, rate, a);
    const S until = root.real ? std::ldexp((root.rate + root.root) / -a, root.power) : rate / -a;
    return std::isfinite(until) ? std::optional<S>(until) : std::nullopt;
  }
  if (!closing && !(a < S(0))) return std::nullopt;
  if (a == S(0)) {
    const S until = gap / -rate;
    return std::isfinite(until) ? std::optional<S>(until) : std::nullopt;
  }
  const auto root = detail::closing_root(gap, rate, a);
  if (!root.real) return std::nullopt;
  // Two forms of the same root; each is used where its sum does not cancel.
  const S until = rate > S(0) ? std::ldexp((root.rate + root.root) / -a, root.power)
                              : std::ldexp(gap / (root.root - root.rate) * S(2), -root.power);
  return std::isfinite(until) ? std::optional<S>(until) : std::nullopt;
}
// [/closing-time]

}  // namespace contact
