// misconception: break-outside-the-region
// caught by: a hit in the middle of a triangle of 4 m is missed
// seen: https://github.com/mrdoob/three.js/pull/33661
//   rays through an edge or a vertex are those that miss
#include "break_the_determinant.hpp"

namespace exercise {

Shot small_triangle() {
  return {{0.0001, 0.0001, 1}, {0, 0, -1}, {0, 0, 0}, {0.0004, 0, 0}, {0, 0.0004, 0}};
}

Shot short_direction() { return {{1, 0, 1}, {0, 0, -1e-8}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

Shot whole_numbers() { return {{1, 1, 0}, {0, 0, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}; }

}  // namespace exercise
