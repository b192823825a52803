// mistake: no-such-header
// says: ray_triangel.hpp
// says: ray_triangle.hpp

#include "ray_triangle.hpp"
#include "ray_triangel.hpp"  // here

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace exercise
