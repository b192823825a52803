/// @file
/// Slabs and boxes of a body in the world, made again from its vertices at each pose.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/exact.hpp>
#include <contact/exact_outward.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace carried_points_detail {

/// Where normal · x is for the images of some points.
struct Extent {
  double low, high;
};

/// Bounds on normal · (o + A p) = normal · o + (normalᵀ A) · p.
///
/// A term normalᵢ Aᵢⱼ pⱼ has at most seven roundings, and its underflow adds at most η (1 + |pⱼ|);
/// 16 u times the sum of the magnitudes is above γ(7) of it, with the roundings of that sum and of
/// the ends.
template <FloatOrDouble S>
Extent extent_of(const Vector3<S>& normal, std::span<const Vector3<S>> points,
                 const CoordinateFrame<S>& frame) {
  const Vector3<double>& n = normal.template cast<double>();
  const Vector3<double>& origin = frame.origin.template cast<double>();
  const Matrix3<double>& axes = frame.axes.template cast<double>();
  const Vector3<double> along = axes.transpose() * n;
  const double start = n.dot(origin);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  Vector3<double> size = Vector3<double>::Zero();
  for (const Vector3<S>& point : points) {
    const Vector3<double>& p = point.template cast<double>();
    const double at = start + along.dot(p);
    low = std::min(low, at);
    high = std::max(high, at);
    size = size.cwiseMax(p.cwiseAbs());
  }
  const double magnitude = n.cwiseAbs().dot(axes.cwiseAbs() * size + origin.cwiseAbs());
  const double error = 16 * tolerance::unit_roundoff<double> * magnitude +
                       16 * tolerance::underflow_unit<double> * (1 + size.sum());
  return {low - error, high + error};
}

}  // namespace carried_points_detail

// [kdop-of-carried]
/// A k-DOP around the images of points under a frame: tighter than the k-DOP of the object carried
/// along, which grows, but each pose costs a product for each normal and vertex.
///
/// It contains the exact image o + A p of each point, for the frame as stored, whether or not its
/// axes are a rotation; and so the image of their hull. A slab is wider than the smallest one by at
/// most about 46 u Σ|normal| (|A||p| + |o|). Scales: any without overflow; subnormal numbers too.
/// @param points n ≥ 1, m, finite; those of the hull's vertices suffice
/// @throws std::invalid_argument if there is no point or normal, a normal is 0, a number is not
/// finite, or the k-DOP overflows
template <FloatOrDouble S>
Kdop<S> kdop_of_carried(const std::vector<Vector3<S>>& normals, std::span<const Vector3<S>> points,
                        const CoordinateFrame<S>& frame) {
  detail::require_slabs_of(normals, points);
  Kdop<S> dop;
  dop.normals = normals;
  for (const Vector3<S>& normal : normals) {
    const auto extent = carried_points_detail::extent_of<S>(normal, points, frame);
    dop.low.push_back(downward<S>(extent.low));
    dop.high.push_back(upward<S>(extent.high));
    if (!std::isfinite(dop.low.back()) || !std::isfinite(dop.high.back())) {
      throw_invalid_argument("frame", vector_text(frame.origin),
                             "must be finite, and the k-DOP must not overflow");
    }
  }
  return dop;
}
// [/kdop-of-carried]

/// An axis-aligned box around the images of points under a frame, as kdop_of_carried().
/// @throws std::invalid_argument as that
template <FloatOrDouble S>
Aabb<S> aabb_of_carried_points(std::span<const Vector3<S>> points,
                               const CoordinateFrame<S>& frame) {
  const Kdop<S> dop = kdop_of_carried<S>(kdop_normals<S>(6), points, frame);
  return {{dop.low[0], dop.low[1], dop.low[2]}, {dop.high[0], dop.high[1], dop.high[2]}};
}

}  // namespace contact
