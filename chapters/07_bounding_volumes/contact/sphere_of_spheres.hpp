/// @file
/// Spheres that enclose spheres: the smallest one of two, and one grown by each of many.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/sphere_terms.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [encloses]
/// Whether the outer sphere contains all of the inner one: whether R − r ≥ 0 and
/// |C − c|² ≤ (R − r)². Touching from inside counts.
///
/// Exact for the stored numbers, of any size; the filter is that of may_meet() for spheres.
/// @return false if a number is not finite or a radius is negative
template <FloatOrDouble S>
bool encloses(const Sphere<S>& outer, const Sphere<S>& inner) {
  if (!is_ball(outer) || !is_ball(inner) || outer.radius < inner.radius) return false;
  const Sphere<double> out = in_double(outer), in = in_double(inner);
  const Vector3<double> between = out.centre - in.centre;
  const double room = out.radius - in.radius;
  const double left = between.dot(between), right = room * room;
  const double bound = 8 * tolerance::unit_roundoff<double> * (left + right) + 0x1p-1000;
  if (std::abs(right - left) > bound) return right > left;
  const auto d = detail::minus(detail::triple<Exact>(out.centre), detail::triple<Exact>(in.centre));
  const Exact radii = Exact(out.radius) - Exact(in.radius);
  return detail::dot(d, d) <= radii * radii;
}
// [/encloses]

namespace detail {

/// The centre, rounded, of the smallest sphere about two of which none contains the other: on the
/// line of their centres, half of the difference of the radii from the middle. Computed with the
/// largest number scaled to about 1, so that nothing overflows.
template <FloatOrDouble S>
Vector3<S> centre_about(const Sphere<S>& a, const Sphere<S>& b) {
  const Sphere<double> first = in_double(a), second = in_double(b);
  const double largest = std::max({first.centre.cwiseAbs().maxCoeff(), first.radius,
                                   second.centre.cwiseAbs().maxCoeff(), second.radius});
  int power = 0;
  std::frexp(largest, &power);
  const auto scaled = [&power](double x) { return std::ldexp(x, -power); };
  Vector3<double> between;
  for (int k = 0; k < 3; ++k) between[k] = scaled(second.centre[k]) - scaled(first.centre[k]);
  const double distance = between.stableNorm();
  const double difference = scaled(second.radius) - scaled(first.radius);
  const double share = distance > 0 ? (distance + difference) / (2 * distance) : 0.5;
  const double t = std::min(std::max(share, 0.0), 1.0);
  Vector3<S> centre;
  for (int k = 0; k < 3; ++k) {
    centre[k] = static_cast<S>(std::ldexp(scaled(first.centre[k]) + t * between[k], power));
  }
  return centre;
}

/// The two spheres with the lowest and the highest point along the axis in which all spheres extend
/// furthest. Halves are compared, so that nothing overflows.
template <FloatOrDouble S>
std::array<std::size_t, 2> furthest_spheres(std::span<const Sphere<S>> spheres) {
  std::array<std::size_t, 2> furthest{0, 0};
  double widest = -1;
  for (int k = 0; k < 3; ++k) {
    const auto side = [&](std::size_t i, double sign) {
      const Sphere<double> sphere = in_double(spheres[i]);
      return sphere.centre[k] / 2 + sign * (sphere.radius / 2);
    };
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < spheres.size(); ++i) {
      if (side(i, -1) < side(low, -1)) low = i;
      if (side(i, 1) > side(high, 1)) high = i;
    }
    const double width = side(high, 1) / 2 - side(low, -1) / 2;
    if (width > widest) {
      widest = width;
      furthest = {low, high};
    }
  }
  return furthest;
}

/// A sphere about two, rounded, which may miss either by a rounding: where only the centre of the
/// last one matters.
template <FloatOrDouble S>
Sphere<S> rounded_sphere_about(const Sphere<S>& a, const Sphere<S>& b) {
  const double distance =
      (a.centre.template cast<double>() - b.centre.template cast<double>()).stableNorm();
  const double first = static_cast<double>(a.radius), second = static_cast<double>(b.radius);
  if (distance + second <= first) return a;
  if (distance + first <= second) return b;
  const double radius = distance / 2 + first / 2 + second / 2;
  return {centre_about(a, b), static_cast<S>(radius)};
}

/// The radius about a centre that encloses all spheres; only those that may be the furthest are
/// compared exactly. Half of |c − p| + r is computed in double, off by a few u and a few η.
template <FloatOrDouble S>
S radius_about_far_ones(const Vector3<S>& centre, std::span<const Sphere<S>> spheres) {
  const auto furthest = [&centre](const Sphere<S>& sphere) {
    const Vector3<double> d =
        sphere.centre.template cast<double>() - centre.template cast<double>();
    return d.stableNorm() / 2 + static_cast<double>(sphere.radius) / 2;
  };
  double largest = 0;
  for (const Sphere<S>& sphere : spheres) largest = std::max(largest, furthest(sphere));
  std::vector<Sphere<S>> far;
  for (const Sphere<S>& sphere : spheres) {
    const double room = 0x1p-40 * largest + 8 * tolerance::underflow_unit<double>;
    if (furthest(sphere) >= largest - room) far.push_back(sphere);
  }
  return enclosing_radius(centre, std::span<const Sphere<S>>(far));
}

}  // namespace detail

// [sphere-of-two]
/// A sphere that contains two: the larger one if it contains the other, which is decided exactly.
/// Otherwise the smallest such sphere with a rounded centre: each coordinate is a few u of the
/// largest coordinate or radius off, and the radius is the smallest number that encloses both about
/// the stored centre, so that it is above the smallest possible one by no more than that error.
///
/// Its filter and its exact numbers make it contain both in every case, subnormal numbers included.
/// @param a, b m, finite, with radii that are not negative
/// @throws std::invalid_argument if one does not satisfy this, or if the radius overflows
template <FloatOrDouble S>
Sphere<S> enclosing_sphere(const Sphere<S>& a, const Sphere<S>& b) {
  detail::require_sphere(a);
  detail::require_sphere(b);
  if (encloses(a, b)) return a;
  if (encloses(b, a)) return b;
  const std::array<Sphere<S>, 2> both{a, b};
  Sphere<S> about{detail::centre_about(a, b), S(0)};
  about.radius = enclosing_radius(about.centre, std::span<const Sphere<S>>(both));
  return about;
}
// [/sphere-of-two]

// [sphere-of-spheres]
/// A sphere that contains all spheres: grown as the lecture's sphere of points.
///
/// It begins with the two spheres that are furthest apart along one axis, becomes the sphere about
/// itself and each sphere that it does not contain, and last takes the smallest radius that
/// encloses all about its centre. It depends on the order of the spheres, and may be larger than
/// the smallest one.
/// @param spheres n ≥ 1, m, finite, with radii that are not negative
/// @throws std::invalid_argument if there is none, one does not satisfy this, or the radius
/// overflows
template <FloatOrDouble S>
Sphere<S> grown_sphere_of_spheres(std::span<const Sphere<S>> spheres) {
  if (spheres.empty()) throw_invalid_argument("spheres", "{}", "needs at least one sphere");
  for (const Sphere<S>& sphere : spheres) detail::require_sphere(sphere);
  const auto [low, high] = detail::furthest_spheres(spheres);
  Sphere<S> grown = detail::rounded_sphere_about(spheres[low], spheres[high]);
  for (const Sphere<S>& sphere : spheres) grown = detail::rounded_sphere_about(grown, sphere);
  grown.radius = detail::radius_about_far_ones(grown.centre, spheres);
  return grown;
}
// [/sphere-of-spheres]

}  // namespace contact
