#include "break_the_epsilon.hpp"

namespace exercise {

// A thin triangle: twice its area is 1e-7 square metres.
Points plane_refused() { return {{0, 0, 0}, {1, 0, 0}, {2, 1e-7, 0}}; }

// A small one: twice its area is 2.5e-7 square metres.
Points small_triangle_refused() { return {{0, 0, 0}, {0.0005, 0, 0}, {0, 0.0005, 0}}; }

// On the line y = 3x. The differences of y have two binary digits fewer after the point than those
// of x, so they are rounded otherwise. Found by trying.
Points line_accepted() {
  return {{0x1.1cp-24, 0x1.aap-23, 0}, {1585100, 4755300, 0}, {-4425136, -13275408, 0}};
}

}  // namespace exercise
