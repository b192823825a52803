/// @file
/// A signed distance with its direction and points, and what all pairs of bodies need to find it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>

#include <contact/exact_gjk.hpp>
#include <contact/exact_support.hpp>
#include <contact/gjk.hpp>
#include <contact/plane.hpp>
#include <contact/support.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [signed-distance]
/// The signed distance of two bodies A and B.
///
/// on_a − on_b = distance normal, up to rounding. For separated bodies these are two closest
/// points. For overlapping bodies, a translation of A by −distance along the normal is the shortest
/// one that separates them.
template <Ring S>
struct SignedDistance {
  S distance = S(0);                       ///< m; negative: minus the penetration depth
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  Vector3<S> on_a = Vector3<S>::Zero();    ///< on the surface of A, m
  Vector3<S> on_b = Vector3<S>::Zero();    ///< on the surface of B, m
};
// [/signed-distance]

/// The same with the two bodies exchanged. A coordinate 0 of the normal stays 0 and does not become
/// −0.
template <Ring S>
SignedDistance<S> exchanged(const SignedDistance<S>& found) {
  return {found.distance, Vector3<S>(Vector3<S>::Zero() - found.normal), found.on_b, found.on_a};
}

namespace detail {

/// The same numbers, with 0 for −0.
template <std::floating_point S>
SignedDistance<S> without_negative_zero(const SignedDistance<S>& found) {
  const Vector3<S> zero = Vector3<S>::Zero();
  return {found.distance + S(0), Vector3<S>(found.normal + zero), Vector3<S>(found.on_a + zero),
          Vector3<S>(found.on_b + zero)};
}

/// A unit vector perpendicular to d, always the same for the same d: perpendicular to the
/// coordinate axis along which d is smallest. For d = 0, the z axis.
template <std::floating_point S>
Vector3<S> perpendicular_to(const Vector3<S>& d) {
  if (d == Vector3<S>::Zero()) return Vector3<S>::UnitZ();
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(d(i)) < std::abs(d(least))) least = i;
  }
  Vector3<S> axis = Vector3<S>::Zero();
  axis(least) = S(1);
  return normalised<S>(Vector3<S>(d.cross(axis)));
}

/// The signed distance of two bodies from the closest points of their cores, along a unit normal:
/// each surface is at a distance of its radius from its core.
template <std::floating_point S>
SignedDistance<S> signed_distance_of_cores(const Vector3<S>& on_a, const S& radius_a,
                                           const Vector3<S>& on_b, const S& radius_b,
                                           const S& distance, const Vector3<S>& normal) {
  return {distance - (radius_a + radius_b), normal, Vector3<S>(on_a - normal * radius_a),
          Vector3<S>(on_b + normal * radius_b)};
}

template <std::floating_point S>
S length(const Vector3<S>& v) {
  return std::sqrt(v.dot(v));
}

/// At least the error of a computed distance of two bodies with such coordinates: two closest
/// points that are nearer to each other may as well be common points.
template <std::floating_point S>
S distance_error(const S& largest_coordinate) {
  return S(32) * std::numeric_limits<S>::epsilon() * largest_coordinate;
}

// [near]
/// Whether the difference of two computed closest points is too short to give a direction.
///
/// Its error is some u of the largest coordinate, so the direction is off by that divided by the
/// distance. Above 2^-22 of the coordinates (float: 2^-10) that is below 2^-26 (float: 2^-10), and
/// a translation along such a direction separates as well up to the square of it, which is of the
/// order of u. Below, core_direction() gives the direction.
template <std::floating_point S>
bool is_near(const S& distance, const S& largest_coordinate) {
  constexpr S root = std::numeric_limits<S>::digits <= 24 ? S(0x1p-10) : S(0x1p-22);
  return !(distance > root * largest_coordinate);
}
// [/near]

/// The largest magnitude of a coordinate.
template <std::floating_point S>
S largest_coordinate(const Vector3<S>& p, const Vector3<S>& q) {
  return std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff());
}

/// The distance of two cores and its direction.
template <std::floating_point S>
struct CoreDirection {
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A; 0: the cores meet
  S distance = S(0);                       ///< m
};

