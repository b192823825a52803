// misconception: break-determinant-is-large
// caught by: a hit in the middle of a small triangle is missed
// seen: https://github.com/jbikker/tinybvh/pull/283
//   names details of millimetres; its example has 0.2 mm
#include "break_the_determinant.hpp"

namespace exercise {

Shot small_triangle() {
  return {{0.001, 0.001, 1}, {0, 0, -1}, {0, 0, 0}, {0.004, 0, 0}, {0, 0.004, 0}};
}

Shot short_direction() { return {{1, 1, 1}, {0, 0, -1e-8}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

Shot whole_numbers() { return {{1, 1, 0}, {0, 0, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

}  // namespace exercise
