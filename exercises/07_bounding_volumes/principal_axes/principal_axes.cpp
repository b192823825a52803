#include "principal_axes.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "principal_box.hpp"

namespace exercise {

std::vector<Eigen::Vector3d> larger_than_the_aligned_box() { contact::todo(); }

Body changed_by_a_point() { contact::todo(); }

std::vector<Eigen::Vector3d> cube_in_a_large_box() { contact::todo(); }

}  // namespace exercise
