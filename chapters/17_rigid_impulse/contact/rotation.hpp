/// @file
/// How a spinning body lies after a while: by matrix, by quaternion, by the exponential map.
#pragma once

#include <array>
#include <cmath>
#include <concepts>

#include <contact/inertia.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A sine and a cosine.
template <std::floating_point S>
struct SineCosine {
  S sine = S(0);    ///< from −1 to 1
  S cosine = S(1);  ///< from −1 to 1
};

// [sine-cosine]
/// sin x and cos x from additions and products alone, so that their bits are the same everywhere.
///
/// x is reduced by whole turns without rounding, then by quarter turns; what is left is at most an
/// eighth of a turn, for which a short series does. The stored 2π is off by its last digit, so the
/// result is that of an x that is off by at most u of itself.
/// @param x rad, finite
/// @return off by a few u, and by u |x|
template <std::floating_point S>
SineCosine<S> sine_cosine(const S& x) {
  constexpr double two_pi = 6.283185307179586;
  constexpr double quarter = 1.5707963267948966;
  constexpr double quarter_rest = 6.123233995736766e-17;
  const double turned = std::remainder(static_cast<double>(x), two_pi);
  const double n = std::nearbyint(turned / quarter);
  const double r = (turned - n * quarter) - n * quarter_rest;
  const double r2 = r * r;
  double s = 0;
  double c = 0;
  for (int k = 9; k >= 1; --k) {
    s = -r2 * (1 + s) / (2 * k * (2 * k + 1));
    c = -r2 * (1 + c) / (2 * k * (2 * k - 1));
  }
  const double sine = r * (1 + s);
  const double cosine = 1 + c;
  switch (static_cast<int>(n) & 3) {
    case 0:
      return {S(sine), S(cosine)};
    case 1:
      return {S(cosine), S(-sine)};
    case 2:
      return {S(-sine), S(-cosine)};
    default:
      return {S(-cosine), S(sine)};
  }
}
// [/sine-cosine]

/// The matrix of ω×: its product with r is ω × r.
template <Ring S>
Matrix3<S> cross_matrix(const Vector3<S>& w) {
  Matrix3<S> m;
  m << S(0), S(-w.z()), w.y(), w.z(), S(0), S(-w.x()), S(-w.y()), w.x(), S(0);
  return m;
}

// [matrix-step]
/// A rotation matrix after a short time at the spin ω, by Euler's step: R + h ω × R.
///
/// @warning Every column is pushed along its tangent, so each step makes those across ω longer, by
/// √(1 + |ω|² h²). After a while the matrix is no rotation any more.
/// @param spin ω, in the world, rad/s
/// @param h s
template <Ring S>
Matrix3<S> matrix_step(const Matrix3<S>& rotation, const Vector3<S>& spin, const S& h) {
  const Matrix3<S> push = cross_matrix<S>(spin) * rotation;
  return rotation + push * h;
}

/// The rotation whose first column points as that of `m`, and whose second lies in the plane of the
/// first two: Gram and Schmidt's way, column by column.
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

/// A rotation as a quaternion of length 1: w, and the vector part x, y, z.
template <Ring S>
struct Rotor {
  S w = S(1);                         ///< cosine of half the angle
  Vector3<S> v = Vector3<S>::Zero();  ///< sine of half the angle, along the axis
};

/// The product of two quaternions: first b's rotation, then a's.
template <Ring S>
Rotor<S> operator*(const Rotor<S>& a, const Rotor<S>& b) {
  return {a.w * b.w - a.v.dot(b.v), Vector3<S>(b.v * a.w + a.v * b.w) + Vector3<S>(a.v.cross(b.v))};
}

/// A quaternion made as long as 1.
template <std::floating_point S>
Rotor<S> normalised(const Rotor<S>& q) {
  const S length = std::sqrt(q.w * q.w + q.v.dot(q.v));
  return {q.w / length, Vector3<S>(q.v / length)};
}

/// The rotation matrix of a unit quaternion.
template <Ring S>
Matrix3<S> matrix_of(const Rotor<S>& q) {
  const S two(2);
  const S x = q.v.x();
  const S y = q.v.y();
  const S z = q.v.z();
  Matrix3<S> m;
  m << S(1) - two * (y * y + z * z), two * (x * y - q.w * z), two * (x * z + q.w * y),
      two * (x * y + q.w * z), S(1) - two * (x * x + z * z), two * (y * z - q.w * x),
      two * (x * z - q.w * y), two * (y * z + q.w * x), S(1) - two * (x * x + y * y);
  return m;
}

