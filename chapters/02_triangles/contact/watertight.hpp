/// @file
/// A watertight test of ray and segment against triangle: of two triangles that share an edge, at
/// least one is hit by a ray that goes between them.
#pragma once

#include <cmath>
#include <concepts>
#include <contact/barycentric.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <optional>
#include <utility>

namespace contact {

/// cross2(u, v) with the right sign unless a product over- or underflows.
///
/// Rounding is monotonic: if u.x v.y is the larger product, its rounded value is not the smaller
/// one. So the difference of the two rounded products has the right sign, or is 0. If it is 0, the
/// rounding errors of the two products decide, and a fused multiply-add gives each of them exactly.
/// Exchanging u and v gives the opposite number.
// [edge-function]
template <std::floating_point S>
S cross2_right_sign(const Vector2<S>& u, const Vector2<S>& v) {
  const S left = u.x() * v.y();
  const S right = u.y() * v.x();
  if (left != right) return left - right;
  return std::fma(u.x(), v.y(), -left) - std::fma(u.y(), v.x(), -right);
}
// [/edge-function]

/// A ray prepared for many triangles: a frame in which it starts at the origin and runs along z.
template <std::floating_point S>
class WatertightRay {
 public:
  /// @param origin m
  /// @param direction m for each unit of t; a zero direction meets nothing
  WatertightRay(const Vector3<S>& origin, const Vector3<S>& direction)
      : origin_(origin), z_(largest_dimension(direction)), x_((z_ + 1) % 3), y_((z_ + 2) % 3) {
    along_ = direction[z_];
    // A shear, not a rotation: it shifts x and y in proportion to z and maps lines to lines.
    shear_ = Vector2<S>(direction[x_], direction[y_]) / along_;
  }

  /// (d) Woop, Benthin and Wald: shear the vertices; then three two-dimensional edge functions say
  /// on which side of each edge the z axis passes.
  /// @param last the largest t that counts
  ///
  /// Limits: the shear rounds each vertex, so a hit near an edge may be assigned to the neighbour.
  /// It is not lost between the two, because both round the shared vertices alike. This holds as
  /// long as no product over- or underflows and t is not within its rounding of 0 or `last`, and
  /// only without fused multiply-adds in the shear and the edge function (`-ffp-contract=off`).
  ///
  /// Source: Woop, Benthin and Wald,
  /// Watertight Ray/Triangle Intersection, 2013.
  std::optional<TriangleHit<S>> meet(const Triangle<S>& triangle,
                                     const std::optional<S>& last) const {
    // [watertight-ray]
    if (along_ == S(0)) return std::nullopt;
    const Vector3<S> oa = triangle.a - origin_;
    const Vector3<S> ob = triangle.b - origin_;
    const Vector3<S> oc = triangle.c - origin_;
    const Vector2<S> a = sheared(oa), b = sheared(ob), c = sheared(oc);

    const S of_a = cross2_right_sign(b, c);
    const S of_b = cross2_right_sign(c, a);
    const S of_c = cross2_right_sign(a, b);
    const bool all_left = of_a >= S(0) && of_b >= S(0) && of_c >= S(0);
    const bool all_right = of_a <= S(0) && of_b <= S(0) && of_c <= S(0);
    if (!all_left && !all_right) return std::nullopt;
    const S sum = of_a + of_b + of_c;
    if (sum == S(0)) return std::nullopt;  // seen edge-on, or without area

    const Vector3<S> weights(of_a / sum, of_b / sum, of_c / sum);
    const S t = weights.dot(Vector3<S>(oa[z_], ob[z_], oc[z_])) / along_;
    if (!(t >= S(0)) || (last && t > *last)) return std::nullopt;
    return finite_hit(TriangleHit<S>{t, weights});
    // [/watertight-ray]
  }

 private:
  Vector2<S> sheared(const Vector3<S>& p) const {
    return {p[x_] - shear_.x() * p[z_], p[y_] - shear_.y() * p[z_]};
  }

  Vector3<S> origin_;
  int z_, x_, y_;
  S along_;
  Vector2<S> shear_;
};

/// (d) for one ray and one triangle. For many triangles, make the WatertightRay once.
template <std::floating_point S>
std::optional<TriangleHit<S>> intersect_watertight(const Ray<S>& ray, const Triangle<S>& triangle) {
  return WatertightRay<S>(ray.origin, ray.direction).meet(triangle, std::nullopt);
}

/// (d) for a segment: t is from 0 to 1.
template <std::floating_point S>
std::optional<TriangleHit<S>> intersect_watertight(const Segment<S>& segment,
                                                   const Triangle<S>& triangle) {
  return WatertightRay<S>(segment.start, segment.end - segment.start).meet(triangle, S(1));
}

}  // namespace contact
