/// @file
/// Disjoint, touching or overlapping with a proof, for bodies that are a core and a radius:
/// floating point first, and exactly if that proves nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <contact/certificates.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/gjk.hpp>
#include <contact/outward.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/support.hpp>
#include <contact/surrounding_set.hpp>
#include <contact/vector.hpp>

namespace contact {

// [certified-proximity]
/// How two bodies lie to each other, and the proof.
///
/// | state | plane | common | low, high |
/// |---|---|---|---|
/// | disjoint | separates them | close points, no proof | bounds of the distance |
/// | touching | separates them weakly | proves that they meet | 0 |
/// | overlapping | no proof | proves that they overlap | 0 |
/// | undecided | no proof | no proof | bounds of the signed distance |
///
/// A signed distance below 0 is minus the depth: how far one body must be moved so that they touch.
/// What is not a body has no points: then the state is disjoint, without a plane, and the bounds
/// are ∞.
struct CertifiedProximity {
  Proximity state = Proximity::undecided;  ///< the case, proved unless it is undecided
  SeparatingPlane plane;                   ///< see separates() and separates_weakly()
  CommonPointProof common;                 ///< see overlap_proved() and meeting_proved()
  double low = -std::numeric_limits<double>::infinity();  ///< m
  double high = std::numeric_limits<double>::infinity();  ///< m
};
// [/certified-proximity]

namespace detail {

/// The answer for what is not a body.
inline CertifiedProximity no_body() {
  CertifiedProximity answer;
  answer.state = Proximity::disjoint;
  answer.low = answer.high;
  return answer;
}

/// A lower bound of gap/|n| for a lower bound `gap` of a separation along n times |n|, by directed
/// rounding; −∞ if |n| is out of range.
inline double along_unit_down(double gap, const Vector3<double>& n) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const double squared = n.dot(n);
  if (!(squared > 0x1p-900 && squared < 0x1p900)) {
    return gap > 0 ? 0 : -std::numeric_limits<double>::infinity();
  }
  // The length has at most three roundings, the quotient one; the last product another.
  const double bound = gap / std::sqrt(squared) * (gap > 0 ? 1 - 8 * u : 1 + 8 * u);
  return std::nextafter(bound, -std::numeric_limits<double>::infinity());
}

/// A lower bound of the separation of A and B along n, times |n|; NaN or −∞ if it overflows.
template <ConvexBody A, ConvexBody B>
double separation_down(const A& a, const B& b, const Vector3<double>& n) {
  const double in_front = support_up(a, Vector3<double>(-n)), behind = support_up(b, n);
  if (!(std::isfinite(in_front) && std::isfinite(behind))) {
    return -std::numeric_limits<double>::infinity();
  }
  return -sum_up(in_front, behind);
}

/// The vertices of GJK's simplex as members, with its weights.
inline void set_members(CommonPointProof& common, const GjkResult<double>& near) {
  common.count = near.count;
  for (std::size_t i = 0; i < std::size_t(near.count); ++i) {
    common.of_a[i].vertex = near.simplex[i].a;
    common.of_b[i].vertex = near.simplex[i].b;
    common.weights[i] = near.weights[i];
  }
}

/// Differences as members, without weights.
inline CommonPointProof members_of(std::span<const ExactDifference> differences) {
  CommonPointProof common;
  common.count = static_cast<int>(differences.size());
  for (std::size_t i = 0; i < differences.size(); ++i) {
    common.of_a[i].vertex = differences[i].of.a;
    common.of_b[i].vertex = differences[i].of.b;
  }
  return common;
}

/// Weights without rounding, and as doubles of sum 1.
inline void set_weights(CommonPointProof& common, std::span<const Exact> weights) {
  Exact sum;
  common.exact_weights.assign(weights.begin(), weights.begin() + common.count);
  for (const Exact& weight : common.exact_weights) sum += weight;
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    common.weights[i] = quotient<double>(weights[i], sum);
  }
}

/// Weights for drawing of differences that surround the origin: those of a subset of at most four
/// whose hull contains it.
inline void set_weights_for_drawing(CommonPointProof& common,
                                    std::span<const ExactDifference> differences) {
  for (unsigned subset = 1; subset < 1U << differences.size(); ++subset) {
    std::vector<ExactDifference> chosen;
    for (std::size_t i = 0; i < differences.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(differences[i]);
    }
    if (chosen.size() > 4) continue;
    const auto inside = closest_inside(chosen);
    if (!inside || !is_zero(inside->direction)) continue;
    Exact sum;
    for (const Exact& weight : inside->weights) sum += weight;
    for (std::size_t i = 0, k = 0; i < differences.size(); ++i) {
      if ((subset >> i & 1U) != 0) common.weights[i] = quotient<double>(inside->weights[k++], sum);
    }
    return;
  }
}

