/// @file
/// Exercise: when a ball leaves its cell, and for which one.
///
/// The cells of a grid in the plane are squares of one size. Cell (i, j) is between the borders
/// x = i * size and x = (i + 1) * size, and between y = j * size and y = (j + 1) * size.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ball that moves uniformly, and the cell in whose list it is.
///
/// Only the centre of the ball counts. It may be exactly on a border of its cell. The program moves
/// a ball from list to list at the time that it has computed for the crossing, and this time is
/// rounded, so the centre may also be beyond a border, by a few units in the last place.
struct Ball {
  std::array<double, 2> position;  ///< x and y of the centre, m
  std::array<double, 2> velocity;  ///< x and y, m/s
  std::array<int, 2> cell;         ///< i and j: the cell in whose list the ball is
};

/// How a ball leaves its cell.
struct Crossing {
  double time;                   ///< s from now, not negative
  int axis;                      ///< 0 if it crosses a border in x, 1 if it crosses one in y
  int towards;                   ///< 1 if that coordinate increases, -1 if it decreases
  std::array<int, 2> next_cell;  ///< i and j of the neighbour that it enters
};

/// The next crossing of a ball; nothing if it stays in its cell forever.
///
/// The stored cell decides where the ball is, also on a border and beyond one. A ball on a border,
/// or beyond it, crosses it at time 0 if it moves further out, and not at all if it moves back in.
/// A velocity of 0 leads through no border, wherever the ball is, whatever the sign of the 0.
///
/// If the ball reaches two borders at the same time, it crosses the one in x first, and enters the
/// neighbour in x. The crossing in y is its next one, at time 0. All times before 0 count as 0.
///
/// In the test cases no two times differ by rounding alone: either they are clearly different, or
/// equal and computed exactly, since sizes, velocities and coordinates are then short binary
/// fractions.
/// @param size of a cell, m, greater than 0
std::optional<Crossing> next_crossing(const Ball& ball, double size);

}  // namespace exercise
