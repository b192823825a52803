#include "break_the_queue.hpp"

namespace exercise {

// After 2 s the last tile knocks the middle one up, out of the path of the first. After 5 s the
// first is where it would have hit the middle one, which is 1.5 m higher by then.
Tiles three_tiles() { return {{{-6, 0.5}, {0, 0}, {0, -3}}, {{1, 0}, {0, 0}, {0, 1}}}; }

// The same, with a tile above that the middle one hits after 7 s. In the code the wrong hit turns
// it aside before, and it misses that tile. At the start no hit of the lowest and the highest tile
// is expected: the highest would believe it.
Tiles right_number_of_hits() {
  return {{{-6, 0.5}, {0, 0}, {-0.5, -3}, {0.5, 6}}, {{1, 0}, {0, 0}, {0, 1}, {0, 0}}};
}

// After 2 s the last tile hits the middle one from behind and leaves upwards. The middle one moves
// on at 1 m/s, and the first reaches it after 5 s instead of 3.5 s.
Tiles too_early() { return {{{-8, 0}, {0, 0.5}, {-3, -1}}, {{2, 0}, {0, 0}, {1, 1}}}; }

}  // namespace exercise
