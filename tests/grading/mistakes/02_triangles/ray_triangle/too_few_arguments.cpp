// mistake: wrong-argument-count
// says: product
// says: 2

#include "ray_triangle.hpp"

namespace exercise {

double product(double x, double y) { return y * x; }

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (product(1.0) > 1.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
