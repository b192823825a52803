/// @file
/// Going back to where things were still free: in slices, and by bisection.
///
/// Both ask one question, "is this moment free of overlap?", and know nothing else. That is their
/// strength, since any shape and any motion can answer it; and their weakness, since what goes in
/// and out again between two looks is never seen.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include <contact/ballistic.hpp>
#include <contact/bouncing.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Two moments with an impact between them.
template <Scalar S>
struct RollbackBracket {
  S free = S(0);     ///< s into the step: nothing overlapped then
  S blocked = S(0);  ///< s into the step, later: something did
  int looks = 0;     ///< how often the question was asked
};

// [slices]
/// The last slice of a step that is free, before the first that is not.
///
/// @param is_free whether nothing overlaps at a time from 0 to `step`; asked in order, until the
/// answer is no. Time 0 is taken to be free and not asked
/// @param step s, greater than 0
/// @param slices 1 or more
/// @return nothing if every slice is free. That does not prove that the step is: a thing that is in
/// and out between two slices is missed. The last free time is before the impact by at most
/// step / slices
/// @see *Fundamentals of Computer Animation*, slide "How About 2 MOVING spheres?": "take the
/// previous position as the intersection point"
template <Scalar S, class IsFree>
std::optional<RollbackBracket<S>> last_free_slice(const IsFree& is_free, const S& step,
                                                  int slices) {
  S before(0);
  for (int i = 1; i <= slices; ++i) {
    // The end itself, and not a sum of slices that rounding has put beside it.
    const S time = i == slices ? step : S(step * S(i) / S(slices));
    if (!is_free(time)) return RollbackBracket<S>{before, time, i};
    before = time;
  }
  return std::nullopt;
}
// [/slices]

// [bisection]
/// A bracket made half as wide, again and again.
///
/// It keeps its promise at every turn: its free end is free, its blocked end is blocked. So an
/// impact lies between them, though not always the first one.
/// @param is_free as above; it is asked once for each halving
/// @param width stops when the bracket is no wider, s, 0 or more. With 0 it stops when there is no
/// number between the ends, which takes no more than 1100 halvings for a double, and mostly 50
template <std::floating_point S, class IsFree>
RollbackBracket<S> bisected(const IsFree& is_free, RollbackBracket<S> bracket, const S& width) {
  while (bracket.blocked - bracket.free > width) {
    const S middle = bracket.free + (bracket.blocked - bracket.free) / S(2);
    if (!(bracket.free < middle && middle < bracket.blocked)) break;
    (is_free(middle) ? bracket.free : bracket.blocked) = middle;
    ++bracket.looks;
  }
  return bracket;
}
// [/bisection]

/// How a bouncing ball looks for its impact in a step.
template <std::floating_point S>
struct RollbackRules {
  int slices = 1;  ///< looks in one step, evenly spaced, 1 or more
  S width = S(0);  ///< bisects until the impact is known as well as this, s; infinite: not at all
};

// [rolled-back-step]
/// One step of a bouncing ball that goes back to the last free state before an impact, reflects the
/// velocity there, and uses up the rest of the step in the same way.
///
/// The impact is early by no more than the bracket is wide, and the ball turns a little above the
/// floor. With k = 1 no energy is gained or lost by that: it is reflected where it is, with the
/// speed that it has there.
/// @param now its state, on the floor or above it
/// @param ball for gravity and restitution
/// @param dt length of the step, s, greater than 0
/// @param rules how it looks
/// @note A flight shorter than a slice may not be seen. Bounces that are too short for the bracket,
/// or for the clock, end the step: the ball stays where it is until the next one
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
