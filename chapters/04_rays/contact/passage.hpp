/// @file
/// Where a line enters and leaves a convex body, and what of that a ray or a segment sees first.
///
/// ray_of and start_of pass on all numbers, also a direction of 0, infinities and NaN.
#pragma once

#include <concepts>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/plane.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <optional>

namespace contact {

// [passage]
/// The part of an unbounded line inside a convex body: all points origin + t direction with entry ≤
/// t ≤ exit.
///
/// Bodies are solid and closed, so touching counts: then entry = exit. A line that does not meet
/// the body has no Passage; functions return an empty optional.
template <Ring S>
struct Passage {
  /// In multiples of the direction; −∞ where the body is unbounded in this direction or the line
  /// has no direction.
  S entry = S(0);
  S exit = S(0);  ///< the same, +∞
  /// Outward normal of the surface where the line enters, unit except where a function says
  /// otherwise; 0 where the line enters nowhere.
  Vector3<S> entry_normal = Vector3<S>::Zero();
  Vector3<S> exit_normal = Vector3<S>::Zero();  ///< where it leaves
  int entry_face = -1;  ///< number of the face, as the function says; −1 for a curved surface
  int exit_face = -1;   ///< where it leaves
};

/// The first point of a solid body that a ray or a segment meets.
template <Ring S>
struct BodyHit {
  S t = S(0);  ///< in multiples of the direction; for a segment, from 0 to 1; 0 if inside
  Vector3<S> point = Vector3<S>::Zero();   ///< m
  Vector3<S> normal = Vector3<S>::Zero();  ///< outward, where it enters; 0 if inside
  int face = -1;        ///< as in Passage; −1 for a curved surface and if inside
  bool inside = false;  ///< the line starts in the body without entering it there: entry < 0 ≤ exit
};
// [/passage]

// [line-of]
/// A ray as it is, for templates.
template <Ring S>
const Ray<S>& ray_of(const Ray<S>& ray) {
  return ray;
}
/// A segment as a ray: t = 1 is its end. The direction is rounded, and infinite if it overflows.
template <Ring S>
Ray<S> ray_of(const Segment<S>& segment) {
  return {segment.start, Vector3<S>(segment.end - segment.start)};
}

/// A ray of floats or doubles in exact numbers. Numbers that are not finite are an error of the
/// program, as for Exact.
template <std::floating_point S>
Ray<Exact> exact_ray_of(const Ray<S>& ray) {
  return {exact_vector(ray.origin), exact_vector(ray.direction)};
}
/// A segment as a ray in exact numbers: the direction is end − start without rounding, so t = 1 is
/// exactly the stored end. It must be finite, and may be longer than the largest number.
template <std::floating_point S>
Ray<Exact> exact_ray_of(const Segment<S>& segment) {
  const Vector3<Exact> start = exact_vector(segment.start);
  return {start, Vector3<Exact>(exact_vector(segment.end) - start)};
}

/// Where a ray starts.
template <Ring S>
const Vector3<S>& start_of(const Ray<S>& ray) {
  return ray.origin;
}
/// Where a segment starts.
template <Ring S>
const Vector3<S>& start_of(const Segment<S>& segment) {
  return segment.start;
}

/// Whether the line ends at t = 1.
template <class Line>
inline constexpr bool has_end = false;
/// A segment does.
template <Ring S>
inline constexpr bool has_end<Segment<S>> = true;

/// Whether every coordinate is finite: no for an infinity or NaN, yes for a direction of 0.
template <Ring S>
bool is_finite(const Ray<S>& ray) {
  return all_finite(ray.origin) && all_finite(ray.direction);
}
/// The same for a segment: yes also for one of length 0 or longer than the largest number.
template <Ring S>
bool is_finite(const Segment<S>& segment) {
  return all_finite(segment.start) && all_finite(segment.end);
}
// [/line-of]

namespace detail {

/// Whether the direction is 0.
template <Ring S>
bool is_point(const Ray<S>& ray) {
  return ray.direction == Vector3<S>::Zero();
}
template <Ring S>
bool is_point(const Segment<S>& segment) {
  return segment.start == segment.end;
}

/// origin + t direction, computed in double and rounded once more in float. A component 0
/// stays where it is.
template <std::floating_point S>
Vector3<S> point_of_line(const Ray<S>& ray, double t) {
  const Vector3<double> d = ray.direction.template cast<double>();
  Vector3<double> offset = d * t;
  for (int k = 0; k < 3; ++k) {
    if (d(k) == 0) offset(k) = 0;  // also for an infinite t
  }
  return (ray.origin.template cast<double>() + offset).template cast<S>();
}
/// The same for a segment; t from 0 to 1. Halves cannot overflow.
template <std::floating_point S>
Vector3<S> point_of_line(const Segment<S>& segment, double t) {
  const Vector3<double> start = segment.start.template cast<double>();
  const Vector3<double> end = segment.end.template cast<double>();
  if (t == 1) return segment.end;
  return (start + (end / 2 - start / 2) * (t + t)).template cast<S>();
}

/// The hit of a line with a passage; `last` bounds t if it is finite.
template <Ring S>
std::optional<BodyHit<S>> first_of_passage(const Ray<S>& ray, const Passage<S>& passage,
                                           const S* last) {
  if (!(S(0) <= passage.exit)) return std::nullopt;  // behind, or NaN
  if (passage.entry < S(0)) {
    BodyHit<S> hit;
    hit.point = ray.origin;
    hit.inside = true;
    return hit;
  }
  if (!(passage.entry <= passage.exit) || (last != nullptr && *last < passage.entry)) {
    return std::nullopt;
  }
  return BodyHit<S>{passage.entry, Vector3<S>(ray.origin + ray.direction * passage.entry),
                    passage.entry_normal, passage.entry_face, false};
}

}  // namespace detail

// [first-of-passage]
/// What a ray meets first of a body that its line passes: the entry, or the start if that is
/// inside.
///
/// Nothing if the body is behind the start (exit < 0), and nothing for a NaN as entry or exit. The
/// numbers of the ray only make the point: that of an entry of ∞ is not finite. A line that only
/// touches at the start (entry = 0) hits there and is not inside; one that leaves there (entry < 0
/// = exit) is. The comparisons are exact for the numbers of the passage; if these are rounded, a
/// body that ends next to the start may be found or missed.
/// @return its point is origin + t direction as rounded, off by at most γ(2) of the sum of the
/// absolute values of both terms in each coordinate, and by the error of t times the direction
template <Ring S>
std::optional<BodyHit<S>> first_hit(const Ray<S>& ray, const Passage<S>& passage) {
  return detail::first_of_passage<S>(ray, passage, nullptr);
}

/// The same for a segment: also nothing if entry > 1. The passage is that of ray_of(segment), and
/// if its direction overflows, the point of an entry is not finite.
template <Ring S>
std::optional<BodyHit<S>> first_hit(const Segment<S>& segment, const Passage<S>& passage) {
  const S last(1);
  return detail::first_of_passage<S>(ray_of(segment), passage, &last);
}
// [/first-of-passage]

}  // namespace contact
