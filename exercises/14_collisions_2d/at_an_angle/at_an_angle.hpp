/// @file
/// Exercise: vehicles that stick together at an angle, and a momentum as the sum of two with known
/// directions.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A vehicle and its motion.
struct Vehicle {
  double mass;     ///< kg, greater than 0
  double speed;    ///< m/s, not negative
  double heading;  ///< degrees from the x axis towards the y axis, -180 to 180
};

/// A motion as in a police report.
struct Motion {
  double speed;    ///< m/s, not negative
  double heading;  ///< degrees from the x axis towards the y axis, more than -180, at most 180
};

/// The motion of two vehicles after they have stuck together. Their total momentum is never zero.
Motion stuck_together(const Vehicle& a, const Vehicle& b);

/// The magnitudes of two momenta, kg·m/s.
struct Sizes {
  double a;
  double b;
};

/// Ball A hits ball B at rest; afterwards A leaves to the left of A's old direction and B to the
/// right. The magnitudes of their momenta.
///
/// @param total magnitude of A's momentum before, kg·m/s
/// @param angle_a between A's new direction and the old one, to the left, degrees, greater than 0
/// @param angle_b between B's direction and A's old one, to the right, degrees, greater than 0;
/// angle_a + angle_b is less than 180
Sizes leaving_at(double total, double angle_a, double angle_b);

}  // namespace exercise
