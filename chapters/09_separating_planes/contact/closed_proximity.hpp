/// @file
/// Disjoint, touching or overlapping: which of the three holds for two spheres, capsules, boxes or
/// half-spaces, decided exactly for the stored numbers by closed forms.
///
/// A body with a number that is not finite is undecided with every other.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

#include <contact/box_axes.hpp>
#include <contact/box_proximity.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/early_decision.hpp>
#include <contact/exact_distance.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

inline ExactFraction fraction(double x) { return ExactFraction(x); }
inline Vector3<ExactFraction> fractions(const Vector3<double>& v) {
  return {fraction(v.x()), fraction(v.y()), fraction(v.z())};
}
inline Segment<ExactFraction> fractions(const Segment<double>& s) {
  return {fractions(s.start), fractions(s.end)};
}
inline OrientedBox<ExactFraction> fractions(const OrientedBox<double>& box) {
  OrientedBox<ExactFraction> exact{fractions(box.centre), Matrix3<ExactFraction>(),
                                   fractions(box.half_lengths)};
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> axis = box.axes.col(i);
    exact.axes.col(i) = fractions(axis);
  }
  return exact;
}

/// The projection of a body on a direction n: smallest and largest n · x, and the sum of absolute
/// terms, which bounds their rounding.
struct Extent {
  double low = 0;   ///< m, times |n|
  double high = 0;  ///< m, times |n|
  double size = 0;  ///< m, times |n|
};

inline Extent extent_along(const Capsule<double>& c, const Vector3<double>& n) {
  const double start = n.dot(c.core.start);
  const double end = n.dot(c.core.end);
  const double reach = c.radius * std::sqrt(n.dot(n));
  return {std::min(start, end) - reach, std::max(start, end) + reach,
          n.cwiseAbs().dot(c.core.start.cwiseAbs().cwiseMax(c.core.end.cwiseAbs())) + reach};
}
inline Extent extent_along(const Sphere<double>& s, const Vector3<double>& n) {
  return extent_along(as_capsule(s), n);
}
inline Extent extent_along(const OrientedBox<double>& box, const Vector3<double>& n) {
  const double middle = n.dot(box.centre);
  const double reach = projected_radius(box, n);
  const Vector3<double> far =
      box.centre.cwiseAbs() + Vector3<double>(box.axes.cwiseAbs() * box.half_lengths);
  return {middle - reach, middle + reach, n.cwiseAbs().dot(far)};
}

/// What closest_points() takes of a body.
inline Segment<double> core_of(const Sphere<double>& s) { return {s.centre, s.centre}; }
inline const Segment<double>& core_of(const Capsule<double>& c) { return c.core; }
inline const OrientedBox<double>& core_of(const OrientedBox<double>& box) { return box; }

/// Bound on the error of a computed point of the core: γ(12) of its absolute terms.
inline double core_slack(const Capsule<double>& c) {
  const Vector3<double> sum = c.core.start.cwiseAbs() + c.core.end.cwiseAbs();
  return tolerance::gamma<double>(12) * sum.sum();
}
inline double core_slack(const OrientedBox<double>& box) {
  const Vector3<double> sum =
      box.centre.cwiseAbs() + Vector3<double>(box.axes.cwiseAbs() * box.half_lengths);
  return tolerance::gamma<double>(12) * sum.sum();
}

}  // namespace detail

// [certificate]
/// Whether n certainly separates A from B: a plane perpendicular to n has A strictly in front and B
/// strictly behind. A result of true is a proof, wherever n came from; false means nothing.
///
/// The smallest n · x of A and the largest of B have at most 12 roundings each, so the error of
/// their difference is at most γ(12) of the sum of their absolute terms; γ(16) includes the
/// rounding of the bound.
/// @param a, b Sphere, Capsule or OrientedBox
/// @param n of any length but 0
template <class A, class B>
bool surely_separates(const A& a, const B& b, const Vector3<double>& n) {
  const detail::Extent in_front = detail::extent_along(a, n);
  const detail::Extent behind = detail::extent_along(b, n);
  const double size = in_front.size + behind.size;
  return detail::in_filter_range(size) && detail::in_filter_range(n.dot(n)) &&
         in_front.low - behind.high > tolerance::gamma<double>(16) * size;
}
// [/certificate]

