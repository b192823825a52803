#include "break_angles.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "hull_by_angles.hpp"

namespace exercise {

std::vector<Eigen::Vector2d> points_that_lose_a_vertex() { contact::todo(); }

std::vector<Eigen::Vector2d> points_with_an_extra_vertex() { contact::todo(); }

std::vector<Eigen::Vector2d> points_in_different_directions() { contact::todo(); }

}  // namespace exercise
