/// @file
/// The stiffness for an overlap and the step for a contact with one mistake that people make: what
/// the test of the exercise recognises.
#pragma once

#include <cmath>
#include <numbers>

#include "stiffness_for_overlap.hpp"

namespace overlap_with_mistakes {

/// What is done wrong with the stiffness.
enum class Way {
  fall_alone,    ///< gravity does no work during the contact
  no_half,       ///< the spring holds k d²
  weight_alone,  ///< the overlap at rest
  twice_weight,  ///< as if released at the surface
  weight_once,   ///< the overlap of the fall and the one at rest, added
  not_squared,   ///< d instead of d²
  from_the_top,  ///< the height minus the overlap
  no_mass,       ///< the mass is left out
  speed_once,    ///< v instead of v²
};

inline double stiffness(double m, double height, double g, double d, Way way) {
  switch (way) {
    case Way::fall_alone:
      return 2 * m * g * height / (d * d);
    case Way::no_half:
      return m * g * (height + d) / (d * d);
    case Way::weight_alone:
      return m * g / d;
    case Way::twice_weight:
      return 2 * m * g / d;
    case Way::weight_once:
      return 2 * m * g * height / (d * d) + m * g / d;
    case Way::not_squared:
      return 2 * m * g * (height + d) / d;
    case Way::from_the_top:
      return 2 * m * g * (height - d) / (d * d);
    case Way::no_mass:
      return 2 * g * (height + d) / (d * d);
    case Way::speed_once:
      return m * (std::sqrt(2 * g * height) + 2 * g * d) / (d * d);
  }
  return 0;
}

/// What is done wrong with the step.
enum class StepWay {
  half_period,   ///< the contact without gravity
  whole_period,  ///< the period of the oscillation
  to_the_depth,  ///< half of the contact
  above_rest,    ///< the rest of the period
  cycles,        ///< ω in cycles instead of radians
  exchanged,     ///< ω = √(m / k)
  no_root,       ///< v = 2 g h
  not_divided,   ///< the whole contact
  one_more,      ///< so many points in time
  one_less,      ///< one step more than asked for
};

inline double step(double m, double height, double g, double k, int steps, StepWay way) {
  double w = way == StepWay::exchanged ? std::sqrt(m / k) : std::sqrt(k / m);
  if (way == StepWay::cycles) w /= 2 * std::numbers::pi;
  const double square = 2 * g * height;
  const double speed = way == StepWay::no_root ? square : std::sqrt(square);
  const double above = std::atan2(w * speed, g);
  double contact = 2 * (std::numbers::pi - above) / w;
  if (way == StepWay::half_period) contact = std::numbers::pi / w;
  if (way == StepWay::whole_period) contact = 2 * std::numbers::pi / w;
  if (way == StepWay::to_the_depth) contact /= 2;
  if (way == StepWay::above_rest) contact = 2 * above / w;
  if (way == StepWay::not_divided) return contact;
  if (way == StepWay::one_more) return contact / (steps - 1);
  if (way == StepWay::one_less) return contact / (steps + 1);
  return contact / steps;
}

}  // namespace overlap_with_mistakes
