/// @file
/// Bounding volumes carried along with their object: the image of all that is in a volume, under
/// the frame as it is stored, is in the result.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include <contact/aabb.hpp>
#include <contact/carried_slabs.hpp>
#include <contact/exact_outward.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/oriented_box.hpp>
#include <contact/outward.hpp>
#include <contact/shapes.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

inline constexpr double carry_u = tolerance::unit_roundoff<double>;
inline constexpr double carry_floor = 4 * tolerance::underflow_unit<double>;

/// The largest row sum of |AᵀA − shift I|, an upper bound: three roundings of each entry and three
/// of the sum are off by at most γ(6) times the largest of the rows of |A|ᵀ|A|, at most three times
/// the largest diagonal entry.
inline double row_sum(const Matrix3<double>& axes, double shift) {
  const Matrix3<double> products = axes.transpose() * axes;
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    double sum = std::abs(products(i, i) - shift);
    for (int j = 0; j < 3; ++j) sum += i == j ? 0.0 : std::abs(products(i, j));
    if (!(sum <= largest)) largest = sum;  // NaN stays
  }
  const double diagonal = products.diagonal().maxCoeff();
  return largest + 16 * carry_u * (diagonal + std::abs(shift)) + 0x1p-1000;
}

}  // namespace detail

// [stretch]
/// An upper bound on the factor by which stored axes lengthen a vector: their spectral norm, at
/// most the root of the largest row sum of |AᵀA|.
///
/// Rounded axes are no rotation: they lengthen some vectors by a few u of their type. The columns
/// may all be shorter than 1 and still lengthen a diagonal.
/// @return about 2^-500 of axes that are 0; ∞ if squares overflow (beyond 1e154); ∞ or NaN if an
/// entry is not finite
template <FloatOrDouble S>
double stretch_of(const Matrix3<S>& axes) {
  return std::sqrt(detail::row_sum(axes.template cast<double>(), 0)) * (1 + 4 * detail::carry_u);
}
// [/stretch]

namespace detail {

/// A point as stored, and a bound on the distance from the exact one, m.
template <FloatOrDouble S>
struct Carried {
  Vector3<S> point = Vector3<S>::Zero();
  double error = 0;
};

/// The position of p in the world: four roundings, so a coordinate is off by at most γ(4) times the
/// sum of the magnitudes of its terms; a float is one more rounding off, whose error is computed.
template <FloatOrDouble S>
Carried<S> carried_point(const CoordinateFrame<S>& frame, const Vector3<double>& p) {
  Carried<S> result;
  for (int k = 0; k < 3; ++k) {
    double value = 0, magnitude = 0;
    for (int j = 0; j < 3; ++j) {
      const double term = static_cast<double>(frame.axes(k, j)) * p[j];
      value += term;
      magnitude += std::abs(term);
    }
    const double origin = static_cast<double>(frame.origin[k]);
    value += origin;
    magnitude += std::abs(origin);
    result.point[k] = static_cast<S>(value);
    result.error += std::abs(value - static_cast<double>(result.point[k])) +
                    8 * carry_u * magnitude + carry_floor;
  }
  result.error *= 1 + 8 * carry_u;
  return result;
}

/// Throws unless a number of a carried volume is finite.
template <FloatOrDouble S, std::floating_point T>
T require_carried(const CoordinateFrame<S>& frame, T x) {
  if (!std::isfinite(x)) {
    throw_invalid_argument("frame", vector_text(frame.origin),
                           "must be finite, and the carried volume must not overflow");
  }
  return x;
}

/// 1/σ for the smallest singular value σ of axes that are nearly orthonormal: with ε the largest
/// row sum of |AᵀA − I|, σ² ≥ 1 − ε, and 1/√(1 − ε) ≤ 1 + ε for ε ≤ 1/2.
/// @throws std::invalid_argument if ε exceeds 1/2
template <FloatOrDouble S>
double inverse_stretch(const Matrix3<S>& axes) {
  const double off = row_sum(axes.template cast<double>(), 1);
  if (!(off <= 0.5)) {
    throw_invalid_argument("axes", vector_text(Vector3<S>(axes.col(0))) + ", ...",
                           "must be orthonormal");
  }
  return 1 + off;
}

/// The half length h grown by `error`, rounded up; for any coordinate along an axis.
template <FloatOrDouble S>
Vector3<S> grown_half_lengths(const CoordinateFrame<S>& frame, const Vector3<double>& half,
                              double error) {
  Vector3<S> grown;
  for (int k = 0; k < 3; ++k) {
    grown[k] = require_carried(frame, upward<S>(sum_up(half[k], error)));
  }
  return grown;
}

/// Throws unless a box has finite corners, low ≤ high.
template <FloatOrDouble S>
void require_box(const Aabb<S>& box) {
  aabb_from_corners<S>(box.low, box.high);
}

}  // namespace detail

