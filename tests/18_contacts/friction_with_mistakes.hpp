/// @file
/// The update of a contact with friction with one mistake that people make: what the test of the
/// exercise recognises.
#pragma once

#include <algorithm>
#include <cmath>

#include "friction_clamp.hpp"

namespace friction_with_mistakes {

using exercise::Friction;
using Vector = Eigen::Vector2d;

/// What is done wrong with the normal impulse.
enum class NormalWay {
  change_clamped,   ///< what the visit adds is 0 or more, not the sum
  reversed,         ///< the visit pushes surfaces that separate
  pulls,            ///< the sum may be negative
  forgets,          ///< the old sum is left out
  divided,          ///< velocity over effective mass
  change_returned,  ///< the change in place of the sum
  magnitude,        ///< a negative sum becomes positive
};

inline double normal_sum(double sum, double velocity, double mass, NormalWay way) {
  double change = -velocity * mass;
  if (way == NormalWay::divided) change = -velocity / mass;
  if (way == NormalWay::reversed) change = -change;
  if (way == NormalWay::change_clamped) return sum + std::max(change, 0.0);
  if (way == NormalWay::forgets) return std::max(change, 0.0);
  if (way == NormalWay::pulls) return sum + change;
  if (way == NormalWay::magnitude) return std::abs(sum + change);
  const double after = std::max(sum + change, 0.0);
  return way == NormalWay::change_returned ? after - sum : after;
}

/// What is done wrong with the friction.
enum class Way {
  change_clamped,   ///< what the visit adds is bounded, not the sum
  each_axis,        ///< each component is bounded: a square
  along_slip,       ///< a sum that is too long becomes opposite to the slip
  no_limit,         ///< every slip is stopped
  let_go,           ///< a sum that is too long becomes 0
  mu_alone,         ///< bounded by μ
  normal_alone,     ///< bounded by the normal impulse
  with_slip,        ///< the friction acts along the slip
  forgets,          ///< the old sum is left out
  whole_change,     ///< the change is that without the bound
  sum_applied,      ///< the change is the new sum
  change_reversed,  ///< the change is the old sum minus the new one
  always_longest,   ///< the sum is stretched to the largest length
  sticks_reversed,  ///< whether it slides
  sticks_strict,    ///< on the edge it slides
  sticks_by_slip,   ///< it sticks if there is no slip before the visit
  divided,          ///< slip over effective mass
  square,           ///< the square of the length in place of the length
};

inline Friction friction_after(const Vector& sum, const Vector& slip, double mass, double mu,
                               double normal, Way way) {
  Vector change = -slip * mass;
  if (way == Way::divided) change = -slip / mass;
  if (way == Way::with_slip) change = slip * mass;
  double most = mu * normal;
  if (way == Way::mu_alone) most = mu;
  if (way == Way::normal_alone) most = normal;
  const Vector old = way == Way::forgets ? Vector(0, 0) : sum;
  if (way == Way::change_clamped) {
    const double length = change.norm();
    const bool sticks = length <= most;
    if (!sticks) change *= most / length;
    return {old + change, change, sticks};
  }
  const Vector stopped = old + change;
  if (way == Way::each_axis) {
    const Vector after = stopped.cwiseMax(-most).cwiseMin(most);
    return {after, after - old, after == stopped};
  }
  const double length = way == Way::square ? stopped.squaredNorm() : stopped.norm();
  bool sticks = way == Way::sticks_strict ? length < most : length <= most;
  if (way == Way::no_limit) sticks = true;
  Vector after = stopped;
  if (length > most && !sticks) after = stopped * (most / length);
  if (way == Way::along_slip && !sticks) after = -slip.normalized() * most;
  if (way == Way::let_go && !sticks) after = {0, 0};
  if (way == Way::always_longest) after = stopped * (most / length);
  if (way == Way::sticks_reversed) sticks = !sticks;
  if (way == Way::sticks_by_slip) sticks = slip.isZero(0);
  if (way == Way::whole_change) return {after, change, sticks};
  if (way == Way::sum_applied) return {after, after, sticks};
  if (way == Way::change_reversed) return {after, old - after, sticks};
  return {after, after - old, sticks};
}

}  // namespace friction_with_mistakes
