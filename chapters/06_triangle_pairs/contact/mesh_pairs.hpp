/// @file
/// Which triangles of two meshes meet, by two trees of boxes: the same pairs as each triangle
/// against each.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <contact/aabb.hpp>
#include <contact/box_quads.hpp>
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
  std::size_t boxes = 0;      ///< pairs of boxes, also those of single triangles
  std::size_t triangles = 0;  ///< pairs of triangles whose boxes touch, or by a tree nearly do
};
// [/triangle-pair]

namespace mesh_pairs_detail {

template <FloatOrDouble S>
Aabb<S> box_of(const Triangle<S>& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

/// Adds to counts that are asked for.
inline void add(PairCounts* counts, const PairCounts& done) {
  if (counts == nullptr) return;
  counts->boxes += done.boxes;
  counts->triangles += done.triangles;
}

/// Calls each(pair) for the pairs of triangles of two trees for which `meet` is true, in some
/// order, until it returns true. A tree with itself: each pair once.
template <FloatOrDouble S, class Meet, class Each>
bool each_pair(const MeshTree<S>& a, const MeshTree<S>& b, PairCounts* counts, const Meet& meet,
               const Each& each) {
  if (a.quads().empty() || b.quads().empty()) return false;
  PairCounts done;
  const auto visit = [&](int k, int l) {
    const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(l);
    ++done.triangles;
    return meet(a.ordered_triangles()[i], b.ordered_triangles()[j]) &&
           each(TrianglePair{a.boxes().order[i], b.boxes().order[j]});
  };
  ++done.boxes;
  const bool stopped = boxes_touch(a.boxes().nodes[0].box, b.boxes().nodes[0].box) &&
                       detail::visit_touching(a.quads(), b.quads(), visit, done.boxes);
  add(counts, done);
  return stopped;
}

/// Calls each(pair) for the pairs of triangles that meet, in some order, until it returns true.
template <FloatOrDouble S, class Each>
bool each_meeting(const MeshTree<S>& a, const MeshTree<S>& b, PairCounts* counts,
                  const Each& each) {
  const auto meet = [](const Triangle<S>& s, const Triangle<S>& t) { return triangles_meet(s, t); };
  return each_pair(a, b, counts, meet, each);
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

/// Sorts pairs by one of their numbers, below n, with equal ones in the order that they have: a
/// counting sort.
inline void sort_by(int TrianglePair::*number, std::size_t n, std::vector<TrianglePair>& pairs) {
  std::vector<std::size_t> next(n + 1);
  for (const TrianglePair& pair : pairs) ++next[static_cast<std::size_t>(pair.*number) + 1];
  for (std::size_t i = 1; i < n; ++i) next[i] += next[i - 1];
  std::vector<TrianglePair> sorted(pairs.size());
  for (const TrianglePair& pair : pairs) {
    sorted[next[static_cast<std::size_t>(pair.*number)]++] = pair;
  }
  pairs.swap(sorted);
}

/// Sorts the pairs of two meshes with n and m triangles: many in a time that grows with their
/// number.
inline void sort_pairs(std::size_t n, std::size_t m, std::vector<TrianglePair>& pairs) {
  if (pairs.size() < (n + m) / 4) return std::sort(pairs.begin(), pairs.end());
  sort_by(&TrianglePair::of_second, m, pairs);
  sort_by(&TrianglePair::of_first, n, pairs);
}

/// All pairs that meet, in some order.
template <class Meshes>
std::vector<TrianglePair> all_pairs(const Meshes& a, const Meshes& b, PairCounts* counts) {
  std::vector<TrianglePair> pairs;
  each_meeting(a, b, counts, [&pairs](const TrianglePair& pair) {
    pairs.push_back(pair);
    return false;
  });
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
  return mesh_pairs_detail::all_pairs(a, b, counts);
}
/// The same list by two trees: only pairs whose boxes touch, or nearly do, are compared.
///
/// Limits: meshes that are close to each other everywhere take a time that grows with the number
/// of their triangles; long slivers, whose boxes overlap, up to n·m.
template <FloatOrDouble S>
std::vector<TrianglePair> meeting_triangles(const MeshTree<S>& a, const MeshTree<S>& b,
                                            PairCounts* counts = nullptr) {
  std::vector<TrianglePair> pairs = mesh_pairs_detail::all_pairs(a, b, counts);
  mesh_pairs_detail::sort_pairs(a.mesh().triangles.size(), b.mesh().triangles.size(), pairs);
  return pairs;
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

/// Which vertices two triangles share, because they are at equal positions.
struct SharedVertices {
  std::array<bool, 3> of_first{}, of_second{};
  bool any = false;

  template <FloatOrDouble S>
  SharedVertices(const Triangle<S>& s, const Triangle<S>& t) {
    const std::array<const Vector3<S>*, 3> p{&s.a, &s.b, &s.c}, q{&t.a, &t.b, &t.c};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (p[i]->x() != q[j]->x() || p[i]->y() != q[j]->y() || p[i]->z() != q[j]->z()) continue;
        any = of_first[i] = of_second[j] = true;
      }
    }
  }
};

/// Whether the vertices of t that are not shared with s are all on one side of its plane. Then t
/// has no more in common with the plane than the vertex or the edge that the triangles share.
template <FloatOrDouble S>
bool leaves_plane(const Triangle<S>& s, const Triangle<S>& t, const std::array<bool, 3>& shared) {
  const Triangle<double> plane = in_double(s), other = in_double(t);
  int side = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (shared[i]) continue;
    const Vector3<double>& v = i == 0 ? other.a : (i == 1 ? other.b : other.c);
    const int of_v = orient_3d(plane.a, plane.b, plane.c, v);
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
  const SharedVertices shared(s, t);
  if (!shared.any) return triangles_meet(s, t);
  if (leaves_plane(s, t, shared.of_second) || leaves_plane(t, s, shared.of_first)) return false;
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
/// that they share, sorted; in each pair the smaller number first. A mesh without such pairs
/// crosses or touches itself at most in vertices and edges that its triangles share.
///
/// A vertex is shared if the two triangles have vertices at equal positions, so it is the same for
/// a soup. An edge is shared if its two ends are. Exact, touching counts: a vertex on a face or on
/// the middle of an edge, folded triangles, the same triangle twice. A triangle with a coordinate
/// that is not finite is left out. A triangle without area is the segment or the point that it is.
/// An empty mesh has no pairs.
///
/// Limits: as of `meeting_triangles`.
/// @param counts if not null, what was compared is added to it
template <FloatOrDouble S>
std::vector<TrianglePair> self_meeting_triangles(const MeshTree<S>& tree,
                                                 PairCounts* counts = nullptr) {
  using namespace mesh_pairs_detail;
  std::vector<TrianglePair> pairs;
  each_pair(tree, tree, counts, meet_beyond_shared<S>, [&pairs](const TrianglePair& pair) {
    const auto [low, high] = std::minmax(pair.of_first, pair.of_second);
    pairs.push_back({low, high});
    return false;
  });
  const std::size_t n = tree.mesh().triangles.size();
  sort_pairs(n, n, pairs);
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
