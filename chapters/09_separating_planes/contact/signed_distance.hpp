/// @file
/// The signed distance of two convex bodies, its direction and the points that attain it.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

#include <contact/box_axes.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/face_clipping.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [signed-distance]
/// The signed distance of two bodies A and B.
///
/// on_a − on_b = distance normal, up to rounding. For separated bodies these are two closest
/// points. For overlapping bodies, a translation of A by −distance along the normal is the shortest
/// one that separates them.
template <Ring S>
struct SignedDistance {
  S distance = S(0);                       ///< m; negative: minus the penetration depth
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  Vector3<S> on_a = Vector3<S>::Zero();    ///< on the surface of A, m
  Vector3<S> on_b = Vector3<S>::Zero();    ///< on the surface of B, m
};
// [/signed-distance]

/// The same with the two bodies exchanged.
template <Ring S>
SignedDistance<S> exchanged(const SignedDistance<S>& between) {
  return {between.distance, Vector3<S>(-between.normal), between.on_b, between.on_a};
}

namespace detail {

/// A unit vector perpendicular to d, always the same for the same d: perpendicular to the
/// coordinate axis along which d is smallest. For d = 0, the z axis.
template <std::floating_point S>
Vector3<S> perpendicular_to(const Vector3<S>& d) {
  if (d == Vector3<S>::Zero()) return Vector3<S>::UnitZ();
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(d(i)) < std::abs(d(least))) least = i;
  }
  Vector3<S> axis = Vector3<S>::Zero();
  axis(least) = S(1);
  return normalised<S>(Vector3<S>(d.cross(axis)));
}

/// The signed distance of two bodies from the closest points of their cores, along a unit normal:
/// each surface is at a distance of its radius from its core.
template <std::floating_point S>
SignedDistance<S> signed_distance_of_cores(const Vector3<S>& on_a, const S& radius_a,
                                           const Vector3<S>& on_b, const S& radius_b,
                                           const S& distance, const Vector3<S>& normal) {
  return {distance - (radius_a + radius_b), normal, Vector3<S>(on_a - normal * radius_a),
          Vector3<S>(on_b + normal * radius_b)};
}

/// Below this length the difference of two closest points is a rounding residual, and its direction
/// has no meaning.
template <std::floating_point S>
S direction_threshold(const Vector3<S>& p, const Vector3<S>& q) {
  return S(32) * std::numeric_limits<S>::epsilon() *
         std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff());
}

template <std::floating_point S>
S length(const Vector3<S>& v) {
  return std::sqrt(v.dot(v));
}

}  // namespace detail

// [signed-distance-spheres]
/// The signed distance of two spheres. If the centres coincide, all directions are equivalent, and
/// z is taken.
/// @return error of the distance: a few u of the coordinates and radii
template <std::floating_point S>
SignedDistance<S> signed_distance(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> between = a.centre - b.centre;
  const Vector3<S> normal =
      between == Vector3<S>::Zero() ? Vector3<S>(Vector3<S>::UnitZ()) : normalised<S>(between);
  return detail::signed_distance_of_cores<S>(a.centre, a.radius, b.centre, b.radius,
                                             detail::length<S>(between), normal);
}
// [/signed-distance-spheres]

