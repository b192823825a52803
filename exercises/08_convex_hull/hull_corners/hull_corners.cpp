#include "hull_corners.hpp"

namespace exercise {

std::vector<int> hull_corners(const std::vector<Eigen::Vector3d>& /*points*/) { contact::todo(); }

}  // namespace exercise
