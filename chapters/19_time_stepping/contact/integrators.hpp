/// @file
/// One step of a motion under a force: Euler's step in its two orders, Verlet's two, and the
/// classical Runge–Kutta step of order 4.
///
/// A law of force is a function that gives the acceleration at a place, in m/s². A place is a
/// number, for motion on a line, or a Vector3. All but the last digit of what these steps do can be
/// seen with fractions: nothing here but +, − and ×, and a division by 2 or 6.
#pragma once

#include <contact/vector.hpp>

namespace contact {

/// Where a body is and how fast.
/// @tparam V a number, for motion on a line, or a vector
template <class V>
struct MotionState {
  V position;  ///< m
  V velocity;  ///< m/s
};

/// Which step is taken.
enum class Integrator {
  position_first,   ///< Euler: the position with the old velocity, then the velocity
  velocity_first,   ///< Euler: the velocity, then the position with the new one
  velocity_verlet,  ///< half a push, a whole way, half a push
  position_verlet,  ///< half a way, a whole push, half a way
  runge_kutta_4     ///< four looks at the force
};

// [euler]
/// Euler's step with the position first: x' = x + h v, v' = v + h a(x). Both with what was known at
/// the start of the step.
///
/// Its error falls with h. On a spring it adds energy in every step, by the factor 1 + (ω h)².
/// @param h length of the step, s
/// @param law the acceleration at a place, m/s²
template <class V, Scalar S, class Law>
MotionState<V> position_first_step(const MotionState<V>& now, const S& h, const Law& law) {
  const V position = now.position + now.velocity * h;
  const V velocity = now.velocity + law(now.position) * h;
  return {position, velocity};
}

/// Euler's step with the velocity first: v' = v + h a(x), x' = x + h v'.
///
/// Its error falls with h too. On a spring it keeps v² + (ω x)² − h ω² x v, as long as ω h < 2: so
/// the energy goes up and down by about ω h / 2 of itself, and does not run away.
/// @param h, law as above
/// @see *Fundamentals of Computer Animation*, slide "Moving Under Gravity"
template <class V, Scalar S, class Law>
MotionState<V> velocity_first_step(const MotionState<V>& now, const S& h, const Law& law) {
  const V velocity = now.velocity + law(now.position) * h;
  const V position = now.position + velocity * h;
  return {position, velocity};
}
// [/euler]

// [verlet]
/// Verlet's step by the velocity: half of the push with the force of the start, the way with what
/// that gives, half of the push with the force of the end.
///
/// Its error falls with h². It is exact for a constant acceleration. On a spring it keeps
/// v² + (ω x)² (1 − (ω h)²/4), as long as ω h < 2. Taken back with −h it returns to where it was.
/// @param h, law as above
/// @see Verlet, *Computer "experiments" on classical fluids I*, Physical Review 159 (1967)
template <class V, Scalar S, class Law>
MotionState<V> velocity_verlet_step(const MotionState<V>& now, const S& h, const Law& law) {
  const S half = h / S(2);
  const V middle = now.velocity + law(now.position) * half;
  const V position = now.position + middle * h;
  const V velocity = middle + law(position) * half;
  return {position, velocity};
}

/// Verlet's step by the position: half of the way, the whole push with the force there, the other
/// half of the way. One look at the force.
///
/// Its error falls with h². It is exact for a constant acceleration. On a spring it keeps
/// v² (1 − (ω h)²/4) + (ω x)², as long as ω h < 2.
/// @param h, law as above
template <class V, Scalar S, class Law>
MotionState<V> position_verlet_step(const MotionState<V>& now, const S& h, const Law& law) {
  const S half = h / S(2);
  const V middle = now.position + now.velocity * half;
  const V velocity = now.velocity + law(middle) * h;
  const V position = middle + velocity * half;
  return {position, velocity};
}
// [/verlet]

// [runge-kutta]
/// The classical Runge–Kutta step: the slope at the start, twice in the middle, at the end, and of
/// these a mean with the weights 1, 2, 2, 1.
///
/// Its error falls with h⁴, for four looks at the force. It is exact for a constant acceleration.
/// On a spring it loses energy in every step, by the factor 1 − (ω h)⁶/72 + (ω h)⁸/576, as long as
/// ω h < 2√2; beyond that it gains.
/// @param h, law as above
template <class V, Scalar S, class Law>
MotionState<V> runge_kutta_4_step(const MotionState<V>& now, const S& h, const Law& law) {
  const S half = h / S(2);
  const V a1 = law(now.position);
  const V v2 = now.velocity + a1 * half;
  const V a2 = law(V(now.position + now.velocity * half));
  const V v3 = now.velocity + a2 * half;
  const V a3 = law(V(now.position + v2 * half));
  const V v4 = now.velocity + a3 * h;
  const V a4 = law(V(now.position + v3 * h));
  const S sixth = h / S(6);
  const V position = now.position + (now.velocity + (v2 + v3) * S(2) + v4) * sixth;
  const V velocity = now.velocity + (a1 + (a2 + a3) * S(2) + a4) * sixth;
  return {position, velocity};
}
// [/runge-kutta]

// [integrate]
/// One step by the integrator of that name.
/// @param h length of the step, s
/// @param law the acceleration at a place, m/s²
template <class V, Scalar S, class Law>
MotionState<V> motion_step(Integrator integrator, const MotionState<V>& now, const S& h,
                           const Law& law) {
  switch (integrator) {
    case Integrator::position_first:
      return position_first_step(now, h, law);
    case Integrator::velocity_first:
      return velocity_first_step(now, h, law);
    case Integrator::velocity_verlet:
      return velocity_verlet_step(now, h, law);
    case Integrator::position_verlet:
      return position_verlet_step(now, h, law);
    case Integrator::runge_kutta_4:
      break;
  }
  return runge_kutta_4_step(now, h, law);
}

/// Where a body is after so many steps.
/// @note Each step rounds once more; after n steps that may come to some n u.
template <class V, Scalar S, class Law>
MotionState<V> integrate(Integrator integrator, MotionState<V> state, const S& h, long long steps,
                         const Law& law) {
  for (long long i = 0; i < steps; ++i) state = motion_step(integrator, state, h, law);
  return state;
}
// [/integrate]

}  // namespace contact
