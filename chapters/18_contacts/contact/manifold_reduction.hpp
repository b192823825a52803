/// @file
/// A contact manifold with at most four points: which points hold a body, and what is lost without
/// the others.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <contact/hull_2d.hpp>
#include <contact/manifold_point.hpp>
#include <contact/orientation.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Four of the vertices of a convex polygon, or as many as it has.
class SupportPolygon {
 public:
  /// @param outline vertices, counter-clockwise
  /// @param load a point that the chosen vertices must contain if all vertices do
  SupportPolygon(std::vector<Vector2<double>> outline, const Vector2<double>& load)
      : outline_(std::move(outline)), load_(load) {
    double size = 0;
    for (const Vector2<double>& p : outline_) size = std::max(size, p.cwiseAbs().maxCoeff());
    int power = 0;
    std::frexp(size, &power);
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const Vector2<double>& p = outline_[i];
      scaled_.emplace_back(std::ldexp(p.x(), -power), std::ldexp(p.y(), -power));
      const std::size_t next = (i + 1) % outline_.size();
      must_contain_ = must_contain_ && orient_2d(outline_[i], outline_[next], load_) >= 0;
    }
  }

  // [best-four]
  /// The quadrilateral of largest area with a given vertex that contains the load; a triangle if
  /// the polygon has three vertices.
  ///
  /// A diagonal from the given vertex to another one cuts each such quadrilateral into two
  /// triangles. On either side the third vertex is chosen alone: the farthest from the diagonal,
  /// on the load's side the farthest of those whose triangle contains the load. There is always
  /// one: the diagonals from a vertex cut the polygon into triangles, and one contains the load.
  std::vector<std::size_t> with(std::size_t first) const {
    std::vector<std::size_t> best;
    double largest = -1;
    const std::size_t n = outline_.size();
    for (std::size_t step = 1; step < n; ++step) {
      const std::size_t other = (first + step) % n;
      const Third right = third(first, other), left = third(other, first);
      if (!right.possible || !left.possible || !(right.area + left.area > largest)) continue;
      largest = right.area + left.area;
      best = {first, other};
      if (right.vertex != other) best.push_back(right.vertex);
      if (left.vertex != first) best.push_back(left.vertex);
    }
    return best;
  }
  // [/best-four]

  /// The triangle of largest area that contains the load. Time is proportional to the cube of the
  /// number of vertices.
  std::vector<std::size_t> triangle() const {
    std::vector<std::size_t> best;
    double largest = -1;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      for (std::size_t k = i + 1; k < outline_.size(); ++k) {
        const Third apex = third(k, i);
        const bool beside = must_contain_ && orient_2d(outline_[k], outline_[i], load_) < 0;
        if (!apex.possible || beside || !(apex.area > largest)) continue;
        largest = apex.area;
        best = {i, k, apex.vertex};
        if (apex.vertex == i) best.pop_back();
      }
    }
    return best;
  }

 private:
  std::vector<Vector2<double>> outline_;
  std::vector<Vector2<double>>
      scaled_;  // by a power of two, so that areas do not over- or underflow
  Vector2<double> load_;
  bool must_contain_ = true;

  struct Third {
    bool possible;
    double area;         // twice, scaled and rounded: it may be 0 for a vertex that the load needs
    std::size_t vertex;  // `to` if there is none
  };
  /// The third vertex of the largest triangle to the left of the line from one vertex to another:
  /// one of those that follow `to` and precede `from`.
  Third third(std::size_t from, std::size_t to) const {
    const std::size_t n = outline_.size();
    const Vector2<double>&p = outline_[from], &q = outline_[to];
    const bool holds = must_contain_ && orient_2d(p, q, load_) > 0;
    Third best{!holds, 0, to};
    for (std::size_t k = (to + 1) % n; k != from; k = (k + 1) % n) {
      const Vector2<double>& r = outline_[k];
      if (holds && (orient_2d(q, r, load_) < 0 || orient_2d(r, p, load_) < 0)) continue;
      const Vector2<double> d = scaled_[to] - scaled_[from], e = scaled_[k] - scaled_[from];
      const double area = d.x() * e.y() - d.y() * e.x();
      if (best.possible && !(area > best.area)) continue;
      best = {true, std::max(area, 0.0), k};
    }
    return best;
  }
};

}  // namespace detail

// [reduced-manifold]
/// At most four points of a manifold, in the same order.
///
/// Seen along the normal, points support a load whose line passes through their convex hull. Three
/// points always suffice for one load (Carathéodory); four are enough to keep the deepest point as
/// well, and of all such choices the one of largest area is taken:
/// - the deepest point (the first of equally deep ones), so that the distance of the bodies is that
///   of the points;
/// - if the hull of all points contains the load, so does that of the chosen ones, exactly for the
///   projected points as they are in double. A body that cannot tip over does not because of the
///   reduction;
/// - if the deepest point is a vertex of the hull, no other quadrilateral with these two properties
///   is larger, up to rounding. If it is inside, the other three are the largest triangle that
///   contains the load.
///
/// Lost are the distances of the other points, which may penetrate, and support for other loads:
/// of a regular octagon 1 − 1/√2 = 29.3% of the area. Of any convex polygon the largest
/// quadrilateral is at least 2/π = 63.7% (Sas), but the deepest point and a load near the boundary
/// can demand a smaller one.
/// @param load a point on the line of the load, such as the centre of mass of the body that rests
/// on the other, m
/// @return the manifold itself if it has at most four points, or a number or projection is not
/// finite
/// @see E. Sas, *Über eine Extremumeigenschaft der Ellipsen*, Compositio Mathematica 6 (1939)
template <FloatOrDouble S>
ContactManifold<S> reduced_manifold(const ContactManifold<S>& manifold, const Vector3<S>& load) {
  if (manifold.points.size() <= 4 || !all_finite(manifold.normal) || !all_finite(load)) {
    return manifold;
  }
  const Vector3<S> right = detail::perpendicular_to<S>(manifold.normal);
  const Vector3<S> up = manifold.normal.cross(right);
  const auto projected = [&](const Vector3<S>& p) {
    return Vector2<double>(double(right.dot(p)), double(up.dot(p)));
  };
  std::vector<Vector2<double>> flat;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < manifold.points.size(); ++i) {
    flat.push_back(projected(manifold.points[i].point));
    if (!all_finite(flat.back()) || !is_finite(manifold.points[i].distance)) return manifold;
    if (manifold.points[i].distance < manifold.points[deepest].distance) deepest = i;
  }
  if (!all_finite(projected(load))) return manifold;
  const std::vector<int> hull = convex_hull_2d(flat);
  std::vector<Vector2<double>> outline;
  std::size_t at = hull.size();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    outline.push_back(flat[std::size_t(hull[i])]);
    if (outline.back() == flat[deepest]) at = i;
  }
  const detail::SupportPolygon support(outline, projected(load));
  const bool inside = at == hull.size();
  std::vector<bool> kept(manifold.points.size(), false);
  for (const std::size_t i : inside ? support.triangle() : support.with(at)) {
    kept[std::size_t(hull[i])] = true;
  }
  if (!inside) kept[std::size_t(hull[at])] = false;  // of two points there the deepest
  kept[deepest] = true;
  ContactManifold<S> reduced{manifold.normal, {}};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) reduced.points.push_back(manifold.points[i]);
  }
  return reduced;
}
// [/reduced-manifold]

}  // namespace contact
