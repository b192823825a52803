#include "hull_2d.hpp"

namespace exercise {

std::vector<int> hull_2d(const std::vector<Eigen::Vector2d>& /*points*/) { contact::todo(); }

}  // namespace exercise
