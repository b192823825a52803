/// @file
/// A convex hull as vertices and faces, for input of any dimension.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <contact/hull_2d.hpp>
#include <contact/orientation.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace contact {

// [hull]
/// A convex hull in space, by the indices of the points that it was made of.
///
/// | dimension | the points are | vertices | faces |
/// |---|---|---|---|
/// | −1 | none | none | none |
/// | 0 | all equal | one | none |
/// | 1 | on a line | the two ends | none |
/// | 2 | in a plane | the vertices of a convex polygon | two: that polygon from either side |
/// | 3 | none of these | the vertices of a polyhedron | its faces |
///
/// A face is a convex polygon; coplanar triangles are joined into one face. Its vertices run
/// counter-clockwise as seen from outside. No vertex lies on an edge or in the interior of a face.
/// Of equal points the first one represents all. For 2 and 3 dimensions Euler's formula holds:
/// vertices − edges + faces = 2, where the number of edges is half the length of `face_vertices`.
struct Hull {
  int dimension = -1;              ///< of the affine hull of the points, from -1 to 3
  std::vector<int> vertices;       ///< in increasing order
  std::vector<int> face_vertices;  ///< the vertices of all faces, one face after the other
  std::vector<int>
      face_starts;  ///< where each face begins in `face_vertices`, then where the last one ends
  /// False if a method with rounded decisions got stuck: then the faces do not close.
  bool closed = true;

  /// The number of faces.
  int face_count() const {
    return face_starts.empty() ? 0 : static_cast<int>(face_starts.size()) - 1;
  }
  /// The number of edges.
  int edge_count() const { return static_cast<int>(face_vertices.size() / 2); }
  /// The vertices of face i, counter-clockwise from outside.
  std::span<const int> face(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return std::span<const int>(face_vertices)
        .subspan(static_cast<std::size_t>(face_starts[at]),
                 static_cast<std::size_t>(face_starts[at + 1] - face_starts[at]));
  }
  /// Appends a face.
  void add_face(std::span<const int> polygon) {
    if (face_starts.empty()) face_starts.push_back(0);
    face_vertices.insert(face_vertices.end(), polygon.begin(), polygon.end());
    face_starts.push_back(static_cast<int>(face_vertices.size()));
  }
};
// [/hull]

/// The faces cut into triangles, each by diagonals from its first vertex.
inline std::vector<std::array<int, 3>> triangles(const Hull& hull) {
  std::vector<std::array<int, 3>> all;
  for (int f = 0; f < hull.face_count(); ++f) {
    const auto polygon = hull.face(f);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      all.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
  }
  return all;
}

/// Fills `vertices` from the faces.
inline void collect_vertices(Hull& hull) {
  hull.vertices = hull.face_vertices;
  std::sort(hull.vertices.begin(), hull.vertices.end());
  hull.vertices.erase(std::unique(hull.vertices.begin(), hull.vertices.end()), hull.vertices.end());
}

/// The dimension of the affine hull of the points, and `dimension + 1` of the points that span it:
/// four that are not coplanar, or fewer if there are none. For 3 dimensions point 3 is behind the
/// triangle of the others.
struct Simplex {
  int dimension = -1;                     ///< from -1 to 3
  std::array<int, 4> points{0, 0, 0, 0};  ///< the first `dimension + 1` count
};

