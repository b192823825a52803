// misconception: mass-not-refused
// caught by: an invalid mass of the piece is refused
// seen: https://github.com/notgiven688/jitterphysics2/issues/55
//   an invalid mass gives NaN velocities
#include "fly_apart.hpp"

namespace exercise {

Remainder send_out(double mass, const Eigen::Vector2d& velocity, double piece_mass,
                   const Eigen::Vector2d& piece_velocity) {
  const double rest_mass = mass - piece_mass;
  const Eigen::Vector2d rest = (mass * velocity - piece_mass * piece_velocity) / rest_mass;
  const double before = mass * velocity.squaredNorm() / 2;
  const double after =
      piece_mass * piece_velocity.squaredNorm() / 2 + rest_mass * rest.squaredNorm() / 2;
  return {rest, after - before};
}

}  // namespace exercise
