/// @file
/// Bounding spheres from one or two passes over the points: the lecture's, which grows from the
/// most distant extreme pair, and those about the mean of the points and about the centre of their
/// box.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/bounded_double_double.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace contact {

/// Two points of a list that are extreme along an axis.
struct ExtremePair {
  int low;   ///< index of a point with the smallest coordinate
  int high;  ///< index of a point with the largest one
  int axis;  ///< 0, 1 or 2: x, y or z
};

namespace sphere_detail {

/// |b − a|² − |d − c|², of four points.
template <class T, FloatOrDouble S>
T difference_of_squares(const std::array<Vector3<S>, 4>& p) {
  std::array<T, 2> squares;
  for (std::size_t i = 0; i < 2; ++i) {
    detail::Triple<T> x;
    for (int k = 0; k < 3; ++k) {
      x[static_cast<std::size_t>(k)] =
          T(static_cast<double>(p[2 * i + 1](k))) - T(static_cast<double>(p[2 * i](k)));
    }
    squares[i] = detail::dot(x, x);
  }
  return squares[0] - squares[1];
}

/// The sign of |b − a| − |d − c|.
template <FloatOrDouble S>
int compare_distances(const std::array<Vector3<S>, 4>& p) {
  bool sure = true;
  int sign = detail::sign_of(difference_of_squares<RunningError>(p), sure);
  if (sure) return sign;
  sure = true;
  sign = detail::sign_of(difference_of_squares<BoundedDoubleDouble>(p), sure);
  return sure ? sign : difference_of_squares<Exact>(p).sign();
}

/// A power of two by which the largest coordinate becomes about 1, or 1 if it is 0.
template <FloatOrDouble S>
S scale_to_one(std::span<const Vector3<S>> points) {
  S largest = S(0);
  for (const Vector3<S>& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  if (largest == S(0)) return S(1);
  constexpr int most = std::numeric_limits<S>::max_exponent - 2;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(S(1), std::min(-exponent, most));
}

}  // namespace sphere_detail

// [most-distant-extremes]
/// The lecture's pair: for each axis the first point with the smallest and the first with the
/// largest coordinate; of these three pairs, the one whose points are farthest apart. Which one is
/// decided without error; of equal ones it is the first.
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if there is no point, or a coordinate is not finite
template <FloatOrDouble S>
ExtremePair most_distant_extremes(std::span<const Vector3<S>> points) {
  sphere_detail::require_points(points);
  const auto at = [&points](int i) { return points[static_cast<std::size_t>(i)]; };
  ExtremePair best{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    ExtremePair pair{0, 0, axis};
    for (int i = 1; i < static_cast<int>(points.size()); ++i) {
      if (at(i)(axis) < at(pair.low)(axis)) pair.low = i;
      if (at(i)(axis) > at(pair.high)(axis)) pair.high = i;
    }
    if (axis == 0 || sphere_detail::compare_distances<S>(
                         {at(pair.low), at(pair.high), at(best.low), at(best.high)}) > 0) {
      best = pair;
    }
  }
  return best;
}
// [/most-distant-extremes]

namespace sphere_detail {

// [grow]
/// Grows a sphere so that it contains a point: the smallest one that contains both, rounded.
template <FloatOrDouble S>
void grow(Sphere<S>& sphere, const Vector3<S>& point) {
  const Vector3<S> to_point = point - sphere.centre;
  const S distance = to_point.norm();
  if (!(distance > sphere.radius)) return;
  const S radius = (sphere.radius + distance) / 2;
  sphere.centre += to_point * ((distance - radius) / distance);
  sphere.radius = radius;
}
// [/grow]

/// The lecture's sphere of the points times a power of two.
template <FloatOrDouble S>
Sphere<S> grown(std::span<const Vector3<S>> points, S scale) {
  const ExtremePair pair = most_distant_extremes(points);
  const auto at = [&](int i) { return Vector3<S>(points[static_cast<std::size_t>(i)] * scale); };
  const Vector3<S> low = at(pair.low), high = at(pair.high);
  Sphere<S> sphere{low / 2 + high / 2, (high - low).norm() / 2};
  for (const Vector3<S>& point : points) grow<S>(sphere, point * scale);
  return sphere;
}

}  // namespace sphere_detail

// [grown-as-given]
/// The lecture's sphere, as it stands there: the midpoint of the most distant extreme pair and half
/// its distance, then grown by each point that is outside, in order.
///
/// Everything is rounded, so **the sphere may miss its own points**, by some ulps of the
/// coordinates; of float, a large share of all spheres does. Use grown_sphere(). The result depends
/// on the order of the points. Squares overflow for distances beyond 1e154 (float: 1e19), and then
/// centre or radius are not finite; they underflow below 1e-162 (float: 1e-23).
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if there is no point, or a coordinate is not finite
///
/// Source: Ritter, *An efficient bounding sphere*, Graphics Gems (1990).
template <FloatOrDouble S>
Sphere<S> sphere_grown_as_given(std::span<const Vector3<S>> points) {
  return sphere_detail::grown(points, S(1));
}
// [/grown-as-given]

// [grown]
/// The lecture's sphere, certain to contain every point: its centre, and the smallest radius about
/// it that encloses them.
///
/// The centre is that of sphere_grown_as_given(), computed at a scale at which nothing overflows.
/// Rounding moves the centre by some ulps; a radius that is computed afterwards makes up for it.
/// @param points n ≥ 1 points, m, finite, of any magnitude
/// @throws std::invalid_argument if there is no point, a coordinate is not finite, or the radius
/// overflows
template <FloatOrDouble S>
Sphere<S> grown_sphere(std::span<const Vector3<S>> points) {
  sphere_detail::require_points(points);
  const S scale = sphere_detail::scale_to_one(points);
  const Vector3<S> centre = sphere_detail::grown(points, scale).centre / scale;
  return {centre, enclosing_radius(centre, points)};
}
// [/grown]

/// The sphere about the mean of the points, with the smallest radius that encloses them.
///
/// The mean is rounded (recursive summation); the radius is not affected. Each point counts, so
/// where a mesh has many vertices the centre moves towards them, and the sphere grows: its radius
/// may be almost twice that of the smallest one.
/// @param points n ≥ 1 points, m, finite, of any magnitude
/// @throws std::invalid_argument if there is no point, a coordinate is not finite, or the radius
/// overflows
template <FloatOrDouble S>
Sphere<S> centroid_sphere(std::span<const Vector3<S>> points) {
  sphere_detail::require_points(points);
  const S scale = sphere_detail::scale_to_one(points);
  Vector3<double> sum = Vector3<double>::Zero();
  for (const Vector3<S>& point : points) sum += (point * scale).template cast<double>();
  const Vector3<double> mean = sum / static_cast<double>(points.size());
  const Vector3<S> centre = mean.template cast<S>() / scale;
  return {centre, enclosing_radius(centre, points)};
}

/// The sphere about the centre of the points' box, with the smallest radius that encloses them.
///
/// Its radius is at most √3 times that of the smallest sphere, up to rounding: half the diagonal of
/// a box whose edges are at most that sphere's diameter.
/// @param points n ≥ 1 points, m, finite, of any magnitude
/// @throws std::invalid_argument if there is no point, a coordinate is not finite, or the radius
/// overflows
template <FloatOrDouble S>
Sphere<S> box_centre_sphere(std::span<const Vector3<S>> points) {
  const Aabb<S> box = aabb_of_points(points);
  Vector3<S> centre;
  for (int k = 0; k < 3; ++k) centre(k) = std::midpoint(box.low(k), box.high(k));
  return {centre, enclosing_radius(centre, points)};
}

}  // namespace contact
