/// @file
/// Proofs that two convex bodies are disjoint, touch or overlap, and their check, which is separate
/// from the search for them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/body_contains.hpp>
#include <contact/bounded_differences.hpp>
#include <contact/exact.hpp>
#include <contact/exact_support.hpp>
#include <contact/outward.hpp>
#include <contact/plane.hpp>
#include <contact/support.hpp>
#include <contact/support_bounds.hpp>
#include <contact/vector.hpp>

namespace contact {

// [separating-plane]
/// A plane that is to separate two bodies A and B, given by its normal alone: if any plane
/// perpendicular to it separates them, one halfway between their supports does.
struct SeparatingPlane {
  /// From B to A, of any length; 0: no plane.
  Vector3<double> normal = Vector3<double>::Zero();
  /// If it is not 0, the normal: for bodies so close that no vector of doubles need separate them.
  /// `normal` is then rounded from it.
  Vector3<Exact> exact_normal;
};
// [/separating-plane]

// [common-point]
/// A point of each of two bodies, as a member of a common point.
struct Member {
  /// At least 0: that vertex of the core. Otherwise −1, and `point` is a point of the whole body.
  int vertex = -1;
  Vector3<double> point = Vector3<double>::Zero();  ///< m; for a vertex it is not used
};

/// Up to six pairs of points aᵢ of A and bᵢ of B that are to prove that the bodies meet, by
/// weights or by the positions of the differences aᵢ − bᵢ around the origin.
struct CommonPointProof {
  int count = 0;               ///< of pairs; 0: no common point
  std::array<Member, 6> of_a;  ///< aᵢ
  std::array<Member, 6> of_b;  ///< bᵢ
  std::array<double, 6>
      weights{};  ///< λᵢ ≥ 0, of any sum; Σ λᵢ aᵢ / Σ λᵢ is close to a common point
  /// If not empty, the weights: for those that no doubles are. `weights` are then rounded from
  /// them, up to a factor.
  std::vector<Exact> exact_weights;
};
// [/common-point]

namespace detail {

// [bounds-separate]
/// Whether bounds of the supports prove that n separates A from B strictly: fast, and false means
/// nothing. An upper bound of −(least n · x over A) + (largest over B) is negative.
template <ConvexBody A, ConvexBody B>
bool bounds_separate(const A& a, const B& b, const Vector3<double>& n) {
  const double in_front = support_up(a, Vector3<double>(-n)), behind = support_up(b, n);
  return std::isfinite(in_front) && std::isfinite(behind) && sum_up(in_front, behind) < 0;
}
// [/bounds-separate]

/// The normal of a plane without rounding; 0 if it has none or it is not finite.
inline Vector3<Exact> normal_of(const SeparatingPlane& plane) {
  if (!is_zero(plane.exact_normal)) return plane.exact_normal;
  return all_finite(plane.normal) ? exact_vector<double>(plane.normal) : Vector3<Exact>::Zero();
}

}  // namespace detail

// [separates]
/// Whether the plane proves that A and B are disjoint: whether one perpendicular to its normal has
/// A strictly in front and B strictly behind. Exact: first by bounds, in doubt without rounding.
/// @return false also if there is no normal, or a or b is no body
template <ConvexBody A, ConvexBody B>
bool separates(const SeparatingPlane& plane, const A& a, const B& b) {
  if (!is_convex_body(a) || !is_convex_body(b)) return false;
  const Vector3<Exact> n = detail::normal_of(plane);
  if (detail::is_zero(n)) return false;
  if (detail::is_zero(plane.exact_normal) && detail::bounds_separate(a, b, plane.normal))
    return true;
  return exact_separation_sign(a, b, n) > 0;
}

/// Whether the plane proves that A and B do not overlap: whether one perpendicular to its normal
/// has A in front of it or on it, and B behind it or on it. Exact.
/// @return false also if there is no normal, or a or b is no body
template <ConvexBody A, ConvexBody B>
bool separates_weakly(const SeparatingPlane& plane, const A& a, const B& b) {
  if (!is_convex_body(a) || !is_convex_body(b)) return false;
  const Vector3<Exact> n = detail::normal_of(plane);
  return !detail::is_zero(n) && exact_separation_sign(a, b, n) >= 0;
}
// [/separates]

namespace detail {

/// Whether a member is what it says: a vertex of the core, or a point of the body.
template <ConvexBody Body>
bool is_member(const Member& member, const Body& body) {
  if (member.vertex == -1) return all_finite(member.point) && contains(body, member.point);
  if constexpr (PolytopeCore<Body>) {
    return member.vertex >= 0 && member.vertex < vertex_count(body);
  } else {
    return false;
  }
}

/// A member without rounding, m.
template <ConvexBody Body>
Vector3<Exact> exact_member(const Member& member, const Body& body) {
  if constexpr (PolytopeCore<Body>) {
    if (member.vertex >= 0) return exact_vertex(body, member.vertex);
  }
  return exact_vector<double>(member.point);
}

/// A member in double, m: rounded for vertices of boxes and lozenges.
template <ConvexBody Body>
PositionAndOffset rounded_member(const Member& member, const Body& body) {
  if constexpr (PolytopeCore<Body>) {
    if (member.vertex >= 0) return vertex_from_position(body, member.vertex);
  }
  return {member.point};
}

template <ConvexBody A, ConvexBody B>
bool has_members(const CommonPointProof& common, const A& a, const B& b) {
  if (common.count < 1 || common.count > 6 || !is_convex_body(a) || !is_convex_body(b))
    return false;
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    if (!is_member(common.of_a[i], a) || !is_member(common.of_b[i], b)) return false;
  }
  return true;
}

/// By how much two bodies exceed their members: a radius counts only where all members are
/// vertices of the core, because a point of the body may be on its surface already.
struct Radii {
  double of_a = 0;  ///< m
  double of_b = 0;  ///< m
};
template <ConvexBody A, ConvexBody B>
Radii radii_beyond(const CommonPointProof& common, const A& a, const B& b) {
  bool vertices_of_a = true, vertices_of_b = true;
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    vertices_of_a = vertices_of_a && common.of_a[i].vertex >= 0;
    vertices_of_b = vertices_of_b && common.of_b[i].vertex >= 0;
  }
  return {vertices_of_a ? double(radius_of(a)) : 0, vertices_of_b ? double(radius_of(b)) : 0};
}

