/// @file
/// Code to break: how many hits a position can be predicted for.
#pragma once

#include <contact/prelude.hpp>

namespace given {

/// The mean length of a flight from post to post, m: posts of this radius are at all points of the
/// plane with whole coordinates, and the mean is over all flights (Santaló: π times the free area
/// over the perimeter).
inline double mean_flight(double radius) {
  const double pi = 3.14159265358979323846;
  return (1 - pi * radius * radius) / (2 * radius);
}

/// How many hits it takes until an error of 1e-12 m has grown to a millimetre.
inline int hits_until_apart(double radius) {
  int hits = 0;
  for (double error = 1e-12; error < 1e-3; ++hits) error *= 1 + 2 * mean_flight(radius) / radius;
  return hits;
}

}  // namespace given
