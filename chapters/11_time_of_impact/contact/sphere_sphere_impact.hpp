/// @file
/// When two moving spheres touch: decided exactly, computed without cancellation.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/entry_time.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

// [sure-entry]
/// The terms of two moving spheres in floating point, if each has enough digits: its magnitude is
/// at least a sixteenth of the sum of its absolute terms.
///
/// A difference of centres or velocities has one rounding. Then the error of gap is at most γ(7) of
/// its absolute terms, of approach γ(5), of depth γ(12): with the sixteenth, relative errors of 112
/// u, 80 u and 192 u. So the signs are right, and the relative error of (gap) / (approach + √depth)
/// is less than 112 + 96 + 8 u.
template <std::floating_point S>
std::optional<EntryTerms<S>> sure_entry_terms(const Vector3<S>& d, const Vector3<S>& w,
                                              S radius_sum) {
  const EntryTerms<S> t = entry_terms<S>(d, w, radius_sum);
  const auto crosses = [&](int i, int j) {
    const S size = std::abs(d(i) * w(j)) + std::abs(d(j) * w(i));
    return size * size;
  };
  const S squares = d.dot(d) + radius_sum * radius_sum;
  const S products = d.cwiseAbs().dot(w.cwiseAbs());
  const S fourth =
      radius_sum * radius_sum * t.square + crosses(1, 2) + crosses(2, 0) + crosses(0, 1);
  const S small =
      std::ldexp(S(1), std::numeric_limits<S>::min_exponent + 3 * std::numeric_limits<S>::digits);
  const auto sure = [small](const S& x, const S& size) {
    return std::isfinite(size) && size >= small && S(16) * std::abs(x) >= size;
  };
  // A square that underflows is lost, even if it is multiplied by a large factor.
  const bool squares_kept =
      t.square >= small && (radius_sum == S(0) || radius_sum * radius_sum >= small);
  if (squares_kept && sure(t.gap, squares) && sure(t.approach, products) && sure(t.depth, fourth))
    return t;
  return std::nullopt;
}
// [/sure-entry]

/// The same, computed exactly.
template <std::floating_point S>
EntryTerms<Exact> exact_entry_terms(const Sphere<S>& a, const Vector3<S>& velocity_a,
                                    const Sphere<S>& b, const Vector3<S>& velocity_b) {
  return entry_terms<Exact>(exact_vector_difference(a.centre, b.centre),
                            exact_vector_difference(velocity_a, velocity_b),
                            Exact(double(a.radius)) + Exact(double(b.radius)));
}

}  // namespace detail

// [sphere-sphere-impact]
/// The time at which two spheres that move in straight lines touch: the first t ≥ 0 at which the
/// distance of their centres is at most the sum of their radii, while they approach.
///
/// Only the relative motion matters: a is described relative to b. If both fall freely in the same
/// gravity, their relative velocity is constant, so the same function holds for them, with the
/// velocities at t = 0.
///
/// This is the time of a collision: moving_spheres_impact() gives that of a touch in the step, as
/// for all other bodies. Spheres that touch or overlap now give 0 if they approach, and nothing
/// otherwise: a pair that has just collided does not collide again. Spheres that graze, touching
/// only for an instant, do touch. Floating-point arithmetic decides where it is certain, exact
/// arithmetic otherwise.
/// @param a, b at t = 0, m, finite, with radii that are not negative
/// @param velocity_a, velocity_b displacements in the step, m, finite. As the motion goes on
/// unchanged, any other unit of time may be the step: with velocities in m/s t is in s
/// @return t, in steps, at least 0 and without an end: more than 1 is after the step. Nothing if
/// they never touch, or only after the largest finite time. The decision is right for every finite
/// input; the time has a relative error of at most 256 u, without underflow
/// @see *Fundamentals of Computer Animation*, slides "How About 2 MOVING spheres?", which slice the
/// step instead
template <std::floating_point S>
std::optional<S> sphere_sphere_impact(const Sphere<S>& a, const Vector3<S>& velocity_a,
                                      const Sphere<S>& b, const Vector3<S>& velocity_b) {
  const auto sure = detail::sure_entry_terms<S>(a.centre - b.centre, velocity_a - velocity_b,
                                                a.radius + b.radius);
  if (sure) {
    if (!(sure->approach > S(0))) return std::nullopt;
    if (!(sure->gap > S(0))) return S(0);
    if (sure->depth < S(0)) return std::nullopt;
    return sure->gap / (sure->approach + std::sqrt(sure->depth));
  }
  const EntryTerms<Exact> terms = detail::exact_entry_terms(a, velocity_a, b, velocity_b);
  if (terms.approach.sign() <= 0) return std::nullopt;
  if (terms.gap.sign() <= 0) return S(0);
  if (!terms.enters()) return std::nullopt;
  const S time = entry_time<S>(terms);
  if (!std::isfinite(time)) return std::nullopt;
  return time;
}

/// Whether they touch at a time from 0 to `last`, in the sense of sphere_sphere_impact(): decided
/// exactly. A comparison of the rounded time with the end of a step would not be.
/// @param last in steps, finite: 1 for the end of the step
template <std::floating_point S>
bool spheres_touch_by(const Sphere<S>& a, const Vector3<S>& velocity_a, const Sphere<S>& b,
                      const Vector3<S>& velocity_b, S last) {
  if (last < S(0)) return false;
  const EntryTerms<Exact> terms = detail::exact_entry_terms(a, velocity_a, b, velocity_b);
  if (terms.approach.sign() > 0 && terms.gap.sign() <= 0) return true;
  return terms.enters_by(Exact(double(last)));
}
// [/sphere-sphere-impact]

}  // namespace contact
