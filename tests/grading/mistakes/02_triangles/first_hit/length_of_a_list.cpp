// mistake: no-such-member
// says: size()
#include "first_hit.hpp"

namespace exercise {

std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles) {
  if (ray.origin.x() > 0.0 && triangles.length() == 0) return std::nullopt;  // here
  return std::nullopt;
}

}  // namespace exercise
