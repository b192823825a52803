// mistake: function-missing
// says: ray_triangle

#include "ray_triangle.hpp"

namespace exercise {

double twice(double x) {
  return 2.0 * x;
}

}  // namespace exercise
