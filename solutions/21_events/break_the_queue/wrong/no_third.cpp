// misconception: break-no-prediction-is-void
// caught by: three tiles end at wrong positions
// seen: not found
#include "break_the_queue.hpp"

namespace exercise {

std::vector<Tile> three_tiles() {
  return {{{-6, 0}, {1, 0}}, {{0, 0}, {-1, 0}}, {{0, -5}, {0, 0}}};
}

std::vector<Tile> right_number_of_hits() {
  return {{{-6, 0.5}, {1, 0}}, {{0, 0}, {0, 0}}, {{-0.5, -3}, {0, 1}}, {{0.5, 6}, {0, 0}}};
}

std::vector<Tile> too_early() {
  return {{{-8, 0}, {2, 0}}, {{0, 0.5}, {0, 0}}, {{-3, -1}, {1, 1}}};
}

}  // namespace exercise
