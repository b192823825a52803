#include "separating_axis.hpp"

namespace exercise {

namespace {

// How far the polygon reaches along the direction: the largest dot product of one of its points.
double largest_projection(const Eigen::Vector2d& direction,
                          const std::vector<Eigen::Vector2d>& polygon) {
  //? All dot products may be negative, so the search starts below all of them.
  //? gap: -std::numeric_limits<double>::infinity()
  double largest = -std::numeric_limits<double>::infinity();
  //? Points between vertices project between the projections of these.
  //? gap: direction.dot(p)
  for (const Eigen::Vector2d& p : polygon) largest = std::max(largest, direction.dot(p));
  return largest;
}

}  // namespace

bool separates(const Eigen::Vector2d& direction, const std::vector<Eigen::Vector2d>& first,
               const std::vector<Eigen::Vector2d>& second) {
  //? The first polygon ends at its farthest vertex. The second begins at its nearest one, which is
  //? the farthest in the opposite direction.
  //? gap: -largest_projection(-direction, second)
  const double end = largest_projection(direction, first),
               begin = -largest_projection(-direction, second);
  //? If they are equal, a line perpendicular to the direction touches both: that is not apart.
  //? gap: end < begin
  return end < begin;
}

std::optional<Eigen::Vector2d> separating_axis(const std::vector<Eigen::Vector2d>& first,
                                               const std::vector<Eigen::Vector2d>& second) {
  //? Outwards from an edge of a counter-clockwise polygon is to the right of it. The last edge ends
  //? at the first vertex, and a segment has two edges, one for each side.
  //? gap: polygon[(i + 1) % polygon.size()] - polygon[i]
  //? gap: Eigen::Vector2d(edge.y(), -edge.x())
  const auto outwards = [](const std::vector<Eigen::Vector2d>& polygon, std::size_t i) {
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    return Eigen::Vector2d(edge.y(), -edge.x());
  };
  //? The second polygon may be in front of an edge of the first.
  //? gap: separates(n, first, second)
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Eigen::Vector2d n = outwards(first, i);
    if (separates(n, first, second)) return n;
  }
  //? Or the first is in front of an edge of the second. From the first to the second is inwards.
  //? gap: -outwards(second, i)
  for (std::size_t i = 0; i < second.size(); ++i) {
    const Eigen::Vector2d n = -outwards(second, i);
    if (separates(n, first, second)) return n;
  }
  //? Two points, or points and segments on one line, may be apart along this line only.
  //? gap: second.front() - first.front()
  const Eigen::Vector2d along = second.front() - first.front();
  if (separates(along, first, second)) return along;
  //? No other line could separate them.
  return std::nullopt;
}

}  // namespace exercise
