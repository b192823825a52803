#include "mesh_contacts.hpp"

namespace exercise {
namespace {

// What is in this namespace is given: you may use it.

using Point = Eigen::Vector3d;
using Mesh = contact::Mesh<double>;

// Whether the point is on the triangle, its border included.
[[maybe_unused]] bool on_triangle(const Point& point, const contact::Triangle<double>& triangle) {
  const auto& [a, b, c] = triangle;
  const Point n = (b - a).cross(c - a);
  const auto is_inner = [&](const Point& from, const Point& to) {
    return n.dot((to - from).cross(point - from)) >= 0;
  };
  return n.dot(point - a) == 0 && is_inner(a, b) && is_inner(b, c) && is_inner(c, a);
}

// Whether the point is on the edge, its ends included.
[[maybe_unused]] bool on_edge(const Point& point, const contact::Segment<double>& edge) {
  const Point to_start = edge.start - point, to_end = edge.end - point;
  return to_start.cross(to_end).isZero(0) && to_start.dot(to_end) <= 0;
}

// The point where two edges cross between their ends.
[[maybe_unused]] std::optional<Point> crossing(const contact::Segment<double>& a,
                                               const contact::Segment<double>& b) {
  const Point u = a.end - a.start, v = b.end - b.start, w = b.start - a.start, n = u.cross(v);
  if (n.isZero(0) || n.dot(w) != 0) return std::nullopt;
  const double s = w.cross(v).dot(n) / n.dot(n), t = w.cross(u).dot(n) / n.dot(n);
  if (std::min(s, t) <= 0 || std::max(s, t) >= 1) return std::nullopt;
  return a.start + s * u;
}

[[maybe_unused]] Point at(const Mesh& mesh, int vertex) {
  return mesh.vertices[static_cast<std::size_t>(vertex)];
}

[[maybe_unused]] contact::Segment<double> segment(const Mesh& mesh, const Feature& edge) {
  return {at(mesh, edge[0]), at(mesh, edge[1])};
}

// An edge as one of its triangles has it, and the third vertex of this triangle.
struct Side {
  int from, to, opposite;
};

// The three edges of each triangle, so that each edge of the mesh comes twice.
[[maybe_unused]] std::vector<Side> sides_of(const Mesh& mesh) {
  std::vector<Side> sides;
  for (const auto& [i, j, k] : mesh.triangles)
    sides.insert(sides.end(), {Side{i, j, k}, Side{j, k, i}, Side{k, i, j}});
  return sides;
}

}  // namespace

std::vector<Feature> edges_of(const contact::Mesh<double>& /*mesh*/) { contact::todo(); }

std::optional<Feature> feature_at(const contact::Mesh<double>& /*mesh*/,
                                  const Eigen::Vector3d& /*point*/) {
  contact::todo();
}

std::vector<MeshContact> mesh_contacts(const contact::Mesh<double>& /*a*/,
                                       const contact::Mesh<double>& /*b*/) {
  contact::todo();
}

}  // namespace exercise
