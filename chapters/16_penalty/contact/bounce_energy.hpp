/// @file
/// The energy that a bounce on a spring gains or loses in steps, also beyond the stability limit.
#pragma once

#include <contact/invalid_argument.hpp>
#include <contact/penalty_step.hpp>

namespace contact {

namespace detail {

/// a − 1 with a = h² k / m.
template <Scalar S>
S bounce_growth(const SpringDamper<S>& spring, const S& mass, const S& h) {
  return h * h * spring.stiffness / mass - S(1);
}

}  // namespace detail

// [bounce-energy]
/// Bounds on the factor by which one bounce on an undamped spring, without load, in steps of
/// semi-implicit Euler changes the kinetic energy, for every step h > 0. With a = h² k / m they are
/// those of stepped_energy_factor() for a < 2, else from 1 / (a − 1)² to (a − 1)².
///
/// For a ≥ 2 the force acts in at most two steps. Let the first overlap be σ h v. After one step
/// the velocity is (1 − a σ) v and the overlap (1 − (a − 1) σ) h v: the body has left if σ > 1 / (a
/// − 1). Otherwise a second step gives the velocity −((a − 1) − a (a − 2) σ) v, and it has left, as
/// the overlap is linear in σ and negative at both ends. Both velocities are linear in σ, so the
/// extreme values are at the ends, σ = 0 and σ = 1 / (a − 1), and they are reached.
///
/// Both forms of Verlet's step have the same bounds: between two forces they move the body by h v
/// as well, so velocities between the forces and positions at them are those of semi-implicit
/// Euler.
/// @param mass kg, greater than 0
/// @param h s, greater than 0
/// @note So the stability limit a = 4 is no limit for the energy: there a bounce multiplies it by
/// up to 9. The bounds do not hold with a damper, which removes energy in addition.
template <Scalar S>
EnergyFactor<S> bounce_energy_factor(const SpringDamper<S>& spring, const S& mass, const S& h) {
  const S growth = detail::bounce_growth(spring, mass, h);
  if (growth < S(1)) return stepped_energy_factor(spring, mass, h);
  return {S(1) / (growth * growth), growth * growth};
}
// [/bounce-energy]

// [mean-bounce-energy]
/// The mean of that factor for a ≥ 2 if every first overlap is equally likely:
/// (A² + 1 + 1 / A²) / 3 with A = a − 1. It is 1 for a = 2 only, and 3.37 at the stability limit.
///
/// For every a below 4 this mean is at least 1. The steps preserve area in the plane of overlap and
/// velocity, so with R the ratio of speeds the first overlaps of an interval dσ become last ones of
/// R² or 1 / R² times its length: the mean of 1 / R² is exactly 1. And the mean of R² is at least
/// 1 over the mean of 1 / R² (Cauchy–Schwarz), with equality only if all bounces have R = 1.
/// @param mass kg, greater than 0
/// @param h s; h² k / m at least 2
/// @throws std::invalid_argument if h² k / m is less than 2: then there is no such closed form
template <Scalar S>
S mean_bounce_energy_factor(const SpringDamper<S>& spring, const S& mass, const S& h) {
  const S growth = detail::bounce_growth(spring, mass, h);
  if (!(growth >= S(1))) {
    throw_invalid_argument("h", number_text(h), "h² k / m must be at least 2");
  }
  const S square = growth * growth;
  return (square + S(1) + S(1) / square) / S(3);
}
// [/mean-bounce-energy]

// [step-area-factor]
/// The factor by which a step on an attached spring and damper multiplies areas in the plane of
/// penetration and velocity: the determinant of its matrix.
///
/// Without a damper it is 1 for semi-implicit Euler and both forms of Verlet's step. Explicit Euler
/// (1 + a), implicit Euler (1 / (1 + a)) and Runge–Kutta (1 − a³ / 72 + a⁴ / 576) then rotate and
/// scale the plane of ω₀ d and v, so the energy of spring and motion is multiplied by exactly this
/// factor, whatever the state.
/// @note A bounce of n steps multiplies the kinetic energy by the n-th power only roughly: its
/// first and last overlap begin and end within a step, where the body is free for a part of it.
/// @param mass kg, greater than 0
/// @param h s, greater than 0
template <Scalar S>
S step_area_factor(PenaltyScheme scheme, const SpringDamper<S>& spring, const S& mass, const S& h) {
  const auto first = spring_step<S>(scheme, {S(1), S(0)}, spring, mass, h, S(0));
  const auto second = spring_step<S>(scheme, {S(0), S(1)}, spring, mass, h, S(0));
  return first.penetration * second.approach - first.approach * second.penetration;
}
// [/step-area-factor]

}  // namespace contact
