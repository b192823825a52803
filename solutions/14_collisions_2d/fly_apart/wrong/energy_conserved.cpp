// misconception: energy-taken-for-conserved
// caught by: from rest the two pieces leave in opposite directions
// seen: L20, slide "Elastic Collisions"
//   its example is a nuclear decay
#include "fly_apart.hpp"

namespace exercise {

Remainder send_out(double mass, const Eigen::Vector2d& velocity, double piece_mass,
                   const Eigen::Vector2d& piece_velocity) {
  if (!(piece_mass > 0 && piece_mass < mass)) {
    throw std::invalid_argument("a piece weighs more than nothing and less than the whole");
  }
  const double rest_mass = mass - piece_mass;
  const Eigen::Vector2d rest = (mass * velocity - piece_mass * piece_velocity) / rest_mass;
  return {rest, 0};
}

}  // namespace exercise
