/// @file
/// Exercise: the largest gap between two boxes along their fifteen axes.
///
/// The axes of a box are the columns of a matrix, as unit vectors in world coordinates. They are
/// perpendicular to each other, except for rounding. Half lengths go from the centre to a face.
/// Coordinates of centres are multiples of 2^-30 from -1000 to 1000, half lengths whole numbers
/// from 1 to 1000, m. Gaps of an answer may be off by 1e-9.
#pragma once

#include <contact/prelude.hpp>

#include <contact/oriented_box.hpp>

namespace exercise {

/// The gap between the projections of two boxes on a line: how far they are apart along it. If they
/// overlap, it is negative: its absolute value is how far one box must move along the line until
/// they do not.
///
/// @param first anywhere, perhaps inside the second
/// @param second the same
/// @param direction of the line, of any length but zero; whole numbers from -1000 to 1000
/// @return m
double gap_along(const contact::OrientedBox<double>& first,
                 const contact::OrientedBox<double>& second, const Eigen::Vector3d& direction);

/// A gap and the axis that has it.
struct LargestGap {
  double gap;  ///< m
  int axis;    ///< from 0 to 14, see largest_gap()
};

/// The largest gap of two boxes along fifteen axes, as in gap_along(), and the axis that has it.
///
/// - Axes 0, 1 and 2 are those of the first box, 3, 4 and 5 those of the second.
/// - Axis 6 + 3 i + j is perpendicular to axis i of the first box and to axis j of the second, with
///   i and j from 0 to 2. If these are parallel, there is no such axis: two count as parallel if
///   their cross product is shorter than 1e-8. The contract does not ask about cross products from
///   1e-12 to 1e-2.
/// - Of axes whose gaps differ by less than 1e-9 m the first counts.
///
/// @param first anywhere, perhaps inside the second
/// @param second the same
LargestGap largest_gap(const contact::OrientedBox<double>& first,
                       const contact::OrientedBox<double>& second);

}  // namespace exercise
