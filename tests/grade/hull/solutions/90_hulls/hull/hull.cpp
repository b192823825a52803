#include "hull.hpp"

namespace exercise {

// Andrew's monotone chain.
std::vector<int> hull(const std::vector<Eigen::Vector2d>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) -> const Eigen::Vector2d& {
    return points[static_cast<std::size_t>(i)];
  };
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::pair(at(i).x(), at(i).y()) < std::pair(at(j).x(), at(j).y());
  });
  std::vector<int> chain;
  const auto add = [&](int i, std::size_t least) {
    while (chain.size() >= least + 2) {
      const Eigen::Vector2d u = at(chain.back()) - at(chain[chain.size() - 2]);
      const Eigen::Vector2d v = at(i) - at(chain.back());
      if (u.x() * v.y() - u.y() * v.x() > 0) break;
      chain.pop_back();
    }
    chain.push_back(i);
  };
  for (const int i : order) add(i, 0);
  const std::size_t lower = chain.size() - 1;
  for (auto i = order.rbegin() + 1; i != order.rend(); ++i) add(*i, lower);
  chain.pop_back();
  return chain;
}

}  // namespace exercise
