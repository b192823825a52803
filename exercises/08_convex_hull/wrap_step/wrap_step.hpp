/// @file
/// Exercise: one fold of the wrapping paper.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A face of the hull is known, and with it the edge from point `from` to point `to`: seen from
/// outside, the vertices of that face run counter-clockwise, through `from` and then `to`. Find the
/// face on the other side of the edge.
///
/// The result is the index i of a point such that the triangle (`to`, `from`, i) has an area, and
/// its plane has no point of the set in front (on the side from which `to`, `from`, i run
/// counter-clockwise). If there are several such indices, it is the smallest.
///
/// @param points whole numbers from -1000 to 1000, not all in one plane; points may be equal, or on
///   one line with the edge
/// @param from,to indices of two different points on an edge of the hull
int wrap_step(const std::vector<Eigen::Vector3d>& points, int from, int to);

}  // namespace exercise
