/// @file
/// The winding number of a closed mesh around a point as a sum of solid angles, with a bound on its
/// error.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/arc.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/mesh.hpp>
#include <contact/polygon.hpp>
#include <contact/tolerance.hpp>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

namespace contact {

/// A winding number as a sum of solid angles.
struct SolidAngleWinding {
  double winding = 0;  ///< the sum of the solid angles, divided by 4π
  double bound = 0;    ///< the exact value differs from it by at most this; may be infinite

  /// For a closed mesh the winding number, if the bound proves it: there is only one whole number
  /// within the bound. For an open mesh it means nothing. Nothing if the bound is infinite or NaN.
  std::optional<int> certain() const {
    if (!(bound < 0.5)) return std::nullopt;
    const double nearest = std::round(winding);
    return static_cast<int>(nearest);
  }
};

namespace solid_angle_detail {

/// A solid angle with its error bound, sr.
struct BoundedAngle {
  double value = 0;
  double bound = 0;
};

// [solid-angle]
/// The solid angle of the triangle a, b, c (relative to the point) by van Oosterom and Strackee:
/// tan(Ω/2) = a·(b × c) / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|).
///
/// The bound. Let P = |a||b||c|. The sum of the absolute terms of the numerator is the permanent of
/// the absolute entries, at most 6/√27 P < 1.2 P (Carlen, Lieb and Loss), and each has at most 8
/// roundings: three of differences, one of a product, one of a difference, one of a product, two of
/// sums. So the numerator is off by less than 10 u P. A length has at most 4 roundings (the root
/// halves those before it), so P has 14, and with three sums 17; each other term has at most 5 of
/// the scalar product, 4 of the length, one of the product and three of the sums: 13, and its
/// absolute terms are at most P. So the denominator is off by less than (17 + 3·13) u P = 56 u P,
/// and the vector (denominator, numerator) by less than 57 u P, or 64 u P in terms of the computed
/// P. Its direction is off by at most asin(δ/h) ≤ (π/3) δ/h if δ ≤ h/2, where h is the length of
/// the computed vector, and Ω, twice the angle, by 2.1·64 u P/h < 136 u P/h; h is at least its
/// larger entry. `portable_angle` is off by at most 16 u of an angle of at most π, with u of
/// double, and twice that is 32 π u < 101 u: 128 u for Ω leaves room.
///
/// If δ > h/2, or if the numerator may be 0 and the denominator is negative, so that the angle may
/// be on the other side of ±π, the whole 4π is the bound: the point is, as far as the arithmetic
/// can tell, on the triangle. The lengths must be between 2^-e and 2^e, so that products do not
/// overflow, and underflow stays far below u P; otherwise the bound is infinite.
template <FloatOrDouble S>
BoundedAngle solid_angle(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c) {
  constexpr double u = tolerance::unit_roundoff<S>;
  constexpr double pi = std::numbers::pi, endless = std::numeric_limits<double>::infinity();
  constexpr S most = std::same_as<S, float> ? S(0x1p30) : S(0x1p300);
  const S la = std::sqrt(a.dot(a)), lb = std::sqrt(b.dot(b)), lc = std::sqrt(c.dot(c));
  const S numerator = a.dot(b.cross(c));
  const S denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  const double half = portable_angle(std::abs(double(numerator)), double(denominator));
  const double value = numerator < S(0) ? -2 * half : 2 * half;
  if (!(std::min({la, lb, lc}) > 1 / most && std::max({la, lb, lc}) < most))
    return {value, endless};
  const double error = 64 * u * static_cast<double>(la * lb * lc);
  const double n = std::abs(static_cast<double>(numerator)), d = static_cast<double>(denominator);
  const double larger = std::max(n, std::abs(d));
  if (2 * error >= larger || (n <= error && d <= error)) return {value, 4 * pi};
  return {value, 136.0 / 64 * error / larger + 128 * tolerance::unit_roundoff<double>};
}
// [/solid-angle]

}  // namespace solid_angle_detail

// [winding-by-solid-angles]
/// The winding number of a closed mesh around a point: the sum of the solid angles of all triangles
/// as seen from the point, divided by 4π.
///
/// Every direction counts, so there is no ray that could meet an edge. Each triangle costs an arc
/// tangent and three roots, and no box spares a triangle, so it is slow for every point.
///
/// Limits: the bound is proved at `solid_angle`. If `bound` is below 1/2, the nearest whole number
/// is the winding number of the closed mesh, and the point is not on the surface. Measured on a box
/// and on balls of up to 5,120 triangles: in double, 99 of 100 points at a distance of 2^-40 edge
/// lengths from a face or an edge are certain and none at 2^-52; in float, 98 of 100 at 2^-12 and
/// none at 2^-22. On the surface nothing is proved. For a mesh that is not closed it is the
/// fraction of all directions in which the surface is seen from behind, minus those in which it is
/// seen from the front (the generalised winding number). No triangles: 0. A number that is not
/// finite: the bound is infinite.
///
/// Source: van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983; Jacobson, Kavan
/// and Sorkine-Hornung, Robust Inside-Outside Segmentation using Generalized Winding Numbers, 2013.
template <FloatOrDouble S>
SolidAngleWinding winding_by_solid_angles(const Vector3<S>& point, const Mesh<S>& mesh) {
  double sum = 0, bound = 0, magnitude = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = triangle_of(mesh, i);
    const auto [value, error] = solid_angle_detail::solid_angle<S>(a - point, b - point, c - point);
    sum += value;
    bound += error;
    magnitude += std::abs(value);
  }
  // The sums are of doubles: n additions, each off by u of a partial sum, and as much for the
  // bound.
  const double n = static_cast<double>(mesh.triangles.size());
  const double rounding = (n + 4) * std::numeric_limits<double>::epsilon();
  const double whole = 4 * std::numbers::pi;
  const double total = (bound + magnitude * rounding) * (1 + 2 * rounding) / whole * (1 + 0x1p-50);
  const bool finite = std::isfinite(sum) && total >= 0;
  return {finite ? sum / whole : 0, finite ? total : std::numeric_limits<double>::infinity()};
}
// [/winding-by-solid-angles]

/// Inside if the nearest whole number is not 0: two answers, whatever the bound.
///
/// Limits: on a face half a turn is lost or gained by chance, and near an edge or a vertex several
/// triangles can be wrong by a whole turn. The product of the three distances from the point to a
/// triangle's vertices may overflow or underflow, for sizes beyond about 1e±100 in double and 1e±12
/// in float: then even the centre may be outside. No triangles, or a number that is not finite:
/// outside.
template <FloatOrDouble S>
Where where_by_solid_angles(const Vector3<S>& point, const Mesh<S>& mesh) {
  const double winding = winding_by_solid_angles(point, mesh).winding;
  return std::abs(winding) > 0.5 ? Where::inside : Where::outside;
}

}  // namespace contact