inline SeparatingPlane plane_of(const Vector3<Exact>& normal) {
  return {rounded_direction(normal), normal};
}

/// Bounds of h/|V| − r, which is known to be positive, as (h² − r² V²)/(V² (h/|V| + r)).
inline void set_exact_bounds(CertifiedProximity& answer, const ExactClosest& c, const Exact& reach,
                             const Exact& beyond) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const Exact squared = c.direction.dot(c.direction);
  const double core = root_of_quotient(c.offset * c.offset, squared);
  const double fraction = quotient<double>(beyond, squared), sum = core + rounded<double>(reach);
  answer.low = 0;
  answer.high = std::nextafter(core * (1 + 8 * u), std::numeric_limits<double>::infinity());
  if (fraction > 0x1p-1000 && fraction < 0x1p1000 && sum > 0x1p-500 && sum < 0x1p500) {
    answer.low = fraction / sum * (1 - 16 * u);
    answer.high = fraction / sum * (1 + 16 * u);
  }
}

// [decide-exactly]
/// The exact decision for cores and radii: the squared distance of the cores is compared with the
/// squared sum of the radii; if both are 0, a weakly separating plane is looked for.
template <PolytopeCore A, PolytopeCore B>
CertifiedProximity decide_exactly(const A& a, const B& b, std::span<const DifferenceIndex> start) {
  CertifiedProximity answer;
  answer.low = answer.high = 0;
  const ExactClosest c = exact_gjk(a, b, start);
  const std::span<const ExactDifference> simplex(c.vertex.data(), std::size_t(c.count));
  answer.common = members_of(simplex);
  set_weights(answer.common, c.weights);
  const Exact reach = Exact(radius_of(a)) + Exact(radius_of(b));
  if (is_zero(c.direction) && reach.sign() == 0) {
    const PlaneOrSurrounding found = plane_or_surrounding(a, b, simplex);
    answer.plane = plane_of(found.normal);
    answer.state = Proximity::touching;
    if (found.surrounding.empty()) return answer;
    answer.state = Proximity::overlapping;
    answer.common = members_of(found.surrounding);
    set_weights_for_drawing(answer.common, found.surrounding);
    return answer;
  }
  const Exact beyond = c.offset * c.offset - reach * reach * c.direction.dot(c.direction);
  answer.state = is_zero(c.direction) ? Proximity::overlapping : proximity_of_sign(beyond.sign());
  answer.plane = plane_of(c.direction);
  if (answer.state == Proximity::disjoint) set_exact_bounds(answer, c, reach, beyond);
  return answer;
}
// [/decide-exactly]

/// A direction without over- or underflow in its square, in which case it is made a unit vector.
inline Vector3<double> of_moderate_length(const Vector3<double>& n) {
  const double squared = n.dot(n);
  return squared > 0x1p-180 && squared < 0x1p180 ? n : unit_of_any_size<double>(n);
}

// [certify-cores]
/// The certified decision for cores and radii. What GJK finds is only a guess; each answer in
/// floating point is a proof by bounds, and if there is none, decide_exactly() decides.
template <PolytopeCore A, PolytopeCore B>
CertifiedProximity certify_cores(const A& a, const B& b, const GjkStart<double>& start) {
  CertifiedProximity answer;
  const GjkResult<double> near = gjk(a, b, start);
  set_members(answer.common, near);
  const BoundedDifferences w = bounded_differences(answer.common, a, b);
  const double reach = sum_down(radius_of(a), radius_of(b));
  const double core_high = w.distance_up(answer.common.weights);
  if (core_high < reach || w.certainly_surround()) {
    answer.state = Proximity::overlapping;
    answer.low = answer.high = 0;
    return answer;
  }
  const Vector3<double> n = of_moderate_length(near.between);
  const double separation = separation_down(a, b, n);
  if (separation > 0) {
    answer.state = Proximity::disjoint;
    answer.plane.normal = n;
    answer.low = along_unit_down(separation, n);
    answer.high = sum_up(core_high, -reach);
    return answer;
  }
  std::array<DifferenceIndex, 4> simplex;
  for (std::size_t i = 0; i < 4; ++i) simplex[i] = {near.simplex[i].a, near.simplex[i].b};
  answer = decide_exactly(a, b, std::span(simplex).first(std::size_t(near.count)));
  return answer;
}
// [/certify-cores]

}  // namespace detail

}  // namespace contact
