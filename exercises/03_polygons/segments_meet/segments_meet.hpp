/// @file
/// Exercise: how two segments meet.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// All points from a to b, both included. A segment may be a single point: then a and b are equal.
struct Segment {
  Eigen::Vector2d a;
  Eigen::Vector2d b;
};

/// What two segments have in common.
enum class Meeting {
  none,        ///< no point
  crossing,    ///< one point, which is an end of neither
  touching,    ///< one point, which is an end of one of them or of both
  overlapping  ///< more than one point
};

/// How the segments meet.
///
/// All numbers are whole, from -2^25 to 2^25, so that a double holds every difference, every
/// product of two of them and the sum or difference of two such products without rounding: the
/// answer must be right for every input.
Meeting segments_meet(const Segment& s, const Segment& t);

}  // namespace exercise
