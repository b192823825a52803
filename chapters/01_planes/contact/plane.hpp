/// @file
/// Planes: three ways to make one; the side and the signed distance of a point.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/shapes.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The side of a plane on which a point is; the normal points to the front.
enum class Side { back = -1, on = 0, front = 1 };

/// A plane normal · x = offset whose normal has any length but zero: what three points give without
/// a square root.
///
/// Nothing is rounded if S is exact, so signs computed from it are exact. Distances are multiplied
/// by the length of the normal.
template <Ring S>
struct RawPlane {
  Vector3<S> normal = Vector3<S>::Zero();  ///< m² if made from three points in m
  S offset = S(0);                         ///< m³ if made from three points in m
};

/// The raw plane through three points: N = (b − a) × (c − a), K = N · a. Seen from its front, a, b,
/// c are counter-clockwise. Collinear points give N = 0. In a floating-point type, large or tiny
/// coordinates overflow or underflow.
/// @param a, b, c points, m
/// @see *Interaction and Normals*, slide "Triangle vs. Triangle"
template <Ring S>
RawPlane<S> raw_plane_from_points(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c) {
  const Vector3<S> edge_ab = b - a;
  const Vector3<S> edge_ac = c - a;
  const Vector3<S> normal = edge_ab.cross(edge_ac);
  return {normal, normal.dot(a)};
}

/// A point's coordinates as exact numbers. They must be finite; float or double.
template <std::floating_point S>
Vector3<Exact> exact_vector(const Vector3<S>& v) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  return {Exact(double(v.x())), Exact(double(v.y())), Exact(double(v.z()))};
}

namespace detail {

/// The exponent e with 2^e ≤ the largest |entry| of v < 2^(e+1), for a finite v other than 0.
template <std::floating_point S>
int binary_exponent(const Vector3<S>& v) {
  return std::ilogb(std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())}));
}

/// v times 2^power: exact, except for entries that become negligible beside the largest.
template <std::floating_point S>
Vector3<S> times_power_of_two(const Vector3<S>& v, int power) {
  return {std::ldexp(v.x(), power), std::ldexp(v.y(), power), std::ldexp(v.z(), power)};
}

/// (b − a) × (c − a) with each edge scaled by a power of two, its largest entry in [1, 2): only the
/// direction matters.
template <std::floating_point S>
Vector3<S> cross_of_edges(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c) {
  Vector3<S> edge_ab = b - a;
  Vector3<S> edge_ac = c - a;
  if (!all_finite(edge_ab)) edge_ab = b / S(2) - a / S(2);  // on opposite ends of the number range
  if (!all_finite(edge_ac)) edge_ac = c / S(2) - a / S(2);
  const Vector3<S> zero = Vector3<S>::Zero();
  if (edge_ab == zero || edge_ac == zero) return zero;
  return times_power_of_two(edge_ab, -binary_exponent(edge_ab))
      .cross(times_power_of_two(edge_ac, -binary_exponent(edge_ac)));
}

/// The same, computed exactly and rounded once; its largest entry is ±1. Zero only for collinear
/// points.
template <std::floating_point S>
Vector3<S> exact_cross_of_edges(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c,
                                const Vector3<S>& rounded) {
  if constexpr (std::numeric_limits<S>::digits > 53) {
    return rounded;
  } else {
    const Vector3<Exact> n =
        raw_plane_from_points(exact_vector(a), exact_vector(b), exact_vector(c)).normal;
    const Exact largest = std::max({abs(n.x()), abs(n.y()), abs(n.z())});
    if (largest.sign() == 0) return Vector3<S>::Zero();
    return {quotient<S>(n.x(), largest), quotient<S>(n.y(), largest), quotient<S>(n.z(), largest)};
  }
}

}  // namespace detail

