// mistake: another-return-type
// says: return type

#include "ray_triangle.hpp"

namespace exercise {

bool ray_triangle(const contact::Ray<double>& ray,  // here
                  const contact::Triangle<double>& triangle) {
  return ray.direction.norm() > triangle.a.norm();
}

}  // namespace exercise