/// The differences aᵢ − bᵢ in double with bounds of their error.
template <ConvexBody A, ConvexBody B>
BoundedDifferences bounded_differences(const CommonPointProof& common, const A& a, const B& b) {
  BoundedDifferences differences(offset_size(a) + offset_size(b));
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    differences.add(rounded_member(common.of_a[i], a), rounded_member(common.of_b[i], b));
  }
  return differences;
}

/// The differences aᵢ − bᵢ without rounding, m.
template <ConvexBody A, ConvexBody B>
std::vector<Vector3<Exact>> exact_differences(const CommonPointProof& common, const A& a,
                                              const B& b) {
  std::vector<Vector3<Exact>> w;
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    w.push_back(exact_member(common.of_a[i], a) - exact_member(common.of_b[i], b));
  }
  return w;
}

/// The weights without rounding; empty if one is negative or not finite, or all are 0.
inline std::vector<Exact> exact_weights_of(const CommonPointProof& common) {
  const auto count = std::size_t(common.count);
  std::vector<Exact> weights = common.exact_weights;
  if (weights.empty()) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!std::isfinite(common.weights[i])) return {};
      weights.emplace_back(common.weights[i]);
    }
  }
  const auto negative = [](const Exact& x) { return x.sign() < 0; };
  const auto zero = [](const Exact& x) { return x.sign() == 0; };
  if (weights.size() != count || std::any_of(weights.begin(), weights.end(), negative) ||
      std::all_of(weights.begin(), weights.end(), zero)) {
    return {};
  }
  return weights;
}

// [weights-prove]
/// The sign of (rₐ + r_b) Σ λᵢ − |Σ λᵢ (aᵢ − bᵢ)|, without rounding; −1 for weights that are none.
///
/// If it is positive, Σ λᵢ aᵢ / Σ λᵢ and Σ λᵢ bᵢ / Σ λᵢ, points of the cores, are closer than the
/// sum of the radii: then the bodies overlap, because small translations do not separate them. If
/// it is 0, they meet.
template <ConvexBody A, ConvexBody B>
int sign_by_weights(const CommonPointProof& common, const A& a, const B& b) {
  const std::vector<Exact> weights = exact_weights_of(common);
  if (weights.empty()) return -1;
  const std::vector<Vector3<Exact>> w = exact_differences(common, a, b);
  Vector3<Exact> between = Vector3<Exact>::Zero();
  Exact sum;
  for (std::size_t i = 0; i < w.size(); ++i) {
    between += w[i] * weights[i];
    sum += weights[i];
  }
  const Radii radii = radii_beyond(common, a, b);
  const Exact reach = (Exact(radii.of_a) + Exact(radii.of_b)) * sum;
  return (reach * reach - between.dot(between)).sign();
}
// [/weights-prove]

/// The same by bounded double: 1 if it is certain to be positive, else 0.
template <ConvexBody A, ConvexBody B>
int certain_by_weights(const CommonPointProof& common, const A& a, const B& b) {
  if (!common.exact_weights.empty()) return 0;
  const Radii radii = radii_beyond(common, a, b);
  const double reach = sum_down(radii.of_a, radii.of_b);
  if (!(reach > 0)) return 0;
  return bounded_differences(common, a, b).distance_up(common.weights) < reach ? 1 : 0;
}

