// mistake: unknown-name
// says: distance_to_it

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  distance_to_it = ray.origin.x();  // here
  return std::nullopt;
}

}  // namespace exercise
