// misconception: nearest-point
// caught by: the next face of a box and of a pyramid is found
// seen: not found
#include "wrap_step.hpp"

namespace exercise {
namespace {

bool on_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b - a).cross(c - a) == Eigen::Vector3d(0, 0, 0);
}

}  // namespace

int wrap_step(const std::vector<Eigen::Vector3d>& points, int from, int to) {
  const auto at = [&](std::size_t i) { return points[i]; };
  const Eigen::Vector3d f = at(static_cast<std::size_t>(from));
  const Eigen::Vector3d t = at(static_cast<std::size_t>(to));
  int best = -1;
  double least = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (on_line(t, f, at(i))) continue;
    const double distance = (t - f).cross(at(i) - f).squaredNorm();
    if (least < 0 || distance < least) {
      least = distance;
      best = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace exercise
