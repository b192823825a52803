// misconception: swaps-whatever-the-mass
// caught by: a heavy ball among light ones
#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& row) {
  std::vector<double> v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  while (true) {
    std::size_t fastest = 0;
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      if (v[i] - v[i + 1] > v[fastest] - v[fastest + 1]) fastest = i;
    }
    if (row.size() < 2 || !(v[fastest] > v[fastest + 1])) break;
    std::swap(v[fastest], v[fastest + 1]);
  }
  return v;
}

}  // namespace exercise
