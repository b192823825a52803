/// @file
/// Points about one of them, scaled by a power of two, and the farthest of them from a centre.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/bounded_double_double.hpp>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace contact::sphere_detail {

/// A power of two by which differences become about 1 in size: at most 2^1000, at least 2^-1022.
///
/// Differences that might overflow are scaled before they are formed, others afterwards: then only
/// parts below 2^-1074 are lost.
struct Scaling {
  double before = 1;  ///< to multiply the coordinates by
  double after = 1;   ///< to multiply the differences by

  /// @param largest the largest difference, rounded; may be infinite
  explicit Scaling(double largest) {
    if (largest == 0) return;
    int exponent = std::numeric_limits<double>::max_exponent;
    if (std::isfinite(largest)) std::frexp(largest, &exponent);
    const double scale = std::ldexp(1.0, std::clamp(-exponent, -1022, 1000));
    (exponent > 400 ? before : after) = scale;
  }
  /// Both together.
  double scale() const { return before * after; }
  /// Whether all differences are scaled afterwards, by 2^-60 to 2^60: their quotients by the scale
  /// lose less than 2^-1000.
  bool is_moderate() const { return before == 1 && after >= 0x1p-60 && after <= 0x1p60; }
  /// Whether a number may have lost something when it was multiplied by `after`.
  bool lossy(double x) const { return x * after / after != x; }
};

/// A point that is farthest from a centre.
struct Farthest {
  double distance_squared;  ///< as computed
  int index;
};

/// Points in double, about the first of them and scaled: what is fast to measure from a centre.
template <FloatOrDouble S>
class LocalPoints {
 public:
  /// @param points not empty, finite; must stay where they are
  explicit LocalPoints(std::span<const Vector3<S>> points)
      : points_(points), scaling_(largest_difference(points)) {
    const std::size_t n = points.size(), padded = (n + block - 1) / block * block;
    for (std::size_t k = 0; k < 3; ++k) {
      const double origin = static_cast<double>(points[0](static_cast<int>(k))) * scaling_.before;
      coordinates_[k].assign(padded, 0.0);  // as the first point, for all but n of them
      for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(points[i](static_cast<int>(k)));
        coordinates_[k][i] = (x * scaling_.before - origin) * scaling_.after;
        extent_ = std::max(extent_, std::abs(coordinates_[k][i]));
      }
    }
  }

  const Scaling& scaling() const { return scaling_; }
  /// How many points there are.
  int size() const { return static_cast<int>(points_.size()); }
  /// The largest coordinate of all.
  double extent() const { return extent_; }
  /// A point; each coordinate is within u |coordinate| + 2^-1000 of the exact one.
  Vector3<double> operator[](int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {coordinates_[0][at], coordinates_[1][at], coordinates_[2][at]};
  }
  /// |p − c|² of a point, as computed.
  double distance_squared(int i, const Vector3<double>& c) const {
    const Vector3<double> d = (*this)[i] - c;
    return d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  }

  /// A point whose computed distance from a centre is largest.
  ///
  /// Blocks of points are measured without branches, four maxima at a time, because each maximum
  /// waits for the one before. Only where a block has a larger one, its point is looked for.
  // [farthest]
  Farthest farthest(const Vector3<double>& c) const {
    Farthest found{-1, 0};
    std::array<double, block> squares;
    for (std::size_t start = 0; start < coordinates_[0].size(); start += block) {
      const double *x = &coordinates_[0][start], *y = &coordinates_[1][start],
                   *z = &coordinates_[2][start];
      for (std::size_t j = 0; j < block; ++j) {
        const double dx = x[j] - c.x(), dy = y[j] - c.y(), dz = z[j] - c.z();
        squares[j] = dx * dx + dy * dy + dz * dz;
      }
      std::array<double, 4> most{-1, -1, -1, -1};
      for (std::size_t j = 0; j < block; j += 4) {
        for (std::size_t k = 0; k < 4; ++k) most[k] = std::max(most[k], squares[j + k]);
      }
      const double largest = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
      if (!(largest > found.distance_squared)) continue;
      const auto at = std::find(squares.begin(), squares.end(), largest) - squares.begin();
      found = {largest, static_cast<int>(start) + static_cast<int>(at)};
    }
    if (found.index >= size()) found.index = 0;  // the rest of the last block
    return found;
  }
  // [/farthest]

  /// The difference of two points in a number type, without error up to its bound; scaled, except
  /// in exact numbers.
  template <class T>
  detail::Triple<T> difference(int point, int base) const {
    detail::Triple<T> v;
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = difference_of(coordinate(point, k), coordinate(base, k), T());
    return v;
  }
  /// A coordinate as it was given.
  double coordinate(int i, std::size_t k) const {
    return static_cast<double>(points_[static_cast<std::size_t>(i)](static_cast<int>(k)));
  }

 private:
  static constexpr std::size_t block = 64;
  std::span<const Vector3<S>> points_;
  Scaling scaling_;
  std::array<std::vector<double>, 3> coordinates_;
  double extent_ = 0;

  static double largest_difference(std::span<const Vector3<S>> points) {
    double largest = 0;
    const Vector3<double> first = points[0].template cast<double>();
    for (const Vector3<S>& point : points) {
      for (int k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(static_cast<double>(point(k)) - first(k)));
      }
    }
    return largest;
  }
  RunningError difference_of(double x, double y, const RunningError&) const {
    const auto [value, error] = two_sum(x * scaling_.before, -y * scaling_.before);
    return {value * scaling_.after,
            RunningError::up(std::abs(error) * scaling_.after) + RunningError::floor};
  }
  BoundedDoubleDouble difference_of(double x, double y, const BoundedDoubleDouble&) const {
    const auto [value, error] = two_sum(x * scaling_.before, -y * scaling_.before);
    const bool lost = scaling_.before != 1 || scaling_.lossy(value) || scaling_.lossy(error);
    return {value * scaling_.after, error * scaling_.after, lost ? RunningError::floor : 0};
  }
  Exact difference_of(double x, double y, const Exact&) const { return Exact(x) - Exact(y); }
};

}  // namespace contact::sphere_detail
