/// @file
/// Exercise: all meetings of beads on a wire, in the order in which they happen.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A bead on a wire. All beads have the same mass, and are points.
struct Bead {
  double position;  ///< m
  double velocity;  ///< m/s
};

/// Two neighbours that meet and exchange their velocities.
struct Meeting {
  double time;  ///< s from the start
  int left;     ///< index of the left bead; the other is left + 1
};

/// All meetings from the start until the time `until`, inclusive, in order.
///
/// Two neighbours meet when they are at the same position and the left one has the larger velocity.
/// Then they exchange their velocities, as equal masses do in an elastic collision. So beads keep
/// their order on the wire, and two neighbours that have just met do not meet again before one of
/// them has met its other neighbour. Of meetings at the same time, the one with the smallest `left`
/// comes first; if its exchange causes another meeting at that time, this one is ordered with those
/// that remain.
///
/// @param beads in the order of their positions; neighbours may be at the same position
/// @param until s, 0 or more
std::vector<Meeting> meetings(const std::vector<Bead>& beads, double until);

}  // namespace exercise
