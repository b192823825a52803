/// @file
/// The lecture's sphere around points whose coordinates are multiples of 1/8, with extremes and
/// distances compared in integers, and with the mistakes that the tests of the exercise recognise.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/shapes.hpp>
#include <cstdint>
#include <limits>
#include <vector>

namespace spheres_with_mistakes {

using Point = Eigen::Vector3d;
using Points = std::vector<Point>;
using Sphere = contact::Sphere<double>;

inline constexpr double kParts = 8;
inline constexpr double kLimit = 1000;

/// Two points that are extreme along an axis, by index.
struct Pair {
  int low, high;
};

inline const Point& at(const Points& points, int i) { return points[static_cast<std::size_t>(i)]; }

inline std::int64_t eighths(double x) { return static_cast<std::int64_t>(x * kParts); }

/// In units of 1/64 m².
inline std::int64_t square_distance(const Point& a, const Point& b) {
  std::int64_t sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += (eighths(a[k]) - eighths(b[k])) * (eighths(a[k]) - eighths(b[k]));
  return sum;
}

// ---------------------------------------------------------------- the most distant extremes

inline Pair extremes_along(int axis, const Points& points) {
  const auto less = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
  const auto low = std::min_element(points.begin(), points.end(), less);
  const auto high = std::max_element(points.begin(), points.end(), less);
  return {static_cast<int>(low - points.begin()), static_cast<int>(high - points.begin())};
}

/// The same with the last one of equal points.
inline Pair last_extremes_along(int axis, const Points& points) {
  const Points reversed(points.rbegin(), points.rend());
  const Pair pair = extremes_along(axis, reversed);
  const int last = static_cast<int>(points.size()) - 1;
  return {last - pair.low, last - pair.high};
}

/// Each point is compared with the largest coordinate only if it is not below the smallest one.
inline Pair extremes_by_else(int axis, const Points& points) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  Pair pair{0, 0};
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const double x = at(points, i)[axis];
    if (x < low) {
      low = x;
      pair.low = i;
    } else if (x > high) {
      high = x;
      pair.high = i;
    }
  }
  return pair;
}

/// The largest coordinate is searched for from 0.
inline Pair extremes_from_zero(int axis, const Points& points) {
  Pair pair{extremes_along(axis, points).low, 0};
  double high = 0;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if (at(points, i)[axis] <= high) continue;
    high = at(points, i)[axis];
    pair.high = i;
  }
  return pair;
}

inline double extent_along(int axis, const Pair& pair, const Points& points) {
  return at(points, pair.high)[axis] - at(points, pair.low)[axis];
}
inline std::int64_t square_distance(int /*axis*/, const Pair& pair, const Points& points) {
  return square_distance(at(points, pair.low), at(points, pair.high));
}

/// The first of the three pairs with the largest measure, or the last one.
template <class Search, class Measure>
inline Pair best_pair(const Points& points, const Search& search, const Measure& measure,
                      bool last = false) {
  Pair best = search(0, points);
  auto largest = measure(0, best, points);
  for (int axis = 1; axis < 3; ++axis) {
    const Pair pair = search(axis, points);
    const auto size = measure(axis, pair, points);
    if (size < largest || (size == largest && !last)) continue;
    best = pair;
    largest = size;
  }
  return best;
}

template <class Search>
inline Pair farthest_pair(const Points& points, const Search& search, bool last = false) {
  const auto measure = [](int axis, const Pair& pair, const Points& of) {
    return square_distance(axis, pair, of);
  };
  return best_pair(points, search, measure, last);
}

inline Pair most_distant_extremes(const Points& points) {
  return farthest_pair(points, extremes_along);
}

/// Whether no two of the points are farther from each other.
inline bool is_farthest_of_all(const Pair& pair, const Points& points) {
  const int count = static_cast<int>(points.size());
  if (std::min(pair.low, pair.high) < 0 || std::max(pair.low, pair.high) >= count) return false;
  const std::int64_t distance = square_distance(at(points, pair.low), at(points, pair.high));
  return std::all_of(points.begin(), points.end(), [&](const Point& a) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Point& b) { return square_distance(a, b) <= distance; });
  });
}

// ---------------------------------------------------------------- the start

inline Sphere start_sphere(const Point& low, const Point& high) {
  return {low + (high - low) / 2, std::sqrt(double(square_distance(low, high))) / (2 * kParts)};
}

// ---------------------------------------------------------------- one step

/// A sphere of this radius that touches the point and whose centre is towards the old one.
inline Sphere touching(const Point& point, double radius, const Sphere& sphere) {
  const Point from_point = sphere.centre - point;
  return {point + from_point * (radius / from_point.norm()), radius};
}
inline double mean_radius(const Sphere& sphere, const Point& point) {
  return (sphere.radius + (sphere.centre - point).norm()) / 2;
}
inline Sphere grown(const Sphere& sphere, const Point& point) {
  return touching(point, mean_radius(sphere, point), sphere);
}
inline Sphere grown_by(const Sphere& sphere, const Point& point) {
  return (point - sphere.centre).norm() > sphere.radius ? grown(sphere, point) : sphere;
}

// ---------------------------------------------------------------- the whole sphere

inline Sphere start_of(const Points& points) {
  const Pair pair = most_distant_extremes(points);
  return start_sphere(at(points, pair.low), at(points, pair.high));
}

inline Sphere grow_sphere(const Points& points) {
  Sphere sphere = start_of(points);
  for (const Point& p : points) sphere = grown_by(sphere, p);
  return sphere;
}

/// Grows once, by the point that is farthest from the centre of the start sphere.
inline Sphere grown_once(const Points& points) {
  const Sphere start = start_of(points);
  const auto nearer = [&](const Point& a, const Point& b) {
    return (a - start.centre).squaredNorm() < (b - start.centre).squaredNorm();
  };
  return grown_by(start, *std::max_element(points.begin(), points.end(), nearer));
}

inline Sphere around(const Point& centre, const Points& points) {
  double radius = 0;
  for (const Point& p : points) radius = std::max(radius, (p - centre).norm());
  return {centre, radius};
}
inline Sphere around_mean(const Points& points) {
  Point sum = Point::Zero();
  for (const Point& p : points) sum += p;
  return around(sum / double(points.size()), points);
}
inline Sphere around_box_centre(const Points& points) {
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return around((low + high) / 2, points);
}

}  // namespace spheres_with_mistakes
