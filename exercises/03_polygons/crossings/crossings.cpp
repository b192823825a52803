#include "crossings.hpp"

namespace exercise {

bool crosses(const Eigen::Vector2d& /*point*/, const Eigen::Vector2d& /*from*/,
             const Eigen::Vector2d& /*to*/) {
  contact::todo();
}

bool crossings(const std::vector<Eigen::Vector2d>& /*polygon*/, const Eigen::Vector2d& /*point*/) {
  contact::todo();
}

}  // namespace exercise
