#include "first_touch.hpp"

namespace exercise {

namespace {

std::optional<double> touch(const Disc& a, const Disc& b) {
  const Eigen::Vector2d d = a.centre - b.centre;
  const Eigen::Vector2d w = a.velocity - b.velocity;
  const double radius_sum = a.radius + b.radius;
  const double approach = -d.dot(w);
  if (!(approach > 0)) return std::nullopt;
  const double gap = d.squaredNorm() - radius_sum * radius_sum;
  if (gap <= 0) return 0;
  const double root = approach * approach - w.squaredNorm() * gap;
  if (root < 0) return std::nullopt;
  return gap / (approach + std::sqrt(root));
}

}  // namespace

std::optional<Touch> first_touch(const std::vector<Disc>& discs) {
  std::optional<Touch> first;
  for (int i = 0; i < static_cast<int>(discs.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(discs.size()); ++j) {
      const auto time =
          touch(discs[static_cast<std::size_t>(i)], discs[static_cast<std::size_t>(j)]);
      if (time && (!first || *time < first->time)) first = Touch{i, j, *time};
    }
  }
  return first;
}

}  // namespace exercise
