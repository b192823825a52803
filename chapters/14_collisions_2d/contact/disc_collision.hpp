/// @file
/// Two smooth discs that touch: the line of their centres, whether they approach, and the
/// velocities that the collision leaves.
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

/// A disc without friction, so that nothing ever turns it. Make it with disc(), which checks what
/// it is given.
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

// [line-of-centres]
/// The axis of a collision between discs: the unit vector along the line of their centres, from B
/// to A. It is the common normal of their rims where they touch.
///
/// The same for spheres, with a third coordinate.
/// @param centre_a, centre_b m
/// @return a vector of length 1, each entry off by at most 6 u; nothing if the centres coincide
/// @see *Fundamentals of Computer Animation: Collision Detection and Response*, slide "Collisions
/// Between Spheres (1)", step a; that axis points the other way
template <std::floating_point S>
std::optional<Vector2<S>> line_of_centres(const Vector2<S>& centre_a, const Vector2<S>& centre_b) {
  Vector2<S> d = centre_a - centre_b;
  if (!all_finite(d)) d = centre_a / S(2) - centre_b / S(2);
  // Rounded differences are zero only if the numbers are equal.
  if (d.x() == S(0) && d.y() == S(0)) return std::nullopt;
  // With the larger entry in [1, 2) no square overflows, and none that counts underflows.
  d = detail::times_power<S>(d, -detail::power_of<S>(d));
  const S length = std::sqrt(d.x() * d.x() + d.y() * d.y());
  return Vector2<S>(d.x() / length, d.y() / length);
}
// [/line-of-centres]

// [closing]
/// Whether two discs approach, (c_A − c_B) · (v_A − v_B): −1 if their centres come closer, +1 if
/// they go apart, 0 if their distance is just then at its least (or they move alike).
///
/// A decision: right for every finite input. Rounded first; if that is too near to zero to be sure
/// of, without rounding.
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

/// Whether two discs come closer, so that they collide when they touch: closing_sign() is −1.
template <Ring S>
bool approaching(const Disc<S>& a, const Disc<S>& b) {
  return closing_sign(a, b) < 0;
}
// [/closing]

/// A velocity in two parts at right angles.
template <std::floating_point S>
struct Components {
  S normal = S(0);                         ///< n · v: along the axis, with its sign, m/s
  Vector2<S> across = Vector2<S>::Zero();  ///< the rest, v − (n · v) n, m/s
};

// [components]
/// A velocity split into the part along an axis and the rest, which is at right angles to it.
/// @param velocity m/s, below half the largest number
/// @param axis unit vector
/// @return both parts off by at most 16 u |v|
/// @see *Fundamentals of Computer Animation*, slide "Collisions Between Spheres (1)", step b
template <std::floating_point S>
Components<S> components(const Vector2<S>& velocity, const Vector2<S>& axis) {
  const S normal = axis.x() * velocity.x() + axis.y() * velocity.y();
  return {normal, velocity - axis * normal};
}
// [/components]

/// What a collision of two discs leaves.
template <std::floating_point S>
struct DiscCollision {
  bool hit = false;  ///< whether they pushed at all: they approached, and there was an axis
  Vector2<S> velocity_a = Vector2<S>::Zero();  ///< m/s
  Vector2<S> velocity_b = Vector2<S>::Zero();  ///< m/s
  Vector2<S> impulse = Vector2<S>::Zero();     ///< on A; on B it is the opposite, N·s
};

// [collide-discs]
/// The collision of two smooth discs that touch: along the line of their centres it is a collision
/// on a line, and across it nothing happens, since without friction nothing pushes that way.
///
/// Nothing happens either if they do not approach, or if their centres coincide, since then there
/// is no axis. Whether they touch is not asked: that is the caller's to know.
/// @param a, b the discs at the moment of the touch. A mass may be infinite: a disc that nothing
/// turns
/// @param restitution e, from 0 (they keep together along the axis) to 1 (elastic)
/// @return each velocity off by at most 64 u of |v_A − v_B| and 2 u of itself; infinite only if the
/// true one is about as large as the largest number, and never NaN
/// @note No small *relative* error of a small part is to be had: close to grazing the push itself
/// is small beside |v_A − v_B|.
/// @see *Fundamentals of Computer Animation*, slide "Collisions Between Spheres (1)", steps a to d,
/// which reflect also what separates
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
  // As B sees it, A comes and B rests. Along the axis that is a collision on a line.
  const S speed = std::max(S(0), -components<S>(relative, *axis).normal);
  const LineBody<S> coming{a.mass, speed};
  const LineBody<S> resting{b.mass, S(0)};
  const LineCollision<S> after = collide(coming, resting, restitution);
  result.velocity_a = a.velocity + *axis * S(speed - after.first);
  result.velocity_b = b.velocity - *axis * after.second;
  result.impulse = *axis * collision_impulse(coming, resting, restitution);
  return result;
}
// [/collide-discs]

// [cushion]
/// A velocity after a hit against a fixed smooth wall: the part along the wall's normal turns round
/// and is multiplied by e, the part along the wall stays.
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
// [/cushion]

}  // namespace contact
