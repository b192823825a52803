/// @file
/// Ray and segment against triangle so that a mesh has no cracks: of two triangles that share an
/// edge, at least one takes a ray that goes between them.
#pragma once

#include <cmath>
#include <concepts>
#include <contact/barycentric.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <optional>
#include <utility>

namespace contact {

// [edge-function]
/// cross2(u, v) with the right sign, always, unless a product over- or underflows.
///
/// Rounding keeps order: if u.x v.y is the larger product, its rounded value is not the smaller
/// one. So the difference of the two rounded products has the right sign, or is 0. When it is 0,
/// the two products' own rounding errors decide, and a fused multiply-add gives each of them
/// exactly. Exchanging u and v gives the same number with the other sign.
template <std::floating_point S>
S cross2_right_sign(const Vector2<S>& u, const Vector2<S>& v) {
  const S left = u.x() * v.y();
  const S right = u.y() * v.x();
  if (left != right) return left - right;
  return std::fma(u.x(), v.y(), -left) - std::fma(u.y(), v.x(), -right);
}
// [/edge-function]

// [watertight-ray]
/// A ray, made ready for many triangles: a frame in which it starts at the origin and runs along z.
template <std::floating_point S>
class WatertightRay {
 public:
  /// @param origin m
  /// @param direction m for each unit of t; a zero direction meets nothing
  WatertightRay(const Vector3<S>& origin, const Vector3<S>& direction)
      : origin_(origin), z_(largest_dimension(direction)), x_((z_ + 1) % 3), y_((z_ + 2) % 3) {
    along_ = direction[z_];
    // A shear, not a rotation: it moves x and y in proportion to z, and keeps straight lines
    // straight.
    shear_ = Vector2<S>(direction[x_], direction[y_]) / along_;
  }

  /// (d) Woop, Benthin and Wald: shear the corners, then ask three flat edge functions on which
  /// side the z axis passes.
  /// @param last the largest t that counts
  ///
  /// Limits: the shear rounds each corner, so a hit near an edge may be given to the neighbour:
  /// wrong by itself, yet never lost between the two, since both round the shared corners alike.
  /// That holds as long as no product over- or underflows and t is not within its rounding of 0 or
  /// `last`, and only without fused multiply-adds in the shear and the edge function
  /// (`-ffp-contract=off`).
  ///
  /// Source: Woop, Benthin and Wald,
  /// Watertight Ray/Triangle Intersection, 2013.
  std::optional<TriangleHit<S>> meet(const Triangle<S>& triangle,
                                     const std::optional<S>& last) const {
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
// [/watertight-ray]

/// (d) for one ray and one triangle. For many triangles, make the WatertightRay once.
template <std::floating_point S>
std::optional<TriangleHit<S>> intersect_watertight(const Ray<S>& ray, const Triangle<S>& triangle) {
  return WatertightRay<S>(ray.origin, ray.direction).meet(triangle, std::nullopt);
}

/// (d) for a segment: t runs from 0 to 1.
template <std::floating_point S>
std::optional<TriangleHit<S>> intersect_watertight(const Segment<S>& segment,
                                                   const Triangle<S>& triangle) {
  return WatertightRay<S>(segment.start, segment.end - segment.start).meet(triangle, S(1));
}

}  // namespace contact
