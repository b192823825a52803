/// @file
/// Clipping of polygons by planes: the part of a box's face that lies over a face of another box.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <vector>

#include <contact/closest_points.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [clip]
/// The part of a convex polygon with n · x ≤ k.
///
/// Vertices on the plane are kept. Where an edge crosses the plane, the new vertex lies between the
/// ends of the edge. The order of the vertices is kept.
/// @param polygon vertices in order, m
/// @return no vertex if all lie beyond the plane
/// @see Sutherland and Hodgman, *Reentrant polygon clipping*, Communications of the ACM 17 (1974)
template <Scalar S>
std::vector<Vector3<S>> clipped_polygon(const std::vector<Vector3<S>>& polygon, const Vector3<S>& n,
                                        const S& k) {
  std::vector<Vector3<S>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3<S>& here = polygon[i];
    const Vector3<S>& next = polygon[(i + 1) % polygon.size()];
    const S at_here = n.dot(here) - k;
    const S at_next = n.dot(next) - k;
    if (!(S(0) < at_here)) kept.push_back(here);
    if ((at_here < S(0) && S(0) < at_next) || (S(0) < at_here && at_next < S(0))) {
      const S whole = at_here - at_next;
      // From the end that is closer to the plane.
      const Vector3<S> edge = next - here;
      kept.push_back(Vector3<S>(here + edge * S(at_here / whole)));
    }
  }
  return kept;
}
// [/clip]

// [face]
/// The four corners of a box's face in order, and the index of each corner in box_corner().
template <Ring S>
struct BoxFace {
  std::array<Vector3<S>, 4> corners;  ///< m
  std::array<int, 4> indices{};       ///< from 0 to 7
};

/// The face of a box on the positive or negative side of an axis.
/// @param axis from 0 to 2
template <Ring S>
BoxFace<S> box_face(const OrientedBox<S>& box, int axis, bool positive) {
  const int first = 1 << ((axis + 1) % 3);
  const int second = 1 << ((axis + 2) % 3);
  const int base = positive ? 1 << axis : 0;
  BoxFace<S> face;
  face.indices = {base, base | first, base | first | second, base | second};
  for (std::size_t i = 0; i < 4; ++i) face.corners[i] = box_corner(box, face.indices[i]);
  return face;
}

/// The face of a box whose normal is closest to n: of equal ones the first of x, y and z, and the
/// negative side if n is perpendicular to the axis.
template <Ring S>
BoxFace<S> face_towards(const OrientedBox<S>& box, const Vector3<S>& n) {
  int best = 0;
  S most = n.dot(Vector3<S>(box.axes.col(0)));
  for (int i = 1; i < 3; ++i) {
    const S other = n.dot(Vector3<S>(box.axes.col(i)));
    if ((most < S(0) ? S(-most) : most) < (other < S(0) ? S(-other) : other)) {
      most = other;
      best = i;
    }
  }
  return box_face(box, best, S(0) < most);
}
// [/face]

// [over-face]
/// The part of a polygon over a face of a box: the polygon is clipped by the four planes beside the
/// face.
/// @param axis of the face, from 0 to 2; both sides of the box have the same four planes
template <Scalar S>
std::vector<Vector3<S>> polygon_over_face(std::vector<Vector3<S>> polygon,
                                          const OrientedBox<S>& box, int axis) {
  for (int k = 1; k < 3; ++k) {
    const int side = (axis + k) % 3;
    const Vector3<S> n = box.axes.col(side);
    const S middle = n.dot(box.centre);
    polygon = clipped_polygon<S>(polygon, n, S(middle + box.half_lengths(side)));
    polygon = clipped_polygon<S>(polygon, Vector3<S>(-n), S(box.half_lengths(side) - middle));
  }
  return polygon;
}
// [/over-face]

namespace detail {

/// The lowest point along n, the first of equal ones. There must be at least one point.
template <Ring S>
Vector3<S> lowest_of(const std::vector<Vector3<S>>& points, const Vector3<S>& n) {
  Vector3<S> best = points[0];
  for (const Vector3<S>& p : points) {
    if (n.dot(p) < n.dot(best)) best = p;
  }
  return best;
}

/// The deepest point over the face of `box`, of the other box's incident face (that which faces
/// against `outward`); nothing if no point is over it, as rounding may have it for boxes that touch
/// at an edge.
template <std::floating_point S>
std::optional<Vector3<S>> deepest_over_face(const OrientedBox<S>& box, int axis,
                                            const Vector3<S>& outward,
                                            const OrientedBox<S>& other) {
  const BoxFace<S> face = face_towards<S>(other, Vector3<S>(-outward));
  const std::vector<Vector3<S>> whole(face.corners.begin(), face.corners.end());
  const std::vector<Vector3<S>> over = polygon_over_face<S>(whole, box, axis);
  if (over.empty()) return std::nullopt;
  return lowest_of<S>(over, outward);
}

/// The point closest to the start of a segment, of its part over a face of a box; the start if
/// there is no such part.
template <std::floating_point S>
Vector3<S> lowest_over_face(const Segment<S>& segment, const OrientedBox<S>& box, int axis) {
  const Vector3<S> start = in_box_axes(box, segment.start);
  const Vector3<S> end = in_box_axes(box, segment.end);
  S first(0);
  S last(1);
  for (int k = 1; k < 3; ++k) {
    const int i = (axis + k) % 3;
    const S half = box.half_lengths(i);
    const S rate = end(i) - start(i);
    if (rate == S(0)) continue;
    const S one = (-half - start(i)) / rate;
    const S other = (half - start(i)) / rate;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  }
  return first <= last ? point_at<S>(segment, first) : segment.start;
}

/// The edge along a given axis of a box that is extreme along n.
template <std::floating_point S>
Segment<S> support_edge(const OrientedBox<S>& box, int axis, const Vector3<S>& n) {
  int corner = 0;
  for (int i = 0; i < 3; ++i) {
    if (i != axis && n.dot(Vector3<S>(box.axes.col(i))) > S(0)) corner |= 1 << i;
  }
  return {box_corner(box, corner), box_corner(box, corner | (1 << axis))};
}

}  // namespace detail

}  // namespace contact