// [signed-distance-capsules]
/// The signed distance of two capsules: that of the closest points of their segments, less the
/// radii.
///
/// If the segments cross, their closest points define no direction. Then the shortest translation
/// is perpendicular to both.
/// @return error of the distance: a few u of the coordinates and radii
template <std::floating_point S>
SignedDistance<S> signed_distance(const Capsule<S>& a, const Capsule<S>& b) {
  const ClosestPoints<S> near = closest_points<S>(a.core, b.core);
  const Vector3<S> between = near.on_a - near.on_b;
  const S distance = detail::length<S>(between);
  const Vector3<S> d = a.core.end - a.core.start;
  const Vector3<S> e = b.core.end - b.core.start;
  if (distance > detail::direction_threshold<S>(near.on_a, near.on_b)) {
    return detail::signed_distance_of_cores<S>(near.on_a, a.radius, near.on_b, b.radius, distance,
                                               normalised<S>(between));
  }
  Vector3<S> normal = d.cross(e);
  const S parallel = detail::length<S>(d) * detail::length<S>(e) * S(0x1p-20);
  if (detail::length<S>(normal) > parallel) {
    normal = normalised<S>(normal);
  } else {
    normal = detail::perpendicular_to<S>(d == Vector3<S>::Zero() ? e : d);
  }
  if (normal.dot(between) < S(0)) normal = -normal;
  return detail::signed_distance_of_cores<S>(near.on_a, a.radius, near.on_b, b.radius, S(0),
                                             normal);
}
/// A sphere and a capsule.
template <std::floating_point S>
SignedDistance<S> signed_distance(const Sphere<S>& a, const Capsule<S>& b) {
  return signed_distance(as_capsule(a), b);
}
/// A capsule and a sphere.
template <std::floating_point S>
SignedDistance<S> signed_distance(const Capsule<S>& a, const Sphere<S>& b) {
  return signed_distance(a, as_capsule(b));
}
// [/signed-distance-capsules]

// [signed-distance-sphere-box]
/// The signed distance of a sphere and a box. A centre inside the box is moved out through the
/// closest face: of equal ones, the first of x, y and z, on the positive side.
/// @return error of the distance: a few u of the coordinates, sizes and radius
template <std::floating_point S>
SignedDistance<S> signed_distance(const Sphere<S>& a, const OrientedBox<S>& b) {
  const Vector3<S> local = in_box_axes(b, a.centre);
  Vector3<S> inside;
  for (int i = 0; i < 3; ++i) {
    inside(i) = std::clamp<S>(local(i), -b.half_lengths(i), b.half_lengths(i));
  }
  const Vector3<S> between = local - inside;
  if (between != Vector3<S>::Zero()) {
    const Vector3<S> unit = normalised<S>(between);
    const Vector3<S> normal = b.axes * unit;
    return detail::signed_distance_of_cores<S>(a.centre, a.radius, out_of_box_axes(b, inside), S(0),
                                               detail::length<S>(between), normal);
  }
  int face = 0;
  S depth = b.half_lengths(0) - std::abs(local(0));
  for (int i = 1; i < 3; ++i) {
    const S other = b.half_lengths(i) - std::abs(local(i));
    if (other < depth) {
      depth = other;
      face = i;
    }
  }
  const S side = local(face) < S(0) ? S(-1) : S(1);
  inside(face) = side * b.half_lengths(face);
  const Vector3<S> normal = Vector3<S>(b.axes.col(face)) * side;
  return detail::signed_distance_of_cores<S>(a.centre, a.radius, out_of_box_axes(b, inside), S(0),
                                             S(-depth), normal);
}
/// A box and a sphere.
template <std::floating_point S>
SignedDistance<S> signed_distance(const OrientedBox<S>& a, const Sphere<S>& b) {
  return exchanged(signed_distance(b, a));
}
// [/signed-distance-sphere-box]

namespace detail {

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

}  // namespace detail

