// mistake: missing-include
// says: #include <iostream>

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  std::cout << ray.origin.x();  // here
  return std::nullopt;
}

}  // namespace exercise
