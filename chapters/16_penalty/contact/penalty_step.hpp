/// @file
/// A contact spring in time steps: four integration schemes, the steps for which each is stable,
/// and the step for a required accuracy.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/spring_damper.hpp>

namespace contact {

/// How a step computes the next penetration and velocity.
enum class PenaltyScheme {
  explicit_euler,       ///< position with the old velocity, velocity with the old force
  semi_implicit_euler,  ///< symplectic Euler: velocity with the old force, position with the new
                        ///< velocity
  implicit_damper,      ///< the same, but with the damping force of the new velocity
  implicit_euler        ///< spring and damping force of the new penetration and velocity
};

/// Penetration and velocity of a body along the normal of a contact.
template <Ring S>
struct PenaltyState {
  S penetration = S(0);  ///< m; negative: a gap
  S approach = S(0);     ///< m/s; negative: it separates
};

namespace detail {

template <Scalar S>
PenaltyState<S> free_step(PenaltyScheme scheme, const PenaltyState<S>& now, const S& h,
                          const S& load) {
  const S speed = now.approach + h * load;
  const S moved = h * (scheme == PenaltyScheme::explicit_euler ? now.approach : speed);
  return {now.penetration + moved, speed};
}

}  // namespace detail

// [spring-step]
/// One step of a mass that stays attached to a spring and a damper, which push and pull: a linear
/// map.
/// @param mass kg, greater than 0
/// @param h length of the step, s, greater than 0
/// @param load acceleration towards the surface by other forces, such as gravity, m/s²
template <Scalar S>
PenaltyState<S> spring_step(PenaltyScheme scheme, const PenaltyState<S>& now,
                            const SpringDamper<S>& spring, const S& mass, const S& h,
                            const S& load) {
  const S pull = load - spring.stiffness * now.penetration / mass;  // without the damper
  const S damper = h * spring.damping / mass;
  const S carried = now.approach + h * pull;
  if (scheme == PenaltyScheme::explicit_euler || scheme == PenaltyScheme::semi_implicit_euler) {
    const S speed = carried - damper * now.approach;
    const bool old = scheme == PenaltyScheme::explicit_euler;
    return {now.penetration + h * (old ? now.approach : speed), speed};
  }
  S divisor = S(1) + damper;
  if (scheme == PenaltyScheme::implicit_euler) divisor = divisor + h * h * spring.stiffness / mass;
  const S speed = carried / divisor;
  return {now.penetration + h * speed, speed};
}
// [/spring-step]

// [penalty-step]
/// One step of a body at a contact: spring and damper act if it touches or overlaps at the start of
/// the step.
/// @param rule with ContactRelease::at_zero_force, a step in which the contact would pull in total
/// is taken without the contact
/// @param h s, greater than 0; mass and load as for spring_step()
template <Scalar S>
PenaltyState<S> penalty_step(PenaltyScheme scheme, const PenaltyState<S>& now,
                             const SpringDamper<S>& spring, const S& mass, const S& h,
                             const S& load, ContactRelease rule = ContactRelease::at_zero_force) {
  const PenaltyState<S> without = detail::free_step(scheme, now, h, load);
  if (now.penetration < S(0)) return without;
  const PenaltyState<S> with = spring_step(scheme, now, spring, mass, h, load);
  if (rule == ContactRelease::at_zero_force && with.approach > without.approach) return without;
  return with;
}
// [/penalty-step]

/// Stability of a step: the behaviour of a body on a spring after many steps.
enum class StepBehaviour {
  decays,   ///< it converges to rest
  bounded,  ///< it neither converges nor diverges
  grows     ///< it diverges: the step is too long
};

// [step-behaviour]
/// The stability of the steps of spring_step(), for every start. Exact for the stored numbers.
///
/// With a = h² k / m and b = h c / m a step is a matrix with trace T and determinant D. The motion
/// decays if D < 1 and −T < 1 + D (T < 1 + D always holds, since a > 0):
///
/// | | decays if |
/// |---|---|
/// | explicit Euler | a < b and 2 b < 4 + a |
/// | semi-implicit Euler | 0 < b and a + 2 b < 4 |
/// | implicit damper | 0 < b and a < 4 + 2 b |
/// | implicit Euler | always |
///
/// If one of the two inequalities is an equality, the motion stays bounded. If both are, −1 is a
/// double eigenvalue, and the motion grows linearly with the number of steps.
/// @param mass kg, greater than 0
/// @param h s, greater than 0
template <Ring S>
StepBehaviour step_behaviour(PenaltyScheme scheme, const SpringDamper<S>& spring, const S& mass,
                             const S& h) {
  using T = decltype(detail::unrounded(mass));
  const T m = detail::unrounded(mass);
  const T step = detail::unrounded(h);
  const T a = step * step * detail::unrounded(spring.stiffness);  // times m, like all below
  const T b = step * detail::unrounded(spring.damping);
  T below_one = a + b;                      // m (1 − D), up to a positive factor
  T above_minus_one = T(4) * m + T(2) * b;  // m (1 + T + D), up to a positive factor
  switch (scheme) {
    case PenaltyScheme::explicit_euler:
      below_one = b - a;
      above_minus_one = T(4) * m + a - T(2) * b;
      break;
    case PenaltyScheme::semi_implicit_euler:
      below_one = b;
      above_minus_one = T(4) * m - a - T(2) * b;
      break;
    case PenaltyScheme::implicit_damper:
      below_one = b;
      above_minus_one = above_minus_one - a;
      break;
    case PenaltyScheme::implicit_euler:
      above_minus_one = above_minus_one + a;
      break;
  }
  const T zero(0);
  if (below_one < zero || above_minus_one < zero) return StepBehaviour::grows;
  if (below_one > zero && above_minus_one > zero) return StepBehaviour::decays;
  return below_one == zero && above_minus_one == zero ? StepBehaviour::grows
                                                      : StepBehaviour::bounded;
}
// [/step-behaviour]

// [step-limit]
/// The stability limit: the smallest step for which step_behaviour() is `grows`. Every shorter step
/// decays, or stays bounded without a damper. 0: with explicit Euler and without a damper every
/// step grows. ∞: no step does.
///
/// Semi-implicit Euler: 4 m / (c + √(c² + 4 k m)), which is 2 √(m / k) without a damper; a damper
/// reduces it. Explicit Euler: c / k while c² ≤ 4 k m, else 4 m / (c + √(c² − 4 k m)).
/// Implicit damper: (c + √(c² + 4 k m)) / k.
/// @param mass kg, greater than 0
/// @return s; relative error at most 8 u if k, m and c² are from 1e-120 to 1e120 (in double; 1e-15
/// to 1e15 in float)
template <std::floating_point S>
S step_limit(PenaltyScheme scheme, const SpringDamper<S>& spring, const S& mass) {
  const S k = spring.stiffness;
  const S c = spring.damping;
  if (scheme == PenaltyScheme::implicit_euler) return std::numeric_limits<S>::infinity();
  if (scheme == PenaltyScheme::explicit_euler) {
    const S discriminant = rounded<S>(detail::damping_discriminant(spring, mass));
    if (!(discriminant > S(0))) return c / k;
    return S(4) * mass / (c + std::sqrt(discriminant));
  }
  const S sum = c + std::sqrt(c * c + S(4) * k * mass);
  return scheme == PenaltyScheme::implicit_damper ? S(sum / k) : S(S(4) * mass / sum);
}
// [/step-limit]

/// Bounds on the change of the kinetic energy by an impact in steps.
template <Scalar S>
struct EnergyFactor {
  S min = S(1);  ///< lower bound of the energy after over the energy before
  S max = S(1);  ///< upper bound
};

// [energy-factor]
/// Bounds on the factor by which one impact on an undamped spring, without load, in steps of
/// semi-implicit Euler changes the kinetic energy: from 1 − a/4 to 1 / (1 − a/4), with
/// a = h² k / m < 4.
///
/// v² + ω₀² d² − h ω₀² d v is an invariant of the steps. At the first step with an overlap, d is
/// between 0 and h v, so the invariant is between (1 − a/4) v² and v². The same holds for the speed
/// after the last step with an overlap. The extreme values belong to an overlap of h v / 2 at
/// the first or at the last step. The penetration is at most v √(m / k) / √(1 − a/4).
/// @param mass kg, greater than 0
/// @param h s, greater than 0 and below step_limit()
/// @note The bounds do not hold with a damper, which removes energy in addition.
template <Scalar S>
EnergyFactor<S> stepped_energy_factor(const SpringDamper<S>& spring, const S& mass, const S& h) {
  const S least = S(1) - h * h * spring.stiffness / mass / S(4);
  return {least, S(1) / least};
}

/// The longest step with which one such impact changes the kinetic energy by at most the fraction
/// ε: √(4 ε m / ((1 + ε) k)). An impact takes about π / √a steps, so half the ε takes √2 times as
/// many.
/// @param mass kg, greater than 0
/// @param share ε, greater than 0
/// @return s; relative error at most 6 u
template <std::floating_point S>
S step_for_energy(const SpringDamper<S>& spring, const S& mass, const S& share) {
  return S(2) * std::sqrt(share / (S(1) + share)) * (std::sqrt(mass) / std::sqrt(spring.stiffness));
}
// [/energy-factor]

}  // namespace contact
