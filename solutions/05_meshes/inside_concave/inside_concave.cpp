#include "inside_concave.hpp"

namespace exercise {

Eigen::Vector3d normal_of(const contact::Triangle<double>& triangle) {
  //? Perpendicular to two edges. Its length does not matter.
  //? gap: (triangle.b - triangle.a).cross(triangle.c - triangle.a)
  return (triangle.b - triangle.a).cross(triangle.c - triangle.a);
}

bool on_triangle(const Eigen::Vector3d& point, const contact::Triangle<double>& triangle) {
  //? First the plane: the product with the normal is 0 in it.
  //? gap: normal.dot(point - triangle.a) != 0
  const Eigen::Vector3d normal = normal_of(triangle);
  if (normal.dot(point - triangle.a) != 0) return false;
  //? Then the triangle: in the plane, the point is on the inner side of each edge, or on it.
  //? gap: (to - from).cross(point - from)
  //? gap: >= 0
  const auto is_inner = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(point - from)) >= 0;
  };
  return is_inner(triangle.a, triangle.b) && is_inner(triangle.b, triangle.c) &&
         is_inner(triangle.c, triangle.a);
}

// Whether the line through the point along z crosses the triangle. If it meets an edge, it is
// treated as if it were shifted a little in +y, and much less in +x.
bool line_crosses(const Eigen::Vector3d& point, const contact::Triangle<double>& triangle) {
  //? Seen along z, a ray in +x from a point inside crosses one or three edges of the triangle.
  bool inside = false;
  for (const auto& [from, to] :
       {std::pair{triangle.a, triangle.b}, std::pair{triangle.b, triangle.c},
        std::pair{triangle.c, triangle.a}}) {
    //? By the same comparison for every end, a vertex belongs to one of two edges that go on.
    //? gap: (from.y() > point.y()) == goes_up
    const bool goes_up = to.y() > point.y();
    if ((from.y() > point.y()) == goes_up) continue;
    //? Both triangles of an edge must compute the same: from its lower end to its upper one.
    //? gap: goes_up ? from : to
    const Eigen::Vector3d low = goes_up ? from : to;
    const Eigen::Vector3d high = goes_up ? to : from;
    //? Positive if the point is to the left of the edge.
    //? gap: left > 0
    const double left =
        (high.x() - low.x()) * (point.y() - low.y()) - (high.y() - low.y()) * (point.x() - low.x());
    if (left > 0) inside = !inside;
  }
  return inside;
}

Where inside_concave(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point) {
  //? Without a crossing the point is outside.
  bool inside = false;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const contact::Triangle<double> triangle = contact::triangle_of(mesh, i);
    //? On the surface no ray is needed.
    //? gap: on_triangle(point, triangle)
    if (on_triangle(point, triangle)) return Where::on;
    //? The line crosses the triangle above the point if its normal points up and the point is
    //? behind it, or if its normal points down and the point is in front.
    //? gap: line_crosses(point, triangle)
    //? gap: is_behind == (normal.z() > 0)
    const Eigen::Vector3d normal = normal_of(triangle);
    const bool is_behind = normal.dot(triangle.a - point) > 0;
    if (line_crosses(point, triangle) && is_behind == (normal.z() > 0)) inside = !inside;
  }
  //? Each crossing leads from inside to outside or back.
  //? gap: inside ? Where::inside : Where::outside
  return inside ? Where::inside : Where::outside;
}

}  // namespace exercise
