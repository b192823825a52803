/// @file
/// Three ways to update velocities in a collision, and their effect on the total momentum.
#pragma once

#include <cmath>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/impulse.hpp>
#include <vector>

namespace contact {

/// How the velocities after an elastic collision on a line are computed.
enum class MomentumUpdate {
  formulas,  ///< each new velocity from its own formula
  impulses,  ///< one impulse, added to one body and subtracted from the other
  grid       ///< the same with momenta and impulses that are whole multiples of a unit
};

/// A body on a line. Make it with momentum_body().
template <std::floating_point S>
struct MomentumBody {
  S mass = S(1);      ///< kg, greater than 0
  S velocity = S(0);  ///< m/s
  S momentum = S(0);  ///< N·s, a multiple of the unit; only MomentumUpdate::grid updates it
};

// [on-grid]
/// The whole multiple of the unit that is nearest to x (ties to even).
///
/// Sums of such multiples have no rounding error while they stay below 2^p units, p = 24 in single
/// and 53 in double precision.
/// @param unit a power of two, such that x / unit neither overflows nor underflows
template <std::floating_point S>
S on_grid(S x, S unit) {
  return std::nearbyint(x / unit) * unit;
}
// [/on-grid]

/// A body whose momentum is the multiple of the unit nearest to the given one, and whose velocity
/// is that momentum over its mass.
/// @param mass kg, greater than 0
/// @param momentum N·s
/// @param unit N·s, a power of two
template <std::floating_point S>
MomentumBody<S> momentum_body(S mass, S momentum, S unit) {
  const S kept = on_grid(momentum, unit);
  return {mass, kept / mass, kept};
}

// [collide]
/// An elastic collision of two bodies on a line: their velocities are reflected about that of the
/// common centre of mass, whether they approach or not.
///
/// With MomentumUpdate::formulas and MomentumUpdate::impulses rounding changes the total momentum,
/// by some u of m|v| and of the impulse (u the unit roundoff). With MomentumUpdate::grid it does
/// not change, as long as each momentum and impulse stays below 2^p units.
/// @param unit N·s, for MomentumUpdate::grid alone: a power of two
/// @see *Interaction and Normals*, slide "Conservation of Momentum and Newton's Third Law"
template <std::floating_point S>
void collide_with_update(MomentumBody<S>& a, MomentumBody<S>& b, MomentumUpdate update, S unit) {
  if (update == MomentumUpdate::formulas) {
    const S before_a = a.velocity;
    const S together = a.mass + b.mass;
    a.velocity = ((a.mass - b.mass) * a.velocity + S(2) * b.mass * b.velocity) / together;
    b.velocity = ((b.mass - a.mass) * b.velocity + S(2) * a.mass * before_a) / together;
    return;
  }
  S impulse = S(2) * (a.velocity - b.velocity) * (a.mass * b.mass / (a.mass + b.mass));
  if (update == MomentumUpdate::impulses) {
    a.velocity = velocity_after(a.mass, a.velocity, S(-impulse));
    b.velocity = velocity_after(b.mass, b.velocity, impulse);
    return;
  }
  impulse = on_grid(impulse, unit);
  a.momentum -= impulse;  // exact, as is the next line
  b.momentum += impulse;
  a.velocity = a.momentum / a.mass;
  b.velocity = b.momentum / b.mass;
}
// [/collide]

/// The total momentum without rounding: of m v, or with MomentumUpdate::grid of the stored momenta.
/// All numbers must be finite.
template <std::floating_point S>
Exact stored_momentum(const std::vector<MomentumBody<S>>& bodies, MomentumUpdate update) {
  Exact sum;
  for (const MomentumBody<S>& body : bodies) {
    sum += update == MomentumUpdate::grid ? Exact(double(body.momentum))
                                          : Exact(double(body.mass)) * Exact(double(body.velocity));
  }
  return sum;
}

}  // namespace contact
