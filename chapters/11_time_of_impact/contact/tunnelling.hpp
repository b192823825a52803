/// @file
/// What a step may skip: when nothing can pass through unseen, and how short a chord can be that is
/// missed.
///
/// Every bound here is rounded upwards: a proof that holds on paper holds for the stored numbers.
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

/// A few roundings of numbers that are not negative, made good: x with γ(16) and 16 η on top.
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

/// What is known of a body's motion and size during a step.
template <std::floating_point S>
struct Mover {
  S inner_radius = S(0);  ///< of a ball about its centre that it holds, m
  S outer_radius = S(0);  ///< of a ball about its centre that holds it, m
  S spin = S(0);          ///< |ω| at most, rad/s
};

/// Checks what is known of a body.
/// @param inner_radius, outer_radius m, finite, 0 ≤ inner ≤ outer
/// @param spin |ω| at most, rad/s, finite, not negative
/// @throws std::invalid_argument if an argument is not as said
template <std::floating_point S>
Mover<S> mover(S inner_radius, S outer_radius, S spin) {
  detail::require_not_negative("inner_radius", inner_radius);
  detail::require_not_negative("outer_radius", outer_radius);
  detail::require_not_negative("spin", spin);
  if (outer_radius < inner_radius) {
    throw_invalid_argument("outer_radius", number_text(outer_radius),
                           "must not be less than inner_radius");
  }
  return {inner_radius, outer_radius, spin};
}

// [step-displacement]
/// How far the centre of one body can get in a step, seen from the centre of the other: h |v| + h²
/// |a| / 2, rounded upwards.
/// @param speed |v_a − v_b| at the beginning of the step at most, m/s
/// @param acceleration |a_a − a_b| at most, m/s²; 0 for two bodies in one field of gravity
/// @param step h, s
/// @throws std::invalid_argument if an argument is negative or not finite
template <std::floating_point S>
S centre_displacement(S speed, S acceleration, S step) {
  detail::require_not_negative("speed", speed);
  detail::require_not_negative("acceleration", acceleration);
  detail::require_not_negative("step", step);
  return detail::a_little_more((speed + acceleration * step / S(2)) * step);
}

/// How far any point of one body can get in a step relative to any frame that turns with the other,
/// while they are near enough to touch.
///
/// With L the displacement of the centres: where they can touch, the centres are at most R = r_a +
/// r_b apart, so at most R + L all through the step. A point of the other's frame there moves by at
/// most ω_b (R + L) h, and a point of the one about its centre by ω_a r_a h. To be the same from
/// both sides, both bodies' terms are taken for both: L + h (ω_a (R + L) + ω_b (R + L)).
/// @param a, b as mover() makes them
/// @param centres as centre_displacement() gives it, m
/// @param step h, s
/// @return m, rounded upwards
template <std::floating_point S>
S relative_displacement(const Mover<S>& a, const Mover<S>& b, S centres, S step) {
  const S reach = a.outer_radius + b.outer_radius + centres;
  return detail::a_little_more(centres + (a.spin + b.spin) * step * reach);
}
// [/step-displacement]

/// What a proof compares: how far things get in a step, and how thick is what they would have to
/// pass.
template <std::floating_point S>
struct TunnellingBound {
  S displacement = S(0);  ///< the largest relative displacement in a step, m, rounded upwards
  S thickness = S(0);     ///< of what is in the way, m, rounded downwards

  /// Whether it is proven that nothing passes through unseen: displacement ≤ thickness.
  bool nothing_passes() const { return displacement <= thickness; }
};

// [nothing-passes]
/// The proof that a body cannot get from one side of a slab to the other between two looks.
///
/// A slab is all that is between two parallel planes: a wall. The body holds a ball of the radius
/// ρ about its centre. While the centre is within w/2 + ρ of the slab's middle plane, they touch: a
/// layer of the thickness w + 2 ρ. To be beyond it at one look and on the near side at the look
/// before, the centre must cover more than that between them. So if it gets no further than w + 2 ρ
/// in a step, one of the looks sees the touch. (A body of a smaller ρ than it has, 0 at the least,
/// makes the bound safe and weaker.)
/// @param body as mover() makes it; the slab is at rest in the frame in which the displacement is
/// measured
/// @param thickness w of the slab, m
/// @param displacement as relative_displacement() or centre_displacement() gives it, m
template <std::floating_point S>
TunnellingBound<S> slab_tunnelling(const Mover<S>& body, S thickness, S displacement) {
  detail::require_not_negative("thickness", thickness);
  detail::require_not_negative("displacement", displacement);
  return {displacement, sum_down(sum_down(thickness, body.inner_radius), body.inner_radius)};
}

