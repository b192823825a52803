/// @file
/// Whether a sphere contains a point, without error, and the smallest radius with which it contains
/// all points or all spheres of a list.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/bounded_double_double.hpp>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <span>

namespace contact {

namespace sphere_detail {

/// |p − c|² − r² in a number type, where p_k − c_k = value + error exactly.
template <class T>
T excess(const detail::Triple<T>& d, const T& radius) {
  return detail::dot(d, d) - radius * radius;
}

/// The sign of |p − c|² − r² with twice as many digits, or else exactly.
template <FloatOrDouble S>
int excess_sign_in_doubt(const Vector3<S>& centre, S radius, const Vector3<S>& point) {
  const double r = static_cast<double>(radius);
  detail::Triple<BoundedDoubleDouble> sharp;
  detail::Triple<Exact> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = static_cast<int>(k);
    const double p = static_cast<double>(point(i)), c = static_cast<double>(centre(i));
    const auto [difference, error] = two_sum(p, -c);
    sharp[k] = {difference, error, 0};
  }
  bool sure = true;
  const int sign = detail::sign_of(excess<BoundedDoubleDouble>(sharp, r), sure);
  if (sure) return sign;
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = static_cast<int>(k);
    exact[k] = Exact(static_cast<double>(point(i))) - Exact(static_cast<double>(centre(i)));
  }
  return excess<Exact>(exact, r).sign();
}

// [excess-sign]
/// The sign of |p − c|² − r²: −1 inside, 0 on the surface, 1 outside.
///
/// In double the value is off by less than 8u (|p − c|² + r²), as in sphere_terms.hpp: each
/// difference is rounded once, and no term to the result more than six times. In doubt, with twice
/// as many digits; then exactly.
/// @param centre, point finite
/// @param radius finite
template <FloatOrDouble S>
int excess_sign(const Vector3<S>& centre, S radius, const Vector3<S>& point) {
  const Vector3<double> d = point.template cast<double>() - centre.template cast<double>();
  const double r = static_cast<double>(radius);
  const double distance_squared = d.dot(d), value = distance_squared - r * r;
  const double bound = 8 * RunningError::u * (distance_squared + r * r) + RunningError::floor;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return excess_sign_in_doubt(centre, radius, point);
}
// [/excess-sign]

/// Whether all points are finite; throws if there is none, or one is not.
template <class Points>
void require_points(const Points& points) {
  if (points.empty()) throw_invalid_argument("points", "{}", "there must be at least one point");
  for (const auto& point : points) require_finite("points", point);
}

/// Differences of points from a centre in double, times a power of two by which no square
/// overflows, and none that matters underflows.
///
/// Each is rounded once, and off by less than 2^-1000 more by underflow. The largest is 0 or at
/// least 2^-474.
template <FloatOrDouble S>
class ScaledDifferences {
 public:
  /// @param centre, points finite
  ScaledDifferences(const Vector3<S>& centre, std::span<const Vector3<S>> points)
      : centre_(centre.template cast<double>()) {
    for (const Vector3<S>& point : points) {
      const Vector3<double> d = point.template cast<double>() - centre_;
      largest_ = std::max({largest_, std::abs(d.x()), std::abs(d.y()), std::abs(d.z())});
    }
    if (largest_ > 0x1p400) {
      before_ = 0x1p-600;
      centre_ *= before_;
    }
    if (largest_ < 0x1p-400) after_ = 0x1p600;
  }
  /// (point − centre) scale().
  Vector3<double> operator()(const Vector3<S>& point) const {
    return (point.template cast<double>() * before_ - centre_) * after_;
  }
  /// By what the differences are multiplied: 2^-600, 1 or 2^600.
  double scale() const { return before_ * after_; }
  /// The largest coordinate of all differences, rounded, before scaling; may be infinite.
  double largest() const { return largest_; }

 private:
  Vector3<double> centre_;
  double largest_ = 0, before_ = 1, after_ = 1;
};

/// The largest S that is at most x ≥ 0 / scale.
template <FloatOrDouble S>
S divided_down(double x, double scale) {
  constexpr S largest = std::numeric_limits<S>::max();
  const double quotient = x / scale;
  S below = quotient >= static_cast<double>(largest) ? largest : static_cast<S>(quotient);
  return below > S(0) ? std::nextafter(below, S(0)) : S(0);
}

}  // namespace sphere_detail

