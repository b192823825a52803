/// @file
/// Convex bodies as *core and radius*: the vertices of a core, and its point farthest along a
/// direction (support function).
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <contact/capsule.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/exact.hpp>
#include <contact/oriented_box.hpp>
#include <contact/plane.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// What is known of a kind of body.
template <class Body>
struct BodyKind {
  static constexpr bool has_vertices = false;
  static constexpr bool is_smooth = false;
};
template <class S>
struct HasVertices {
  using Scalar = S;
  static constexpr bool has_vertices = true;
  static constexpr bool is_smooth = false;
};
template <class S>
struct IsSmooth {
  using Scalar = S;
  static constexpr bool has_vertices = false;
  static constexpr bool is_smooth = true;
};
template <Ring S>
struct BodyKind<Sphere<S>> : HasVertices<S> {};
template <Ring S>
struct BodyKind<Capsule<S>> : HasVertices<S> {};
template <Ring S>
struct BodyKind<Lozenge<S>> : HasVertices<S> {};
template <Ring S>
struct BodyKind<OrientedBox<S>> : HasVertices<S> {};
template <Ring S>
struct BodyKind<Triangle<S>> : HasVertices<S> {};
template <Ring S>
struct BodyKind<ConvexHull<S>> : HasVertices<S> {};
template <Ring S>
struct BodyKind<Cylinder<S>> : IsSmooth<S> {};
template <Ring S>
struct BodyKind<Ellipsoid<S>> : IsSmooth<S> {};

/// x · y, written out: compilers often call Eigen's as a function.
template <Ring S>
S dot3(const Vector3<S>& x, const Vector3<S>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// A direction of a body's scalar, to which an expression is converted.
template <class S>
using Direction = std::type_identity_t<Vector3<S>>;

}  // namespace detail

// [kinds-of-body]
/// A body that is a *core and a radius*: all points at most the radius from a polytope, the core.
///
/// | body | core | vertices | radius |
/// |---|---|---|---|
/// | Sphere | its centre | 1 | its own |
/// | Capsule | a segment | 2 | its own |
/// | Lozenge | a parallelogram | 4 | its own |
/// | OrientedBox | itself | 8 | 0 |
/// | Triangle | itself | 3 | 0 |
/// | ConvexHull | a polytope | n | its own, or 0 |
template <class Body>
concept PolytopeCore = detail::BodyKind<Body>::has_vertices;
// [/kinds-of-body]

// [smooth-body]
/// A body with a curved surface that is no core and radius: a cylinder or an ellipsoid.
template <class Body>
concept SmoothBody = detail::BodyKind<Body>::is_smooth;
// [/smooth-body]

// [convex-body]
/// A bounded convex body of any kind.
template <class Body>
concept ConvexBody = PolytopeCore<Body> || SmoothBody<Body>;
// [/convex-body]

/// The number type of a body.
template <ConvexBody Body>
using ScalarOf = typename detail::BodyKind<Body>::Scalar;

// [radius-of]
/// The radius by which the body exceeds its core, m; 0 for a body that is its own core, as smooth
/// ones are.
template <ConvexBody Body>
ScalarOf<Body> radius_of(const Body& body) {
  if constexpr (PolytopeCore<Body> && requires { body.radius; }) {
    return body.radius;
  } else {
    return ScalarOf<Body>(0);
  }
}
// [/radius-of]

/// The number of vertices of the core.
template <PolytopeCore Body>
int vertex_count(const Body& body) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, Sphere<S>>) return 1;
  if constexpr (std::same_as<Body, Capsule<S>>) return 2;
  if constexpr (std::same_as<Body, Triangle<S>>) return 3;
  if constexpr (std::same_as<Body, Lozenge<S>>) return 4;
  if constexpr (std::same_as<Body, OrientedBox<S>>) return 8;
  if constexpr (std::same_as<Body, ConvexHull<S>>) return static_cast<int>(body.vertices.size());
}

