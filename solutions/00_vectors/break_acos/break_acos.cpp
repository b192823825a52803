#include "break_acos.hpp"

namespace exercise {

// Vectors in one direction whose quotient is rounded to more than 1, found by trying.
Pair angle_is_no_number() { return {{0.1, 0.3, 0.1}, {0.3, 0.9, 0.3}}; }

// The cross product is 1, so the angle is 5e-13. Its cosine differs from 1 by 1e-25.
Pair angle_is_lost() { return {{1e6, 1e6 - 1, 0}, {1e6 - 1, 1e6 - 2, 0}}; }

// The squares overflow, and infinity divided by infinity is NaN.
Pair large_angle() { return {{1e200, 0, 0}, {1e200, 1e200, 0}}; }

}  // namespace exercise
