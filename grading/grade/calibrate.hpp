#pragma once

// How much time this machine's tests need, and whether they can be graded here at all.

#include "unit.hpp"

namespace contact::grading {

/// Grades the exercise's solution in the same boxes as submissions will be.
/// @returns the seconds of processor time that a test of it may take: those of
/// settings.limits.test_cpu_seconds, or of the exercise if that is 0, and at least ten times what
/// the solution takes here
/// @throws BookError if the solution does not get full marks
double calibrate(Loop& loop, const Book& book, const BuildDescription& build,
                 const Machine& machine, const Seat& seat, const Exercise& exercise,
                 UnitSettings settings);

/// How long that may take on the clock.
double calibrating_seconds(const Exercise& exercise, UnitSettings settings);

}  // namespace contact::grading
