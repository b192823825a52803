// misconception: break-outside-the-region
// caught by: a hit of whole numbers is missed
// seen: not found
#include "break_the_determinant.hpp"

namespace exercise {

Shot small_triangle() {
  return {{0.0001, 0.0001, 1}, {0, 0, -1}, {0, 0, 0}, {0.0004, 0, 0}, {0, 0.0004, 0}};
}

Shot short_direction() { return {{1, 1, 1}, {0, 0, -1e-8}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

Shot whole_numbers() { return {{9, 9, 1}, {0, 0, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

}  // namespace exercise
