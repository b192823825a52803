// misconception: break-the-two-do-not-hit-later
// caught by: a hit that happens later comes too early
// seen: not found
#include "break_the_queue.hpp"

namespace exercise {

std::vector<Tile> three_tiles() {
  return {{{-6, 0.5}, {1, 0}}, {{0, 0}, {0, 0}}, {{0, -3}, {0, 1}}};
}

std::vector<Tile> right_number_of_hits() {
  return {{{-6, 0.5}, {1, 0}}, {{0, 0}, {0, 0}}, {{-0.5, -3}, {0, 1}}, {{0.5, 6}, {0, 0}}};
}

std::vector<Tile> too_early() { return {{{-6, 0.5}, {1, 0}}, {{0, 0}, {0, 0}}, {{0, -3}, {0, 1}}}; }

}  // namespace exercise
