// misconception: direction-normalised
// caught by: t is in multiples of the direction as it is given
// seen: https://github.com/BabylonJS/Babylon.js/pull/1783
//   a transformed ray's direction was normalised
#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d d = ray.direction.normalized();
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d p = d.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return std::nullopt;
  const Eigen::Vector3d s = ray.origin - triangle.a;
  const double beta = s.dot(p) / det;
  if (!(beta >= 0 && beta <= 1)) return std::nullopt;
  const Eigen::Vector3d q = s.cross(e1);
  const double gamma = d.dot(q) / det;
  if (!(gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
  const double t = e2.dot(q) / det;
  if (!(t >= 0)) return std::nullopt;
  return contact::TriangleHit<double>{t, {1 - beta - gamma, beta, gamma}};
}

}  // namespace exercise
