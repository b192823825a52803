/// @file
/// Exercise: how often two blocks and a wall collide.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The number of collisions of a large block that slides towards a small one at rest, before a
/// wall.
///
/// Everything is elastic, on one line and without friction. Collisions of the two blocks count, and
/// those of the small one with the wall. The answer is for the number as it is stored, and exact.
/// @param ratio mass of the large block over that of the small one, from 1 to 1600. (There are then
/// at most 125 collisions.)
int clicks(double ratio);

}  // namespace exercise
