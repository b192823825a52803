// mistake: wrong-type-passed
// says: Vector3<double>
// says: double

#include "ray_triangle.hpp"

namespace exercise {

double twice(double x) { return 2.0 * x; }

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (twice(ray.direction) > 1.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
