/// @file
/// A line in the frame of a wide tree: the numbers with which it is compared with boxes and
/// triangles of floats.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/difference_determinant.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/passage.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>

namespace contact::detail {

/// The planes of four boxes: [low, high][axis][box]. An empty box has low > high.
using FourBoxes = std::array<std::array<std::array<float, 4>, 3>, 2>;

/// Four empty boxes.
constexpr FourBoxes no_boxes() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  FourBoxes boxes{};
  for (std::size_t k = 0; k < 3; ++k) {
    boxes[0][k] = {infinity, infinity, infinity, infinity};
    boxes[1][k] = {-infinity, -infinity, -infinity, -infinity};
  }
  return boxes;
}

/// The frame of a wide tree: x' = (x − centre) · scale, so that the root is in [−1, 1]. The scale
/// is a power of two.
struct WideFrame {
  Vector3<double> centre = Vector3<double>::Zero();
  double scale = 1;
  int exponent = 0;  ///< scale = 2^−exponent

  WideFrame() = default;
  template <FloatOrDouble S>
  explicit WideFrame(const Aabb<S>& root) {
    const Vector3<double> low = root.low.template cast<double>() / 2;
    const Vector3<double> high = root.high.template cast<double>() / 2;
    centre = low + high;
    const double size = (high - low).maxCoeff();
    // The centre is rounded, by as much as half of the size at most.
    exponent = size > 0 ? std::max(std::ilogb(size) + 2, -1000) : -1000;
    scale = std::ldexp(1.0, -exponent);
  }

  /// A plane in the frame, rounded to a float outwards: the value in double is off by u of itself,
  /// the float by another 2^-24.
  float outwards(double x, int k, int side) const {
    const double there = (x - centre[k]) * scale;
    return static_cast<float>(there + side * (0x1p-23 * std::abs(there) + 0x1p-80));
  }
  /// Writes a box as number i of four, rounded outwards.
  template <FloatOrDouble S>
  void put(FourBoxes& boxes, std::size_t i, const Aabb<S>& box) const {
    for (std::size_t k = 0; k < 3; ++k) {
      boxes[0][k][i] = outwards(box.low[int(k)], int(k), -1);
      boxes[1][k][i] = outwards(box.high[int(k)], int(k), 1);
    }
  }
};

// [wide-line]
/// A line in the frame of a wide tree, as x' = o' + τ d' with τ = t · rate − shift.
///
/// d' is the direction times a power of two, with its largest coordinate |d'_k| in [1, 2), and the
/// line starts at τ = 0 at the start or in front of the root, at most 8 from its centre in every
/// coordinate: if it is further, it misses the root. So within the root τ is at most 4, and
/// floats have errors of about 2^-22, whatever the distance of the start.
///
/// The margins. With O' the start in the frame, o' = O' + shift d' is computed in double from two
/// differences and a product, each rounded, and for a segment d' is a rounded difference: off by at
/// most 8 u (|O'| + |shift d'|), u = 2^-53. Two origins in float replace it, one on either side
/// of o' by more than that error and their own rounding: with the one the near planes cannot come
/// too late, with the other the far planes not too early. What remains are relative errors: 1.01 v
/// with v = 2^-24 of the inverse direction, v of the difference, v of the product. So entry ≤ exit
/// (1 + 3.1 v)/(1 − 3.1 v) if the line meets the box, and the factor 1 + 16 v covers that; 2^-120
/// covers underflow. A |d'_k| below 2^-100 counts as 2^-100: the origins are at least 2^-60 apart
/// from o', which is more than the line moves along k, so the slab keeps every line that is in it,
/// for all τ in the root, and no 0 · ∞ arises.
///
/// Source: Ize, *Robust BVH Ray Traversal*, Journal of Computer Graphics Techniques 2 (2013), for
/// the factor; the rest is needed because the boxes are in float and the start is moved.
struct WideLine {
  bool tame = false;    ///< whether the numbers are in a range for floats; else the tree is no help
  bool misses = false;  ///< whether it is certain that the line misses the root
  std::array<float, 3> near_origin{}, far_origin{}, inverse{};
  std::array<std::size_t, 3> near_side{};  ///< 0: the low plane is met first
  double rate = 0, shift = 0;
  float last = 0;  ///< no hit is beyond
  /// On the two axes `across` the line is slope · z + offset, where z is the coordinate `along`,
  /// that in which it is longest.
  std::size_t along = 0;
  std::array<std::size_t, 2> across{};
  std::array<float, 2> slope{}, offset{};
  /// The distance of a point in the root from the line along such an axis, computed in floats, is
  /// off by less than this: see possible_hits.
  float blur = 0;