// [capsules]
/// Which of the three cases holds for two capsules.
///
/// A floating-point filter proves the case where it can: the direction between the computed closest
/// points separates the capsules; or those points, each moved by its error bound, are closer than
/// the sum of the radii. If neither is certain, squared distances are compared in fractions: |p −
/// q|² and (r + R)², without a root and without rounding.
inline Proximity proximity(const Capsule<double>& a, const Capsule<double>& b) {
  const ClosestPoints<double> near = closest_points<double>(a.core, b.core);
  const Vector3<double> n = near.on_a - near.on_b;
  if (surely_separates(a, b, n)) return Proximity::disjoint;
  const double slack = detail::core_slack(a) + detail::core_slack(b);
  const double distance = std::sqrt(n.dot(n)) + slack;
  const double reach = a.radius + b.radius;
  if (detail::in_filter_range(reach) && distance < reach * (1 - 0x1p-48)) {
    return Proximity::overlapping;
  }
  if (!detail::is_finite_body(a) || !detail::is_finite_body(b)) return Proximity::undecided;
  const ExactFraction radius = detail::fraction(a.radius) + detail::fraction(b.radius);
  const ExactFraction squared =
      exact_squared_distance(detail::fractions(a.core), detail::fractions(b.core));
  return detail::proximity_of_sign((squared - radius * radius).sign());
}
// [/capsules]

// [capsule-box]
/// Which of the three cases holds for a capsule and a box. As for two capsules, after GJK cut
/// short; a capsule of radius 0 collides if its segment enters the interior of the box.
inline Proximity proximity(const Capsule<double>& a, const OrientedBox<double>& b) {
  const Proximity early = detail::early_decision(a, b);
  if (early != Proximity::undecided) return early;
  const ClosestPoints<double> near = closest_points<double>(a.core, b);
  const Vector3<double> n = near.on_a - near.on_b;
  if (surely_separates(a, b, n)) return Proximity::disjoint;
  const double distance = std::sqrt(n.dot(n)) + detail::core_slack(a) + detail::core_slack(b);
  if (detail::in_filter_range(a.radius) && distance < a.radius * (1 - 0x1p-48)) {
    return Proximity::overlapping;
  }
  if (!detail::is_finite_body(a) || !detail::is_finite_body(b)) return Proximity::undecided;
  const auto core = detail::fractions(a.core);
  const auto box = detail::fractions(b);
  const ExactFraction radius = detail::fraction(a.radius);
  const int sign = (exact_squared_distance(core, box) - radius * radius).sign();
  if (sign == 0 && radius.sign() == 0) {
    return segment_meets_box(core, box, true) ? Proximity::overlapping : Proximity::touching;
  }
  return detail::proximity_of_sign(sign);
}
/// A box and a capsule.
inline Proximity proximity(const OrientedBox<double>& a, const Capsule<double>& b) {
  return proximity(b, a);
}
// [/capsule-box]

