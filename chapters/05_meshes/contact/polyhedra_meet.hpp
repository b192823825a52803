/// @file
/// Two polyhedra: edges of one against faces of the other, vertices of one inside the other, and
/// the ordered test of both, with the number of tests that it takes.
#pragma once

#include <algorithm>
#include <array>
#include <contact/aabb.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/orientation.hpp>
#include <contact/segments.hpp>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace contact {

// [edge-meets-face]
/// Whether a segment and a triangle have a point in common, decided without error.
///
/// As in the lecture: the ends must not both be on the same side of the plane, and the segment must
/// pass all three edges on the same side. The point itself is never computed, so nothing is
/// rounded. A segment in the plane of the triangle meets it if it starts in it or meets an edge,
/// which is decided in a projection. Touching counts. A triangle without area meets nothing: in a
/// closed mesh its longest edge belongs to other triangles too. A segment of length 0 is a point.
/// A coordinate that is not finite: false.
///
/// Source: *Interaction and Normals*, slide "Collision detection: polyhedra" (edge intersection
/// face test).
inline bool edge_meets_face(const Segment<double>& edge, const Triangle<double>& face) {
  const auto& [start, end] = edge;
  const auto& [a, b, c] = face;
  if (!all_finite(start) || !all_finite(end)) return false;
  if (!mesh_location_detail::finite_triangle(face)) return false;
  const int at_start = orient_3d(a, b, c, start), at_end = orient_3d(a, b, c, end);
  if (at_start * at_end > 0) return false;
  if (at_start != 0 || at_end != 0) {
    const int ab = orient_3d(start, end, a, b);
    const int bc = orient_3d(start, end, b, c);
    if (ab * bc < 0) return false;
    const int ca = orient_3d(start, end, c, a);
    return bc * ca >= 0 && ca * ab >= 0;
  }
  const auto [dropped, orientation] = flat_view(a, b, c);
  if (orientation == 0) return false;
  if (on_triangle(start, face)) return true;
  const auto flat = [k = dropped](const Vector3<double>& v) {
    return drop_dimension<double>(v, k);
  };
  const Segment2<double> s{flat(start), flat(end)};
  return meet(s, {flat(a), flat(b)}) != Meeting::none ||
         meet(s, {flat(b), flat(c)}) != Meeting::none ||
         meet(s, {flat(c), flat(a)}) != Meeting::none;
}
// [/edge-meets-face]

/// How many tests of each kind were made.
struct PolyhedraCounts {
  long boxes = 0;      ///< boxes compared with a box or a point
  long crossings = 0;  ///< triangles tested against the ray from a vertex
  long edge_face = 0;  ///< edges tested against a face
};

/// An edge of one mesh that meets a face of another.
struct EdgeFace {
  std::array<int, 2> edge{};  ///< its vertices, the lower index first
  int face = 0;               ///< the triangle's index
};

