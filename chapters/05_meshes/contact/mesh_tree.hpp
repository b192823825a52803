/// @file
/// A tree of boxes over the triangles of a mesh: the same answers as without it, in a time that
/// grows with the logarithm of the number of triangles.
#pragma once

#include <concepts>
#include <contact/aabb.hpp>
#include <contact/box_tree.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/mesh.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace contact {

/// What a query looked at.
struct TreeCounts {
  std::size_t boxes = 0;      ///< boxes compared with the line, or asked of `enters`
  std::size_t triangles = 0;  ///< triangles tested, or visited
};

// [mesh-tree]
/// A mesh with a tree of boxes over its triangles, built once. It owns what it needs.
///
/// Any mesh will do: open, with triangles that cross, without area or twice the same. A triangle
/// with a coordinate that is not finite is left out of the tree, and no query finds it.
template <FloatOrDouble S>
class MeshTree {
 public:
  /// @throws std::invalid_argument if a triangle names a vertex that does not exist
  explicit MeshTree(Mesh<S> mesh) : mesh_(std::move(mesh)) {
    const int vertices = static_cast<int>(mesh_.vertices.size());
    std::vector<Aabb<S>> boxes(mesh_.triangles.size());
    std::vector<int> items;
    items.reserve(mesh_.triangles.size());
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      for (const int vertex : mesh_.triangles[i]) {
        if (vertex < 0 || vertex >= vertices) {
          throw_invalid_argument(
              "mesh", "vertex " + std::to_string(vertex) + " in triangle " + std::to_string(i),
              "there are " + std::to_string(vertices) + " vertices");
        }
      }
      const Triangle<S> t = triangle_of(mesh_, i);
      if (!all_finite(t.a) || !all_finite(t.b) || !all_finite(t.c)) continue;
      boxes[i] = {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
      items.push_back(static_cast<int>(i));
    }
    tree_ = build_box_tree<S>(boxes, items, max_leaf);
    triangles_.reserve(tree_.order.size());
    for (const int i : tree_.order) {
      triangles_.push_back(triangle_of(mesh_, static_cast<std::size_t>(i)));
    }
  }

  /// The mesh as given.
  const Mesh<S>& mesh() const { return mesh_; }
  /// The tree of boxes; its items are the triangles.
  const BoxTree<S>& boxes() const { return tree_; }

  /// Visits each triangle in the boxes that `enters` accepts; for queries of every kind.
  /// @param enters (const Aabb<S>&) → bool: whether triangles in the box can matter. The box is
  /// exact: the smallest one of the triangles below.
  /// @param visit (int triangle) → bool or (int triangle, const Triangle<S>&) → bool: whether to
  /// stop
  /// @param counts if not null, what was looked at is added to it
  /// @return whether visit stopped
  template <class Enters, class Visit>
  bool visit(const Enters& enters, const Visit& visit, TreeCounts* counts = nullptr) const {
    const auto ask = [&](int position) -> bool {
      if (counts != nullptr) ++counts->triangles;
      const auto at = static_cast<std::size_t>(position);
      if constexpr (std::invocable<const Visit&, int, const Triangle<S>&>) {
        return visit(tree_.order[at], triangles_[at]);
      } else {
        return visit(tree_.order[at]);
      }
    };
    return visit_box_tree<S>(tree_, enters, ask, counts == nullptr ? nullptr : &counts->boxes);
  }

 private:
  static constexpr int max_leaf = 4;

  Mesh<S> mesh_;
  BoxTree<S> tree_;
  std::vector<Triangle<S>> triangles_;  ///< in the order of the tree
};
// [/mesh-tree]

}  // namespace contact
