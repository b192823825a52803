/// @file
/// The damper for a restitution with one mistake that people make: what the test of the exercise
/// recognises.
#pragma once

#include <cmath>
#include <numbers>

#include <contact/spring_impact.hpp>

#include "damping_for_restitution.hpp"

namespace damping_with_mistakes {

/// What is done wrong if the contact ends at zero penetration.
enum class Way {
  none,
  common_logarithm,  ///< to the base 10
  small_damping,     ///< L / π, as for √(1 − ζ²) = 1
  whole_period,      ///< 2 π instead of π
  squared,           ///< e² instead of e
  linear,            ///< ζ = 1 − e
  negative,          ///< ln e instead of −ln e
  ratio_alone,       ///< ζ instead of c
  half,              ///< c = ζ √(k m)
  no_root,           ///< c = 2 ζ k m
  frequency,         ///< c = 2 ζ √(k / m)
  no_mass,           ///< c = 2 ζ √k
  in_the_logarithm,  ///< √(k m) multiplies e instead of the result
};

inline double to_zero_penetration(double e, double k, double m, Way way) {
  double l = way == Way::common_logarithm ? -std::log10(e) : -std::log(e);
  if (way == Way::squared) l *= 2;
  const double pi = way == Way::whole_period ? 2 * std::numbers::pi : std::numbers::pi;
  double ratio = l / std::hypot(pi, l);
  if (way == Way::small_damping) ratio = l / pi;
  if (way == Way::linear) ratio = 1 - e;
  if (way == Way::negative) ratio = -ratio;
  if (way == Way::in_the_logarithm) return -2 * std::log(e * std::sqrt(k * m)) / std::hypot(pi, l);
  if (way == Way::ratio_alone) return ratio;
  if (way == Way::half) return ratio * std::sqrt(k * m);
  if (way == Way::no_root) return 2 * ratio * k * m;
  if (way == Way::frequency) return 2 * ratio * std::sqrt(k / m);
  if (way == Way::no_mass) return 2 * ratio * std::sqrt(k);
  return 2 * ratio * std::sqrt(k * m);
}

/// The ratio ζ for which factor · ζ θ / sin θ is the exponent.
inline double ratio_for(double exponent, double factor) {
  double low = 0;
  double high = 1;
  while (factor * high * contact::arc_over_sine(high) < exponent) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (factor * middle * contact::arc_over_sine(middle) < exponent ? low : high) = middle;
  }
  return high;
}

/// What is done wrong if it ends at zero force.
enum class ForceWay {
  none,
  to_the_depth,      ///< the exponent up to the greatest penetration, half of the contact
  sine_left_out,     ///< exp(−2 ζ)
  common_logarithm,  ///< to the base 10
  ratio_alone,       ///< ζ instead of c
  half,              ///< c = ζ √(k m)
};

inline double to_zero_force(double e, double k, double m, ForceWay way) {
  const double l = way == ForceWay::common_logarithm ? -std::log10(e) : -std::log(e);
  const double ratio =
      way == ForceWay::sine_left_out ? l / 2 : ratio_for(l, way == ForceWay::to_the_depth ? 1 : 2);
  if (way == ForceWay::ratio_alone) return ratio;
  return (way == ForceWay::half ? 1 : 2) * ratio * std::sqrt(k * m);
}

}  // namespace damping_with_mistakes
