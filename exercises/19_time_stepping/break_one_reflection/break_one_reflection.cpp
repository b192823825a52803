#include "break_one_reflection.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "reflect_once.hpp"

namespace exercise {

Step short_step() { contact::todo(); }

Step slow_point() { contact::todo(); }

Step two_impacts() { contact::todo(); }

}  // namespace exercise
