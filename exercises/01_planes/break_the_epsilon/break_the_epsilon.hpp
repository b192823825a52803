/// @file
/// Exercise: three points whose plane an epsilon gets wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Three points, in m.
struct Points {
  Eigen::Vector3d a;
  Eigen::Vector3d b;
  Eigen::Vector3d c;
};

/// Three points that span a plane, and of which given::span_a_plane says that they do not. No two
/// of them are closer than 0.1 m. Like all points here, no coordinate is larger than 1e9.
Points plane_refused();

/// The same, with an angle of at least 30 degrees at each point. The points may be close.
Points small_triangle_refused();

/// Three different points exactly on one line, as stored, of which given::span_a_plane says that
/// they span a plane.
Points line_accepted();

}  // namespace exercise
