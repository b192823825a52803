/// @file
/// Whether two bounding volumes of one kind have a point in common: spheres and axis-aligned boxes
/// exactly, oriented boxes never wrongly apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <contact/aabb.hpp>
#include <contact/exact.hpp>
#include <contact/oriented_box.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/sphere_terms.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [spheres-meet]
/// Whether two spheres have a point in common: whether |a − b|² ≤ (rₐ + r_b)². Touching counts.
///
/// Exact for the stored numbers, of any size. The filter: a term of the difference has at most six
/// roundings, so its error is at most γ(6) times the sum s of both sides; 8 u s is more, and covers
/// the roundings of s. Underflow adds less than 2^-1000. After an overflow the bound is infinite or
/// NaN, and exact numbers decide.
/// @return false if a number is not finite or a radius is negative
template <FloatOrDouble S>
bool may_meet(const Sphere<S>& a, const Sphere<S>& b) {
  if (!is_ball(a) || !is_ball(b)) return false;
  const Sphere<double> first = in_double(a), second = in_double(b);
  const Vector3<double> between = first.centre - second.centre;
  const double reach = first.radius + second.radius;
  const double left = between.dot(between), right = reach * reach;
  const double bound = 8 * tolerance::unit_roundoff<double> * (left + right) + 0x1p-1000;
  if (std::abs(right - left) > bound) return right > left;
  const auto d =
      detail::minus(detail::triple<Exact>(first.centre), detail::triple<Exact>(second.centre));
  const Exact radii = Exact(first.radius) + Exact(second.radius);
  return detail::dot(d, d) <= radii * radii;
}
// [/spheres-meet]

/// Whether two boxes have a point in common, as boxes_touch(). Touching counts, nothing is rounded.
/// Infinite numbers are compared as any others. That low ≤ high is not checked: a box that is not
/// one may meet another.
/// @return false if a number is NaN
template <FloatOrDouble S>
bool may_meet(const Aabb<S>& a, const Aabb<S>& b) {
  for (int k = 0; k < 3; ++k) {
    if (!(a.low(k) <= b.high(k) && b.low(k) <= a.high(k))) return false;
  }
  return true;
}

namespace detail {

/// Whether all numbers of an oriented box are finite.
template <FloatOrDouble S>
bool is_finite_box(const OrientedBox<S>& box) {
  return all_finite(box.centre) && all_finite(box.axes) && all_finite(box.half_lengths);
}

/// An oriented box with what all of its axes share: its face normals as cross products.
struct BoxTerms {
  std::array<Vector3<double>, 3> axes;     ///< as stored
  std::array<Vector3<double>, 3> normals;  ///< axis i+1 × axis i+2
  Vector3<double> half;
  double volume;   ///< |det axes|
  double longest;  ///< the largest of |x| + |y| + |z| of the axes, at least 1
  double size;     ///< the sum of the half lengths

  template <FloatOrDouble S>
  explicit BoxTerms(const OrientedBox<S>& box)
      : half(box.half_lengths.template cast<double>()), longest(1), size(half.sum()) {
    for (int i = 0; i < 3; ++i) {
      axes[std::size_t(i)] = box.axes.col(i).template cast<double>();
      longest = std::max(longest, axes[std::size_t(i)].cwiseAbs().sum());
    }
    for (std::size_t i = 0; i < 3; ++i) normals[i] = axes[(i + 1) % 3].cross(axes[(i + 2) % 3]);
    volume = std::abs(axes[0].dot(normals[0]));
  }
};

/// |table[i][j]| = |normals of a face i · axis j of b|: the determinants of two axes of one box and
/// one of the other, which are all that the fifteen axes need.
using Determinants = std::array<std::array<double, 3>, 3>;
inline Determinants determinants(const BoxTerms& of_faces, const BoxTerms& of_axes) {
  Determinants table{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      table[i][j] = std::abs(of_faces.normals[i].dot(of_axes.axes[j]));
    }
  }
  return table;
}

