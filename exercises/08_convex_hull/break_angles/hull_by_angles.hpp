/// @file
/// Code to break: a hull by Graham's scan.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The vertices of the convex hull, by index, counter-clockwise from the lowest (and of those the
/// leftmost). A point on an edge, between two vertices, should be no vertex.
///
/// @param points different from one another, not all on one line
inline std::vector<int> hull_by_angles(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return {};
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  std::vector<int> order;
  for (std::size_t i = 0; i < points.size(); ++i) order.push_back(static_cast<int>(i));
  std::swap(order.front(), *std::min_element(order.begin(), order.end(), [&](int i, int j) {
              return at(i).y() < at(j).y() || (at(i).y() == at(j).y() && at(i).x() < at(j).x());
            }));

  const Eigen::Vector2d lowest = at(order.front());
  std::vector<double> angle;
  for (const Eigen::Vector2d& p : points)
    angle.push_back(std::atan2(p.y() - lowest.y(), p.x() - lowest.x()));
  std::stable_sort(order.begin() + 1, order.end(), [&](int i, int j) {
    return angle[static_cast<std::size_t>(i)] < angle[static_cast<std::size_t>(j)];
  });

  std::vector<int> hull;
  for (const int next : order) {
    while (hull.size() >= 2) {
      const Eigen::Vector2d a = at(hull[hull.size() - 2]);
      const Eigen::Vector2d ab = at(hull.back()) - a, ac = at(next) - a;
      if (ab.x() * ac.y() - ab.y() * ac.x() > 0) break;  // a left turn
      hull.pop_back();
    }
    hull.push_back(next);
  }
  return hull;
}

}  // namespace given
