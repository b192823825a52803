/// @file
/// Disjoint, touching or overlapping for every pair of kinds of body, with a proof.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>

#include <contact/certificates.hpp>
#include <contact/certified_cores.hpp>
#include <contact/closed_proximity.hpp>
#include <contact/early_decision.hpp>
#include <contact/exact_support.hpp>
#include <contact/gjk.hpp>
#include <contact/half_space_proximity.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/smooth_proximity.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// A body of any kind in double, not copied if it is one.
template <ConvexBody Body>
decltype(auto) as_double(const Body& body) {
  if constexpr (std::same_as<ScalarOf<Body>, double>) {
    return (body);
  } else {
    return in_double(body);
  }
}

template <ConvexBody A, ConvexBody B>
CertifiedProximity certify(const A& a, const B& b, const GjkStart<double>& start) {
  if (!is_convex_body(a) || !is_convex_body(b)) return no_body();
  if constexpr (PolytopeCore<A> && PolytopeCore<B>) {
    return certify_cores(a, b, start);
  } else {
    return SmoothSearch<A, B>(a, b).run(start);
  }
}

}  // namespace detail

// [certified-decision]
/// How two bodies lie to each other, with a proof.
///
/// For bodies that are a core and a radius the state is exact for the stored numbers, whatever
/// finite doubles they are: what floating point does not prove is decided without rounding. Where a
/// body is a cylinder or an ellipsoid, the state is proved or undecided; then `low` and `high`
/// bound the signed distance, and they differ by a few u of the coordinates.
/// @param a, b of any kinds, in float or double; what is_convex_body() refuses has no points
template <ConvexBody A, ConvexBody B>
CertifiedProximity certified_proximity(const A& a, const B& b) {
  return detail::certify(detail::as_double(a), detail::as_double(b), {});
}
/// A body and a half-space as stored: always decided. Where a smooth body touches the half-space,
/// or is in it by less than the distance of doubles, `common` need not prove that they meet:
/// exact_separation_sign() does.
template <ConvexBody A, FloatOrDouble S>
CertifiedProximity certified_proximity(const A& a, const HalfSpace<S>& b) {
  const Vector3<double> normal = b.boundary.normal.template cast<double>();
  return detail::certify_half_space(detail::as_double(a), {{normal, double(b.boundary.offset)}});
}
/// The same for a half-space and a body.
template <FloatOrDouble S, ConvexBody B>
CertifiedProximity certified_proximity(const HalfSpace<S>& a, const B& b) {
  return exchanged(certified_proximity(b, a));
}
// [/certified-decision]

// [proximity-of-any]
/// How two bodies lie to each other, for pairs without a closed form of their own: the state of
/// certified_proximity(), or where that is undecided perhaps a proved one.
///
/// GJK is asked first, cut short: most pairs are proved to be disjoint or to overlap long before
/// their distance is known.
template <ConvexBody A, ConvexBody B>
Proximity proximity(const A& a, const B& b) {
  const Proximity early = detail::early_decision(detail::as_double(a), detail::as_double(b));
  return early == Proximity::undecided ? certified_proximity(a, b).state : early;
}
/// The same for a body and a half-space.
template <ConvexBody A, FloatOrDouble S>
Proximity proximity(const A& a, const HalfSpace<S>& b) {
  return certified_proximity(a, b).state;
}
/// The same for a body and a half-space.
template <FloatOrDouble S, ConvexBody B>
Proximity proximity(const HalfSpace<S>& a, const B& b) {
  return certified_proximity(a, b).state;
}
// [/proximity-of-any]

// [proximity-witness]
/// What proved an earlier answer about two bodies (temporal coherence): all that is stored between
/// steps, and losing it costs only time.
struct ProximityWitness {
  Vector3<double> normal = Vector3<double>::Zero();  ///< separated them; 0: none
  /// A simplex of vertices with weights, which proved that they overlap, or from which GJK starts.
  GjkStart<double> simplex;
  std::array<double, 4> weights{};  ///< of its vertices
};

namespace detail {

/// Whether the witness proves the case of two bodies by bounds; for cores the simplex too.
template <ConvexBody A, ConvexBody B>
bool still_proves(const ProximityWitness& witness, const A& a, const B& b,
                  CertifiedProximity& answer) {
  const double separation = separation_down(a, b, witness.normal);
  if (separation > 0) {
    answer.state = Proximity::disjoint;
    answer.plane.normal = witness.normal;
    answer.low = std::max(0.0, along_unit_down(separation, witness.normal));
    return true;
  }
  if constexpr (PolytopeCore<A> && PolytopeCore<B>) {
    CommonPointProof common;
    common.count = witness.simplex.count;
    for (std::size_t i = 0; i < std::size_t(std::clamp(common.count, 0, 4)); ++i) {
      common.of_a[i].vertex = witness.simplex.a[i];
      common.of_b[i].vertex = witness.simplex.b[i];
      common.weights[i] = witness.weights[i];
    }
    if (common.count > 4 || !has_members(common, a, b)) return false;
    const BoundedDifferences w = bounded_differences(common, a, b);
    const double reach = sum_down(radius_of(a), radius_of(b));
    if (!(w.distance_up(common.weights) < reach) && !w.certainly_surround()) return false;
    answer = {Proximity::overlapping, {}, common, 0, 0};
    return true;
  }
  return false;
}

/// What an answer leaves for the next step.
inline ProximityWitness witness_of(const CertifiedProximity& answer) {
  ProximityWitness witness;
  if (answer.state == Proximity::disjoint) witness.normal = answer.plane.normal;
  witness.simplex.direction = answer.plane.normal;
  const CommonPointProof& common = answer.common;
  const auto count = std::size_t(common.count);
  if (count > 4) return witness;
  for (std::size_t i = 0; i < count; ++i) {
    if (common.of_a[i].vertex < 0 || common.of_b[i].vertex < 0) return witness;
    witness.simplex.a[i] = common.of_a[i].vertex;
    witness.simplex.b[i] = common.of_b[i].vertex;
    witness.weights[i] = common.weights[i];
  }
  witness.simplex.count = common.count;
  return witness;
}

}  // namespace detail

/// The state of certified_proximity(a, b) with a proof, faster if the bodies lie as before.
///
/// The witness is tested first. If it proves that the bodies are disjoint or overlap, so they do,
/// and certified_proximity() has the same state unless that is undecided; otherwise the search
/// starts from it. The state of bodies that are a core and a radius never depends on the witness;
/// the proof and the bounds of the distance may: if the witness separates them, `high` is ∞ and
/// `common` is empty.
/// @param witness of the same two bodies, or of none; replaced if it proves nothing any more
// [witness-first]
template <ConvexBody A, ConvexBody B>
CertifiedProximity certified_proximity_with_witness(const A& a, const B& b,
                                                    ProximityWitness& witness) {
  const auto& first = detail::as_double(a);
  const auto& second = detail::as_double(b);
  if (!is_convex_body(first) || !is_convex_body(second)) return detail::no_body();
  CertifiedProximity answer;
  if (detail::still_proves(witness, first, second, answer)) return answer;
  answer = detail::certify(first, second, witness.simplex);
  witness = detail::witness_of(answer);
  return answer;
}
// [/witness-first]
// [/proximity-witness]

}  // namespace contact
