/// @file
/// Exercise: until when the position of a point among pillars can be predicted.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A hit of a point that flies in the plane, in a straight line from hit to hit, and is reflected.
struct Hit {
  double flight;  ///< length of the path from the previous hit or the start, m, more than 0
  double radius;  ///< of the round pillar, hit from outside, m; infinite: a flat wall
  double cosine;  ///< of the angle between the path and the normal at the hit, more than 0, up to 1
};

/// How long a prediction is within the tolerance, in s from the start; infinite if it always is.
///
/// The start is displaced by `error` perpendicular to the path, and that is the only error. So the
/// true point flies beside the predicted one, parallel to it and at the same speed. They hit the
/// same pillars and walls in the same order, at slightly different points. Compute the distance
/// between the two paths, perpendicular to them, to first order: in the limit of small errors,
/// where twice the error gives twice the distance. The prediction is good until this distance is
/// the tolerance.
///
/// @param hits of the predicted point, in their order; after the last it flies straight on for ever
/// @param speed m/s, greater than 0
/// @param error m, greater than 0: for example the rounding error of a position
/// @param tolerance m, greater than `error`
double horizon(const std::vector<Hit>& hits, double speed, double error, double tolerance);

}  // namespace exercise
