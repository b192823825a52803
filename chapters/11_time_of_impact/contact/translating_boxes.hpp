/// @file
/// Translating boxes, and the interval in which their projections on an axis overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include <contact/exact.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plane.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A box with any orientation that translates.
///
/// Its edges are the columns of `frame.axes` times twice the half lengths, as stored. If the stored
/// axes are not exactly orthogonal, it is the slightly oblique parallelepiped that they span.
/// translating_box() checks its arguments.
template <Ring S>
struct TranslatingBox {
  CoordinateFrame<S> frame;                      ///< centre at the start, m, and axes
  Vector3<S> half_lengths = Vector3<S>::Zero();  ///< m, each greater than 0
  Vector3<S> displacement = Vector3<S>::Zero();  ///< in the step, m
};

/// Checks a translating box.
/// @param frame centre and axes; the axes must be orthonormal to 2^-20
/// @param half_lengths m, finite, each greater than 0
/// @param displacement m, finite
/// @throws std::invalid_argument if an argument does not satisfy these conditions
template <std::floating_point S>
TranslatingBox<S> translating_box(const CoordinateFrame<S>& frame, const Vector3<S>& half_lengths,
                                  const Vector3<S>& displacement) {
  require_finite("frame.origin", frame.origin);
  require_finite("half_lengths", half_lengths);
  require_finite("displacement", displacement);
  const Matrix3<S> product = frame.axes.transpose() * frame.axes;
  for (int k = 0; k < 3; ++k) {
    if (!(half_lengths(k) > S(0))) {
      throw_invalid_argument("half_lengths", vector_text(half_lengths),
                             "each must be greater than 0");
    }
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(product(k, j) - (k == j ? S(1) : S(0))) <= S(0x1p-20))) {
        const Vector3<S> axis = frame.axes.col(k);
        throw_invalid_argument("frame.axes", vector_text(axis),
                               "the axes must have length 1 and be orthogonal");
      }
    }
  }
  return {frame, half_lengths, displacement};
}

/// The first touch of two translating boxes.
template <Ring S>
struct BoxImpact {
  S t = S(0);  ///< fraction of the step, from 0 to 1
  /// Unit vector from b to a, normal to a plane that separates them until then (rounded: until
  /// 2^-42 before then). 0 if they meet at the start.
  Vector3<S> normal = Vector3<S>::Zero();
};

// [axis-times]
/// The interval in which the projections of two bodies on an axis overlap: |distance + speed t| ≤
/// reach.
///
/// Its ends are fractions with a common positive denominator, so they are compared without a
/// division. If the speed is 0, the projections overlap always or never.
template <Ring T>
struct AxisTimes {
  T distance;    ///< axis · d
  T speed;       ///< axis · w
  T radius_sum;  ///< half the sum of both extents, times the length of the axis

  /// Numerator of the time at which the overlap begins; |speed| is the denominator.
  T begins() const { return (speed < T(0) ? distance : T(-distance)) - radius_sum; }
  /// Numerator of the time at which it ends.
  T ends() const { return (speed < T(0) ? distance : T(-distance)) + radius_sum; }
};

/// Axis k of separating_axes(): 0 to 2 and 3 to 5 face normals, 6 + 3 i + j edge i of the first and
/// j of the second.
template <Ring T>
Vector3<T> separating_axis(const std::array<Vector3<T>, 3>& u, const std::array<Vector3<T>, 3>& v,
                           std::size_t k) {
  if (k < 3) return u[(k + 1) % 3].cross(u[(k + 2) % 3]);
  if (k < 6) return v[(k + 1) % 3].cross(v[(k + 2) % 3]);
  return u[(k - 6) / 3].cross(v[(k - 6) % 3]);
}

/// The fifteen axes of two boxes with the half edges u and v: three face normals of each, and nine
/// cross products of an edge of one and an edge of the other. Two boxes are disjoint if and only if
/// one of these axes separates them. Parallel edges give 0, which separates nothing.
template <Ring T>
std::array<Vector3<T>, 15> separating_axes(const std::array<Vector3<T>, 3>& u,
                                           const std::array<Vector3<T>, 3>& v) {
  std::array<Vector3<T>, 15> axes;
  for (std::size_t k = 0; k < 15; ++k) axes[k] = separating_axis(u, v, k);
  return axes;
}
// [/axis-times]

namespace detail {

/// The half edges of two boxes, and the position and displacement of b relative to a.
template <Ring T>
struct SweptPair {
  std::array<Vector3<T>, 3> u;
  std::array<Vector3<T>, 3> v;
  Vector3<T> d;
  Vector3<T> w;
  /// Whether edge k of a and edge j of b are exactly parallel, at 3 k + j; of rounded pairs only.
  std::array<bool, 9> parallel{};

  AxisTimes<T> times(const Vector3<T>& axis) const {
    using std::abs;  // a comparison with 0 would be a branch that no processor predicts
    const auto along = [&axis](const Vector3<T>& x) -> T {
      return axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2];
    };
    T radius_sum(0);
    for (std::size_t k = 0; k < 3; ++k)
      radius_sum = radius_sum + abs(along(u[k])) + abs(along(v[k]));
    return {along(d), along(w), radius_sum};
  }
};

inline SweptPair<Exact> exact_pair(const TranslatingBox<double>& a,
                                   const TranslatingBox<double>& b) {
  SweptPair<Exact> pair;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Vector3<double> edge_a = a.frame.axes.col(k);
    const Vector3<double> edge_b = b.frame.axes.col(k);
    pair.u[at] = exact_vector(edge_a) * Exact(a.half_lengths(k));
    pair.v[at] = exact_vector(edge_b) * Exact(b.half_lengths(k));
  }
  pair.d = exact_vector(b.frame.origin) - exact_vector(a.frame.origin);
  pair.w = exact_vector(b.displacement) - exact_vector(a.displacement);
  return pair;
}

/// Whether two stored axes are certainly parallel: equal, opposite, or without any product in their
/// cross product.
inline bool certainly_parallel(const Vector3<double>& x, const Vector3<double>& y) {
  const auto none = [](double p, double q) { return p == 0 || q == 0; };
  return x == y || x == -y ||
         (none(x[1], y[2]) && none(x[2], y[1]) && none(x[2], y[0]) && none(x[0], y[2]) &&
          none(x[0], y[1]) && none(x[1], y[0]));
}

/// The pair with rounded edges and differences; what is parallel is not asked.
inline SweptPair<double> rounded_edges(const TranslatingBox<double>& a,
                                       const TranslatingBox<double>& b) {
  SweptPair<double> pair;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    pair.u[at] = a.frame.axes.col(k) * a.half_lengths(k);
    pair.v[at] = b.frame.axes.col(k) * b.half_lengths(k);
  }
  pair.d = b.frame.origin - a.frame.origin;
  pair.w = b.displacement - a.displacement;
  return pair;
}

inline SweptPair<double> rounded_pair(const TranslatingBox<double>& a,
                                      const TranslatingBox<double>& b) {
  SweptPair<double> pair = rounded_edges(a, b);
  for (int k = 0; k < 9; ++k) {
    pair.parallel[static_cast<std::size_t>(k)] =
        certainly_parallel(a.frame.axes.col(k / 3), b.frame.axes.col(k % 3));
  }
  return pair;
}

}  // namespace detail

}  // namespace contact
