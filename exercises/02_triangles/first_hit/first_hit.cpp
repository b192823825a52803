#include "first_hit.hpp"

namespace exercise {

std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles) {
  contact::todo();
}

}  // namespace exercise
