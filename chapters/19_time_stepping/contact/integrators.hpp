/// @file
/// One step of a motion under a force: explicit and symplectic Euler, the two forms of Verlet's
/// step, and the classical Runge–Kutta step of order 4. Implicit Euler, for a spring, is in
/// spring_motion.hpp.
///
/// A law of force is a function that returns the acceleration at a position, in m/s². A position is
/// a number, for motion on a line, or a Vector3. The steps use only +, −, × and division by 2 or 6,
/// so on fractions they are exact.
#pragma once

#include <contact/vector.hpp>

namespace contact {

/// Position and velocity of a body.
/// @tparam V a number, for motion on a line, or a vector
template <class V>
struct MotionState {
  V position;  ///< m
  V velocity;  ///< m/s
};

/// Which step is taken.
enum class Integrator {
  explicit_euler,       ///< explicit Euler: the position with the old velocity, then the velocity
  semi_implicit_euler,  ///< symplectic Euler: the velocity, then the position with the new velocity
  velocity_verlet,      ///< half a velocity update, a whole position update, half a velocity update
  position_verlet,      ///< half a position update, a whole velocity update, half a position update
  runge_kutta_4         ///< four force evaluations
};

/// Explicit Euler (forward Euler): x' = x + h v, v' = v + h a(x), with velocity and acceleration of
/// the start of the step.
///
/// The error falls with h. On a spring every step multiplies the energy by 1 + (ω h)².
/// @param h length of the step, s
/// @param law the acceleration at a position, m/s²
// [explicit-euler]
template <class V, Scalar S, class Law>
MotionState<V> explicit_euler_step(const MotionState<V>& now, const S& h, const Law& law) {
  const V position = now.position + now.velocity * h;
  const V velocity = now.velocity + law(now.position) * h;
  return {position, velocity};
}

// [/explicit-euler]

/// Symplectic Euler (semi-implicit Euler): v' = v + h a(x), x' = x + h v'.
///
/// The error falls with h. On a spring v² + (ω x)² − h ω² x v is an invariant. As long as ω h < 2
/// the energy stays within a fraction of about ω h / 2 of it, and does not grow.
/// @param h, law as above
/// @see *Fundamentals of Computer Animation*, slide "Moving Under Gravity"
// [symplectic-euler]
template <class V, Scalar S, class Law>
MotionState<V> semi_implicit_euler_step(const MotionState<V>& now, const S& h, const Law& law) {
  const V velocity = now.velocity + law(now.position) * h;
  const V position = now.position + velocity * h;
  return {position, velocity};
}
// [/symplectic-euler]

/// Velocity Verlet (leapfrog, kick–drift–kick): the velocity for half a step with the acceleration
/// of the start, the position for a step, the velocity for half a step with the acceleration of the
/// end.
///
/// The error falls with h². The step is exact for a constant acceleration. On a spring
/// v² + (ω x)² (1 − (ω h)²/4) is an invariant, and the motion is bounded as long as ω h < 2. A step
/// of −h undoes it.
/// @param h, law as above
/// @see Verlet, *Computer "experiments" on classical fluids I*, Physical Review 159 (1967)
// [verlet]
template <class V, Scalar S, class Law>
MotionState<V> velocity_verlet_step(const MotionState<V>& now, const S& h, const Law& law) {
  const S half = h / S(2);
  const V middle = now.velocity + law(now.position) * half;
  const V position = now.position + middle * h;
  const V velocity = middle + law(position) * half;
  return {position, velocity};
}
// [/verlet]

/// Position Verlet (drift–kick–drift): the position for half a step, the velocity for a step with
/// the acceleration there, the position for half a step. One force evaluation.
///
/// The error falls with h². The step is exact for a constant acceleration. On a spring
/// v² (1 − (ω h)²/4) + (ω x)² is an invariant, and the motion is bounded as long as ω h < 2.
/// @param h, law as above
template <class V, Scalar S, class Law>
MotionState<V> position_verlet_step(const MotionState<V>& now, const S& h, const Law& law) {
  const S half = h / S(2);
  const V middle = now.position + now.velocity * half;
  const V velocity = now.velocity + law(middle) * h;
  const V position = middle + velocity * half;
  return {position, velocity};
}

// [runge-kutta]
/// The classical Runge–Kutta step (RK4): the derivative at the start, twice in the middle, at the
/// end, and their mean with the weights 1, 2, 2, 1.
///
/// The error falls with h⁴, for four force evaluations. The step is exact for a constant
/// acceleration. On a spring every step multiplies the energy by 1 − (ω h)⁶/72 + (ω h)⁸/576: a loss
/// for ω h < 2√2, a gain beyond.
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
/// One step by the given integrator.
/// @param h length of the step, s
/// @param law the acceleration at a position, m/s²
template <class V, Scalar S, class Law>
MotionState<V> motion_step(Integrator integrator, const MotionState<V>& now, const S& h,
                           const Law& law) {
  switch (integrator) {
    case Integrator::explicit_euler:
      return explicit_euler_step(now, h, law);
    case Integrator::semi_implicit_euler:
      return semi_implicit_euler_step(now, h, law);
    case Integrator::velocity_verlet:
      return velocity_verlet_step(now, h, law);
    case Integrator::position_verlet:
      return position_verlet_step(now, h, law);
    case Integrator::runge_kutta_4:
      break;
  }
  return runge_kutta_4_step(now, h, law);
}

/// Position and velocity after a number of steps.
/// @note Each step rounds again: after n steps the rounding error can reach a few n u.
template <class V, Scalar S, class Law>
MotionState<V> integrate(Integrator integrator, MotionState<V> state, const S& h, long long steps,
                         const Law& law) {
  for (long long i = 0; i < steps; ++i) state = motion_step(integrator, state, h, law);
  return state;
}
// [/integrate]

}  // namespace contact
