// misconception: axis-extremes-only
// caught by: vertices are found in every direction
// seen: not found
#include "hull_vertices.hpp"

namespace exercise {

std::vector<int> hull_vertices(const std::vector<Eigen::Vector3d>& points) {
  std::vector<int> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool extreme = false;
    bool first = true;
    for (std::size_t j = 0; j < i; ++j) first = first && points[j] != points[i];
    for (int k = 0; k < 3; ++k) {
      bool least = true;
      bool most = true;
      for (const Eigen::Vector3d& p : points) {
        least = least && points[i][k] <= p[k];
        most = most && points[i][k] >= p[k];
      }
      extreme = extreme || least || most;
    }
    if (extreme && first) vertices.push_back(static_cast<int>(i));
  }
  return vertices;
}

}  // namespace exercise
