#include "crossings.hpp"

namespace exercise {

bool crosses(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  //? Whether the edge ends above the ray.
  //? gap: to.y() > point.y()
  const bool ends_above = to.y() > point.y();
  //? Both ends are above, or neither is: the ray's line is not crossed. By the same comparison for
  //? every end, a vertex belongs to one of two edges that go on in the same direction.
  //? gap: (from.y() > point.y()) == ends_above
  if ((from.y() > point.y()) == ends_above) return false;
  //? Positive if the point is to the left of the edge.
  //? gap: to.x() - from.x()
  const double left =
      (to.x() - from.x()) * (point.y() - from.y()) - (to.y() - from.y()) * (point.x() - from.x());
  //? An edge that goes up is to the right of a point on its left, and one that goes down is to the
  //? right of a point on its right.
  //? gap: (left > 0) == ends_above
  return (left > 0) == ends_above;
}

bool crossings(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point) {
  //? Without a crossing the point is outside.
  bool inside = false;
  //? Each crossing leads from inside to outside or back.
  //? gap: (i + 1) % polygon.size()
  //? gap: inside = !inside
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& next = polygon[(i + 1) % polygon.size()];
    if (crosses(point, polygon[i], next)) inside = !inside;
  }
  //? The last state is that of an odd or an even number.
  return inside;
}

}  // namespace exercise
