/// @file
/// A ball that moves along a segment, against a box: the enlarged box, and the rounded one.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/aabb.hpp>
#include <contact/convex_part.hpp>
#include <contact/outward.hpp>
#include <contact/passage.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_capsule.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [enlarged-box]
/// What the centre of a ball meets first of the box enlarged by the radius on all sides.
///
/// Limits: the enlarged box is larger than what the ball can touch. Beside an edge it is up to
/// (√2 − 1) r too far out, at a corner up to (√3 − 1) r: a ball that passes a corner is said to
/// hit. Its faces are rounded outwards, at most to the largest number, so it misses nothing. A path
/// of length 0 is a point. Nothing for a negative radius, a box with low > high and numbers that
/// are not finite.
template <FloatOrDouble S>
std::optional<BodyHit<S>> ball_hits_enlarged_box(const Segment<S>& path, const S& radius,
                                                 const Aabb<S>& box) {
  if (!is_finite(radius) || radius < S(0)) return std::nullopt;
  if (!all_finite(box.low) || !all_finite(box.high) || !boxes_touch(box, box)) return std::nullopt;
  constexpr S most = std::numeric_limits<S>::max();
  Aabb<S> enlarged;
  for (int k = 0; k < 3; ++k) {
    enlarged.low(k) = std::max(sum_down(box.low(k), -radius), -most);
    enlarged.high(k) = std::min(sum_up(box.high(k), radius), most);
  }
  return first_hit(path, enlarged);
}
// [/enlarged-box]

namespace detail {

// [rounded-box-parts]
/// All points at most r from a box, in 23 convex parts: the box enlarged along each axis (its faces
/// moved outwards), a cylinder about each of twelve edges, a ball about each of eight corners.
struct RoundedBoxParts {
  const DoubleLine& line;
  const Aabb<double>& box;
  double radius;

  static constexpr int count = 23;

  double corner(int axis, int upper) const { return upper != 0 ? box.high(axis) : box.low(axis); }

  template <class T>
  ConvexPart<T> part(int k) const {
    const Triple<T> w = line.direction<T>(), start = triple<T>(line.start);
    const T r(radius);
    ConvexPart<T> part;
    const auto between = [&](int axis, const T& margin) {
      const auto i = static_cast<std::size_t>(axis);
      const T low = T(box.low(axis)) - margin, high = T(box.high(axis)) + margin;
      part.add(start[i] - low, w[i], high - low);
    };
    if (k < 3) {
      for (int axis = 0; axis < 3; ++axis) between(axis, axis == k ? r : T(0.0));
      return part;
    }
    if (k < 15) {  // the edges along an axis: their distance is measured in the plane of two others
      const int along = (k - 3) / 4, which = (k - 3) % 4;
      const int i = (along + 1) % 3, j = (along + 2) % 3;
      Triple<T> m{T(0.0), T(0.0), T(0.0)}, moved = m;
      const auto set = [&](int axis, int upper) {
        const auto n = static_cast<std::size_t>(axis);
        m[n] = start[n] - T(corner(axis, upper));
        moved[n] = w[n];
      };
      set(i, which & 1);
      set(j, which >> 1);
      part = ball_part(m, moved, r);
      between(along, T(0.0));
      return part;
    }
    const int which = k - 15;
    return ball_part(line.from<T>({corner(0, which & 1), corner(1, (which >> 1) & 1),
                                   corner(2, (which >> 2) & 1)}),
                     w, r);
  }
  // [/rounded-box-parts]

  /// Away from the nearest point of the box; with a radius of 0, 0.
  Vector3<double> normal(double t, int) const {
    if (radius == 0) return Vector3<double>::Zero();
    const Vector3<double> p = line.at(t, Vector3<double>::Zero());
    return unit_or_zero(p - p.cwiseMax(box.low).cwiseMin(box.high));
  }
};

}  // namespace detail

// [ball-hits-box]
/// Whether a ball whose centre moves along a segment touches a solid box on its way.
///
/// Right for every finite input. A path of length 0 is a ball at rest. No for a negative radius, a
/// box with low > high and numbers that are not finite.
template <FloatOrDouble S>
bool ball_hits_box(const Segment<S>& path, const S& radius, const Aabb<S>& box) {
  const detail::DoubleLine line(path);
  const Aabb<double> wide = in_double(box);
  if (!line.finite() || !all_finite(box.low) || !all_finite(box.high) || !is_finite(radius) ||
      radius < S(0) || !boxes_touch(box, box)) {
    return false;
  }
  const double r = static_cast<double>(radius);
  for (int k = 0; k < 3; ++k) {  // beside the box: rounded outwards, so nothing is lost
    if (std::max(line.start(k), line.second(k)) < sum_down(wide.low(k), -r) ||
        sum_up(wide.high(k), r) < std::min(line.start(k), line.second(k))) {
      return false;
    }
  }
  const detail::RoundedBoxParts parts{line, wide, r};
  return detail::meets_parts(parts.count, parts, detail::LineExtent::segment);
}

/// Where on its path it touches first. The decision is that of ball_hits_box; t is within 2^-40 of
/// itself. The point is the centre of the ball then, its normal points from the nearest point of
/// the box to it, and is 0 for a radius of 0 and where a difference of coordinates overflows; faces
/// have no number. `inside` if the ball overlaps the box at the start.
template <FloatOrDouble S>
std::optional<BodyHit<S>> ball_first_hit(const Segment<S>& path, const S& radius,
                                         const Aabb<S>& box) {
  if (!ball_hits_box(path, radius, box)) return std::nullopt;
  const detail::DoubleLine line(path);
  const Aabb<double> wide = in_double(box);
  const detail::RoundedBoxParts parts{line, wide, static_cast<double>(radius)};
  auto hit = detail::hit_with_normal<S>(line, detail::passage_in_parts(parts.count, parts),
                                        [&](double t, int face) { return parts.normal(t, face); });
  if (hit) hit->face = -1;
  return hit;
}
// [/ball-hits-box]

}  // namespace contact
