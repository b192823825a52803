/// @file
/// A segment against a plane, with the time of the crossing as a fraction.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <utility>

#include <contact/plane.hpp>
#include <contact/shapes.hpp>

namespace contact {

namespace detail {

/// The signed distances of a segment's ends, or both divided by 8: only their ratio and signs
/// matter, and eighths of finite distances do not overflow, nor does their difference.
template <Ring S>
std::pair<S, S> comparable_distances(const Plane<S>& plane, const Segment<S>& segment) {
  const S start = plane.normal.dot(segment.start) - plane.offset;
  const S end = plane.normal.dot(segment.end) - plane.offset;
  if constexpr (std::floating_point<S>) {
    if (!std::isfinite(start) || !std::isfinite(end) || !std::isfinite(start - end)) {
      const S eighth = S(1) / S(8);
      return {plane.normal.dot(Vector3<S>(segment.start * eighth)) - plane.offset * eighth,
              plane.normal.dot(Vector3<S>(segment.end * eighth)) - plane.offset * eighth};
    }
  }
  return {start, end};
}

/// weight_start × start + weight_end × end, clamped to the box of the two: rounding must not move
/// the point beyond them.
template <Scalar S>
Vector3<S> between(const Segment<S>& segment, const S& weight_start, const S& weight_end) {
  Vector3<S> point;
  for (int i = 0; i < 3; ++i) {
    const S a = segment.start(i);
    const S b = segment.end(i);
    const S value = weight_start * a + weight_end * b;
    point(i) = std::clamp<S>(value, std::min<S>(a, b), std::max<S>(a, b));
  }
  return point;
}

}  // namespace detail

/// The one point where a segment meets a plane.
///
/// With signed distances d₀ at the start and d₁ at the end, the distance at t is d₀ + t (d₁ − d₀),
/// which is 0 at t = d₀ / (d₀ − d₁). An end on the plane counts: touching is contact. t need not be
/// compared with 0 and 1: ends on different sides give 0 ≤ t ≤ 1, in rounded arithmetic too.
/// @param segment from start to end, m
/// @param plane with a unit normal
/// @return t from 0 (start) to 1 (end), and the point, m, inside the box of the two ends. Nothing
/// if both ends are on the same side, and nothing if both are *on* the plane: then the segment lies
/// in the plane and has no single meeting point.
/// @note In a floating-point type the sides are those of the rounded distances. t has an error of
/// about 8 u (Σ|nᵢ startᵢ| + Σ|nᵢ endᵢ| + |k|) / |d₀ − d₁|.
/// @see *Interaction and Normals*, slides "Segment vs. Triangle" and "Collision detection: time of
/// impact"
// [segment-plane]
template <Scalar S>
std::optional<RayHit<S>> segment_plane(const Segment<S>& segment, const Plane<S>& plane) {
  const auto [start, end] = detail::comparable_distances(plane, segment);
  const Side start_side = side_of_value(start);
  const Side end_side = side_of_value(end);
  if (start_side == end_side) return std::nullopt;  // both on one side, or both in the plane
  if (start_side == Side::on) return RayHit<S>{S(0), segment.start};
  if (end_side == Side::on) return RayHit<S>{S(1), segment.end};
  const S t = start / (start - end);
  const S weight_start = end / (end - start);  // 1 − t, without rounding a subtraction
  return RayHit<S>{t, detail::between(segment, weight_start, t)};
}
// [/segment-plane]

}  // namespace contact
