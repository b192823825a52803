/// @file
/// Exercise: a nucleus that sends out a piece of itself.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// What is left of a body that has sent out a piece.
struct Rest {
  Eigen::Vector2d velocity;  ///< of what is left, m/s
  double energy_gained;      ///< kinetic energy of both afterwards less that of the whole before, J
};

/// The motion of what is left of a body that has sent out one piece. No force acts from outside.
///
/// @param mass of the whole, kg
/// @param velocity of the whole before, m/s
/// @param piece_mass kg, greater than 0 and less than mass
/// @param piece_velocity of the piece afterwards, m/s
/// @throws std::invalid_argument unless piece_mass is greater than 0 and less than mass
Rest send_out(double mass, const Eigen::Vector2d& velocity, double piece_mass,
              const Eigen::Vector2d& piece_velocity);

}  // namespace exercise
