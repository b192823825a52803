// mistake: no-such-member
// says: t
// says: barycentric

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  contact::TriangleHit<double> hit;
  hit.distance = 1.0;  // here
  return hit;
}

}  // namespace exercise
