/// @file
/// Code to break: the cells of a grid along one axis, as programs compute them. Cell k has the
/// points with k * edge <= x < (k + 1) * edge, and boxes are intervals, ends included. Boxes with a
/// common point should be in a common cell.
#pragma once

#include <cmath>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The numbers of the first and the last cell of a box.
struct Cells {
  double first = 0;
  double last = 0;
};

/// The cells of a box by dropping the fraction of each quotient, as a cast to int does.
inline Cells cells_by_truncation(double low, double high, double edge) {
  return {std::trunc(low / edge), std::trunc(high / edge)};
}

/// The cells in which a box is stored: by the reciprocal of the edge, since a product costs less
/// than a quotient.
inline Cells cells_to_store(double low, double high, double edge) {
  const double inverse_edge = 1 / edge;
  return {std::floor(low * inverse_edge), std::floor(high * inverse_edge)};
}

/// The cells in which a box looks for others: another function, written at another time.
inline Cells cells_to_search(double low, double high, double edge) {
  return {std::floor(low / edge), std::floor(high / edge)};
}

/// Whether box b is found when box a looks for others.
template <class Pair>
bool is_found(const Pair& pair) {
  const Cells of_a = cells_to_search(pair.low_a, pair.high_a, pair.edge);
  const Cells of_b = cells_to_store(pair.low_b, pair.high_b, pair.edge);
  return of_a.first <= of_b.last && of_b.first <= of_a.last;
}

/// The keys of the cells of a box in a map: the coordinates at which the cells begin.
inline std::vector<double> keys(double low, double high, double edge) {
  std::vector<double> keys;
  for (double key = std::floor(low / edge) * edge; key <= high; key += edge) keys.push_back(key);
  return keys;
}

/// Whether the boxes have a key in common.
template <class Pair>
bool share_a_key(const Pair& pair) {
  for (const double of_a : keys(pair.low_a, pair.high_a, pair.edge))
    for (const double of_b : keys(pair.low_b, pair.high_b, pair.edge))
      if (of_a == of_b) return true;
  return false;
}

}  // namespace given
