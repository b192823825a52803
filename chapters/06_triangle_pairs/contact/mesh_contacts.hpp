/// @file
/// The contacts of two meshes, each counted once, however many triangles share it.
#pragma once

#include <algorithm>
#include <array>
#include <contact/exact_ray_triangle.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_features.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/orientation.hpp>
#include <contact/shapes.hpp>
#include <contact/triangle_features.hpp>
#include <contact/triangle_intersection.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <tuple>
#include <vector>

namespace contact {

// [mesh-contact]
/// A point that two meshes have in common, and the smallest feature of each that contains it.
template <FloatOrDouble S>
struct MeshContact {
  NamedFeature of_first;                     ///< of the first mesh
  NamedFeature of_second;                    ///< of the second mesh
  Vector3<S> position = Vector3<S>::Zero();  ///< m
  S bound = S(0);  ///< m; each coordinate of the exact point differs by at most this

  /// Which of the six kinds it is, from the two features alone.
  ContactKind kind() const { return contact_kind(of_first.kind, of_second.kind); }
};
// [/mesh-contact]

namespace mesh_contacts_detail {

/// Calls each(pair, point, bound) for each common point of each pair of triangles that meet.
template <FloatOrDouble S, class Each>
void each_common_point(const MeshTree<S>& a, const MeshTree<S>& b, const Each& each) {
  for (const TrianglePair& pair : meeting_triangles(a, b)) {
    const auto common =
        intersect_triangles(triangle_of(a.mesh(), static_cast<std::size_t>(pair.of_first)),
                            triangle_of(b.mesh(), static_cast<std::size_t>(pair.of_second)));
    for (int i = 0; i < common.count; ++i) {
      each(pair, common.points[static_cast<std::size_t>(i)], common.bound);
    }
  }
}

/// The name of a feature of a triangle, as if the mesh had no other triangle.
template <FloatOrDouble S>
NamedFeature triangle_feature(const Mesh<S>& mesh, int triangle, const Feature& feature) {
  std::array<int, 3> t = mesh.triangles[static_cast<std::size_t>(triangle)];
  const auto index = static_cast<std::size_t>(feature.index);
  if (feature.kind == FeatureKind::vertex) return {FeatureKind::vertex, {t[index], -1, -1}};
  const auto [low, high] = std::minmax(t[index], t[(index + 1) % 3]);
  if (feature.kind == FeatureKind::edge) return {FeatureKind::edge, {low, high, -1}};
  std::sort(t.begin(), t.end());
  return {FeatureKind::face, t};
}

/// A mesh in which equal vertices have one index, and the names of its features.
template <FloatOrDouble S>
class NamedMesh {
 public:
  explicit NamedMesh(const Mesh<S>& mesh) : merged_(prepared(mesh)), names_(merged_) {}
  NamedMesh(const NamedMesh&) = delete;
  NamedMesh& operator=(const NamedMesh&) = delete;

  NamedFeature name(int triangle, const Feature& feature) {
    return names_.of(static_cast<std::size_t>(triangle), feature);
  }
  Vector3<double> vertex(int v) const {
    return merged_.vertices[static_cast<std::size_t>(v)].template cast<double>();
  }
  /// Whether an edge of another mesh lies in the plane of a triangle.
  bool has_in_plane(int triangle, const NamedMesh& other, const NamedFeature& edge) const {
    const std::array<int, 3>& t = merged_.triangles[static_cast<std::size_t>(triangle)];
    return std::all_of(edge.vertices.begin(), edge.vertices.begin() + 2, [&](int v) {
      return orient_3d(vertex(t[0]), vertex(t[1]), vertex(t[2]), other.vertex(v)) == 0;
    });
  }

 private:
  Mesh<S> merged_;
  FeatureNames names_;

