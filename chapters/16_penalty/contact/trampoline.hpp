/// @file
/// A jump on a trampoline: a fall, more than half a period on a spring under gravity, and a flight.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/invalid_argument.hpp>
#include <contact/momentum.hpp>
#include <contact/spring_damper.hpp>
#include <contact/spring_impact.hpp>

namespace contact {

/// A jump on an undamped spring. Make it with trampoline(), which checks its arguments.
template <Ring S>
struct Trampoline {
  S mass = S(1);       ///< of the jumper, kg, greater than 0
  S stiffness = S(1);  ///< N/m, greater than 0
  S gravity = S(1);    ///< m/s², greater than 0
  S height = S(0);     ///< initial height above the mat at rest, m, 0 or more
};

/// A jump on a trampoline.
/// @param mass kg, greater than 0
/// @param stiffness N/m, greater than 0
/// @param gravity m/s², greater than 0
/// @param height m, 0 or more
/// @throws std::invalid_argument if a number is out of its range or not finite
template <Ring S>
Trampoline<S> trampoline(const S& mass, const S& stiffness, const S& gravity, const S& height) {
  require_mass("mass", mass);
  spring_damper(stiffness, S(0));
  require_finite("gravity", gravity);
  require_finite("height", height);
  if (!(gravity > S(0))) {
    throw_invalid_argument("gravity", number_text(gravity), "must be greater than 0");
  }
  if (height < S(0)) throw_invalid_argument("height", number_text(height), "must not be negative");
  return {mass, stiffness, gravity, height};
}

/// The results of a jump, which repeats without loss.
template <std::floating_point S>
struct TrampolineJump {
  S sag = S(0);           ///< deflection of the mat with the jumper at rest on it, m g / k, m
  S max_depth = S(0);     ///< of the mat, m
  S max_force = S(0);     ///< of the mat, N
  S contact_time = S(0);  ///< on the mat, s
  S air_time = S(0);      ///< from mat to mat, s
};

// [trampoline]
/// A jump on a trampoline in closed form. With the sag s = m g / k and the height H:
///
/// - Conservation of energy gives the depth: s + √(s² + 2 s H). A jump from height 0 is twice as
/// deep
///   as the sag.
/// - The contact lasts 2 (π − β) / ω₀ with tan β = ω₀ v / g, that is cos² β = s / (s + 2 H): π / ω₀
///   for a stiff mat, 2 π / ω₀ from height 0.
/// - The air time is 2 √(2 H / g).
/// @return each with a relative error of at most 40 u, without overflow and underflow
template <std::floating_point S>
TrampolineJump<S> trampoline_jump(const Trampoline<S>& t) {
  const SpringDamper<S> spring{t.stiffness, S(0)};
  TrampolineJump<S> result;
  result.sag = t.mass * t.gravity / t.stiffness;
  const S whole = result.sag + S(2) * t.height;
  result.max_depth = result.sag + std::sqrt(result.sag) * std::sqrt(whole);
  result.max_force = t.stiffness * result.max_depth;
  const S cosine = std::sqrt(result.sag / whole);
  const S sine = std::sqrt(S(2) * t.height / whole);
  const S turned = S(detail::pi) - sine * arc_over_sine(cosine);
  result.contact_time = S(2) * turned / natural_frequency(spring, t.mass);
  result.air_time = S(2) * std::sqrt(S(2) * t.height / t.gravity);
  return result;
}
// [/trampoline]

}  // namespace contact
