#include "next_crossing.hpp"

namespace exercise {

std::optional<Crossing> next_crossing(const Ball& ball, double size) {
  //? A ball at rest crosses nothing: then this stays empty.
  std::optional<Crossing> first;
  //? x comes before y, so that x is kept where the times are equal.
  for (std::size_t axis = 0; axis < 2; ++axis) {
    //? A border is reached only along an axis on which the ball moves. This excludes both zeros.
    //? gap: velocity == 0
    const double velocity = ball.velocity[axis];
    if (velocity == 0) continue;
    //? The cell lies between its own number and the next one. The number is the stored one: on a
    //? border the position belongs to two cells.
    //? gap: ball.cell[axis] + (velocity > 0 ? 1 : 0)
    const int border = ball.cell[axis] + (velocity > 0 ? 1 : 0);
    //? Beyond the border the quotient is negative, and the ball leaves now.
    //? gap: (border * size - ball.position[axis]) / velocity
    const double time = std::max(0.0, (border * size - ball.position[axis]) / velocity);
    //? Only an earlier crossing replaces one that is known.
    //? gap: time >= first->time
    if (first && time >= first->time) continue;
    //? One coordinate of the cell changes, by one.
    //? gap: next_cell[axis] += towards
    const int towards = velocity > 0 ? 1 : -1;
    std::array<int, 2> next_cell = ball.cell;
    next_cell[axis] += towards;
    first = Crossing{time, static_cast<int>(axis), towards, next_cell};
  }
  //? The earlier of at most two crossings is left.
  return first;
}

}  // namespace exercise
