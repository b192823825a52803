// mistake: uninitialised
// says: t

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  double t;
  if (t > ray.origin.x()) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
