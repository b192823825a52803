/// @file
/// The signed distance of a box and a sphere, a capsule or a box, in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/box_axes.hpp>
#include <contact/closest_points.hpp>
#include <contact/face_clipping.hpp>
#include <contact/oriented_box.hpp>
#include <contact/signed_distance_capsules.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// The largest coordinate of a box, and more.
template <FloatOrDouble S>
S largest_coordinate(const OrientedBox<S>& box) {
  return Vector3<S>(box.axes.cwiseAbs() * box.half_lengths + box.centre.cwiseAbs()).maxCoeff();
}

// [signed-distance-sphere-box]
/// The signed distance of a sphere and a box. A centre inside the box is moved out through the
/// closest face: of equal ones, the first of x, y and z, on the positive side.
/// @return error of the distance: a few u of the coordinates, sizes and radius
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const Sphere<S>& a, const OrientedBox<S>& b) {
  const Vector3<S> local = in_box_axes(b, a.centre);
  Vector3<S> inside;
  for (int i = 0; i < 3; ++i) {
    inside(i) = std::clamp<S>(local(i), -b.half_lengths(i), b.half_lengths(i));
  }
  const Vector3<S> between = local - inside;
  const S distance = length<S>(between);
  int face = 0;
  S depth = b.half_lengths(0) - std::abs(local(0));
  for (int i = 1; i < 3; ++i) {
    const S other = b.half_lengths(i) - std::abs(local(i));
    if (other < depth) {
      depth = other;
      face = i;
    }
  }
  const S size = std::max(a.centre.cwiseAbs().maxCoeff(), largest_coordinate(b));
  if (!is_near(distance, size)) {
    return signed_distance_of_cores<S>(a.centre, a.radius, out_of_box_axes(b, inside), S(0),
                                       distance, Vector3<S>(b.axes * normalised<S>(between)));
  }
  if (!(depth > distance_error(size))) {
    const CoreDirection<S> exact = core_direction(a, b);
    if (exact.normal != Vector3<S>::Zero()) {
      return signed_distance_of_cores<S>(a.centre, a.radius, out_of_box_axes(b, inside), S(0),
                                         exact.distance, exact.normal);
    }
  }
  const S side = local(face) < S(0) ? S(-1) : S(1);
  inside(face) = side * b.half_lengths(face);
  return signed_distance_of_cores<S>(a.centre, a.radius, out_of_box_axes(b, inside), S(0),
                                     S(-depth), Vector3<S>(Vector3<S>(b.axes.col(face)) * side));
}
// [/signed-distance-sphere-box]

/// An axis and the separation of A and B along it.
template <std::floating_point S>
struct AxisSeparation {
  S separation = -std::numeric_limits<S>::infinity();  ///< m
  Vector3<S> normal = Vector3<S>::Zero();              ///< unit vector, from B to A
  int axis = -1;                                       ///< which candidate it was
};

/// a × b, also for parallel or almost parallel vectors of similar length. Then the difference b ∓ a
/// is short and accurate: a × b = a × (b ∓ a).
template <std::floating_point S>
Vector3<S> careful_cross(const Vector3<S>& a, const Vector3<S>& b) {
  if (a.dot(b) < S(0)) return a.cross(Vector3<S>(b + a));
  return a.cross(Vector3<S>(b - a));
}

/// Whether a cross product of unit vectors has a meaningful direction: its length exceeds 16 u. A
/// shorter one belongs to edges that are parallel up to the rounding of their stored numbers.
/// Leaving it out adds at most 16 u of an edge's length to the depth, because the strip between the
/// adjacent faces is that narrow.
template <std::floating_point S>
bool has_direction(const Vector3<S>& cross) {
  return length<S>(cross) > S(8) * std::numeric_limits<S>::epsilon();
}

