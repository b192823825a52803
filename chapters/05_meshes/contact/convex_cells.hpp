/// @file
/// Convex cells that planes bound, in exact arithmetic: each vertex is a given point or the
/// intersection of three given planes, so that its numbers do not grow from cut to cut.
///
/// Exact numbers are finite and do not overflow. To make one of a coordinate that is not finite is
/// an error of the program.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <contact/exact.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>

namespace contact {

// [homogeneous]
/// The point scaled/weight without a division, hence exact: three planes rarely intersect at a
/// point whose coordinates are floating-point numbers.
struct HomogeneousPoint {
  Vector3<Exact> scaled = Vector3<Exact>(Exact(), Exact(), Exact());  ///< m, times weight
  Exact weight{1.0};                                                  ///< greater than 0
};

/// The plane of all x with normal · x = offset, for a normal of any length but 0.
struct ExactPlane {
  Vector3<Exact> normal = Vector3<Exact>(Exact(), Exact(), Exact());  ///< points to the front
  Exact offset;  ///< m, times the length of the normal
};

/// On which side of a plane a point is: +1 in front, −1 behind, 0 exactly on it. If the normal and
/// the offset are 0, as of the plane through collinear points, it is 0 for every point.
inline int side_of_plane(const ExactPlane& plane, const HomogeneousPoint& point) {
  return (Exact(plane.normal.dot(point.scaled)) - plane.offset * point.weight).sign();
}

/// The plane through a, b and c; from its front they are seen counter-clockwise.
/// @param a,b,c m, finite and not collinear: of collinear points the normal is 0
inline ExactPlane exact_plane_through(const Vector3<double>& a, const Vector3<double>& b,
                                      const Vector3<double>& c) {
  const auto exact = [](const Vector3<double>& v) {
    return Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
  };
  const Vector3<Exact> ab = exact(b) - exact(a), ac = exact(c) - exact(a);
  ExactPlane plane;
  plane.normal = Vector3<Exact>(ab.cross(ac));
  plane.offset = plane.normal.dot(exact(a));
  return plane;
}

/// The point that three planes have in common (Cramer's rule).
///
/// If each normal comes from the differences of points with b bits, a normal has about 2 b bits,
/// and the weight, which is the determinant of the normals, about 6 b.
/// @param p,q,r with linearly independent normals: otherwise the weight is 0, an error of the
/// program
inline HomogeneousPoint intersection_of(const ExactPlane& p, const ExactPlane& q,
                                        const ExactPlane& r) {
  const Vector3<Exact> qr = q.normal.cross(r.normal);
  const Vector3<Exact> rp = r.normal.cross(p.normal);
  const Vector3<Exact> pq = p.normal.cross(q.normal);
  HomogeneousPoint point;
  point.weight = p.normal.dot(qr);
  for (int k = 0; k < 3; ++k) {
    point.scaled[k] = p.offset * qr[k] + q.offset * rp[k] + r.offset * pq[k];
  }
  if (point.weight.sign() < 0) {
    for (int k = 0; k < 3; ++k) point.scaled[k] = -point.scaled[k];
    point.weight = -point.weight;
  }
  return point;
}
// [/homogeneous]

/// The floating-point point nearest to it: each coordinate is rounded once. One beyond the largest
/// double becomes infinite, one too close to 0 becomes 0; a weight of 0 is an error of the program.
inline Vector3<double> nearest(const HomogeneousPoint& point) {
  return {quotient<double>(point.scaled.x(), point.weight),
          quotient<double>(point.scaled.y(), point.weight),
          quotient<double>(point.scaled.z(), point.weight)};
}

namespace detail {

/// A quotient of exact numbers as a double with the bound of its one rounding.
inline RunningError enclosed_quotient(const Exact& above, const Exact& below) {
  const double value = quotient<double>(above, below);
  if (!std::isfinite(value)) return {value, std::numeric_limits<double>::infinity()};
  if (below * Exact(value) == above) return {value};
  return {value, RunningError::u * std::abs(value) * (1 + 4 * RunningError::u) +
                     std::numeric_limits<double>::denorm_min()};
}

/// The planes and the vertices of all cells, by number. The side of each vertex of each plane is
/// computed at most once: by a filter, and exactly where the filter is not certain.
class CutArrangement {
 public:
  int add(const ExactPlane& plane) {
    Plane added{plane, {}};
    for (int k = 0; k < 3; ++k) {
      added.rough[std::size_t(k)] = enclosed_quotient(plane.normal[k], Exact(1.0));
    }
    added.rough[3] = enclosed_quotient(plane.offset, Exact(1.0));
    planes_.push_back(added);
    known_.emplace_back();
    return static_cast<int>(planes_.size()) - 1;
  }
  int add(const Vector3<double>& point) {
    HomogeneousPoint exact;
    for (int k = 0; k < 3; ++k) exact.scaled[k] = Exact(point[k]);
    return add(exact, {-1, -1, -1});
  }
  /// The intersection of three planes; the same number whenever the same three are given.
  int intersect(int p, int q, int r) {
    std::array<int, 3> key{p, q, r};
    std::sort(key.begin(), key.end());
    const auto found = meets_.find(key);
    if (found != meets_.end()) return found->second;
    const int vertex = add(intersection_of(plane(p), plane(q), plane(r)), key);
    meets_[key] = vertex;
    return vertex;
  }

