/// @file
/// A point and a convex polygon: by dot products with the edges' normals, as the lecture does it,
/// and by bisection.
///
/// All three functions expect a convex polygon that is counter-clockwise (`is_convex`,
/// `area_sign`).
#pragma once

#include <contact/polygon.hpp>

namespace contact {

// [where-by-edges]
/// Where p is, by dot products: for each edge, the sign of p's distance from its line, along the
/// normal that points into the polygon.
///
/// Limits: rounded, a point close to an edge can be put on the wrong side or on the edge; it may be
/// wrong within about 4u (|edge| |p − a|) of the edge. Exact for S = Exact or the rationals. No
/// vertices give outside. A polygon without area has its whole line as `on`; one of equal vertices,
/// the whole plane. A repeated vertex makes inside points `on`: an edge of length 0 has distance 0
/// from every point. NaN gives outside, as does a point that is not finite. Overflow can make any
/// answer wrong, and underflow can give `on`.
///
/// Source: *Interaction and Normals*, slide "Ray Basics".
template <Ring S>
Where where_by_edges(const Polygon<S>& polygon, const Vector2<S>& p) {
  if (polygon.empty()) return Where::outside;
  Where where = Where::inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<S>& a = polygon[i];
    const Vector2<S> edge = polygon[(i + 1) % polygon.size()] - a;
    const Vector2<S> inward(-edge.y(), edge.x());
    const S distance = inward.dot(p - a);  // times the edge's length
    if (!(distance >= S(0))) return Where::outside;
    if (distance == S(0)) where = Where::on;
  }
  return where;
}
// [/where-by-edges]

/// `where_by_edges` with exact signs.
///
/// Right for every finite input. Repeated vertices do no harm. A polygon whose vertices are
/// collinear has no inside: the point is on it or outside. No vertices, or a point that is not
/// finite: outside.
template <std::floating_point S>
Where where_by_edges_exact(const Polygon<S>& polygon, const Vector2<S>& p) {
  if (!all_finite(p)) return Where::outside;
  bool on = false, has_area = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<S>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const int side = polygon_detail::side(a, b, p);
    if (side < 0) return Where::outside;
    if (side > 0) has_area = true;
    if (side == 0 && polygon_detail::in_box(a, b, p)) on = true;
    // On the line of an edge and beyond its ends: another edge of a convex polygon has it outside,
    // unless there is no area.
  }
  return on ? Where::on : has_area ? Where::inside : Where::outside;
}

namespace polygon_detail {

/// Where p is, on the line of the edge that leaves the first vertex or, if not that, of the edge
/// that arrives there. Vertices that follow on the line extend the edge; bisection finds the last.
template <std::floating_point S>
Where where_on_first_edges(const Polygon<S>& polygon, const Vector2<S>& p, bool leaving) {
  const std::size_t n = polygon.size();
  const Vector2<S>& first = polygon[0];
  const auto forward = [&first](const Vector2<S>& v) {
    return v.x() > first.x() || (v.x() == first.x() && v.y() > first.y());
  };
  // If the first vertex is inside a straight edge, p may be on the other half of the line.
  const std::size_t end = leaving && forward(p) == forward(polygon[1]) ? 1 : n - 1;
  if (forward(p) != forward(polygon[end])) return Where::outside;
  const auto extends = [&](std::size_t i) {
    return side(first, polygon[end], polygon[i]) == 0 &&
           forward(polygon[i]) == forward(polygon[end]);
  };
  std::size_t on = end, off = n - end;  // 1 and n − 1, or the other way round
  while (on + 1 != off && off + 1 != on) {
    const std::size_t middle = (on + off) / 2;
    (extends(middle) ? on : off) = middle;
  }
  return in_box(first, polygon[on], p) ? Where::on : Where::outside;
}

}  // namespace polygon_detail

// [where-by-bisection]
/// Where p is, in O(log n): bisection finds the triangle of the fan around the first vertex whose
/// angle contains p, and the edge opposite to the first vertex decides.
///
/// Right for every finite input. A point that is not finite is outside; so is any point if the
/// polygon has fewer than three vertices. Without area, or with a repeated vertex, points of the
/// polygon can be outside.
///
/// @param polygon convex, counter-clockwise, without repeated vertices (`without_repeats`);
/// vertices on a straight edge are allowed
template <std::floating_point S>
Where where_by_bisection(const Polygon<S>& polygon, const Vector2<S>& p) {
  const std::size_t n = polygon.size();
  if (n < 3 || !all_finite(p)) return Where::outside;
  const Vector2<S>& first = polygon[0];
  const auto side_of = [&](std::size_t i) { return polygon_detail::side(first, polygon[i], p); };
  const int right = side_of(1), left = side_of(n - 1);
  if (right < 0 || left > 0) return Where::outside;  // outside of the angle at the first vertex
  if (p == first) return Where::on;
  if (right == 0 || left == 0) return polygon_detail::where_on_first_edges(polygon, p, right == 0);
  std::size_t low = 1, high = n - 1;  // p is left of the diagonal to low, and right of that to high
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    (side_of(middle) >= 0 ? low : high) = middle;
  }
  const int beyond = polygon_detail::side(polygon[low], polygon[high], p);
  return beyond < 0 ? Where::outside : beyond == 0 ? Where::on : Where::inside;
}
// [/where-by-bisection]

}  // namespace contact