// [signed-distance-capsule-box]
/// The axis of largest separation between a segment and a box: of the three face normals of the box
/// and the three cross products of the segment and an edge.
template <FloatOrDouble S>
AxisSeparation<S> max_separation(const Segment<S>& a, const OrientedBox<S>& b) {
  AxisSeparation<S> best;
  const Vector3<S> start = a.start - b.centre;
  const Vector3<S> end = a.end - b.centre;
  const Vector3<S> d = a.end - a.start;
  const Vector3<S> along = d == Vector3<S>::Zero() ? d : normalised<S>(d);
  for (int k = 0; k < 6; ++k) {
    Vector3<S> n = b.axes.col(k % 3);
    if (k >= 3) {
      if (!has_direction<S>(careful_cross<S>(along, n))) continue;
      n = cross_direction<S>(d, n);
      if (n == Vector3<S>::Zero()) continue;
    }
    const S half_extent = projected_radius(b, n);
    const S from = n.dot(start);
    const S to = n.dot(end);
    // In both directions of the axis.
    const S ahead = std::min(from, to) - half_extent;
    const S behind = -std::max(from, to) - half_extent;
    if (ahead > best.separation) best = {ahead, n, k};
    if (behind > best.separation) best = {behind, -n, k};
  }
  return best;
}

/// The deepest point of a segment in a box that it meets, along the axis of least overlap.
template <FloatOrDouble S>
Vector3<S> deepest_in_box(const Segment<S>& a, const OrientedBox<S>& b,
                          const AxisSeparation<S>& widest) {
  const Vector3<S>& n = widest.normal;
  if (widest.axis < 3) {
    // The lowest point of the part of the segment above the face.
    const Segment<S> core = n.dot(a.start) <= n.dot(a.end) ? a : Segment<S>{a.end, a.start};
    return lowest_over_face<S>(core, b, widest.axis);
  }
  const Segment<S> edge = support_edge<S>(b, widest.axis - 3, n);
  const Vector2<S> at = crossing_fractions(a, edge);
  return at.x() >= S(0) ? point_at<S>(a, at.x()) : closest_points<S>(a, b).on_a;
}

/// The signed distance of a capsule and a box: that of its segment and the box, less the radius.
///
/// If the segment is outside, the closest points give distance and direction; very close to the
/// box, the exact closest points do. If it meets the box, the shortest translation is along one of
/// six axes.
/// @return error of the distance: a few u of the coordinates, sizes and radius
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const Capsule<S>& a, const OrientedBox<S>& b) {
  if (a.core.start == a.core.end) return closed_distance(Sphere<S>{a.core.start, a.radius}, b);
  const AxisSeparation<S> widest = max_separation<S>(a.core, b);
  const S size = std::max(largest_coordinate<S>(a.core.start, a.core.end), largest_coordinate(b));
  if (!(widest.separation < -distance_error(size))) {
    const ClosestPoints<S> near = closest_points<S>(a.core, b);
    const Vector3<S> between = near.on_a - near.on_b;
    CoreDirection<S> core{Vector3<S>::Zero(), length<S>(between)};
    if (is_near(core.distance, size)) {
      core = core_direction(a, b);
    } else {
      core.normal = normalised<S>(between);
    }
    if (core.normal != Vector3<S>::Zero()) {
      return signed_distance_of_cores<S>(near.on_a, a.radius, near.on_b, S(0), core.distance,
                                         core.normal);
    }
  }
  const Vector3<S> deepest = deepest_in_box<S>(a.core, b, widest);
  return signed_distance_of_cores<S>(deepest, a.radius,
                                     Vector3<S>(deepest - widest.normal * widest.separation), S(0),
                                     widest.separation, widest.normal);
}
// [/signed-distance-capsule-box]

