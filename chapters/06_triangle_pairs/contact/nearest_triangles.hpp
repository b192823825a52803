/// @file
/// The distance of two triangles, by the features that can be nearest: a vertex and a triangle, or
/// two edges.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/exact_fraction.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/triangle_features.hpp>
#include <contact/triangle_intersection.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>

namespace contact {

// [nearest-features]
/// Two points of two triangles that are as close as any, and the smallest features that have them.
template <Scalar S>
struct NearestFeatures {
  S squared_distance = S(0);                    ///< m²
  ContactKind kind = ContactKind::point_point;  ///< of the two features
  Vector3<S> on_first = Vector3<S>::Zero();     ///< m
  Vector3<S> on_second = Vector3<S>::Zero();    ///< m
  Feature of_first{FeatureKind::vertex, 0};     ///< of the first triangle, has on_first
  Feature of_second{FeatureKind::vertex, 0};    ///< of the second triangle, has on_second
};
// [/nearest-features]

namespace nearest_triangles_detail {

/// The vertices of a triangle by their indices.
template <Ring S>
std::array<Vector3<S>, 3> vertices_of(const Triangle<S>& t) {
  return {t.a, t.b, t.c};
}

/// The nearest of the pairs of points that were considered.
template <Scalar S>
class Nearest {
 public:
  Nearest(const std::array<Vector3<S>, 3>& first, const std::array<Vector3<S>, 3>& second)
      : first_(first), second_(second) {}

  /// All pairs of features, in which a nearest pair of points can be: the smallest features first.
  NearestFeatures<S> find() {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) consider({i, at(first_, i)}, {j, at(second_, j)});
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        vertex_edge(first_, i, second_, j, false);
        vertex_edge(second_, i, first_, j, true);
      }
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) edge_edge(i, j);
    }
    for (int i = 0; i < 3; ++i) {
      vertex_face(first_, i, second_, false);
      vertex_face(second_, i, first_, true);
    }
    return nearest_;
  }

 private:
  using Vertices = std::array<Vector3<S>, 3>;
  /// A point of a feature.
  struct On {
    Feature feature;
    Vector3<S> position;

    On(int vertex, const Vector3<S>& x) : feature{FeatureKind::vertex, vertex}, position(x) {}
    On(FeatureKind kind, int index, const Vector3<S>& x) : feature{kind, index}, position(x) {}
  };

  const Vertices& first_;
  const Vertices& second_;
  NearestFeatures<S> nearest_;
  bool any_ = false;

  static const Vector3<S>& at(const Vertices& vertices, int i) {
    return vertices[static_cast<std::size_t>(i % 3)];
  }
  static bool is_inside(const S& part, const S& whole) { return S(0) < part && part < whole; }

  void consider(const On& p, const On& q) {
    const Vector3<S> apart = p.position - q.position;
    const S squared = apart.dot(apart);
    if (any_ && !(squared < nearest_.squared_distance)) return;
    any_ = true;
    nearest_ = {squared,    contact_kind(p.feature.kind, q.feature.kind),
                p.position, q.position,
                p.feature,  q.feature};
  }
  void consider(const On& one, const On& other, bool one_is_second) {
    one_is_second ? consider(other, one) : consider(one, other);
  }

  /// The foot of the perpendicular from a vertex, if it is inside the edge.
  void vertex_edge(const Vertices& one, int vertex, const Vertices& other, int edge,
                   bool one_is_second) {
    const Vector3<S> step = at(other, edge + 1) - at(other, edge);
    const S along = step.dot(Vector3<S>(at(one, vertex) - at(other, edge)));
    const S whole = step.dot(step);
    if (!is_inside(along, whole)) return;
    const Vector3<S> foot = at(other, edge) + step * S(along / whole);
    consider({vertex, at(one, vertex)}, {FeatureKind::edge, edge, foot}, one_is_second);
  }
  /// The ends of the common perpendicular of two lines, if both are inside the edges.
  void edge_edge(int i, int j) {
    const Vector3<S> e = at(first_, i + 1) - at(first_, i), f = at(second_, j + 1) - at(second_, j);
    const Vector3<S> between = at(second_, j) - at(first_, i);
    const Vector3<S> normal = e.cross(f);
    const S whole = normal.dot(normal);
    const S s = normal.dot(Vector3<S>(between.cross(f)));
    const S t = normal.dot(Vector3<S>(between.cross(e)));
    if (!is_inside(s, whole) || !is_inside(t, whole)) return;
    consider({FeatureKind::edge, i, at(first_, i) + e * S(s / whole)},
             {FeatureKind::edge, j, at(second_, j) + f * S(t / whole)});
  }
  /// The foot of the perpendicular from a vertex, if it is inside the triangle.
  void vertex_face(const Vertices& one, int vertex, const Vertices& other, bool one_is_second) {
    const Vector3<S> ab = other[1] - other[0], ac = other[2] - other[0];
    const Vector3<S> normal = ab.cross(ac);
    const S whole = normal.dot(normal);
    const Vector3<S>& x = at(one, vertex);
    if (!(S(0) < whole)) return;
    for (int j = 0; j < 3; ++j) {
      const Vector3<S> edge = at(other, j + 1) - at(other, j);
      if (!(S(0) < normal.dot(Vector3<S>(edge.cross(Vector3<S>(x - at(other, j))))))) return;
    }
    const S above = normal.dot(Vector3<S>(x - other[0]));
    const Vector3<S> foot = x - normal * S(above / whole);
    consider({vertex, x}, {FeatureKind::face, 0, foot}, one_is_second);
  }
};