namespace polyhedra_detail {

/// Each edge once, its lower vertex first, in increasing order.
template <FloatOrDouble S>
std::vector<std::array<int, 2>> edges_once(const Mesh<S>& mesh) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [i, j] : {std::pair{a, b}, {b, c}, {c, a}}) {
      edges.push_back({std::min(i, j), std::max(i, j)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The box of some points that are known to be finite.
template <FloatOrDouble S>
Aabb<S> box_of(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c) {
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

/// A mesh with what the tests need of it.
template <FloatOrDouble S>
struct Prepared {
  const Mesh<S>& mesh;
  std::vector<std::array<int, 2>> edges;
  std::vector<Aabb<S>> boxes;  ///< of the triangles
  std::vector<char> used;      ///< whether a triangle uses the vertex
  Aabb<S> box;
  bool usable = true;  ///< has triangles, all finite

  explicit Prepared(const Mesh<S>& given)
      : mesh(given), edges(edges_once(given)), used(given.vertices.size(), 0) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto [a, b, c] = triangle_of(mesh, i);
      usable = usable && all_finite(a) && all_finite(b) && all_finite(c);
      boxes.push_back(box_of<S>(a, b, c));
      box = i == 0 ? boxes.back() : enclosing_box(box, boxes.back());
      for (const int v : mesh.triangles[i]) used[static_cast<std::size_t>(v)] = 1;
    }
    usable = usable && !mesh.triangles.empty();
  }
  const Vector3<S>& vertex(int i) const { return mesh.vertices[static_cast<std::size_t>(i)]; }
};

/// The first vertex of a, among those wanted, that is in b or on it.
template <FloatOrDouble S>
std::optional<int> vertex_inside(const Prepared<S>& a, const std::vector<char>& wanted,
                                 const Prepared<S>& b, PolyhedraCounts& counts) {
  for (std::size_t i = 0; i < a.mesh.vertices.size(); ++i) {
    if (wanted[i] == 0) continue;
    const Vector3<S>& p = a.mesh.vertices[i];
    ++counts.boxes;
    if (!boxes_touch(Aabb<S>{p, p}, b.box)) continue;
    const MeshLocation found =
        mesh_location_detail::locate(p, b.mesh, Rule::non_zero, counts.crossings);
    if (found.where != Where::outside) return static_cast<int>(i);
  }
  return std::nullopt;
}

/// The first edge of a that meets a face of b.
template <FloatOrDouble S>
std::optional<EdgeFace> edge_face(const Prepared<S>& a, const Prepared<S>& b,
                                  PolyhedraCounts& counts) {
  for (const auto& [i, j] : a.edges) {
    const Vector3<S>&start = a.vertex(i), &end = a.vertex(j);
    const Aabb<S> edge_box = box_of<S>(start, end, end);
    ++counts.boxes;
    if (!boxes_touch(edge_box, b.box)) continue;
    const Segment<double> edge = in_double(Segment<S>{start, end});
    for (std::size_t face = 0; face < b.boxes.size(); ++face) {
      ++counts.boxes;
      if (!boxes_touch(edge_box, b.boxes[face])) continue;
      ++counts.edge_face;
      if (edge_meets_face(edge, in_double(triangle_of(b.mesh, face)))) {
        return EdgeFace{{i, j}, static_cast<int>(face)};
      }
    }
  }
  return std::nullopt;
}

/// The first used vertex of each connected component.
template <FloatOrDouble S>
std::vector<char> one_of_each_component(const Prepared<S>& a) {
  mesh_check_detail::Sets components(a.mesh.vertices.size());
  for (const auto& [i, j] : a.edges) components.unite(i, j);
  std::vector<char> first(a.mesh.vertices.size(), 0);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const int v = static_cast<int>(i);
    if (a.used[i] != 0 && components.find(v) == v) first[i] = 1;
  }
  return first;
}

}  // namespace polyhedra_detail

// [edges-meet-faces]
/// The first edge of a that meets a face of b, and the first such face; each edge is tested against
/// each face whose box it touches. Exact; touching counts, also at a vertex and along an edge.
///
/// Both ways around, a against b and b against a, it finds whether the surfaces meet: where two
/// triangles with area meet, an edge of one meets the other. Triangles without area have edges but
/// no face: two meshes that have no others may cross unfound. It does not find a polyhedron inside
/// another.
/// A mesh without triangles, or with one that is not finite: nothing.
///
/// Source: *Interaction and Normals*, slide "Collision detection: polyhedra".
template <FloatOrDouble S>
std::optional<EdgeFace> edges_meet_faces(const Mesh<S>& a, const Mesh<S>& b) {
  const polyhedra_detail::Prepared<S> first(a), second(b);
  if (!first.usable || !second.usable) return std::nullopt;
  PolyhedraCounts counts;
  return polyhedra_detail::edge_face(first, second, counts);
}
// [/edges-meet-faces]

/// The first vertex of a that is in b or on its surface, decided by `locate_in_mesh`; b must be
/// closed and oriented, and may be concave. Vertices that no triangle uses are left out.
///
/// A mesh without triangles, or with one that is not finite: nothing.
template <FloatOrDouble S>
std::optional<int> vertices_inside(const Mesh<S>& a, const Mesh<S>& b) {
  const polyhedra_detail::Prepared<S> first(a), second(b);
  if (!first.usable || !second.usable) return std::nullopt;
  PolyhedraCounts counts;
  return polyhedra_detail::vertex_inside(first, first.used, second, counts);
}

