#include "fly_apart.hpp"

namespace exercise {

Remainder send_out(double mass, const Eigen::Vector2d& velocity, double piece_mass,
                   const Eigen::Vector2d& piece_velocity) {
  //? Without mass the piece is none, and with all of it nothing remains to have a velocity.
  //? gap: piece_mass < mass
  if (!(piece_mass > 0 && piece_mass < mass)) {
    throw std::invalid_argument("a piece weighs more than nothing and less than the whole");
  }
  //? What remains has the mass that the piece does not have.
  //? gap: mass - piece_mass
  const double rest_mass = mass - piece_mass;
  //? Momentum is conserved: the remainder has the momentum of the whole without that of the piece.
  //? gap: mass * velocity - piece_mass * piece_velocity
  const Eigen::Vector2d rest = (mass * velocity - piece_mass * piece_velocity) / rest_mass;
  //? The kinetic energy before needs only the square of the speed.
  //? gap: velocity.squaredNorm()
  const double before = mass * velocity.squaredNorm() / 2;
  //? Afterwards it is the sum over both pieces.
  const double after =
      piece_mass * piece_velocity.squaredNorm() / 2 + rest_mass * rest.squaredNorm() / 2;
  //? The difference is the energy that the explosion must supply.
  //? gap: after - before
  return {rest, after - before};
}

}  // namespace exercise
