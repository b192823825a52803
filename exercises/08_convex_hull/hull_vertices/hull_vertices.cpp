#include "hull_vertices.hpp"

namespace exercise {

std::vector<int> hull_vertices(const std::vector<Eigen::Vector3d>& /*points*/) { contact::todo(); }

}  // namespace exercise
