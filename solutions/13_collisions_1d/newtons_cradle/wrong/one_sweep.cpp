// misconception: one-sweep
// caught by: one in, one out
// seen: https://github.com/erincatto/box3d/issues/83 a second pass over the contacts made it better
#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& row) {
  std::vector<double> v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    if (!(v[i] > v[i + 1])) continue;
    const double change = 2 * (v[i] - v[i + 1]);
    const double mass = row[i].mass + row[i + 1].mass;
    v[i] -= change * row[i + 1].mass / mass;
    v[i + 1] += change * row[i].mass / mass;
  }
  return v;
}

}  // namespace exercise
