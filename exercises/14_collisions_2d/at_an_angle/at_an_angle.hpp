/// @file
/// Exercise: vehicles that stick together at an angle, and a momentum shared between two
/// directions.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A vehicle and how it moves.
struct Vehicle {
  double mass;     ///< kg, greater than 0
  double speed;    ///< m/s, not negative
  double heading;  ///< degrees from the x axis towards the y axis, -180 to 180
};

/// A motion as a police report has it.
struct Motion {
  double speed;    ///< m/s, not negative
  double heading;  ///< degrees from the x axis towards the y axis, more than -180, at most 180
};

/// How two vehicles move on once they have stuck together. Their total momentum is never zero.
Motion stuck_together(const Vehicle& a, const Vehicle& b);

/// The sizes of two momenta, kg·m/s.
struct Sizes {
  double a;
  double b;
};

/// A ball comes with a momentum and hits a ball at rest; afterwards one leaves to the left of the
/// old direction and the other to the right. The sizes of their momenta.
///
/// @param total size of the momentum before, kg·m/s
/// @param angle_a of A's new direction with the old one, to the left, degrees, greater than 0
/// @param angle_b of B's new direction with the old one, to the right, degrees, greater than 0;
/// angle_a + angle_b is less than 180
Sizes leaving_at(double total, double angle_a, double angle_b);

}  // namespace exercise
