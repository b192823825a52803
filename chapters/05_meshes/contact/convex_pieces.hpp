/// @file
/// A closed mesh cut into convex pieces, exactly: the cuts lie in the planes of its triangles, and
/// no volume is lost.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/convex_cells.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/orientation.hpp>

namespace contact {

/// An edge at which the solid is concave: the angle inside is greater than 180° (a reflex edge).
struct Notch {
  std::array<int, 2> vertices{};   ///< of the edge, as the first triangle runs through it
  std::array<int, 2> triangles{};  ///< on both sides of it
};

// [notches]
/// The notches of a mesh, decided exactly. A solid whose surface is one closed, oriented manifold
/// component, without triangles without area, is convex if it has none.
///
/// An edge is a notch if the vertex opposite to it in one triangle is in front of the other's
/// plane. Edges that do not belong to exactly two triangles in opposite directions are left out,
/// and so are those of triangles without area.
/// @param mesh m, finite
inline std::vector<Notch> notches(const Mesh<double>& mesh) {
  const auto at = [&mesh](int i) { return mesh.vertices[std::size_t(i)]; };
  std::map<std::array<int, 2>, std::vector<std::array<int, 2>>>
      through;  // triangle, opposite vertex
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = mesh.triangles[t];
      through[{v[k], v[(k + 1) % 3]}].push_back({int(t), v[(k + 2) % 3]});
    }
  }
  std::vector<Notch> found;
  for (const auto& [edge, here] : through) {
    if (edge[0] > edge[1] || here.size() != 1) continue;
    const auto other = through.find({edge[1], edge[0]});
    if (other == through.end() || other->second.size() != 1) continue;
    const auto [first, apex] = here[0];
    const auto [second, opposite] = other->second[0];
    if (orient_3d(at(edge[0]), at(edge[1]), at(apex), at(opposite)) > 0) {
      found.push_back({edge, {first, second}});
    }
  }
  return found;
}
// [/notches]

// [convex-piece]
/// A convex polyhedron whose numbers are exact.
struct ConvexPiece {
  std::vector<ExactPlane> planes;          ///< of the facets; the piece is behind all of them
  std::vector<HomogeneousPoint> vertices;  ///< m
  std::vector<std::vector<int>> facets;    ///< vertices of each, counter-clockwise from outside

  /// m³, exactly: the sum of the signed tetrahedra over the origin and the facets. 0 without
  /// facets; a facet of fewer than three vertices adds nothing.
  ExactFraction volume() const {
    ExactFraction sixfold;
    for (const std::vector<int>& facet : facets) {
      if (facet.empty()) continue;
      const HomogeneousPoint& a = vertices[std::size_t(facet[0])];
      for (std::size_t i = 1; i + 1 < facet.size(); ++i) {
        const HomogeneousPoint& b = vertices[std::size_t(facet[i])];
        const HomogeneousPoint& c = vertices[std::size_t(facet[i + 1])];
        const Exact product = a.scaled.dot(Vector3<Exact>(b.scaled.cross(c.scaled)));
        sixfold += ExactFraction(product) / ExactFraction(a.weight * b.weight * c.weight);
      }
    }
    return sixfold / ExactFraction(6);
  }
};
// [/convex-piece]

/// A piece as a triangle mesh in double, for figures: each coordinate is rounded once, so a facet
/// of more than three vertices may be slightly bent. Without facets it has no triangles; a
/// coordinate beyond the largest double becomes infinite, and triangles that are too small lose
/// their area.
inline Mesh<double> rounded_piece(const ConvexPiece& piece) {
  Mesh<double> mesh;
  for (const HomogeneousPoint& vertex : piece.vertices) mesh.vertices.push_back(nearest(vertex));
  for (const std::vector<int>& facet : piece.facets) {
    for (std::size_t i = 1; i + 1 < facet.size(); ++i) {
      mesh.triangles.push_back({facet[0], facet[i], facet[i + 1]});
    }
  }
  return mesh;
}

