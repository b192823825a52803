/// @file
/// Exercise: bodies that meet during a step, and tests of overlap at the ends of its slices that do
/// not notice.
///
/// Times are fractions of the step: 0 at its start, 1 at its end. Coordinates are in m.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A bullet and a plate, along the line perpendicular to the plate.
struct Shot {
  double start;         ///< of the bullet's centre
  double displacement;  ///< of the bullet's centre during the step
  double radius;        ///< of the bullet
  double plate;         ///< the plate is from here
  double thickness;     ///< to plate + thickness
};

/// Two discs, as seen from one: its centre is at rest at the origin.
struct Pass {
  Eigen::Vector2d start;         ///< of the other one's centre
  Eigen::Vector2d displacement;  ///< of it during the step
  double radii;                  ///< the sum of the radii
};

/// A bullet that flies through a plate, from one side to the other, and of which
/// given::bullet_meets_plate says, with 3 slices, that it does not touch it. The bullet's radius is
/// at least 0.01 m, the plate's thickness at least 0.1 m, and no number is beyond ±10 m.
Shot through_the_plate();

/// Discs of which given::disc_meets_disc says that they do not touch, with 3 slices and again with
/// 100, although they overlap by at least 1 mm during the step. The sum of the radii is from 0.1 to
/// 1 m, and the displacement is at most 10 m long.
Pass graze_missed_again();

/// Discs that given::disc_meets_disc finds with 3 slices and misses with 100. They overlap by at
/// least 1 mm. The sum of the radii is from 0.1 to 1 m, and the displacement is at most 10 m long.
Pass lost_by_finer_slices();

}  // namespace exercise
