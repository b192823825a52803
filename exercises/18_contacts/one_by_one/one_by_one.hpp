/// @file
/// Exercise: boxes with two contacts that one pass gets wrong.
///
/// A box of 1 kg, homogeneous, with horizontal and vertical edges, meets a floor at two points of
/// its lower edge. There is no friction.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A box at the moment of the impact.
struct Box {
  double width;             ///< m
  double height;            ///< m
  double first;             ///< position of the first contact, m to the right of the centre
  double second;            ///< position of the second contact, m to the right of the centre
  double velocity;          ///< of the centre, m/s; up is positive
  double angular_velocity;  ///< rad/s, counter-clockwise
  double restitution;       ///< of both contacts
};

/// A box that does not rotate before the impact, and for which the order of the contacts decides:
/// if first and second are exchanged, the angular velocity that given::one_by_one returns changes
/// by at least a tenth of speed over width.
///
/// Like those of the other functions: width and height are from 0.1 to 10 m, the contacts are on
/// the lower edge and at least 0.1 m apart, the velocities at most 10 m/s and 100 rad/s, and the
/// faster contact approaches with 0.1 m/s or more.
Box order_decides();

/// A box of which one contact still approaches after given::one_by_one, with at least a quarter of
/// the largest speed of approach before.
Box keeps_closing();

/// A box with restitution 1 that does not rotate before the impact, with contacts equally far to
/// the left and to the right. given::one_by_one keeps its kinetic energy, and turns at least half
/// of it into rotation, although the box should bounce straight up.
Box energy_is_right();

}  // namespace exercise
