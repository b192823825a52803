/// @file
/// Which triangles of two meshes meet, by two trees of boxes: the same pairs as each triangle
/// against each.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <contact/aabb.hpp>
#include <contact/box_tree.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/orientation.hpp>
#include <contact/shapes.hpp>
#include <contact/triangle_features.hpp>
#include <contact/triangle_intersection.hpp>
#include <contact/triangles_meet.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <utility>
#include <vector>

namespace contact {

// [triangle-pair]
/// A triangle of each of two meshes, by their numbers.
struct TrianglePair {
  int of_first = 0;   ///< of the first mesh
  int of_second = 0;  ///< of the second mesh; of one mesh, the larger number

  friend auto operator<=>(const TrianglePair&, const TrianglePair&) = default;
};

/// How many pairs were compared.
struct PairCounts {
  std::size_t boxes = 0;      ///< pairs of boxes, also of triangles with boxes and with triangles
  std::size_t triangles = 0;  ///< pairs of triangles whose boxes touch
};
// [/triangle-pair]

namespace mesh_pairs_detail {

/// A pair of nodes of two trees.
struct NodePair {
  int of_first, of_second;
  int depth;  ///< how many nodes were opened above it
};

/// Half of the surface of a box. An overflow makes it infinite.
template <FloatOrDouble S>
S half_surface(const Aabb<S>& box) {
  const Vector3<S> size = box.high - box.low;
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

/// Which of two nodes to open, if not both are leaves: the one with the larger box.
template <FloatOrDouble S>
bool opens_first(const BoxNode<S>& a, const BoxNode<S>& b) {
  if (a.count > 0 || b.count > 0) return b.count > 0;
  return half_surface(a.box) > half_surface(b.box);
}

/// The same as boxes_touch, without a branch to mispredict.
template <FloatOrDouble S>
bool touch(const Aabb<S>& a, const Aabb<S>& b) {
  int apart = 0;
  for (int k = 0; k < 3; ++k) apart |= int(a.high[k] < b.low[k]) | int(b.high[k] < a.low[k]);
  return apart == 0;
}

template <FloatOrDouble S>
Aabb<S> box_of(const Triangle<S>& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

/// Pairs of nodes that wait to be opened. The last one is next, as in every search in depth. But
/// each time that an eighth more leaves has been visited, it is one of the least depth, which is
/// large and far from there. So a search for any pair does not stay where there is none.
class WaitingPairs {
 public:
  bool empty() const { return pairs_.empty(); }
  void add(const NodePair& pair) { pairs_.push_back(pair); }
  NodePair take() {
    if (leaves_ >= next_change_) {
      next_change_ += 1 + leaves_ / 8;
      const auto shallow =
          std::min_element(pairs_.begin(), pairs_.end(),
                           [](const NodePair& p, const NodePair& q) { return p.depth < q.depth; });
      std::iter_swap(shallow, pairs_.end() - 1);
    }
    const NodePair pair = pairs_.back();
    pairs_.pop_back();
    return pair;
  }
  /// Says that a pair of leaves was visited.
  void count_leaf() { ++leaves_; }

 private:
  std::vector<NodePair> pairs_;
  std::size_t leaves_ = 0, next_change_ = 1;
};

template <FloatOrDouble S>
const BoxNode<S>& node(const BoxHierarchy<S>& tree, int i) {
  return tree.nodes[static_cast<std::size_t>(i)];
}

// [visit-leaves]
/// Calls visit(x, y) for each pair of leaves of two trees whose boxes touch, as `BoxNode<S>`, until
/// it returns true: a simultaneous traversal.
///
/// It starts with both roots. If two boxes are apart, nothing below the one touches anything below
/// the other. If they touch, the larger one is opened, and its children are compared with the
/// other. A tree with itself: each pair of leaves once, and each leaf with itself.
/// @param compared the number of pairs of boxes compared is added to it
/// @return whether visit stopped
template <FloatOrDouble S, class Visit>
bool visit_touching_leaves(const BoxHierarchy<S>& a, const BoxHierarchy<S>& b, const Visit& visit,
                           std::size_t& compared) {
  if (a.nodes.empty() || b.nodes.empty()) return false;
  WaitingPairs waiting;
  const auto compare = [&](int i, int j, int depth) {
    ++compared;
    if (touch(node(a, i).box, node(b, j).box)) waiting.add({i, j, depth});
  };
  compare(0, 0, 0);
  while (!waiting.empty()) {
    const auto [i, j, depth] = waiting.take();
    const BoxNode<S>&x = node(a, i), &y = node(b, j);
    if (x.count > 0 && y.count > 0) {
      if (visit(x, y)) return true;
      waiting.count_leaf();
    } else if (&x == &y) {
      waiting.add({x.first, x.first, depth + 1});
      waiting.add({x.first + 1, x.first + 1, depth + 1});
      compare(x.first, x.first + 1, depth + 1);
    } else if (opens_first(x, y)) {
      compare(x.first, j, depth + 1);
      compare(x.first + 1, j, depth + 1);
    } else {
      compare(i, y.first, depth + 1);
      compare(i, y.first + 1, depth + 1);
    }
  }
  return false;
}
// [/visit-leaves]

/// Adds to counts that are asked for.
inline void add(PairCounts* counts, const PairCounts& done) {
  if (counts == nullptr) return;
  counts->boxes += done.boxes;
  counts->triangles += done.triangles;
}

/// The triangles of a leaf whose boxes touch another box, by their positions.
template <FloatOrDouble S>
struct LeafPart {
  std::array<int, MeshTree<S>::max_leaf> at;
  std::array<Aabb<S>, MeshTree<S>::max_leaf> box;
  std::size_t count = 0;

  LeafPart(const MeshTree<S>& tree, const BoxNode<S>& leaf, const Aabb<S>& other) {
    for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
      at[count] = i;
      box[count] = box_of(tree.ordered_triangles()[static_cast<std::size_t>(i)]);
      count += touch(box[count], other) ? 1 : 0;
    }
  }
};

/// Calls each(i, j) for the positions of triangles in two leaves whose boxes touch and for which
/// `meet` is true of the triangles, until it returns true. A leaf with itself: i < j.
template <FloatOrDouble S, class Meet, class Each>
bool each_of_leaves(const MeshTree<S>& a, const BoxNode<S>& x, const MeshTree<S>& b,
                    const BoxNode<S>& y, PairCounts& done, const Meet& meet, const Each& each) {
  const LeafPart<S> part_of_x(a, x, y.box), part_of_y(b, y, x.box);
  done.boxes += static_cast<std::size_t>(x.count + y.count) + part_of_x.count * part_of_y.count;
  for (std::size_t k = 0; k < part_of_x.count; ++k) {
    const int i = part_of_x.at[k];
    const Triangle<S>& s = a.ordered_triangles()[static_cast<std::size_t>(i)];
    for (std::size_t l = &x == &y ? k + 1 : 0; l < part_of_y.count; ++l) {
      if (!touch(part_of_x.box[k], part_of_y.box[l])) continue;
      const int j = part_of_y.at[l];
      ++done.triangles;
      if (meet(s, b.ordered_triangles()[static_cast<std::size_t>(j)]) && each(i, j)) return true;
    }
  }
  return false;
}

/// Calls each(pair) for the pairs of triangles that meet, in some order, until it returns true.
template <FloatOrDouble S, class Each>
bool each_meeting(const MeshTree<S>& a, const MeshTree<S>& b, PairCounts* counts,
                  const Each& each) {
  PairCounts done;
  const auto meet = [](const Triangle<S>& s, const Triangle<S>& t) { return triangles_meet(s, t); };
  const auto report = [&](int i, int j) {
    return each(TrianglePair{a.boxes().order[static_cast<std::size_t>(i)],
                             b.boxes().order[static_cast<std::size_t>(j)]});
  };
  const auto visit = [&](const BoxNode<S>& x, const BoxNode<S>& y) {
    return each_of_leaves(a, x, b, y, done, meet, report);
  };
  const bool stopped = visit_touching_leaves<S>(a.boxes(), b.boxes(), visit, done.boxes);
  add(counts, done);
  return stopped;
}

/// The boxes of the finite triangles, with their numbers.
template <FloatOrDouble S>
struct BoxedTriangle {
  int index;
  Triangle<S> triangle;
  Aabb<S> box;
};
template <FloatOrDouble S>
std::vector<BoxedTriangle<S>> boxed_triangles(const Mesh<S>& mesh) {
  std::vector<BoxedTriangle<S>> boxed;
  boxed.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<S> t = triangle_of(mesh, i);
    if (!all_finite(t.a) || !all_finite(t.b) || !all_finite(t.c)) continue;
    boxed.push_back({static_cast<int>(i), t, box_of(t)});
  }
  return boxed;
}

/// The same of two meshes without trees, in increasing order.
template <FloatOrDouble S, class Each>
bool each_meeting(const Mesh<S>& a, const Mesh<S>& b, PairCounts* counts, const Each& each) {
  const auto of_a = boxed_triangles(a), of_b = boxed_triangles(b);
  PairCounts done;
  const auto visit = [&](const BoxedTriangle<S>& s, const BoxedTriangle<S>& t) {
    ++done.boxes;
    if (!boxes_touch(s.box, t.box)) return false;
    ++done.triangles;
    return triangles_meet(s.triangle, t.triangle) && each(TrianglePair{s.index, t.index});
  };
  const bool stopped = std::any_of(of_a.begin(), of_a.end(), [&](const auto& s) {
    return std::any_of(of_b.begin(), of_b.end(), [&](const auto& t) { return visit(s, t); });
  });
  add(counts, done);
  return stopped;
}

/// All pairs that meet, sorted.
template <class Meshes>
std::vector<TrianglePair> sorted_pairs(const Meshes& a, const Meshes& b, PairCounts* counts) {
  std::vector<TrianglePair> pairs;
  each_meeting(a, b, counts, [&pairs](const TrianglePair& pair) {
    pairs.push_back(pair);
    return false;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace mesh_pairs_detail

// [meeting-triangles]
/// The pairs of triangles of two meshes that have a point in common, sorted: each triangle against
/// each, first by their boxes.
///
/// Right for all meshes, as `triangles_meet` is: closed, open, a soup, crossing itself. Only the
/// surfaces count: a mesh inside another one meets nothing. A triangle with a coordinate that is
/// not finite is left out. An empty mesh meets nothing.
///
/// Limits: n·m pairs of boxes.
/// @param a m; an index that is out of range is an error of the program
/// @param b m; the same
/// @param counts if not null, what was compared is added to it
template <FloatOrDouble S>
std::vector<TrianglePair> meeting_triangles(const Mesh<S>& a, const Mesh<S>& b,
                                            PairCounts* counts = nullptr) {
  return mesh_pairs_detail::sorted_pairs(a, b, counts);
}
/// The same list by two trees: only pairs of leaves whose boxes touch are compared.
///
/// Limits: meshes that are close to each other everywhere take a time that grows with the number
/// of their triangles; long slivers, whose boxes overlap, up to n·m.
template <FloatOrDouble S>
std::vector<TrianglePair> meeting_triangles(const MeshTree<S>& a, const MeshTree<S>& b,
                                            PairCounts* counts = nullptr) {
  return mesh_pairs_detail::sorted_pairs(a, b, counts);
}

/// Whether any triangle of a mesh meets one of another: whether the list is not empty.
template <FloatOrDouble S>
bool any_meeting(const Mesh<S>& a, const Mesh<S>& b, PairCounts* counts = nullptr) {
  return mesh_pairs_detail::each_meeting(a, b, counts, [](const TrianglePair&) { return true; });
}
/// The same by two trees. It ends with the first pair that is found.
template <FloatOrDouble S>
bool any_meeting(const MeshTree<S>& a, const MeshTree<S>& b, PairCounts* counts = nullptr) {
  return mesh_pairs_detail::each_meeting(a, b, counts, [](const TrianglePair&) { return true; });
}
// [/meeting-triangles]

namespace mesh_pairs_detail {

/// Whether a vertex of t is one of s.
template <FloatOrDouble S>
bool is_vertex_of(const Triangle<S>& s, const Vector3<S>& v) {
  return v == s.a || v == s.b || v == s.c;
}

/// Whether the vertices of t that are not of s are all on one side of its plane. Then t has no more
/// in common with the plane than the vertex or the edge that the triangles share.
template <FloatOrDouble S>
bool leaves_plane(const Triangle<S>& s, const Triangle<S>& t) {
  const Triangle<double> plane = in_double(s);
  int side = 0;
  for (const Vector3<S>* v : {&t.a, &t.b, &t.c}) {
    if (is_vertex_of(s, *v)) continue;
    const int of_v = orient_3d(plane.a, plane.b, plane.c, v->template cast<double>());
    if (of_v == 0 || of_v * side < 0) return false;
    side = of_v;
  }
  return side != 0;
}

// [meet-beyond]
/// Whether two triangles have a point in common that is not on a vertex or an edge that they share.
///
/// Their common set is convex, with an end or vertex that is not a vertex of both, or it is
/// spanned by shared vertices: then it is one of them, an edge between two, or an area.
template <FloatOrDouble S>
bool meet_beyond_shared(const Triangle<S>& s, const Triangle<S>& t) {
  if (!is_vertex_of(s, t.a) && !is_vertex_of(s, t.b) && !is_vertex_of(s, t.c)) {
    return triangles_meet(s, t);
  }
  if (leaves_plane(s, t) || leaves_plane(t, s)) return false;
  const TriangleIntersection<S> common = intersect_triangles(s, t);
  if (common.kind == CommonPoints::area) return true;
  return std::any_of(common.points.begin(), common.points.begin() + common.count,
                     [](const CommonPoint<S>& point) {
                       return point.of_first.kind != FeatureKind::vertex ||
                              point.of_second.kind != FeatureKind::vertex;
                     });
}
// [/meet-beyond]

}  // namespace mesh_pairs_detail

// [self-meeting]
/// The pairs of triangles of one mesh that have a point in common besides the vertices and edges
/// that they share, sorted; in each pair the smaller number first. A mesh without such pairs does
/// not cross or touch itself.
///
/// A vertex is shared if the two triangles have vertices at equal positions, so it is the same for
/// a soup. An edge is shared if its two ends are. Exact, touching counts: a vertex on a face or on
/// the middle of an edge, folded triangles, the same triangle twice. A triangle with a coordinate
/// that is not finite is left out.
///
/// Limits: as of `meeting_triangles`.
/// @param counts if not null, what was compared is added to it
template <FloatOrDouble S>
std::vector<TrianglePair> self_meeting_triangles(const MeshTree<S>& tree,
                                                 PairCounts* counts = nullptr) {
  using namespace mesh_pairs_detail;
  std::vector<TrianglePair> pairs;
  PairCounts done;
  const auto report = [&](int i, int j) {
    const auto [low, high] = std::minmax({tree.boxes().order[static_cast<std::size_t>(i)],
                                          tree.boxes().order[static_cast<std::size_t>(j)]});
    pairs.push_back({low, high});
    return false;
  };
  const auto visit = [&](const BoxNode<S>& x, const BoxNode<S>& y) {
    return each_of_leaves(tree, x, tree, y, done, meet_beyond_shared<S>, report);
  };
  visit_touching_leaves<S>(tree.boxes(), tree.boxes(), visit, done.boxes);
  add(counts, done);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
/// The same of a mesh for which no tree is there yet.
/// @throws std::invalid_argument if a triangle names a vertex that does not exist
template <FloatOrDouble S>
std::vector<TrianglePair> self_meeting_triangles(const Mesh<S>& mesh,
                                                 PairCounts* counts = nullptr) {
  return self_meeting_triangles(MeshTree<S>(mesh), counts);
}
// [/self-meeting]

}  // namespace contact