  const ExactPlane& plane(int i) const { return planes_[std::size_t(i)].exact; }
  const HomogeneousPoint& vertex(int i) const { return vertices_[std::size_t(i)].exact; }

  /// −1, 0 or +1.
  int side(int plane, int vertex) {
    std::vector<signed char>& row = known_[std::size_t(plane)];
    if (row.size() < vertices_.size()) row.resize(vertices_.size(), unknown);
    signed char& known = row[std::size_t(vertex)];
    if (known == unknown) known = static_cast<signed char>(compute_side(plane, vertex));
    return known;
  }

 private:
  static constexpr signed char unknown = 2;
  struct Plane {
    ExactPlane exact;
    std::array<RunningError, 4> rough;
  };
  struct Vertex {
    HomogeneousPoint exact;
    std::array<RunningError, 3> rough;
    std::array<int, 3> planes;  // that meet here; −1 for a given point
  };
  std::vector<Plane> planes_;
  std::vector<Vertex> vertices_;
  std::vector<std::vector<signed char>> known_;  // [plane][vertex]
  std::map<std::array<int, 3>, int> meets_;

  int add(const HomogeneousPoint& point, const std::array<int, 3>& planes) {
    Vertex added{point, {}, planes};
    for (int k = 0; k < 3; ++k) {
      added.rough[std::size_t(k)] = enclosed_quotient(point.scaled[k], point.weight);
    }
    vertices_.push_back(added);
    return static_cast<int>(vertices_.size()) - 1;
  }

  int compute_side(int plane, int vertex) const {
    const Plane& p = planes_[std::size_t(plane)];
    const Vertex& v = vertices_[std::size_t(vertex)];
    for (const int through : v.planes) {
      if (through == plane) return 0;
    }
    const RunningError rough =
        p.rough[0] * v.rough[0] + p.rough[1] * v.rough[1] + p.rough[2] * v.rough[2] - p.rough[3];
    const int certain = rough.certain_sign();
    return certain != 0 ? certain : side_of_plane(p.exact, v.exact);
  }
};

// [cell]
/// A convex polygon in a plane. Edge i runs from vertices[i] to the next vertex and lies also in
/// the plane across[i].
struct CellFacet {
  int plane = 0;
  bool reversed = false;      ///< whether its front is the back of its plane
  std::vector<int> vertices;  ///< numbers in the arrangement, counter-clockwise from the front
  std::vector<int> across;    ///< numbers of planes
};

/// A convex polyhedron: its facets, with their fronts outwards.
using ConvexCell = std::vector<CellFacet>;
// [/cell]

// [clip-facet]
/// The part of a convex polygon on one side (−1 or +1) of a plane other than its own; without
/// vertices if it has no area there.
inline CellFacet clip_facet(const CellFacet& facet, int plane, int side, CutArrangement& all) {
  CellFacet kept{facet.plane, facet.reversed, {}, {}};
  bool has_area = false;
  const std::size_t n = facet.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const int here = side * all.side(plane, facet.vertices[i]);
    const int next = side * all.side(plane, facet.vertices[(i + 1) % n]);
    has_area = has_area || here > 0;
    if (here >= 0) {
      kept.vertices.push_back(facet.vertices[i]);
      kept.across.push_back(here == 0 && next <= 0 ? plane : facet.across[i]);
    }
    if (here * next < 0) {
      kept.vertices.push_back(all.intersect(facet.plane, facet.across[i], plane));
      kept.across.push_back(here > 0 ? plane : facet.across[i]);
    }
  }
  if (!has_area) return {facet.plane, facet.reversed, {}, {}};
  return kept;
}
// [/clip-facet]

// [clip-cell]
/// The part of a cell on one side of a plane that passes through its interior. The new facet is
/// made of the edges along which the plane cuts the old ones, in reversed direction.
inline ConvexCell clip_cell(const ConvexCell& cell, int plane, int side, CutArrangement& all) {
  ConvexCell kept;
  std::map<int, std::pair<int, int>> cut;  // from a vertex to the next one, and the plane across
  for (const CellFacet& facet : cell) {
    CellFacet part = clip_facet(facet, plane, side, all);
    const std::size_t n = part.vertices.size();
    if (n == 0) continue;
    for (std::size_t i = 0; i < n; ++i) {
      if (part.across[i] != plane) continue;
      cut[part.vertices[(i + 1) % n]] = {part.vertices[i], facet.plane};
    }
    kept.push_back(std::move(part));
  }
  CellFacet cap{plane, side > 0, {}, {}};
  int at = cut.begin()->first;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const auto [next, across] = cut.at(at);
    cap.vertices.push_back(at);
    cap.across.push_back(across);
    at = next;
  }
  kept.push_back(std::move(cap));
  return kept;
}
// [/clip-cell]

}  // namespace detail

}  // namespace contact
