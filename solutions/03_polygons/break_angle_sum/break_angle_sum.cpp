#include "break_angle_sum.hpp"

namespace exercise {

// 1 m below a side of 2000 m: the triangle is seen under almost half a turn, and the sum is twice
// that.
Query outside_a_triangle() { return {{{-1000, 0}, {1000, 0}, {0, 1000}}, {0, -1}}; }

// In the notch of an arrowhead: the edges of the notch go back, and count as if they went on.
Query outside_a_quadrilateral() { return {{{0, 10}, {-10, -10}, {0, 0}, {10, -10}}, {0, -2}}; }

// Three edges that are seen under almost half a turn each.
Query outside_the_bounding_box() {
  return {{{-10, 0}, {10, 0}, {-9, 1}, {10, 2}, {-10, 2}}, {0, -1}};
}

}  // namespace exercise
