// misconception: break-ray-starts-away
// caught by: a hit of whole numbers is missed
// seen: https://github.com/google/vector_math.dart/pull/43
//   a glancing ray is taken for a parallel one
#include "break_the_determinant.hpp"

namespace exercise {

Shot small_triangle() {
  return {{0.0001, 0.0001, 1}, {0, 0, -1}, {0, 0, 0}, {0.0004, 0, 0}, {0, 0.0004, 0}};
}

Shot short_direction() { return {{1, 1, 1}, {0, 0, -1e-8}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

Shot whole_numbers() { return {{-1, 1, 1}, {10, 0, -9}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

}  // namespace exercise
