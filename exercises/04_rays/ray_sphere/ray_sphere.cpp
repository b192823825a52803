#include "ray_sphere.hpp"

namespace exercise {

std::optional<Inside> ray_sphere(const contact::Ray<double>& /*ray*/,
                                 const contact::Sphere<double>& /*sphere*/) {
  contact::todo();
}

}  // namespace exercise
