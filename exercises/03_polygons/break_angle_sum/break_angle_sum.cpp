#include "break_angle_sum.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "inside_by_angles.hpp"

namespace exercise {

Query outside_a_triangle() { contact::todo(); }

Query outside_a_quadrilateral() { contact::todo(); }

Query outside_the_bounding_box() { contact::todo(); }

}  // namespace exercise
