#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& row) {
  //? Only the velocities change, so they are copied.
  std::vector<double> v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  //? One collision can cause the next, so this goes on until none is left.
  while (true) {
    //? The search for a maximum begins with the first pair.
    std::size_t fastest = 0;
    //? Of all neighbours the pair with the largest closing velocity collides first.
    //? gap: v[i] - v[i + 1] > v[fastest] - v[fastest + 1]
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      if (v[i] - v[i + 1] > v[fastest] - v[fastest + 1]) fastest = i;
    }
    //? If even this pair does not approach, no pair does.
    //? gap: !(v[fastest] > v[fastest + 1])
    if (row.size() < 2 || !(v[fastest] > v[fastest + 1])) break;
    //? In an elastic collision the relative velocity is reversed, so it changes by twice its value.
    //? gap: 2 * (v[fastest] - v[fastest + 1])
    const double change = 2 * (v[fastest] - v[fastest + 1]);
    const double mass = row[fastest].mass + row[fastest + 1].mass;
    //? Each ball takes the share of the other's mass: the impulses are equal and opposite.
    //? gap: change * row[fastest + 1].mass / mass
    v[fastest] -= change * row[fastest + 1].mass / mass;
    v[fastest + 1] += change * row[fastest].mass / mass;
  }
  //? No pair approaches any more: the row has settled.
  return v;
}

}  // namespace exercise
