#include "edge_tests.hpp"

namespace exercise {

Eigen::Vector2d outward_normal(const Eigen::Vector2d& /*from*/, const Eigen::Vector2d& /*to*/) {
  contact::todo();
}

double ahead(const Eigen::Vector2d& /*point*/, const Eigen::Vector2d& /*from*/,
             const Eigen::Vector2d& /*to*/) {
  contact::todo();
}

Where edge_tests(const std::vector<Eigen::Vector2d>& /*polygon*/,
                 const Eigen::Vector2d& /*point*/) {
  contact::todo();
}

}  // namespace exercise