// [spheres]
/// Which of the three cases holds for two spheres: |c − d|² is compared with (r + R)².
inline Proximity proximity(const Sphere<double>& a, const Sphere<double>& b) {
  const Vector3<double> between = a.centre - b.centre;
  const double reach = a.radius + b.radius;
  const double squared = between.dot(between);
  // Five roundings in the squared distance, three in the squared sum of the radii.
  const double room = tolerance::gamma<double>(8) * (squared + reach * reach);
  const double value = squared - reach * reach;
  if (detail::in_filter_range(squared + reach * reach) && std::abs(value) > room) {
    return value > 0 ? Proximity::disjoint : Proximity::overlapping;
  }
  if (!detail::is_finite_body(a) || !detail::is_finite_body(b)) return Proximity::undecided;
  const Vector3<Exact> exact = exact_vector<double>(a.centre) - exact_vector<double>(b.centre);
  const Exact sum = Exact(a.radius) + Exact(b.radius);
  return detail::proximity_of_sign((exact.dot(exact) - sum * sum).sign());
}
/// A sphere and a capsule.
inline Proximity proximity(const Sphere<double>& a, const Capsule<double>& b) {
  return proximity(as_capsule(a), b);
}
/// A capsule and a sphere.
inline Proximity proximity(const Capsule<double>& a, const Sphere<double>& b) {
  return proximity(a, as_capsule(b));
}
/// A sphere and a box.
inline Proximity proximity(const Sphere<double>& a, const OrientedBox<double>& b) {
  return proximity(as_capsule(a), b);
}
/// A box and a sphere.
inline Proximity proximity(const OrientedBox<double>& a, const Sphere<double>& b) {
  return proximity(as_capsule(b), a);
}
// [/spheres]

// [boxes]
/// Which of the three cases holds for two boxes, by the separating axis theorem (SAT).
///
/// The differences a − b of their points (Minkowski difference) form a polyhedron whose face
/// normals are among the fifteen axes. So the boxes are disjoint if the separation along one axis
/// is positive, touch if the largest is 0, and overlap otherwise. A floating-point filter with one
/// bound for all axes decides if it can; otherwise every sign is exact. Axes of parallel edges are
/// left out if they are exactly 0; those of nearly parallel edges are axes like all others.
/// @return undecided if a number is not finite
inline Proximity proximity(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  return detail::box_decision(a, b).state;
}
// [/boxes]

namespace detail {

/// The sign of value − radius |n|, exactly.
inline int sign_beyond(const Exact& value, double radius, const Vector3<Exact>& n) {
  if (value.sign() <= 0) return radius > 0 ? -1 : value.sign();
  const Exact r(radius);
  return (value * value - r * r * n.dot(n)).sign();
}

}  // namespace detail

// [half-space]
/// Which of the three cases holds for points and a half-space. The points of a convex hull decide
/// for the hull, since its lowest point is one of them. With a radius, each point is a ball.
///
/// The half-space is taken as stored: all x with n · x ≤ k, for n of any length. So the distance n
/// · c − k of a ball is compared with r |n|, by squares.
/// @param points at least one
/// @param radius m, not negative
inline Proximity proximity(const std::vector<Vector3<double>>& points, double radius,
                           const HalfSpace<double>& b) {
  const Vector3<double>& n = b.boundary.normal;
  const double length = std::sqrt(n.dot(n));
  bool finite = std::isfinite(radius) && detail::is_finite_body(b);
  for (const Vector3<double>& p : points) finite = finite && all_finite(p);
  if (!finite) return Proximity::undecided;
  int least = 1;
  for (const Vector3<double>& p : points) {
    const double value = n.dot(p) - b.boundary.offset - radius * length;
    const double size =
        n.cwiseAbs().dot(p.cwiseAbs()) + std::abs(b.boundary.offset) + radius * length;
    if (detail::in_filter_range(size) && std::abs(value) > tolerance::gamma<double>(16) * size) {
      if (value < 0) return Proximity::overlapping;
      continue;
    }
    const Vector3<Exact> exact = exact_vector<double>(n);
    const Exact above = exact.dot(exact_vector<double>(p)) - Exact(b.boundary.offset);
    least = std::min(least, detail::sign_beyond(above, radius, exact));
    if (least < 0) return Proximity::overlapping;
  }
  return detail::proximity_of_sign(least);
}
/// A capsule and a half-space.
inline Proximity proximity(const Capsule<double>& a, const HalfSpace<double>& b) {
  return proximity({a.core.start, a.core.end}, a.radius, b);
}
/// A sphere and a half-space.
inline Proximity proximity(const Sphere<double>& a, const HalfSpace<double>& b) {
  return proximity({a.centre}, a.radius, b);
}
/// A box against a half-space: n · c − Σ hᵢ |n · aᵢ| is compared with k.
inline Proximity proximity(const OrientedBox<double>& a, const HalfSpace<double>& b) {
  const Vector3<double>& n = b.boundary.normal;
  const detail::Extent extent = detail::extent_along(a, n);
  const double value = extent.low - b.boundary.offset;
  const double size = extent.size + std::abs(b.boundary.offset);
  if (detail::in_filter_range(size) && std::abs(value) > tolerance::gamma<double>(16) * size) {
    return value > 0 ? Proximity::disjoint : Proximity::overlapping;
  }
  if (!detail::is_finite_body(a) || !detail::is_finite_body(b)) return Proximity::undecided;
  const Vector3<Exact> exact = exact_vector<double>(n);
  Exact lowest = exact.dot(exact_vector<double>(a.centre)) - Exact(b.boundary.offset);
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> axis = a.axes.col(i);
    lowest -= Exact(a.half_lengths(i)) * abs(exact.dot(exact_vector<double>(axis)));
  }
  return detail::proximity_of_sign(lowest.sign());
}
/// A half-space and a sphere.
inline Proximity proximity(const HalfSpace<double>& a, const Sphere<double>& b) {
  return proximity(b, a);
}
/// A half-space and a capsule.
inline Proximity proximity(const HalfSpace<double>& a, const Capsule<double>& b) {
  return proximity(b, a);
}
/// A half-space and a box.
inline Proximity proximity(const HalfSpace<double>& a, const OrientedBox<double>& b) {
  return proximity(b, a);
}
// [/half-space]

