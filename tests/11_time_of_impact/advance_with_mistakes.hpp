/// @file
/// A rod that turns towards a disc, with one mistake that people make: what the test of the
/// exercise recognises.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "advance_safely.hpp"

namespace advance_with_mistakes {

using exercise::Advance;
using exercise::Disc;
using exercise::Rod;
using Vector = Eigen::Vector2d;

/// What is done wrong.
struct Ways {
  bool line = false;             ///< the rod goes on beyond its ends
  bool ends_alone = false;       ///< only the ends of the rod count
  bool centre_alone = false;     ///< only its centre counts
  bool no_radius = false;        ///< the disc is its centre
  bool not_turned = false;       ///< the angle does not change
  bool clockwise = false;        ///< it changes in the other direction
  bool degrees = false;          ///< it is in degrees
  bool not_moved = false;        ///< the centre does not move
  bool no_rotation = false;      ///< the bound has no rotation
  bool rotation_alone = false;   ///< the bound has nothing else
  bool signed_rotation = false;  ///< the rotation counts with its sign
  bool whole_length = false;     ///< the rotation of the whole length
  bool pythagoras = false;       ///< the two speeds are taken to be perpendicular
  bool squared = false;          ///< the square of the speed of the centre
  bool past_the_end = false;     ///< the last time is that of the advance
  bool end_touches = false;      ///< the end counts as a contact
  bool keeps_tolerance = false;  ///< each advance leaves half of the tolerance
  bool times_of_steps = false;   ///< durations of steps instead of times
};

inline double distance_at(const Rod& rod, const Disc& disc, double t, const Ways& ways) {
  const double unit = ways.degrees ? std::numbers::pi / 180 : 1;
  double turn = ways.not_turned ? 0 : rod.angular_velocity * t;
  if (ways.clockwise) turn = -turn;
  const double angle = unit * (rod.angle + turn);
  const Vector along(std::cos(angle), std::sin(angle));
  const Vector centre = rod.centre + (ways.not_moved ? 0 : t) * rod.velocity;
  const Vector to_disc = disc.centre - centre;
  const double l = rod.half_length;
  double nearest = to_disc.dot(along);
  if (ways.ends_alone) nearest = nearest < 0 ? -l : l;
  if (ways.centre_alone) nearest = 0;
  if (!ways.line) nearest = std::clamp(nearest, -l, l);
  return (to_disc - nearest * along).norm() - (ways.no_radius ? 0 : disc.radius);
}

inline double speed_bound(const Rod& rod, const Ways& ways) {
  const double centre = ways.squared ? rod.velocity.squaredNorm() : rod.velocity.norm();
  double end = std::abs(rod.angular_velocity) * rod.half_length;
  if (ways.signed_rotation) end = rod.angular_velocity * rod.half_length;
  if (ways.whole_length) end *= 2;
  if (ways.no_rotation) return centre;
  if (ways.rotation_alone) return end;
  if (ways.pythagoras) return std::sqrt(centre * centre + end * end);
  return centre + end;
}

inline Advance advance_safely(const Rod& rod, const Disc& disc, double duration, double tolerance,
                              const Ways& ways) {
  const double bound = speed_bound(rod, ways);
  Advance advance{{}, false};
  double t = 0;
  for (int k = 0; k < 10'000; ++k) {
    const double distance = distance_at(rod, disc, t, ways);
    advance.times.push_back(t);
    advance.touches = distance <= tolerance || (ways.end_touches && t >= duration);
    if (advance.touches || t >= duration) break;
    t += (ways.keeps_tolerance ? distance - tolerance / 2 : distance) / bound;
    if (!ways.past_the_end) t = std::min(t, duration);
  }
  if (ways.times_of_steps) {
    std::adjacent_difference(advance.times.begin(), advance.times.end(), advance.times.begin());
  }
  return advance;
}

}  // namespace advance_with_mistakes
