#include "break_acos.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "angle_by_acos.hpp"

namespace exercise {

Pair angle_is_no_number() { contact::todo(); }

Pair angle_is_lost() { contact::todo(); }

Pair large_angle() { contact::todo(); }

}  // namespace exercise
