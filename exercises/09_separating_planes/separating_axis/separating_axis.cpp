#include "separating_axis.hpp"

namespace exercise {

bool separates(const Eigen::Vector2d& /*direction*/, const std::vector<Eigen::Vector2d>& /*first*/,
               const std::vector<Eigen::Vector2d>& /*second*/) {
  contact::todo();
}

std::optional<Eigen::Vector2d> separating_axis(const std::vector<Eigen::Vector2d>& /*first*/,
                                               const std::vector<Eigen::Vector2d>& /*second*/) {
  contact::todo();
}

}  // namespace exercise
