// mistake: redefinition
// says: t

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  double t = ray.direction.norm();
  double t = 1.0;  // here
  if (t > 1.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
