/// @file
/// Polygons of the plane: the type, its area and orientation, whether it is convex; and the
/// orientation of three points as the other headers of the chapter ask for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/orientation.hpp>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace contact {

/// A closed polygon: its vertices in order; the last edge leads from the last vertex to the first.
/// It may be clockwise or counter-clockwise, concave, and may cross or touch itself, unless a
/// function says otherwise.
///
/// Vertices must be finite. A vertex that is not is a wrong program: the functions of this chapter
/// still return without undefined behaviour, but what they return means nothing.
template <Ring S>
using Polygon = std::vector<Vector2<S>>;

/// A polygon with holes: the holes are in the outer polygon and do not overlap.
template <Ring S>
struct PolygonWithHoles {
  Polygon<S> outer;               ///< m, either orientation
  std::vector<Polygon<S>> holes;  ///< m, either orientation
};

/// Where a point is, relative to a region. On means exactly on an edge or at a vertex.
enum class Where { outside, on, inside };

/// Calls edge(a, b) for each edge from a to b, in order. A single vertex has an edge of length 0.
/// Without vertices there is no call. Coordinates are passed on, finite or not.
template <Ring S, class Edge>
void for_each_edge(const Polygon<S>& polygon, const Edge& edge) {
  if (polygon.empty()) return;
  const Vector2<S>* a = &polygon.back();
  for (const Vector2<S>& b : polygon) {
    edge(*a, b);
    a = &b;
  }
}

/// The polygon with its vertices in the opposite order, so that its orientation is the other.
/// Coordinates are moved, finite or not; no vertices stay none.
template <Ring S>
Polygon<S> reversed(Polygon<S> polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// The polygon without vertices that are equal to the one before them. Of vertices that are all
/// equal, one is left. A vertex with NaN equals none, so it stays.
template <Ring S>
Polygon<S> without_repeats(Polygon<S> polygon) {
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  return polygon;
}

namespace polygon_detail {

/// A vector as doubles: unchanged. A wider type would be rounded, so there is none for it.
template <std::floating_point S>
Vector2<double> in_double(const Vector2<S>& v) {
  static_assert(std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits,
                "polygons are of float or double: a wider type would be rounded");
  return v.template cast<double>();
}

/// A vector as exact numbers.
inline Vector2<Exact> in_exact(const Vector2<double>& v) { return {Exact(v.x()), Exact(v.y())}; }

// [side-in-doubt]
/// The orientation of a, b, c where the filter is not certain.
///
/// First the four differences with their rounding errors. On a grid, and wherever the points are of
/// similar size, there are none: then the rounded products decide (rounding is monotonic), and if
/// these are equal, their rounding errors. Otherwise the products' rounding errors and the products
/// with the differences' errors are added. What is then left out or rounded, with M = |left| +
/// |right|: the products of two errors, u² M; three additions of errors, 3u² M; four products and
/// three additions, 6u² M; the sum of both parts, 4u² M. That is 14u² M, and 16u² M leaves room.
/// The last addition is rounded without changing the sign. Products of such numbers are 0 or at
/// least 2^-600, so underflow in the small terms is far below the room. Integers decide the
/// rest.
[[gnu::noinline]] inline int side_in_doubt(const Vector2<double>& a, const Vector2<double>& b,
                                           const Vector2<double>& c) {
  using namespace orientation_detail;
  const auto [abx, abx_error] = two_sum(b.x(), -a.x());
  const auto [aby, aby_error] = two_sum(b.y(), -a.y());
  const auto [acx, acx_error] = two_sum(c.x(), -a.x());
  const auto [acy, acy_error] = two_sum(c.y(), -a.y());
  if (moderate(abx) && moderate(aby) && moderate(acx) && moderate(acy)) {
    const auto [left, left_error] = two_product(abx, acy);
    const auto [right, right_error] = two_product(aby, acx);
    if (abx_error == 0 && aby_error == 0 && acx_error == 0 && acy_error == 0) {
      return left != right ? sign_of(left - right) : sign_of(left_error - right_error);
    }
    constexpr double sixteen_u2 = 0x1p-102;
    const auto [difference, difference_error] = two_sum(left, -right);
    const double of_products = left_error - right_error + difference_error;
    const double of_differences =
        (abx * acy_error + acy * abx_error) - (aby * acx_error + acx * aby_error);
    const double sum = difference + (of_products + of_differences);
    if (std::abs(sum) > sixteen_u2 * (std::abs(left) + std::abs(right))) return sign_of(sum);
  }
  if (!all_finite(a) || !all_finite(b) || !all_finite(c)) return 0;
  return orient_2d_in_doubt(a, b, c);
}
// [/side-in-doubt]

/// The sign of `orientation`, right for every finite input; 0 for points that are not finite.
inline int side(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  const int certain = bounded_orientation(a, b, c).certain_sign();
  return certain != 0 ? certain : side_in_doubt(a, b, c);
}
/// The same for points of floats.
inline int side(const Vector2<float>& a, const Vector2<float>& b, const Vector2<float>& c) {
  return side(in_double(a), in_double(b), in_double(c));
}

/// Whether p is in the smallest box with sides along the axes that contains a and b; the sides
/// belong to it.
template <Ring S>
bool in_box(const Vector2<S>& a, const Vector2<S>& b, const Vector2<S>& p) {
  const auto between = [](const S& low, const S& high, const S& x) {
    return (low <= x && x <= high) || (high <= x && x <= low);
  };
  return between(a.x(), b.x(), p.x()) && between(a.y(), b.y(), p.y());
}

}  // namespace polygon_detail

// [doubled-area]
/// Twice the signed area, m²: positive if the polygon is counter-clockwise. A polygon that crosses
/// itself counts each region as often as it winds around it.
///
/// Limits: rounded, with an error of a few n u Σ|terms|; vertices are taken relative to the first,
/// so the distance from the origin costs no digits. With S = Exact it is exact. Fewer than three
/// vertices give 0. Overflow, or a coordinate that is not finite, gives ±∞ or NaN.
template <Ring S>
S doubled_area(const Polygon<S>& polygon) {
  S sum = S(0);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum = sum + orientation<S>(polygon[0], polygon[i - 1], polygon[i]);
  }
  return sum;
}
// [/doubled-area]

