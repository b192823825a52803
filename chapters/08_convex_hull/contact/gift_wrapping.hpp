/// @file
/// Gift wrapping: a hull found face by face, each folded over an edge of the one before. Once as
/// the lecture gives it, by angles, and once repaired, by orientation tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/hull.hpp>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace contact {

/// What "the angle with the plane" means.
enum class FoldAngle {
  unsigned_,  ///< between two planes, 0 to 90°: as the words of the slide have it
  signed_     ///< by how much the paper turns about the edge, 0 to 180°
};

/// The result of wrapping by angles.
struct Wrapping {
  std::vector<std::array<int, 3>> triangles;  ///< three points each
  bool closed = false;  ///< every edge is shared by two triangles, once in each direction
};

/// A monotonic function of an angle, from its sine (not negative) and cosine times a common
/// positive factor: 0 for 0°, 1 for 90°, 2 for 180°. It compares as the angle does but needs no
/// arctangent, so it gives the same result on every machine.
template <Scalar S>
S angle_rank(const S& sine, const S& cosine) {
  return S(1) - cosine / (sine + (cosine < S(0) ? -cosine : cosine));
}

// [by-angles]
/// The lecture's five steps, in the arithmetic of S: highest vertex, edge of least angle with the
/// horizontal plane, first triangle, then over each unmatched edge the vertex of least angle.
///
/// Of equal angles the first one counts, as in a plain loop, and a point equal to the highest is
/// skipped. The method stops with `closed` false if a triangle needs an edge that another triangle
/// has, or after 2n triangles.
///
/// @param points m; the first three steps need three of them that are not collinear
///
/// Limits: right in general position with signed angles, within rounding. Wrong with unsigned ones,
/// and where several points share the least angle (coplanar, collinear, equal).
///
/// Source: *Interaction and Normals*, slide "Convex Hull".
template <Scalar S>
Wrapping wrap_by_angles(const std::vector<Vector3<double>>& points, FoldAngle fold) {
  using std::sqrt;
  const int n = static_cast<int>(points.size());
  const auto at = [&points](int i) -> Vector3<S> {
    return points[static_cast<std::size_t>(i)].template cast<S>();
  };
  Wrapping result;
  if (n < 4) return result;
  // The point with the least `angle`; a NaN is never the least.
  const auto least = [n](const auto& angle) {
    int best = -1;
    S smallest = S(0);
    for (int i = 0; i < n; ++i) {
      const S x = angle(i);
      if (!std::isnan(x) && (best < 0 || x < smallest)) {
        smallest = x;
        best = i;
      }
    }
    return best;
  };
  const S none = std::numeric_limits<S>::quiet_NaN();

  const int v1 = least([&](int i) { return -at(i).z(); });
  const int v2 = least([&](int i) {
    if (i == v1) return none;
    const Vector3<S> d = at(i) - at(v1);
    if (d == Vector3<S>::Zero()) return none;
    return angle_rank<S>(-d.z(), sqrt(d.x() * d.x() + d.y() * d.y()));
  });
  // The angle between the triangle a, b, i and the plane with this normal.
  const auto angle_over = [&](int a, int b, int i, const Vector3<S>& normal) {
    if (i == a || i == b) return none;
    const Vector3<S> turned = (at(b) - at(a)).cross(at(i) - at(a));
    const S sine = normal.cross(turned).norm(), cosine = normal.dot(turned);
    if (sine == S(0) && cosine == S(0)) return none;
    const bool folds_back = fold == FoldAngle::unsigned_ && cosine < S(0);
    return angle_rank<S>(sine, folds_back ? -cosine : cosine);
  };
  if (v2 < 0) return result;
  const Vector3<S> edge = at(v2) - at(v1);
  const Vector3<S> level = edge.cross(Vector3<S>(S(0), S(0), S(1)));
  Vector3<S> tilted = level.cross(edge);
  if (tilted.z() < S(0)) tilted = -tilted;
  const int v3 = least([&](int i) {
    const S one = angle_over(v1, v2, i, tilted), other = angle_over(v2, v1, i, tilted);
    return other < one ? other : one;  // the first triangle may lie on either side of the edge
  });
  if (v3 < 0) return result;

  std::map<std::pair<int, int>, int> triangle_at;  // by directed edge
  std::vector<std::pair<int, int>> unmatched;
  bool stuck = false;
  const auto add = [&](int a, int b, int c) {
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      if (!triangle_at.emplace(std::pair{from, to}, static_cast<int>(result.triangles.size()))
               .second) {
        stuck = true;
      }
      unmatched.emplace_back(from, to);
    }
    result.triangles.push_back({a, b, c});
  };
  if ((at(v2) - at(v1)).cross(at(v3) - at(v1)).dot(tilted) > S(0)) {
    add(v1, v2, v3);
  } else {
    add(v2, v1, v3);
  }
  for (std::size_t next = 0; next < unmatched.size() && !stuck; ++next) {
    const auto [from, to] = unmatched[next];
    if (triangle_at.contains({to, from})) continue;
    if (static_cast<int>(result.triangles.size()) >= 2 * n) {
      stuck = true;
      break;
    }
    const auto [a, b, c] = result.triangles[static_cast<std::size_t>(triangle_at.at({from, to}))];
    const Vector3<S> normal = (at(b) - at(a)).cross(at(c) - at(a));
    const int found = least([&, from_ = from, to_ = to, a_ = a, b_ = b, c_ = c](int i) {
      if (i == a_ || i == b_ || i == c_) return none;  // not the triangle itself
      return angle_over(to_, from_, i, normal);
    });
    if (found < 0) {
      stuck = true;
      break;
    }
    add(to, from, found);
  }
  result.closed = !stuck;
  return result;
}
// [/by-angles]

