/// @file
/// A translating convex body of any kind against a translating half-space.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include <contact/convex_shapes.hpp>
#include <contact/exact.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/exact_support.hpp>
#include <contact/impact_proof.hpp>
#include <contact/plane.hpp>
#include <contact/proximity.hpp>
#include <contact/support.hpp>
#include <contact/support_bounds.hpp>
#include <contact/translating_impact.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

// [half-space-motion]
/// The separation of a body and a half-space along its stored normal: rest + t change − √squared.
/// It is linear in t, and its sign is exact.
struct HalfSpaceMotion {
  Exact rest, change;
  ExactFraction squared;

  template <ConvexBody A>
  HalfSpaceMotion(const A& a, const HalfSpace<double>& b, const Vector3<Exact>& w) {
    const Vector3<Exact> n = exact_vector<double>(b.boundary.normal);
    const ExactSupport below = exact_support(a, Vector3<Exact>(-n));
    rest = -(below.linear + Exact(b.boundary.offset));
    change = n.dot(w);
    squared = below.squared;
  }
  int sign_at(double t) const {
    return sign_minus_roots(rest + change * Exact(t), squared, ExactFraction());
  }
};
// [/half-space-motion]

template <ConvexBody A>
TranslatingImpact find_half_space_impact(const A& a, const Vector3<double>& displacement_a,
                                         const HalfSpace<double>& b,
                                         const Vector3<double>& displacement_b) {
  TranslatingImpact found;
  const Vector3<double>& n = b.boundary.normal;
  if (!is_convex_body(a) || !all_finite(displacement_a) || !all_finite(displacement_b) ||
      !all_finite(n) || n == Vector3<double>::Zero() || !std::isfinite(b.boundary.offset)) {
    return found;
  }
  const HalfSpaceMotion motion(a, b, exact_relative(displacement_a, displacement_b));
  found.plane.normal = n;
  found.meets = motion.sign_at(1) <= 0;
  const bool at_start = motion.sign_at(0) <= 0;
  if (at_start) {
    found.meets = true;
    found.t = found.t_high = 0;
    return found;
  }
  if (!found.meets) return found;
  found.t = 0;
  const auto ask = [&](double t) { (motion.sign_at(t) > 0 ? found.t : found.t_high) = t; };
  // Rounded, so only a guess: two times around it are asked.
  const double least = -support_up(a, Vector3<double>(-n)) - b.boundary.offset;
  const double guess = least / dot3(n, Vector3<double>(displacement_b - displacement_a));
  for (const double t : {guess * (1 - 0x1p-43), guess * (1 + 0x1p-43)}) {
    if (t > found.t && t < found.t_high) ask(t);
  }
  while (!is_narrow(found.t, found.t_high)) ask(time_between(found.t, found.t_high));
  return found;
}

}  // namespace detail

// [half-space-impact]
/// When a translating body of any kind first meets a translating half-space in a step: spheres,
/// capsules, boxes, hulls, cylinders and ellipsoids.
///
/// The farthest point of the body against the normal decides: it is the same at all times. So the
/// separation is linear in t, its sign is computed without rounding, and bisection from a rounded
/// guess ends at the time of impact. No touch is missed and none is invented.
/// @param a, b at the start of the step; what is_convex_body() refuses, and a half-space without a
/// finite normal, meets nothing
/// @param displacement_a, displacement_b in the step, m; if one is not finite, nothing is met
/// @return see TranslatingImpact; the plane is that of the half-space, and there are no vertices
/// that prove the meeting: the same plane does
template <ConvexBody A>
TranslatingImpact translating_impact(const A& a, const Vector3<ScalarOf<A>>& displacement_a,
                                     const HalfSpace<ScalarOf<A>>& b,
                                     const Vector3<ScalarOf<A>>& displacement_b) {
  return detail::find_half_space_impact(
      detail::as_double(a), Vector3<double>(displacement_a.template cast<double>()),
      HalfSpace<double>{{b.boundary.normal.template cast<double>(), double(b.boundary.offset)}},
      Vector3<double>(displacement_b.template cast<double>()));
}
// [/half-space-impact]

}  // namespace contact
