/// @file
/// The convex bodies of this chapter: spheres, capsules, oriented boxes, and half-spaces, which are
/// defined here.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/capsule.hpp>
#include <contact/coordinate_range.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A half-space: all points with n · x ≤ k. The normal points out of the body.
template <Ring S>
struct HalfSpace {
  Plane<S> boundary;  ///< offset in m
};

/// A sphere from input.
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
Sphere<S> sphere_from_radius(const Vector3<S>& centre, const S& radius) {
  detail::require_position("centre", centre);
  detail::require_extent("radius", radius, false);
  return {centre, radius};
}

/// A half-space from its boundary plane.
/// @throws std::invalid_argument if the normal's length is not 1 to within 8 u, or the offset is
/// not finite or out of range
template <std::floating_point S>
HalfSpace<S> half_space_behind(const Plane<S>& boundary) {
  require_finite("normal", boundary.normal);
  detail::require_extent("offset", S(std::abs(boundary.offset)), false);
  const S off = boundary.normal.dot(boundary.normal) - S(1);
  if (!(std::abs(off) <= S(8) * std::numeric_limits<S>::epsilon())) {
    throw_invalid_argument("normal", vector_text(boundary.normal), "must have length 1");
  }
  return {boundary};
}

}  // namespace contact
