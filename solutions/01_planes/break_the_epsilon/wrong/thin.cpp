// misconception: break-outside-the-region
// caught by: a plane through a triangle without small angles is refused
// seen: https://github.com/jrouwe/JoltPhysics/pull/607 thinks of slivers where an area is compared
#include "break_the_epsilon.hpp"

namespace exercise {

Points plane_refused() { return {{0, 0, 0}, {1, 0, 0}, {2, 1e-7, 0}}; }

Points small_triangle_refused() { return {{0, 0, 0}, {1, 0, 0}, {2, 1e-7, 0}}; }

Points line_accepted() {
  return {{0x1.1cp-24, 0x1.aap-23, 0}, {1585100, 4755300, 0}, {-4425136, -13275408, 0}};
}

}  // namespace exercise
