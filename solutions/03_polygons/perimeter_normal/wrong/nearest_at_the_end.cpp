// misconception: nearest-segment-at-the-end
// caught by: a fast vertex comes in where it came from
// seen: https://github.com/liabru/matter-js/issues/810
//   a body far inside is pushed out of the opposite side
#include "perimeter_normal.hpp"

namespace exercise {
namespace {

double cross(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  return u.x() * v.y() - u.y() * v.x();
}

}  // namespace

std::optional<Entry> perimeter_normal(const std::vector<Eigen::Vector2d>& perimeter,
                                      const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  // The least penetration: the segment nearest to the end of the movement.
  std::optional<Entry> nearest;
  double least = 0;
  for (std::size_t i = 0; i < perimeter.size(); ++i) {
    const Eigen::Vector2d a = perimeter[i], edge = perimeter[(i + 1) % perimeter.size()] - a;
    const double along = std::clamp((to - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double distance = (to - a - along * edge).norm();
    if (nearest && distance >= least) continue;
    least = distance;
    const double t = cross(a - from, edge) / cross(to - from, edge);
    nearest = Entry{static_cast<int>(i), t, Eigen::Vector2d(edge.y(), -edge.x()).normalized()};
  }
  return nearest;
}

}  // namespace exercise
