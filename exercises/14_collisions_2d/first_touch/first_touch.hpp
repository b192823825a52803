/// @file
/// Exercise: which two discs on a table touch first, and when.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A disc that moves in a straight line.
struct Disc {
  Eigen::Vector2d centre;    ///< m
  Eigen::Vector2d velocity;  ///< m/s
  double radius;             ///< m, greater than 0
};

/// Two discs that touch.
struct Touch {
  int first;    ///< index of one disc
  int second;   ///< index of the other, larger than first
  double time;  ///< s from now, not negative
};

/// The first touch of any two discs, at its exact time. Nothing if no two ever touch.
///
/// Discs touch at the first moment from now at which the distance of their centres is at most the
/// sum of their radii while they approach. So two discs in contact or overlapping now touch at time
/// 0 if they approach, and not at all if they do not. The test cases have no ties and no paths that
/// nearly graze. The time may have a relative error of 2⁻³⁵.
std::optional<Touch> first_touch(const std::vector<Disc>& discs);

}  // namespace exercise
