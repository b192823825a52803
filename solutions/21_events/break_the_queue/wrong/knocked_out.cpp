// misconception: break-the-two-do-not-hit-later
// caught by: a hit that happens later comes too early
// seen: not found
#include "break_the_queue.hpp"

namespace exercise {

Tiles three_tiles() { return {{{-6, 0.5}, {0, 0}, {0, -3}}, {{1, 0}, {0, 0}, {0, 1}}}; }

Tiles right_number_of_hits() {
  return {{{-6, 0.5}, {0, 0}, {-0.5, -3}, {0.5, 6}}, {{1, 0}, {0, 0}, {0, 1}, {0, 0}}};
}

Tiles too_early() { return {{{-6, 0.5}, {0, 0}, {0, -3}}, {{1, 0}, {0, 0}, {0, 1}}}; }

}  // namespace exercise
