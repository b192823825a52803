/// @file
/// Capsules: plain data, construction, pose and bounding box.
#pragma once

#include <concepts>

#include <contact/aabb.hpp>
#include <contact/coordinate_range.hpp>
#include <contact/frame.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A capsule: all points at most radius from a segment. Equal ends make it a sphere.
template <Ring S>
struct Capsule {
  Segment<S> core;  ///< m
  S radius = S(0);  ///< m, not negative
};

/// A capsule from input.
/// @param start, end of the segment, m; they may be equal
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
Capsule<S> capsule_from_segment(const Vector3<S>& start, const Vector3<S>& end, const S& radius) {
  detail::require_position("start", start);
  detail::require_position("end", end);
  detail::require_extent("radius", radius, false);
  return {{start, end}, radius};
}

/// The capsule whose core is centred at the origin of a frame and lies on its z axis.
///
/// Nothing is checked.
/// @param half_length half the length of the core without the caps, m, not negative
/// @param radius m, not negative
/// @return with ends that are off by at most γ(2) of the sum of the absolute values of their terms
template <Ring S>
Capsule<S> capsule_along_z(const CoordinateFrame<S>& frame, const S& half_length, const S& radius) {
  const Vector3<S> half_core = Vector3<S>(frame.axes.col(2)) * half_length;
  return {{Vector3<S>(frame.origin - half_core), Vector3<S>(frame.origin + half_core)}, radius};
}

/// A sphere as a capsule with a segment of length 0.
template <Ring S>
Capsule<S> as_capsule(const Sphere<S>& sphere) {
  return {{sphere.centre, sphere.centre}, sphere.radius};
}

/// World coordinates of a capsule given in the frame.
/// @return its ends are off as position_in_world() is
template <Ring S>
Capsule<S> transformed(const Capsule<S>& shape, const CoordinateFrame<S>& frame) {
  return {transformed(shape.core, frame), shape.radius};
}

/// The smallest box of representable numbers that contains a capsule: the boxes of the spheres
/// about the ends of its core, rounded outwards.
/// @param capsule m, finite, with a radius that is not negative
/// @throws std::invalid_argument if the capsule does not satisfy this, or its box overflows
template <std::floating_point S>
Aabb<S> aabb_of_capsule(const Capsule<S>& capsule) {
  return enclosing_box(aabb_of_sphere<S>({capsule.core.start, capsule.radius}),
                       aabb_of_sphere<S>({capsule.core.end, capsule.radius}));
}

}  // namespace contact
