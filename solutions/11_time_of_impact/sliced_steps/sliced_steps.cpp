#include "sliced_steps.hpp"

namespace exercise {

// The tests are at -2.9, -0.9, 1.1 and 3.1. The bullet touches the plate from -0.1 to 0.3.
Shot through_the_plate() { return {{-2.9, 0}, {6, 0}, 0.1, 0.2}; }

// The chord is 0.06 m long, and slices of 100 are 0.08 m long. The discs are closest at 0.505, in
// the middle between two tests.
Shot graze_missed_again() { return {{-4.04, 0.198}, {8, 0}, 0.1, 0.1}; }

// Closest at 1/3, which is no multiple of 1/100: the nearest is a third of 0.09 m away.
Shot lost_by_finer_slices() { return {{-3, 0.198}, {9, 0}, 0.1, 0.1}; }

}  // namespace exercise
