/// @file
/// A body on a spring: its law of force, its energy and its true motion, to hold steps against.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/integrators.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/rotation.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A body on a spring whose force is −m ω² x. Make it with linear_spring(), which checks what it is
/// given.
template <Scalar S>
struct LinearSpring {
  S angular_frequency = S(1);  ///< ω = √(stiffness / mass), rad/s, greater than 0

  /// The acceleration at a place, −ω² x, m/s².
  S operator()(const S& position) const {
    return -(angular_frequency * angular_frequency * position);
  }
};

/// A spring that swings with the angular frequency ω.
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
/// The energy of each kilogram, (v² + ω² x²) / 2, in J/kg.
template <Scalar S>
S spring_energy(const LinearSpring<S>& spring, const MotionState<S>& state) {
  const S stretch = spring.angular_frequency * state.position;
  return (state.velocity * state.velocity + stretch * stretch) / S(2);
}
// [/spring-energy]

// [spring-motion]
/// The true motion: x cos ωt + (v/ω) sin ωt, and its velocity.
/// @param start at time 0
/// @param t s, of either sign
/// @return off by some u (8 + ω |t|) (|x| + |v|/ω), and ω times that for the velocity: the angle
/// ω t itself is rounded
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
