/// @file
/// A moving sphere and a moving plane with one mistake that people make: what the test of the
/// exercise recognises.
#pragma once

#include <cmath>
#include <optional>

#include "offset_plane.hpp"

namespace offset_with_mistakes {

using exercise::Contact;
using Plane = contact::Plane<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;

/// What is done wrong.
struct Ways {
  bool one_side = false;         ///< the plane is always offset to its front
  bool start_missed = false;     ///< a contact at the start is not found
  bool leaving_missed = false;   ///< nor one that they leave at once
  bool centre = false;           ///< the centre is the contact point
  bool as_point = false;         ///< the radius is 0
  bool away = false;             ///< the closing distance has no sign
  bool product = false;          ///< signs are compared by a product, which may underflow
  bool at_rest = false;          ///< the plane does not move
  bool added = false;            ///< it moves the other way
  bool old_plane = false;        ///< the contact point is on the plane as it was
  bool opposite = false;         ///< it is on the other side of the sphere
  bool opposite_behind = false;  ///< but only for a sphere behind the plane
  bool before = false;           ///< it is below the centre as it was
  bool end_missed = false;       ///< t is below 1
  bool too_late = false;         ///< t may be above 1
};

inline std::optional<Contact> meets(const Sphere& sphere, const Vector& displacement,
                                    const Plane& plane, double rise, const Ways& ways) {
  const Vector& n = plane.normal;
  const double distance = n.dot(sphere.centre) - plane.offset;
  const double radius = ways.as_point ? 0 : sphere.radius;
  const double side = distance < 0 && !ways.one_side ? -1 : 1;
  if (ways.at_rest) rise = 0;
  if (ways.added) rise = -rise;
  const double gap = side * distance - radius;
  double closing = -side * (n.dot(displacement) - rise);
  if (gap <= 0 && !ways.one_side) {
    const bool leaves = ways.leaving_missed && closing <= 0;
    if (leaves || ways.start_missed) return std::nullopt;
    return Contact{0, ways.centre ? sphere.centre : Vector(sphere.centre - distance * n)};
  }
  if (ways.product && gap * closing == 0) return std::nullopt;
  if (ways.away) closing = std::abs(closing);
  const double t = gap / closing;
  if (!(t >= 0) || !(t <= 1 || ways.too_late) || (ways.end_missed && t == 1)) return std::nullopt;
  if (std::isinf(t)) return std::nullopt;
  const Vector centre = sphere.centre + t * displacement;
  if (ways.centre) return Contact{t, centre};
  if (ways.old_plane) return Contact{t, centre - (side * radius + t * rise) * n};
  if (ways.before) return Contact{t, sphere.centre - distance * n};
  if (ways.opposite) return Contact{t, centre + side * radius * n};
  if (ways.opposite_behind) return Contact{t, centre - radius * n};
  return Contact{t, centre - side * radius * n};
}

}  // namespace offset_with_mistakes
