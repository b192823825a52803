/// @file
/// Barycentric coordinates: the position of a point in a triangle, and interpolation of values at
/// the vertices.
#pragma once

#include <contact/drop_dimension.hpp>
#include <contact/shapes.hpp>
#include <optional>

namespace contact {

/// The barycentric coordinates of a point in a triangle's plane: the weights of a, b and c, in that
/// order, with w_a a + w_b b + w_c c = point and w_a + w_b + w_c = 1. All three are at least 0 if
/// and only if the point is in the triangle, its edges included.
///
/// The coordinate in which the normal is largest is dropped: the triangle's projection along that
/// axis has the largest area, at least 1/√3 of the triangle's own. Dropping the smallest can leave
/// a projection without area.
///
/// @param point a point of the plane, m; for a point off the plane, the weights of its projection
/// along the dropped axis
/// @return nothing if the triangle has no area, or if its area overflows or underflows in S
///
/// Limits: each weight is off by about u (|x||e|/area), so slivers lose digits. The decision by
/// three rounded weights may be wrong (see `intersect_exact`).
///
/// Source: *Interaction and Normals*, slide "Faster Way", where α is w_b and β is w_c; the sign of
/// β is corrected here.
// [barycentric]
template <Scalar S>
std::optional<Vector3<S>> barycentric(const Vector3<S>& point, const Triangle<S>& triangle) {
  const Vector3<S> ab = triangle.b - triangle.a;
  const Vector3<S> ac = triangle.c - triangle.a;
  const Vector3<S> normal = ab.cross(ac);
  const int k = largest_dimension(normal);
  if (normal[k] == S(0) || !is_finite(normal[k])) return std::nullopt;

  const Vector3<S> ax = point - triangle.a;
  const Vector2<S> x = drop_dimension(ax, k);
  const Vector2<S> e1 = drop_dimension(ab, k);
  const Vector2<S> e2 = drop_dimension(ac, k);
  const S of_b = cross2(x, e2) / normal[k];
  const S of_c = cross2(e1, x) / normal[k];  // e1 × x, not x × e1
  const S of_a = S(1) - of_b - of_c;
  const Vector3<S> weights(of_a, of_b, of_c);
  if (!all_finite(weights)) return std::nullopt;
  return weights;
}
// [/barycentric]

/// Whether barycentric weights are those of a point in the triangle, edges and vertices included.
template <Scalar S>
bool inside(const Vector3<S>& weights) {
  return weights.x() >= S(0) && weights.y() >= S(0) && weights.z() >= S(0);
}

/// Linear interpolation of values at the vertices (temperatures, colours, normals).
/// @param weights of a, b and c
/// @return in the unit of the values
// [interpolate]
template <Scalar S, class Value>
Value interpolate(const Vector3<S>& weights, const Value& at_a, const Value& at_b,
                  const Value& at_c) {
  return weights.x() * at_a + weights.y() * at_b + weights.z() * at_c;
}
// [/interpolate]

}  // namespace contact
