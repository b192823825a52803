#include "ray_triangle.hpp"

namespace exercise {

// Möller and Trumbore: solve origin + t·d = a + β·e₁ + γ·e₂ for t, β and γ by Cramer's rule.
std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  //? The edges from vertex a span the plane of the triangle: every point of it is a + β·e₁ + γ·e₂.
  //? gap: triangle.c - triangle.a
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  //? Cramer's rule divides by the determinant of (−d, e₁, e₂), which is the triple product e₁·(d ×
  //? e₂).
  //? gap: ray.direction.cross(e2)
  const Eigen::Vector3d p = ray.direction.cross(e2);
  const double det = e1.dot(p);
  //? Determinant 0: the ray is parallel to the plane, or ray or triangle is degenerate.
  //? gap: det == 0
  // No tolerance: the determinant scales with the triangle, and whether the ray is parallel must
  // not depend on the size.
  if (det == 0) return std::nullopt;

  //? β is the second determinant over the first. Its bounds reject most rays before more is
  //? computed.
  //? gap: s.dot(p) / det
  const Eigen::Vector3d s = ray.origin - triangle.a;
  const double beta = s.dot(p) / det;
  if (!(beta >= 0 && beta <= 1)) return std::nullopt;

  //? The same for γ. As α = 1 − β − γ must not be negative either, the sum of β and γ is at most 1.
  //? gap: s.cross(e1)
  //? gap: beta + gamma <= 1
  const Eigen::Vector3d q = s.cross(e1);
  const double gamma = ray.direction.dot(q) / det;
  if (!(gamma >= 0 && beta + gamma <= 1)) return std::nullopt;

  //? t counts from the origin in multiples of the direction; a negative t lies behind the origin.
  //? gap: t >= 0
  const double t = e2.dot(q) / det;
  if (!(t >= 0)) return std::nullopt;
  //? The weights belong to a, b and c in this order, and their sum is 1.
  //? gap: 1 - beta - gamma
  return contact::TriangleHit<double>{t, {1 - beta - gamma, beta, gamma}};
}

}  // namespace exercise
