/// @file
/// A polygon in a plane of space, and a segment (a movement vector) that passes through it: by
/// dropping a dimension, and by exact signs.
#pragma once

#include <cmath>
#include <contact/point_in_polygon.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <optional>
#include <vector>

namespace contact {

/// A closed polygon in space: vertices in order, in one plane or nearly so; seen from its front
/// they are counter-clockwise.
template <Ring S>
using SpacePolygon = std::vector<Vector3<S>>;

// [newell]
/// The area vector of a polygon in space, m²: its length is twice the area, and it points to the
/// front (Newell's formula). Zero for a polygon without area; of a self-crossing one, regions that
/// wind in opposite directions cancel.
///
/// It is the sum of the vertices' cross products, so vertices that are not quite in one plane are
/// averaged. Taken relative to the first vertex, the distance from the origin costs no digits.
///
/// Limits: rounded, so a polygon without area can have a vector that is not quite zero; fewer than
/// three vertices give zero. Overflow, or a coordinate that is not finite, gives entries that are
/// ±∞ or NaN.
///
/// Source: Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface Algorithms,
/// 1974, for Newell's formula.
template <Ring S>
Vector3<S> doubled_area_vector(const SpacePolygon<S>& polygon) {
  Vector3<S> sum(S(0), S(0), S(0));
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector3<S> to_last = polygon[i - 1] - polygon[0], to_this = polygon[i] - polygon[0];
    sum = sum + to_last.cross(to_this);
  }
  return sum;
}
// [/newell]

/// All vertices with coordinate k dropped (`drop_dimension`), so that a polygon whose area vector
/// has a positive coordinate k is counter-clockwise. No vertices stay none; coordinates are copied,
/// finite or not.
/// @param k 0, 1 or 2
template <Ring S>
Polygon<S> drop_dimension(const SpacePolygon<S>& polygon, int k) {
  Polygon<S> dropped;
  dropped.reserve(polygon.size());
  for (const Vector3<S>& v : polygon) dropped.push_back(drop_dimension<S>(v, k));
  return dropped;
}

/// Where a segment passes through a polygon in space.
template <Scalar S>
struct SpacePolygonHit {
  S t = S(0);                             ///< fraction of the segment, 0 to 1
  Vector3<S> point = Vector3<S>::Zero();  ///< m
  Where where = Where::inside;            ///< inside, or on an edge or vertex
};

// [by-dropping]
/// The lecture's method: the point in the polygon's plane; then, without the coordinate in which
/// the normal is largest, a point and a polygon of the plane.
///
/// Nothing if the segment does not reach the plane or lies in it (so for one of length 0), if the
/// point is outside, for an area vector that is 0 as rounded, and if a coordinate is not finite.
///
/// Limits: the point is rounded before the test, so the answer is exact for a point that is off by
/// a few ulps: close to an edge, inside, on and outside may be exchanged, and a segment can pass
/// between two polygons that share an edge. An area vector that overflows, or underflows to
/// 0, gives nothing; distances that overflow can give a point far from the plane.
///
/// Source: *Interaction and Normals*, slides "Ray Basics" and "Faster Way".
template <std::floating_point S>
std::optional<SpacePolygonHit<S>> intersect_polygon_by_dropping(const Segment<S>& segment,
                                                                const SpacePolygon<S>& polygon,
                                                                Rule rule = Rule::even_odd) {
  const Vector3<S> normal = doubled_area_vector(polygon);
  const int k = largest_dimension<S>(normal);
  if (normal[k] == S(0) || !all_finite(normal)) return std::nullopt;
  const std::optional<RayHit<S>> hit = cross_plane<S>(segment, polygon[0], normal);
  if (!hit || !all_finite(hit->point)) return std::nullopt;
  const Where found = where(drop_dimension<S>(polygon, k), drop_dimension<S>(hit->point, k), rule);
  if (found == Where::outside) return std::nullopt;
  return SpacePolygonHit<S>{hit->t, hit->point, found};
}
// [/by-dropping]

namespace space_detail {

/// The distance of a point from the polygon's plane times the length of the area vector: the plane
/// goes through the first vertex. In double with a bound, and exactly.
template <std::floating_point S>
class PlaneSide {
 public:
  /// Keeps a reference to the polygon.
  explicit PlaneSide(const SpacePolygon<S>& polygon) : polygon_(polygon) {}

  /// The value at p with its bound: each tetrahedron's, and for each of n additions half an ulp of
  /// a partial sum.
  Bounded roughly(const Vector3<double>& p) const {
    double value = 0, bound = 0, magnitude = 0;
    for (std::size_t i = 2; i < polygon_.size(); ++i) {
      const Vector3<double> o = at(0);
      const Bounded part = bounded_volume(p - o, at(i - 1) - o, at(i) - o);
      value += part.value;
      bound += part.bound;
      magnitude += std::abs(part.value);
    }
    const double rounding =
        static_cast<double>(polygon_.size()) * std::numeric_limits<double>::epsilon();
    return {value, (bound + magnitude * rounding) * (1 + 2 * rounding)};
  }

  /// The value at p.
  Exact exactly(const Vector3<double>& p) const {
    SpacePolygon<Exact> exact;
    for (std::size_t i = 0; i < polygon_.size(); ++i) exact.push_back(in_exact(at(i)));
    const Vector3<Exact> from = in_exact(p) - exact[0];
    return doubled_area_vector<Exact>(exact).dot(from);
  }