// [carried-sphere]
/// A sphere carried along: its centre in the world, and its radius times the stretch of the axes,
/// plus the distance by which rounding displaces the centre.
///
/// The image of x is o + A x, and |o + A x − o − A c| ≤ ‖A‖ |x − c| ≤ stretch × radius, so all of
/// it is in the result. With axes that are rounded once the radius grows by at most 20 u of itself
/// and 75 u of the largest coordinate. Carry the object's own sphere at each step, not the sphere
/// of the step before: the growth would add up.
/// @param sphere m, in the frame; finite, with a radius that is not negative
/// @param frame taken as stored, also if its axes are no rotation
/// @throws std::invalid_argument if the sphere does not satisfy this, or a number is not finite
template <FloatOrDouble S>
Sphere<S> carried(const Sphere<S>& sphere, const CoordinateFrame<S>& frame) {
  detail::require_sphere(sphere);
  const auto centre =
      detail::carried_point(frame, Vector3<double>(sphere.centre.template cast<double>()));
  const double radius = static_cast<double>(sphere.radius) * stretch_of(frame.axes);
  const double all = (radius + centre.error) * (1 + 4 * detail::carry_u) + detail::carry_floor;
  for (int k = 0; k < 3; ++k) detail::require_carried(frame, centre.point[k]);
  return {centre.point, detail::require_carried(frame, upward<S>(all))};
}
// [/carried-sphere]

/// An oriented box carried along. The product B of the axes is rounded, and so is the centre; the
/// half lengths grow by a bound on what that can take from the image.
///
/// The exact image of x with |xⱼ| ≤ hⱼ is c + e + (B + D) x, with |D| ≤ γ(3) |F||A|: the point of
/// the stored box with coordinates x + B⁻¹ (e + D x). These exceed hⱼ by at most ‖B⁻¹‖ times
/// |e| + Σ|D| h.
/// @param box m, in the frame; finite, nearly orthonormal axes, half lengths that are not negative
/// @param frame with nearly orthonormal axes
/// @throws std::invalid_argument if an argument does not satisfy this, or a number overflows
template <FloatOrDouble S>
OrientedBox<S> carried(const OrientedBox<S>& box, const CoordinateFrame<S>& frame) {
  require_finite("half_lengths", box.half_lengths);
  if (box.half_lengths.minCoeff() < S(0)) {
    throw_invalid_argument("half_lengths", vector_text(box.half_lengths), "must not be negative");
  }
  const auto centre =
      detail::carried_point(frame, Vector3<double>(box.centre.template cast<double>()));
  const Matrix3<double> turn = frame.axes.template cast<double>();
  const Matrix3<double> axes = box.axes.template cast<double>();
  const Vector3<double> half = box.half_lengths.template cast<double>();
  const Matrix3<double> product = turn * axes;
  const Matrix3<double> magnitude = turn.cwiseAbs() * axes.cwiseAbs();
  OrientedBox<S> result{centre.point, product.cast<S>(), {}};
  const Matrix3<double> rounding = (product - result.axes.template cast<double>()).cwiseAbs();
  double error = centre.error;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      error +=
          (rounding(i, j) + 8 * detail::carry_u * magnitude(i, j) + detail::carry_floor) * half[j];
    }
    detail::require_carried(frame, centre.point[i]);
  }
  error = error * detail::inverse_stretch(result.axes) * (1 + 32 * detail::carry_u);
  result.half_lengths = detail::grown_half_lengths(frame, half, error + 2 * detail::carry_floor);
  return result;
}