// [signed-distance-boxes]
/// The axis of largest separation between two boxes, of the fifteen or of some of them. axis is −1
/// if none of them has a direction. Of equal ones the first is taken, and an edge–edge axis must
/// exceed the face normals by 64 u of the sizes: faces give better contacts, and rounding must not
/// decide.
template <FloatOrDouble S>
AxisSeparation<S> max_separation(const OrientedBox<S>& a, const OrientedBox<S>& b, int first = 0,
                                 int last = box_axis_count - 1) {
  AxisSeparation<S> best;
  const Vector3<S> between = a.centre - b.centre;
  const S size = a.half_lengths.sum() + b.half_lengths.sum() + between.cwiseAbs().sum();
  const S preference = S(32) * std::numeric_limits<S>::epsilon() * size;
  for (int k = first; k <= last; ++k) {
    Vector3<S> n;
    if (k < 6) {
      n = (k < 3 ? a : b).axes.col(k % 3);
    } else {
      n = careful_cross<S>(a.axes.col((k - 6) / 3), b.axes.col((k - 6) % 3));
      if (!has_direction<S>(n)) continue;
      n = normalised<S>(n);
    }
    const S along = n.dot(between);
    const S separation = std::abs(along) - projected_radius(a, n) - projected_radius(b, n);
    const S needed = k < 6 && k != 3 ? best.separation : S(best.separation + preference);
    if (best.axis < 0 || separation > needed) {
      if (along < S(0)) n = -n;
      best = {separation, n, k};
    }
  }
  return best;
}

/// The signed distance of two boxes.
///
/// Separated boxes: the distance of their closest points. If rounding cannot distinguish its
/// direction from one of the fifteen axes, the axis is taken, which has full precision however
/// close the boxes are; at a vertex or an end of an edge of boxes that are very close, the
/// direction of the exact closest points. Overlapping boxes: the axis of least overlap. If it is a
/// face normal, the points are the deepest of the other box over that face; if it belongs to two
/// edges, they are the closest points of these.
/// @return error of the distance: a few u of the coordinates and sizes
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  const AxisSeparation<S> widest = max_separation<S>(a, b);
  const Vector3<S>& n = widest.normal;
  const S size = std::max(largest_coordinate(a), largest_coordinate(b));
  if (widest.separation > distance_error(size)) {
    const ClosestPoints<S> near = closest_points<S>(a, b, n);
    const Vector3<S> between = near.on_a - near.on_b;
    const auto along = [&near](const S& distance, const Vector3<S>& normal) {
      return signed_distance_of_cores<S>(near.on_a, S(0), near.on_b, S(0), distance, normal);
    };
    const S distance = length<S>(between);
    const S aside = length<S>(Vector3<S>(between - n * widest.separation));
    if (aside <= S(4) * distance_error(size)) return along(distance, n);
    if (!is_near(distance, size)) return along(distance, normalised<S>(between));
    const CoreDirection<S> exact = core_direction(a, b);
    return exact.normal == Vector3<S>::Zero() ? along(distance, n)
                                              : along(exact.distance, exact.normal);
  }
  if (widest.axis < 6) {
    const bool face_of_a = widest.axis < 3;
    const Vector3<S> outward = face_of_a ? Vector3<S>(-n) : n;
    const auto deepest = face_of_a ? deepest_over_face<S>(a, widest.axis, outward, b)
                                   : deepest_over_face<S>(b, widest.axis - 3, outward, a);
    if (!deepest) {
      const ClosestPoints<S> near = closest_points<S>(a, b);
      return {widest.separation, n, near.on_a, near.on_b};
    }
    const Vector3<S> shift = n * widest.separation;
    if (face_of_a) return {widest.separation, n, Vector3<S>(*deepest + shift), *deepest};
    return {widest.separation, n, *deepest, Vector3<S>(*deepest - shift)};
  }
  const Segment<S> edge_a = support_edge<S>(a, (widest.axis - 6) / 3, Vector3<S>(-n));
  const Segment<S> edge_b = support_edge<S>(b, (widest.axis - 6) % 3, n);
  const Vector2<S> at = crossing_fractions(edge_a, edge_b);
  if (at.x() >= S(0)) {
    return {widest.separation, n, point_at<S>(edge_a, at.x()), point_at<S>(edge_b, at.y())};
  }
  const ClosestPoints<S> near = closest_points<S>(edge_a, edge_b);
  return {widest.separation, n, near.on_a, near.on_b};
}
// [/signed-distance-boxes]

}  // namespace contact::detail
