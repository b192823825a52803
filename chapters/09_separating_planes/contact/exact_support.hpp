/// @file
/// The support function of every kind of body without rounding, and the exact sign of the
/// separation of two bodies along a direction.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>

#include <contact/convex_bodies.hpp>
#include <contact/exact.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/plane.hpp>
#include <contact/ray_box.hpp>
#include <contact/sphere_terms.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Whether the stored numbers describe a body: all finite, at least one vertex, no radius or half
/// length below 0, and the ends of the core of a cylinder differ. What is not a body has no point.
template <ConvexBody Body>
bool is_convex_body(const Body& body) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, OrientedBox<S>> || std::same_as<Body, Ellipsoid<S>>) {
    return all_finite(body.centre) && all_finite(body.axes) && all_finite(body.half_lengths) &&
           body.half_lengths.minCoeff() >= S(0);
  } else if constexpr (std::same_as<Body, Cylinder<S>>) {
    return all_finite(body.core.start) && all_finite(body.core.end) && std::isfinite(body.radius) &&
           body.radius >= S(0) && body.core.start != body.core.end;
  } else if constexpr (std::same_as<Body, Lozenge<S>>) {
    return all_finite(body.corner) && all_finite(body.first_edge) && all_finite(body.second_edge) &&
           std::isfinite(body.radius) && body.radius >= S(0);
  } else {
    const int count = vertex_count(body);
    for (int i = 0; i < count; ++i) {
      if (!all_finite(vertex(body, i))) return false;
    }
    return count > 0 && std::isfinite(radius_of(body)) && radius_of(body) >= S(0);
  }
}

/// The body with its numbers as doubles, which they all are.
template <FloatOrDouble S>
Capsule<double> in_double(const Capsule<S>& body) {
  return {in_double(body.core), body.radius};
}
/// A cylinder in double.
template <FloatOrDouble S>
Cylinder<double> in_double(const Cylinder<S>& body) {
  return {in_double(body.core), body.radius};
}
/// A lozenge in double.
template <FloatOrDouble S>
Lozenge<double> in_double(const Lozenge<S>& body) {
  return {body.corner.template cast<double>(), body.first_edge.template cast<double>(),
          body.second_edge.template cast<double>(), body.radius};
}
/// An ellipsoid in double.
template <FloatOrDouble S>
Ellipsoid<double> in_double(const Ellipsoid<S>& body) {
  return {body.centre.template cast<double>(), body.axes.template cast<double>(),
          body.half_lengths.template cast<double>()};
}
/// A convex hull in double.
template <FloatOrDouble S>
ConvexHull<double> in_double(const ConvexHull<S>& body) {
  ConvexHull<double> hull;
  hull.vertices.reserve(body.vertices.size());
  for (const Vector3<S>& v : body.vertices) hull.vertices.push_back(v.template cast<double>());
  hull.radius = body.radius;
  return hull;
}

// [exact-support]
/// The largest n · x over a body: linear + √squared, with squared ≥ 0.
struct ExactSupport {
  Exact linear;           ///< m, times |n|
  ExactFraction squared;  ///< m², times |n|²
};

/// The support of a body with a core and a radius: that of its farthest vertex, and r |n|.
/// @param body as is_convex_body() requires
/// @param n of any length
template <PolytopeCore Body>
ExactSupport exact_support(const Body& body, const Vector3<Exact>& n) {
  const Exact radius(static_cast<double>(radius_of(body)));
  return {n.dot(exact_vertex(body, exact_support_vertex(body, n))),
          ExactFraction(radius * radius * n.dot(n))};
}
/// That of a cylinder with the core u: the farther end, and r |n × u|/|u| along the cap.
template <FloatOrDouble S>
ExactSupport exact_support(const Cylinder<S>& body, const Vector3<Exact>& n) {
  const Vector3<Exact> start = exact_vector<S>(body.core.start);
  const Vector3<Exact> core = exact_vector<S>(body.core.end) - start;
  const Exact along = n.dot(core);
  const Vector3<Exact> across = n.cross(core);
  const Exact radius(static_cast<double>(body.radius));
  const Exact lowest = n.dot(start);
  return {along.sign() > 0 ? lowest + along : lowest,
          ExactFraction(radius * radius * across.dot(across)) / ExactFraction(core.dot(core))};
}
/// That of an ellipsoid, the image of the unit ball under M: n · centre + |Mᵀn|.
template <FloatOrDouble S>
ExactSupport exact_support(const Ellipsoid<S>& body, const Vector3<Exact>& n) {
  Exact squared;
  for (int i = 0; i < 3; ++i) {
    const Exact along =
        n.dot(exact_vector<S>(body.axes.col(i))) * Exact(static_cast<double>(body.half_lengths(i)));
    squared += along * along;
  }
  return {n.dot(exact_vector<S>(body.centre)), ExactFraction(squared)};
}
// [/exact-support]

namespace detail {

/// Whether all coordinates are 0.
inline bool is_zero(const Vector3<Exact>& v) {
  return v.x().sign() == 0 && v.y().sign() == 0 && v.z().sign() == 0;
}

// [sign-minus-roots]
/// The sign of c − √p − √q, for p, q ≥ 0: by squaring twice.
///
/// For c > 0 it is that of c² − p − q − 2 √(p q), because c + √p + √q > 0; and that is negative if
/// d = c² − p − q is, and otherwise has the sign of d² − 4 p q.
inline int sign_minus_roots(const Exact& c, const ExactFraction& p, const ExactFraction& q) {
  if (c.sign() <= 0) return p.sign() == 0 && q.sign() == 0 ? c.sign() : -1;
  const ExactFraction d = ExactFraction(c * c) - p - q;
  return d.sign() < 0 ? -1 : (d * d - ExactFraction(4) * p * q).sign();
}
// [/sign-minus-roots]

}  // namespace detail

// [exact-separation]
/// The sign of (least n · x over A) − (largest n · x over B), without rounding: positive if a plane
/// perpendicular to n has A strictly in front and B strictly behind, 0 if both touch such a plane
/// from its two sides.
///
/// The least n · x over A is −(the largest −n · x). So the sign is that of c − √p − √q, where c is
/// minus the sum of the linear parts of the two supports and p and q are their squares.
/// @param a, b as is_convex_body() requires
/// @param n of any length; for 0 the result is 0
template <ConvexBody A, ConvexBody B>
int exact_separation_sign(const A& a, const B& b, const Vector3<Exact>& n) {
  const ExactSupport in_front = exact_support(a, Vector3<Exact>(-n));
  const ExactSupport behind = exact_support(b, n);
  return detail::sign_minus_roots(-(in_front.linear + behind.linear), in_front.squared,
                                  behind.squared);
}

/// The same for a half-space B as stored, all x with m · x ≤ k, along its own normal m: the sign of
/// (least m · x over A) − k.
template <ConvexBody A, FloatOrDouble S>
int exact_separation_sign(const A& a, const HalfSpace<S>& b) {
  const ExactSupport below = exact_support(a, Vector3<Exact>(-exact_vector<S>(b.boundary.normal)));
  const Exact offset(static_cast<double>(b.boundary.offset));
  return detail::sign_minus_roots(-(below.linear + offset), below.squared, ExactFraction());
}
// [/exact-separation]

}  // namespace contact
