// misconception: first-in-list
// caught by: the nearest triangle is found wherever it stands in the list
#include "first_hit.hpp"

namespace exercise {
namespace {

// Where the ray meets one triangle: Möller and Trumbore, without the weights.
std::optional<double> place(const contact::Ray<double>& ray,
                            const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d p = ray.direction.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return std::nullopt;
  const Eigen::Vector3d s = ray.origin - triangle.a;
  const Eigen::Vector3d q = s.cross(e1);
  const double beta = s.dot(p) / det;
  const double gamma = ray.direction.dot(q) / det;
  if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
  return e2.dot(q) / det;
}

}  // namespace

std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::optional<double> t = place(ray, triangles[i]);
    if (!t || *t < 0) continue;
    return FirstHit{static_cast<int>(i), *t};
  }
  return std::nullopt;
}

}  // namespace exercise
