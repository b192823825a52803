#include "cell_rounding.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "cells_as_computed.hpp"

namespace exercise {

Pair in_a_cell_without_a_point() { contact::todo(); }

Pair lost_by_the_reciprocal() { contact::todo(); }

Pair lost_by_added_keys() { contact::todo(); }

}  // namespace exercise
