#include "point_in_triangle.hpp"

namespace exercise {

int dropped_dimension(const Eigen::Vector3d& normal) { contact::todo(); }

bool point_in_triangle(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  contact::todo();
}

}  // namespace exercise
