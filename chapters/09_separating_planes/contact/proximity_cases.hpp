/// @file
/// How two convex bodies can lie to each other.
#pragma once

#include <cmath>

#include <contact/capsule.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [proximity]
/// How two convex bodies lie to each other.
enum class Proximity {
  disjoint,     ///< they have no common point: a plane separates them strictly
  touching,     ///< they have common points, and a plane has A on one side and B on the other
  overlapping,  ///< no plane separates them, not even one that both touch
  undecided  ///< neither was proved: only for cylinders and ellipsoids, with bounds of the distance
};
// [/proximity]

namespace detail {

/// The case that the sign of a signed distance stands for.
inline Proximity proximity_of_sign(int sign) {
  if (sign == 0) return Proximity::touching;
  return sign > 0 ? Proximity::disjoint : Proximity::overlapping;
}

/// Whether all numbers of a body are finite. Nothing is decided about others.
inline bool is_finite_body(const Sphere<double>& s) {
  return all_finite(s.centre) && std::isfinite(s.radius);
}
inline bool is_finite_body(const Capsule<double>& c) {
  return all_finite(c.core.start) && all_finite(c.core.end) && std::isfinite(c.radius);
}
inline bool is_finite_body(const OrientedBox<double>& box) {
  return all_finite(box.centre) && all_finite(box.axes) && all_finite(box.half_lengths);
}
inline bool is_finite_body(const HalfSpace<double>& h) {
  return all_finite(h.boundary.normal) && std::isfinite(h.boundary.offset);
}

}  // namespace detail

}  // namespace contact