/// Which test decided about two polyhedra.
enum class DecidedBy {
  boxes,        ///< their boxes are apart
  vertex_of_a,  ///< a vertex of a is in b
  vertex_of_b,  ///< a vertex of b is in a
  edge_of_a,    ///< an edge of a meets a face of b
  edge_of_b,    ///< an edge of b meets a face of a
  all           ///< no test that was made found a common point
};

/// Which tests are made, and in which order.
enum class PolyhedraOrder {
  lecture,      ///< boxes, all vertices both ways, edges against faces both ways
  edges_first,  ///< boxes, edges against faces both ways, one vertex of each component both ways
  vertices,     ///< boxes and vertices alone: misses bodies that cross without a vertex inside
  edges         ///< boxes and edges against faces alone: misses a body inside the other
};

/// The answer to whether two polyhedra meet.
struct PolyhedraTest {
  bool meet = false;                      ///< whether a common point was found
  DecidedBy decided_by = DecidedBy::all;  ///< the test that decided
  PolyhedraCounts counts;                 ///< the tests that were made up to then
};

// [polyhedra-meet]
/// Whether two solid polyhedra have a point in common: the lecture's ordered test, with exact
/// decisions.
///
/// Cheap tests that decide many pairs come first: boxes reject most pairs that are apart; a vertex
/// inside the other body accepts most that overlap; edges against faces, the most expensive, decide
/// the rest.
///
/// With the orders `lecture` and `edges_first` the answer is right for closed, oriented meshes
/// with finite vertices in which each component has a triangle with area, concave and of several
/// components: if the surfaces meet, an edge of one meets a face of the other; if they do not, each
/// component of a surface is in the other solid as a whole or not at all, so one vertex of it
/// decides, and if none is, the solids are apart. A solid here is what the surface has a winding
/// number other than 0 around, and the surface itself. Touching counts. `vertices` and `edges` show
/// what a test alone misses. A mesh that is not closed: only what edges against faces find means
/// anything. A mesh without triangles, or with one that is not finite: they do not meet.
///
/// Limits: the time grows as the product of the numbers of edges and faces, because no tree is
/// used.
///
/// Source: *Interaction and Normals*, slides "Collision detection: polyhedra": the tests in the
/// order of their cost and of their power.
template <FloatOrDouble S>
PolyhedraTest polyhedra_meet(const Mesh<S>& a, const Mesh<S>& b,
                             PolyhedraOrder order = PolyhedraOrder::lecture) {
  using namespace polyhedra_detail;
  const Prepared<S> first(a), second(b);
  PolyhedraTest test;
  PolyhedraCounts& counts = test.counts;
  if (!first.usable || !second.usable) return test;
  const auto decided = [&test](DecidedBy by) {
    test.meet = true;
    test.decided_by = by;
    return test;
  };
  ++counts.boxes;
  if (!boxes_touch(first.box, second.box)) {
    test.decided_by = DecidedBy::boxes;
    return test;
  }
  const bool vertices_first = order == PolyhedraOrder::lecture || order == PolyhedraOrder::vertices;
  if (vertices_first) {
    if (vertex_inside(first, first.used, second, counts)) return decided(DecidedBy::vertex_of_a);
    if (vertex_inside(second, second.used, first, counts)) return decided(DecidedBy::vertex_of_b);
  }
  if (order != PolyhedraOrder::vertices) {
    if (edge_face(first, second, counts)) return decided(DecidedBy::edge_of_a);
    if (edge_face(second, first, counts)) return decided(DecidedBy::edge_of_b);
  }
  if (order == PolyhedraOrder::edges_first) {
    const auto of_first = one_of_each_component(first), of_second = one_of_each_component(second);
    if (vertex_inside(first, of_first, second, counts)) return decided(DecidedBy::vertex_of_a);
    if (vertex_inside(second, of_second, first, counts)) return decided(DecidedBy::vertex_of_b);
  }
  return test;
}
// [/polyhedra-meet]

}  // namespace contact
