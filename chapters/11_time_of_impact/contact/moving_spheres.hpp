/// @file
/// When two spheres that move during a step first touch.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include <contact/entry_time.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/plane.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The terms of two moving spheres in a number type with + − ×: see entry_terms().
template <class T>
struct MovingSphereTerms {
  T square, approach, gap, depth;
};

template <class T, FloatOrDouble S>
MovingSphereTerms<T> moving_sphere_terms(const Sphere<S>& a, const Vector3<S>& displacement_a,
                                         const Sphere<S>& b, const Vector3<S>& displacement_b) {
  const auto difference = [](const Vector3<S>& x, const Vector3<S>& y) {
    return minus(triple<T>(x.template cast<double>()), triple<T>(y.template cast<double>()));
  };
  // [sphere-terms]
  const Triple<T> d = difference(a.centre, b.centre);
  const Triple<T> w = difference(displacement_a, displacement_b);
  const T radius_sum = T(double(a.radius)) + T(double(b.radius));
  const T square = dot(w, w), reach = radius_sum * radius_sum;
  const Triple<T> across = cross(d, w);
  return {square, -dot(d, w), dot(d, d) - reach, reach * square - dot(across, across)};
  // [/sphere-terms]
}

/// −1: no touch in the step; 0: they meet at the start; 1: a touch later. `sure` becomes false if a
/// sign is not certain.
template <class T>
int moving_spheres_touch(const MovingSphereTerms<T>& t, bool& sure) {
  if (sign_of(t.gap, sure) <= 0) return 0;
  if (sign_of(t.approach, sure) <= 0 || sign_of(t.depth, sure) < 0) return -1;
  // In the step if the closest approach is, or if the gap at its end is closed.
  if (sign_of(t.approach - t.square, sure) <= 0) return 1;
  return sign_of((t.square - t.approach - t.approach) + t.gap, sure) <= 0 ? 1 : -1;
}

}  // namespace detail

// [moving-spheres]
/// When two moving spheres first touch in a step.
///
/// Relative to b, a moves by w in the step, from d. They touch when |d + w t|² = R², with the sum R
/// of the radii: square t² − 2 approach t + gap = 0, see EntryTerms. The first root is the time
/// gap / (approach + √depth), with a sum below; gap and depth are differences. What decides is the
/// sign of five polynomials: of gap, approach and depth, whether the closest approach is in the
/// step, and whether the gap at its end is closed. Each is computed with a bound on its error, and
/// where one or t is not certain all are computed without rounding: no touch is missed or invented.
/// @param a, b at the start, m, with radii that are not negative
/// @param displacement_a, displacement_b in the step, m
/// @return t, the fraction of the step, from 0 to 1; 0 if they meet at the start, in whichever
/// direction they move. Nothing if they do not touch in the step, or a number is not finite. An
/// instant counts. Error at most 32 u of t, or the smallest number. Never −0
/// @see *Fundamentals of Computer Animation*, slides "How About 2 MOVING spheres?", which slice the
/// step instead
template <FloatOrDouble S>
std::optional<S> moving_spheres_impact(const Sphere<S>& a, const Vector3<S>& displacement_a,
                                       const Sphere<S>& b, const Vector3<S>& displacement_b) {
  if (!all_finite(a.centre) || !all_finite(b.centre) || !all_finite(displacement_a) ||
      !all_finite(displacement_b) || !std::isfinite(a.radius) || !std::isfinite(b.radius)) {
    return std::nullopt;
  }
  bool sure = true;
  const auto rounded =
      detail::moving_sphere_terms<RunningError>(a, displacement_a, b, displacement_b);
  int touch = detail::moving_spheres_touch(rounded, sure);
  if (sure) {
    if (touch < 0) return std::nullopt;
    if (touch == 0) return S(0);
    const RunningError t = rounded.gap / (rounded.approach + sqrt(rounded.depth));
    if (t.bound <= 30 * tolerance::unit_roundoff<S> * t.value)
      return std::min(S(1), static_cast<S>(t.value));
  }
  const auto exact = detail::moving_sphere_terms<Exact>(a, displacement_a, b, displacement_b);
  touch = detail::moving_spheres_touch(exact, sure);
  if (touch < 0) return std::nullopt;
  if (touch == 0) return S(0);
  return std::min(
      S(1), entry_time<S>(EntryTerms<Exact>{exact.square, exact.approach, exact.gap, exact.depth}));
}
// [/moving-spheres]

}  // namespace contact
