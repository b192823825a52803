// misconception: touching-rejected
// caught by: touching an edge, a vertex or the origin counts as a hit
// seen: L20, slide "Segment vs. Triangle"
#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d p = ray.direction.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return std::nullopt;
  const Eigen::Vector3d s = ray.origin - triangle.a;
  const double beta = s.dot(p) / det;
  if (!(beta > 0 && beta < 1)) return std::nullopt;
  const Eigen::Vector3d q = s.cross(e1);
  const double gamma = ray.direction.dot(q) / det;
  if (!(gamma > 0 && beta + gamma < 1)) return std::nullopt;
  const double t = e2.dot(q) / det;
  if (!(t > 0)) return std::nullopt;
  return contact::TriangleHit<double>{t, {1 - beta - gamma, beta, gamma}};
}

}  // namespace exercise
