/// @file
/// A body against a half-space: decided exactly for every kind, because the support function is a
/// closed form. The normal of the half-space is the only one that can separate.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

#include <contact/certificates.hpp>
#include <contact/certified_cores.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/exact_support.hpp>
#include <contact/outward.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/smooth_proximity.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Whether the stored numbers describe a half-space: finite, and with a normal that is not 0. Its
/// length need not be 1: the half-space is all x with n · x ≤ k, as stored.
template <FloatOrDouble S>
bool is_half_space(const HalfSpace<S>& b) {
  return all_finite(b.boundary.normal) && std::isfinite(b.boundary.offset) &&
         b.boundary.normal != Vector3<S>::Zero();
}

namespace detail {

/// Whether a plane's normal is a positive multiple of that of a half-space. No other plane has a
/// half-space on one side.
template <FloatOrDouble S>
bool is_normal_of(const SeparatingPlane& plane, const HalfSpace<S>& b) {
  const Vector3<Exact> n = normal_of(plane), m = exact_vector<S>(b.boundary.normal);
  return is_zero(n.cross(m)) && n.dot(m).sign() > 0;
}

}  // namespace detail

// [half-space-proofs]
/// Whether the plane proves that A and a half-space B are disjoint. Exact.
template <ConvexBody A, FloatOrDouble S>
bool separates(const SeparatingPlane& plane, const A& a, const HalfSpace<S>& b) {
  return is_convex_body(a) && is_half_space(b) && detail::is_normal_of(plane, b) &&
         exact_separation_sign(a, b) > 0;
}
/// Whether the plane proves that A and a half-space B do not overlap. Exact.
template <ConvexBody A, FloatOrDouble S>
bool separates_weakly(const SeparatingPlane& plane, const A& a, const HalfSpace<S>& b) {
  return is_convex_body(a) && is_half_space(b) && detail::is_normal_of(plane, b) &&
         exact_separation_sign(a, b) >= 0;
}

/// The sign of k − (least n · x of a member of A with its radius), without rounding; −1 if there is
/// no member. Positive: that point is in the interior of the half-space, so A and B overlap. 0: it
/// is on its boundary, so they meet.
template <ConvexBody A, FloatOrDouble S>
int exact_sign_of_depth(const CommonPointProof& common, const A& a, const HalfSpace<S>& b) {
  if (common.count < 1 || common.count > 6 || !is_convex_body(a) || !is_half_space(b)) return -1;
  const Member& member = common.of_a[0];
  if (!detail::is_member(member, a)) return -1;
  const Vector3<Exact> n = exact_vector<S>(b.boundary.normal);
  const Exact radius(member.vertex >= 0 ? double(radius_of(a)) : 0.0);
  const Exact above = n.dot(detail::exact_member(member, a)) - Exact(double(b.boundary.offset));
  return -detail::sign_minus_roots(above, ExactFraction(radius * radius * n.dot(n)), {});
}
/// Whether the first member of A proves that A and a half-space B overlap. Exact. Members of B are
/// not used.
template <ConvexBody A, FloatOrDouble S>
bool overlap_proved(const CommonPointProof& common, const A& a, const HalfSpace<S>& b) {
  return exact_sign_of_depth(common, a, b) > 0;
}
/// Whether the first member of A proves that A and a half-space B have a point in common. Exact.
template <ConvexBody A, FloatOrDouble S>
bool meeting_proved(const CommonPointProof& common, const A& a, const HalfSpace<S>& b) {
  return exact_sign_of_depth(common, a, b) >= 0;
}
// [/half-space-proofs]

/// The proof with the bodies exchanged.
inline SeparatingPlane exchanged(const SeparatingPlane& plane) {
  const Vector3<double> zero = Vector3<double>::Zero();
  return {Vector3<double>(zero - plane.normal), Vector3<Exact>(-plane.exact_normal)};
}
/// The same with the two bodies exchanged.
inline CommonPointProof exchanged(CommonPointProof common) {
  std::swap(common.of_a, common.of_b);
  return common;
}
/// The same with the two bodies exchanged.
inline CertifiedProximity exchanged(CertifiedProximity answer) {
  answer.plane = exchanged(answer.plane);
  answer.common = exchanged(std::move(answer.common));
  return answer;
}

/// The same for a half-space A and a body B.
template <FloatOrDouble S, ConvexBody B>
bool separates(const SeparatingPlane& plane, const HalfSpace<S>& a, const B& b) {
  return separates(exchanged(plane), b, a);
}
/// The same for a half-space and a body.
template <FloatOrDouble S, ConvexBody B>
bool separates_weakly(const SeparatingPlane& plane, const HalfSpace<S>& a, const B& b) {
  return separates_weakly(exchanged(plane), b, a);
}
/// The same for a half-space and a body.
template <FloatOrDouble S, ConvexBody B>
bool overlap_proved(const CommonPointProof& common, const HalfSpace<S>& a, const B& b) {
  return overlap_proved(exchanged(common), b, a);
}
/// The same for a half-space and a body.
template <FloatOrDouble S, ConvexBody B>
bool meeting_proved(const CommonPointProof& common, const HalfSpace<S>& a, const B& b) {
  return meeting_proved(exchanged(common), b, a);
}

namespace detail {

/// A member of A that is lowest along n, as far as it can be found.
template <ConvexBody A>
CommonPointProof lowest_member(const A& a, const Vector3<double>& n) {
  CommonPointProof common;
  common.count = 1;
  common.weights[0] = 1;
  if constexpr (PolytopeCore<A>) {
    common.of_a[0].vertex = farthest_vertex(a, Vector3<Exact>(-exact_vector<double>(n)));
    common.of_b[0].point = vertex(a, common.of_a[0].vertex);
  } else {
    common.of_a[0] =
        pulled_inside(a, support<double>(a, Vector3<double>(-n)), inner_point(a), no_pull);
    if (common.of_a[0].vertex < -1) return {};
    common.of_b[0] = common.of_a[0];
  }
  return common;
}

// [certify-half-space]
/// The certified decision for a body and a half-space: bounds of the support along its normal, and
/// in doubt the support without rounding. Never undecided.
template <ConvexBody A>
CertifiedProximity certify_half_space(const A& a, const HalfSpace<double>& b) {
  if (!is_convex_body(a) || !is_half_space(b)) return no_body();
  const Vector3<double>& n = b.boundary.normal;
  const Vector3<double> down = -n;
  const double most = support_up(a, down), least = support_down(a, down);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double low = std::isfinite(most) ? -sum_up(most, b.boundary.offset) : -infinity;
  const double high = std::isfinite(least) ? -sum_down(least, b.boundary.offset) : infinity;
  CertifiedProximity answer;
  answer.plane.normal = n;
  answer.common = lowest_member(a, n);
  const int sign = low > 0 ? 1 : (high < 0 ? -1 : exact_separation_sign(a, b));
  answer.state = proximity_of_sign(sign);
  answer.low = sign > 0 ? std::max(0.0, along_unit_down(low, n)) : 0;
  answer.high = sign > 0 ? -along_unit_down(-high, n) : 0;
  return answer;
}
// [/certify-half-space]

}  // namespace detail

}  // namespace contact
