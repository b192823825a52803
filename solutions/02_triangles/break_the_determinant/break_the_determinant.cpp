#include "break_the_determinant.hpp"

namespace exercise {

// The determinant is twice the area, 1.6e-7.
Shot small_triangle() {
  return {{0.0001, 0.0001, 1}, {0, 0, -1}, {0, 0, 0}, {0.0004, 0, 0}, {0, 0.0004, 0}};
}

// The determinant is 16 times the length of the direction.
Shot short_direction() { return {{1, 1, 1}, {0, 0, -1e-8}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

// The ray starts on the triangle, at t = 0.
Shot whole_numbers() { return {{1, 1, 0}, {0, 0, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

}  // namespace exercise
