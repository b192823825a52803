#include "hull.hpp"

namespace exercise {

std::vector<int> hull(const std::vector<Eigen::Vector2d>& /*points*/) { contact::todo(); }

}  // namespace exercise