// [quaternion-step]
/// A quaternion after a short time at the spin ω, by Euler's step and made as long as 1 again:
/// q + ½ h ω q.
///
/// It stays a rotation. But each step turns by 2 arctan(½ |ω| h) in place of |ω| h: it lags behind,
/// by |ω|³ h³/12.
/// @param spin ω, in the world, rad/s
/// @param h s
template <std::floating_point S>
Rotor<S> quaternion_step(const Rotor<S>& q, const Vector3<S>& spin, const S& h) {
  const Rotor<S> push = Rotor<S>{S(0), spin * (h / S(2))} * q;
  return normalised<S>({q.w + push.w, q.v + push.v});
}
// [/quaternion-step]

// [exponential]
/// The rotation by the angle |a| about a: the exponential map, as a quaternion
/// (cos ½|a|, sin ½|a| · a/|a|).
/// @param a rotation vector, rad, finite
/// @return of length 1 but for a few u; no turn for a = 0
template <std::floating_point S>
Rotor<S> exponential(const Vector3<S>& a) {
  const S largest = a.cwiseAbs().maxCoeff();
  if (largest == S(0)) return {};
  const Vector3<S> share = a / largest;  // so that no square overflows or vanishes
  const S length = std::sqrt(share.dot(share));
  const auto half = sine_cosine<S>(largest * length / S(2));
  return {half.cosine, share * (half.sine / length)};
}

/// A quaternion after a time at the spin ω, by the exponential map: right for any h, as long as ω
/// does not change.
template <std::floating_point S>
Rotor<S> exponential_step(const Rotor<S>& q, const Vector3<S>& spin, const S& h) {
  return exponential<S>(spin * h) * q;
}
// [/exponential]

// [free-spin]
/// The spin of a body that lies as R says and has the angular momentum L: ω = R · I⁻¹ · Rᵀ L.
/// @param momentum L about the centre of mass, in the world, kg·m²/s
/// @param moments about the principal axes, kg·m², each greater than 0
/// @param rotation its columns are the principal axes as the world sees them
template <Scalar S>
Vector3<S> free_spin(const Vector3<S>& momentum, const Vector3<S>& moments,
                     const Matrix3<S>& rotation) {
  const Vector3<S> seen = rotation.transpose() * momentum;
  const Vector3<S> spin(seen.x() / moments.x(), seen.y() / moments.y(), seen.z() / moments.z());
  return rotation * spin;
}

/// A step of a body that nothing pushes, with the spin of the step's middle: found by half a step
/// at the spin of its beginning. Its error falls with h².
template <std::floating_point S>
Rotor<S> midpoint_step(const Rotor<S>& q, const Vector3<S>& momentum, const Vector3<S>& moments,
                       const S& h) {
  const Vector3<S> first = free_spin<S>(momentum, moments, matrix_of(q));
  const Rotor<S> middle = exponential_step<S>(q, first, h / S(2));
  return exponential_step<S>(q, free_spin<S>(momentum, moments, matrix_of(middle)), h);
}
// [/free-spin]

// [symmetric-top]
/// How a body with an axis of symmetry lies after a time, if nothing pushes it: exactly.
///
/// Its spin is L/I₁ and, along its own axis z, a rest Ω = L_z (1/I₃ − 1/I₁) that does not change.
/// So it turns by Ω t about its own axis first, and then by L t/I₁ about L, which stays where it
/// is.
/// @param q how it lies at first, from body to world; its axis of symmetry is the body's z
/// @param momentum L, in the world, kg·m²/s
/// @param across, along I₁ and I₃, kg·m², greater than 0
/// @param t s
template <std::floating_point S>
Rotor<S> free_top(const Rotor<S>& q, const Vector3<S>& momentum, const S& across, const S& along,
                  const S& t) {
  const S seen = matrix_of(q).col(2).dot(momentum);
  const S rest = seen * (S(1) / along - S(1) / across);
  return exponential<S>(momentum * (t / across)) * q * exponential<S>({S(0), S(0), rest * t});
}
// [/symmetric-top]

}  // namespace contact
