// misconception: break-area-is-large
// caught by: a plane through distant points is refused
// seen: https://github.com/bevyengine/bevy/pull/12508
//   a reviewer: nearly collinear points are above such a threshold
#include "break_the_epsilon.hpp"

namespace exercise {

Points plane_refused() { return {{0, 0, 0}, {1, 0, 0}, {2, 0.001, 0}}; }

Points small_triangle_refused() { return {{0, 0, 0}, {0.0005, 0, 0}, {0, 0.0005, 0}}; }

Points line_accepted() {
  return {{0x1.1cp-24, 0x1.aap-23, 0}, {1585100, 4755300, 0}, {-4425136, -13275408, 0}};
}

}  // namespace exercise