/// The sum of the volumes of pieces, m³, exactly; 0 without pieces. Slow for pieces with many
/// vertices that are not given points, because fractions are not reduced.
inline ExactFraction volume_of_pieces(const std::vector<ConvexPiece>& pieces) {
  ExactFraction sum;
  for (const ConvexPiece& piece : pieces) sum += piece.volume();
  return sum;
}

namespace detail {

/// Cuts a box around the mesh by the planes of its triangles until no cell has a triangle inside (a
/// binary space partition).
class SolidCutter {
 public:
  explicit SolidCutter(const Mesh<double>& mesh) : mesh_(mesh) {
    require_closed(mesh);
    for (const Vector3<double>& vertex : mesh.vertices) all_.add(vertex);
    if (mesh.triangles.empty()) return;
    add_box(mesh);
    add_triangles(mesh);
  }

  std::vector<ConvexPiece> cut() {
    std::vector<ConvexPiece> pieces;
    std::vector<Node> open;
    if (!box_.empty()) open.push_back({box_, fragments_, fragments_.empty() && surrounded(box_)});
    while (!open.empty()) {
      const Node node = std::move(open.back());
      open.pop_back();
      if (node.fragments.empty()) {
        if (node.inside) pieces.push_back(as_piece(node.cell));
        continue;
      }
      const int plane = choose(node.fragments);
      for (const int side : {+1, -1}) open.push_back(child(node, plane, side));
    }
    return pieces;
  }

 private:
  /// A cell, the parts of triangles in its interior, and, where there are none, whether it is in
  /// the solid.
  struct Node {
    ConvexCell cell;
    std::vector<CellFacet> fragments;
    bool inside = false;
  };
  const Mesh<double>& mesh_;
  CutArrangement all_;
  ConvexCell box_;
  std::vector<CellFacet> fragments_;
  std::set<int> at_notch_;  // planes across the edges that are notches

  static void require_closed(const Mesh<double>& mesh) {
    for (const Vector3<double>& vertex : mesh.vertices) require_finite("mesh.vertices", vertex);
    for (const auto& triangle : mesh.triangles) {
      for (const int v : triangle) {
        if (v < 0 || std::size_t(v) >= mesh.vertices.size()) {
          throw_invalid_argument("mesh.triangles", std::to_string(v), "no vertex has this index");
        }
      }
    }
    for (const auto& [edge, balance] : mesh_check_detail::edge_balance(mesh)) {
      if (balance == 0) continue;
      throw_invalid_argument("mesh.triangles",
                             std::to_string(edge[0]) + "-" + std::to_string(edge[1]),
                             "the mesh is not closed and oriented at this edge");
    }
  }

