/// @file
/// Exercise: how many comparisons a broad phase is expected to need, before any box exists.
///
/// Boxes are squares in the plane, edges included. There are kinds of them: each has a count and a
/// size. The lower corner of a square is (x, y) with whole numbers from 0 <= x < width and
/// 0 <= y < height, all of them equally probable and all independent of one another, so the square
/// has the points from x to x + size and from y to y + size. All lengths are whole numbers, in cm.
///
/// Expected numbers may be off by a relative error of 1e-9.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Squares of one size.
struct Kind {
  std::int64_t count;  ///< from 0 to 1000000
  std::int64_t size;   ///< from 0 to 10000
};

/// The positions of the lower corners.
struct World {
  std::int64_t width;   ///< from 1 to 10000
  std::int64_t height;  ///< from 1 to 10000
};

/// The number of pairs of squares.
///
/// @param kinds at most eight; all squares of all kinds are compared with one another
std::int64_t all_pairs(const std::vector<Kind>& kinds);

/// The expected number of pairs whose intervals along x have a point in common: these a sweep along
/// x compares.
double sweep(const std::vector<Kind>& kinds, const World& world);

/// What a grid is expected to do.
struct Grid {
  double entries;   ///< pairs of a square and a cell in which it has a point
  double compared;  ///< pairs of squares that share a cell, each counted once
};

/// What a grid of square cells is expected to do. Cell (i, j) has the points with
/// i * edge <= x < (i + 1) * edge and j * edge <= y < (j + 1) * edge; cells continue beyond the
/// world.
///
/// @param edge at least 1; divides width and height
Grid grid(const std::vector<Kind>& kinds, const World& world, std::int64_t edge);

/// A broad phase.
enum class Method { all_pairs, sweep, grid };

/// The method with the smallest expected cost; the first of several. For n squares all pairs cost
/// their number, a sweep what it compares and n k for sorting, where k is the smallest whole number
/// with n <= 2^k, and a grid what it compares and its entries.
///
/// @param edge at least 1; divides width and height
Method choose(const std::vector<Kind>& kinds, const World& world, std::int64_t edge);

}  // namespace exercise
