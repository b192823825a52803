// misconception: none
// caught by: the vertices come counter-clockwise from the leftmost
#include "hull_2d.hpp"

#include <algorithm>

namespace exercise {
namespace {

double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

std::vector<int> hull_2d(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (points[i].x() != points[j].x()) return points[i].x() < points[j].x();
    if (points[i].y() != points[j].y()) return points[i].y() < points[j].y();
    return i < j;
  });
  const auto same = [&](std::size_t i, std::size_t j) { return points[i] == points[j]; };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  if (order.size() < 3) return {order.begin(), order.end()};
  std::vector<int> hull;
  const auto walk = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
      const auto at = [&](std::size_t back) {
        return points[static_cast<std::size_t>(hull[hull.size() - back])];
      };
      while (hull.size() >= start + 2 && area(at(2), at(1), points[*first]) <= 0) hull.pop_back();
      hull.push_back(static_cast<int>(*first));
    }
    hull.pop_back();
  };
  walk(order.begin(), order.end());
  return hull;
}

}  // namespace exercise
