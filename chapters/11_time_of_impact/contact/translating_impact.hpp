/// @file
/// Translating convex bodies of any kind: the time of impact by casting a ray at their Minkowski
/// difference, with a proof.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <contact/certificates.hpp>
#include <contact/exact.hpp>
#include <contact/impact_proof.hpp>
#include <contact/proximity.hpp>
#include <contact/ray_cast_difference.hpp>
#include <contact/support.hpp>
#include <contact/swept_difference.hpp>
#include <contact/vector.hpp>

namespace contact {

// [translating-impact]
/// When two translating bodies first meet in a step, with a proof.
struct TranslatingImpact {
  bool meets = false;  ///< whether they have a common point at a time of the step; touching counts
  /// Fraction of the step, from 0 to 1: they have no common point before it. 1 if they do not meet.
  double t = 1;
  /// If they meet, they do so at a time from t to t_high: at most 2^-40 of itself after t, or the
  /// next number.
  double t_high = 1;
  /// Separates them until t (separates_until()); if they do not meet, throughout the step
  /// (separates_throughout()). If t is 0, there is nothing to prove and there may be no normal. It
  /// leads from B to A; at the impact it is
  /// normal to the surface, up to rounding.
  SeparatingPlane plane;
  /// If they meet, proves that they do so at a time from t to t_high (meeting_proved_between()).
  CommonPointInMotion common;
};
// [/translating-impact]

namespace detail {

/// The plane with an exact normal.
inline SeparatingPlane exact_plane(const Vector3<Exact>& n) { return {rounded_direction(n), n}; }

/// Whether an interval of times is as narrow as promised.
inline bool is_narrow(double t, double t_high) {
  return t_high - t <= 0x1p-40 * t_high || std::nextafter(t, 1) >= t_high;
}

/// Until when a meeting is looked for, from a time before which there is none.
inline double end_of_search(double t) {
  return std::min(1.0, std::max(t * (1 + 0x1p-41), std::nextafter(t, 1)));
}

/// A time between two others: in the middle, or where their ratio is large of their exponents.
inline double time_between(double t, double t_high) {
  if (t_high <= 4 * t || t_high < 0x1p-1060) return t + (t_high - t) / 2;
  const int low = t > 0 ? std::ilogb(t) : -1074;
  return std::ldexp(1.0, (low + std::ilogb(t_high)) / 2);
}

// [decide-exactly]
/// The impact without rounding, from what is proved already.
///
/// First the interval in which the ray cast expects the meeting is tried. Otherwise whether they
/// meet until t_high is decided without rounding, and the time of that answer becomes
/// one end of the interval. A plane that separates them until t separates them at least until it
/// closes, which is close to the impact (Newton's method). Every other time lies in the middle, so
/// the interval at least halves with each two.
template <PolytopeCore A, PolytopeCore B>
TranslatingImpact decide_exactly(const A& a, const B& b, const Vector3<Exact>& w,
                                 TranslatingImpact found, CommonPointInMotion start) {
  const SweptDifference<A, B> difference(a, b, w);
  const auto ask = [&](double t) {
    const SweptAnswer answer = difference.between(0, t, start);
    if (answer.meets) {
      found.t_high = t;
      start = answer.common;
    } else {
      found.plane = exact_plane(answer.normal);
      found.t = std::min(1.0, std::max(t, difference.closes(answer.normal)));
    }
    return answer.meets;
  };
  if (start.count > 0 && found.t > 0) {  // the ray cast has found both times
    const SweptAnswer answer = difference.between(found.t, end_of_search(found.t), start);
    if (answer.meets) {
      found.meets = true;
      found.t_high = end_of_search(found.t);
      found.common = answer.common;
      return found;
    }
  }
  if (!(found.t > 0) && ask(0)) {
    found.meets = true;
    found.t = 0;
    found.common = start;
    return found;
  }
  if (!ask(1)) {
    found.t = 1;
    return found;
  }
  found.meets = true;
  bool middle = false;
  while (!is_narrow(found.t, found.t_high)) {
    const double near = end_of_search(found.t);
    const bool useful = !middle && near < found.t_high;
    ask(useful ? near : time_between(found.t, found.t_high));
    middle = !middle;
  }
  found.common = difference.between(found.t, found.t_high, start).common;
  return found;
}
// [/decide-exactly]

/// The impact of bodies in double: rounded, with bounds that prove it; in doubt without rounding.
template <PolytopeCore A, PolytopeCore B>
TranslatingImpact find_translating_impact(const A& a, const Vector3<double>& displacement_a,
                                          const B& b, const Vector3<double>& displacement_b) {
  TranslatingImpact found;
  if (!is_convex_body(a) || !is_convex_body(b) || !all_finite(displacement_a) ||
      !all_finite(displacement_b)) {
    return found;
  }
  const Vector3<double> w = displacement_a - displacement_b;
  RayCast<A, B> ray(a, b, w);
  const CastCandidate candidate = ray.cast();
  found.t = 0;
  CommonPointInMotion common;
  const Vector3<double> normal = near_one(candidate.normal);
  if (normal != Vector3<double>::Zero()) {
    const double t = closes_not_before(normal, a, displacement_a, b, displacement_b);
    if (t > 1) {
      found.t = 1;
      found.plane.normal = normal;
      return found;
    }
    if (t > 0) {
      found.t = t;
      found.plane.normal = normal;
    }
  }
  if (candidate.end == CastCandidate::End::meets) {
    const double t_high = found.t > 0 ? end_of_search(found.t) : 0;
    common = ray.meeting_at(t_high);
    if (certainly_meet(common, a, displacement_a, b, displacement_b)) {
      found.meets = true;
      found.t_high = t_high;
      found.common = common;
      return found;
    }
  }
  return decide_exactly(a, b, exact_relative(displacement_a, displacement_b), found, common);
}

}  // namespace detail

// [translating-impact-of]
/// When two translating bodies first meet in a step: spheres, capsules, lozenges, boxes, triangles
/// and hulls, in any pair.
///
/// Conservative in the strict sense: the bodies have no common point before t, proved by a plane,
/// and if they are said to meet, they do, proved by vertices. A rounded ray cast finds both, and
/// rounded bounds prove them; in doubt the question is decided without rounding. So for the stored
/// numbers no touch is missed and none is invented, also one for an instant, along a face, of
/// bodies without thickness, at the start and at the end of the step.
/// @param a, b at the start of the step, in float or double; what is_convex_body() refuses meets
/// nothing
/// @param displacement_a, displacement_b in the step, m; if one is not finite, nothing is met
/// @return see TranslatingImpact; t is 0 if they meet at the start, in whichever direction they
/// move. For all finite numbers, whatever their size
template <PolytopeCore A, PolytopeCore B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> TranslatingImpact
translating_impact(const A& a, const Vector3<ScalarOf<A>>& displacement_a, const B& b,
                   const Vector3<ScalarOf<B>>& displacement_b) {
  return detail::find_translating_impact(
      detail::as_double(a), Vector3<double>(displacement_a.template cast<double>()),
      detail::as_double(b), Vector3<double>(displacement_b.template cast<double>()));
}
// [/translating-impact-of]

}  // namespace contact
