#include "wrap_step.hpp"

namespace exercise {
namespace {

// Positive if p is in front of the plane a, b, c.
double side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
            const Eigen::Vector3d& p) {
  //? The normal of the plane is the cross product of two edges; the dot product with p − a is
  //? positive in front of it.
  //? gap: (b - a).cross(c - a)
  return (p - a).dot((b - a).cross(c - a));
}

bool on_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  //? Parallel edges have the zero vector as cross product.
  return (b - a).cross(c - a) == Eigen::Vector3d(0, 0, 0);
}

}  // namespace

int wrap_step(const std::vector<Eigen::Vector3d>& points, int from, int to) {
  //? Short names keep the predicates below readable.
  const auto at = [&](std::size_t i) { return points[i]; };
  const Eigen::Vector3d f = at(static_cast<std::size_t>(from));
  const Eigen::Vector3d t = at(static_cast<std::size_t>(to));
  //? The first candidate must span a plane with the edge, so points on its line are skipped.
  //? gap: on_line(t, f, at(best))
  std::size_t best = 0;
  while (on_line(t, f, at(best))) ++best;
  //? A point in front of the plane of the candidate is a better candidate, as in searching for a
  //? maximum. At the end no point is in front. Of several points in its plane the first is kept,
  //? because the later ones are not in front.
  //? gap: side(t, f, at(best), at(i)) > 0
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (side(t, f, at(best), at(i)) > 0) best = i;
  }
  return static_cast<int>(best);
}

}  // namespace exercise
