/// @file
/// Exercise: all meetings of beads on a wire, in the order in which they happen.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A bead on a wire. All beads are alike, and so small that they are points.
struct Bead {
  double position;  ///< m
  double velocity;  ///< m/s
};

/// Two neighbours that meet.
struct Meeting {
  double time;  ///< s from the start
  int left;     ///< index of the left one; the other is left + 1
};

/// All meetings from the start until the time `until`, that moment included, in their order.
///
/// Two neighbours meet when they are at one place and the left one is faster than the right one.
/// Then they exchange their velocities, since they are alike and nothing is lost; and they have
/// met. So beads keep their order on the wire, and neighbours that have just met do not meet again
/// before something else has happened to one of them. Of meetings that are due at one time, the one
/// with the smallest `left` comes first; what its exchange makes due at the same time is then due
/// like the others.
///
/// @param beads in the order of their positions; neighbours may be at one place
/// @param until s, 0 or more
std::vector<Meeting> meetings(const std::vector<Bead>& beads, double until);

}  // namespace exercise
