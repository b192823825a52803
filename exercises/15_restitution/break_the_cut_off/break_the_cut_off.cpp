#include "break_the_cut_off.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "rest_after_cut_off.hpp"

namespace exercise {

Drop weak_bounces() { contact::todo(); }

Drop from_high_up() { contact::todo(); }

Drop by_a_minute() { contact::todo(); }

}  // namespace exercise
