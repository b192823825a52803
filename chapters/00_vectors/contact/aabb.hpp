/// @file
/// Axis-aligned bounding boxes that are certain to enclose their contents, compared without
/// rounding.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>

#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [aabb]
/// An axis-aligned bounding box: all x with low ≤ x ≤ high in each coordinate, faces included.
///
/// A box may be flat or a point. One with low > high or with an entry that is not finite is an
/// error of the program, not of its input: make boxes with the functions below, which check.
template <Ring S>
struct Aabb {
  Vector3<S> low = Vector3<S>::Zero();   ///< the corner with the smallest coordinates, m
  Vector3<S> high = Vector3<S>::Zero();  ///< the corner with the largest coordinates, m
};

/// Whether two boxes have a point in common. Touching counts. Nothing is rounded: the result is
/// exact for the stored numbers.
template <Ring S>
bool boxes_touch(const Aabb<S>& a, const Aabb<S>& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.high(k) < b.low(k) || b.high(k) < a.low(k)) return false;
  }
  return true;
}
// [/aabb]

/// The smallest box that contains both boxes. Nothing is rounded.
template <Ring S>
Aabb<S> enclosing_box(const Aabb<S>& a, const Aabb<S>& b) {
  Aabb<S> both = a;
  for (int k = 0; k < 3; ++k) {
    if (b.low(k) < a.low(k)) both.low(k) = b.low(k);
    if (a.high(k) < b.high(k)) both.high(k) = b.high(k);
  }
  return both;
}

/// The box with the given corners.
/// @param low, high m, finite
/// @throws std::invalid_argument if an entry is not finite, or if low > high in a coordinate
template <std::floating_point S>
Aabb<S> aabb_from_corners(const Vector3<S>& low, const Vector3<S>& high) {
  require_finite("low", low);
  require_finite("high", high);
  for (int k = 0; k < 3; ++k) {
    if (low(k) > high(k)) {
      throw_invalid_argument("low", vector_text(low),
                             "no coordinate may exceed that of high = " + vector_text(high));
    }
  }
  return {low, high};
}

/// The smallest box that contains all points. Nothing is rounded.
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if there is no point, or an entry is not finite
template <std::floating_point S>
Aabb<S> aabb_of_points(std::span<const Vector3<S>> points) {
  if (points.empty()) throw_invalid_argument("points", "{}", "a box needs at least one point");
  Aabb<S> box{points.front(), points.front()};
  for (const Vector3<S>& point : points) {
    require_finite("points", point);
    box = enclosing_box(box, Aabb<S>{point, point});
  }
  return box;
}

namespace detail {

/// Throws unless the sphere has a finite centre and a finite radius that is not negative.
template <std::floating_point S>
void require_sphere(const Sphere<S>& sphere) {
  require_finite("centre", sphere.centre);
  require_finite("radius", sphere.radius);
  if (sphere.radius < S(0)) {
    throw_invalid_argument("radius", number_text(sphere.radius), "must not be negative");
  }
}

/// Throws if rounding a box outwards has overflowed.
template <std::floating_point S>
Aabb<S> require_in_range(const char* argument, const Vector3<S>& value, const Aabb<S>& box) {
  if (!all_finite(box.low) || !all_finite(box.high)) {
    throw_invalid_argument(argument, vector_text(value), "its box overflows");
  }
  return box;
}

/// The box of all positions of a box that moves by the displacement, with a margin on all sides;
/// each sum is rounded outwards.
template <std::floating_point S>
Aabb<S> swept_outwards(const Aabb<S>& box, const Vector3<S>& displacement, S margin) {
  Aabb<S> swept;
  for (int k = 0; k < 3; ++k) {
    const S back = std::min(displacement(k), S(0));
    const S forth = std::max(displacement(k), S(0));
    const S low = sum_down(box.low(k), back);
    const S high = sum_up(box.high(k), forth);
    swept.low(k) = std::isfinite(low) ? sum_down(low, -margin) : low;
    swept.high(k) = std::isfinite(high) ? sum_up(high, margin) : high;
  }
  return swept;
}

}  // namespace detail

// [aabb-of-sphere]
/// The smallest box of representable numbers that contains a sphere: centre ± radius, each rounded
/// outwards.
///
/// Rounded to nearest, a face could lie inside the sphere, and a touch would be missed.
/// @param sphere m, finite, with a radius that is not negative
/// @throws std::invalid_argument if the sphere does not satisfy this, or its box overflows
template <std::floating_point S>
Aabb<S> aabb_of_sphere(const Sphere<S>& sphere) {
  detail::require_sphere(sphere);
  const Aabb<S> centre{sphere.centre, sphere.centre};
  return detail::require_in_range(
      "centre", sphere.centre,
      detail::swept_outwards<S>(centre, Vector3<S>::Zero(), sphere.radius));
}

/// A box that contains a sphere throughout a straight displacement.
///
/// In each coordinate the extremes are at an end of the path. Two sums are rounded outwards, so a
/// face is at most two ulps from the tightest one: the first of them an ulp of the magnitude of
/// centre + displacement.
/// @param sphere at the start, m, finite, with a radius that is not negative
/// @param displacement of its centre, m, finite
/// @throws std::invalid_argument if an argument does not satisfy these conditions, or the box
/// overflows
template <std::floating_point S>
Aabb<S> aabb_of_swept_sphere(const Sphere<S>& sphere, const Vector3<S>& displacement) {
  detail::require_sphere(sphere);
  require_finite("displacement", displacement);
  const Aabb<S> centre{sphere.centre, sphere.centre};
  return detail::require_in_range("displacement", displacement,
                                  detail::swept_outwards<S>(centre, displacement, sphere.radius));
}

/// A box that contains another throughout a straight displacement, with a margin on all sides.
/// @param box m, made by the functions of this file
/// @param displacement m, finite
/// @param margin m, not negative: the largest deviation of anything in the box from the straight
/// path
/// @throws std::invalid_argument if an argument does not satisfy these conditions, or the result
/// overflows
template <std::floating_point S>
Aabb<S> aabb_of_swept_box(const Aabb<S>& box, const Vector3<S>& displacement, S margin = S(0)) {
  require_finite("displacement", displacement);
  require_finite("margin", margin);
  if (margin < S(0)) throw_invalid_argument("margin", number_text(margin), "must not be negative");
  return detail::require_in_range("displacement", displacement,
                                  detail::swept_outwards<S>(box, displacement, margin));
}
// [/aabb-of-sphere]

}  // namespace contact
