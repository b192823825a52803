/// @file
/// Exercise: roll back by bisection to a state in which bodies do not overlap.
///
/// Times are fractions of the step: 0 at its start, 1 at its end.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A time during which two bodies touch or overlap, both ends included.
struct Overlap {
  double begin;
  double end;  ///< not less than begin
};

/// Whether the bodies touch or overlap at a time.
///
/// @param overlaps any number, in any order
bool overlap_at(const std::vector<Overlap>& overlaps, double t);

/// What bisection knows at the end. It asks overlap_at() and nothing else.
struct Bracket {
  std::optional<double>
      free;  ///< the latest time before `overlapping` at which it found no overlap
  std::optional<double> overlapping;  ///< the earliest time at which it found an overlap
  std::vector<double> asked;  ///< all times for which it asked, in the order in which it did
};

/// Tests the start of the step, then its end, then halves the interval between them.
///
/// - If the bodies overlap at the start, there is nothing to roll back to: `free` is nothing,
///   `overlapping` is 0, and nothing else is asked.
/// - If they are free at the start and at the end, the whole step counts as free: `free` is 1,
///   `overlapping` is nothing, and nothing else is asked.
/// - Otherwise each halving asks for the middle between a free and an overlapping time, and puts
///   the middle in place of one of them.
///
/// No time is asked twice. All times are exact.
///
/// @param overlaps any number, in any order
/// @param halvings from 0 to 50
Bracket bisect_back(const std::vector<Overlap>& overlaps, int halvings);

}  // namespace exercise
