// misconception: all-pairs-at-once
// caught by: balls that come in from both sides
// seen: https://github.com/keenon/nimblephysics/issues/143
//   two collisions of one ball at once double the energy
#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& row) {
  std::vector<double> v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  for (int round = 0; round < 1000; ++round) {
    const std::vector<double> old = v;
    bool any = false;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      if (!(old[i] > old[i + 1])) continue;
      any = true;
      const double change = 2 * (old[i] - old[i + 1]);
      const double mass = row[i].mass + row[i + 1].mass;
      v[i] -= change * row[i + 1].mass / mass;
      v[i + 1] += change * row[i].mass / mass;
    }
    if (!any) break;
  }
  return v;
}

}  // namespace exercise
