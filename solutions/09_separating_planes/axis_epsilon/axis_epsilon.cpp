#include "axis_epsilon.hpp"

namespace exercise {

// Two bars, each with an edge towards the other one, cross at a right angle. The cross product of
// these edges is 0.03 * 0.03 long, so its square is 0.81e-6 and below the threshold. No face
// separates the bars.
Pair small_gap_missed() {
  return {{0, 0, 0},     {0.03, 0, 0}, {0, 0.02, 0.02}, {0, -0.02, 0.02},
          {0, 0, 0.085}, {0, 0.03, 0}, {0.02, 0, 0.02}, {-0.02, 0, 0.02}};
}

// The same with an angle of 0.002 between the edges. The padding adds 1e-6 times four half lengths,
// and the distance is times the sine, so a gap of 4e-6 / 0.002 = 0.002 disappears.
Pair padded_gap_missed() {
  return {{0, 0, 0},      {1, 0, 0},          {0, 0.7, 0.7},       {0, -0.7, 0.7},
          {0, 0, 2.8015}, {0.99, 0.00198, 0}, {-0.0014, 0.7, 0.7}, {0.0014, -0.7, 0.7000028}};
}

// Two cubes that touch with an edge each. Their cross product has 13 digits, and the dot products
// of it with the differences of positions have 19, which no double holds.
Pair common_point_missed() {
  return {{0, 0, 0},
          {1000000, 0, 0},
          {0, 1000000, 0},
          {0, 0, 1000000},
          {-510003, -2360008, 1850005},
          {340002, 510003, 1020006},
          {510003, -1020006, 340002},
          {1020006, 340002, -510003}};
}

}  // namespace exercise
