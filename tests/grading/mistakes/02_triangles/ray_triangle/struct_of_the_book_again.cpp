// mistake: redefinition
// says: TriangleHit

#include "ray_triangle.hpp"

namespace exercise {

}  // namespace exercise

namespace contact {
template <Ring S>
struct TriangleHit {  // here
  S t;
  Vector3<S> weights;
};
}  // namespace contact

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace exercise
