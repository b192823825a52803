#include "one_by_one.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "single_pass.hpp"

namespace exercise {

Box order_decides() { contact::todo(); }

Box keeps_closing() { contact::todo(); }

Box energy_is_right() { contact::todo(); }

}  // namespace exercise
