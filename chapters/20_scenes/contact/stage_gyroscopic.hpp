/// @file
/// A stage: turning with the gyroscopic term, in place of turning with an even spin.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <contact/free_turning.hpp>
#include <contact/rotation.hpp>
#include <contact/stage_rotation.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

// [gyroscopic-stage]
namespace detail {

/// How a body lies that nothing pushes, a time later, by four exponentials of spins on the way: of
/// order 4, and its angular momentum stays as it is.
///
/// Source: Celledoni, Marthinsen and Owren, *Commutator-free Lie group methods*, Future Generation
/// Computer Systems 19 (2003).
inline Rotor<double> free_turn(const Rotor<double>& q, const Vector3<double>& momentum,
                               const SteppedBody& body, double h) {
  const auto spin_at = [&](const Rotor<double>& r) {
    return free_spin<double>(momentum, body.moments, Matrix3<double>(matrix_of(r) * body.axes));
  };
  const Vector3<double> k1 = spin_at(q);
  const Rotor<double> half = exponential<double>(k1 * (h / 2)) * q;
  const Vector3<double> k2 = spin_at(half);
  const Vector3<double> k3 = spin_at(exponential<double>(k2 * (h / 2)) * q);
  const Vector3<double> k4 = spin_at(exponential<double>(k3 * h - k1 * (h / 2)) * half);
  const Vector3<double> both = (k2 + k3) * 2;
  const Vector3<double> first = (k1 * 3 + both - k4) * (h / 12);
  const Vector3<double> second = (k4 * 3 + both - k1) * (h / 12);
  return normalised(exponential<double>(second) * (exponential<double>(first) * q));
}

}  // namespace detail

namespace detail {

/// The angular momentum of a body that lies so and spins so, in the world, kg·m²/s.
inline Vector3<double> momentum_of_spin(const SteppedBody& body, const Rotor<double>& q,
                                        const Vector3<double>& spin) {
  const Matrix3<double> principal = matrix_of(q) * body.axes;
  const Vector3<double> seen = principal.transpose() * spin;
  return principal * Vector3<double>(seen.cwiseProduct(body.moments));
}

/// largest_free_square() of a body that lies so and spins so, in the world, rad²/s².
inline double largest_free_square(const SteppedBody& body, const Rotor<double>& q,
                                  const Vector3<double>& spin) {
  const Vector3<double> seen = (matrix_of(q) * body.axes).transpose() * spin;
  return contact::largest_free_square(body.moments, seen);
}

/// How a mover lies after a part of this length: while contacts push, it turns as with the mean of
/// its momenta.
inline Rotor<double> turned_freely(const SteppedSetup& setup, const SteppedState& state,
                                   const StepPart& part, std::size_t i, double length) {
  const SteppedBody& body = setup.bodies[i];
  Rotor<double> q = state.orientation[i];
  const Vector3<double> mean = mean_spin(state, part, i, length);
  if (body.round || mean == Vector3<double>::Zero())
    return normalised(exponential_step(q, mean, length));
  const Vector3<double> momentum = momentum_of_spin(body, q, mean);
  // Where a needle lies a little otherwise, its spin is another by much: as much as its moments
  // differ, and what the fourth order leaves grows with that.
  const double ratio = body.moments.maxCoeff() / body.moments.minCoeff();
  const double fastest = std::sqrt(largest_free_square(body, q, mean) * ratio);
  const double looks = std::ceil(fastest * length / gyroscopic_angle);
  const auto count = static_cast<std::uint64_t>(std::min(std::max(looks, 1.0), 4096.0));
  const double h = length / static_cast<double>(count);
  for (std::uint64_t k = 0; k < count; ++k) q = free_turn(q, momentum, body, h);
  return q;
}

}  // namespace detail

/// Turning with the gyroscopic term: the angular momentum is what contacts leave of it, and the
/// spin follows from how the body lies.
inline void turn_with_gyroscopic_term(const SteppedSetup& setup, SteppedState& state,
                                      StepPart& part) {
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    const SteppedBody& body = setup.bodies[i];
    Vector3<double> spin = detail::pushed_spin(state, part, i, part.length);
    const Rotor<double> turned = detail::turned_freely(setup, state, part, i, part.length);
    if (!body.round && spin != Vector3<double>::Zero()) {
      const Vector3<double> momentum = detail::momentum_of_spin(body, state.orientation[i], spin);
      const Matrix3<double> principal = matrix_of(turned) * body.axes;
      spin = free_spin<double>(momentum, body.moments, principal);
    }
    state.orientation[i] = turned;
    state.spin.set(i, spin);
  }
}
// [/gyroscopic-stage]

}  // namespace contact
