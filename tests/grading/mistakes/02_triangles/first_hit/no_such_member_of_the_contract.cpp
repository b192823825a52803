// mistake: no-such-member
// says: index
// says: t

#include "first_hit.hpp"

namespace exercise {

std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles) {
  if (triangles.empty() || ray.direction.norm() == 0.0) return std::nullopt;
  FirstHit hit;
  hit.number = 0;  // here
  return hit;
}

}  // namespace exercise
