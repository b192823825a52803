/// @file
/// Exercise: advance a turning rod towards a disc, and never past their first contact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A thin rod in the plane: a segment.
struct Rod {
  Eigen::Vector2d centre;    ///< at time 0, m
  double half_length;        ///< m, greater than 0
  double angle;              ///< of the rod with the x axis at time 0, rad
  Eigen::Vector2d velocity;  ///< of its centre, constant, m/s
  double angular_velocity;   ///< about its centre, counterclockwise, constant, rad/s
};

/// A disc at rest.
struct Disc {
  Eigen::Vector2d centre;  ///< m
  double radius;           ///< m, 0 or more
};

/// The distance of the rod at a time from the disc, m: from the point of the rod nearest to the
/// centre of the disc to that centre, less the radius. It is negative if the rod is in the disc.
///
/// @param t s, 0 or more
double distance_at(const Rod& rod, const Disc& disc, double t);

/// The speed that no point of the rod exceeds and that one of its ends may reach: the speed of the
/// centre plus that of an end about the centre. m/s
double speed_bound(const Rod& rod);

/// The times at which the distance was computed.
struct Advance {
  std::vector<double> times;  ///< s, increasing; the first one is 0
  bool touches;               ///< whether the distance at the last time is at most the tolerance
};

/// Advances the time until the distance is at most the tolerance, or until the end.
///
/// From one time to the next it advances by the time that a point at the speed bound needs for the
/// distance, so it never passes a contact. If that is past the end, or if no point moves, the next
/// time is the duration, and the last one. No time is listed twice. Times may be off by 10⁻⁹ s.
///
/// @param duration s, 0 or more
/// @param tolerance m, greater than 0
Advance advance_safely(const Rod& rod, const Disc& disc, double duration, double tolerance);

}  // namespace exercise