// [vertex]
/// Vertex i of the core, from 0 to vertex_count() − 1, m. Of a capsule 0 is the start; of a
/// triangle a, b and c; of a lozenge bit 0 of i adds the first edge and bit 1 the second; of a box
/// as box_corner().
///
/// With a floating-point type that of a lozenge is rounded twice, and that of a box as box_corner()
/// says; all others are stored numbers.
template <Ring S>
const Vector3<S>& vertex(const Sphere<S>& body, int) {
  return body.centre;
}
/// Vertex i of a capsule.
template <Ring S>
const Vector3<S>& vertex(const Capsule<S>& body, int i) {
  return i == 0 ? body.core.start : body.core.end;
}
/// Vertex i of a triangle.
template <Ring S>
const Vector3<S>& vertex(const Triangle<S>& body, int i) {
  return i == 0 ? body.a : (i == 1 ? body.b : body.c);
}
/// Vertex i of a convex hull.
template <Ring S>
const Vector3<S>& vertex(const ConvexHull<S>& body, int i) {
  return body.vertices[static_cast<std::size_t>(i)];
}
/// Vertex i of a lozenge.
template <Ring S>
Vector3<S> vertex(const Lozenge<S>& body, int i) {
  Vector3<S> corner = body.corner;
  if ((i & 1) != 0) corner = corner + body.first_edge;
  if ((i & 2) != 0) corner = corner + body.second_edge;
  return corner;
}
/// Vertex i of a box.
template <Ring S>
Vector3<S> vertex(const OrientedBox<S>& body, int i) {
  return box_corner(body, i);
}
// [/vertex]

namespace detail {

/// The body with its stored numbers as exact ones.
template <FloatOrDouble S>
OrientedBox<Exact> exact_body(const OrientedBox<S>& box) {
  OrientedBox<Exact> exact{exact_vector<S>(box.centre), Matrix3<Exact>(),
                           exact_vector<S>(box.half_lengths)};
  for (int i = 0; i < 3; ++i) exact.axes.col(i) = exact_vector<S>(box.axes.col(i));
  return exact;
}
template <FloatOrDouble S>
Lozenge<Exact> exact_body(const Lozenge<S>& body) {
  return {exact_vector<S>(body.corner), exact_vector<S>(body.first_edge),
          exact_vector<S>(body.second_edge), Exact(static_cast<double>(body.radius))};
}

}  // namespace detail

/// Vertex i of the core as vertex(), without rounding: that of the body of the stored numbers.
/// @param body finite
template <PolytopeCore Body>
Vector3<Exact> exact_vertex(const Body& body, int i) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, OrientedBox<S>> || std::same_as<Body, Lozenge<S>>) {
    return vertex(detail::exact_body(body), i);
  } else {
    return exact_vector<S>(vertex(body, i));
  }
}

// [support-vertex]
/// The index of a vertex of the core that is farthest along n: of those with the largest computed
/// n · v the first one.
///
/// Edges and axes decide for a capsule, a lozenge and a box, so that their position does not round
/// the comparison. Up to rounding the vertex is the farthest: no other exceeds n · v by more than
/// γ(4) of the absolute terms of what is compared. With an exact type it is the farthest.
/// The direction has any length; for 0, or NaN, the answer is vertex 0.
template <Ring S>
int support_vertex(const Sphere<S>&, const detail::Direction<S>&) {
  return 0;
}
/// The same of a capsule.
template <Ring S>
int support_vertex(const Capsule<S>& body, const detail::Direction<S>& n) {
  return S(0) < detail::dot3<S>(n, body.core.end - body.core.start) ? 1 : 0;
}
/// The same of a triangle.
template <Ring S>
int support_vertex(const Triangle<S>& body, const detail::Direction<S>& n) {
  const S ab = detail::dot3<S>(n, body.b - body.a), ac = detail::dot3<S>(n, body.c - body.a);
  if (ab < ac) return S(0) < ac ? 2 : 0;
  return S(0) < ab ? 1 : 0;
}
/// The same of a lozenge.
template <Ring S>
int support_vertex(const Lozenge<S>& body, const detail::Direction<S>& n) {
  return (S(0) < detail::dot3<S>(n, body.first_edge) ? 1 : 0) |
         (S(0) < detail::dot3<S>(n, body.second_edge) ? 2 : 0);
}
/// The same of a box.
template <Ring S>
int support_vertex(const OrientedBox<S>& body, const detail::Direction<S>& n) {
  int corner = 0;
  for (int i = 0; i < 3; ++i) {
    if (S(0) < detail::dot3<S>(n, body.axes.col(i))) corner |= 1 << i;
  }
  return corner;
}
/// The same of a convex hull.
template <Ring S>
int support_vertex(const ConvexHull<S>& body, const detail::Direction<S>& n) {
  int farthest = 0;
  S most = detail::dot3<S>(n, body.vertices[0]);
  const int count = vertex_count(body);
  for (int i = 1; i < count; ++i) {
    const S along = detail::dot3<S>(n, body.vertices[static_cast<std::size_t>(i)]);
    if (most < along) {
      most = along;
      farthest = i;
    }
  }
  return farthest;
}
// [/support-vertex]

