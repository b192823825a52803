/// @file
/// The edges of a mesh with the triangles on their two sides, and the volume that a mesh bounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/exact_fraction.hpp>
#include <contact/filter.hpp>
#include <contact/mesh.hpp>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace contact {

// [mesh-edges]
/// An edge of a mesh with the triangles on its two sides.
struct MeshEdge {
  std::array<int, 2> vertices{-1, -1};  ///< the lower index first
  /// The first triangle that runs from vertices[0] to vertices[1], and the first that runs back; −1
  /// if there is none. In a closed, oriented manifold these are its two triangles.
  std::array<int, 2> triangles{-1, -1};
  int count = 0;  ///< of all triangles with this edge
};

namespace mesh_check_detail {

/// One side of a triangle.
struct HalfEdge {
  int low, high, triangle;
  bool up;  // runs from low to high
  friend bool operator<(const HalfEdge& g, const HalfEdge& h) {
    if (g.low != h.low) return g.low < h.low;
    if (g.high != h.high) return g.high < h.high;
    return g.triangle < h.triangle;
  }
  bool same_edge(const HalfEdge& h) const { return low == h.low && high == h.high; }
};

/// Whether all three indices name vertices.
template <Ring S>
bool in_range(const Mesh<S>& mesh, const std::array<int, 3>& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&mesh](int v) {
    return v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size();
  });
}
/// Whether two are the same.
inline bool repeats(const std::array<int, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// The sides of all triangles with three different vertices that exist, sorted by edge.
template <Ring S>
std::vector<HalfEdge> sorted_half_edges(const Mesh<S>& mesh) {
  std::vector<HalfEdge> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<int, 3>& t = mesh.triangles[i];
    if (!in_range(mesh, t) || repeats(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), from < to});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Calls group(begin, end) for each run of equal elements of a sorted range.
template <class Iterator, class Same, class Group>
void for_each_group(Iterator begin, Iterator end, const Same& same, const Group& group) {
  while (begin != end) {
    Iterator next = begin;
    while (next != end && same(*begin, *next)) ++next;
    group(begin, next);
    begin = next;
  }
}

/// Disjoint sets of the numbers from 0 to n − 1. Each is named by its least member.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void unite(int i, int j) {
    i = find(i);
    j = find(j);
    at(std::max(i, j)) = std::min(i, j);
  }

 private:
  std::vector<int> parent_;
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
};

/// How much more often each edge, its lower vertex first, is run through upwards than downwards.
/// All are 0 if the mesh is closed and oriented; then its winding number changes on its triangles
/// only.
template <Ring S>
std::map<std::array<int, 2>, int> edge_balance(const Mesh<S>& mesh) {
  std::map<std::array<int, 2>, int> balance;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      balance[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : from > to ? -1 : 0;
    }
  }
  return balance;
}

}  // namespace mesh_check_detail

/// All edges of a mesh, each once, sorted by their vertices. O(n log n).
///
/// Triangles with an index out of range or a repeated one are left out. Coordinates do not matter:
/// a triangle without area, or with NaN, has its three edges.
template <Ring S>
std::vector<MeshEdge> mesh_edges(const Mesh<S>& mesh) {
  using mesh_check_detail::HalfEdge;
  std::vector<MeshEdge> edges;
  for (const HalfEdge& side : mesh_check_detail::sorted_half_edges(mesh)) {
    if (edges.empty() || edges.back().vertices != std::array<int, 2>{side.low, side.high}) {
      edges.push_back({{side.low, side.high}, {-1, -1}, 0});
    }
    int& triangle = edges.back().triangles[side.up ? 0 : 1];
    if (triangle < 0) triangle = side.triangle;
    ++edges.back().count;
  }
  return edges;
}

/// The vertex of a triangle that is not on an edge of it: the first one if there are several, and
/// the triangle's first vertex if there is none, as with a repeated index.
inline int third_vertex(const std::array<int, 3>& triangle, const std::array<int, 2>& edge) {
  for (const int v : triangle) {
    if (v != edge[0] && v != edge[1]) return v;
  }
  return triangle[0];
}
// [/mesh-edges]

namespace mesh_check_detail {

// [volume-of]
/// Six volumes from the first vertex to each of some triangles of a mesh, divided by 6. The bound:
/// each triangle has that of `bounded_volume`, and each of n additions adds half an ulp of a
/// partial sum, which is at most the sum of all magnitudes. The quotient adds half an ulp.
template <std::floating_point S>
Bounded volume_of(const Mesh<S>& mesh, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0, bound = 0, magnitude = 0;
  const auto at = [&mesh](int v) -> Vector3<double> {
    return mesh.vertices[static_cast<std::size_t>(v)].template cast<double>();
  };
  for (const auto& [a, b, c] : triangles) {
    const Vector3<double> from = at(triangles[0][0]);
    const Bounded part = bounded_volume(at(a) - from, at(b) - from, at(c) - from);
    sum += part.value;
    bound += part.bound;
    magnitude += std::abs(part.value);
  }
  const double rounding =
      static_cast<double>(triangles.size() + 2) * std::numeric_limits<double>::epsilon();
  return {sum / 6, (bound + magnitude * rounding) / 6 * (1 + 2 * rounding) + 0x1p-1000};
}
// [/volume-of]

}  // namespace mesh_check_detail

// [mesh-volume]
/// The volume that a closed, oriented mesh bounds, m³, with a bound on its error: a sixth of the
/// sum of the volumes from the first vertex to each triangle. Negative if the front is inside. A
/// region around which the surface goes twice counts twice.
///
/// Without triangles 0. If the mesh is not closed or not oriented the number means nothing. If
/// something overflows or is not finite, the bound is infinite or NaN.
template <std::floating_point S>
Bounded mesh_volume(const Mesh<S>& mesh) {
  return mesh_check_detail::volume_of(mesh, mesh.triangles);
}

/// The same without error, for finite vertices.
template <std::floating_point S>
ExactFraction mesh_volume_exactly(const Mesh<S>& mesh) {
  const auto exact = [](const Vector3<S>& v) {
    const auto in = [](const S& x) { return ExactFraction(static_cast<double>(x)); };
    return Vector3<ExactFraction>(in(v.x()), in(v.y()), in(v.z()));
  };
  ExactFraction sum;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<S> t = triangle_of(mesh, i);
    const Vector3<ExactFraction> from = exact(triangle_of(mesh, 0).a);
    const Vector3<ExactFraction> a = exact(t.a) - from, b = exact(t.b) - from,
                                 c = exact(t.c) - from;
    sum += a.dot(b.cross(c));
  }
  return sum / ExactFraction(6);
}
// [/mesh-volume]

}  // namespace contact
