// misconception: division-by-zero
// caught by: a parallel ray, a direction of length zero and a triangle without area give no hit
// seen: https://github.com/assimp/assimp/pull/456 weights are divided by an area of zero
#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d n = e1.cross(e2);
  const double t = n.dot(triangle.a - ray.origin) / n.dot(ray.direction);
  if (t < 0) return std::nullopt;
  const Eigen::Vector3d x = ray.origin + t * ray.direction - triangle.a;
  const double beta = n.dot(x.cross(e2)) / n.squaredNorm();
  const double gamma = n.dot(e1.cross(x)) / n.squaredNorm();
  if (beta < 0 || gamma < 0 || beta + gamma > 1) return std::nullopt;
  return contact::TriangleHit<double>{t, {1 - beta - gamma, beta, gamma}};
}

}  // namespace exercise