/// The index of a vertex of the core that is farthest along an exact direction, without rounding:
/// of equal ones the first of a hull or a triangle; of a box or lozenge that without the axes or
/// edges that are perpendicular to n.
/// @param body finite
template <PolytopeCore Body>
int exact_support_vertex(const Body& body, const Vector3<Exact>& n) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, OrientedBox<S>> || std::same_as<Body, Lozenge<S>>) {
    return support_vertex(detail::exact_body(body), n);
  } else {
    int farthest = 0;
    Exact most = n.dot(exact_vertex(body, 0));
    for (int i = 1; i < vertex_count(body); ++i) {
      const Exact along = n.dot(exact_vertex(body, i));
      if (most < along) {
        most = along;
        farthest = i;
      }
    }
    return farthest;
  }
}

namespace detail {

/// v divided by its length, for entries of any size; 0 for 0.
template <std::floating_point S>
Vector3<S> unit_of_any_size(const Vector3<S>& v) {
  const S squared = v.dot(v);
  constexpr S least = std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
  if (squared > least && squared < std::numeric_limits<S>::max()) return v / std::sqrt(squared);
  const S largest = v.cwiseAbs().maxCoeff();
  if (!(largest > S(0))) return Vector3<S>::Zero();
  int power = 0;
  std::frexp(largest, &power);
  const Vector3<S> near_one(std::ldexp(v.x(), -power), std::ldexp(v.y(), -power),
                            std::ldexp(v.z(), -power));
  return near_one / std::sqrt(near_one.dot(near_one));
}

}  // namespace detail

// [support]
/// A point of the core that is farthest along n, or for a smooth body of the body. With the radius
/// along n/|n| it is the support of the whole body.
/// @param n of any length; for 0 some point of the core
/// @return m; a vertex of the core, or rounded: off by a few u of the coordinates of the body
template <PolytopeCore Body>
Vector3<ScalarOf<Body>> support(const Body& body, const detail::Direction<ScalarOf<Body>>& n) {
  return vertex(body, support_vertex(body, n));
}
/// That of a cylinder is on the rim of a cap: the component of n perpendicular to the core gives
/// the direction from its centre. Along the core, the centre of the cap.
template <FloatOrDouble S>
Vector3<S> support(const Cylinder<S>& body, const detail::Direction<S>& n) {
  const Vector3<S> axis = detail::unit_of_any_size<S>(Vector3<S>(body.core.end - body.core.start));
  const Vector3<S> unit = detail::unit_of_any_size<S>(n);
  const S along = axis.dot(unit);
  // Twice, because rounding leaves a component along the core; what is left below 4 u is rounding.
  Vector3<S> across = unit - axis * along;
  across -= axis * axis.dot(across);
  constexpr S least = S(2) * std::numeric_limits<S>::epsilon();
  if (across.dot(across) <= least * least) across = Vector3<S>::Zero();
  return (along > S(0) ? body.core.end : body.core.start) +
         detail::unit_of_any_size<S>(across) * body.radius;
}
/// That of an ellipsoid, the image of the unit ball under M: centre + M (Mᵀn)/|Mᵀn|.
template <FloatOrDouble S>
Vector3<S> support(const Ellipsoid<S>& body, const detail::Direction<S>& n) {
  const Vector3<S> unit = detail::unit_of_any_size<S>(n);
  const Vector3<S> turned = Vector3<S>(body.axes.transpose() * unit);
  const Vector3<S> on_ball =
      detail::unit_of_any_size<S>(Vector3<S>(turned.cwiseProduct(body.half_lengths)));
  return body.centre + body.axes * Vector3<S>(on_ball.cwiseProduct(body.half_lengths));
}
// [/support]

// [inner-point]
/// A point of the core, rounded: its centre, or the mean of its vertices. Up to rounding it is in
/// the interior if the body has one.
/// @return m; off by a few u of the largest coordinate, times the number of vertices of a hull
template <PolytopeCore Body>
Vector3<ScalarOf<Body>> inner_point(const Body& body) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, Sphere<S>> || std::same_as<Body, OrientedBox<S>>) {
    return body.centre;
  } else {
    const int count = vertex_count(body);
    Vector3<S> mean = Vector3<S>::Zero();
    for (int i = 0; i < count; ++i) mean += Vector3<S>(vertex(body, i)) / S(count);
    return mean;
  }
}
/// An inner point of a cylinder.
template <FloatOrDouble S>
Vector3<S> inner_point(const Cylinder<S>& body) {
  return body.core.start / S(2) + body.core.end / S(2);
}
/// An inner point of an ellipsoid.
template <FloatOrDouble S>
Vector3<S> inner_point(const Ellipsoid<S>& body) {
  return body.centre;
}
// [/inner-point]

}  // namespace contact