  /// Its sign.
  int sign(const Vector3<double>& p) const {
    const int certain = roughly(p).certain_sign();
    return certain != 0 ? certain : exactly(p).sign();
  }

 private:
  const SpacePolygon<S>& polygon_;

  Vector3<double> at(std::size_t i) const { return polygon_[i].template cast<double>(); }
  static Vector3<Exact> in_exact(const Vector3<double>& v) {
    return {Exact(v.x()), Exact(v.y()), Exact(v.z())};
  }
};

/// How often the polygon winds around the line from start to end; nothing if the line meets an
/// edge.
///
/// As `winding_number`, with a half-plane that the line bounds in the role of the level: it
/// contains the axis k. On which side of its plane a vertex is, is an orientation in the plane
/// without coordinate k; on which side of the line an edge passes, an orientation in space.
inline std::optional<int> winding_number(const Vector3<double>& start, const Vector3<double>& end,
                                         const std::vector<Vector3<double>>& polygon) {
  // [winding-in-space]
  int k = 0;  // the coordinate in which the line advances least: the other two are not both 0
  const Vector3<double> along = (end - start).cwiseAbs();
  if (along[1] < along[k]) k = 1;
  if (along[2] < along[k]) k = 2;
  const auto side_without = [&](int dropped, const Vector3<double>& v) {
    return polygon_detail::side(drop_dimension<double>(start, dropped),
                                drop_dimension<double>(end, dropped),
                                drop_dimension<double>(v, dropped));
  };
  int winding = 0;
  const Vector3<double>* a = &polygon.back();
  int side_a = side_without(k, *a);
  for (const Vector3<double>& b : polygon) {
    const int side_b = side_without(k, b);
    if ((side_a > 0) != (side_b > 0)) {
      const int passes = orient_3d(start, end, *a, b);
      if (passes == 0) return std::nullopt;
      if ((passes > 0) == (side_b > 0)) winding += side_b > 0 ? 1 : -1;
    } else if (side_a == 0 || side_b == 0) {
      // In the plane of the half-plane, or with one end in it: the line may pass through an end or
      // along the edge.
      if (side_b == 0 && are_collinear(start, end, b)) return std::nullopt;
      if (side_a == 0 && side_b == 0) {
        const int other = (along[(k + 1) % 3] > along[(k + 2) % 3]) ? (k + 2) % 3 : (k + 1) % 3;
        if (side_without(other, *a) * side_without(other, b) < 0) return std::nullopt;
      }
    }
    a = &b;
    side_a = side_b;
  }
  return winding;
  // [/winding-in-space]
}

}  // namespace space_detail

// [exact-in-space]
/// Whether and where a segment passes through a polygon in space, decided without rounding.
///
/// The plane goes through the first vertex with the area vector as its normal. The segment has to
/// reach it, and the polygon has to wind around the segment's line. For a planar polygon this is
/// the question; if the rounded vertices are not quite in one plane, a line still cannot pass
/// between two polygons that share an edge, because the edge has one side for both. Nothing if the
/// segment does not reach the plane or lies in it, for a polygon without area, and if a coordinate
/// is not finite.
///
/// Limits: the decision is right for every finite input; t is off by at most 2^-40, the point by
/// 2^-40 of the segment's length and a few ulps.
template <std::floating_point S>
std::optional<SpacePolygonHit<S>> intersect_polygon(const Segment<S>& segment,
                                                    const SpacePolygon<S>& polygon,
                                                    Rule rule = Rule::even_odd) {
  if (polygon.size() < 3 || !all_finite(segment.start) || !all_finite(segment.end)) {
    return std::nullopt;
  }
  std::vector<Vector3<double>> vertices;
  for (const Vector3<S>& v : polygon) {
    if (!all_finite(v)) return std::nullopt;
    vertices.push_back(v.template cast<double>());
  }
  const Vector3<double> start = segment.start.template cast<double>();
  const Vector3<double> end = segment.end.template cast<double>();
  const space_detail::PlaneSide<S> plane(polygon);
  const int at_start = plane.sign(start), at_end = plane.sign(end);
  if (at_start * at_end > 0 || (at_start == 0 && at_end == 0)) return std::nullopt;

  const std::optional<int> winding = space_detail::winding_number(start, end, vertices);
  if (winding && (rule == Rule::non_zero ? *winding == 0 : *winding % 2 == 0)) return std::nullopt;
  SpacePolygonHit<S> hit;
  hit.where = winding ? Where::inside : Where::on;

  const Bounded d0 = plane.roughly(start), d1 = plane.roughly(end);
  const double length = std::abs(d0.value) + std::abs(d1.value);  // opposite signs, if certain
  double t = std::abs(d0.value) / length;
  if (d0.certain_sign() * d1.certain_sign() == 0 || !(d0.bound + d1.bound <= 0x1p-42 * length)) {
    const Exact from_start = abs(plane.exactly(start));
    t = quotient<double>(from_start, from_start + abs(plane.exactly(end)));
  }
  hit.t = static_cast<S>(t);
  hit.point = ((1 - t) * start + t * end).template cast<S>();
  return hit;
}
// [/exact-in-space]

}  // namespace contact