  /// The bounding box as the first cell: planes 2k (low) and 2k + 1 (high), all with normals along
  /// the positive axes.
  void add_box(const Mesh<double>& mesh) {
    Vector3<double> low = used(mesh, 0, 0), high = low;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        low = low.cwiseMin(used(mesh, t, k));
        high = high.cwiseMax(used(mesh, t, k));
      }
    }
    for (int k = 0; k < 3; ++k) {
      for (const double offset : {low[k], high[k]}) {
        ExactPlane plane;
        plane.normal[k] = Exact(1.0);
        plane.offset = Exact(offset);
        all_.add(plane);
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (!(low[k] < high[k])) return;  // flat: no interior, no pieces
    }
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      for (const int end : {0, 1}) {
        // Around the facet, counter-clockwise from the positive side: low j, high i, high j, low i.
        std::vector<int> across{2 * j, 2 * i + 1, 2 * j + 1, 2 * i};
        if (end == 0) std::reverse(across.begin(), across.end());
        CellFacet facet{2 * k + end, end == 0, {}, across};
        for (std::size_t e = 0; e < 4; ++e) {
          facet.vertices.push_back(all_.intersect(2 * k + end, across[(e + 3) % 4], across[e]));
        }
        box_.push_back(facet);
      }
    }
  }

  static Vector3<double> used(const Mesh<double>& mesh, std::size_t triangle, std::size_t corner) {
    return mesh.vertices[std::size_t(mesh.triangles[triangle][corner])];
  }

  /// Each triangle with area as a fragment, except those in a face of the box. Coplanar triangles
  /// have one plane.
  void add_triangles(const Mesh<double>& mesh) {
    if (box_.empty()) return;
    std::map<std::array<int, 3>, int> edge_planes;
    std::vector<std::array<Vector3<double>, 3>> of_plane;  // a triangle in each plane
    std::set<std::array<int, 2>> reflex;
    for (const Notch& notch : notches(mesh)) reflex.insert(notch.vertices);
    std::vector<int> plane_numbers;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = mesh.triangles[t];
      const Vector3<double> a = used(mesh, t, 0), b = used(mesh, t, 1), c = used(mesh, t, 2);
      const FlatView view = flat_view(a, b, c);
      if (view.orientation == 0) continue;
      int plane = -1;
      for (int k = 0; k < 3; ++k) {
        for (int end = 0; end < 2 && a[k] == b[k] && a[k] == c[k]; ++end) {
          if (all_.side(2 * k + end, v[0]) == 0) plane = 2 * k + end;
        }
      }
      if (plane >= 0) continue;  // in a face of the box, so not inside the first cell
      bool reversed = false;
      for (std::size_t i = 0; i < of_plane.size() && plane < 0; ++i) {
        const auto& [p, q, r] = of_plane[i];
        if (orient_3d(p, q, r, a) != 0 || orient_3d(p, q, r, b) != 0 ||
            orient_3d(p, q, r, c) != 0) {
          continue;
        }
        plane = plane_numbers[i];
        reversed = flat_view(p, q, r).orientation != view.orientation;
      }
      if (plane < 0) {
        plane = all_.add(exact_plane_through(a, b, c));
        of_plane.push_back({a, b, c});
        plane_numbers.push_back(plane);
      }
      CellFacet fragment{plane, reversed, {v[0], v[1], v[2]}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        fragment.across.push_back(
            plane_across(mesh, {v[k], v[(k + 1) % 3]}, view.dropped, edge_planes, reflex));
      }
      fragments_.push_back(fragment);
    }
  }

  /// A plane through an edge and parallel to the axis k, which is not parallel to the triangle: the
  /// neighbour's plane would not do where the two are coplanar.
  int plane_across(const Mesh<double>& mesh, std::array<int, 2> edge, int k,
                   std::map<std::array<int, 3>, int>& made,
                   const std::set<std::array<int, 2>>& reflex) {
    const auto known = made.find({edge[0], edge[1], k});
    if (known != made.end()) return known->second;
    const auto exact = [&mesh](int i) {
      const Vector3<double>& p = mesh.vertices[std::size_t(i)];
      return Vector3<Exact>(Exact(p.x()), Exact(p.y()), Exact(p.z()));
    };
    const Vector3<Exact> along = exact(edge[1]) - exact(edge[0]);
    ExactPlane plane;
    plane.normal[(k + 1) % 3] = along[(k + 2) % 3];
    plane.normal[(k + 2) % 3] = -along[(k + 1) % 3];
    plane.offset = plane.normal.dot(exact(edge[0]));
    const int number = all_.add(plane);
    made[{edge[0], edge[1], k}] = number;
    if (reflex.count({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}) > 0) {
      at_notch_.insert(number);
    }
    return number;
  }

  /// How the fragments lie to a plane.
  struct Sides {
    int behind = 0, in_front = 0, cut = 0;
  };
  Sides sides_of(int plane, const std::vector<CellFacet>& fragments) {
    Sides sides;
    for (const CellFacet& fragment : fragments) {
      if (fragment.plane == plane) continue;
      bool behind = false, in_front = false;
      for (const int vertex : fragment.vertices) {
        const int side = all_.side(plane, vertex);
        behind = behind || side < 0;
        in_front = in_front || side > 0;
      }
      ++(behind && in_front ? sides.cut : behind ? sides.behind : sides.in_front);
    }
    return sides;
  }

  // [choose-cut]
  /// The plane of the next cut. First those of which all fragments are behind (or all in front, for
  /// a plane whose triangles look the other way): they cut off outside only. Then, of the planes at
  /// a notch, or of all if there is none, the one that cuts the fewest fragments.
  int choose(const std::vector<CellFacet>& fragments) {
    std::set<int> tried;
    int best = -1, least = 0;
    bool best_at_notch = false;
    for (const CellFacet& fragment : fragments) {
      const bool notch = std::any_of(fragment.across.begin(), fragment.across.end(),
                                     [this](int across) { return at_notch_.count(across) > 0; });
      if (!tried.insert(2 * fragment.plane + (notch ? 1 : 0)).second) continue;
      const Sides sides = sides_of(fragment.plane, fragments);
      if (sides.cut == 0 && (fragment.reversed ? sides.behind : sides.in_front) == 0) {
        return fragment.plane;
      }
      if (best < 0 || (notch && !best_at_notch) || (notch == best_at_notch && sides.cut < least)) {
        best = fragment.plane;
        least = sides.cut;
        best_at_notch = notch;
      }
    }
    return best;
  }
  // [/choose-cut]

  Node child(const Node& node, int plane, int side) {
    Node made{clip_cell(node.cell, plane, side, all_), {}, false};
    std::vector<CellFacet> in_plane;
    for (const CellFacet& fragment : node.fragments) {
      if (fragment.plane == plane) {
        in_plane.push_back(fragment);
        continue;
      }
      CellFacet part = clip_facet(fragment, plane, side, all_);
      if (!part.vertices.empty()) made.fragments.push_back(std::move(part));
    }
    if (made.fragments.empty()) made.inside = is_inside(made.cell, in_plane, plane, side);
    return made;
  }

  /// Whether a cell that has no fragment in it is in the solid, by the triangles in the plane that
  /// cut it off: their front is outside.
  ///
  /// Where solids touch, or where the mesh has a flat part without volume, triangles of both
  /// orientations are in the plane. With the winding number w = 0 or 1 in a cell behind the plane
  /// and 0 ≤ v ≤ 1 in front of it, the signed area is that of the facet times w − (mean of v): w is
  /// 1 if it is positive, and 0 if it is negative. If it is 0, w = v, and both may be 0 or 1; then
  /// a ray decides. In front of the plane it is the same with the signs reversed.
  bool is_inside(const ConvexCell& cell, const std::vector<CellFacet>& in_plane, int plane,
                 int side) const {
    const auto looks_back = [](const CellFacet& fragment) { return fragment.reversed; };
    const bool back = std::any_of(in_plane.begin(), in_plane.end(), looks_back);
    if (std::all_of(in_plane.begin(), in_plane.end(), looks_back)) return side > 0;
    if (!back) return side < 0;
    ExactFraction area;
    for (const CellFacet& fragment : in_plane) {
      area += signed_area(fragment, plane);
    }
    if (area.sign() == 0) return surrounded(cell);
    return (area.sign() > 0) == (side < 0);
  }

  /// Whether the winding number of a cell that has no triangle in it is greater than 0.
  ///
  /// A ray starts at a mean of the vertices, which is inside the cell. Its direction (1, k, k²) is
  /// in the plane of the ray's start and an edge for at most two k (or for every k, if the edge's
  /// line contains the start; then the triangle's other two edges say that it is missed), so one of
  /// the first k meets no edge.
  bool surrounded(const ConvexCell& cell) const {
    HomogeneousPoint start;
    start.weight = Exact();
    for (const CellFacet& facet : cell) {
      for (const int vertex : facet.vertices) {
        start.scaled += all_.vertex(vertex).scaled;
        start.weight += all_.vertex(vertex).weight;
      }
    }
    for (double k = 0;; ++k) {
      const Vector3<Exact> direction(Exact(1.0), Exact(k), Exact(k * k));
      if (const auto winding = winding_along(start, direction)) return *winding > 0;
    }
  }

  /// The signed number of triangles that a ray leaves through; nothing if it meets an edge.
  std::optional<int> winding_along(const HomogeneousPoint& start,
                                   const Vector3<Exact>& direction) const {
    int winding = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (flat_view(used(mesh_, t, 0), used(mesh_, t, 1), used(mesh_, t, 2)).orientation == 0) {
        continue;
      }
      std::array<Vector3<Exact>, 3> corner;  // from the start, times its weight
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3<double> v = used(mesh_, t, i);
        for (int k = 0; k < 3; ++k) {
          corner[i][k] = Exact(v[k]) * start.weight - start.scaled[k];
        }
      }
      int least = 1, most = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3<Exact> across = corner[i].cross(corner[(i + 1) % 3]);
        const int side = Exact(direction.dot(across)).sign();
        least = std::min(least, side);
        most = std::max(most, side);
      }
      if (least < 0 && most > 0) continue;
      if (least != most || least == 0) return std::nullopt;
      const Vector3<Exact> across = corner[1].cross(corner[2]);
      if (Exact(corner[0].dot(across)).sign() == least) winding += least;
    }
    return winding;
  }

  /// Twice the area of a fragment's projection along an axis, positive if it looks to the front of
  /// its plane.
  ExactFraction signed_area(const CellFacet& fragment, int plane) const {
    int k = 0;
    while (all_.plane(plane).normal[k].sign() == 0) ++k;
    const auto coordinate = [&](std::size_t i, int axis) {
      const HomogeneousPoint& p = all_.vertex(fragment.vertices[i % fragment.vertices.size()]);
      return ExactFraction(p.scaled[(k + axis) % 3]) / ExactFraction(p.weight);
    };
    ExactFraction twice;
    for (std::size_t i = 0; i < fragment.vertices.size(); ++i) {
      twice += coordinate(i, 1) * coordinate(i + 1, 2) - coordinate(i, 2) * coordinate(i + 1, 1);
    }
    return all_.plane(plane).normal[k].sign() > 0 ? twice : -twice;
  }

  ConvexPiece as_piece(const ConvexCell& cell) const {
    ConvexPiece piece;
    std::map<int, int> numbers;
    for (const CellFacet& facet : cell) {
      ExactPlane plane = all_.plane(facet.plane);
      if (facet.reversed) {
        for (int k = 0; k < 3; ++k) plane.normal[k] = -plane.normal[k];
        plane.offset = -plane.offset;
      }
      piece.planes.push_back(plane);
      std::vector<int> loop;
      for (const int vertex : facet.vertices) {
        const auto [entry, added] = numbers.insert({vertex, int(piece.vertices.size())});
        if (added) piece.vertices.push_back(all_.vertex(vertex));
        loop.push_back(entry->second);
      }
      piece.facets.push_back(loop);
    }
    return piece;
  }
};

}  // namespace detail

