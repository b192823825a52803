#include "ray_cylinder.hpp"

namespace exercise {

std::optional<Entry> ray_cylinder(const contact::Ray<double>& /*ray*/,
                                  const Cylinder& /*cylinder*/) {
  contact::todo();
}

}  // namespace exercise
