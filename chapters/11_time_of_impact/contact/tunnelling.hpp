/// @file
/// Tunnelling: when a body cannot pass through another between two tests, and how long a missed
/// chord can be.
///
/// Every bound is rounded upwards, so the proof holds for the stored numbers.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// An upper bound that includes a few roundings of non-negative numbers: x plus γ(16) x and 16 η.
template <std::floating_point S>
S a_little_more(S x) {
  return x + (tolerance::gamma<S>(16) * x + S(16) * tolerance::underflow_unit<S>);
}

template <std::floating_point S>
void require_not_negative(const char* argument, S x) {
  require_finite(argument, x);
  if (x < S(0)) throw_invalid_argument(argument, number_text(x), "must not be negative");
}

}  // namespace detail

/// Bounds on the motion and size of a body during a step.
template <std::floating_point S>
struct Mover {
  S inner_radius = S(0);      ///< of a ball about its centre inside the body, m
  S outer_radius = S(0);      ///< of a ball about its centre that contains the body, m
  S angular_velocity = S(0);  ///< upper bound of |ω|, rad/s
};

/// Checks the bounds of a body.
/// @param inner_radius, outer_radius m, finite, 0 ≤ inner ≤ outer
/// @param angular_velocity upper bound of |ω|, rad/s, finite, not negative
/// @throws std::invalid_argument if an argument does not satisfy these conditions
template <std::floating_point S>
Mover<S> mover(S inner_radius, S outer_radius, S angular_velocity) {
  detail::require_not_negative("inner_radius", inner_radius);
  detail::require_not_negative("outer_radius", outer_radius);
  detail::require_not_negative("angular_velocity", angular_velocity);
  if (outer_radius < inner_radius) {
    throw_invalid_argument("outer_radius", number_text(outer_radius),
                           "must not be less than inner_radius");
  }
  return {inner_radius, outer_radius, angular_velocity};
}

// [step-displacement]
/// The largest displacement of the centre of one body in a step, relative to the centre of the
/// other: h |v| + h² |a| / 2, rounded upwards.
/// @param speed upper bound of |v_a − v_b| at the start of the step, m/s
/// @param acceleration upper bound of |a_a − a_b|, m/s²; 0 for two bodies in the same gravity
/// @param step h, s
/// @throws std::invalid_argument if an argument is negative or not finite
template <std::floating_point S>
S centre_displacement(S speed, S acceleration, S step) {
  detail::require_not_negative("speed", speed);
  detail::require_not_negative("acceleration", acceleration);
  detail::require_not_negative("step", step);
  return detail::a_little_more((speed + acceleration * step / S(2)) * step);
}

/// The largest displacement of any point of one body in a step relative to any frame that rotates
/// with the other, while they are close enough to touch.
///
/// Let L be the displacement of the centres. Where they can touch, the centres are at most R = r_a
/// + r_b apart, so at most R + L throughout the step. A point of the other's frame there moves by
/// at most ω_b (R + L) h, and a point of the first about its centre by ω_a r_a h. To be symmetric,
/// the larger terms are taken for both: L + h (ω_a (R + L) + ω_b (R + L)).
/// @param a, b made by mover()
/// @param centres from centre_displacement(), m
/// @param step h, s
/// @return m, rounded upwards
template <std::floating_point S>
S relative_displacement(const Mover<S>& a, const Mover<S>& b, S centres, S step) {
  const S extent = a.outer_radius + b.outer_radius + centres;
  return detail::a_little_more(centres + (a.angular_velocity + b.angular_velocity) * step * extent);
}
// [/step-displacement]

/// The two sides of a proof: the largest displacement in a step, and the thickness of the obstacle.
template <std::floating_point S>
struct TunnellingBound {
  S displacement = S(0);  ///< the largest relative displacement in a step, m, rounded upwards
  S thickness = S(0);     ///< of the obstacle, m, rounded downwards

  /// Whether it is proven that no test misses a passage from one side of the obstacle to the other:
  /// displacement ≤ thickness. See slab_tunnelling() for what can still be missed.
  bool nothing_passes() const { return displacement <= thickness; }
};

