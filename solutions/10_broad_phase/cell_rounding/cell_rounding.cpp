#include "cell_rounding.hpp"

namespace exercise {

// A cast turns -0.5 and -0.25 into 0, and cell 0 begins at 0.
Pair in_a_cell_without_a_point() { return {1, -0.5, -0.25, 0, 0}; }

// 0.3 is less than 3 times the stored 0.1, and the quotient is rounded to less than 3. The
// reciprocal is 10 and the product 3.
Pair lost_by_the_reciprocal() { return {0.1, 0.3, 0.3, 0.3, 0.3}; }

// Both boxes have a point in the cell from 0.6 to 0.7. The key of this cell is 0.6 if 0.1 is added
// to 0.5, and 6 * 0.1 is larger.
Pair lost_by_added_keys() { return {0.1, 0, 0.65, 0.62, 0.64}; }

}  // namespace exercise