/// A large simplex of the points, found exactly: distant points are tried first, and all points if
/// those are degenerate.
inline Simplex first_simplex(const std::vector<Vector3<double>>& points) {
  Simplex simplex;
  if (points.empty()) return simplex;
  const int n = static_cast<int>(points.size());
  const auto at = [&points](int i) -> const Vector3<double>& {
    return points[static_cast<std::size_t>(i)];
  };
  int& a = simplex.points[0];
  int& b = simplex.points[1];
  int& c = simplex.points[2];
  int& d = simplex.points[3];
  // The candidate with the greatest rounded size; if that is degenerate, the first that is not.
  const auto choose = [n](const auto& size, const auto& fits) {
    int best = 0;
    double largest = -1;
    for (int i = 0; i < n; ++i) {
      const double s = size(i);
      if (s > largest) {
        largest = s;
        best = i;
      }
    }
    if (fits(best)) return best;
    for (int i = 0; i < n; ++i) {
      if (fits(i)) return i;
    }
    return -1;
  };
  for (int i = 1; i < n; ++i) {
    if (at(i).x() < at(a).x()) a = i;
  }
  simplex.dimension = 0;
  b = choose([&](int i) { return (at(i) - at(a)).squaredNorm(); },
             [&](int i) { return at(i) != at(a); });
  if (b < 0) return simplex;
  simplex.dimension = 1;
  c = choose([&](int i) { return (at(b) - at(a)).cross(at(i) - at(a)).squaredNorm(); },
             [&](int i) { return !are_collinear(at(a), at(b), at(i)); });
  if (c < 0) return simplex;
  simplex.dimension = 2;
  const Vector3<double> normal = (at(b) - at(a)).cross(at(c) - at(a));
  d = choose([&](int i) { return std::abs(normal.dot(at(i) - at(a))); },
             [&](int i) { return orient_3d(at(a), at(b), at(c), at(i)) != 0; });
  if (d < 0) return simplex;
  simplex.dimension = 3;
  if (orient_3d(at(a), at(b), at(c), at(d)) > 0) std::swap(b, c);
  return simplex;
}

