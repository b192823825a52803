/// @file
/// The features of a mesh: its vertices, its edges, and its faces, which are made of coplanar
/// triangles.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <contact/exact_ray_triangle.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/orientation.hpp>
#include <contact/triangle_features.hpp>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace contact {

// [mesh-feature]
/// A feature of a mesh, by the indices of its vertices in increasing order. A face that consists of
/// several coplanar triangles is named by the first of them. Equal features have equal names.
/// (`MeshFeature` of contact/mesh_hits.hpp is only a kind.)
struct NamedFeature {
  FeatureKind kind = FeatureKind::face;     ///< which of the three
  std::array<int, 3> vertices{-1, -1, -1};  ///< one, two or three indices; −1: unused

  friend auto operator<=>(const NamedFeature&, const NamedFeature&) = default;
};
// [/mesh-feature]

/// Names the feature of a mesh that a feature of one of its triangles belongs to.
///
/// An edge is *flat* if it belongs to exactly two triangles and these are in one plane, on
/// different sides of the edge. It is no edge of the mesh, but inside the face that the triangles
/// across flat edges form together. A vertex is always a feature of its own, even inside a face.
/// Decided exactly. Edges belong together if their vertices have the same indices, so equal
/// vertices of a soup have to be merged first (`merge_equal_vertices`).
class FeatureNames {
 public:
  /// O(n log n). The mesh must outlive this.
  /// @param mesh m; a triangle without area, or with an index that is repeated or out of range, has
  /// no flat edge. A triangle with a vertex that is not finite is an error of the program, and may
  /// assert
  template <FloatOrDouble S>
  explicit FeatureNames(const Mesh<S>& mesh)
      : triangles_(mesh.triangles), flat_(mesh.triangles.size()) {
    mesh_check_detail::Sets sets(mesh.triangles.size());
    using mesh_check_detail::HalfEdge;
    const auto sides = mesh_check_detail::sorted_half_edges(mesh);
    mesh_check_detail::for_each_group(
        sides.begin(), sides.end(),
        [](const HalfEdge& g, const HalfEdge& h) { return g.same_edge(h); },
        [&](auto begin, auto end) {
          if (std::distance(begin, end) != 2) return;
          const HalfEdge &g = *begin, &h = *std::next(begin);
          if (!is_flat(mesh, g.low, g.high, third(g), third(h))) return;
          sets.unite(g.triangle, h.triangle);
          mark(g);
          mark(h);
        });
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      faces_.push_back(sets.find(static_cast<int>(i)));
    }
  }

  /// The feature of the mesh whose relative interior contains that of a feature of triangle i; a
  /// number i without a triangle is an error of the program, here and below. An edge from a vertex
  /// to itself names this vertex twice.
  NamedFeature of(std::size_t i, const Feature& feature) const {
    const std::array<int, 3>& t = triangles_[i];
    const auto index = static_cast<std::size_t>(feature.index);
    if (feature.kind == FeatureKind::vertex) return {FeatureKind::vertex, {t[index], -1, -1}};
    if (feature.kind == FeatureKind::edge && !flat_[i][index]) {
      const auto [low, high] = std::minmax({t[index], t[(index + 1) % 3]});
      return {FeatureKind::edge, {low, high, -1}};
    }
    std::array<int, 3> named = triangles_[static_cast<std::size_t>(face(i))];
    // Three numbers; std::sort would be a tenth of what a page loads.
    for (const std::size_t k : {0U, 1U, 0U}) {
      if (named[k + 1] < named[k]) std::swap(named[k], named[k + 1]);
    }
    return {FeatureKind::face, named};
  }
  /// The first triangle of the face that triangle i belongs to; i itself if it has no area.
  int face(std::size_t i) const { return faces_[i]; }
  /// Whether edge 0, 1 or 2 of triangle i is flat; false if the triangle has no area.
  bool is_flat(std::size_t i, int edge) const { return flat_[i][static_cast<std::size_t>(edge)]; }

 private:
  const std::vector<std::array<int, 3>>& triangles_;
  std::vector<std::array<bool, 3>> flat_;
  std::vector<int> faces_;  // the first triangle of each triangle's face

  const std::array<int, 3>& triangle(const mesh_check_detail::HalfEdge& side) const {
    return triangles_[static_cast<std::size_t>(side.triangle)];
  }
  int third(const mesh_check_detail::HalfEdge& side) const {
    return third_vertex(triangle(side), {side.low, side.high});
  }
  void mark(const mesh_check_detail::HalfEdge& side) {
    const std::array<int, 3>& t = triangle(side);
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::minmax(t[k], t[(k + 1) % 3]) == std::minmax(side.low, side.high)) {
        flat_[static_cast<std::size_t>(side.triangle)][k] = true;
      }
    }
  }
  /// Whether c and d are in one plane with the edge from a to b, on different sides of it.
  template <FloatOrDouble S>
  static bool is_flat(const Mesh<S>& mesh, int a, int b, int c, int d) {
    const auto at = [&mesh](int v) -> Vector3<double> {
      return mesh.vertices[static_cast<std::size_t>(v)].template cast<double>();
    };
    const Vector3<double> from = at(a), to = at(b), left = at(c), right = at(d);
    if (orient_3d(from, to, left, right) != 0) return false;
    for (int k = 0; k < 3; ++k) {
      const auto side = [&](const Vector3<double>& x) {
        return orient_2d(drop_dimension<double>(from, k), drop_dimension<double>(to, k),
                         drop_dimension<double>(x, k));
      };
      const int of_left = side(left);
      if (of_left != 0) return of_left * side(right) < 0;
    }
    return false;
  }
};

}  // namespace contact