// [nothing-passes]
/// The proof that a body cannot pass through a slab between two tests.
///
/// A slab is the space between two parallel planes: a wall. The body contains a ball of radius ρ
/// about its centre. While the centre is within w/2 + ρ of the middle plane of the slab, they
/// touch: a layer of thickness w + 2 ρ. To be behind it at one test and in front of it at the test
/// before, the centre must move by more than that. So if it moves by at most w + 2 ρ in a step, it
/// does not get to the other side unless a test finds the touch. (A smaller ρ, at least 0, gives a
/// valid but weaker bound.)
///
/// A ball of radius ρ whose centre moves at a constant velocity does not turn back, so no touch of
/// it is missed. Other bodies may touch the slab and leave it on the same side between two tests:
/// an accelerated ball turns back, and the end of a rod that turns reaches beyond ρ.
/// @param body made by mover(); the slab is at rest in the frame in which the displacement is
/// measured
/// @param thickness w of the slab, m
/// @param displacement from relative_displacement() or centre_displacement(), m
template <std::floating_point S>
TunnellingBound<S> slab_tunnelling(const Mover<S>& body, S thickness, S displacement) {
  detail::require_not_negative("thickness", thickness);
  detail::require_not_negative("displacement", displacement);
  return {displacement, sum_down(sum_down(thickness, body.inner_radius), body.inner_radius)};
}

/// The same for two bodies: the inner balls touch while the centres are within ρ = ρ_a + ρ_b, and
/// along a line through the centre that is a path of 2 ρ.
///
/// It proves that no two bodies whose centres move straight, relative to each other, pass through
/// each other along such a line, or along any line that cuts a chord of at least the displacement
/// out of the ball of radius ρ. Shorter chords, near the rim, may be missed: missed_chord() bounds
/// them. Touches of what is outside the inner balls may be missed, too.
template <std::floating_point S>
TunnellingBound<S> pair_tunnelling(const Mover<S>& a, const Mover<S>& b, S displacement) {
  detail::require_not_negative("displacement", displacement);
  const S core = sum_down(a.inner_radius, b.inner_radius);
  return {displacement, sum_down(core, core)};
}
// [/nothing-passes]

/// Bounds on the grazes that can be missed.
template <std::floating_point S>
struct MissedChord {
  S length = S(0);  ///< of the longest chord that can be missed, m
  S depth = S(0);   ///< largest overlap of the bodies on it, m
  /// Upper bound of the missed approach speed as a fraction of the relative speed: the cosine of
  /// the angle between the path and the normal at the touch.
  S approach = S(0);
};

// [missed-chord]
/// The deepest graze that two tests can miss.
///
/// A straight path cuts a chord c out of the ball of radius ρ in which the bodies touch. On a chord
/// of at least the displacement D there is a test. So a missed chord has c < D, its sagitta is less
/// than ρ − √(ρ² − D²/4), and where it enters, the normal component of the velocity is less than
/// the fraction D / (2 ρ) of the speed. For a small D the difference cancels, so the sagitta is
/// written (D²/4) / (ρ + √(ρ² − D²/4)).
/// @param radius_sum ρ, m, finite and greater than 0: for balls the sum of the radii
/// @param displacement D, m, in a step
/// @return upper bounds; for D ≥ 2 ρ, up to rounding, every graze can be missed: 2 ρ, ρ and 1
/// @throws std::invalid_argument if an argument does not satisfy these conditions
template <std::floating_point S>
MissedChord<S> missed_chord(S radius_sum, S displacement) {
  detail::require_not_negative("displacement", displacement);
  require_finite("radius_sum", radius_sum);
  if (!(radius_sum > S(0)))
    throw_invalid_argument("radius_sum", number_text(radius_sum), "must exceed 0");
  // Rounded upwards first: the depth increases with the ratio, and 1 − ratio is then exact or
  // nearly exact.
  const S ratio = detail::a_little_more(displacement / radius_sum / S(2));
  if (!(ratio < S(1))) return {S(2) * radius_sum, radius_sum, S(1)};
  const S rest = std::sqrt((S(1) - ratio) * (S(1) + ratio));
  const S depth = detail::a_little_more(radius_sum * (ratio * ratio / (S(1) + rest)));
  return {displacement, depth < radius_sum ? depth : radius_sum, ratio};
}
// [/missed-chord]

// [energy-speed]
/// The largest speed that the energy allows: √(2 (E − U) / m), rounded upwards.
///
/// If the forces have a potential that is at least U, and nothing adds energy, the kinetic energy
/// is at most E − U.
/// @param energy E, kinetic plus potential, J, finite
/// @param min_potential U, J, finite
/// @param mass m, kg, finite and greater than 0
/// @return m/s; 0 if E ≤ U
/// @throws std::invalid_argument if an argument does not satisfy these conditions
template <std::floating_point S>
S energy_speed(S energy, S min_potential, S mass) {
  require_finite("energy", energy);
  require_finite("min_potential", min_potential);
  require_finite("mass", mass);
  if (!(mass > S(0))) throw_invalid_argument("mass", number_text(mass), "must exceed 0");
  const S kinetic = sum_up(energy, -min_potential);
  if (!(kinetic > S(0))) return S(0);
  return detail::a_little_more(std::sqrt(detail::a_little_more(kinetic / mass * S(2))));
}
// [/energy-speed]

}  // namespace contact
