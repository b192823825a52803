/// @file
/// Oriented boxes around points along given axes, and whether a point is in an oriented box: exact,
/// and as the lecture decides it.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>

#include <contact/aabb.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/oriented_box.hpp>
#include <contact/outward.hpp>
#include <contact/running_error.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace box_around_detail {

/// The smallest S that is at least x ≥ 0; ∞ if that is beyond the largest.
template <std::floating_point S>
S rounded_up(double x) {
  const S nearest = static_cast<S>(x);
  return static_cast<double>(nearest) < x
             ? std::nextafter(nearest, std::numeric_limits<S>::infinity())
             : nearest;
}

/// Whether the axes are those of the world, up to order and sign.
template <std::floating_point S>
bool along_world_axes(const Matrix3<S>& axes) {
  for (int i = 0; i < 3; ++i) {
    int zeros = 0;
    for (int k = 0; k < 3; ++k) zeros += axes(k, i) == S(0) ? 1 : 0;
    if (zeros != 2) return false;
  }
  return true;  // their length is 1 to within 64 u; see with_world_axes()
}

/// The largest entry, in magnitude, of axesᵀ axes − 1, rounded up: nine entries with at most four
/// roundings each, of sums below 2.
inline double departure_from_orthonormal(const Matrix3<double>& axes) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = i == j ? -1 : 0;
      for (int k = 0; k < 3; ++k) sum += axes(k, i) * axes(k, j);
      largest = std::max(largest, std::abs(sum));
    }
  }
  return largest + tolerance::gamma<double>(12);
}

/// Along the axes of the world, where lengths differ from coordinates by the factor |axes|, which
/// is 1 to within 64 u.
template <FloatOrDouble S>
OrientedBox<S> with_world_axes(const Matrix3<S>& axes, const Aabb<S>& bounds) {
  OrientedBox<S> box{Vector3<S>::Zero(), axes, Vector3<S>::Zero()};
  for (int k = 0; k < 3; ++k) {
    const S low = bounds.low[k], high = bounds.high[k];
    box.centre[k] = low == high ? low : low / S(2) + high / S(2);
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const S length = std::abs(axes(k, i));
      if (length == S(0)) continue;
      const S reach =
          std::max(sum_up(bounds.high[k], -box.centre[k]), sum_up(box.centre[k], -bounds.low[k]));
      const S margin = tolerance::gamma<S>(200) * reach + tolerance::underflow_unit<S>;
      box.half_lengths[i] = length == S(1) || reach == S(0) ? reach : sum_up(reach, margin);
    }
  }
  return box;
}

/// Along other axes, in double.
template <FloatOrDouble S>
OrientedBox<S> with_any_axes(const Matrix3<S>& axes, const Aabb<S>& bounds,
                             std::span<const Vector3<S>> points) {
  constexpr double eta = tolerance::underflow_unit<double>;
  const Matrix3<double>& a = axes.template cast<double>();
  const Vector3<double> low = bounds.low.template cast<double>();
  const Vector3<double> high = bounds.high.template cast<double>();
  const Vector3<double> from = low / 2 + high / 2;
  const Vector3<double> size = (high - from).cwiseMax(from - low);
  const double infinity = std::numeric_limits<double>::infinity();
  Vector3<double> least = Vector3<double>::Constant(infinity), most = -least;
  for (const Vector3<S>& point : points) {
    const Vector3<double> p = point.template cast<double>() - from;
    for (int i = 0; i < 3; ++i) {
      const double y = a(0, i) * p[0] + a(1, i) * p[1] + a(2, i) * p[2];
      least[i] = std::min(least[i], y);
      most[i] = std::max(most[i], y);
    }
  }
  // A sum y has at most four roundings a term; γ(8) covers those of the bound and of M.
  const auto bound = [&a](int i, const Vector3<double>& of) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += std::abs(a(k, i)) * of[k];
    return tolerance::gamma<double>(8) * sum + 4 * eta;
  };
  OrientedBox<S> box;
  box.axes = axes;
  const Vector3<double> middle = least / 2 + most / 2;
  for (int k = 0; k < 3; ++k) {
    const double shift = a(k, 0) * middle[0] + a(k, 1) * middle[1] + a(k, 2) * middle[2];
    box.centre[k] = static_cast<S>(from[k] + shift);
  }
  const Vector3<double> moved = box.centre.template cast<double>() - from;
  Vector3<double> y;
  for (int i = 0; i < 3; ++i) {
    const double at = a(0, i) * moved[0] + a(1, i) * moved[1] + a(2, i) * moved[2];
    y[i] = std::max(most[i] - at, at - least[i]) + bound(i, size) + bound(i, moved.cwiseAbs());
    y[i] += tolerance::gamma<double>(8) * y[i];
  }
  const double e = departure_from_orthonormal(a);
  const double off = e * (y[0] + y[1] + y[2]) * (1 + 4 * e) + eta;
  for (int i = 0; i < 3; ++i) {
    const double half_length = y[i] + off;
    box.half_lengths[i] =
        rounded_up<S>(half_length + (tolerance::gamma<double>(12) * half_length + eta));
  }
  return box;
}

}  // namespace box_around_detail

