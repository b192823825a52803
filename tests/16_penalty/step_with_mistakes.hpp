/// @file
/// A step of a contact spring and its stability limit with one mistake that people make: what the
/// test of the exercise recognises.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "largest_step.hpp"

namespace step_with_mistakes {

using exercise::State;

/// What is done wrong in a step.
enum class Way {
  old_velocity,    ///< the penetration changes with the old velocity
  position_first,  ///< the penetration changes first, and the force is that of the new one
  no_damper,       ///< the damper is left out
  damper_drives,   ///< it has the wrong sign
  spring_drives,   ///< the spring has the wrong sign
  no_mass,         ///< the mass is left out
  new_damper,      ///< the damping force of the new velocity
  all_new,         ///< spring and damping force of the new state
  lets_go,         ///< no pull
  only_contact,    ///< no force across a gap
};

inline State after_step(const State& now, double k, double c, double m, double h, Way way) {
  const double d =
      way == Way::position_first ? now.penetration + h * now.approach : now.penetration;
  if (way == Way::no_damper) c = 0;
  if (way == Way::damper_drives) c = -c;
  if (way == Way::spring_drives) k = -k;
  if (way == Way::no_mass) m = 1;
  double force = k * d + c * now.approach;
  if (way == Way::lets_go) force = std::max(force, 0.0);
  if (way == Way::only_contact && d < 0) force = 0;
  double approach = now.approach - h * force / m;
  if (way == Way::new_damper) approach = (now.approach - h * k * d / m) / (1 + h * c / m);
  if (way == Way::all_new) {
    approach = (now.approach - h * k * d / m) / (1 + h * c / m + h * h * k / m);
  }
  if (way == Way::position_first) return {d, approach};
  return {d + h * (way == Way::old_velocity ? now.approach : approach), approach};
}

/// What is done wrong with the limit.
enum class LimitWay {
  undamped,        ///< 2 √(m / k)
  half,            ///< half of the limit
  frequency,       ///< 2 √(k / m) without a damper
  explicit_euler,  ///< the limit of explicit Euler
  new_damper,      ///< that of an implicit damper
  period,          ///< the period of the oscillation
  damper_alone,    ///< 2 m / c
  smaller,         ///< the smaller of two limits
  difference,      ///< (−c + √(c² + 4 k m)) / k
  energy,          ///< h² k + h c = 4 m
};

inline double limit(double k, double c, double m, LimitWay way) {
  const double right = 4 * m / (c + std::sqrt(c * c + 4 * k * m));
  const double undamped = 2 * std::sqrt(m / k);
  switch (way) {
    case LimitWay::undamped:
      return undamped;
    case LimitWay::half:
      return right / 2;
    case LimitWay::frequency:
      return 2 * std::sqrt(k / m);
    case LimitWay::explicit_euler:
      return c * c <= 4 * k * m ? c / k : 4 * m / (c + std::sqrt(c * c - 4 * k * m));
    case LimitWay::new_damper:
      return (c + std::sqrt(c * c + 4 * k * m)) / k;
    case LimitWay::period:
      return 2 * std::numbers::pi * std::sqrt(m / k);
    case LimitWay::damper_alone:
      return 2 * m / c;
    case LimitWay::smaller:
      return std::min(undamped, 2 * m / c);
    case LimitWay::difference:
      return (std::sqrt(c * c + 4 * k * m) - c) / k;
    case LimitWay::energy:
      return 8 * m / (c + std::sqrt(c * c + 16 * k * m));
  }
  return right;
}

}  // namespace step_with_mistakes
