/// @file
/// Two smooth discs in contact: their line of centres, whether they approach, and their velocities
/// after the collision.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/collision_1d.hpp>
#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/momentum.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A disc without friction, so that no torque acts on it. Make it with disc(), which checks its
/// arguments.
template <Ring S>
struct Disc {
  S mass = S(1);                             ///< kg, greater than 0
  S radius = S(0);                           ///< m, not negative
  Vector2<S> centre = Vector2<S>::Zero();    ///< m
  Vector2<S> velocity = Vector2<S>::Zero();  ///< m/s
};

/// A disc.
/// @param mass kg, greater than 0
/// @param radius m, not negative
/// @param centre m
/// @param velocity m/s
/// @throws std::invalid_argument if the mass is not greater than 0, the radius is negative, or a
/// number is not finite
template <Ring S>
Disc<S> disc(const S& mass, const S& radius, const Vector2<S>& centre, const Vector2<S>& velocity) {
  require_mass("mass", mass);
  require_finite("radius", radius);
  if (radius < S(0)) throw_invalid_argument("radius", number_text(radius), "must not be negative");
  require_finite("centre", centre);
  require_finite("velocity", velocity);
  return {mass, radius, centre, velocity};
}

/// The kinetic energy of a disc, ½ m |v|².
/// @return J; off by at most γ(5) of itself, if nothing underflows
template <Scalar S>
S kinetic_energy(const Disc<S>& d) {
  return d.mass * (d.velocity.x() * d.velocity.x() + d.velocity.y() * d.velocity.y()) / S(2);
}

namespace detail {

/// x times 2^power, entry by entry.
template <std::floating_point S>
Vector2<S> times_power(const Vector2<S>& x, int power) {
  return {std::ldexp(x.x(), power), std::ldexp(x.y(), power)};
}

/// The power of two p for which the largest entry of x is in [2^p, 2^(p + 1)); x is not zero.
template <std::floating_point S>
int power_of(const Vector2<S>& x) {
  return std::ilogb(std::max(std::abs(x.x()), std::abs(x.y())));
}

/// x · y of two differences x = a − b and y = p − q, without rounding.
template <std::floating_point S>
Exact exact_dot_of_differences(const Vector2<S>& a, const Vector2<S>& b, const Vector2<S>& p,
                               const Vector2<S>& q) {
  Exact sum;
  for (int k = 0; k < 2; ++k) {
    sum +=
        (Exact(double(a(k))) - Exact(double(b(k)))) * (Exact(double(p(k))) - Exact(double(q(k))));
  }
  return sum;
}

}  // namespace detail

/// The axis: the unit vector along the line of centres of two discs, from B to A.
/// This is the line of impact (line of collision), the common normal of their rims at the contact.
///
/// The same for spheres, with a third coordinate.
/// @param centre_a, centre_b m
/// @return a vector of length 1, each entry off by at most 6 u; nothing if the centres coincide
/// @see *Fundamentals of Computer Animation: Collision Detection and Response*, slide "Collisions
/// Between Spheres (1)", step a; that axis has the opposite direction
// [line-of-centres]
template <std::floating_point S>
std::optional<Vector2<S>> line_of_centres(const Vector2<S>& centre_a, const Vector2<S>& centre_b) {
  Vector2<S> d = centre_a - centre_b;
  if (!all_finite(d)) d = centre_a / S(2) - centre_b / S(2);
  // Rounded differences are zero only if the numbers are equal.
  if (d.x() == S(0) && d.y() == S(0)) return std::nullopt;
  // With the larger entry in [1, 2) no square overflows, and none that matters underflows.
  d = detail::times_power<S>(d, -detail::power_of<S>(d));
  const S length = std::sqrt(d.x() * d.x() + d.y() * d.y());
  return Vector2<S>(d.x() / length, d.y() / length);
}
// [/line-of-centres]

/// The sign of (c_A − c_B) · (v_A − v_B): −1 if two discs approach, +1 if they separate, 0 if their
/// distance is stationary (or they move with the same velocity).
///
/// Exact for every finite input: rounded arithmetic first (a floating-point filter), and exact
/// arithmetic if the result is too near to zero.
template <Ring S>
int closing_sign(const Disc<S>& a, const Disc<S>& b) {
  const Vector2<S> d = a.centre - b.centre;
  const Vector2<S> w = a.velocity - b.velocity;
  const S s = d.x() * w.x() + d.y() * w.y();
  if constexpr (std::floating_point<S>) {
    // Two differences, a product and a sum: four roundings in each term.
    const S size = std::abs(d.x() * w.x()) + std::abs(d.y() * w.y());
    const S bound = tolerance::gamma<S>(8) * size + S(4) * tolerance::underflow_unit<S>;
    if (std::isfinite(size) && std::abs(s) > bound) return s < S(0) ? -1 : 1;
    return detail::exact_dot_of_differences<S>(a.centre, b.centre, a.velocity, b.velocity).sign();
  } else {
    return s < S(0) ? -1 : S(0) < s ? 1 : 0;
  }
}

