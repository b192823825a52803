/// @file
/// Exercise: starts from which a prediction fails earlier than expected.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A point starts to fly in the plane, at 1 m/s. Round posts of radius 0.4 m stand at all points
/// with whole coordinates, in all directions without end, and reflect it (k = 1, no friction).
struct Start {
  Eigen::Vector2d position;   ///< m, coordinates from 0 to 1
  Eigen::Vector2d direction;  ///< of any length from 0.1 to 10
};

/// A start from which two paths are a millimetre apart before given::hits_until_apart expects it,
/// which are 15 hits: at the time of hit 7 or earlier.
///
/// As for all starts here, the second path starts 1e-12 m beside the first one, to its left, and in
/// parallel. What counts is the distance of the two points at the time of a hit of the first one.
/// Until then no flight of the first, from the start or from hit to hit, is longer than 10 m. The
/// start is at least 1e-6 m away from every post.
Start apart_by_hit_7();

/// The same at the time of hit 12 or earlier, and until then the first point hits each post almost
/// head on: the cosine of the angle between path and normal is at least 0.9.
Start without_oblique_hits();

/// The same at the time of hit 15 or earlier. Until then the first point hits each post almost head
/// on, as above, and no flight is longer than given::mean_flight, which is 0.62168 m.
Start without_long_flights();

}  // namespace exercise
