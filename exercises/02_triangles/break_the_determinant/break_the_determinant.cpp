#include "break_the_determinant.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "hit_with_epsilon.hpp"

namespace exercise {

Shot small_triangle() { contact::todo(); }

Shot short_direction() { contact::todo(); }

Shot whole_numbers() { contact::todo(); }

}  // namespace exercise