// [signed-distance-capsule-box]
namespace detail {

/// The axis of largest separation between a segment and a box: of the three face normals of the box
/// and the three cross products of the segment and an edge.
template <std::floating_point S>
AxisSeparation<S> max_separation(const Segment<S>& a, const OrientedBox<S>& b) {
  AxisSeparation<S> best;
  const Vector3<S> start = a.start - b.centre;
  const Vector3<S> end = a.end - b.centre;
  const Vector3<S> d = a.end - a.start;
  const Vector3<S> along = d == Vector3<S>::Zero() ? d : normalised<S>(d);
  for (int k = 0; k < 6; ++k) {
    Vector3<S> n = b.axes.col(k % 3);
    if (k >= 3) {
      n = careful_cross<S>(along, n);
      if (along == Vector3<S>::Zero() || !has_direction<S>(n)) continue;
      n = normalised<S>(n);
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

}  // namespace detail

/// The signed distance of a capsule and a box: that of its segment and the box, less the radius.
///
/// If the segment is outside, the closest points give distance and direction. If it meets the box,
/// the shortest translation is along one of six axes.
/// @return error of the distance: a few u of the coordinates, sizes and radius
template <std::floating_point S>
SignedDistance<S> signed_distance(const Capsule<S>& a, const OrientedBox<S>& b) {
  if (a.core.start == a.core.end) return signed_distance(Sphere<S>{a.core.start, a.radius}, b);
  const detail::AxisSeparation<S> widest = detail::max_separation<S>(a.core, b);
  const ClosestPoints<S> near = closest_points<S>(a.core, b);
  const Vector3<S> between = near.on_a - near.on_b;
  const S distance = detail::length<S>(between);
  const Vector3<S> far = b.axes.cwiseAbs() * b.half_lengths + b.centre.cwiseAbs();
  if (distance > detail::direction_threshold<S>(near.on_a, far)) {
    return detail::signed_distance_of_cores<S>(near.on_a, a.radius, near.on_b, S(0), distance,
                                               normalised<S>(between));
  }
  const Vector3<S>& n = widest.normal;
  Vector3<S> deepest;
  if (widest.axis < 3) {
    // The lowest point of the part of the segment above the face.
    const S from = n.dot(a.core.start);
    const S to = n.dot(a.core.end);
    const Segment<S> core = from <= to ? a.core : Segment<S>{a.core.end, a.core.start};
    deepest = detail::lowest_over_face<S>(core, b, widest.axis);
  } else {
    const int along = widest.axis - 3;
    int corner = 0;
    for (int i = 0; i < 3; ++i) {
      if (i != along && n.dot(Vector3<S>(b.axes.col(i))) > S(0)) corner |= 1 << i;
    }
    const Segment<S> edge{box_corner(b, corner), box_corner(b, corner | (1 << along))};
    const Vector2<S> at = detail::crossing_fractions(a.core, edge);
    deepest = at.x() >= S(0) ? detail::point_at<S>(a.core, at.x()) : near.on_a;
  }
  return detail::signed_distance_of_cores<S>(
      deepest, a.radius, Vector3<S>(deepest - n * widest.separation), S(0), widest.separation, n);
}
/// A box and a capsule.
template <std::floating_point S>
SignedDistance<S> signed_distance(const OrientedBox<S>& a, const Capsule<S>& b) {
  return exchanged(signed_distance(b, a));
}
// [/signed-distance-capsule-box]

// [signed-distance-boxes]
namespace detail {

/// The axis of largest separation between two boxes, of the fifteen or of some of them. axis is −1
/// if none of them has a direction. Of equal ones the first is taken, and an edge–edge axis must
/// exceed the face normals by 64 u of the sizes: faces give better contacts, and rounding must not
/// decide.
template <std::floating_point S>
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

}  // namespace detail

/// The signed distance of two boxes.
///
/// Separated boxes: the distance of their closest points. If rounding cannot distinguish its
/// direction from one of the fifteen axes, the axis is taken, which has full precision however
/// close the boxes are. Overlapping boxes: the axis of least overlap. If it is a face normal, the
/// points are the deepest of the other box over that face; if it belongs to two edges, they are the
/// closest points of these.
/// @return error of the distance: a few u of the coordinates and sizes
template <std::floating_point S>
SignedDistance<S> signed_distance(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  const detail::AxisSeparation<S> widest = detail::max_separation<S>(a, b);
  const Vector3<S>& n = widest.normal;
  const Vector3<S> far_a = a.axes.cwiseAbs() * a.half_lengths + a.centre.cwiseAbs();
  const Vector3<S> far_b = b.axes.cwiseAbs() * b.half_lengths + b.centre.cwiseAbs();
  if (widest.separation > detail::direction_threshold<S>(far_a, far_b)) {
    const ClosestPoints<S> near = closest_points<S>(a, b);
    const Vector3<S> between = near.on_a - near.on_b;
    // A direction computed from two points loses its digits if the boxes almost touch.
    const bool along = detail::length<S>(Vector3<S>(between - n * widest.separation)) <=
                       S(4) * detail::direction_threshold<S>(far_a, far_b);
    return detail::signed_distance_of_cores<S>(near.on_a, S(0), near.on_b, S(0),
                                               detail::length<S>(between),
                                               along ? n : normalised<S>(between));
  }
  if (widest.axis < 6) {
    const bool face_of_a = widest.axis < 3;
    const Vector3<S> outward = face_of_a ? Vector3<S>(-n) : n;
    const Vector3<S> deepest = face_of_a
                                   ? detail::deepest_over_face<S>(a, widest.axis, outward, b)
                                   : detail::deepest_over_face<S>(b, widest.axis - 3, outward, a);
    const Vector3<S> shift = n * widest.separation;
    if (face_of_a) return {widest.separation, n, Vector3<S>(deepest + shift), deepest};
    return {widest.separation, n, deepest, Vector3<S>(deepest - shift)};
  }
  const Segment<S> edge_a = detail::support_edge<S>(a, (widest.axis - 6) / 3, Vector3<S>(-n));
  const Segment<S> edge_b = detail::support_edge<S>(b, (widest.axis - 6) % 3, n);
  const Vector2<S> at = detail::crossing_fractions(edge_a, edge_b);
  if (at.x() >= S(0)) {
    return {widest.separation, n, detail::point_at<S>(edge_a, at.x()),
            detail::point_at<S>(edge_b, at.y())};
  }
  const ClosestPoints<S> near = closest_points<S>(edge_a, edge_b);
  return {widest.separation, n, near.on_a, near.on_b};
}
// [/signed-distance-boxes]

// [signed-distance-half-space]
/// The signed distance of points and a half-space: that of the lowest point, the first of equal
/// ones. The points of a convex hull represent the hull. With a radius, each point is a ball.
/// @param points at least one
/// @param radius m, not negative
/// @return error of the distance: a few u of the coordinates
template <std::floating_point S>
SignedDistance<S> signed_distance(const std::vector<Vector3<S>>& points, const S& radius,
                                  const HalfSpace<S>& b) {
  std::size_t lowest = 0;
  S least = signed_distance(b.boundary, points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const S other = signed_distance(b.boundary, points[i]);
    if (other < least) {
      least = other;
      lowest = i;
    }
  }
  const Vector3<S>& n = b.boundary.normal;
  return detail::signed_distance_of_cores<S>(
      points[lowest], radius, Vector3<S>(points[lowest] - n * least), S(0), least, n);
}
/// A sphere and a half-space.
template <std::floating_point S>
SignedDistance<S> signed_distance(const Sphere<S>& a, const HalfSpace<S>& b) {
  return signed_distance<S>(std::vector<Vector3<S>>{a.centre}, a.radius, b);
}
/// A capsule and a half-space: the lower end of its segment.
template <std::floating_point S>
SignedDistance<S> signed_distance(const Capsule<S>& a, const HalfSpace<S>& b) {
  return signed_distance<S>(std::vector<Vector3<S>>{a.core.start, a.core.end}, a.radius, b);
}
/// A box and a half-space: the lowest corner.
template <std::floating_point S>
SignedDistance<S> signed_distance(const OrientedBox<S>& a, const HalfSpace<S>& b) {
  std::vector<Vector3<S>> corners;
  corners.reserve(8);
  for (int k = 0; k < 8; ++k) corners.push_back(box_corner(a, k));
  return signed_distance<S>(corners, S(0), b);
}
/// A half-space and any of these.
template <std::floating_point S, template <class> class Shape>
SignedDistance<S> signed_distance(const HalfSpace<S>& a, const Shape<S>& b) {
  return exchanged(signed_distance(b, a));
}
// [/signed-distance-half-space]

}  // namespace contact
