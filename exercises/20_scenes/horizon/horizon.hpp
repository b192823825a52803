/// @file
/// Exercise: until when the place of a point among pillars can be predicted.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A hit of a point that flies in the plane, straight on from hit to hit, and is reflected there.
struct Hit {
  double flight;  ///< length of the path from the hit before (or from the start), m, more than 0
  double radius;  ///< of the round pillar that is hit from outside, m; infinite: a flat wall
  double cosine;  ///< of the angle between the path and the normal at the hit, more than 0, up to 1
};

/// How long a prediction is good, in s from the start; infinite if it is good for ever.
///
/// What is known of the start is off by `error` across the path, and nothing else is. So the true
/// point flies beside the predicted one, parallel to it and as fast. They hit the same things in
/// the same order, a little apart. How far apart the two paths are, across the path, is to be
/// computed to first order: as if the error were so small that twice the error, anywhere, made
/// twice the distance. The prediction is good until this distance is the tolerance.
///
/// @param hits of the predicted point, in their order; after the last it flies straight on for ever
/// @param speed m/s, greater than 0
/// @param error m, greater than 0: perhaps what rounding to a double made of a place
/// @param tolerance m, greater than `error`
double horizon(const std::vector<Hit>& hits, double speed, double error, double tolerance);

}  // namespace exercise
