// misconception: starts-on-the-edge
// caught by: points on the edge's line make no face
// seen: L20, slide "Convex Hull"
//   step 5 does not exclude points on the edge's line
#include "wrap_step.hpp"

namespace exercise {
namespace {

// Positive if p is in front of the plane a, b, c.
double side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
            const Eigen::Vector3d& p) {
  return (p - a).dot((b - a).cross(c - a));
}

}  // namespace

int wrap_step(const std::vector<Eigen::Vector3d>& points, int from, int to) {
  const auto at = [&](std::size_t i) { return points[i]; };
  const Eigen::Vector3d f = at(static_cast<std::size_t>(from));
  const Eigen::Vector3d t = at(static_cast<std::size_t>(to));
  std::size_t best = 0;
  while (static_cast<int>(best) == from || static_cast<int>(best) == to) ++best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (side(t, f, at(best), at(i)) > 0) best = i;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<int>(i) != from && static_cast<int>(i) != to &&
        side(t, f, at(best), at(i)) == 0)
      return static_cast<int>(i);
  }
  return static_cast<int>(best);
}

}  // namespace exercise
