#include "break_the_epsilon.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "span_a_plane.hpp"

namespace exercise {

Points plane_refused() { contact::todo(); }

Points small_triangle_refused() { contact::todo(); }

Points line_accepted() { contact::todo(); }

}  // namespace exercise
