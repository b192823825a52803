/// @file
/// The convex hull of points in the plane.
#pragma once

#include <algorithm>
#include <contact/invalid_argument.hpp>
#include <contact/orientation.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace contact {

// [monotone-chain]
/// The vertices of the hull of the points, by index, counter-clockwise from the one with the least
/// x (and of those the least y), by Andrew's monotone chain.
///
/// The orientation predicate is a parameter: `orientation(i, j, k)` is positive if the path over
/// the points i, j, k turns left, and 0 if it is straight. Points at which it is straight are no
/// vertices.
///
/// @param points m; of equal points the first one represents all
template <Ring S, class Orientation>
std::vector<int> monotone_chain(const std::vector<Vector2<S>>& points,
                                const Orientation& orientation) {
  const auto at = [&points](int i) -> const Vector2<S>& {
    return points[static_cast<std::size_t>(i)];
  };
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&at](int i, int j) {
    if (at(i).x() != at(j).x()) return at(i).x() < at(j).x();
    if (at(i).y() != at(j).y()) return at(i).y() < at(j).y();
    return i < j;
  });
  const auto same = [&at](int i, int j) { return at(i) == at(j); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  if (order.size() < 3) return order;

  std::vector<int> chain;
  const auto walk = [&chain, &orientation](auto first, auto last) {
    const std::size_t start = chain.size();
    for (auto i = first; i != last; ++i) {
      while (chain.size() >= start + 2 &&
             !(orientation(chain[chain.size() - 2], chain.back(), *i) > 0)) {
        chain.pop_back();
      }
      chain.push_back(*i);
    }
    chain.pop_back();  // it is the first of the other half
  };
  walk(order.begin(), order.end());
  walk(order.rbegin(), order.rend());
  return chain;
}
// [/monotone-chain]

/// Throws std::invalid_argument that names the first point with a coordinate that is not finite.
template <int Size>
void require_finite_points(const std::vector<Eigen::Matrix<double, Size, 1>>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!all_finite(points[i])) {
      require_finite(("points[" + std::to_string(i) + "]").c_str(), points[i]);
    }
  }
}

// [convex-hull-2d]
/// The vertices of the convex hull, by index, counter-clockwise, with every decision exact.
///
/// The first vertex is the one with the least x, and of those the least y. A point on an edge, or
/// equal to an earlier one, is no vertex. No points give no vertices; points that are all equal
/// give one, the first; points on a line give the two ends.
///
/// @param points m, any number; throws std::invalid_argument unless all are finite
///
/// Limits: none; the time is that of sorting, O(n log n).
///
/// Source: Andrew, Another Efficient Algorithm for Convex Hulls in Two Dimensions, 1979.
inline std::vector<int> convex_hull_2d(const std::vector<Vector2<double>>& points) {
  require_finite_points(points);
  return monotone_chain(points, [&points](int i, int j, int k) {
    const auto at = [&points](int index) -> const Vector2<double>& {
      return points[static_cast<std::size_t>(index)];
    };
    return orient_2d(at(i), at(j), at(k));
  });
}
// [/convex-hull-2d]

/// The same with the orientation as the scalar rounds it; values within `epsilon` of zero count as
/// straight. For comparison only: vertices may be lost, and the result may be no hull.
template <Scalar S>
std::vector<int> convex_hull_2d_rounded(const std::vector<Vector2<S>>& points, S epsilon = S(0)) {
  return monotone_chain(points, [&points, epsilon](int i, int j, int k) {
    const auto at = [&points](int index) -> const Vector2<S>& {
      return points[static_cast<std::size_t>(index)];
    };
    const S area = orientation<S>(at(i), at(j), at(k));
    return area > epsilon ? 1 : (area < -epsilon ? -1 : 0);
  });
}

}  // namespace contact
