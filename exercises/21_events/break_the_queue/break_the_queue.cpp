#include "break_the_queue.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "queue_of_hits.hpp"

namespace exercise {

Tiles three_tiles() { contact::todo(); }

Tiles right_number_of_hits() { contact::todo(); }

Tiles too_early() { contact::todo(); }

}  // namespace exercise
