#include "break_the_horizon.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "hits_until_apart.hpp"

namespace exercise {

Start apart_by_hit_7() { contact::todo(); }

Start without_oblique_hits() { contact::todo(); }

Start without_long_flights() { contact::todo(); }

}  // namespace exercise