// [core-direction]
/// The distance and direction of two cores, exact but for the last rounding, however close they
/// are: of the stored bodies, whose vertices are not rounded.
template <PolytopeCore A, PolytopeCore B>
CoreDirection<ScalarOf<A>> core_direction(const A& a, const B& b) {
  using S = ScalarOf<A>;
  const auto first = in_double(a);
  const auto second = in_double(b);
  const GjkResult<double> rounded = gjk(first, second);
  std::array<DifferenceIndex, 4> start;
  for (std::size_t i = 0; i < 4; ++i) start[i] = {rounded.simplex[i].a, rounded.simplex[i].b};
  const auto known = static_cast<std::size_t>(rounded.count);
  const ExactClosest exact = exact_gjk(first, second, std::span(start).first(known));
  const Vector3<double> direction = rounded_direction(exact.direction);
  if (direction == Vector3<double>::Zero()) return {};
  const Exact scale =
      std::max({abs(exact.direction.x()), abs(exact.direction.y()), abs(exact.direction.z())});
  const double distance = quotient<double>(exact.offset, scale) / length(direction);
  return {Vector3<S>(normalised<double>(direction).template cast<S>()), static_cast<S>(distance)};
}
// [/core-direction]

/// The power of two by which bodies with coordinates of up to `size` are divided before they are
/// measured, so that no product of lengths over- or underflows; 0 for bodies of an ordinary size.
template <FloatOrDouble S>
int scale_power(const S& size) {
  constexpr int limit = std::same_as<S, float> ? 20 : 200;
  int power = 0;
  std::frexp(size, &power);
  return power < -limit || power > limit ? power : 0;
}

/// −1, 0 or 1: which of two bodies of one kind comes first in the order of their stored numbers.
template <std::floating_point S>
int order_of(const S& x, const S& y) {
  return x < y ? -1 : (y < x ? 1 : 0);
}
template <std::floating_point S>
int order_of(const Vector3<S>& x, const Vector3<S>& y) {
  for (int i = 0; i < 3; ++i) {
    const int order = order_of(S(x(i)), S(y(i)));
    if (order != 0) return order;
  }
  return 0;
}
template <std::floating_point S>
int order_of(const Matrix3<S>& x, const Matrix3<S>& y) {
  for (int i = 0; i < 3; ++i) {
    const int order = order_of(Vector3<S>(x.col(i)), Vector3<S>(y.col(i)));
    if (order != 0) return order;
  }
  return 0;
}
template <std::floating_point S>
int order_of(const Segment<S>& x, const Segment<S>& y) {
  const int order = order_of(x.start, y.start);
  return order != 0 ? order : order_of(x.end, y.end);
}
template <class T, class... Rest>
int order_of_all(const T& x, const T& y, const Rest&... rest) {
  const int order = order_of(x, y);
  if constexpr (sizeof...(rest) > 0) {
    return order != 0 ? order : order_of_all(rest...);
  } else {
    return order;
  }
}

/// Whether the stored numbers of a are before those of b.
template <ConvexBody Body>
bool precedes(const Body& a, const Body& b) {
  if constexpr (requires { a.axes; }) {
    return order_of_all(a.centre, b.centre, a.half_lengths, b.half_lengths, a.axes, b.axes) < 0;
  } else if constexpr (requires { a.core; }) {
    return order_of_all(a.core, b.core, a.radius, b.radius) < 0;
  } else if constexpr (requires { a.corner; }) {
    return order_of_all(a.corner, b.corner, a.first_edge, b.first_edge, a.second_edge,
                        b.second_edge, a.radius, b.radius) < 0;
  } else if constexpr (requires { a.vertices; }) {
    if (a.vertices.size() != b.vertices.size()) return a.vertices.size() < b.vertices.size();
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
      const int order = order_of(a.vertices[i], b.vertices[i]);
      if (order != 0) return order < 0;
    }
    return a.radius < b.radius;
  } else if constexpr (requires { a.radius; }) {
    return order_of_all(a.centre, b.centre, a.radius, b.radius) < 0;
  } else {
    return order_of_all(a.a, b.a, a.b, b.b, a.c, b.c) < 0;
  }
}

}  // namespace detail

}  // namespace contact
