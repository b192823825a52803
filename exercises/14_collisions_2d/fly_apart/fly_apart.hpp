/// @file
/// Exercise: a nucleus that emits a piece of itself.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The remainder of a body that has emitted a piece.
struct Remainder {
  Eigen::Vector2d velocity;  ///< of the remainder, m/s
  double energy_gained;  ///< kinetic energy of both afterwards minus that of the whole before, J
};

/// The motion of the remainder of a body that has emitted one piece. No external force acts.
///
/// @param mass of the whole, kg
/// @param velocity of the whole before, m/s
/// @param piece_mass kg, greater than 0 and less than mass
/// @param piece_velocity of the piece afterwards, m/s
/// @throws std::invalid_argument unless piece_mass is greater than 0 and less than mass
Remainder send_out(double mass, const Eigen::Vector2d& velocity, double piece_mass,
                   const Eigen::Vector2d& piece_velocity);

}  // namespace exercise
