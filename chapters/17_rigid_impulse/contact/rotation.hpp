/// @file
/// The orientation of a rotating body, integrated as a matrix, as a quaternion and by the
/// exponential map.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/quaternion.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The matrix of ω×: its product with r is ω × r.
template <Ring S>
Matrix3<S> cross_matrix(const Vector3<S>& w) {
  Matrix3<S> m;
  m << S(0), S(-w.z()), w.y(), w.z(), S(0), S(-w.x()), S(-w.y()), w.x(), S(0);
  return m;
}

// [matrix-step]
/// A rotation matrix after a time h at the angular velocity ω, by explicit Euler: R + h ω × R.
///
/// @warning Every column is displaced along its tangent, so each step makes the columns
/// perpendicular to ω longer by the factor √(1 + |ω|² h²). Soon the matrix is no rotation.
/// @param angular_velocity ω, in the axes of the world, rad/s
/// @param h s
template <Ring S>
Matrix3<S> matrix_step(const Matrix3<S>& rotation, const Vector3<S>& angular_velocity, const S& h) {
  const Matrix3<S> change = cross_matrix<S>(angular_velocity) * rotation;
  return rotation + change * h;
}

/// The rotation whose first column is parallel to that of `m`, and whose second lies in the plane
/// of its first two: Gram–Schmidt orthonormalisation.
/// @param m first two columns not parallel
template <std::floating_point S>
Matrix3<S> orthonormalised(const Matrix3<S>& m) {
  Matrix3<S> r;
  r.col(0) = m.col(0) / std::sqrt(m.col(0).dot(m.col(0)));
  const Vector3<S> second = m.col(1) - r.col(0) * r.col(0).dot(m.col(1));
  r.col(1) = second / std::sqrt(second.dot(second));
  r.col(2) = r.col(0).cross(r.col(1));
  return r;
}
// [/matrix-step]

// [quaternion-step]
/// A quaternion after a time h at the angular velocity ω, by explicit Euler, q + ½ h ω q,
/// normalised.
///
/// It stays a rotation. But each step turns by 2 arctan(½ |ω| h) instead of |ω| h, and so lags
/// behind by about |ω|³ h³/12.
/// @param angular_velocity ω, in the axes of the world, rad/s
/// @param h s
template <std::floating_point S>
Quaternion<S> quaternion_step(const Quaternion<S>& q, const Vector3<S>& angular_velocity,
                              const S& h) {
  const Quaternion<S> change = Quaternion<S>{S(0), angular_velocity * (h / S(2))} * q;
  return normalised<S>({q.w + change.w, q.v + change.v});
}
// [/quaternion-step]

// [exponential-step]
/// A quaternion after a time h at the angular velocity ω, by the exponential map: exact for any h
/// if ω is constant.
template <std::floating_point S>
Quaternion<S> exponential_step(const Quaternion<S>& q, const Vector3<S>& angular_velocity,
                               const S& h) {
  return exponential<S>(angular_velocity * h) * q;
}
// [/exponential-step]

// [free-spin]
/// The angular velocity of a body with the orientation R and the angular momentum L:
/// ω = R · I⁻¹ · Rᵀ L.
/// @param momentum L about the centre of mass, in the axes of the world, kg·m²/s
/// @param moments about the principal axes, kg·m², each greater than 0
/// @param rotation its columns are the principal axes in world coordinates
template <Scalar S>
Vector3<S> free_angular_velocity(const Vector3<S>& momentum, const Vector3<S>& moments,
                                 const Matrix3<S>& rotation) {
  const Vector3<S> seen = rotation.transpose() * momentum;
  const Vector3<S> angular_velocity(seen.x() / moments.x(), seen.y() / moments.y(),
                                    seen.z() / moments.z());
  return rotation * angular_velocity;
}

/// A step of a body without torque, with the angular velocity at the midpoint of the step, which a
/// half step with that of its beginning finds. A second-order method: its error falls as h².
template <std::floating_point S>
Quaternion<S> midpoint_step(const Quaternion<S>& q, const Vector3<S>& momentum,
                            const Vector3<S>& moments, const S& h) {
  const Vector3<S> first = free_angular_velocity<S>(momentum, moments, matrix_of(q));
  const Quaternion<S> middle = exponential_step<S>(q, first, h / S(2));
  return exponential_step<S>(q, free_angular_velocity<S>(momentum, moments, matrix_of(middle)), h);
}
// [/free-spin]

// [symmetric-top]
/// The exact orientation of a body with an axis of symmetry after a time without torque.
///
/// Its angular velocity is L/I₁ plus Ω = L_z (1/I₃ − 1/I₁) along its own axis z, and Ω is constant.
/// So it rotates by Ω t about its own axis first, and then by L t/I₁ about L, which is fixed in
/// space.
/// @param q initial orientation, from body to world; the axis of symmetry is the body's z
/// @param momentum L, in the axes of the world, kg·m²/s
/// @param transverse, axial I₁ and I₃, kg·m², greater than 0
/// @param t s
template <std::floating_point S>
Quaternion<S> free_top(const Quaternion<S>& q, const Vector3<S>& momentum, const S& transverse,
                       const S& axial, const S& t) {
  const S seen = matrix_of(q).col(2).dot(momentum);
  const S rest = seen * (S(1) / axial - S(1) / transverse);
  return exponential<S>(momentum * (t / transverse)) * q * exponential<S>({S(0), S(0), rest * t});
}
// [/symmetric-top]

}  // namespace contact
