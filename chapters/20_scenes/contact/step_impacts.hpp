/// @file
/// How the impacts of a step are taken: each at its own time, or many at once.
#pragma once

#include <algorithm>
#include <cstddef>

namespace contact {

/// How many impacts of a step are taken each at its own time. What is left of it then is taken in
/// crowd_parts parts or more, and in each of them a pair bounces once. Balls meet as often as their
/// speeds say, and each impact costs as much as there are pairs: one ball may have 65536, 64 of
/// them 16 together. Corners chatter, and all that touches is solved anew for each: what turns and
/// has some has 4. Where infinitely many hits come in a finite time it is this that ends them.
/// @param edges whether something turns that is no ball
inline int most_impacts(std::size_t movers, bool edges) {
  const std::size_t many = std::max<std::size_t>(movers, 1);
  return edges ? 4 : static_cast<int>(std::max<std::size_t>(65536 / (many * many), 4));
}
/// How many bodies may move for impacts to be taken one by one, each at its own time.
inline constexpr std::size_t most_one_by_one = 64;
/// In how many parts a step is taken in which more bodies move, or hit more often; a power of two.
inline constexpr int crowd_parts = 4;
/// How often in a row a part is taken anew because somebody is flung at somebody else.
inline constexpr int most_anew = 32;

}  // namespace contact