// [box-with-axes]
/// A box with the given axes that contains all points.
///
/// It contains them as it is stored, a parallelepiped: contains() is true for each. Proof. Let A be
/// the stored axes, E = AᵀA − 1 and e ≥ |Eᵢⱼ|. The coordinates of p are x = A⁻¹(p − c), and y =
/// Aᵀ(p − c) = x + E x; so |xᵢ| ≤ |yᵢ| + e Σ|xⱼ|, and the sum of these three gives Σ|xⱼ| ≤
/// Σ|yⱼ|/(1 − 3e). The half lengths are these bounds with the largest |yᵢ| of all points, each
/// extended by a bound on its rounding and rounded up.
///
/// Beyond the extent along an axis, a half length is at most 500 u of the largest distance from the
/// centre. Along the axes of the world, of length exactly 1, it is the smallest that contains all
/// points with the centre as stored. So it is 0 for a set that is flat there, and for points that
/// are all equal, with any axes; otherwise a flat set gets a half length of some u of its size.
/// @param axes a rotation: columns orthonormal to within 64 u, right-handed
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if an argument does not satisfy this, or the box overflows
///
/// Scales: all whose box does not overflow, subnormal numbers included.
template <FloatOrDouble S>
OrientedBox<S> box_with_axes(const Matrix3<S>& axes, std::span<const Vector3<S>> points) {
  oriented_box_from_axes<S>(Vector3<S>::Zero(), axes, Vector3<S>::Ones());
  const Aabb<S> bounds = aabb_of_points<S>(points);
  OrientedBox<S> box;
  if (bounds.low == bounds.high) {
    box = {bounds.low, axes, Vector3<S>::Zero()};
  } else if (box_around_detail::along_world_axes(axes)) {
    box = box_around_detail::with_world_axes(axes, bounds);
  } else {
    box = box_around_detail::with_any_axes(axes, bounds, points);
  }
  if (!all_finite(box.centre) || !all_finite(box.half_lengths)) {
    throw_invalid_argument("points", vector_text(bounds.high), "their box overflows");
  }
  return box;
}
// [/box-with-axes]

