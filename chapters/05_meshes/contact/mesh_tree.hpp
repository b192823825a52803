/// @file
/// A tree of boxes over the triangles of a mesh: the same answers as without it, for most meshes
/// and rays in a time that grows with the logarithm of the number of triangles.
#pragma once

#include <algorithm>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/box_quads.hpp>
#include <contact/box_tree.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/four_triangles.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_hits.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <contact/wide_line.hpp>
#include <contact/wide_tree.hpp>
#include <cstddef>
#include <optional>
#include <span>
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
///
/// Limits: a ray that starts about 10^12 mesh sizes away, or one through many parallel slivers
/// along a diagonal, whose boxes overlap, tests every triangle.
template <FloatOrDouble S>
class MeshTree {
 public:
  /// The most triangles of a leaf.
  static constexpr int max_leaf = 4;

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
    tree_ = build_box_hierarchy<S>(boxes, items, max_leaf);
    quads_ = detail::BoxQuads(tree_, std::span<const Aabb<S>>(boxes));
    triangles_.reserve(tree_.order.size());
    for (const int i : tree_.order) {
      triangles_.push_back(triangle_of(mesh_, static_cast<std::size_t>(i)));
    }
    wide_ = detail::WideTree(tree_, std::span<const Triangle<S>>(triangles_));
  }

  /// The mesh as given.
  const Mesh<S>& mesh() const { return mesh_; }
  /// The tree of boxes; its items are the triangles.
  const BoxHierarchy<S>& boxes() const { return tree_; }
  /// The same for pairs of meshes, with the boxes of single triangles.
  const detail::BoxQuads& quads() const { return quads_; }
  /// The triangles in the order of the tree: number i is triangle boxes().order[i] of the mesh.
  const std::vector<Triangle<S>>& ordered_triangles() const { return triangles_; }

  /// Visits each triangle in the boxes that `enters` accepts; for queries of every kind.
  /// @param enters called with a box, an `Aabb<S>`; returns whether triangles in it can matter. The
  /// box is exact: the smallest one of the triangles below.
  /// @param visit called with the number of a triangle, or with it and its `Triangle<S>`; returns
  /// whether to stop
  /// @param counts if not null, what was looked at is added to it
  /// @return whether visit stopped; without a triangle nothing is called, and it is false
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
    return visit_box_hierarchy<S>(tree_, enters, ask, counts == nullptr ? nullptr : &counts->boxes);
  }

  // [tree-hits]
  /// The same as first_mesh_hit of the mesh, to the last bit.
  template <LineOf<S> Line>
  std::optional<MeshHit<S>> first(const Line& line, TreeCounts* counts = nullptr) const {
    const detail::MeshLine prepared(in_double(line));
    std::optional<Found> first;
    each_meeting(prepared, counts, [&](const Found& found, double& latest) {
      if (!first || earlier(prepared.line(), found, *first)) {
        first = found;
        latest = found.met.latest();
      }
      return false;
    });
    if (!first) return std::nullopt;
    return answer(line, prepared.line(), *first);
  }

  /// The same as any_mesh_hit.
  template <LineOf<S> Line>
  bool any(const Line& line, TreeCounts* counts = nullptr) const {
    bool any = false;
    each_meeting(detail::MeshLine(in_double(line)), counts,
                 [&any](const Found&, double&) { return any = true; });
    return any;
  }

  /// The same as all_mesh_hits, to the last bit.
  template <LineOf<S> Line>
  std::vector<MeshHit<S>> all(const Line& line, TreeCounts* counts = nullptr) const {
    const detail::MeshLine prepared(in_double(line));
    std::vector<Found> all;
    each_meeting(prepared, counts, [&](const Found& found, double&) {
      all.push_back(found);
      return false;
    });
    std::sort(all.begin(), all.end(),
              [&](const Found& x, const Found& y) { return earlier(prepared.line(), x, y); });
    std::vector<MeshHit<S>> hits;
    hits.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > 0 && order(prepared.line(), all[i - 1], all[i]) == 0) continue;
      hits.push_back(answer(line, prepared.line(), all[i]));
    }
    return hits;
  }
  // [/tree-hits]

 private:
  /// A triangle that is met, and its position in the order.
  struct Found {
    detail::MeshMeeting met;
    std::size_t at = 0;
  };

  Mesh<S> mesh_;
  BoxHierarchy<S> tree_;
  detail::WideTree wide_;
  detail::BoxQuads quads_;
  std::vector<Triangle<S>> triangles_;  ///< in the order of the tree

  /// Calls each(found, latest) for the triangles that the line meets, about from front to back;
  /// `each` may decrease `latest` to a t after which nothing matters.
  template <class Line, class Each>
  void each_meeting(const detail::MeshLine<Line>& line, TreeCounts* counts,
                    const Each& each) const {
    if (!line.meets_any()) return;
    const detail::WideLine wide = detail::wide_line(line.line(), wide_.frame());
    float no_last = 0;
    const auto test = [&](std::size_t at, float& last) {
      std::optional<detail::MeshMeeting> met = line.meet(in_double(triangles_[at]));
      if (!met) return false;
      met->triangle = tree_.order[at];
      double latest = -1;
      if (each(Found{*met, at}, latest)) return true;
      if (latest >= 0) last = std::min(last, wide.after(latest));
      return false;
    };
    if (!wide.tame) {
      if (counts != nullptr) counts->triangles += triangles_.size();
      for (std::size_t at = 0; at < triangles_.size() && !test(at, no_last); ++at) continue;
      return;
    }
    const auto test_leaf = [&](const detail::FourTriangles& leaf, float& last) {
      if (counts != nullptr) counts->triangles += static_cast<std::size_t>(leaf.count);
      return detail::each_bit(detail::possible_hits(leaf, wide), [&](std::size_t i) {
        return test(static_cast<std::size_t>(leaf.first) + i, last);
      });
    };
    wide_.walk(wide, test_leaf, counts == nullptr ? nullptr : &counts->boxes);
  }

  template <class Line>
  int order(const Line& line, const Found& x, const Found& y) const {
    return detail::compare_meetings(line, x.met, y.met, in_double(triangles_[x.at]),
                                    in_double(triangles_[y.at]));
  }
  template <class Line>
  bool earlier(const Line& line, const Found& x, const Found& y) const {
    const int sign = order(line, x, y);
    return sign < 0 || (sign == 0 && x.met.triangle < y.met.triangle);
  }
  template <class Line, class DoubleLine>
  MeshHit<S> answer(const Line& line, const DoubleLine& in_doubles, const Found& found) const {
    return detail::mesh_answer<S>(line, in_doubles, found.met, triangles_[found.at], mesh_);
  }
};
// [/mesh-tree]

}  // namespace contact
