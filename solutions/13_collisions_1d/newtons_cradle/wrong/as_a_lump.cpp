// misconception: row-as-a-lump
// caught by: one in, one out
// seen: https://byjus.com/question-answer/two-identical-balls-marked-2-and-3-in-contact-with-each-other-and-at-rest-1/
//   a test offers that the balls that are hit roll off together
#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& row) {
  std::vector<double> v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  if (row.size() < 2 || !(v[0] > v[1])) return v;
  double mass = 0;
  double momentum = 0;
  for (std::size_t i = 1; i < row.size(); ++i) {
    mass += row[i].mass;
    momentum += row[i].mass * v[i];
  }
  const double change = 2 * (v[0] - momentum / mass);
  v[0] -= change * mass / (row[0].mass + mass);
  for (std::size_t i = 1; i < row.size(); ++i) {
    v[i] = momentum / mass + change * row[0].mass / (row[0].mass + mass);
  }
  return v;
}

}  // namespace exercise