// [contains]
/// Whether a point is in a sphere: |p − c|² ≤ r², decided without error for the stored numbers.
/// Touching counts.
/// @return false if a number is not finite, or the radius is negative
template <FloatOrDouble S>
bool contains(const Sphere<S>& sphere, const Vector3<S>& point) {
  if (!all_finite(sphere.centre) || !is_finite(sphere.radius) || !all_finite(point)) return false;
  return sphere.radius >= S(0) &&
         sphere_detail::excess_sign(sphere.centre, sphere.radius, point) <= 0;
}
// [/contains]

/// The smallest number of S that is at least the distance of every point from a centre: with it, a
/// sphere contains all of them, and with the next smaller number it does not.
///
/// A radius below the largest rounded distance is raised, number by number, as long as a point is
/// outside; it starts at most a few numbers below the result. Points that are nearer than the
/// farthest by more than all rounding are not looked at.
/// @param centre m, finite
/// @param points n ≥ 1 points, m, finite, of any magnitude
/// @throws std::invalid_argument if there is no point, a number is not finite, or the radius is
/// larger than the largest number
// [enclosing-radius]
template <FloatOrDouble S>
S enclosing_radius(const Vector3<S>& centre, std::span<const Vector3<S>> points) {
  require_finite("centre", centre);
  sphere_detail::require_points(points);
  const sphere_detail::ScaledDifferences<S> scaled(centre, points);
  double largest = 0;
  for (const Vector3<S>& point : points) {
    const Vector3<double> d = scaled(point);
    largest = std::max(largest, d.dot(d));
  }
  constexpr double u = RunningError::u;
  S radius = sphere_detail::divided_down<S>(std::sqrt(largest) * (1 - 8 * u), scaled.scale());
  for (const Vector3<S>& point : points) {
    const Vector3<double> d = scaled(point);
    if (d.dot(d) < largest * (1 - 32 * u)) continue;
    while (sphere_detail::excess_sign(centre, radius, point) > 0) {
      radius = std::nextafter(radius, std::numeric_limits<S>::infinity());
      if (!std::isfinite(radius)) {
        throw_invalid_argument("points", vector_text(point), "the radius overflows");
      }
    }
  }
  return radius;
}
// [/enclosing-radius]

namespace sphere_detail {

/// Whether a sphere about a centre with a radius does not contain another sphere: |c' − c| > R − r.
template <FloatOrDouble S>
bool sticks_out(const Vector3<S>& centre, S radius, const Sphere<S>& sphere) {
  const Exact room = Exact(radius) - Exact(sphere.radius);
  if (room.sign() < 0) return true;
  Exact distance_squared;
  for (int k = 0; k < 3; ++k) {
    const Exact d = Exact(sphere.centre(k)) - Exact(centre(k));
    distance_squared += d * d;
  }
  return distance_squared > room * room;
}

}  // namespace sphere_detail

/// The smallest number of S with which a sphere about a centre contains every sphere of a list: at
/// least every |c' − c| + r'.
/// @param centre m, finite
/// @param spheres n ≥ 1 spheres, m, finite, with radii that are not negative
/// @throws std::invalid_argument if there is no sphere, a number is not finite, a radius is
/// negative, or the result is larger than the largest number
template <FloatOrDouble S>
S enclosing_radius(const Vector3<S>& centre, std::span<const Sphere<S>> spheres) {
  require_finite("centre", centre);
  if (spheres.empty()) throw_invalid_argument("spheres", "{}", "there must be at least one");
  S radius = S(0);
  for (const Sphere<S>& sphere : spheres) {
    require_finite("spheres", sphere.centre);
    require_finite("spheres", sphere.radius);
    if (sphere.radius < S(0)) {
      throw_invalid_argument("spheres", number_text(sphere.radius),
                             "a radius must not be negative");
    }
    const std::span<const Vector3<S>> one(&sphere.centre, 1);
    const sphere_detail::ScaledDifferences<S> scaled(centre, one);
    const double s = scaled.scale(), r = static_cast<double>(sphere.radius);
    const Vector3<double> d = scaled(sphere.centre);
    // Rounded, and certain not to be too large: half of both, so that nothing overflows.
    constexpr double less = 1 - 16 * RunningError::u;
    constexpr double room = 2 * tolerance::underflow_unit<double>;  // for halves of subnormals
    const double half = std::max(0.0, (std::sqrt(d.dot(d)) / 2 / s + r / 2) * less - room);
    radius = std::max(radius, sphere_detail::divided_down<S>(half, 0.5));
    while (sphere_detail::sticks_out(centre, radius, sphere)) {
      radius = std::nextafter(radius, std::numeric_limits<S>::infinity());
      if (!std::isfinite(radius)) {
        throw_invalid_argument("spheres", vector_text(sphere.centre), "the radius overflows");
      }
    }
  }
  return radius;
}

}  // namespace contact
