// mistake: assigned-to-const
// says: t
// says: const

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = 0.0;
  t = ray.direction.norm();  // here
  return std::nullopt;
}

}  // namespace exercise
