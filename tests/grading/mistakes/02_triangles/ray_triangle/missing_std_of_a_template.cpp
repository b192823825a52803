// mistake: missing-std
// says: std::vector

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  vector<double> distances;  // here
  distances.push_back(1.0);
  return std::nullopt;
}

}  // namespace exercise