/// The sign of the area: +1 counter-clockwise, −1 clockwise, 0 if the area is exactly 0. Right for
/// every finite input; 0 for fewer than three vertices, and if a coordinate is not finite.
///
/// The bound: each triangle has the bound of `bounded_orientation`, and each of n additions adds
/// half an ulp of a partial sum, which is at most the sum of all magnitudes. Overflow makes the
/// bound infinite or NaN.
template <std::floating_point S>
int area_sign(const Polygon<S>& polygon) {
  using polygon_detail::in_double;
  if (polygon.size() < 3) return 0;
  const Vector2<double> first = in_double(polygon[0]);
  double sum = 0, bound = 0, magnitude = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Bounded triangle =
        bounded_orientation(first, in_double(polygon[i - 1]), in_double(polygon[i]));
    sum += triangle.value;
    bound += triangle.bound;
    magnitude += std::abs(triangle.value);
  }
  const double rounding =
      static_cast<double>(polygon.size()) * std::numeric_limits<double>::epsilon();
  const Bounded area{sum, (bound + magnitude * rounding) * (1 + 2 * rounding)};
  if (area.certain_sign() != 0) return area.certain_sign();
  Polygon<Exact> exact;
  for (const Vector2<S>& v : polygon) {
    if (!all_finite(v)) return 0;
    exact.push_back(polygon_detail::in_exact(in_double(v)));
  }
  return doubled_area<Exact>(exact).sign();
}

// [is-convex]
/// Whether a polygon is convex: its boundary turns only one way, and once around.
///
/// Vertices on a straight edge and repeated vertices are allowed. A polygon without area, a spike
/// and a pentagram are not convex. Right for every finite input. With a coordinate that is not
/// finite, either answer is possible.
///
/// All vertices must turn the same way. That alone accepts a pentagram, which turns twice. So the
/// direction of the edges is watched as well: along a boundary that turns once it points to larger
/// x (or straight up) for one stretch and to smaller x (or straight down) for another.
template <std::floating_point S>
bool is_convex(const Polygon<S>& given) {
  const Polygon<S> polygon = without_repeats(given);
  const std::size_t n = polygon.size();
  if (n < 3) return false;
  const auto forward = [](const Vector2<S>& a, const Vector2<S>& b) {
    return b.x() > a.x() || (b.x() == a.x() && b.y() > a.y());
  };
  int orientation = 0, reversals = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2<S>&a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    const int turn = polygon_detail::side(a, b, c);
    if (turn * orientation < 0) return false;
    if (turn != 0) orientation = turn;
    if (forward(a, b) != forward(b, c)) ++reversals;
  }
  return orientation != 0 && reversals == 2;
}
// [/is-convex]

}  // namespace contact
