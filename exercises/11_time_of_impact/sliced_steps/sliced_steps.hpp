/// @file
/// Exercise: a disc that meets an obstacle during a step, and tests of overlap at the ends of
/// slices of the step that do not notice.
///
/// Times are fractions of the step: 0 at its start, 1 at its end. Coordinates are in m.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A moving disc and an obstacle at rest.
struct Shot {
  Eigen::Vector2d start;         ///< of the disc's centre
  Eigen::Vector2d displacement;  ///< of the disc's centre during the step
  double radius;                 ///< of the disc
  /// The thickness of a plate, 0 <= x <= size, or the radius of a disc about the origin.
  double size;
};

/// A bullet that flies through the plate, from one side to the other, and of which
/// given::meets_plate says, with 3 slices, that it does not touch it. The bullet's radius is at
/// least 0.01 m, the plate is at least 0.1 m thick, and no number is beyond ±10 m.
Shot through_the_plate();

/// Discs of which given::meets_disc says that they do not touch, with 3 slices and again with 100,
/// although they overlap by at least 1 mm during the step. Each radius is from 0.05 to 0.5 m, the
/// displacement is at most 10 m long, and the start is at most 100 m from the origin.
Shot graze_missed_again();

/// Discs that given::meets_disc finds with 3 slices and misses with 100. They overlap by at least 1
/// mm. Each radius is from 0.05 to 0.5 m, the displacement is at most 10 m long, and the start is
/// at most 100 m from the origin.
Shot lost_by_finer_slices();

}  // namespace exercise