// [surrounds]
/// Whether the origin is an interior point of the hull of the points w, without rounding.
///
/// It is not if and only if some n ≠ 0 has n · w ≥ 0 for all of them. If they span space, these n
/// form a pointed cone, one of whose edges is perpendicular to two independent w: so it suffices to
/// try n = ±wᵢ × wⱼ. Each is refuted by determinants of both signs, n · wₖ > 0 and n · wₖ < 0.
template <class SignOfVolume>
bool surrounds_origin(std::size_t count, const SignOfVolume& sign_of_volume) {
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      bool positive = false, negative = false;
      for (std::size_t k = 0; k < count; ++k) {
        const int sign = k == i || k == j ? 0 : sign_of_volume(i, j, k);
        positive = positive || sign > 0;
        negative = negative || sign < 0;
      }
      if (positive != negative) return false;
      any = any || positive;
    }
  }
  return any;
}
// [/surrounds]

/// Whether the differences of the members surround the origin: each determinant by a filter, in
/// doubt without rounding.
template <ConvexBody A, ConvexBody B>
bool differences_surround(const CommonPointProof& common, const A& a, const B& b) {
  if (common.count < 4) return false;
  const BoundedDifferences bounded = bounded_differences(common, a, b);
  std::vector<Vector3<Exact>> exact;
  return surrounds_origin(std::size_t(common.count),
                          [&](std::size_t i, std::size_t j, std::size_t k) {
                            const int sign = bounded.certain_sign_of_volume(i, j, k);
                            if (sign != 0) return sign;
                            if (exact.empty()) exact = exact_differences(common, a, b);
                            return exact[i].dot(Vector3<Exact>(exact[j].cross(exact[k]))).sign();
                          });
}

}  // namespace detail

// [overlap-proved]
/// Whether the common point proves that A and B overlap, that is, that no plane separates them, not
/// even one that both touch. Exact.
///
/// Either the weighted members are closer than the sum of the radii: |Σ λᵢ (aᵢ − bᵢ)| < (rₐ + r_b)
/// Σ λᵢ. Or the origin is an interior point of the hull of the differences aᵢ − bᵢ, which is part
/// of the set of all differences A − B: then a translation of A by any small vector leaves the
/// origin in it, so the bodies still meet. A separating plane, even a touched one, would not allow
/// all of these.
/// @return false also if a member is none or a or b is no body
template <ConvexBody A, ConvexBody B>
bool overlap_proved(const CommonPointProof& common, const A& a, const B& b) {
  if (!detail::has_members(common, a, b)) return false;
  return detail::certain_by_weights(common, a, b) > 0 ||
         detail::differences_surround(common, a, b) || detail::sign_by_weights(common, a, b) > 0;
}

/// Whether the common point proves that A and B have a point in common: as overlap_proved(), and
/// also if the weighted members are as far apart as the sum of the radii. Exact.
template <ConvexBody A, ConvexBody B>
bool meeting_proved(const CommonPointProof& common, const A& a, const B& b) {
  if (!detail::has_members(common, a, b)) return false;
  return detail::certain_by_weights(common, a, b) > 0 ||
         detail::sign_by_weights(common, a, b) >= 0 || detail::differences_surround(common, a, b);
}
// [/overlap-proved]

// [near-common-point]
/// A point close to a common one, for drawing: Σ λᵢ aᵢ / Σ λᵢ, moved to Σ λᵢ bᵢ / Σ λᵢ by its share
/// of the radii, or by half. Rounded, so it need not be in either body.
/// @return m; 0 if there are no members or weights
template <ConvexBody A, ConvexBody B>
Vector3<double> near_common_point(const CommonPointProof& common, const A& a, const B& b) {
  Vector3<double> on_a = Vector3<double>::Zero(), on_b = on_a;
  double sum = 0;
  for (int i = 0; i < common.count; ++i) sum += common.weights[std::size_t(i)];
  if (!(sum > 0)) return on_a;
  const auto point = [](const detail::PositionAndOffset& p) {
    return Vector3<double>(p.position + p.offset);
  };
  for (std::size_t i = 0; i < std::size_t(common.count); ++i) {
    on_a += point(detail::rounded_member(common.of_a[i], a)) * (common.weights[i] / sum);
    on_b += point(detail::rounded_member(common.of_b[i], b)) * (common.weights[i] / sum);
  }
  const detail::Radii radii = detail::radii_beyond(common, a, b);
  const double reach = radii.of_a + radii.of_b;
  const double share = reach > 0 ? radii.of_a / reach : 0.5;
  return on_a + (on_b - on_a) * share;
}
// [/near-common-point]

}  // namespace contact