/// The vertices of the hull of some points of the plane a, b, c, in the sense of rotation of that
/// triangle. Exact. Of equal points the first one represents all.
inline std::vector<int> hull_in_plane(const std::vector<Vector3<double>>& points,
                                      const std::vector<int>& chosen, int a, int b, int c) {
  const auto at = [&points](int i) -> const Vector3<double>& {
    return points[static_cast<std::size_t>(i)];
  };
  const FlatView view = flat_view(at(a), at(b), at(c));
  std::vector<Vector2<double>> flat;
  flat.reserve(chosen.size());
  for (const int i : chosen) flat.push_back(drop_dimension<double>(at(i), view.dropped));
  std::vector<int> polygon = convex_hull_2d(flat);
  for (int& vertex : polygon) vertex = chosen[static_cast<std::size_t>(vertex)];
  if (view.orientation < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// The hull of points that span fewer than three dimensions.
inline Hull flat_hull(const std::vector<Vector3<double>>& points, const Simplex& simplex) {
  Hull hull;
  hull.dimension = simplex.dimension;
  if (simplex.dimension < 0) return hull;
  const auto at = [&points](int i) -> const Vector3<double>& {
    return points[static_cast<std::size_t>(i)];
  };
  const int n = static_cast<int>(points.size());
  if (simplex.dimension < 2) {
    const auto before = [&at](int i, int j) {
      return std::lexicographical_compare(at(i).begin(), at(i).end(), at(j).begin(), at(j).end());
    };
    int first = 0, last = 0;
    for (int i = 1; i < n; ++i) {
      if (before(i, first)) first = i;
      if (before(last, i)) last = i;
    }
    hull.vertices = {std::min(first, last)};
    if (first != last) hull.vertices.push_back(std::max(first, last));
    return hull;
  }
  std::vector<int> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  const auto [a, b, c, d] = simplex.points;
  std::vector<int> polygon = hull_in_plane(points, all, a, b, c);
  hull.add_face(polygon);
  std::reverse(polygon.begin(), polygon.end());
  hull.add_face(polygon);
  collect_vertices(hull);
  return hull;
}

/// The decisions of a hull: side(plane, a, b, c, d) is +1 if point d is in front of the triangle of
/// the points a, b, c, −1 if it is behind and 0 if it is in the plane; `plane` is what was computed
/// in advance for that triangle.
template <class T>
concept SideTest = requires(const T test, int i) {
  typename T::Plane;
  { test.plane(i, i, i) } -> std::same_as<typename T::Plane>;
  { test.side(test.plane(i, i, i), i, i, i, i) } -> std::same_as<int>;
};

// [exact-sides]
/// Exact orientation, with one filter per plane: the normal is computed once, with a bound on the
/// error for all points of the set.
///
/// The bound is that of `bounded_volume`, with the width of the set instead of |p_i|. Rounding is
/// monotonic, so the computed |p_i| is at most the computed width, and each step of the bound is at
/// least that of one point.
class ExactSides {
 public:
  /// A plane: its rounded normal n, and a bound on the error of n·(p − at).
  struct Plane {
    Vector3<double> normal;  ///< not normalised
    Vector3<double> at;      ///< a point of the plane
    double bound;            ///< on the error of n·(p − at), for every point of the set
  };

  /// @param points finite; must neither move in memory nor change while this object is used
  explicit ExactSides(const std::vector<Vector3<double>>& points)
      : points_(points.data()), width_(0, 0, 0) {
    if (points.empty()) return;
    Vector3<double> low = points[0], high = points[0];
    for (const Vector3<double>& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    width_ = high - low;
  }

  /// The plane of three points.
  Plane plane(int a, int b, int c) const {
    constexpr double nine_u = 4.5 * std::numeric_limits<double>::epsilon();
    const Vector3<double> q = at(b) - at(a), r = at(c) - at(a);
    Plane plane{{0, 0, 0}, at(a), 0};
    double magnitude = 0, size = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double left = q[j] * r[k], right = q[k] * r[j];
      plane.normal[i] = left - right;
      magnitude += width_[i] * (std::abs(left) + std::abs(right));
      size += width_[i];
    }
    plane.bound = nine_u * magnitude + 0x1p-1000 * (1 + size);
    return plane;
  }

  /// +1 if point d is in front of the plane a, b, c, −1 behind, 0 exactly in it.
  int side(const Plane& plane, int a, int b, int c, int d) const {
    const Vector3<double> p = at(d) - plane.at;
    const double value = p[0] * plane.normal[0] + p[1] * plane.normal[1] + p[2] * plane.normal[2];
    if (value > plane.bound) return 1;
    if (value < -plane.bound) return -1;
    return orient_3d(at(a), at(b), at(c), at(d));
  }

 private:
  const Vector3<double>* points_;
  Vector3<double> width_;

  const Vector3<double>& at(int i) const { return points_[i]; }
};
// [/exact-sides]

/// Exact orientation without a filter.
class UnfilteredSides {
 public:
  /// Nothing is computed in advance.
  struct Plane {};
  /// @param points finite; must neither move in memory nor change while this object is used
  explicit UnfilteredSides(const std::vector<Vector3<double>>& points) : points_(points.data()) {}
  /// Nothing.
  Plane plane(int, int, int) const { return {}; }
  /// As that of `ExactSides`.
  int side(const Plane&, int a, int b, int c, int d) const {
    return orient_3d_exactly(points_[a], points_[b], points_[c], points_[d]);
  }

 private:
  const Vector3<double>* points_;
};

// [rounded-sides]
/// Orientation as the scalar rounds it. With an epsilon, points nearer to the plane than that (in
/// m) count as in it. For comparison only: these decisions contradict each other near zero.
template <Scalar S>
class RoundedSides {
 public:
  /// A plane as rounded.
  struct Plane {
    Vector3<S> normal;  ///< a unit vector if there is an epsilon
    Vector3<S> at;      ///< a point of the plane
  };
  /// @param epsilon m; 0 for none
  explicit RoundedSides(const std::vector<Vector3<double>>& points, S epsilon = S(0))
      : epsilon_(epsilon) {
    points_.reserve(points.size());
    for (const Vector3<double>& p : points) points_.push_back(p.template cast<S>());
  }
  /// The plane of three points.
  Plane plane(int a, int b, int c) const {
    const Vector3<S> ab = at(b) - at(a), ac = at(c) - at(a);
    Vector3<S> normal = ab.cross(ac);
    if (epsilon_ > S(0)) {
      const S length = normal.norm();
      if (length > S(0)) normal /= length;
    }
    return {normal, at(a)};
  }
  /// +1 in front, −1 behind, 0 in the plane, as rounded.
  int side(const Plane& plane, int a, int b, int c, int d) const {
    if (d == a || d == b || d == c) return 0;  // rounded, a vertex may be off its own plane
    const S value = plane.normal.dot(at(d) - plane.at);
    return value > epsilon_ ? 1 : (value < -epsilon_ ? -1 : 0);
  }

 private:
  std::vector<Vector3<S>> points_;
  S epsilon_;

  const Vector3<S>& at(int i) const { return points_[static_cast<std::size_t>(i)]; }
};
// [/rounded-sides]

}  // namespace contact