/// Gift wrapping with whole faces, and with orientation tests instead of angles.
///
/// It starts at the lexicographically highest point (z, then x, then y), which is a vertex even if
/// there are ties, with a face found by turning a plane about it. Over each unmatched edge it turns
/// a plane until no point is in front; every point in that plane belongs to the face, whose
/// vertices are the hull of these points in two dimensions.
///
/// With exact decisions the result is that of `convex_hull`. With rounded ones it may get stuck:
/// then `closed` is false.
///
/// @param points m; throws std::invalid_argument unless all are finite
///
/// Limits: 2n orientation tests for each face of the hull, so O(n h) with h vertices.
///
/// Source: Chand and Kapur, An Algorithm for Convex Polytopes, 1970.
template <SideTest Sides, class... Arguments>
Hull gift_wrap_with(const std::vector<Vector3<double>>& points, Arguments... arguments) {
  require_finite_points(points);
  const Simplex simplex = first_simplex(points);
  if (simplex.dimension < 3) return flat_hull(points, simplex);
  const Sides sides(points, arguments...);
  const int n = static_cast<int>(points.size());
  const auto at = [&points](int i) -> const Vector3<double>& {
    return points[static_cast<std::size_t>(i)];
  };
  Hull hull;
  hull.dimension = 3;

  // [wrap-turn]
  // Turns the plane through a, b and c about the edge a, b until no point is in front of it.
  const auto turn_forward = [&](int a, int b, int c) {
    typename Sides::Plane plane = sides.plane(a, b, c);
    for (int i = 0; i < n; ++i) {
      if (i == a || i == b || i == c || sides.side(plane, a, b, c, i) <= 0) continue;
      c = i;
      plane = sides.plane(a, b, c);
    }
    return c;
  };
  // The face in the plane a, b, c: the hull of all points of that plane.
  const auto face_of = [&](int a, int b, int c) {
    const typename Sides::Plane plane = sides.plane(a, b, c);
    std::vector<int> flat;
    for (int i = 0; i < n; ++i) {
      if (i == a || i == b || i == c || sides.side(plane, a, b, c, i) == 0) flat.push_back(i);
    }
    return hull_in_plane(points, flat, a, b, c);
  };
  // [/wrap-turn]
  const auto off_line = [&](int a, int b) {
    int c = 0;
    while (c < n && are_collinear(at(a), at(b), at(c))) ++c;
    return c;
  };

  // [wrap-start]
  // The highest point; of ties the one with the greatest x, then y.
  int top = 0;
  for (int i = 1; i < n; ++i) {
    const auto key = [&at](int k) { return std::array{at(k).z(), at(k).x(), at(k).y()}; };
    if (key(top) < key(i)) top = i;
  }
  // Projected along y it is a vertex of the projected hull. The edge of that hull that starts there
  // is a plane with no point in front.
  std::vector<Vector2<double>> side_view;
  for (const Vector3<double>& p : points) side_view.emplace_back(p.z(), p.x());
  int second = -1;
  for (int i = 0; i < n; ++i) {
    const auto flat = [&](int k) { return side_view[static_cast<std::size_t>(k)]; };
    if (flat(i) == flat(top)) continue;
    if (second < 0) {
      second = i;
      continue;
    }
    const int side = orient_2d(flat(top), flat(second), flat(i));
    // Of collinear points any will do.
    if (side > 0) second = i;
  }
  std::vector<int> on_plane;
  for (int i = 0; i < n; ++i) {
    const auto flat = [&](int k) { return side_view[static_cast<std::size_t>(k)]; };
    if (orient_2d(flat(top), flat(second), flat(i)) == 0) on_plane.push_back(i);
  }
  // If all points of that plane are collinear, the two ends are an edge; otherwise the polygon has
  // edges.
  std::vector<Vector3<double>> in_plane;
  for (const int i : on_plane) in_plane.push_back(at(i));
  const Hull start = flat_hull(in_plane, first_simplex(in_plane));
  const auto named = [&](int i) { return on_plane[static_cast<std::size_t>(i)]; };
  const int a = named(start.dimension == 2 ? start.face_vertices[0] : start.vertices[0]);
  const int b = named(start.dimension == 2 ? start.face_vertices[1] : start.vertices[1]);
  const int c = turn_forward(a, b, off_line(a, b));
  // [/wrap-start]

  // [wrap-loop]
  std::map<std::pair<int, int>, int> inner;  // for each directed edge another vertex of its face
  std::vector<std::pair<int, int>> unmatched;
  const auto add = [&](const std::vector<int>& polygon) {
    if (polygon.size() < 3) hull.closed = false;
    for (std::size_t i = 0; i < polygon.size() && hull.closed; ++i) {
      const std::pair edge{polygon[i], polygon[(i + 1) % polygon.size()]};
      if (!inner.emplace(edge, polygon[(i + 2) % polygon.size()]).second) hull.closed = false;
      unmatched.push_back(edge);
    }
    if (hull.closed) hull.add_face(polygon);
  };
  add(face_of(a, b, c));
  for (std::size_t next = 0; next < unmatched.size() && hull.closed; ++next) {
    const auto [from, to] = unmatched[next];
    if (inner.contains({to, from})) continue;
    // Start with the plane of the known face, reversed: all other points are in front of it.
    const int third = turn_forward(to, from, inner.at({from, to}));
    add(face_of(to, from, third));
    if (!inner.contains({to, from})) hull.closed = false;
  }
  // [/wrap-loop]
  collect_vertices(hull);
  return hull;
}

/// Gift wrapping with every decision exact.
inline Hull gift_wrap(const std::vector<Vector3<double>>& points) {
  return gift_wrap_with<ExactSides>(points);
}

}  // namespace contact
