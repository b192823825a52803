/// @file
/// Exercise: starts that a queue of predictions gets wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Squares of 1 m with sides along x and y, which slide without friction and do not rotate. All
/// have the same mass. When a side of one hits a side of another, the two exchange their velocities
/// along the axis that is perpendicular to these sides, as in an elastic collision.
struct Tiles {
  std::vector<Eigen::Vector2d> positions;   ///< of the centres, m
  std::vector<Eigen::Vector2d> velocities;  ///< of the same tiles in the same order, m/s
};

/// Three tiles of which given::run is wrong: after 10 s at least one of them is more than 0.01 m
/// from where it should be.
///
/// Like those of the other functions: there are at most six tiles; every coordinate is a multiple
/// of 0.5 m from -20 to 20 m, and every component of a velocity a whole number from -4 to 4 m/s. No
/// two tiles touch at the start. In the right run of 10 s no two ever touch at their corners alone,
/// no two hits happen at the same time, and none at the end.
Tiles three_tiles();

/// Tiles of which given::run is wrong, although it counts as many hits as there are in 10 s. The
/// first hit that it gets wrong is one of two tiles that never hit each other in this time.
Tiles right_number_of_hits();

/// Tiles of which given::run is wrong, and the first hit that it gets wrong is too early: within
/// the 10 s, the same two tiles do hit each other later.
Tiles too_early();

}  // namespace exercise
