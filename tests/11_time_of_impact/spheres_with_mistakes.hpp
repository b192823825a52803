/// @file
/// Two moving spheres with one mistake that people make: what the test of the exercise recognises.
#pragma once

#include <cmath>
#include <optional>

#include "moving_spheres.hpp"

namespace spheres_with_mistakes {

using exercise::Contact;
using exercise::MovingSphere;
using Vector = Eigen::Vector3d;

/// What is done wrong.
struct Ways {
  bool later_root = false;       ///< they would separate then
  bool other_at_rest = false;    ///< only a moves
  bool added = false;            ///< displacements are added
  bool one_radius = false;       ///< that of b is left out
  bool start_missed = false;     ///< a contact at the start is not found
  bool leaving_missed = false;   ///< nor one that they leave at once
  bool exit_at_start = false;    ///< spheres that overlap touch when they separate
  bool graze_missed = false;     ///< a double root is none
  bool cancelled_root = false;   ///< the root is a difference
  bool cancelled_depth = false;  ///< so is what is under it
  bool closest = false;          ///< they touch where they are closest
  bool away = false;             ///< a touch in the past counts
  bool too_late = false;         ///< t may be above 1
  bool end_missed = false;       ///< t is below 1
  bool middle = false;           ///< the point is in the middle between the centres
  bool other_ratio = false;      ///< it is as far from a as the radius of b
  bool before = false;           ///< it is that of the centres at the start
  bool b_before = false;         ///< only that of b
};

inline Contact contact_at(const MovingSphere& a, const MovingSphere& b, double t,
                          const Ways& ways) {
  const double of_point = ways.before ? 0 : t;
  const Vector of_a = a.centre + of_point * a.displacement;
  const Vector of_b = b.centre + (ways.b_before ? 0 : of_point) * b.displacement;
  double share = a.radius / (a.radius + b.radius);
  if (ways.middle) share = 0.5;
  if (ways.other_ratio) share = b.radius / (a.radius + b.radius);
  return {t, of_a + share * (of_b - of_a)};
}

inline std::optional<Contact> meet(const MovingSphere& a, const MovingSphere& b, const Ways& ways) {
  const Vector d = a.centre - b.centre;
  Vector w = a.displacement - b.displacement;
  if (ways.other_at_rest) w = a.displacement;
  if (ways.added) w = a.displacement + b.displacement;
  double radius_sum = a.radius + b.radius;
  if (ways.one_radius) radius_sum = a.radius;
  const double gap = d.squaredNorm() - radius_sum * radius_sum;
  const double approach = -d.dot(w);
  const double square = w.squaredNorm();
  const double across = d.cross(w).squaredNorm();
  double depth = radius_sum * radius_sum * square - across;
  if (ways.cancelled_depth) depth = approach * approach - square * gap;
  if (gap <= 0) {
    if (ways.start_missed || (ways.leaving_missed && approach <= 0)) return std::nullopt;
    if (!ways.exit_at_start) return contact_at(a, b, 0, ways);
  } else if (!(approach > 0) && !ways.away) {
    return std::nullopt;
  }
  if (square == 0 || depth < 0 || (ways.graze_missed && depth == 0)) return std::nullopt;
  double t = gap / (approach + std::sqrt(depth));
  if (ways.cancelled_root) t = (approach - std::sqrt(depth)) / square;
  if (ways.later_root || ways.exit_at_start) t = (approach + std::sqrt(depth)) / square;
  if (ways.away && approach < 0) t = (approach - std::sqrt(depth)) / square;
  if (ways.closest) t = approach / square;
  if ((t > 1 && !ways.too_late) || (ways.end_missed && t == 1)) return std::nullopt;
  return contact_at(a, b, t, ways);
}

}  // namespace spheres_with_mistakes
