/// @file
/// Whether a triangle and an axis-aligned box have a point in common, by thirteen separating axes:
/// rounded, as it is often written, and exact.
#pragma once

#include <algorithm>
#include <array>
#include <contact/aabb.hpp>
#include <contact/drop_dimension.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/orientation.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <utility>

namespace contact {

// [triangle-box-rounded]
/// Whether a triangle and a box have a point in common: thirteen axes, in the arithmetic of S. The
/// centre of the box is moved to the origin; then the box projects to ± its radius.
///
/// Limits: everything is doubled, so that S need not divide. All axes but the first three round,
/// and the first three round when the centre is subtracted. Touching counts as far as S can tell. A
/// box of which some edges have no length and a triangle without area are the sets of points that
/// they are. Exact if S is exact. Overflow, ∞ and NaN: no meaning; a NaN separates nothing, so a
/// triangle of NaN meets every box.
/// @param t m
/// @param box m, low ≤ high
///
/// Source: Akenine-Möller, Fast 3D Triangle-Box Overlap Testing, 2001.
template <Ring S>
bool triangle_meets_box_rounded(const Triangle<S>& t, const Aabb<S>& box) {
  const Vector3<S> centre = box.low + box.high;
  const Vector3<S> half = box.high - box.low;
  const auto doubled = [&centre](const Vector3<S>& v) { return Vector3<S>(v + v - centre); };
  const std::array<Vector3<S>, 3> at{doubled(t.a), doubled(t.b), doubled(t.c)};
  const auto separates = [&](const Vector3<S>& axis) {
    S radius(0);
    for (int k = 0; k < 3; ++k) radius = radius + (axis[k] < S(0) ? -axis[k] : axis[k]) * half[k];
    const auto [low, high] =
        std::minmax({S(axis.dot(at[0])), S(axis.dot(at[1])), S(axis.dot(at[2]))});
    return low > radius || high < -radius;
  };
  const std::array<Vector3<S>, 3> edges{at[1] - at[0], at[2] - at[1], at[0] - at[2]};
  for (int k = 0; k < 3; ++k) {
    const Vector3<S> along = Vector3<S>::Unit(k);
    if (separates(along)) return false;
    for (const Vector3<S>& edge : edges) {
      if (separates(along.cross(edge))) return false;
    }
  }
  return !separates(edges[0].cross(edges[1]));
}
// [/triangle-box-rounded]

namespace triangle_box_detail {

/// Of the rectangle from low to high, the corner that is farthest to the left of the direction from
/// p to q (farthest to the right with left = false). Nothing is rounded.
inline Vector2<double> farthest_corner(const Vector2<double>& p, const Vector2<double>& q,
                                       const Vector2<double>& low, const Vector2<double>& high,
                                       bool left) {
  return {(q.y() > p.y()) == left ? low.x() : high.x(),
          (q.x() > p.x()) == left ? high.y() : low.y()};
}

/// Whether an edge of the triangle abc of the plane has the rectangle strictly on its outer side.
/// `orientation` is that of abc. If it is 0, the triangle is a segment, of which both sides are
/// outer; its edges run in both directions, so the tests for +1 are enough. A point has no sides.
inline bool edge_separates(const std::array<Vector2<double>, 3>& at, const Vector2<double>& low,
                           const Vector2<double>& high, int orientation) {
  const bool inner_is_left = orientation >= 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector2<double>&p = at[i], &q = at[(i + 1) % 3];
    const int side = orient_2d(p, q, farthest_corner(p, q, low, high, inner_is_left));
    if (inner_is_left ? side < 0 : side > 0) return true;
  }
  return false;
}

/// Whether the plane of the triangle has the box strictly on one side. `normal` are the signs of
/// the normal's coordinates; if all are 0, there is no plane, and nothing is separated.
inline bool plane_separates(const Triangle<double>& t, const Aabb<double>& box,
                            const std::array<int, 3>& normal) {
  Vector3<double> front = box.high, back = box.low;
  for (int k = 0; k < 3; ++k) {
    if (normal[static_cast<std::size_t>(k)] < 0) std::swap(front[k], back[k]);
  }
  return orient_3d(t.a, t.b, t.c, front) < 0 || orient_3d(t.a, t.b, t.c, back) > 0;
}

/// Whether the boxes of both are apart, or an entry is not finite.
inline bool boxes_apart(const Triangle<double>& t, const Aabb<double>& box) {
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax({t.a[k], t.b[k], t.c[k]});
    if (!(low <= box.high[k] && box.low[k] <= high)) return true;
  }
  return !(all_finite(t.a) && all_finite(t.b) && all_finite(t.c) && all_finite(box.low) &&
           all_finite(box.high));
}

}  // namespace triangle_box_detail

// [triangle-box]
/// Whether a triangle and a box have a point in common, by the same thirteen axes, with the right
/// answer for every finite input.
///
/// An axis e × k, perpendicular to an edge e of the triangle and to the coordinate axis k, is the
/// normal of e in the projection along k. So the three projections decide nine axes: there, an edge
/// separates if the corner of the rectangle that is farthest inwards is still strictly outside of
/// it. Which corner that is, comparisons say, and on which side it is, `orient_2d`. The
/// orientations of the three projected triangles are the signs of the normal. They say which corner
/// of the box is farthest in front of the triangle's plane and which is farthest behind, and
/// `orient_3d` says on which side these two are.
///
/// Touching counts. A triangle without area is the segment or point that it is, and a box may be
/// flat, a segment or a point. If an entry is not finite: false.
/// @param t m
/// @param box m, low ≤ high
///
/// Source: the axes are those of Akenine-Möller 2001.
template <FloatOrDouble S>
bool triangle_meets_box(const Triangle<S>& t, const Aabb<S>& box) {
  using namespace triangle_box_detail;
  const Triangle<double> triangle{t.a.template cast<double>(), t.b.template cast<double>(),
                                  t.c.template cast<double>()};
  const Aabb<double> cell{box.low.template cast<double>(), box.high.template cast<double>()};
  if (boxes_apart(triangle, cell)) return false;
  std::array<int, 3> normal{};
  for (int k = 0; k < 3; ++k) {
    const auto flat = [k](const Vector3<double>& v) { return drop_dimension<double>(v, k); };
    const std::array<Vector2<double>, 3> at{flat(triangle.a), flat(triangle.b), flat(triangle.c)};
    const int side = orient_2d(at[0], at[1], at[2]);
    if (edge_separates(at, flat(cell.low), flat(cell.high), side)) return false;
    normal[static_cast<std::size_t>(k)] = side;
  }
  return !plane_separates(triangle, cell, normal);
}
// [/triangle-box]

}  // namespace contact
