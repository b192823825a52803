#include "perimeter_normal.hpp"

namespace exercise {
namespace {

double cross(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  return u.x() * v.y() - u.y() * v.x();
}

}  // namespace

std::optional<Entry> perimeter_normal(const std::vector<Eigen::Vector2d>& perimeter,
                                      const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d movement = to - from;
  std::optional<Entry> first;
  for (std::size_t i = 0; i < perimeter.size(); ++i) {
    const Eigen::Vector2d& a = perimeter[i];
    const Eigen::Vector2d edge = perimeter[(i + 1) % perimeter.size()] - a;
    // from + t movement = a + along edge
    const double determinant = cross(movement, edge);
    if (determinant == 0) continue;
    const double t = cross(a - from, edge) / determinant;
    const double along = cross(a - from, movement) / determinant;
    if (!(t >= 0 && t <= 1 && along >= 0 && along <= 1)) continue;
    if (!first || t < first->t) {
      const Eigen::Vector2d outward(edge.y(), -edge.x());
      first = Entry{static_cast<int>(i), t, outward.normalized()};
    }
  }
  return first;
}

}  // namespace exercise