// [box-faces]
/// Whether a plane parallel to a face of a separates it from b, `margin` being the error of both
/// sides. d: from the centre of b to that of a.
inline bool face_separates(const BoxTerms& a, const BoxTerms& b, const Determinants& table,
                           const Vector3<double>& d, double margin) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double radius_of_b =
        b.half[0] * table[i][0] + b.half[1] * table[i][1] + b.half[2] * table[i][2];
    const double reach = a.half[int(i)] * a.volume + radius_of_b;
    if (std::abs(a.normals[i].dot(d)) > reach + margin) return true;
  }
  return false;
}
// [/box-faces]

// [box-edges]
/// Whether a plane parallel to an edge of each separates a from b. For n = aᵢ × bⱼ, n · aₖ is, but
/// for its sign, a determinant of two axes of a and one of b: an entry of a's table.
inline bool edge_pair_separates(const BoxTerms& a, const BoxTerms& b, const Determinants& of_a,
                                const Determinants& of_b, const Vector3<double>& d, double margin) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    const Vector3<double> turned = d.cross(a.axes[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double radius_of_a = a.half[int(i1)] * of_a[i2][j] + a.half[int(i2)] * of_a[i1][j];
      const double radius_of_b = b.half[int(j1)] * of_b[j2][i] + b.half[int(j2)] * of_b[j1][i];
      if (std::abs(turned.dot(b.axes[j])) > radius_of_a + radius_of_b + margin) return true;
    }
  }
  return false;
}
// [/box-edges]

/// A margin that covers the rounding of both sides along each of the fifteen axes.
///
/// Let n be such an axis. The boxes as stored, parallelepipeds, are apart if |n · d| exceeds r, the
/// sum of their supports along n, Σ half length × |n · axis|. Each term of n · d and of r is a
/// product of a length and at most three entries of axes, with at most 6 and 9 roundings; without
/// signs, the terms of a length x add up to at most x m³, m the largest sum of the magnitudes of an
/// axis. So with s = m² (max |d| + m Σ half lengths), |n · d| − r is off by at most γ(10) s, plus
/// 16 η and a share of s that is far below u for underflow. 16 u s + 16 η is above that, its own
/// roundings included.
inline double boxes_margin(const BoxTerms& a, const BoxTerms& b, const Vector3<double>& d) {
  const double m = std::max(a.longest, b.longest);
  const double s = m * m * (d.cwiseAbs().maxCoeff() + m * (a.size + b.size));
  return 16 * tolerance::unit_roundoff<double> * s + 16 * tolerance::underflow_unit<double>;
}

}  // namespace detail

// [boxes-meet]
/// Whether two oriented boxes may have a point in common: no plane along one of the fifteen axes is
/// certain to separate them. Rounded and conservative: never false for stored boxes with a common
/// point, whatever their axes are; see detail::boxes_margin(). Parallel edges give n = 0, and 0
/// exceeds nothing.
///
/// It says "may" for some that are apart: if no gap along the fifteen axes exceeds twice the
/// margin, about 10^-14 of the size.
/// @param a, b with half lengths that are not negative; they may be 0
/// @return false if a number is not finite; true if a product overflows
/// @see Gottschalk, Lin and Manocha, *OBBTree*, SIGGRAPH 1996
template <FloatOrDouble S>
bool may_meet(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  const detail::BoxTerms p(a), q(b);
  const Vector3<double> d = a.centre.template cast<double>() - b.centre.template cast<double>();
  const double margin = detail::boxes_margin(p, q, d);
  const bool in_range = std::isfinite(margin + d.sum() + p.volume + q.volume);
  if (!in_range) return detail::is_finite_box(a) && detail::is_finite_box(b);
  const detail::Determinants of_p = detail::determinants(p, q);
  if (detail::face_separates(p, q, of_p, d, margin)) return false;
  const detail::Determinants of_q = detail::determinants(q, p);
  return !detail::face_separates(q, p, of_q, d, margin) &&
         !detail::edge_pair_separates(p, q, of_p, of_q, d, margin);
}
// [/boxes-meet]

}  // namespace contact
