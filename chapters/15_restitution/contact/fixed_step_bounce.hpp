/// @file
/// A bouncing ball in fixed time steps: five rules for a step with an impact, of which one is
/// right.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/bouncing.hpp>

namespace contact {

/// The rule for a step that reaches the floor.
enum class StepRule {
  /// No test for approach: below the floor the velocity is reversed, and the height is kept.
  flip_below,
  /// Below the floor the ball is put on it, and its velocity is reversed.
  clamp,
  /// The lecture's loop: the new velocity of the semi-implicit Euler step moves the ball to the
  /// floor, is reflected, and moves it on for the rest of the step.
  new_velocity,
  /// The exact parabola and time of impact, but the velocity of the end of the step is reflected
  /// there; with it the ball flies on for the rest of the step.
  end_velocity,
  /// The exact parabola, time and velocity of the impact, and of every further impact in the step.
  impact_velocity
};

namespace detail {

template <std::floating_point S>
BounceState<S> euler_step(BounceState<S> now, const BouncingBall<S>& ball, const S& dt,
                          StepRule rule) {
  const S k = ball.restitution;
  now.velocity -= ball.gravity * dt;
  const S moved = now.height + now.velocity * dt;
  if (!(moved < S(0)) || (rule == StepRule::new_velocity && !(now.velocity < S(0)))) {
    now.height = moved;
    return now;
  }
  if (rule == StepRule::new_velocity) {
    const S share = now.height / (now.height - moved);  // of the step, until the impact
    now.velocity *= -k;
    now.height = (S(1) - share) * dt * now.velocity;
  } else {
    now.velocity *= -k;
    now.height = rule == StepRule::clamp ? S(0) : moved;
  }
  now.bounces += S(1);
  return now;
}

template <std::floating_point S>
BounceState<S> end_velocity_step(const BounceState<S>& now, const BouncingBall<S>& ball,
                                 const S& dt) {
  const S g = ball.gravity;
  const BouncingBall<S> flying{now.height, now.velocity, g, ball.restitution};
  const S until = first_impact_time(flying);
  if (!(until < dt)) {
    return {now.height + (now.velocity - g * dt / S(2)) * dt, now.velocity - g * dt, now.bounces,
            false};
  }
  const S leaving = ball.restitution * (g * dt - now.velocity);
  const S rest = dt - until;
  return {std::max(S(0), S((leaving - g * rest / S(2)) * rest)), leaving - g * rest,
          now.bounces + S(1), false};
}

}  // namespace detail

// [step]
/// One step of a bouncing ball.
/// @param now its state; `resting` only ever becomes true with StepRule::impact_velocity
/// @param ball for gravity and restitution; height and velocity do not matter
/// @param dt length of the step, s, greater than 0
template <std::floating_point S>
BounceState<S> bounce_step(const BounceState<S>& now, const BouncingBall<S>& ball, const S& dt,
                           StepRule rule) {
  if (now.resting) return now;
  if (rule == StepRule::end_velocity) return detail::end_velocity_step(now, ball, dt);
  if (rule != StepRule::impact_velocity) return detail::euler_step(now, ball, dt, rule);
  // All impacts of the step at once, even infinitely many.
  BounceState<S> then =
      bounce_at(BouncingBall<S>{now.height, now.velocity, ball.gravity, ball.restitution}, dt);
  then.bounces += now.bounces;
  return then;
}
// [/step]

// [steps]
/// The state of a ball after so many steps of dt.
/// @note Each step rounds: after n steps height and velocity are off by some n u more than the
/// error of the rule.
template <std::floating_point S>
BounceState<S> bounce_in_steps(const BouncingBall<S>& ball, const S& dt, long long steps,
                               StepRule rule) {
  BounceState<S> state{ball.height, ball.velocity, S(0), false};
  for (long long i = 0; i < steps; ++i) state = bounce_step(state, ball, dt, rule);
  return state;
}
// [/steps]

}  // namespace contact
