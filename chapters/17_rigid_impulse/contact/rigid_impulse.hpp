/// @file
/// Two rigid bodies touch at a point: whether they close, and the impulse of their collision.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/exact.hpp>
#include <contact/rigid_body.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [contact]
/// A contact of two bodies A and B. The line through the point along the normal is the line of
/// impact (line of collision, common normal).
template <Ring S>
struct ContactPoint {
  Vector3<S> point = Vector3<S>::Zero();   ///< in the world, m
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
};
// [/contact]

namespace detail {

/// n · (v + ω × (p − x)) without rounding.
template <std::floating_point S>
Exact exact_normal_component(const RigidBody<S>& body, const ContactPoint<S>& at) {
  const auto exact = [](const S& x) { return Exact(double(x)); };
  const auto lever_arm = [&](int k) { return exact(at.point(k)) - exact(body.position(k)); };
  Exact sum;
  for (int k = 0; k < 3; ++k) {
    const int y = (k + 1) % 3;
    const int z = (k + 2) % 3;
    sum += exact(at.normal(k)) *
           (exact(body.velocity(k)) + exact(body.angular_velocity(y)) * lever_arm(z) -
            exact(body.angular_velocity(z)) * lever_arm(y));
  }
  return sum;
}

template <std::floating_point S>
S exact_normal_velocity(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at) {
  const Exact sum = exact_normal_component(a, at) - exact_normal_component(b, at);
  const S value = rounded<S>(sum);
  // What is not zero keeps its sign, even if the nearest number is 0.
  if (value == S(0)) return S(sum.sign()) * std::numeric_limits<S>::denorm_min();
  return value;
}

/// The sum of the magnitudes of all terms of v_n: |n| · (|v| + |ω| × |r|) of both bodies.
template <std::floating_point S>
S size_of_normal_velocity(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at) {
  const auto part = [&](const RigidBody<S>& body) {
    const Vector3<S> r = (at.point - body.position).cwiseAbs();
    const Vector3<S> w = body.angular_velocity.cwiseAbs();
    const Vector3<S> turn(w.y() * r.z() + w.z() * r.y(), w.z() * r.x() + w.x() * r.z(),
                          w.x() * r.y() + w.y() * r.x());
    return S(at.normal.cwiseAbs().dot(body.velocity.cwiseAbs() + turn));
  };
  return part(a) + part(b);
}

}  // namespace detail

/// How fast A moves away from B at the contact: n · (v_A(p) − v_B(p)).
///
/// Its sign decides whether there is a collision: negative, the bodies close; zero, they touch and
/// do not collide; positive, they are separating already.
/// @return m/s. In a floating-point type the sign is that of the exact value for the numbers as
/// stored, for every finite input: a floating-point filter sends doubtful values to exact
/// arithmetic, and the result is rounded once. Otherwise it is off by γ(12) of the sum of its
/// terms' magnitudes
/// @see *Game Physics – Part III*, slide "Normal velocity equations"
template <Ring S>
S normal_velocity(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at) {
  const Vector3<S> relative = velocity_at(a, at.point) - velocity_at(b, at.point);
  const S plain = at.normal.dot(relative);
  if constexpr (std::floating_point<S>) {
    const S size = detail::size_of_normal_velocity(a, b, at);
    // Ten roundings on the longest path from an input to the sum, and those of `size` itself.
    const S bound = tolerance::gamma<S>(16) * size;
    const S small =
        std::ldexp(S(1), std::numeric_limits<S>::min_exponent + 2 * std::numeric_limits<S>::digits);
    if (std::isfinite(size) && size > small && std::abs(plain) > bound) return plain;
    return detail::exact_normal_velocity(a, b, at);
  }
  return plain;
}

// [closing-case]
/// How the normal velocity of two bodies in contact is signed.
enum class Closing { approaching, touching, separating };

/// Which of the three cases it is: exact for finite numbers as stored.
template <Ring S>
Closing closing_case(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at) {
  const S v = normal_velocity(a, b, at);
  return v < S(0) ? Closing::approaching : S(0) < v ? Closing::separating : Closing::touching;
}
// [/closing-case]

// [response]
/// The change of the relative velocity at the contact along `out` for one unit of impulse along
/// `in`, on A and reversed on B: (1/m_A + 1/m_B) out · in, plus (r × out) · I⁻¹ (r × in) for each
/// body.
///
/// For in = out = n it is the inverse of the contact's effective mass, and the divisor of the
/// collision impulse. It is never negative for in = out, and 0 only between immovable bodies.
/// @return 1/kg
template <Ring S>
S inverse_effective_mass(const RigidBody<S>& a, const RigidBody<S>& b, const Vector3<S>& point,
                         const Vector3<S>& out, const Vector3<S>& in) {
  const auto turning = [&](const RigidBody<S>& body) {
    const Vector3<S> r = point - body.position;
    const Vector3<S> turned = body.inverse_inertia * Vector3<S>(r.cross(in));
    return S(Vector3<S>(r.cross(out)).dot(turned));
  };
  return (a.inverse_mass + b.inverse_mass) * S(out.dot(in)) + turning(a) + turning(b);
}
// [/response]