/// The unit vector in the direction of v.
///
/// The largest coordinate is first scaled to near 1 by a power of two, which is exact. So the
/// squares in the length neither overflow (v near 1e200) nor underflow (v near 1e-200). Every entry
/// of the result has a relative error of at most 4 u (u: unit roundoff), or an error of at most the
/// smallest positive number.
/// @param v any finite vector but 0
/// @throws std::invalid_argument if v is 0 or not finite
// [normalised]
template <std::floating_point S>
Vector3<S> normalised(const Vector3<S>& v) {
  require_finite("normal", v);
  if (v == Vector3<S>::Zero()) {
    throw_invalid_argument("normal", vector_text(v), "the zero vector has no direction");
  }
  const Vector3<S> near_one = detail::times_power_of_two(v, -detail::binary_exponent(v));
  return near_one / std::sqrt(near_one.dot(near_one));
}
// [/normalised]

/// The plane through a point, facing along a normal.
/// @param normal any finite vector but 0; it is normalised here
/// @param point a point of the plane, m
/// @throws std::invalid_argument if normal is 0, if an argument is not finite, or if the sum that
/// gives the offset overflows
/// @note The offset is rounded: the stored plane misses the point by up to 4 u |point|, which is
/// large far from the origin; see signed_distance_from_point().
/// @see *Interaction and Normals*, slides "Collision detection: point-plane" and "Sphere-Plane
/// Intersection"
// [from-normal-and-point]
template <std::floating_point S>
Plane<S> plane_from_normal_and_point(const Vector3<S>& normal, const Vector3<S>& point) {
  require_finite("point", point);
  const Vector3<S> unit = normalised(normal);
  const S offset = unit.dot(point);
  if (!is_finite(offset)) {
    throw_invalid_argument("point", vector_text(point), "the plane's offset overflows");
  }
  return {unit, offset};
}
// [/from-normal-and-point]

// [from-coefficients]
/// The plane of all (x, y, z) with a x + b y + c z + d = 0, facing along (a, b, c).
///
/// d is on the left of the equation, so the offset is −d over the length of (a, b, c).
/// @param a, b, c, d finite; a, b and c not all 0
/// @throws std::invalid_argument if a, b and c are all 0, if one of the four is not finite, or if
/// the offset overflows
/// @see *Interaction and Normals*, slide "Collision detection: point-plane", E(p) = ax + by + cz +
/// d
template <std::floating_point S>
Plane<S> plane_from_coefficients(S a, S b, S c, S d) {
  const Vector3<S> normal(a, b, c);
  require_finite("d", d);
  const Vector3<S> unit = normalised(normal);
  const int exponent = detail::binary_exponent(normal);
  const Vector3<S> near_one = detail::times_power_of_two(normal, -exponent);
  const S offset = std::ldexp(-d / std::sqrt(near_one.dot(near_one)), -exponent);
  if (!is_finite(offset))
    throw_invalid_argument("d", number_text(d), "the plane's offset overflows");
  return {unit, offset};
}
// [/from-coefficients]

// [from-points]
/// The plane through three points; seen from its front, a, b, c are counter-clockwise.
///
/// If the edges at a are far from parallel, rounded arithmetic is accurate enough. If not, the
/// cross product is computed again exactly: a thin triangle gets as accurate a normal as any other,
/// and points are called collinear if and only if they are so as stored. (In long double, for which
/// there is no exact arithmetic here, only the first.)
/// @param a, b, c finite points that are not on one line, m
/// @throws std::invalid_argument if a point is not finite, if the points are collinear, or if the
/// offset overflows
/// @note In float and double the normal's direction is off by less than 256 u. The offset is
/// rounded as in plane_from_normal_and_point().
/// @see *Interaction and Normals*, slide "The Plane Containing the Triangle"
template <std::floating_point S>
Plane<S> plane_from_points(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c) {
  require_finite("a", a);
  require_finite("b", b);
  require_finite("c", c);
  Vector3<S> normal = detail::cross_of_edges(a, b, c);
  // Entries of the scaled edges are below 2. Differences, products and their difference are four
  // successive roundings, so an entry of the normal is off by at most 4 u × (4 + 4), the vector by
  // 32 √3 u: 222 u of a length of 1/4.
  const bool thin = normal.cwiseAbs().maxCoeff() < S(0.25);
  if (thin) normal = detail::exact_cross_of_edges(a, b, c, normal);
  if (normal == Vector3<S>::Zero()) {
    throw_invalid_argument("a, b, c",
                           vector_text(a) + ", " + vector_text(b) + ", " + vector_text(c),
                           "the points lie on one line");
  }
  return plane_from_normal_and_point(normal, a);
}
// [/from-points]

