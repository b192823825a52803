#include "break_the_parity.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "inside_by_parity.hpp"

namespace exercise {

Eigen::Vector3d inside_the_octahedron() { contact::todo(); }

Eigen::Vector3d left_of_the_house() { contact::todo(); }

Eigen::Vector3d past_every_edge() { contact::todo(); }

}  // namespace exercise
