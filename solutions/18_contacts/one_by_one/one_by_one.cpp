#include "one_by_one.hpp"

namespace exercise {

// The first contact stops and the box rotates about it. That makes the second contact faster, so
// the last impulse turns the box to the other side.
Box order_decides() { return {2, 1, -1, 1, -1, 0, 0}; }

// The second contact stops, and its impulse throws the first one down again: at 0.71 m/s.
Box keeps_closing() { return {2, 0.1, -1, 1, -1, 0, 0}; }

// Each impulse keeps the energy, and together they leave 56 % of it in the rotation.
Box energy_is_right() { return {2, 1, -1, 1, -1, 0, 1}; }

}  // namespace exercise
