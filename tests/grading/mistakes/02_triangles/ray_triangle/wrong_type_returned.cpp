// mistake: wrong-type-returned
// says: double
// says: std::optional<contact::TriangleHit<double>>

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return ray.origin.x();  // here
}

}  // namespace exercise
