/// @file
/// A body on a linear spring: acceleration, energy, exact motion, and the step of implicit Euler.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/integrators.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A body on a spring with the force −m ω² x. Make it with linear_spring(), which checks its
/// argument.
template <Scalar S>
struct LinearSpring {
  S angular_frequency = S(1);  ///< ω = √(stiffness / mass), rad/s, greater than 0

  /// The acceleration at a position, −ω² x, m/s².
  S operator()(const S& position) const {
    return -(angular_frequency * angular_frequency * position);
  }
};

/// A spring with the angular frequency ω.
/// @param angular_frequency rad/s, greater than 0
/// @throws std::invalid_argument if it is not greater than 0 or not finite
template <Scalar S>
LinearSpring<S> linear_spring(const S& angular_frequency) {
  require_finite("angular_frequency", angular_frequency);
  if (!(angular_frequency > S(0))) {
    throw_invalid_argument("angular_frequency", number_text(angular_frequency),
                           "must be greater than 0");
  }
  return {angular_frequency};
}

// [spring-energy]
/// The energy per unit of mass, (v² + ω² x²) / 2, in J/kg.
template <Scalar S>
S spring_energy(const LinearSpring<S>& spring, const MotionState<S>& state) {
  const S stretch = spring.angular_frequency * state.position;
  return (state.velocity * state.velocity + stretch * stretch) / S(2);
}
// [/spring-energy]

/// One step of implicit Euler (backward Euler) on a spring: x' = x + h v', v' = v − h ω² x', solved
/// for x' and v'. For other forces this equation is not linear, and needs an iteration.
///
/// The error falls with h. Every step divides the energy by 1 + (ω h)² and the amplitude by its
/// root: the step is stable for every h, and it damps a spring that has no damper. It is the
/// adjoint of explicit Euler: explicit_euler_step() with −h undoes it.
/// @param h length of the step, s, 0 or more
// [implicit-euler]
template <Scalar S>
MotionState<S> implicit_euler_step(const MotionState<S>& now, const S& h,
                                   const LinearSpring<S>& spring) {
  const S pull = spring.angular_frequency * spring.angular_frequency * h;
  const S velocity = (now.velocity - pull * now.position) / (S(1) + pull * h);
  const S position = now.position + velocity * h;
  return {position, velocity};
}
// [/implicit-euler]

// [spring-motion]
/// The exact motion: x cos ωt + (v/ω) sin ωt, and its velocity.
/// @param start at time 0
/// @param t s, of either sign
/// @return the position with an error of about u (8 + ω |t|) (|x| + |v|/ω), and the velocity with
/// ω times that: the angle ω t itself is rounded
template <std::floating_point S>
MotionState<S> spring_motion(const LinearSpring<S>& spring, const MotionState<S>& start,
                             const S& t) {
  const S w = spring.angular_frequency;
  const SineCosine<S> turn = sine_cosine<S>(w * t);
  return {start.position * turn.cosine + start.velocity / w * turn.sine,
          start.velocity * turn.cosine - w * start.position * turn.sine};
}
// [/spring-motion]

}  // namespace contact
