/// @file
/// Where a point is, relative to a closed triangle mesh, decided without error: on the surface,
/// inside or outside, and the winding number.
#pragma once

#include <algorithm>
#include <contact/exact_ray_triangle.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/orientation.hpp>
#include <contact/point_in_polygon.hpp>
#include <contact/polygon.hpp>
#include <cstddef>

namespace contact {

/// Where a point is, relative to a closed and oriented mesh.
struct MeshLocation {
  Where where = Where::outside;  ///< on means on a triangle, also if both its sides are inside
  int winding = 0;               ///< how often the surface goes around the point; 0 if it is on it

  friend bool operator==(const MeshLocation&, const MeshLocation&) = default;
};

namespace mesh_location_detail {

/// Whether all coordinates of a triangle are finite.
inline bool finite_triangle(const Triangle<double>& t) {
  return all_finite(t.a) && all_finite(t.b) && all_finite(t.c);
}

/// Whether p is in the smallest box that contains the triangle.
inline bool in_box_of(const Triangle<double>& t, const Vector3<double>& p) {
  for (int k = 0; k < 3; ++k) {
    if (p[k] < std::min({t.a[k], t.b[k], t.c[k]})) return false;
    if (p[k] > std::max({t.a[k], t.b[k], t.c[k]})) return false;
  }
  return true;
}

}  // namespace mesh_location_detail

// [on-triangle]
/// Whether a point is exactly on a triangle, edges and vertices included.
///
/// It is in the triangle's plane, and in the projection of the triangle along a coordinate in which
/// the plane's projection is injective. A triangle without area is a segment or a point, and its
/// points are those of the line in its box. Right for every finite input; if a coordinate is not
/// finite, the result is false.
inline bool on_triangle(const Vector3<double>& p, const Triangle<double>& t) {
  if (!mesh_location_detail::in_box_of(t, p)) return false;
  if (!all_finite(p) || !mesh_location_detail::finite_triangle(t)) return false;
  const auto [dropped, orientation] = flat_view(t.a, t.b, t.c);
  if (orientation == 0) {
    return are_collinear(t.a, t.b, p) && are_collinear(t.b, t.c, p) && are_collinear(t.c, t.a, p);
  }
  if (orient_3d(t.a, t.b, t.c, p) != 0) return false;
  const auto flat = [k = dropped](const Vector3<double>& v) {
    return drop_dimension<double>(v, k);
  };
  const Vector2<double> a = flat(t.a), b = flat(t.b), c = flat(t.c), q = flat(p);
  return orient_2d(a, b, q) * orientation >= 0 && orient_2d(b, c, q) * orientation >= 0 &&
         orient_2d(c, a, q) * orientation >= 0;
}
// [/on-triangle]

namespace mesh_location_detail {

/// What one triangle contributes to the location of a point.
struct Crossing {
  bool on = false;  ///< the point is on the triangle
  int step = 0;     ///< +1 if the ray leaves through the triangle, −1 if it enters, else 0
};

/// The direction of the ray along z.
enum class Ahead { up = 1, down = -1 };

// [perturbed-side]
/// The side of a projected edge on which (x + ε, y + ε²) is, for all sufficiently small ε > 0, if
/// (x, y) is on the given side: the side itself, and on the line of the edge the sign of the terms
/// (a.y − b.y) ε + (b.x − a.x) ε². 0 only for a projection that is a point.
inline int perturbed_side(int side, const Vector3<double>& a, const Vector3<double>& b) {
  if (side != 0) return side;
  if (a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
  return b.x() > a.x() ? 1 : (b.x() < a.x() ? -1 : 0);
}
// [/perturbed-side]

/// x and y.
inline Vector2<double> seen_along_z(const Vector3<double>& v) { return {v.x(), v.y()}; }

/// The sign of the orientation of p and an edge in the projection along z.
inline int side_of_edge(const Vector3<double>& p, const Vector3<double>& a,
                        const Vector3<double>& b) {
  return polygon_detail::side(seen_along_z(p), seen_along_z(a), seen_along_z(b));
}

// [crossing-in-doubt]
/// The same as `crossing` for a point whose projection may be on the line of an edge.
[[gnu::noinline]] inline Crossing crossing_in_doubt(const Vector3<double>& p,
                                                    const Triangle<double>& t, Ahead ahead) {
  if (!finite_triangle(t)) return {};
  const int ab = side_of_edge(p, t.a, t.b);
  const int bc = side_of_edge(p, t.b, t.c);
  const int ca = side_of_edge(p, t.c, t.a);
  const int smallest = std::min({ab, bc, ca}), largest = std::max({ab, bc, ca});
  if (smallest < 0 && largest > 0) return {};  // beside the projection
  // The triangle is vertical, and p is in its plane: it can be on it, but the perturbed ray is not
  // in this plane and does not meet it.
  if (smallest == 0 && largest == 0) return {on_triangle(p, t), 0};
  const int orientation = smallest + largest > 0 ? 1 : -1;
  const int height = orient_3d(t.a, t.b, t.c, p);
  if (height == 0) return {true, 0};
  const int out = static_cast<int>(ahead);
  if (height == orientation * out) return {};  // the triangle is behind the ray
  const bool met = perturbed_side(ab, t.a, t.b) == orientation &&
                   perturbed_side(bc, t.b, t.c) == orientation &&
                   perturbed_side(ca, t.c, t.a) == orientation;
  return {false, met ? orientation * out : 0};
}
// [/crossing-in-doubt]

// [crossing]
/// What a triangle contributes to the location of p, which must be finite.
///
/// If all three sides are certain and equal, the vertical line through p meets the interior of the
/// triangle, and the height decides: most are decided by comparing coordinates.
inline Crossing crossing(const Vector3<double>& p, const Triangle<double>& t,
                         Ahead ahead = Ahead::up) {
  const Vector2<double> q = seen_along_z(p);
  const Vector2<double> a = seen_along_z(t.a), b = seen_along_z(t.b), c = seen_along_z(t.c);
  const int ab = bounded_orientation(q, a, b).certain_sign();
  const int bc = bounded_orientation(q, b, c).certain_sign();
  const int ca = bounded_orientation(q, c, a).certain_sign();
  if (ab * bc < 0 || bc * ca < 0 || ca * ab < 0) return {};
  if (ab * bc * ca == 0) return crossing_in_doubt(p, t, ahead);
  int above = 0;  // +1 if p is above the triangle
  if (p.z() < std::min({t.a.z(), t.b.z(), t.c.z()})) above = -1;
  if (p.z() > std::max({t.a.z(), t.b.z(), t.c.z()})) above = 1;
  if (above == 0) {
    above = ab * bounded_volume(p - t.a, t.b - t.a, t.c - t.a).certain_sign();
    if (above == 0) return crossing_in_doubt(p, t, ahead);
  }
  const int out = static_cast<int>(ahead);
  return {false, above == out ? 0 : ab * out};
}
// [/crossing]

/// Whether the ray from p along +z meets the box of a triangle, by comparisons alone.
inline bool column_meets(const Vector3<double>& p, const Triangle<double>& t) {
  return p.x() >= std::min({t.a.x(), t.b.x(), t.c.x()}) &&
         p.x() <= std::max({t.a.x(), t.b.x(), t.c.x()}) &&
         p.y() >= std::min({t.a.y(), t.b.y(), t.c.y()}) &&
         p.y() <= std::max({t.a.y(), t.b.y(), t.c.y()}) &&
         p.z() <= std::max({t.a.z(), t.b.z(), t.c.z()});
}

/// The location of a point with this winding number off the surface.
inline MeshLocation off_surface(int winding, Rule rule) {
  const bool inside = rule == Rule::non_zero ? winding != 0 : winding % 2 != 0;
  return {inside ? Where::inside : Where::outside, winding};
}

/// The location from all triangles of a mesh; counts those that were tested by orientations.
template <FloatOrDouble S>
MeshLocation locate(const Vector3<S>& point, const Mesh<S>& mesh, Rule rule, long& tested) {
  const Vector3<double>& p = point.template cast<double>();
  if (!all_finite(p)) return {};
  int winding = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> t = in_double(triangle_of(mesh, i));
    if (!column_meets(p, t)) continue;
    ++tested;
    const Crossing found = crossing(p, t);
    if (found.on) return {Where::on, 0};
    winding += found.step;
  }
  return off_surface(winding, rule);
}

}  // namespace mesh_location_detail

/// Where a point is, relative to a closed and oriented mesh: the book's choice.
///
/// **On the surface.** The point is on it if a triangle contains it: if its projection along z is
/// in that of the triangle and `orient_3d` is 0; for a vertical triangle `on_triangle` decides. The
/// ray starts in the box of such a triangle, so no comparison of boxes leaves it out.
///
/// **Off the surface** the winding number is the number of triangles through which a ray from the
/// point leaves, minus the number of those through which it enters; for the ray along +z a triangle
/// is left if its projection is counter-clockwise. The ray may meet edges and vertices, and may lie
/// in vertical triangles. So the point is moved, in thought, from (x, y, z) to (x + ε, y + ε², z).
/// - The moved ray meets no edge and no vertex for all sufficiently small ε > 0. The projection of
///   an edge is in a line α x + β y = γ or is a point. On the curve (x + ε, y + ε²) the difference
///   of both sides is a polynomial in ε; α and β are not both 0, so it is not the polynomial 0, and
///   has no root in some interval (0, ε₀). There are finitely many edges.
/// - Moving changes no answer: the point is not on the surface, which is closed as a set of points,
///   so a ball around the point has no point of the surface, and the winding number is constant in
///   it.
/// - A moved ray passes through the interiors of triangles only, none of them vertical, and the sum
///   of the signs is the winding number, as for every such ray.
/// - The decisions need no ε. The side of an edge is the sign of a polynomial in ε for small ε, the
///   sign of its first coefficient that is not 0 (`perturbed_side`). Reversed, the edge has the
///   opposite sign, so its two triangles agree. A vertical triangle has a projection without area:
///   the three polynomials have the sum 0 and are never all of one sign. The height is the sign of
///   `orient_3d`, which is not 0 where the moved ray meets the triangle: if it were, the point
///   would be in the plane and in the closed projection, that is, on the triangle.
///
/// Right for every finite input, whatever the ray meets. Every sign is decided by a filter, and
/// exactly where it is in doubt.
///
/// A mesh that is closed and oriented but crosses itself, or has several components, is allowed:
/// then `rule` says which winding numbers are inside. Components inside out subtract. If all
/// triangles are reversed, the winding number is negated, and `where` is the same. For a mesh that
/// is not closed, `winding` is the signed number of triangles above the point, which depends on the
/// direction: it means nothing. No triangles, or a point that is not finite: outside. A vertex that
/// is not finite is an error of the program: the result then means nothing.
///
/// @param point m, any scale
/// @param mesh m; each triangle is compared, so the time is proportional to their number
///
/// Source: Edelsbrunner and Mücke, Simulation of Simplicity, 1990, for the perturbation.
// [locate-in-mesh]
template <FloatOrDouble S>
MeshLocation locate_in_mesh(const Vector3<S>& point, const Mesh<S>& mesh,
                            Rule rule = Rule::non_zero) {
  long tested = 0;
  return mesh_location_detail::locate(point, mesh, rule, tested);
}
// [/locate-in-mesh]

// [locate-by-tree]
/// The same answer by a tree of boxes: only triangles in boxes that the ray meets are tested. A ray
/// along an axis meets a box if two coordinates are in it and it is not all behind, which is
/// decided by comparisons, without rounding.
///
/// The ray goes up or down, towards the nearer end of the mesh's box; both are right. Only for a
/// mesh that is not closed the winding number may differ from that without a tree.
///
/// @param tree over the mesh; triangles that are not finite are not in it
/// @param counts if not null, the numbers of boxes and triangles asked are added to it
template <FloatOrDouble S>
MeshLocation locate_in_mesh(const Vector3<S>& point, const MeshTree<S>& tree,
                            Rule rule = Rule::non_zero, TreeCounts* counts = nullptr) {
  using namespace mesh_location_detail;
  if (!all_finite(point) || tree.boxes().nodes.empty()) return {};
  const Vector3<double>& p = point.template cast<double>();
  const S x = point.x(), y = point.y(), z = point.z();
  const auto in_column = [x, y](const Aabb<S>& box) {
    return int{box.low.x() <= x} & int{x <= box.high.x()} & int{box.low.y() <= y} &
           int{y <= box.high.y()};
  };
  int winding = 0;
  const auto ask = [&](Ahead ahead, const auto& enters) {
    const auto visit = [&winding, &p, ahead](int, const Triangle<S>& triangle) {
      const Crossing found = crossing(p, in_double(triangle), ahead);
      winding += found.step;
      return found.on;
    };
    return tree.visit(enters, visit, counts);
  };
  const Aabb<S>& box = tree.boxes().nodes[0].box;
  const bool up = box.high.z() / 2 - z / 2 <= z / 2 - box.low.z() / 2;
  const bool on =
      up ? ask(Ahead::up,
               [&](const Aabb<S>& b) { return (in_column(b) & int{z <= b.high.z()}) != 0; })
         : ask(Ahead::down,
               [&](const Aabb<S>& b) { return (in_column(b) & int{b.low.z() <= z}) != 0; });
  return on ? MeshLocation{Where::on, 0} : off_surface(winding, rule);
}
// [/locate-by-tree]

}  // namespace contact