  /// An upper bound of the τ of a hit with t ≤ latest.
  float after(double latest) const {
    const double at = latest * rate;
    const double tau = (at - shift) + 0x1p-50 * (at + shift);
    return tau < 8 ? static_cast<float>(std::max(tau, 0.0) * (1 + 0x1p-20) + 0x1p-60) : 8.0f;
  }
};

template <class Line>
WideLine wide_line(const Line& line, const WideFrame& frame) {
  WideLine wide;
  const Vector3<double> start = (start_of(line) - frame.centre) * frame.scale;
  Vector3<double> direction = ray_of(line).direction;
  const double longest = direction.cwiseAbs().maxCoeff();
  if (!(start.cwiseAbs().maxCoeff() < 0x1p40 && longest > 0x1p-1000 && longest < 0x1p1000)) {
    return wide;
  }
  const int exponent = difference_detail::stored_exponent(longest) - 1023;
  if (std::abs(exponent - frame.exponent) > 1000) return wide;
  direction *= difference_detail::power_of_two(-exponent);
  wide.rate = difference_detail::power_of_two(exponent - frame.exponent);

  // The longest coordinate decides from where the line can be in the root: not before it is at −2
  // or 2, because from there to −1 or 1 is further than all errors.
  int k = 0;
  direction.cwiseAbs().maxCoeff(&k);
  const double entry = (-std::copysign(2.0, direction[k]) - start[k]) / direction[k];
  wide.shift = std::max(entry, 0.0);
  wide.tame = true;
  Vector3<double> origins;
  double most_error = 0;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double advance = wide.shift * direction[i];
    const double origin = start[i] + advance;
    const double error = 8 * 0x1p-53 * (std::abs(start[i]) + std::abs(advance));
    if (std::abs(origin) > 8) wide.misses = true;
    origins[i] = origin;
    most_error = std::max(most_error, error);
    const double margin = 0x1p-22 * std::abs(origin) + 2 * error + 0x1p-59;
    const bool level = std::abs(direction[i]) < 0x1p-100;
    const double step = level ? 0x1p-100 : direction[i];
    const double forwards = std::copysign(margin, step);  // no branch to mispredict
    wide.near_side[at] = static_cast<std::size_t>(std::signbit(step));
    wide.near_origin[at] = static_cast<float>(origin + forwards);
    wide.far_origin[at] = static_cast<float>(origin - forwards);
    wide.inverse[at] = static_cast<float>(1 / step);
  }
  wide.last = has_end<Line> ? wide.after(1.0) : 8.0f;
  double reach = 0;
  wide.along = static_cast<std::size_t>(k);
  for (std::size_t side = 0; side < 2; ++side) {
    wide.across[side] = (wide.along + 1 + side) % 3;
    const int i = static_cast<int>(wide.across[side]);
    const double slope = direction[i] / direction[k];
    const double offset = origins[i] - slope * origins[k];
    wide.slope[side] = static_cast<float>(slope);
    wide.offset[side] = static_cast<float>(offset);
    reach = std::max(reach, std::abs(offset));
  }
  wide.blur = static_cast<float>(0x1p-23 * (5 + reach) + 4 * most_error);
  return wide;
}
// [/wide-line]

}  // namespace contact::detail
