/// @file
/// The three conditions of two bodies in contact, by their relative velocity: separating, resting
/// or colliding.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>

namespace contact {

// [motion]
/// What two bodies in contact do: the sign of the relative velocity along the normal, which leads
/// from B to A.
enum class Motion {
  separating,  ///< they move apart: v · n > 0
  resting,     ///< the contact remains, to first order: v · n = 0. The lecture calls it "contact"
  colliding    ///< they move into each other: v · n < 0
};
// [/motion]

/// How a body moves and rotates at a moment.
struct BodyMotion {
  Vector3<double> centre = Vector3<double>::Zero();   ///< a point of the body, m
  Vector3<double> linear = Vector3<double>::Zero();   ///< velocity of that point, m/s
  Vector3<double> angular = Vector3<double>::Zero();  ///< velocity in world coordinates, rad/s
};

namespace detail {

inline Motion motion_of_sign(int sign) {
  if (sign == 0) return Motion::resting;
  return sign > 0 ? Motion::separating : Motion::colliding;
}

/// n · (v + ω × (p − centre)) of A minus that of B, in a number type.
template <class T>
T approach_speed(const BodyMotion& a, const BodyMotion& b, const Vector3<double>& point,
                 const Vector3<double>& normal) {
  const Triple<T> p = triple<T>(point), n = triple<T>(normal);
  const auto of_body = [&](const BodyMotion& body) {
    const Triple<T> lever = minus(p, triple<T>(body.centre));
    return dot(n, triple<T>(body.linear)) + dot(n, cross(triple<T>(body.angular), lever));
  };
  return of_body(a) - of_body(b);
}

}  // namespace detail

// [approach]
/// Whether two bodies that touch at a point separate, rest or collide there.
///
/// Exact for the stored numbers: a floating-point filter, then exact arithmetic. A velocity along a
/// face or the rotation about an axis through the point therefore rests, and is not a rounded
/// ±1e-17.
/// @param normal from B to A, of any length but 0
/// @param point of the contact, m
/// @return resting if a number is not finite
inline Motion motion_in_contact(const Vector3<double>& normal, const Vector3<double>& point,
                                const BodyMotion& a, const BodyMotion& b) {
  const RunningError rounded = detail::approach_speed<RunningError>(a, b, point, normal);
  const int certain = rounded.certain_sign();
  if (certain != 0 && std::isfinite(rounded.bound)) return detail::motion_of_sign(certain);
  const auto is_finite = [](const BodyMotion& body) {
    return all_finite(body.centre) && all_finite(body.linear) && all_finite(body.angular);
  };
  if (!is_finite(a) || !is_finite(b) || !all_finite(point) || !all_finite(normal)) {
    return Motion::resting;
  }
  return detail::motion_of_sign(detail::approach_speed<Exact>(a, b, point, normal).sign());
}

/// The same for bodies that do not rotate.
/// @param velocity_a, velocity_b m/s
inline Motion motion_in_contact(const Vector3<double>& normal, const Vector3<double>& velocity_a,
                                const Vector3<double>& velocity_b) {
  BodyMotion a, b;
  a.linear = velocity_a;
  b.linear = velocity_b;
  return motion_in_contact(normal, Vector3<double>::Zero(), a, b);
}
// [/approach]

}  // namespace contact
