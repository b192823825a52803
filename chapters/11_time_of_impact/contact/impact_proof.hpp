/// @file
/// Proofs about translating bodies: a plane that separates them until a time, and a common point at
/// a time in an interval. Their check is separate from the search for them.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/certificates.hpp>
#include <contact/exact.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/exact_support.hpp>
#include <contact/proximity.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

// [common-point-in-motion]
/// One to four differences of two vertices, each at a time: aᵢ − bᵢ + τᵢ w, with the relative
/// displacement w.
///
/// If their hull comes as close to the origin as the sum of the radii, the bodies meet at a time
/// from the smallest to the largest τᵢ. For with weights λᵢ of sum 1, Σ λᵢ (aᵢ − bᵢ + τᵢ w) is the
/// difference of a point of A's core and one of B's at the time Σ λᵢ τᵢ.
struct CommonPointInMotion {
  int count = 0;                  ///< of differences; 0: no common point
  std::array<int, 4> of_a{};      ///< which vertices of A's core
  std::array<int, 4> of_b{};      ///< which vertices of B's core
  std::array<double, 4> times{};  ///< τᵢ, fractions of the step, from 0 to 1
};
// [/common-point-in-motion]

namespace detail {

/// The relative displacement w = displacement of A − displacement of B, without rounding.
template <FloatOrDouble S>
Vector3<Exact> exact_relative(const Vector3<S>& displacement_a, const Vector3<S>& displacement_b) {
  return exact_vector<S>(displacement_a) - exact_vector<S>(displacement_b);
}

/// The sign of (least n · x over A) − (largest over B) + t n · w: positive if at the time t a plane
/// perpendicular to n has A strictly in front and B strictly behind.
template <ConvexBody A, ConvexBody B>
int exact_separation_sign_at(const A& a, const B& b, const Vector3<Exact>& w,
                             const Vector3<Exact>& n, double t) {
  const ExactSupport in_front = exact_support(a, Vector3<Exact>(-n));
  const ExactSupport behind = exact_support(b, n);
  return sign_minus_roots(n.dot(w) * Exact(t) - (in_front.linear + behind.linear), in_front.squared,
                          behind.squared);
}

}  // namespace detail

// [separates-until]
/// Whether the plane proves that A and B have no common point before t.
///
/// The separation along a normal changes linearly while both bodies translate. So if it is positive
/// at the start and not negative at t, it is positive at all times between: no bound on a speed of
/// approach is needed. Exact.
/// @param displacement_a, displacement_b in the step, m, finite
/// @param t fraction of the step, from 0 to 1; nothing comes before 0
/// @return false also if there is no normal, unless t is 0, or if a or b is no body
template <ConvexBody A, ConvexBody B>
bool separates_until(const SeparatingPlane& plane, const A& a,
                     const Vector3<ScalarOf<A>>& displacement_a, const B& b,
                     const Vector3<ScalarOf<B>>& displacement_b, double t) {
  if (!is_convex_body(a) || !is_convex_body(b) || !(t >= 0 && t <= 1)) return false;
  if (t == 0) return true;
  const Vector3<Exact> n = detail::normal_of(plane);
  const Vector3<Exact> w = detail::exact_relative(displacement_a, displacement_b);
  return !detail::is_zero(n) && detail::exact_separation_sign_at(a, b, w, n, 0) > 0 &&
         detail::exact_separation_sign_at(a, b, w, n, t) >= 0;
}

/// Whether the plane proves that A and B have no common point in the whole step, both ends
/// included. Exact.
template <ConvexBody A, ConvexBody B>
bool separates_throughout(const SeparatingPlane& plane, const A& a,
                          const Vector3<ScalarOf<A>>& displacement_a, const B& b,
                          const Vector3<ScalarOf<B>>& displacement_b) {
  if (!is_convex_body(a) || !is_convex_body(b)) return false;
  const Vector3<Exact> n = detail::normal_of(plane);
  const Vector3<Exact> w = detail::exact_relative(displacement_a, displacement_b);
  return !detail::is_zero(n) && detail::exact_separation_sign_at(a, b, w, n, 0) > 0 &&
         detail::exact_separation_sign_at(a, b, w, n, 1) > 0;
}
// [/separates-until]

namespace detail {

/// Whether the point of a hull that is closest to the origin is at most `reach` from it: h²/V² ≤
/// reach².
inline bool is_within(const ExactClosest& closest, const Exact& reach) {
  const Vector3<Exact>& v = closest.direction;
  return is_zero(v) || closest.offset * closest.offset <= reach * reach * v.dot(v);
}

template <PolytopeCore A, PolytopeCore B>
Exact radius_sum(const A& a, const B& b) {
  return Exact(static_cast<double>(radius_of(a))) + Exact(static_cast<double>(radius_of(b)));
}

}  // namespace detail

// [meeting-between]
/// Whether the differences prove that A and B have a common point at a time from `from` to `to`.
/// Exact.
/// @param from, to fractions of the step, 0 ≤ from ≤ to ≤ 1
/// @return false also if a vertex is none, a time is outside, or a or b is no body
template <PolytopeCore A, PolytopeCore B>
bool meeting_proved_between(const CommonPointInMotion& common, const A& a,
                            const Vector3<ScalarOf<A>>& displacement_a, const B& b,
                            const Vector3<ScalarOf<B>>& displacement_b, double from, double to) {
  if (!is_convex_body(a) || !is_convex_body(b) || common.count < 1 || common.count > 4 ||
      !(from >= 0 && to <= 1)) {
    return false;
  }
  const Vector3<Exact> w = detail::exact_relative(displacement_a, displacement_b);
  std::vector<ExactDifference> points;
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    const int p = common.of_a[i], q = common.of_b[i];
    const double time = common.times[i];
    if (p < 0 || q < 0 || p >= vertex_count(a) || q >= vertex_count(b)) return false;
    if (!(time >= from && time <= to)) return false;
    points.push_back({{p, q}, exact_vertex(a, p) - exact_vertex(b, q) + w * Exact(time)});
  }
  return detail::is_within(detail::closest_of_hull(points), detail::radius_sum(a, b));
}
// [/meeting-between]

}  // namespace contact