namespace box_around_detail {

/// Whether a point is in the stored body, by Cramer's rule: xᵢ = det(A with p − c as column i) /
/// det A. Sets `sure` to false if a sign is not certain.
template <class T>
bool inside_by_determinants(const OrientedBox<double>& box, const Vector3<double>& point,
                            bool& sure) {
  const auto column = [&box](int i) { return detail::triple<T>(Vector3<double>(box.axes.col(i))); };
  const detail::Triple<T> a = column(0), b = column(1), c = column(2);
  const detail::Triple<T> d =
      detail::minus(detail::triple<T>(point), detail::triple<T>(box.centre));
  const detail::Triple<T> normals[3] = {detail::cross(b, c), detail::cross(c, a),
                                        detail::cross(a, b)};
  T volume = detail::dot(a, normals[0]);
  const int side = detail::sign_of(volume, sure);
  if (side == 0) return false;
  if (side < 0) volume = -volume;
  for (int i = 0; i < 3; ++i) {
    const T along = detail::dot(d, normals[i]);
    const T limit = T(box.half_lengths[i]) * volume;
    if (detail::sign_of(limit - along, sure) < 0 || detail::sign_of(limit + along, sure) < 0) {
      return false;
    }
  }
  return true;
}

}  // namespace box_around_detail

// [box-contains]
/// Whether a point is in a box, exactly, for the stored numbers. Touching counts.
///
/// The stored body is a parallelepiped, because its axes are rounded. The coordinates of p = centre
/// + Σ xᵢ axesᵢ are quotients of determinants (Cramer's rule), so |xᵢ| ≤ half lengthᵢ is the sign
/// of a polynomial: it is computed in double with a bound on its error, and in doubt exactly.
/// @return false if a number is not finite, a half length is negative, or the axes are linearly
/// dependent
template <FloatOrDouble S>
bool contains(const OrientedBox<S>& box, const Vector3<S>& point) {
  if (!all_finite(point) || !all_finite(box.centre) || !all_finite(box.axes) ||
      !all_finite(box.half_lengths) || box.half_lengths.minCoeff() < S(0)) {
    return false;
  }
  const OrientedBox<double> stored{box.centre.template cast<double>(),
                                   box.axes.template cast<double>(),
                                   box.half_lengths.template cast<double>()};
  const Vector3<double> p = point.template cast<double>();
  bool sure = true;
  const bool inside = box_around_detail::inside_by_determinants<RunningError>(stored, p, sure);
  return sure ? inside : box_around_detail::inside_by_determinants<Exact>(stored, p, sure);
}
// [/box-contains]

// [six-planes]
/// Whether a point is on the inner side of the six planes of a box's faces, as the lecture decides
/// it, in the arithmetic of S.
///
/// Limits: rounded. A point on a face, or one that made the box, may be outside. With half lengths
/// that are not negative, an axis that is 0 excludes nothing; one that is infinite may exclude any
/// or none. An infinite half length excludes every point where its axis has an entry 0.
/// @return false if the point or the centre is not finite, or a number is NaN
template <FloatOrDouble S>
bool inside_six_planes(const OrientedBox<S>& box, const Vector3<S>& point) {
  for (int i = 0; i < 3; ++i) {
    const Vector3<S> axis = box.axes.col(i);
    for (const S side : {S(-1), S(1)}) {
      const Vector3<S> outward = side * axis;
      const Vector3<S> on_face = box.centre + box.half_lengths[i] * outward;
      if (!(outward.dot(Vector3<S>(point - on_face)) <= S(0))) return false;
    }
  }
  return true;
}

/// Whether a point is between each pair of parallel faces: three slabs |axisᵢ · (p − centre)| ≤
/// half lengthᵢ, in the arithmetic of S.
///
/// Limits: rounded, and only with orthonormal axes about the same body as contains(). With half
/// lengths that are not negative, an axis that is 0 excludes no finite point.
/// @return false if a number is NaN; with finite half lengths also if another number is infinite,
/// or the product along an axis overflows
template <FloatOrDouble S>
bool between_each_pair(const OrientedBox<S>& box, const Vector3<S>& point) {
  const Vector3<S> from_centre = point - box.centre;
  for (int i = 0; i < 3; ++i) {
    const Vector3<S> axis = box.axes.col(i);
    if (!(std::abs(axis.dot(from_centre)) <= box.half_lengths[i])) return false;
  }
  return true;
}
// [/six-planes]

}  // namespace contact
