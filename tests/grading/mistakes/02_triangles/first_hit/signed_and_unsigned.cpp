// mistake: signed-compared
// says: int

#include "first_hit.hpp"

namespace exercise {

std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles) {
  for (int i = 0; i < triangles.size(); ++i) {  // here
    if (ray.direction.norm() == 0.0) return FirstHit{i, 0.0};
  }
  return std::nullopt;
}

}  // namespace exercise
