/// @file
/// A rigid body in the world: the velocities of its points, its momentum and its energy.
#pragma once

#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

// [rigid-body]
/// A rigid body at one moment, everything in the axes of the world.
///
/// A collision needs the inverses: the change of velocity for a unit of impulse, and that of the
/// angular velocity for a unit of angular impulse. An immovable body has zeros there, and so needs
/// no special case. Its `mass` and `inertia` are zero too: it adds nothing to sums of momentum and
/// energy.
template <Ring S>
struct RigidBody {
  S mass = S(0);                                     ///< kg
  Matrix3<S> inertia = Matrix3<S>::Zero();           ///< about the centre of mass, kg·m²
  S inverse_mass = S(0);                             ///< 1/kg; 0 for an immovable body
  Matrix3<S> inverse_inertia = Matrix3<S>::Zero();   ///< 1/(kg·m²); 0 for an immovable body
  Vector3<S> position = Vector3<S>::Zero();          ///< of the centre of mass, m
  Vector3<S> velocity = Vector3<S>::Zero();          ///< of the centre of mass, m/s
  Vector3<S> angular_velocity = Vector3<S>::Zero();  ///< angular velocity ω, rad/s
};
// [/rigid-body]

namespace detail {

template <Ring S>
void require_motion(const Vector3<S>& position, const Vector3<S>& velocity,
                    const Vector3<S>& angular_velocity) {
  require_finite("position", position);
  require_finite("velocity", velocity);
  require_finite("angular_velocity", angular_velocity);
}

template <Scalar S>
S inverse_of(const char* argument, const S& x) {
  require_size(argument, x);
  const S inverse = S(1) / x;
  if (!is_finite(inverse)) throw_invalid_argument(argument, number_text(x), "is too small");
  return inverse;
}

}  // namespace detail

/// The inverse of a symmetric positive definite matrix, by cofactors.
/// @return nothing if a leading minor is not greater than 0, or an entry of the inverse is not
/// finite. Exact if S is exact; else off by about the ratio of the largest moment to the smallest,
/// times a few u of its largest entry
template <Scalar S>
std::optional<Matrix3<S>> inverse_of_symmetric(const Matrix3<S>& m) {
  const S c00 = m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1);
  const S c01 = m(1, 2) * m(2, 0) - m(1, 0) * m(2, 2);
  const S c02 = m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0);
  const S minor = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  const S det = m(0, 0) * c00 + m(0, 1) * c01 + m(0, 2) * c02;
  if (!(S(0) < m(0, 0)) || !(S(0) < minor) || !(S(0) < det)) return std::nullopt;
  Matrix3<S> inverse;
  inverse(0, 0) = c00 / det;
  inverse(0, 1) = inverse(1, 0) = c01 / det;
  inverse(0, 2) = inverse(2, 0) = c02 / det;
  inverse(1, 1) = (m(0, 0) * m(2, 2) - m(0, 2) * m(2, 0)) / det;
  inverse(1, 2) = inverse(2, 1) = (m(0, 2) * m(1, 0) - m(0, 0) * m(1, 2)) / det;
  inverse(2, 2) = minor / det;
  if (!all_finite(inverse)) return std::nullopt;
  return inverse;
}

/// A movable body from its tensor in the axes of the world.
/// @param mass kg, finite and greater than 0
/// @param inertia about the centre of mass, world axes, symmetric and positive definite, kg·m²
/// @param position, velocity of the centre of mass, m and m/s
/// @param angular_velocity angular velocity, rad/s
/// @throws std::invalid_argument naming the argument and its value
/// @note Inverting the full tensor of a needle loses as many digits as the ratio of its moments
/// has. If you have the principal moments, use rigid_body_from_axes().
template <Scalar S>
RigidBody<S> rigid_body(const S& mass, const Matrix3<S>& inertia, const Vector3<S>& position,
                        const Vector3<S>& velocity, const Vector3<S>& angular_velocity) {
  const S inverse_mass = detail::inverse_of("mass", mass);
  detail::require_motion(position, velocity, angular_velocity);
  if (!all_finite(inertia)) throw_invalid_argument("inertia", "?", "every entry must be finite");
  if (inertia != inertia.transpose()) throw_invalid_argument("inertia", "?", "must be symmetric");
  const auto inverse = inverse_of_symmetric(inertia);
  if (!inverse) throw_invalid_argument("inertia", "?", "must be positive definite");
  return {mass, inertia, inverse_mass, *inverse, position, velocity, angular_velocity};
}

