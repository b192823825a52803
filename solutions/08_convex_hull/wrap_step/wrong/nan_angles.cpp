// misconception: none
// caught by: the next face of a box and of a pyramid is found
// seen: a first reader of this book
#include "wrap_step.hpp"

namespace exercise {
namespace {

bool on_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b - a).cross(c - a) == Eigen::Vector3d(0, 0, 0);
}

// The first point of the known face that is not on the line of the edge.
int inner_of(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& f,
             const Eigen::Vector3d& t) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d normal = (t - f).cross(points[i] - f);
    bool face = !on_line(t, f, points[i]);
    for (const Eigen::Vector3d& p : points) face = face && normal.dot(p - f) <= 0;
    if (face) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

int wrap_step(const std::vector<Eigen::Vector3d>& points, int from, int to) {
  const auto at = [&](std::size_t i) { return points[i]; };
  const Eigen::Vector3d f = at(static_cast<std::size_t>(from));
  const Eigen::Vector3d t = at(static_cast<std::size_t>(to));
  const int inner = inner_of(points, f, t);
  // A normal of length 0 makes every cosine 0/0: NaN.
  const Eigen::Vector3d normal = (t - f).cross(f - t);
  double least = 4;
  int best = 0;
  while (on_line(t, f, at(static_cast<std::size_t>(best)))) ++best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (on_line(t, f, at(i)) || static_cast<int>(i) == inner) continue;
    const Eigen::Vector3d turned = (f - t).cross(at(i) - t);
    const double cosine = normal.dot(turned) / (normal.norm() * turned.norm());
    const double angle = std::acos(cosine);
    if (angle < least) {
      least = angle;
      best = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace exercise