/// The signed distance of x from the plane, E(x) = normal · x − offset: positive in front, negative
/// behind, 0 on it.
///
/// Total: for finite input the result is finite, or ±∞ if the true distance is beyond the largest
/// number.
/// @param plane with a unit normal
/// @param x a point, m
/// @return m; off by at most signed_distance_error(plane, x)
/// @see *Interaction and Normals*, slide "Collision detection: point-plane"
// [signed-distance]
template <Ring S>
S signed_distance(const Plane<S>& plane, const Vector3<S>& x) {
  const S distance = plane.normal.dot(x) - plane.offset;
  if constexpr (std::floating_point<S>) {
    // A partial sum may overflow though the distance does not: add eighths instead.
    if (!std::isfinite(distance)) {
      return S(8) * (plane.normal.dot(Vector3<S>(x / S(8))) - plane.offset / S(8));
    }
  }
  return distance;
}
// [/signed-distance]

// [distance-error]
/// A bound on the rounding error of signed_distance(plane, x), for the plane as it is stored.
///
/// The product of each coordinate goes through at most four roundings (×, two +, −), so the error
/// is at most γ(4) (Σ|nᵢ xᵢ| + |k|), plus 3 η / 2 for products that underflow. The bound is itself
/// computed with at most six roundings, so γ(11) replaces γ(4), and 2 η replaces 3 η / 2.
/// @return m, never NaN for finite input; ∞ if the sum of absolute values overflows
template <std::floating_point S>
S signed_distance_error(const Plane<S>& plane, const Vector3<S>& x) {
  const S size = plane.normal.cwiseAbs().dot(x.cwiseAbs()) + std::abs(plane.offset);
  return tolerance::gamma<S>(11) * size + S(2) * tolerance::underflow_unit<S>;
}
// [/distance-error]

// [distance-from-point]
/// The signed distance of x from the plane through a point: normal · (x − point).
///
/// The difference is taken first. When x and the point are near each other and far from the origin,
/// their difference is exact or nearly so, and the error is a few u |x − point|. In
/// signed_distance() it is a few u |x|.
/// @param normal unit vector
/// @param point a point of the plane, m
/// @param x a point, m
template <Ring S>
S signed_distance_from_point(const Vector3<S>& normal, const Vector3<S>& point,
                             const Vector3<S>& x) {
  return normal.dot(Vector3<S>(x - point));
}
// [/distance-from-point]

/// The sign of a number as a side: front if positive, back if negative, on if zero.
template <Ring S>
Side side_of_value(const S& value) {
  if (value > S(0)) return Side::front;
  if (value < S(0)) return Side::back;
  return Side::on;
}

// [side]
/// The side of the plane on which x is, by the sign of the computed signed distance.
///
/// In a floating-point type it can be wrong if |distance| is at most signed_distance_error(plane,
/// x); in an exact type it is right.
template <Ring S>
Side side(const Plane<S>& plane, const Vector3<S>& x) {
  return side_of_value(signed_distance(plane, x));
}
// [/side]

/// The side of a raw plane on which x is: the sign of N · x − K.
template <Ring S>
Side side(const RawPlane<S>& plane, const Vector3<S>& x) {
  return side_of_value(S(plane.normal.dot(x) - plane.offset));
}

/// The side of the plane through a, b and c on which x is: the orientation predicate of four
/// points, exact for all finite coordinates, without a tolerance. Collinear a, b, c give Side::on.
// [exact-points]
template <std::floating_point S>
Side side_of_points_exactly(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c,
                            const Vector3<S>& x) {
  return side(raw_plane_from_points(exact_vector(a), exact_vector(b), exact_vector(c)),
              exact_vector(x));
}
// [/exact-points]

/// The same plane with the normal reversed.
template <Ring S>
Plane<S> flipped(const Plane<S>& plane) {
  return {-plane.normal, -plane.offset};
}

}  // namespace contact