// [witness]
/// What separated two bodies in an earlier step (temporal coherence). It is all that is stored
/// between steps, and losing it costs only time.
struct SeparatingWitness {
  Vector3<double> axis = Vector3<double>::Zero();  ///< from B to A, of any length; 0: none yet
  int box_axis = -1;  ///< of two boxes: which of the fifteen axes; −1: none yet
};

/// The first candidate for a separating direction, in floating point: from the closest point of B
/// to that of A.
template <class A, class B>
Vector3<double> likely_axis(const A& a, const B& b) {
  const ClosestPoints<double> near = closest_points<double>(detail::core_of(a), detail::core_of(b));
  return near.on_a - near.on_b;
}
/// For two boxes: of the fifteen axes the one with the largest separation relative to its length.
inline Vector3<double> likely_axis(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  Vector3<double> best = Vector3<double>::Zero();
  double largest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < box_axis_count; ++k) {
    const Vector3<double> n = box_axis(a, b, k);
    const double length = std::sqrt(n.dot(n));
    if (!(length > 0)) continue;
    const double separation = separation_along<double>(a, b, n) / length;
    if (separation > largest) {
      largest = separation;
      best = n.dot(Vector3<double>(a.centre - b.centre)) < 0 ? Vector3<double>(-n) : n;
    }
  }
  return best;
}

/// The same result as proximity(a, b), faster if the bodies are disjoint as before.
///
/// The witness is tested first. If it certainly separates them, they are disjoint: that is a proof,
/// and the exact proximity() would agree. Otherwise proximity() decides. So the result never
/// depends on the witness.
/// @param witness is replaced if the bodies are disjoint along another direction
template <class A, class B>
Proximity proximity_with_witness(const A& a, const B& b, SeparatingWitness& witness) {
  if (surely_separates(a, b, witness.axis)) return Proximity::disjoint;
  const Proximity answer = proximity(a, b);
  if (answer == Proximity::disjoint) witness.axis = likely_axis(a, b);
  return answer;
}
/// For two boxes the witness is the index of an axis, which rotates with the boxes.
inline Proximity proximity_with_witness(const OrientedBox<double>& a, const OrientedBox<double>& b,
                                        SeparatingWitness& witness) {
  if (witness.box_axis >= 0 && detail::box_axis_separates(a, b, witness.box_axis)) {
    return Proximity::disjoint;
  }
  const detail::BoxDecision decision = detail::box_decision(a, b);
  if (decision.state == Proximity::disjoint) witness.box_axis = decision.axis;
  return decision.state;
}
// [/witness]

}  // namespace contact
