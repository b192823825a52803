// misconception: updated-too-early
// caught by: one in, one out
// seen: https://github.com/hunar4321/particle-life/issues/18
//   later rules see what earlier ones have changed
#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& row) {
  std::vector<double> v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  for (int round = 0; round < 1000; ++round) {
    std::size_t fastest = 0;
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      if (v[i] - v[i + 1] > v[fastest] - v[fastest + 1]) fastest = i;
    }
    if (row.size() < 2 || !(v[fastest] > v[fastest + 1])) break;
    const double mass = row[fastest].mass + row[fastest + 1].mass;
    v[fastest] -= 2 * (v[fastest] - v[fastest + 1]) * row[fastest + 1].mass / mass;
    v[fastest + 1] += 2 * (v[fastest] - v[fastest + 1]) * row[fastest].mass / mass;
  }
  return v;
}

}  // namespace exercise
