/// @file
/// The right answers for the exercises of this chapter. It needs no library, so it works wherever
/// the tests do.
#pragma once

#include <optional>

#include <contact/exact.hpp>
#include <contact/shapes.hpp>

namespace exact {

using Ray = contact::Ray<double>;
using Triangle = contact::Triangle<double>;
using Hit = contact::TriangleHit<double>;

/// Where a ray with these numbers meets a triangle with these numbers, rounded once at the end.
inline std::optional<Hit> exact_hit(const Ray& ray, const Triangle& triangle) {
  using contact::Exact;
  using V = contact::Vector3<Exact>;
  const V a = triangle.a.cast<Exact>();
  const V e1 = triangle.b.cast<Exact>() - a, e2 = triangle.c.cast<Exact>() - a;
  const V s = ray.origin.cast<Exact>() - a, d = ray.direction.cast<Exact>();
  const V n = e1.cross(e2);
  const Exact det = -n.dot(d);
  if (det.sign() == 0) return std::nullopt;
  const Exact t = n.dot(s), beta = e2.dot(s.cross(d)), gamma = -e1.dot(s.cross(d));
  const Exact alpha = det - beta - gamma;
  for (const Exact& x : {t, alpha, beta, gamma}) {
    if (x.sign() * det.sign() < 0) return std::nullopt;
  }
  const auto over = [&](const Exact& x) { return quotient<double>(x, det); };
  return Hit{over(t), {over(alpha), over(beta), over(gamma)}};
}

/// The ray that meets the plane of the triangle after t, where the weights are 1 - beta - gamma,
/// beta and gamma.
inline Ray aimed(const Triangle& triangle, double beta, double gamma,
                 const Eigen::Vector3d& direction, double t) {
  const Eigen::Vector3d x =
      triangle.a + beta * (triangle.b - triangle.a) + gamma * (triangle.c - triangle.a);
  return {x - t * direction, direction};
}

}  // namespace exact
