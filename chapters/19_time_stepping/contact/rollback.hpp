/// @file
/// Rolling back to the last time without overlap: by equal substeps (slices), and by bisection.
///
/// Both only test whether the bodies overlap at a given time. Any shape and any motion allow that
/// test; but an overlap that begins and ends between two tests is missed.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include <contact/ballistic.hpp>
#include <contact/bouncing.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Two times with an impact between them.
template <Scalar S>
struct RollbackBracket {
  S free = S(0);     ///< s from the start of the step: no overlap then
  S blocked = S(0);  ///< s from the start of the step, later: an overlap then
  int tests = 0;     ///< how many overlap tests were made
};

// [slices]
/// Cuts the step into equal slices and brackets the first slice end with an overlap.
///
/// @param is_free whether there is no overlap at a time from 0 to `step`; called in order until the
/// result is false. Time 0 is assumed to be free and is not tested
/// @param step s, greater than 0
/// @param slices 1 or more
/// @return nothing if all slice ends are free. That does not prove that the whole step is free: an
/// overlap that begins and ends between two tests is missed. The last free time is before the
/// impact by at most step / slices
/// @see *Fundamentals of Computer Animation*, slide "How About 2 MOVING spheres?": "take the
/// previous position as the intersection point"
template <Scalar S, class IsFree>
std::optional<RollbackBracket<S>> last_free_slice(const IsFree& is_free, const S& step,
                                                  int slices) {
  S before(0);
  for (int i = 1; i <= slices; ++i) {
    // The last time is `step` itself, without rounding.
    const S time = i == slices ? step : S(step * S(i) / S(slices));
    if (!is_free(time)) return RollbackBracket<S>{before, time, i};
    before = time;
  }
  return std::nullopt;
}
// [/slices]

/// Halves a bracket repeatedly.
///
/// Invariant: there is no overlap at the free end and there is one at the blocked end. So an impact
/// lies between them, though not always the first one.
/// @param is_free as above; called once for each halving
/// @param width stops when the bracket is no wider, s, 0 or more. With 0 it stops when there is no
/// number between the ends: for doubles after at most 1,100 halvings, usually after about 50
// [bisection]
template <std::floating_point S, class IsFree>
RollbackBracket<S> bisected(const IsFree& is_free, RollbackBracket<S> bracket, const S& width) {
  while (bracket.blocked - bracket.free > width) {
    const S middle = bracket.free + (bracket.blocked - bracket.free) / S(2);
    if (!(bracket.free < middle && middle < bracket.blocked)) break;
    (is_free(middle) ? bracket.free : bracket.blocked) = middle;
    ++bracket.tests;
  }
  return bracket;
}
// [/bisection]

/// How the impact of a bouncing ball in a step is found.
template <std::floating_point S>
struct RollbackRules {
  int slices = 1;  ///< number of equal slices of a step, 1 or more
  S width = S(0);  ///< bisects until the bracket is no wider, s; infinite: no bisection
};

// [rolled-back-step]
/// One step of a bouncing ball that rolls back to the last free state before an impact, reflects
/// the velocity there, and uses up the rest of the step in the same way.
///
/// The impact is early by at most the width of the bracket, so the ball bounces a little above the
/// floor. With k = 1 this changes no energy, since the ball is reflected with the speed that it has
/// at that height.
/// @param now state of the ball, on the floor or above it
/// @param ball for gravity and restitution
/// @param dt length of the step, s, greater than 0
/// @param rules how the impact is found
/// @note A flight shorter than a slice may be missed. Bounces shorter than the bracket, or too
/// short to change the time, end the step: the ball stays at its position until the next step
template <std::floating_point S>
BounceState<S> rolled_back_step(BounceState<S> now, const BouncingBall<S>& ball, S dt,
                                const RollbackRules<S>& rules) {
  const S g = ball.gravity;
  const auto at = [&](const S& t) {
    return ballistic_motion<S>(MotionState<S>{now.height, now.velocity}, -g, t);
  };
  while (dt > S(0)) {
    const auto is_free = [&](const S& t) { return !(at(t).position < S(0)); };
    auto bracket = last_free_slice<S>(is_free, dt, rules.slices);
    if (bracket) bracket = bisected<S>(is_free, *bracket, rules.width);
    const S until = bracket ? bracket->free : dt;
    const bool stuck = !(now.velocity < S(0)) && !(dt - until < dt);
    const MotionState<S> there = at(until);
    now.height = there.position;
    now.velocity = there.velocity;
    if (!bracket || stuck) break;
    if (now.velocity < S(0)) {
      now.velocity *= -ball.restitution;
      now.bounces += S(1);
    }
    dt -= until;
  }
  return now;
}
// [/rolled-back-step]

}  // namespace contact
