/// @file
/// Exercise: the number of collisions of two blocks and a wall.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The number of collisions after a large block slides towards a small one that rests in front of a
/// wall.
///
/// Everything is elastic, on one line and without friction. Collisions of the two blocks count, and
/// those of the small one with the wall. The answer is exact, for the ratio as it is stored.
/// @param ratio mass of the large block over that of the small one, from 1 to 1600. (There are then
/// at most 125 collisions.)
int clicks(double ratio);

}  // namespace exercise
