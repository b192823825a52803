/// @file
/// A sphere at rest against a plane.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/plane.hpp>
#include <contact/shapes.hpp>

namespace contact {

/// Whether a sphere and a plane have a point in common: |n · c − k| ≤ r. Touching counts.
/// @param sphere with a radius that is not negative, m
/// @param plane with a unit normal; with another length the test is wrong by that factor
/// @note In a floating-point type the rounded distance decides: certain only if | |n · c − k| − r |
/// exceeds signed_distance_error(plane, c).
/// @see *Interaction and Normals*, slide "Sphere-Plane Intersection"
// [sphere-plane]
template <Ring S>
bool sphere_meets_plane(const Sphere<S>& sphere, const Plane<S>& plane) {
  const S distance = signed_distance(plane, sphere.centre);
  return distance <= sphere.radius && -distance <= sphere.radius;
}
// [/sphere-plane]

/// The same question for a plane whose normal was never normalised: (N · c − K)² ≤ r² N · N.
///
/// Both sides were multiplied by |N| and squared, so there is no square root and no division: with
/// an exact S the answer is exact. In a floating-point type the squares overflow and underflow much
/// sooner than the lengths.
/// @param sphere with a radius that is not negative, m
/// @param plane with a normal of any length; N = 0 is no plane, and no sphere meets it
// [sphere-raw-plane]
template <Ring S>
bool sphere_meets_plane(const Sphere<S>& sphere, const RawPlane<S>& plane) {
  const S length_squared = plane.normal.dot(plane.normal);
  if (!(length_squared > S(0)) || sphere.radius < S(0)) return false;
  const S value = plane.normal.dot(sphere.centre) - plane.offset;
  return value * value <= sphere.radius * sphere.radius * length_squared;
}
// [/sphere-raw-plane]

namespace detail {

// [sphere-filter]
/// The floating-point filter: the answer of rounded arithmetic if it is certain, else nothing.
/// Compares |N · (c − a)| with r |N|.
///
/// With P = Σ Mᵢ |cᵢ − aᵢ| and Mᵢ the sum of the magnitudes of the products of entry i of the cross
/// product: each term of N · (c − a) goes through at most eight roundings (two differences,
/// product, difference; one difference, product, two sums), so the left side is off by at most γ(8)
/// P. The entries of N are off by γ(4) Mᵢ and the root adds 4 u, so the right side is off by at
/// most γ(8) r ΣMᵢ. γ(24) leaves room for the rounding of the bound itself, and for the squares in
/// N · N that underflow as long as N · N ≥ 2^-900. Products that underflow are off by η / 2 each: 8
/// η (Σ|cᵢ − aᵢ| + r + 1) covers them. An overflow makes the comparison false and the answer
/// uncertain.
inline std::optional<bool> sphere_meets_plane_if_certain(const Sphere<double>& sphere,
                                                         const Vector3<double>& a,
                                                         const Vector3<double>& b,
                                                         const Vector3<double>& c) {
  const Vector3<double> ab = b - a;
  const Vector3<double> ac = c - a;
  const Vector3<double> to_centre = sphere.centre - a;
  const Vector3<double> normal = ab.cross(ac);
  const Vector3<double> products(std::abs(ab.y() * ac.z()) + std::abs(ab.z() * ac.y()),
                                 std::abs(ab.z() * ac.x()) + std::abs(ab.x() * ac.z()),
                                 std::abs(ab.x() * ac.y()) + std::abs(ab.y() * ac.x()));
  const double length_squared = normal.dot(normal);
  const double left = std::abs(normal.dot(to_centre));
  const double right = sphere.radius * std::sqrt(length_squared);
  const double bound =
      tolerance::gamma<double>(24) *
          (products.dot(to_centre.cwiseAbs()) + sphere.radius * products.sum()) +
      8 * tolerance::underflow_unit<double> * (to_centre.cwiseAbs().sum() + sphere.radius + 1);
  if (!(length_squared >= 0x1p-900) || !std::isfinite(right)) return std::nullopt;
  if (left - right > bound) return false;
  if (right - left > bound) return true;
  return std::nullopt;
}
// [/sphere-filter]

}  // namespace detail

// [sphere-exact]
/// Whether a sphere and the plane through three points have a point in common: right for all finite
/// numbers, without a tolerance. A floating-point filter: rounded arithmetic where it is certain,
/// exact arithmetic elsewhere.
/// @param sphere with a radius that is not negative, m
/// @param a, b, c points, m; collinear points determine no plane, and no sphere meets them
template <std::floating_point S>
bool sphere_meets_plane_exactly(const Sphere<S>& sphere, const Vector3<S>& a, const Vector3<S>& b,
                                const Vector3<S>& c) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  const Sphere<double> in_double{sphere.centre.template cast<double>(), double(sphere.radius)};
  if (sphere.radius < S(0)) return false;
  const auto certain = detail::sphere_meets_plane_if_certain(
      in_double, a.template cast<double>(), b.template cast<double>(), c.template cast<double>());
  if (certain) return *certain;
  const Sphere<Exact> exact{exact_vector(sphere.centre), Exact(double(sphere.radius))};
  return sphere_meets_plane(
      exact, raw_plane_from_points(exact_vector(a), exact_vector(b), exact_vector(c)));
}
// [/sphere-exact]

}  // namespace contact