/// A movable body from its principal moments and the rotation from its principal axes to the axes
/// of the world.
/// @param moments kg·m², each finite and greater than 0
/// @param rotation orthonormal; its columns are the principal axes in world coordinates
/// @return with an inverse tensor as accurate as the tensor, whatever the ratio of the moments
/// @throws std::invalid_argument naming the argument and its value
template <Scalar S>
RigidBody<S> rigid_body_from_axes(const S& mass, const Vector3<S>& moments,
                                  const Matrix3<S>& rotation, const Vector3<S>& position,
                                  const Vector3<S>& velocity, const Vector3<S>& angular_velocity) {
  const S inverse_mass = detail::inverse_of("mass", mass);
  Vector3<S> inverse;
  for (int k = 0; k < 3; ++k) inverse(k) = detail::inverse_of("moments", S(moments(k)));
  detail::require_motion(position, velocity, angular_velocity);
  if (!all_finite(rotation)) throw_invalid_argument("rotation", "?", "must be finite");
  return {mass,
          rotated<S>(detail::diagonal<S>(moments.x(), moments.y(), moments.z()), rotation),
          inverse_mass,
          rotated<S>(detail::diagonal<S>(inverse.x(), inverse.y(), inverse.z()), rotation),
          position,
          velocity,
          angular_velocity};
}

/// An immovable body: the ground, or a flywheel that keeps its velocity and angular velocity.
/// @throws std::invalid_argument if a coordinate is not finite
template <Ring S>
RigidBody<S> immovable(const Vector3<S>& position, const Vector3<S>& velocity,
                       const Vector3<S>& angular_velocity) {
  detail::require_motion(position, velocity, angular_velocity);
  RigidBody<S> body;
  body.position = position;
  body.velocity = velocity;
  body.angular_velocity = angular_velocity;
  return body;
}

/// The velocity of the point of the body that is at p now: v + ω × r, with the lever arm r from the
/// centre of mass to p.
/// @param p in the world, m; it need not lie in the body
/// @return m/s; each coordinate off by γ(5) of the sum of its terms' magnitudes
/// @see *Interaction and Normals*, slide "Velocities of points of contact"
// [velocity-at]
template <Ring S>
Vector3<S> velocity_at(const RigidBody<S>& body, const Vector3<S>& p) {
  const Vector3<S> r = p - body.position;
  return body.velocity + Vector3<S>(body.angular_velocity.cross(r));
}
// [/velocity-at]

// [momenta]
/// The angular momentum of a body about a point of the world, of its motion and of its rotation:
/// (x − o) × m v + I ω.
/// @return kg·m²/s; 0 for an immovable body
template <Ring S>
Vector3<S> angular_momentum(const RigidBody<S>& body, const Vector3<S>& o) {
  const Vector3<S> p = body.velocity * body.mass;
  const Vector3<S> r = body.position - o;
  return Vector3<S>(r.cross(p)) + Vector3<S>(body.inertia * body.angular_velocity);
}

/// The kinetic energy of a body: ½ m v² + ½ ω · I ω.
/// @return J; 0 for an immovable body
template <Scalar S>
S kinetic_energy(const RigidBody<S>& body) {
  const Vector3<S> spin_momentum = body.inertia * body.angular_velocity;
  return (body.mass * body.velocity.dot(body.velocity) + body.angular_velocity.dot(spin_momentum)) /
         S(2);
}
// [/momenta]

/// The body after an impulse J at the point p: the velocity changes by J/m, the angular velocity by
/// I⁻¹ (r × J). Its position does not change.
/// @param impulse on this body, N·s
/// @param p in the world, m
// [apply-impulse]
template <Ring S>
RigidBody<S> after_impulse(RigidBody<S> body, const Vector3<S>& impulse, const Vector3<S>& p) {
  const Vector3<S> r = p - body.position;
  const Vector3<S> angular_impulse = r.cross(impulse);
  body.velocity = body.velocity + impulse * body.inverse_mass;
  body.angular_velocity =
      body.angular_velocity + Vector3<S>(body.inverse_inertia * angular_impulse);
  return body;
}
// [/apply-impulse]

// [sweet-spot]
/// The centre of percussion, I/(m d): how far beyond the centre of mass a hit must be for a point
/// on the other side to stay at rest.
/// @param inertia about the axis through the centre of mass, kg·m², greater than 0
/// @param mass kg, greater than 0
/// @param d distance of the point that is to stay at rest from the centre of mass, m
/// @return m; ∞ for d = 0 in a floating-point type: every hit moves the centre of mass
template <Scalar S>
S centre_of_percussion(const S& inertia, const S& mass, const S& d) {
  return inertia / mass / d;
}
// [/sweet-spot]

}  // namespace contact
