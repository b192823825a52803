/// @file
/// Rotations as quaternions: from an axis and an angle, from a rotation vector, and to and from
/// rotation matrices.
#pragma once

#include <array>
#include <cmath>
#include <concepts>

#include <contact/invalid_argument.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A rotation as a quaternion of length 1: w, and the vector part x, y, z.
///
/// Wherever four numbers are listed (a scene's file, a constructor), w is the first. q and −q are
/// the same rotation.
template <Ring S>
struct Quaternion {
  S w = S(1);                         ///< cosine of half the angle
  Vector3<S> v = Vector3<S>::Zero();  ///< sine of half the angle, along the axis
};

/// The product of two quaternions: first b's rotation, then a's.
template <Ring S>
Quaternion<S> operator*(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {a.w * b.w - a.v.dot(b.v), Vector3<S>(b.v * a.w + a.v * b.w) + Vector3<S>(a.v.cross(b.v))};
}

/// A quaternion divided by its length.
template <std::floating_point S>
Quaternion<S> normalised(const Quaternion<S>& q) {
  const S length = std::sqrt(q.w * q.w + q.v.dot(q.v));
  return {q.w / length, Vector3<S>(q.v / length)};
}

/// The rotation matrix of a unit quaternion.
template <Ring S>
Matrix3<S> matrix_of(const Quaternion<S>& q) {
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

/// The unit quaternion of a rotation matrix.
///
/// The largest of |w|, |x|, |y| and |z| is at least ½. It is computed first, from the diagonal, so
/// that no digit cancels; the others follow from sums or differences of two entries.
/// @param m a rotation: orthonormal columns, right-handed, to a few u
/// @return of the two quaternions of the rotation that with w ≥ 0; off by a few u
///
/// Source: Shepperd, *Quaternion from Rotation Matrix*, Journal of Guidance and Control 1 (1978).
template <std::floating_point S>
Quaternion<S> quaternion_of(const Matrix3<S>& m) {
  const S trace = m(0, 0) + m(1, 1) + m(2, 2);
  int i = 0;  // of the largest coordinate of the vector part
  if (m(1, 1) > m(i, i)) i = 1;
  if (m(2, 2) > m(i, i)) i = 2;
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  Quaternion<S> q;
  if (trace > m(i, i)) {
    q.w = S(1) + trace;  // 4 w²; the vector part is 4 w v
    q.v = Vector3<S>(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
  } else {
    q.w = m(k, j) - m(j, k);  // 4 vᵢ w, and so on
    q.v(i) = S(1) + m(i, i) - m(j, j) - m(k, k);
    q.v(j) = m(j, i) + m(i, j);
    q.v(k) = m(k, i) + m(i, k);
  }
  const Quaternion<S> unit = normalised(q);
  return unit.w < S(0) ? Quaternion<S>{-unit.w, Vector3<S>(-unit.v)} : unit;
}

/// The rotation about an axis by the angle of whose half the sine and the cosine are given.
/// @param axis of any length; finite and not 0
/// @return of length 1 up to a few u
/// @throws std::invalid_argument if the axis is 0 or an entry is not finite
template <std::floating_point S>
Quaternion<S> from_axis_half_angle(const Vector3<S>& axis, const SineCosine<S>& half) {
  require_finite("axis", axis);
  const S largest = axis.cwiseAbs().maxCoeff();
  if (largest == S(0)) throw_invalid_argument("axis", vector_text(axis), "it has no direction");
  const Vector3<S> share = axis / largest;  // so that no square over- or underflows
  const S length = std::sqrt(share.dot(share));
  return {half.cosine, share * (half.sine / length)};
}

/// The rotation about an axis by an angle, counter-clockwise if the axis points to the observer.
/// @param axis of any length; finite and not 0
/// @param angle rad, finite
/// @return of length 1 up to a few u
/// @throws std::invalid_argument if the axis is 0, or a number is not finite
template <std::floating_point S>
Quaternion<S> from_axis_angle(const Vector3<S>& axis, const S& angle) {
  require_finite("angle", angle);
  return from_axis_half_angle<S>(axis, sine_cosine<S>(angle / S(2)));
}

// [exponential]
/// The rotation by the angle |a| about a: the exponential map, as a quaternion
/// (cos ½|a|, sin ½|a| · a/|a|).
/// @param a rotation vector, rad
/// @return of length 1 up to a few u; the identity for a = 0; four NaN if a number is not finite
template <std::floating_point S>
Quaternion<S> exponential(const Vector3<S>& a) {
  if (a.isZero(S(0))) return {};
  const S largest = a.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  const Vector3<S> share = a / largest;  // so that no square over- or underflows
  const S length = std::sqrt(share.dot(share));
  const auto half = sine_cosine<S>(largest * length / S(2));
  return {half.cosine, share * (half.sine / length)};
}
// [/exponential]

}  // namespace contact