// [impulse-without-rotation]
/// The impulse along n of a collision without friction between bodies that do not rotate:
/// j = −(1 + e) v_n / (1/m_A + 1/m_B), and 0 unless they close.
/// @param e coefficient of restitution, from 0 to 1
/// @return N·s, not negative: along n on A, reversed on B
/// @see *Game Physics – Part III*, slide "Impulse force magnitude (without rotation)"
template <Scalar S>
S impulse_without_rotation(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at,
                           const S& e) {
  const S v = at.normal.dot(a.velocity - b.velocity);
  const S divisor = a.inverse_mass + b.inverse_mass;
  if (!(v < S(0)) || divisor == S(0)) return S(0);
  return -((S(1) + e) * v) / divisor;
}
// [/impulse-without-rotation]

/// The impulse along n of a collision without friction: j = −(1 + e) v_n / k, with
/// k = 1/m_A + 1/m_B + (r_A × n) · I_A⁻¹ (r_A × n) + (r_B × n) · I_B⁻¹ (r_B × n), and 0 unless the
/// bodies close.
///
/// The tensors are in the axes of the world, as RigidBody stores them. Without friction the
/// restitution laws of Newton, Poisson and Stronge all give this impulse.
/// @param e coefficient of restitution, from 0 to 1
/// @return N·s, not negative: along n on A, reversed on B; 0 between immovable bodies
/// @see *Game Physics – Part III*, slides "Spinning" and "Completion"
// [collision-impulse]
template <Scalar S>
S collision_impulse(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at,
                    const S& e) {
  const S v = normal_velocity(a, b, at);
  const S k = inverse_effective_mass<S>(a, b, at.point, at.normal, at.normal);
  if (!(v < S(0)) || k == S(0)) return S(0);
  return -((S(1) + e) * v) / k;
}
// [/collision-impulse]

/// Two bodies after a collision, and its impulse.
template <Ring S>
struct Collided {
  RigidBody<S> a;                           ///< afterwards
  RigidBody<S> b;                           ///< afterwards
  Vector3<S> impulse = Vector3<S>::Zero();  ///< on A; reversed on B, N·s
};

/// A collision without friction. Bodies that do not close are returned unchanged.
///
/// One impulse acts at the point, on A and reversed on B. So momentum, and angular momentum about
/// any point, are conserved up to the rounding of the velocities themselves.
///
/// The bodies do not close afterwards. Rounded velocities may miss −e v_n by a few ulps, and where
/// it is small they can miss its sign. Then the impulse is raised by what one rounding can hide,
/// and by twice as much while the exact v_n is still negative. That exact sign is expensive only
/// where v_n' is near 0: with e = 0, and for the smallest velocities.
/// @param e coefficient of restitution, from 0 to 1
/// @note Immovable bodies go on closing, and so may bodies whose impulse under- or overflows, or
/// whose inverse tensors have lost the effective mass to rounding (the thinnest needles).
/// @see *Interaction and Normals*, slide "Rigid body simulation"
// [collide]
template <Scalar S>
Collided<S> collide(const RigidBody<S>& a, const RigidBody<S>& b, const ContactPoint<S>& at,
                    const S& e) {
  S j = collision_impulse(a, b, at, e);
  if (j == S(0)) return {a, b, Vector3<S>::Zero()};
  const auto pushed = [&]() -> Collided<S> {
    const Vector3<S> impulse = at.normal * j;
    return {after_impulse(a, impulse, at.point),
            after_impulse<S>(b, Vector3<S>(-impulse), at.point), impulse};
  };
  Collided<S> after = pushed();
  // What follows only corrects j where rounding leaves the bodies closing.
  // [/collide]
  if constexpr (std::floating_point<S>) {
    const auto size = [&] { return detail::size_of_normal_velocity(after.a, after.b, at); };
    const S k = inverse_effective_mass<S>(a, b, at.point, at.normal, at.normal);
    S more = std::max(tolerance::unit_roundoff<S> * size() / k, tolerance::underflow_unit<S>);
    // Doubled 24 times, it is a few 1e-9 of the velocities: more than rounding can hide.
    for (int tries = 0; tries < 24; ++tries) {
      if (!std::isfinite(size()) || !std::isfinite(j + more)) break;
      if (!(normal_velocity(after.a, after.b, at) < S(0))) break;
      j += more;
      more += more;
      after = pushed();
    }
  }
  return after;
}

}  // namespace contact
