#include "sort_and_sweep.hpp"

namespace exercise {

std::vector<int> order_along_x(const std::vector<Box>& boxes) {
  //? Indices are sorted, and the boxes stay where they are.
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  //? Equal starts leave the indices to decide, so the order is the only one.
  //? gap: i < j
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    const double x = boxes[static_cast<std::size_t>(i)].low.x(),
                 y = boxes[static_cast<std::size_t>(j)].low.x();
    return x < y || (x == y && i < j);
  });
  return order;
}

Swept sort_and_sweep(const std::vector<Box>& boxes) {
  //? Each box meets those that start after it, in their order.
  Swept swept{{}, 0};
  const std::vector<int> order = order_along_x(boxes);
  for (std::size_t first = 0; first < order.size(); ++first) {
    for (std::size_t next = first + 1; next < order.size(); ++next) {
      //? All that follow start even later, so none of them has a point in common either.
      //? gap: b.low.x() > a.high.x()
      const Box &a = boxes[static_cast<std::size_t>(order[first])],
                &b = boxes[static_cast<std::size_t>(order[next])];
      if (b.low.x() > a.high.x()) break;
      //? Their intervals along x have a common point, so those along y decide.
      //? gap: a.low.y() <= b.high.y() && b.low.y() <= a.high.y()
      //? gap: std::minmax(order[first], order[next])
      ++swept.compared;
      const auto [i, j] = std::minmax(order[first], order[next]);
      if (a.low.y() <= b.high.y() && b.low.y() <= a.high.y()) swept.touching.push_back({i, j});
    }
  }
  //? The sweep found them in the order of their starts.
  //? gap: swept.touching.end()
  std::sort(swept.touching.begin(), swept.touching.end());
  return swept;
}

}  // namespace exercise
