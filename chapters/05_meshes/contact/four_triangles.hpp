/// @file
/// A leaf of a wide tree: four triangles of floats that a line is compared with together. Most are
/// missed for certain; the others are left to the decision in double.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <contact/exact_ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <contact/wide_line.hpp>
#include <cstddef>
#include <cstdint>

namespace contact::detail {

// [four-triangles]
/// Up to four triangles in the frame of a wide tree, rounded to floats.
struct alignas(32) FourTriangles {
  /// [vertex][axis][triangle]
  std::array<std::array<std::array<float, 4>, 3>, 3> corners{};
  int first = 0;  ///< position in the order of the tree
  int count = 0;

  /// Writes triangle i of four; all of it is in the root's box.
  template <FloatOrDouble S>
  void put(const WideFrame& frame, std::size_t i, const Triangle<S>& triangle) {
    const std::array<const Vector3<S>*, 3> from{&triangle.a, &triangle.b, &triangle.c};
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        const double x = static_cast<double>((*from[v])[axis]) - frame.centre[axis];
        corners[v][k][i] = static_cast<float>(x * frame.scale);
      }
    }
  }
};

/// Which of four triangles the line may meet: bit i for triangle i. The line certainly misses the
/// others, also beyond its ends.
///
/// Along the line everything is projected to the plane of two axes, so that the line becomes 0 and
/// three corners a, b, c. It misses the triangle if a × b, b × c and c × a have different signs.
///
/// The bound, with v = 2^-24. A corner is in [−1, 1] and rounded, and slopes are at most 1: x −
/// slope z is off by 6 v. The offset, of size q, is rounded too, and so is the difference, which is
/// at most 2 + q: `blur` is more than (8 + 2 q) v and what the origins are off. Let T be the sum of
/// the sizes of all six coordinates. The roundings of a × b make at most 2 v (2 + q) T, and those
/// of its factors blur T + 2 blur²: together less than 2 blur (T + blur).
inline unsigned possible_hits(const FourTriangles& four, const WideLine& line) {
  const std::size_t i = line.across[0], j = line.across[1], k = line.along;
  const auto& [a, b, c] = four.corners;
  const float slope_x = line.slope[0], slope_y = line.slope[1];
  const float x0 = line.offset[0], y0 = line.offset[1], blur = line.blur;
  std::array<std::uint32_t, 4> mixed;
  for (std::size_t n = 0; n < 4; ++n) {
    const float ax = (a[i][n] - slope_x * a[k][n]) - x0, ay = (a[j][n] - slope_y * a[k][n]) - y0;
    const float bx = (b[i][n] - slope_x * b[k][n]) - x0, by = (b[j][n] - slope_y * b[k][n]) - y0;
    const float cx = (c[i][n] - slope_x * c[k][n]) - x0, cy = (c[j][n] - slope_y * c[k][n]) - y0;
    const float ab = ax * by - ay * bx, bc = bx * cy - by * cx, ca = cx * ay - cy * ax;
    const float sizes =
        std::abs(ax) + std::abs(ay) + std::abs(bx) + std::abs(by) + std::abs(cx) + std::abs(cy);
    const float room = 3 * blur * (sizes + blur);
    const auto sign = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    const std::uint32_t below = sign(ab + room) | sign(bc + room) | sign(ca + room);
    const std::uint32_t above = sign(room - ab) | sign(room - bc) | sign(room - ca);
    mixed[n] = below & above;
  }
  const auto missed = [&mixed](std::size_t n) { return mixed[n] >> 31 << n; };
  return ((1u << four.count) - 1) & ~(missed(0) | missed(1) | missed(2) | missed(3));
}
// [/four-triangles]

}  // namespace contact::detail