/// The same for two bodies that fly at each other: the inner balls touch while the centres are
/// within ρ = ρ_a + ρ_b, and along a line through the middle that is for 2 ρ of the way.
///
/// It proves that no two bodies get from one side of each other to the other along such a line, and
/// along every line that cuts a chord of at least the displacement out of the ball of radius ρ.
/// Shorter chords, at the rim, may be missed: missed_chord() bounds them.
template <std::floating_point S>
TunnellingBound<S> pair_tunnelling(const Mover<S>& a, const Mover<S>& b, S displacement) {
  detail::require_not_negative("displacement", displacement);
  const S core = sum_down(a.inner_radius, b.inner_radius);
  return {displacement, sum_down(core, core)};
}
// [/nothing-passes]

/// What can be missed at the rim.
template <std::floating_point S>
struct MissedChord {
  S length = S(0);  ///< of the longest chord that can be missed, m
  S depth = S(0);   ///< how deep the bodies overlap on it at most, m
  /// The approach that is missed, as a share of the relative speed: the cosine of the angle between
  /// the path and the normal at the touch, at most.
  S approach = S(0);
};

// [missed-chord]
/// The deepest graze that two looks can miss.
///
/// A straight path cuts a chord c out of the ball of radius ρ in which the centres touch. A chord
/// of at least the displacement D has a look on it. So c < D for one that is missed, its sagitta is
/// less than ρ − √(ρ² − D²/4), and where it enters, the normal part of the velocity is less than
/// D / (2 ρ) of the whole. The root cancels for a small D, so the sagitta is written
/// (D²/4) / (ρ + √(ρ² − D²/4)).
/// @param reach ρ, m, finite and greater than 0: for balls the sum of the radii
/// @param displacement D, m, in a step
/// @return upper bounds; with D ≥ 2 ρ, to rounding, everything can be missed: 2 ρ, ρ and 1
/// @throws std::invalid_argument if an argument is not as said
template <std::floating_point S>
MissedChord<S> missed_chord(S reach, S displacement) {
  detail::require_not_negative("displacement", displacement);
  require_finite("reach", reach);
  if (!(reach > S(0))) throw_invalid_argument("reach", number_text(reach), "must exceed 0");
  // Rounded upwards first: the depth grows with the ratio, and 1 − ratio is then exact or nearly
  // so.
  const S ratio = detail::a_little_more(displacement / reach / S(2));
  if (!(ratio < S(1))) return {S(2) * reach, reach, S(1)};
  const S rest = std::sqrt((S(1) - ratio) * (S(1) + ratio));
  const S depth = detail::a_little_more(reach * (ratio * ratio / (S(1) + rest)));
  return {displacement, depth < reach ? depth : reach, ratio};
}
// [/missed-chord]

// [energy-speed]
/// The greatest speed that energy allows: √(2 (E − U) / m), rounded upwards.
///
/// Where forces have a potential that is never below U, and nothing adds energy, kinetic energy
/// never exceeds E − U.
/// @param energy E, kinetic and potential together, J, finite
/// @param least_potential U, J, finite
/// @param mass m, kg, finite and greater than 0
/// @return m/s; 0 if E ≤ U
/// @throws std::invalid_argument if an argument is not as said
template <std::floating_point S>
S energy_speed(S energy, S least_potential, S mass) {
  require_finite("energy", energy);
  require_finite("least_potential", least_potential);
  require_finite("mass", mass);
  if (!(mass > S(0))) throw_invalid_argument("mass", number_text(mass), "must exceed 0");
  const S kinetic = sum_up(energy, -least_potential);
  if (!(kinetic > S(0))) return S(0);
  return detail::a_little_more(std::sqrt(detail::a_little_more(kinetic / mass * S(2))));
}
// [/energy-speed]

}  // namespace contact