// [convex-pieces]
/// A solid as convex pieces with disjoint interiors whose union is the solid, exactly.
///
/// The bounding box is cut by planes of triangles until no cell has a part of a triangle inside;
/// then each cell is in the solid or outside. Planes that cut off outside only are taken first, so
/// that a convex solid stays in one piece. Then follow planes at notches (Chazelle's cuts,
/// restricted to the planes of the faces).
///
/// The number of pieces is not the smallest possible: to find that is NP-hard. Chazelle's algorithm
/// makes O(r²) pieces from r notches; here a cut passes through its whole cell, also where there is
/// no notch, so there may be more. The time grows with the planes times the fragments: for meshes
/// of a few hundred triangles.
/// @param mesh m, closed and oriented with the front outside, without self-intersections; several
/// components, cavities, tunnels, coplanar triangles and solids that touch are allowed; triangles
/// without area are ignored
/// @return no pieces for a mesh without volume. For a mesh that intersects itself or is inside out
/// the pieces mean nothing; then `volume_of_pieces` differs from `mesh_volume_exactly`, except by
/// accident
/// @throws std::invalid_argument if a vertex is not finite, an index has no vertex, or the mesh is
/// not closed and oriented
///
/// Source: Chazelle, Convex Partitions of Polyhedra, 1984; binary space partition of a solid:
/// Thibault and Naylor, 1987; vertices from planes: Sugihara and Iri, 1989; Bernstein and Fussell,
/// Fast, Exact, Linear Booleans, 2009.
inline std::vector<ConvexPiece> convex_pieces(const Mesh<double>& mesh) {
  return detail::SolidCutter(mesh).cut();
}
// [/convex-pieces]

}  // namespace contact
