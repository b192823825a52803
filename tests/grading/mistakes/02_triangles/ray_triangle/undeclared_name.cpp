// mistake: unknown-name
// says: alpha_weight

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = 1.0;
  return contact::TriangleHit<double>{t, {alpha_weight, 0.0, 1.0}};  // here
}

}  // namespace exercise
