/// @file
/// Gaps of two boxes along their axes, right or with one mistake that people make: what the test of
/// the exercise compares with and recognises.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <contact/exact.hpp>
#include <contact/oriented_box.hpp>

#include "fifteen_axes.hpp"

namespace gaps_with_mistakes {

using contact::Exact;
using exercise::LargestGap;
using Vector = Eigen::Vector3d;
using Axes = Eigen::Matrix3d;
using Box = contact::OrientedBox<double>;
using ExactVector = contact::Vector3<Exact>;

constexpr double kParallel = 1e-8, kEqual = 1e-9;

/// The rotation by a quaternion of whole numbers.
inline Axes rotation(int w, int x, int y, int z) {
  Axes whole;
  whole << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y),
      2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return whole / (w * w + x * x + y * y + z * z);
}

// ---------------------------------------------------------------- right answers

inline ExactVector exactly(const Vector& v) { return {Exact(v.x()), Exact(v.y()), Exact(v.z())}; }
inline Exact dot(const ExactVector& u, const ExactVector& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}
inline ExactVector cross(const ExactVector& u, const ExactVector& v) {
  return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
          u.x() * v.y() - u.y() * v.x()};
}

/// The gap along n for the stored numbers, rounded when all of it is known: numerator, square of
/// the length, root and quotient.
inline double gap_along(const Box& a, const Box& b, const ExactVector& n) {
  Exact gap = abs(dot(n, exactly(b.centre)) - dot(n, exactly(a.centre)));
  for (const Box& box : {a, b})
    for (int i = 0; i < 3; ++i)
      gap -= Exact(box.half_lengths[i]) * abs(dot(n, exactly(box.axes.col(i))));
  return rounded<double>(gap) / std::sqrt(rounded<double>(dot(n, n)));
}

/// Direction k of the contract, of any length.
inline ExactVector direction(const Box& a, const Box& b, int k) {
  if (k < 6) return exactly(k < 3 ? a.axes.col(k) : b.axes.col(k - 3));
  return cross(exactly(a.axes.col((k - 6) / 3)), exactly(b.axes.col((k - 6) % 3)));
}

/// NaN where the edges are parallel.
inline std::array<double, 15> all_gaps(const Box& a, const Box& b) {
  std::array<double, 15> gaps;
  for (int k = 0; k < 15; ++k) {
    const ExactVector n = direction(a, b, k);
    const bool parallel = std::sqrt(rounded<double>(dot(n, n))) < kParallel;
    gaps[static_cast<std::size_t>(k)] =
        parallel ? std::numeric_limits<double>::quiet_NaN() : gap_along(a, b, n);
  }
  return gaps;
}

inline LargestGap largest_of(const std::array<double, 15>& gaps) {
  LargestGap largest{-std::numeric_limits<double>::infinity(), 0};
  for (int k = 0; k < 15; ++k) {
    const double gap = gaps[static_cast<std::size_t>(k)];
    if (gap > largest.gap + kEqual) largest = {gap, k};
  }
  return largest;
}

// ---------------------------------------------------------------- what the contract allows

inline bool is_box(const Box& box) {
  const Vector& h = box.half_lengths;
  return box.axes.allFinite() &&
         (box.axes.transpose() * box.axes - Axes::Identity()).cwiseAbs().maxCoeff() < 1e-14 &&
         box.axes.determinant() > 0 && h == h.array().round().matrix() && h.minCoeff() >= 1 &&
         h.maxCoeff() <= 1000 && box.centre.cwiseAbs().maxCoeff() <= 1000 &&
         box.centre * 0x1p30 == (box.centre * 0x1p30).array().round().matrix();
}

/// Whether edges are parallel or clearly not, and gaps equal but for rounding or clearly different.
inline bool is_clear(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double sine = Vector(a.axes.col(i)).cross(Vector(b.axes.col(j))).norm();
      if (sine > 1e-12 && sine < 1e-2) return false;
    }
  const std::array<double, 15> gaps = all_gaps(a, b);
  const double largest = largest_of(gaps).gap;
  return std::none_of(gaps.begin(), gaps.end(), [&](double gap) {
    return std::abs(gap - largest) > 1e-10 && std::abs(gap - largest) < 1.5e-9;
  });
}

// ---------------------------------------------------------------- with mistakes

/// What is done wrong along one direction.
enum class Along {
  rightly,
  not_divided,
  with_edges,
  with_half_of_the_half,
  by_rows,
  without_axes,
  without_magnitude,
  by_distance_of_centres,
  on_one_side,
  with_the_first_twice,
  not_below_zero,
  reversed,
  by_common_part
};

inline double extent(const Box& box, const Vector& n, Along way) {
  Vector along = box.axes.transpose() * n;
  if (way == Along::by_rows) along = box.axes * n;
  if (way == Along::without_axes) along = n;
  if (way == Along::without_magnitude) return std::abs(along.dot(box.half_lengths));
  const double sum = along.cwiseAbs().dot(box.half_lengths);
  return way == Along::with_edges ? 2 * sum : way == Along::with_half_of_the_half ? sum / 2 : sum;
}

inline double gap_with(Along way, const Box& a, const Box& b, const Vector& n) {
  const double of_a = extent(a, n, way);
  const double of_b = way == Along::with_the_first_twice ? of_a : extent(b, n, way);
  const double between = n.dot(b.centre - a.centre);
  if (way == Along::by_common_part) {
    const double begin = std::max(-of_a, between - of_b), end = std::min(of_a, between + of_b);
    return (begin - end) / n.norm();
  }
  if (way == Along::by_distance_of_centres)
    return (b.centre - a.centre).norm() - (of_a + of_b) / n.norm();
  const double gap = (way == Along::on_one_side ? between : std::abs(between)) - of_a - of_b;
  if (way == Along::not_divided) return gap;
  if (way == Along::not_below_zero) return std::max(gap, 0.0) / n.norm();
  return (way == Along::reversed ? -gap : gap) / n.norm();
}

/// What is done wrong in the search.
struct Search {
  int axes = 15;                 ///< how many of them are tried
  bool of_second = true;         ///< the normals of the second box are tried
  bool cross_unit = true;        ///< cross products are divided by their length
  bool by_second = false;        ///< axis 6 + 3 j + i for edges i and j
  bool first_positive = false;   ///< the search ends at the first axis that separates
  bool nearest_to_zero = false;  ///< of all gaps
};

inline LargestGap search(const Box& a, const Box& b, const Search& ways) {
  const double infinity = std::numeric_limits<double>::infinity();
  LargestGap best{-infinity, 0};
  double value = -infinity;
  for (int k = 0; k < ways.axes; ++k) {
    if (!ways.of_second && k >= 3 && k < 6) continue;
    const int i = (k - 6) / 3, j = (k - 6) % 3;
    const Vector n = k < 3   ? Vector(a.axes.col(k))
                     : k < 6 ? Vector(b.axes.col(k - 3))
                             : Vector(a.axes.col(i)).cross(Vector(b.axes.col(j)));
    if (n.norm() < kParallel) continue;
    const double right = gap_with(Along::rightly, a, b, n);
    const double gap = ways.cross_unit ? right : right * n.norm();
    const double worth = ways.nearest_to_zero ? -std::abs(gap) : gap;
    if (worth <= value + kEqual) continue;
    value = worth;
    best = {gap, k >= 6 && ways.by_second ? 6 + 3 * j + i : k};
    if (ways.first_positive && gap > 0) break;
  }
  return best;
}

}  // namespace gaps_with_mistakes
