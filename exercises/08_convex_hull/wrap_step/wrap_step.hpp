/// @file
/// Exercise: one fold of the wrapping paper.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A face of the hull is known, and with it the edge from point `from` to point `to`: seen from
/// outside, the corners from, to and `inner` run counter-clockwise. The face on the other side of
/// that edge is to be found.
///
/// The result is the index i of a point such that the triangle to, from, i has an area and no point
/// of the set lies in front of its plane (where its corners are seen counter-clockwise). If there
/// are several, it is the smallest such index.
///
/// @param points whole numbers from -1000 to 1000, not all in one plane; points may be equal, or on
///   one line with the edge
/// @param from,to,inner indices of three points that are not on one line, with no point in front
int wrap_step(const std::vector<Eigen::Vector3d>& points, int from, int to, int inner);

}  // namespace exercise
