#include "mesh_contacts.hpp"

namespace exercise {
namespace {

using Point = Eigen::Vector3d;
using Mesh = contact::Mesh<double>;

// Whether the point is on the triangle, its border included.
bool on_triangle(const Point& point, const contact::Triangle<double>& triangle) {
  const auto& [a, b, c] = triangle;
  const Point n = (b - a).cross(c - a);
  const auto is_inner = [&](const Point& from, const Point& to) {
    return n.dot((to - from).cross(point - from)) >= 0;
  };
  return n.dot(point - a) == 0 && is_inner(a, b) && is_inner(b, c) && is_inner(c, a);
}

// Whether the point is on the edge, its ends included.
bool on_edge(const Point& point, const contact::Segment<double>& edge) {
  const Point to_start = edge.start - point, to_end = edge.end - point;
  return to_start.cross(to_end).isZero(0) && to_start.dot(to_end) <= 0;
}

// The point where two edges cross between their ends.
std::optional<Point> crossing(const contact::Segment<double>& a,
                              const contact::Segment<double>& b) {
  const Point u = a.end - a.start, v = b.end - b.start, w = b.start - a.start, n = u.cross(v);
  if (n.isZero(0) || n.dot(w) != 0) return std::nullopt;
  const double s = w.cross(v).dot(n) / n.dot(n), t = w.cross(u).dot(n) / n.dot(n);
  if (std::min(s, t) <= 0 || std::max(s, t) >= 1) return std::nullopt;
  return a.start + s * u;
}

Point at(const Mesh& mesh, int vertex) { return mesh.vertices[static_cast<std::size_t>(vertex)]; }

contact::Segment<double> segment(const Mesh& mesh, const Feature& edge) {
  return {at(mesh, edge[0]), at(mesh, edge[1])};
}

// An edge as one of its triangles has it, and the third vertex of this triangle.
struct Side {
  int from, to, opposite;
};

// The three edges of each triangle, so that each edge of the mesh comes twice.
std::vector<Side> sides_of(const Mesh& mesh) {
  std::vector<Side> sides;
  for (const auto& [i, j, k] : mesh.triangles)
    sides.insert(sides.end(), {Side{i, j, k}, Side{j, k, i}, Side{k, i, j}});
  return sides;
}

}  // namespace

std::vector<Feature> edges_of(const contact::Mesh<double>& mesh) {
  //? Each edge comes twice, and so any two sides may be those of one edge.
  const std::vector<Side> sides = sides_of(mesh);
  std::vector<Feature> edges;
  for (const Side& one : sides) {
    for (const Side& other : sides) {
      //? The same edge in the other triangle has the opposite direction. Of the two, the one that
      //? goes from the lower index to the higher one gives the name.
      //? gap: one.from < one.to
      //? gap: other.from == one.to && other.to == one.from
      const bool is_pair = other.from == one.to && other.to == one.from;
      if (!(is_pair && one.from < one.to)) continue;
      //? In one plane, the two triangles make a flat face: the product of three vectors is 0.
      //? gap: (at(mesh, one.to) - a).cross(at(mesh, one.opposite) - a)
      //? gap: n.dot(at(mesh, other.opposite) - a) != 0
      const Point a = at(mesh, one.from);
      const Point n = (at(mesh, one.to) - a).cross(at(mesh, one.opposite) - a);
      if (n.dot(at(mesh, other.opposite) - a) != 0) edges.push_back({one.from, one.to, -1});
    }
  }
  //? The triangles may come in any order.
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::optional<Feature> feature_at(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point) {
  //? The smallest features come first: a vertex, then an edge of the body.
  //? gap: mesh.vertices[v] == point
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v] == point) return Feature{static_cast<int>(v), -1, -1};
  }
  //? Flat edges are not among these.
  //? gap: edges_of(mesh)
  for (const Feature& edge : edges_of(mesh)) {
    if (on_edge(point, segment(mesh, edge))) return edge;
  }
  //? Otherwise it is inside a face. The first triangle names it, its indices in order.
  //? gap: on_triangle(point, contact::triangle_of(mesh, i))
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!on_triangle(point, contact::triangle_of(mesh, i))) continue;
    Feature face = mesh.triangles[i];
    std::sort(face.begin(), face.end());
    return face;
  }
  return std::nullopt;
}

std::vector<MeshContact> mesh_contacts(const contact::Mesh<double>& a,
                                       const contact::Mesh<double>& b) {
  std::vector<MeshContact> contacts;
  //? A vertex of A: whatever it touches, it has one smallest feature of B.
  //? gap: feature_at(b, a.vertices[v])
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    const std::optional<Feature> of_b = feature_at(b, a.vertices[v]);
    if (of_b) contacts.push_back({{static_cast<int>(v), -1, -1}, *of_b, a.vertices[v]});
  }
  //? A vertex of B on one of A is in the list already.
  //? gap: !of_a || (*of_a)[1] < 0
  for (std::size_t v = 0; v < b.vertices.size(); ++v) {
    const std::optional<Feature> of_a = feature_at(a, b.vertices[v]);
    if (!of_a || (*of_a)[1] < 0) continue;
    contacts.push_back({*of_a, {static_cast<int>(v), -1, -1}, b.vertices[v]});
  }
  //? Edges that cross between their ends. Each edge of a body is asked once, not once for each of
  //? its triangles.
  //? gap: crossing(segment(a, of_a), segment(b, of_b))
  for (const Feature& of_a : edges_of(a)) {
    for (const Feature& of_b : edges_of(b)) {
      const std::optional<Point> position = crossing(segment(a, of_a), segment(b, of_b));
      if (position) contacts.push_back({of_a, of_b, *position});
    }
  }
  //? In the order of the names.
  //? gap: std::tie(x.of_a, x.of_b) < std::tie(y.of_a, y.of_b)
  std::sort(contacts.begin(), contacts.end(), [](const MeshContact& x, const MeshContact& y) {
    return std::tie(x.of_a, x.of_b) < std::tie(y.of_a, y.of_b);
  });
  return contacts;
}

}  // namespace exercise