// [carried-box]
/// An axis-aligned box carried along: an oriented box, with the axes of the frame as stored. Only
/// its centre is rounded, for which the half lengths grow.
/// @param box m, in the frame
/// @param frame with nearly orthonormal axes
/// @throws std::invalid_argument if an argument does not satisfy this, or a number overflows
template <FloatOrDouble S>
OrientedBox<S> carried(const Aabb<S>& box, const CoordinateFrame<S>& frame) {
  detail::require_box(box);
  const Vector3<double> low = box.low.template cast<double>();
  const Vector3<double> high = box.high.template cast<double>();
  const Vector3<double> middle = low / 2 + high / 2;
  Vector3<double> half;
  for (int k = 0; k < 3; ++k) {
    half[k] = std::max(sum_up(high[k], -middle[k]), sum_up(middle[k], -low[k]));
  }
  const auto centre = detail::carried_point(frame, middle);
  for (int k = 0; k < 3; ++k) detail::require_carried(frame, centre.point[k]);
  const double error = centre.error * detail::inverse_stretch(frame.axes);
  return {centre.point, frame.axes,
          detail::grown_half_lengths(frame, half,
                                     error * (1 + 4 * detail::carry_u) + detail::carry_floor)};
}
// [/carried-box]

namespace detail {

/// The smallest and the largest coordinate k in the world of a box in a frame, rounded outwards.
///
/// Each sum has at most four roundings and is off by at most γ(4) times the sum s of the magnitudes
/// of its terms. It is moved outwards by 8 u s, which also covers the rounding of that move.
template <FloatOrDouble S>
std::array<S, 2> carried_range(const Aabb<S>& box, const CoordinateFrame<S>& frame, int k) {
  double low = 0, high = 0, magnitude = 0;
  for (int j = 0; j < 3; ++j) {
    const double axis = static_cast<double>(frame.axes(k, j));
    const double a = axis * static_cast<double>(box.low[j]);
    const double b = axis * static_cast<double>(box.high[j]);
    low += std::min(a, b);
    high += std::max(a, b);
    magnitude += std::max(std::abs(a), std::abs(b));
  }
  const double origin = static_cast<double>(frame.origin[k]);
  const double error = 8 * carry_u * (magnitude + std::abs(origin)) + carry_floor;
  require_carried(frame, error);
  return {downward<S>(low + origin - error), upward<S>(high + origin + error)};
}

}  // namespace detail

// [aabb-of-carried]
/// An axis-aligned box that contains the image of another: for each coordinate the sum of the
/// smaller of axis × low and axis × high, and of the larger ones, rounded outwards.
///
/// It may be larger than the box of the object's points, and is up to √3 times as wide in a
/// direction as that of a cube before it turned.
/// @param box m, in the frame
/// @param frame taken as stored, also if its axes are no rotation
/// @throws std::invalid_argument if the box has low > high, or a number is not finite
///
/// Source: Arvo, *Transforming Axis-Aligned Bounding Boxes*, Graphics Gems (1990).
template <FloatOrDouble S>
Aabb<S> aabb_of_carried(const Aabb<S>& box, const CoordinateFrame<S>& frame) {
  detail::require_box(box);
  Aabb<S> result;
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = detail::carried_range(box, frame, k);
    result.low[k] = detail::require_carried(frame, low);
    result.high[k] = detail::require_carried(frame, high);
  }
  return result;
}
// [/aabb-of-carried]

}  // namespace contact
