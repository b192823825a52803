#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  // Use ray.origin, ray.direction, triangle.a, triangle.b, triangle.c. `u.dot(v)` and `u.cross(v)`
  // are the products. A hit is written `return contact::TriangleHit<double>{t, {alpha, beta,
  // gamma}};`, a miss `return std::nullopt;`.
  contact::todo();
}

}  // namespace exercise