/// The exponent of the largest coordinate: divided by two to it, all are below 2.
inline int common_exponent(const Triangle<double>& s, const Triangle<double>& t) {
  double largest = 0;
  for (const auto& v : {s.a, s.b, s.c, t.a, t.b, t.c}) {
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
  }
  return largest > 0 ? std::ilogb(largest) : 0;
}
inline Vector3<double> scaled(const Vector3<double>& v, int exponent) {
  return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent)};
}
inline std::array<Vector3<double>, 3> scaled(const Triangle<double>& t, int exponent) {
  return {scaled(t.a, exponent), scaled(t.b, exponent), scaled(t.c, exponent)};
}

/// A triangle in fractions.
inline Triangle<ExactFraction> in_fractions(const Triangle<double>& t) {
  const auto exact = [](const Vector3<double>& v) {
    return Vector3<ExactFraction>(ExactFraction(v.x()), ExactFraction(v.y()), ExactFraction(v.z()));
  };
  return {exact(t.a), exact(t.b), exact(t.c)};
}

}  // namespace nearest_triangles_detail

/// The nearest points of two triangles that have no common point, in the arithmetic of S: the least
/// of the distances of 6 vertices from a triangle and of 9 pairs of edges, of features with their
/// borders.
///
/// Exact if S is an exact field; of several nearest pairs one. Rounded, a pair may be preferred
/// that is as close up to rounding. If the triangles cross, the distance is not 0: an edge may pass
/// through a face far from both borders. If S is exact, a triangle without area is the segment or
/// the point that it is. NaN, ∞ and overflow: no meaning; the distance may be finite nevertheless.
// [nearest-apart]
template <Scalar S>
NearestFeatures<S> nearest_of_apart_triangles(const Triangle<S>& first, const Triangle<S>& second) {
  const auto a = nearest_triangles_detail::vertices_of(first);
  const auto b = nearest_triangles_detail::vertices_of(second);
  return nearest_triangles_detail::Nearest<S>(a, b).find();
}
// [/nearest-apart]

/// The distance of two triangles and two points that have it.
///
/// Whether they meet is decided without error. If they do, the distance is 0 and the point is the
/// first that `intersect_triangles` finds; its features may be an edge and a face. If not, kind and
/// features are never edge_face or face_face. They are computed in double and rounded to S, without
/// a bound, and of pairs of features that are as close up to rounding any may be found. For thin
/// triangles the distance and the positions can be wrong by much, and the distance too small; of
/// nearly parallel edges the positions. `nearest_of_triangles_exactly` has no such limits. A
/// squared distance beyond the number range is ∞ or 0. Triangles without area are segments or
/// points.
/// @param first m
/// @param second m
/// @return NaN as the squared distance if a coordinate is not finite
template <FloatOrDouble S>
NearestFeatures<S> nearest_of_triangles(const Triangle<S>& first, const Triangle<S>& second) {
  using namespace nearest_triangles_detail;
  NearestFeatures<S> found;
  if (!triangle_intersection_detail::finite_triangle(first) ||
      !triangle_intersection_detail::finite_triangle(second)) {
    found.squared_distance = std::numeric_limits<S>::quiet_NaN();
    return found;
  }
  const TriangleIntersection<S> common = intersect_triangles(first, second);
  if (common.count > 0) {
    const CommonPoint<S>& p = common.points[0];
    const ContactKind kind = contact_kind(p.of_first.kind, p.of_second.kind);
    return {S(0), kind, p.position, p.position, p.of_first, p.of_second};
  }
  const Triangle<double> a = in_double(first), b = in_double(second);
  const int exponent = common_exponent(a, b);
  const auto a_scaled = scaled(a, -exponent), b_scaled = scaled(b, -exponent);
  const NearestFeatures<double> near = Nearest<double>(a_scaled, b_scaled).find();
  found.squared_distance = static_cast<S>(std::ldexp(near.squared_distance, 2 * exponent));
  found.kind = near.kind;
  found.on_first = scaled(near.on_first, exponent).template cast<S>();
  found.on_second = scaled(near.on_second, exponent).template cast<S>();
  found.of_first = near.of_first;
  found.of_second = near.of_second;
  return found;
}

/// The same in fractions, for finite triangles: exact distance, kind and features. Slow. Where the
/// triangles meet, the position is that of `intersect_triangles`, rounded. A coordinate that is not
/// finite is an error of the program, and asserts.
template <FloatOrDouble S>
NearestFeatures<ExactFraction> nearest_of_triangles_exactly(const Triangle<S>& first,
                                                            const Triangle<S>& second) {
  using nearest_triangles_detail::in_fractions;
  const NearestFeatures<S> rounded = nearest_of_triangles(first, second);
  if (common_points(first, second) == CommonPoints::none) {
    return nearest_of_apart_triangles<ExactFraction>(in_fractions(in_double(first)),
                                                     in_fractions(in_double(second)));
  }
  NearestFeatures<ExactFraction> found;
  found.kind = rounded.kind;
  found.of_first = rounded.of_first;
  found.of_second = rounded.of_second;
  for (int k = 0; k < 3; ++k) {
    found.on_first[k] = ExactFraction(static_cast<double>(rounded.on_first[k]));
    found.on_second[k] = found.on_first[k];
  }
  return found;
}

}  // namespace contact
