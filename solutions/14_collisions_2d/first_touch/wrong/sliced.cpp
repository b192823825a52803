// misconception: sliced-time
// caught by: one disc meets one at rest
// seen: FCA, slide "How About 2 MOVING spheres?"
#include "first_touch.hpp"

namespace exercise {

std::optional<Touch> first_touch(const std::vector<Disc>& discs) {
  const double slice = 0.01;
  for (int k = 0; k <= 2000; ++k) {
    const double t = k * slice;
    for (int i = 0; i < static_cast<int>(discs.size()); ++i) {
      for (int j = i + 1; j < static_cast<int>(discs.size()); ++j) {
        const Disc& a = discs[static_cast<std::size_t>(i)];
        const Disc& b = discs[static_cast<std::size_t>(j)];
        const Eigen::Vector2d w = a.velocity - b.velocity;
        const Eigen::Vector2d d = a.centre - b.centre + t * w;
        if (d.norm() <= a.radius + b.radius && d.dot(w) < 0) return Touch{i, j, t};
      }
    }
  }
  return std::nullopt;
}

}  // namespace exercise