/// Whether two discs approach, so that they collide if they touch: closing_sign() is −1.
template <Ring S>
bool approaching(const Disc<S>& a, const Disc<S>& b) {
  return closing_sign(a, b) < 0;
}

/// A velocity as the sum of two perpendicular components.
template <std::floating_point S>
struct Components {
  S normal = S(0);                             ///< n · v, the normal component, m/s
  Vector2<S> tangential = Vector2<S>::Zero();  ///< v − (n · v) n, the tangential component, m/s
};

/// A velocity split into its component along an axis and the perpendicular rest.
/// @param velocity m/s, below half the largest number
/// @param axis unit vector
/// @return both off by at most 16 u |v|
/// @see *Fundamentals of Computer Animation*, slide "Collisions Between Spheres (1)", step b
template <std::floating_point S>
Components<S> components(const Vector2<S>& velocity, const Vector2<S>& axis) {
  const S normal = axis.x() * velocity.x() + axis.y() * velocity.y();
  return {normal, velocity - axis * normal};
}

/// The result of a collision of two discs.
template <std::floating_point S>
struct DiscCollision {
  bool hit = false;  ///< whether an impulse acted: they approached, and there was an axis
  Vector2<S> velocity_a = Vector2<S>::Zero();  ///< m/s
  Vector2<S> velocity_b = Vector2<S>::Zero();  ///< m/s
  Vector2<S> impulse = Vector2<S>::Zero();     ///< on A; reversed on B, N·s
};

/// The collision of two smooth discs in contact: along the line of their centres a collision on a
/// line; the tangential velocities are unchanged, as there is no friction.
///
/// Nothing happens if they do not approach, or if their centres coincide, since then there is no
/// axis. The function does not test whether they touch; the caller must.
/// @param a, b the discs at the moment of contact. A mass may be infinite: an immovable disc
/// @param restitution e, from 0 (perfectly inelastic) to 1 (elastic)
/// @return each velocity off by at most 64 u of |v_A − v_B| and 2 u of itself; infinite only if the
/// true one is about as large as the largest number, and never NaN
/// @note The *relative* error of a small component can be large: near grazing the impulse itself is
/// small compared with |v_A − v_B|.
/// @see *Fundamentals of Computer Animation*, slide "Collisions Between Spheres (1)", steps a to d,
/// which also reflect discs that separate
template <std::floating_point S>
DiscCollision<S> collide_discs(const Disc<S>& a, const Disc<S>& b, const S& restitution) {
  DiscCollision<S> result{false, a.velocity, b.velocity, Vector2<S>::Zero()};
  const auto axis = line_of_centres(a.centre, b.centre);
  if (!axis || !approaching(a, b)) return result;
  const Vector2<S> relative = a.velocity - b.velocity;
  if (!all_finite(Vector2<S>(relative * S(4)))) {
    // Near the largest number: the same with an eighth of the velocities.
    Disc<S> slow_a = a;
    Disc<S> slow_b = b;
    slow_a.velocity /= S(8);
    slow_b.velocity /= S(8);
    const DiscCollision<S> slow = collide_discs(slow_a, slow_b, restitution);
    return {true, slow.velocity_a * S(8), slow.velocity_b * S(8), slow.impulse * S(8)};
  }
  result.hit = true;
  // [collide-discs]
  // In the frame of B, A approaches and B rests. Along the axis this is a collision on a line.
  const S speed = std::max(S(0), -components<S>(relative, *axis).normal);
  const LineBody<S> coming{a.mass, speed};
  const LineBody<S> resting{b.mass, S(0)};
  const LineCollision<S> after = collide(coming, resting, restitution);
  result.velocity_a = a.velocity + *axis * S(speed - after.first);
  result.velocity_b = b.velocity - *axis * after.second;
  result.impulse = *axis * collision_impulse(coming, resting, restitution);
  // [/collide-discs]
  return result;
}

/// The velocity after a hit against a fixed smooth wall: the normal component is multiplied by −e,
/// the tangential component is unchanged.
/// @param velocity m/s, below a quarter of the largest number
/// @param normal unit vector, away from the wall
/// @param restitution e, from 0 to 1
/// @return m/s, off by at most 16 u |v|; unchanged if the body does not move towards the wall
/// @see *Interaction and Normals*, the problem of the steel ball
template <std::floating_point S>
Vector2<S> off_cushion(const Vector2<S>& velocity, const Vector2<S>& normal, const S& restitution) {
  const S inwards = components(velocity, normal).normal;
  if (!(inwards < S(0))) return velocity;
  return velocity - normal * S((S(1) + restitution) * inwards);
}

}  // namespace contact
