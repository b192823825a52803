#include "hull_2d.hpp"

#include <algorithm>

namespace exercise {
namespace {

double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

std::vector<int> hull_2d(const std::vector<Eigen::Vector2d>& points) {
  //? The answer consists of indices, so indices are sorted instead of points.
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  //? Sorted by x and then by y, the first point and the last are certainly vertices of the hull.
  //? gap: points[i].x() < points[j].x()
  //? gap: points[i].y() < points[j].y()
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (points[i].x() != points[j].x()) return points[i].x() < points[j].x();
    if (points[i].y() != points[j].y()) return points[i].y() < points[j].y();
    return i < j;
  });
  //? Of equal points one is enough. After sorting they follow one another.
  //? gap: points[i] == points[j]
  const auto same = [&](std::size_t i, std::size_t j) { return points[i] == points[j]; };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  //? One or two points are their own hull.
  //? gap: order.size() < 3
  if (order.size() < 3) return {order.begin(), order.end()};
  //? The walk appends to the hull, and removes again what turned out to be inside.
  std::vector<int> hull;
  const auto walk = [&](auto first, auto last) {
    //? The second walk must not remove vertices of the first.
    const std::size_t start = hull.size();
    //? Each step looks at the last two vertices so far.
    for (; first != last; ++first) {
      const auto at = [&](std::size_t back) {
        return points[static_cast<std::size_t>(hull[hull.size() - back])];
      };
      //? While the last two vertices and the new point do not make a left turn, the last vertex is
      //? not on the hull. A zero means on one line, and is removed too.
      //? gap: area(at(2), at(1), points[*first]) <= 0
      while (hull.size() >= start + 2 && area(at(2), at(1), points[*first]) <= 0) hull.pop_back();
      //? The new point is a vertex as far as is known.
      hull.push_back(static_cast<int>(*first));
    }
    //? The last point of one walk is the first of the other.
    hull.pop_back();
  };
  //? From left to right the walk makes the lower chain.
  //? gap: order.begin(), order.end()
  walk(order.begin(), order.end());
  //? Back from right to left it makes the upper chain, so the whole hull is counterclockwise.
  //? gap: order.rbegin(), order.rend()
  walk(order.rbegin(), order.rend());
  //? Both chains together are the hull.
  return hull;
}

}  // namespace exercise