  /// A triangle that is not finite meets nothing and has no edges: it becomes a point.
  static Mesh<S> prepared(const Mesh<S>& mesh) {
    Mesh<S> merged = merge_equal_vertices(mesh);
    for (auto& t : merged.triangles) {
      const bool finite = std::all_of(t.begin(), t.end(), [&merged](int v) {
        return all_finite(merged.vertices[static_cast<std::size_t>(v)]);
      });
      if (!finite) t = {t[0], t[0], t[0]};
    }
    return merged;
  }
};

// [isolated]
/// Whether a common point of two triangles is one of the meshes too: whether their features f and
/// g, extended to planes or lines, meet in this point alone.
///
/// A point on a flat edge is inside a face. There an edge of the other mesh meets the face in one
/// point if it is not in its plane. Two faces have a segment or a region in common, and it is no
/// end of that if both features are faces.
template <FloatOrDouble S>
bool is_isolated(const NamedFeature& f, const NamedFeature& g, const TrianglePair& pair,
                 const NamedMesh<S>& a, const NamedMesh<S>& b) {
  const bool f_is_face = f.kind == FeatureKind::face, g_is_face = g.kind == FeatureKind::face;
  if (f_is_face && g.kind == FeatureKind::edge) return !a.has_in_plane(pair.of_first, b, g);
  if (g_is_face && f.kind == FeatureKind::edge) return !b.has_in_plane(pair.of_second, a, f);
  return !(f_is_face && g_is_face);
}
// [/isolated]

/// By names, then the most accurate position, then any order that depends on the position alone.
template <FloatOrDouble S>
auto key(const MeshContact<S>& c) {
  return std::tuple(c.of_first, c.of_second, c.bound, c.position.x(), c.position.y(),
                    c.position.z());
}

}  // namespace mesh_contacts_detail

// [mesh-contacts]
/// The isolated points of what two meshes have in common, each once, sorted by the names of the two
/// features: where they touch, the vertices of the region, and where they cross, the points in
/// which an edge of one passes through a face or an edge of the other.
///
/// A contact is identified by the smallest features of the two meshes that contain it: a vertex
/// rather than its edges, an edge rather than its faces. Equal names are one contact. Names are
/// decided exactly, so no tolerance merges what is apart. Each position is the most accurate of
/// those that the pairs of triangles give; a vertex is copied.
///
/// Flat edges are no edges, but inside a face (see FeatureNames), so how a flat face is divided
/// into triangles changes nothing; each vertex stays a feature, also inside a flat face. Equal
/// vertices count as one, the first of them: a soup has the contacts of the mesh that it was. A
/// triangle with a coordinate that is not finite is left out, and one without area is the segment
/// or the point that it is. An empty mesh has no contacts. The list is the same for every order of
/// the triangles, but for the names of faces, and of two meshes swapped it is the same with the
/// features swapped.
///
/// Limits: if a mesh touches or crosses itself at a contact (also a vertex inside an edge that is
/// not divided there), each pair of its features has one there. O(n log n) for the names, besides
/// the time of `meeting_triangles`.
/// @param a m
/// @param b m
template <FloatOrDouble S>
std::vector<MeshContact<S>> mesh_contacts(const MeshTree<S>& a, const MeshTree<S>& b) {
  using namespace mesh_contacts_detail;
  NamedMesh<S> of_a(a.mesh()), of_b(b.mesh());
  std::vector<MeshContact<S>> contacts;
  each_common_point(a, b, [&](const TrianglePair& pair, const CommonPoint<S>& point, S bound) {
    const NamedFeature f = of_a.name(pair.of_first, point.of_first);
    const NamedFeature g = of_b.name(pair.of_second, point.of_second);
    if (!is_isolated(f, g, pair, of_a, of_b)) return;
    const bool copied = f.kind == FeatureKind::vertex || g.kind == FeatureKind::vertex;
    contacts.push_back({f, g, point.position, copied ? S(0) : bound});
  });
  std::sort(contacts.begin(), contacts.end(),
            [](const auto& x, const auto& y) { return key(x) < key(y); });
  const auto same = [](const MeshContact<S>& x, const MeshContact<S>& y) {
    return x.of_first == y.of_first && x.of_second == y.of_second;
  };
  contacts.erase(std::unique(contacts.begin(), contacts.end(), same), contacts.end());
  return contacts;
}
/// The same of two meshes for which no trees are there yet.
/// @throws std::invalid_argument if a triangle names a vertex that does not exist
template <FloatOrDouble S>
std::vector<MeshContact<S>> mesh_contacts(const Mesh<S>& a, const Mesh<S>& b) {
  return mesh_contacts(MeshTree<S>(a), MeshTree<S>(b));
}
// [/mesh-contacts]

// [contacts-of-pairs]
/// For comparison: the points of each pair of triangles that meet, pair by pair. A contact is in
/// the list as often as pairs of triangles share it, and the ends at flat edges are in it too.
/// Features are those of single triangles: equal vertices are not merged. Triangles without area or
/// not finite and empty meshes count as in `mesh_contacts`.
template <FloatOrDouble S>
std::vector<MeshContact<S>> contacts_of_pairs(const MeshTree<S>& a, const MeshTree<S>& b) {
  using mesh_contacts_detail::triangle_feature;
  std::vector<MeshContact<S>> all;
  mesh_contacts_detail::each_common_point(
      a, b, [&](const TrianglePair& pair, const CommonPoint<S>& point, S bound) {
        all.push_back({triangle_feature(a.mesh(), pair.of_first, point.of_first),
                       triangle_feature(b.mesh(), pair.of_second, point.of_second), point.position,
                       bound});
      });
  return all;
}
/// The same of two meshes for which no trees are there yet.
/// @throws std::invalid_argument if a triangle names a vertex that does not exist
template <FloatOrDouble S>
std::vector<MeshContact<S>> contacts_of_pairs(const Mesh<S>& a, const Mesh<S>& b) {
  return contacts_of_pairs(MeshTree<S>(a), MeshTree<S>(b));
}
// [/contacts-of-pairs]

}  // namespace contact
