#include "count_the_clicks.hpp"

#include <contact/exact.hpp>

namespace exercise {

// Only the signs of velocities and of their difference matter, so no division is needed: after each
// collision of the blocks all velocities are M + m times too large, which changes no sign.
int clicks(double ratio) {
  using contact::Exact;
  const Exact difference = Exact(ratio) - Exact(1.0);
  const Exact two_ratio = Exact(2.0) * Exact(ratio);
  Exact large(1.0);
  Exact small(0.0);
  for (int count = 0;; ++count) {
    if (large > small) {
      const Exact after = difference * large + Exact(2.0) * small;
      small = two_ratio * large - difference * small;
      large = after;
    } else if (small.sign() > 0) {
      small = -small;
    } else {
      return count;
    }
  }
}

}  // namespace exercise
