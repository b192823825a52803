/// @file
/// Ray and segment against triangle by three rounded methods. They differ in their rounding errors;
/// none is right for every input, and none uses a tolerance.
///
/// All count touching as a hit, from either side of the triangle. A ray in the triangle's plane, a
/// zero direction and a triangle without area have no single meeting point, so they give no hit.
/// With an exact field for S, such as the rationals, each is exact.
#pragma once

#include <concepts>
#include <contact/barycentric.hpp>
#include <contact/shapes.hpp>
#include <optional>

namespace contact {

/// A Ray or a Segment of S.
template <class Line, class S>
concept LineOf = std::same_as<Line, Ray<S>> || std::same_as<Line, Segment<S>>;

/// The hit, or nothing if an intermediate result overflowed.
template <Scalar S>
std::optional<TriangleHit<S>> finite_hit(const TriangleHit<S>& hit) {
  if (!is_finite(hit.t) || !all_finite(hit.barycentric)) return std::nullopt;
  return hit;
}

// [cross-plane]
/// Where a segment crosses the plane through a point: the signed distances of its ends have
/// opposite signs, or one is 0.
/// @param normal any normal of the plane; both distances are multiplied by its length, which
/// cancels in their ratio
/// @return nothing if both ends are on one side, or both in the plane
///
/// Source: *Interaction and Normals*, slide "Segment vs. Triangle".
template <Scalar S>
std::optional<RayHit<S>> cross_plane(const Segment<S>& segment, const Vector3<S>& on_plane,
                                     const Vector3<S>& normal) {
  const S start_distance = normal.dot(segment.start - on_plane);
  const S end_distance = normal.dot(segment.end - on_plane);
  if (start_distance > S(0) && end_distance > S(0)) return std::nullopt;
  if (start_distance < S(0) && end_distance < S(0)) return std::nullopt;
  if (start_distance == end_distance) return std::nullopt;
  const S t = start_distance / (start_distance - end_distance);
  return RayHit<S>{t, segment.start + t * (segment.end - segment.start)};
}

/// Where a ray crosses the plane through a point: distance over rate of approach.
/// @return nothing if the ray is parallel to the plane or points away from it
template <Scalar S>
std::optional<RayHit<S>> cross_plane(const Ray<S>& ray, const Vector3<S>& on_plane,
                                     const Vector3<S>& normal) {
  const S rate = normal.dot(ray.direction);
  if (rate == S(0)) return std::nullopt;
  const S t = normal.dot(on_plane - ray.origin) / rate;
  if (!(t >= S(0))) return std::nullopt;
  return RayHit<S>{t, ray.origin + t * ray.direction};
}
// [/cross-plane]

/// (a) Signed distances, then edge tests: find the point in the plane, and test for each edge
/// whether it is on the inner side.
/// @param line a Ray or a Segment
///
/// Limits: the point is rounded before the edge tests, so two triangles that share an edge can both
/// reject a ray between them. t is off by a few u (Σ|terms of N| + |t| Σ|terms of D|) / |D|, where
/// N and D are the numerator and the denominator of t; the decision has no error bound.
///
/// Source: *Interaction and Normals*, slide "Segment vs. Triangle".
// [edge-tests]
template <Scalar S, LineOf<S> Line>
std::optional<TriangleHit<S>> intersect_by_edges(const Line& line, const Triangle<S>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3<S> normal = (b - a).cross(c - a);
  const std::optional<RayHit<S>> crossing = cross_plane(line, a, normal);
  if (!crossing) return std::nullopt;

  // normal × edge points into the triangle. Each product is |normal| times twice the area of the
  // triangle of that edge and x.
  const Vector3<S>& x = crossing->point;
  const S beyond_bc = normal.cross(c - b).dot(x - b);
  const S beyond_ca = normal.cross(a - c).dot(x - c);
  const S beyond_ab = normal.cross(b - a).dot(x - a);
  if (!(beyond_bc >= S(0) && beyond_ca >= S(0) && beyond_ab >= S(0))) return std::nullopt;

  const S all = normal.dot(normal);
  if (all == S(0)) return std::nullopt;
  return finite_hit(
      TriangleHit<S>{crossing->t, {beyond_bc / all, beyond_ca / all, beyond_ab / all}});
}
// [/edge-tests]

// [dropped-dimension]
/// (b) The same point, tested in two dimensions: its barycentric coordinates after the largest
/// dimension is dropped.
/// @param line a Ray or a Segment
///
/// Limits: as for intersect_by_edges.
///
/// Source: *Interaction and Normals*, slide "Faster Way".
template <Scalar S, LineOf<S> Line>
std::optional<TriangleHit<S>> intersect_by_dropping(const Line& line, const Triangle<S>& triangle) {
  const Vector3<S> normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const std::optional<RayHit<S>> crossing = cross_plane(line, triangle.a, normal);
  if (!crossing) return std::nullopt;
  const std::optional<Vector3<S>> weights = barycentric(crossing->point, triangle);
  if (!weights || !inside(*weights)) return std::nullopt;
  return finite_hit(TriangleHit<S>{crossing->t, *weights});
}
// [/dropped-dimension]

/// A hit before any division: t and the weights of b and c are these numbers over `denominator`,
/// which is positive.
template <Ring S>
struct TriangleFractions {
  /// t times the denominator.
  S t;
  /// The weight of b times the denominator.
  S of_b;
  /// The weight of c times the denominator.
  S of_c;
  /// Positive: the magnitude of direction · normal.
  S denominator;
};

/// The decision of (c), without a division, so that it also works for exact types without one.
/// @param origin, direction of the ray; t is in multiples of the direction
/// @param last the largest t that counts, for a segment 1; nothing for a ray
template <Ring S>
std::optional<TriangleFractions<S>> moller_trumbore_fractions(const Vector3<S>& origin,
                                                              const Vector3<S>& direction,
                                                              const std::optional<S>& last,
                                                              const Triangle<S>& triangle) {
  // [fractions]
  const Vector3<S> ab = triangle.b - triangle.a;
  const Vector3<S> ac = triangle.c - triangle.a;
  const Vector3<S> p = direction.cross(ac);
  const S determinant = ab.dot(p);  // −direction · (ab × ac)
  if (determinant == S(0)) return std::nullopt;
  const S sign = determinant < S(0) ? S(-1) : S(1);
  const S denominator = sign * determinant;

  const Vector3<S> s = sign * (origin - triangle.a);
  const S of_b = s.dot(p);
  if (of_b < S(0) || of_b > denominator) return std::nullopt;
  const Vector3<S> q = s.cross(ab);
  const S of_c = direction.dot(q);
  if (of_c < S(0) || of_b + of_c > denominator) return std::nullopt;
  const S t = ac.dot(q);
  if (t < S(0) || (last && t > *last * denominator)) return std::nullopt;
  return TriangleFractions<S>{t, of_b, of_c, denominator};
  // [/fractions]
}

/// The hit with these fractions.
template <Scalar S>
std::optional<TriangleHit<S>> divide(const std::optional<TriangleFractions<S>>& hit) {
  if (!hit) return std::nullopt;
  const S of_b = hit->of_b / hit->denominator;
  const S of_c = hit->of_c / hit->denominator;
  return finite_hit(TriangleHit<S>{hit->t / hit->denominator, {S(1) - of_b - of_c, of_b, of_c}});
}

// [moller-trumbore]
/// (c) Möller and Trumbore: solve origin + t direction = a + w_b (b − a) + w_c (c − a) for t, w_b
/// and w_c by Cramer's rule. The plane's normal and the point are never formed.
///
/// Limits: while nothing over- or underflows, each of the four determinants is off by at most γ(8)
/// Σ|its terms|, so t, a quotient N / D of two of them, is off by at most 10 u (Σ|terms of N| + |t|
/// Σ|terms of D|) / |D|, unless |D| is not much larger than its rounding error. The decision has no
/// error bound, and rays can leak at a shared edge, because the two triangles measure from
/// different vertices.
///
/// Source: Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997; *Interaction
/// and Normals*, slide "Ray Basics", marks it as the best.
template <Scalar S>
std::optional<TriangleHit<S>> intersect_moller_trumbore(const Ray<S>& ray,
                                                        const Triangle<S>& triangle) {
  return divide(moller_trumbore_fractions<S>(ray.origin, ray.direction, std::nullopt, triangle));
}

/// (c) for a segment: the direction is the whole segment, so t is from 0 to 1.
template <Scalar S>
std::optional<TriangleHit<S>> intersect_moller_trumbore(const Segment<S>& segment,
                                                        const Triangle<S>& triangle) {
  return divide(
      moller_trumbore_fractions<S>(segment.start, segment.end - segment.start, S(1), triangle));
}
// [/moller-trumbore]

}  // namespace contact
