/// @file
/// Differences of points of two bodies in double, with bounds of their error: the filters of the
/// proofs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// A point of a body as a stored position and a short offset from it, both m: so the difference of
/// two points of bodies far from the origin loses no digits.
struct PositionAndOffset {
  Vector3<double> position;
  Vector3<double> offset = Vector3<double>::Zero();
};

/// Vertex i of a core in this form. Only boxes and lozenges have offsets.
template <PolytopeCore Body>
PositionAndOffset vertex_from_position(const Body& body, int i) {
  using S = ScalarOf<Body>;
  static_assert(std::same_as<S, double>, "convert the body by in_double()");
  if constexpr (std::same_as<Body, OrientedBox<S>>) {
    const auto edge = [&](int k) {
      return Vector3<double>(body.axes.col(k) *
                             ((i >> k & 1) != 0 ? body.half_lengths(k) : -body.half_lengths(k)));
    };
    return {body.centre, edge(0) + edge(1) + edge(2)};
  } else if constexpr (std::same_as<Body, Lozenge<S>>) {
    return {body.corner, body.first_edge * double(i & 1) + body.second_edge * double(i >> 1 & 1)};
  } else {
    return {vertex(body, i)};
  }
}

/// The largest sum of absolute terms of a coordinate of an offset, m, up to rounding.
template <ConvexBody Body>
double offset_size(const Body& body) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, OrientedBox<S>>) {
    return Vector3<double>(body.axes.cwiseAbs() * body.half_lengths).maxCoeff();
  } else if constexpr (std::same_as<Body, Lozenge<S>>) {
    return Vector3<double>(body.first_edge.cwiseAbs() + body.second_edge.cwiseAbs()).maxCoeff();
  } else {
    return 0;
  }
}

/// Up to six differences aᵢ − bᵢ in double, and how far they may be off.
class BoundedDifferences {
 public:
  /// @param offsets the offset_size() of both bodies together, m
  explicit BoundedDifferences(double offsets) : offsets_(offsets) {}

  /// Adds the difference of two points. One that overflows makes nothing certain.
  void add(const PositionAndOffset& a, const PositionAndOffset& b) {
    const Vector3<double> w = (a.position - b.position) + (a.offset - b.offset);
    largest_ = std::max(largest_, w.cwiseAbs().maxCoeff());
    if (!all_finite(w)) largest_ = std::numeric_limits<double>::infinity();
    w_[count_++] = w;
  }

  /// The differences as computed, m.
  const Vector3<double>& difference(std::size_t i) const { return w_[i]; }
  /// How many there are.
  std::size_t count() const { return count_; }

  // [difference-error]
  /// Bound on the error of a coordinate of a difference, m.
  ///
  /// Let M bound the coordinates and E the absolute terms of the two offsets. The offsets are off
  /// by at most γ(3) E (a product and two sums) and their difference by another u E; that of the
  /// positions is at most M + E, off by at most u of that; and the last sum by u M. Together less
  /// than 2 u M + 6 u E; products that underflow cost less than eight times the smallest number.
  double error() const {
    return (2 * u * largest_ + 7 * u * offsets_) + 8 * std::numeric_limits<double>::denorm_min();
  }
  // [/difference-error]

  // [certain-volume]
  /// The sign of the exact wᵢ · (wⱼ × wₖ) if it is certain, else 0.
  ///
  /// Let M bound the coordinates and e their errors, both of the computed and of the exact
  /// differences. Each of six products of three computed coordinates has at most eight roundings on
  /// its path to the sum: 6 γ(8) M³. Exact instead of computed coordinates change each product by
  /// at most 3 e M². Together less than M² (49 u M + 18 e), and the factor 1 + 2^-20 covers the
  /// rounding of this bound. Sizes are brought near 1 by a power of two, so nothing overflows, and
  /// underflow is far below u M³.
  int certain_sign_of_volume(std::size_t i, std::size_t j, std::size_t k) const {
    const double scale = to_range();
    const double e = error() * scale, m = largest_ * scale + e;
    if (!(m > 0x1p-300 && m < 0x1p300)) return 0;
    const double volume = (w_[i] * scale).dot((w_[j] * scale).eval().cross((w_[k] * scale).eval()));
    const double bound = m * m * (49 * u * m + 18 * e) * (1 + 0x1p-20);
    return volume > bound ? 1 : (volume < -bound ? -1 : 0);
  }

  /// Whether four differences certainly have the origin in the interior of their tetrahedron: it is
  /// on the inner side of each face.
  bool certainly_surround() const {
    if (count_ != 4) return false;
    const int sign = certain_sign_of_volume(1, 2, 3);
    return sign != 0 && certain_sign_of_volume(0, 2, 3) == -sign &&
           certain_sign_of_volume(0, 1, 3) == sign && certain_sign_of_volume(0, 1, 2) == -sign;
  }
  // [/certain-volume]

  // [distance-up]
  /// An upper bound of |Σ λᵢ wᵢ| / Σ λᵢ for the exact differences; ∞ if a weight is negative or not
  /// finite, their sum is 0 or out of range, or a difference overflows.
  ///
  /// The length of a vector whose coordinates are off by at most d is off by at most √3 d < 2 d. A
  /// coordinate of Σ λᵢ wᵢ has at most seven roundings, so it is off by at most (γ(7) M + e) Σ λᵢ;
  /// length, sum and quotient by γ(12) of themselves. 16 u of either is more. Sizes are brought
  /// near 1 by a power of two s; 2^-600/s covers all underflow but that of the last quotient.
  double distance_up(const std::array<double, 6>& weights) const {
    const double scale = to_range();
    Vector3<double> sum = Vector3<double>::Zero();
    double of_weights = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (!(weights[i] >= 0)) return std::numeric_limits<double>::infinity();
      sum += w_[i] * scale * weights[i];
      of_weights += weights[i];
    }
    const bool in_range = of_weights > 0x1p-100 && of_weights < 0x1p100 && std::isfinite(largest_);
    if (!in_range) return std::numeric_limits<double>::infinity();
    const double size = sum.cwiseAbs().maxCoeff();
    const double length = size > 0x1p-500 ? std::sqrt(sum.dot(sum)) : 2 * size;
    const double room = 2 * scale * (error() + 16 * u * largest_);
    const double bound = ((length / of_weights + room) * (1 + 16 * u) + 0x1p-600) / scale;
    return scale > 1 ? bound + std::numeric_limits<double>::denorm_min() : bound;
  }
  // [/distance-up]

 private:
  static constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  double offsets_;
  double largest_ = 0;
  std::size_t count_ = 0;
  std::array<Vector3<double>, 6> w_;

  /// A power of two that brings the largest coordinate near 1, if it is so large or small that
  /// products of three would over- or underflow; else 1.
  double to_range() const {
    if ((largest_ > 0x1p-250 && largest_ < 0x1p250) || !(largest_ > 0)) return 1;
    if (!std::isfinite(largest_)) return 1;
    return std::ldexp(1.0, std::clamp(-std::ilogb(largest_), -1000, 1000));
  }
};

}  // namespace contact::detail
