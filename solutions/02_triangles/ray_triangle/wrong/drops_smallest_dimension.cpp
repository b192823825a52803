// misconception: drops-smallest-dimension
// caught by: a triangle is hit in every orientation
// seen: L20, slide "Faster Way"
#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d n = e1.cross(e2);
  const double slope = n.dot(ray.direction);
  if (slope == 0) return std::nullopt;
  const double t = n.dot(triangle.a - ray.origin) / slope;
  if (t < 0) return std::nullopt;

  int dropped = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(n[k]) < std::abs(n[dropped])) dropped = k;
  }
  const int i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  const Eigen::Vector3d x = ray.origin + t * ray.direction - triangle.a;
  const double area = e1[i] * e2[j] - e1[j] * e2[i];
  const double beta = (x[i] * e2[j] - x[j] * e2[i]) / area;
  const double gamma = (e1[i] * x[j] - e1[j] * x[i]) / area;
  if (beta < 0 || gamma < 0 || beta + gamma > 1) return std::nullopt;
  return contact::TriangleHit<double>{t, {1 - beta - gamma, beta, gamma}};
}

}  // namespace exercise
