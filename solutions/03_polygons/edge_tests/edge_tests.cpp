#include "edge_tests.hpp"

namespace exercise {

Eigen::Vector2d outward_normal(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  //? The edge as a vector, in the direction of the polygon.
  const Eigen::Vector2d edge = to - from;
  //? Counter-clockwise, the interior is to the left: rotate clockwise by a right angle.
  //? gap: edge.y(), -edge.x()
  return {edge.y(), -edge.x()};
}

double ahead(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  //? From any point of the edge to the point.
  //? gap: point - from
  return outward_normal(from, to).dot(point - from);
}

Where edge_tests(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point) {
  //? Whether the point is on the line of an edge.
  bool on_a_line = false;
  //? All edges must be asked, also the one from the last vertex to the first.
  //? gap: (i + 1) % polygon.size()
  //? gap: product > 0
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double product = ahead(point, polygon[i], polygon[(i + 1) % polygon.size()]);
    if (product > 0) return Where::outside;
    if (product == 0) on_a_line = true;
  }
  //? Only here it is known that the point is in front of no edge. On the line of one, it is on it.
  //? gap: on_a_line ? Where::on : Where::inside
  return on_a_line ? Where::on : Where::inside;
}

}  // namespace exercise
