#include "interval_overlap.hpp"

namespace exercise {

// pq crosses z = 0 at (2/3, -4/3, 0), which is on bc. Along x the code computes this point as
// -8 + 13 · 2/3 and as 8 - 11 · 2/3, which are rounded differently.
Pair common_point_missed() {
  return {{0, 0, 0}, {8, 0, 0}, {-3, -2, 0}, {-8, 2, 2}, {5, -3, -1}, {5, 9, 5}};
}

// The normals have the length 10⁻⁴, and the distances are 5·10⁻⁷: below the threshold. So the code
// takes the triangles for coplanar, and drops z.
Pair gap_missed() {
  return {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.005}, {0.01, 0, 0.005}, {0, 0.01, 0.005}};
}

// In the plane z = x + y. The products have more than 53 digits, and none of the six distances is
// computed as zero. Three of them have the same sign.
Pair inside_missed() {
  return {{-4000001, -3000007, -7000008}, {5000003, -2000003, 3000000},
          {-1000003, 4000037, 3000034},   {-1234567, -1, -1234568},
          {1234567, 1, 1234568},          {1, 1234567, 1234568}};
}

}  // namespace exercise
