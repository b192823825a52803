/// @file
/// Separating, touching or colliding: which of the three two convex bodies do, without error for
/// the numbers as they are stored.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

#include <contact/box_axes.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/exact_distance.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [separation]
/// What two convex bodies do.
enum class Separation {
  colliding = -1,  ///< they overlap: no small enough shift parts them
  touching = 0,    ///< they have points in common, and some shift, however small, parts them
  separating = 1   ///< they have no point in common
};
// [/separation]

namespace detail {

inline Separation separation_of_sign(int sign) {
  return sign > 0 ? Separation::separating
                  : (sign < 0 ? Separation::colliding : Separation::touching);
}

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

/// What a body covers of a direction n: its lowest and highest n · x, and a sum of the sizes of the
/// terms in either, by which their rounding is bounded.
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
  const double reach = box_reach(box, n);
  const Vector3<double> far =
      box.centre.cwiseAbs() + Vector3<double>(box.axes.cwiseAbs() * box.half_lengths);
  return {middle - reach, middle + reach, n.cwiseAbs().dot(far)};
}

/// How far a point of the core that was computed may be off it: γ(12) of the sizes it is made of.
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
/// Whether n surely separates A from B: a plane across n has A strictly in front and B strictly
/// behind. If it says yes, that is proved, wherever n came from; no says nothing.
///
/// The lowest n · x of A and the highest of B go through at most 12 roundings each, so their
/// difference is off by at most γ(12) of the sum of their terms' sizes; γ(16) leaves room for the
/// bound's own rounding.
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
/// Which of the three cases two capsules are in.
///
/// Rounded arithmetic proves it where it can. The direction between the closest points that it
/// finds separates them; or those points, each moved by what rounding may have done to it, are
/// nearer than the radii. If neither is certain, squared distances are compared in fractions:
/// |p − q|² against (r + R)², with no root and no rounding.
inline Separation separation(const Capsule<double>& a, const Capsule<double>& b) {
  const ClosestPoints<double> near = closest_points<double>(a.core, b.core);
  const Vector3<double> n = near.on_a - near.on_b;
  if (surely_separates(a, b, n)) return Separation::separating;
  const double slack = detail::core_slack(a) + detail::core_slack(b);
  const double distance = std::sqrt(n.dot(n)) + slack;
  const double reach = a.radius + b.radius;
  if (detail::in_filter_range(reach) && distance < reach * (1 - 0x1p-48)) {
    return Separation::colliding;
  }
  const ExactFraction radius = detail::fraction(a.radius) + detail::fraction(b.radius);
  const ExactFraction squared =
      exact_squared_distance(detail::fractions(a.core), detail::fractions(b.core));
  return detail::separation_of_sign((squared - radius * radius).sign());
}
// [/capsules]

// [capsule-box]
/// Which of the three cases a capsule and a box are in. As for two capsules; a capsule of radius 0
/// collides if its segment enters the inside of the box.
inline Separation separation(const Capsule<double>& a, const OrientedBox<double>& b) {
  const ClosestPoints<double> near = closest_points<double>(a.core, b);
  const Vector3<double> n = near.on_a - near.on_b;
  if (surely_separates(a, b, n)) return Separation::separating;
  const double distance = std::sqrt(n.dot(n)) + detail::core_slack(a) + detail::core_slack(b);
  if (detail::in_filter_range(a.radius) && distance < a.radius * (1 - 0x1p-48)) {
    return Separation::colliding;
  }
  const auto core = detail::fractions(a.core);
  const auto box = detail::fractions(b);
  const ExactFraction radius = detail::fraction(a.radius);
  const int sign = (exact_squared_distance(core, box) - radius * radius).sign();
  if (sign == 0 && radius.sign() == 0) {
    return segment_meets_box(core, box, true) ? Separation::colliding : Separation::touching;
  }
  return detail::separation_of_sign(sign);
}
/// A box and a capsule.
inline Separation separation(const OrientedBox<double>& a, const Capsule<double>& b) {
  return separation(b, a);
}
// [/capsule-box]

// [spheres]
/// Which of the three cases two spheres are in: |c − d|² against (r + R)².
inline Separation separation(const Sphere<double>& a, const Sphere<double>& b) {
  const Vector3<double> between = a.centre - b.centre;
  const double reach = a.radius + b.radius;
  const double squared = between.dot(between);
  // Five roundings in the squared distance, three in the squared reach.
  const double room = tolerance::gamma<double>(8) * (squared + reach * reach);
  const double value = squared - reach * reach;
  if (detail::in_filter_range(squared + reach * reach) && std::abs(value) > room) {
    return value > 0 ? Separation::separating : Separation::colliding;
  }
  const Vector3<Exact> exact = exact_vector<double>(a.centre) - exact_vector<double>(b.centre);
  const Exact sum = Exact(a.radius) + Exact(b.radius);
  return detail::separation_of_sign((exact.dot(exact) - sum * sum).sign());
}
/// A sphere and a capsule.
inline Separation separation(const Sphere<double>& a, const Capsule<double>& b) {
  return separation(as_capsule(a), b);
}
/// A capsule and a sphere.
inline Separation separation(const Capsule<double>& a, const Sphere<double>& b) {
  return separation(a, as_capsule(b));
}
/// A sphere and a box.
inline Separation separation(const Sphere<double>& a, const OrientedBox<double>& b) {
  return separation(as_capsule(a), b);
}
/// A box and a sphere.
inline Separation separation(const OrientedBox<double>& a, const Sphere<double>& b) {
  return separation(as_capsule(b), a);
}
// [/spheres]

// [boxes]
/// Which of the three cases two boxes are in, by the separating axis theorem.
///
/// All points a − b of the two fill a polyhedron, and each of its faces is at right angles to one
/// of the fifteen axes. So the boxes separate if there is a gap along one of them, touch if the
/// largest is 0, and collide otherwise. Every sign is exact: rounded arithmetic answers if its
/// bound lets it, exact arithmetic if not. Axes of parallel edges are left out if they are 0, and
/// only then; nearly parallel edges are an axis like any other.
inline Separation separation(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  bool touching = false;
  for (int k = 0; k < box_axis_count; ++k) {
    const int sign = detail::sign_of_gap(a, b, k);
    if (sign == 1) return Separation::separating;
    if (sign == 0) touching = true;
  }
  return touching ? Separation::touching : Separation::colliding;
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
/// Which of the three cases points and a half-space are in: the points of a convex hull decide for
/// the hull, since its lowest point is one of them. With a radius, each point is a ball.
///
/// The half-space is taken as stored: all x with n · x ≤ k, whatever the length of n. So a ball's
/// distance n · c − k is held against r |n|, by squares.
/// @param points at least one
/// @param radius m, not negative
inline Separation separation(const std::vector<Vector3<double>>& points, double radius,
                             const HalfSpace<double>& b) {
  const Vector3<double>& n = b.boundary.normal;
  const double length = std::sqrt(n.dot(n));
  int least = 1;
  for (const Vector3<double>& p : points) {
    const double value = n.dot(p) - b.boundary.offset - radius * length;
    const double size =
        n.cwiseAbs().dot(p.cwiseAbs()) + std::abs(b.boundary.offset) + radius * length;
    if (detail::in_filter_range(size) && std::abs(value) > tolerance::gamma<double>(16) * size) {
      if (value < 0) return Separation::colliding;
      continue;
    }
    const Vector3<Exact> exact = exact_vector<double>(n);
    const Exact above = exact.dot(exact_vector<double>(p)) - Exact(b.boundary.offset);
    least = std::min(least, detail::sign_beyond(above, radius, exact));
    if (least < 0) return Separation::colliding;
  }
  return detail::separation_of_sign(least);
}
/// A capsule and a half-space.
inline Separation separation(const Capsule<double>& a, const HalfSpace<double>& b) {
  return separation({a.core.start, a.core.end}, a.radius, b);
}
/// A sphere and a half-space.
inline Separation separation(const Sphere<double>& a, const HalfSpace<double>& b) {
  return separation({a.centre}, a.radius, b);
}
/// A box against a half-space: n · c − Σ hᵢ |n · aᵢ| against k.
inline Separation separation(const OrientedBox<double>& a, const HalfSpace<double>& b) {
  const Vector3<double>& n = b.boundary.normal;
  const detail::Extent extent = detail::extent_along(a, n);
  const double value = extent.low - b.boundary.offset;
  const double size = extent.size + std::abs(b.boundary.offset);
  if (detail::in_filter_range(size) && std::abs(value) > tolerance::gamma<double>(16) * size) {
    return value > 0 ? Separation::separating : Separation::colliding;
  }
  const Vector3<Exact> exact = exact_vector<double>(n);
  Exact lowest = exact.dot(exact_vector<double>(a.centre)) - Exact(b.boundary.offset);
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> axis = a.axes.col(i);
    lowest -= Exact(a.half_lengths(i)) * abs(exact.dot(exact_vector<double>(axis)));
  }
  return detail::separation_of_sign(lowest.sign());
}
/// A half-space and a sphere.
inline Separation separation(const HalfSpace<double>& a, const Sphere<double>& b) {
  return separation(b, a);
}
/// A half-space and a capsule.
inline Separation separation(const HalfSpace<double>& a, const Capsule<double>& b) {
  return separation(b, a);
}
/// A half-space and a box.
inline Separation separation(const HalfSpace<double>& a, const OrientedBox<double>& b) {
  return separation(b, a);
}
// [/half-space]

// [witness]
/// A direction that separated two bodies the last time. It is the only thing that is kept from one
/// step to the next, and losing it loses time alone.
struct SeparatingWitness {
  Vector3<double> axis = Vector3<double>::Zero();  ///< from B to A, of any length; 0: none yet
};

/// The direction in which rounded arithmetic would first look for a separating plane.
template <class A, class B>
Vector3<double> likely_axis(const A& a, const B& b) {
  const ClosestPoints<double> near = closest_points<double>(a, b);
  return near.on_a - near.on_b;
}
/// That of two centres.
inline Vector3<double> likely_axis(const Sphere<double>& a, const Sphere<double>& b) {
  return a.centre - b.centre;
}
/// That of two segments.
inline Vector3<double> likely_axis(const Capsule<double>& a, const Capsule<double>& b) {
  return likely_axis(a.core, b.core);
}
/// That of a segment and a box.
inline Vector3<double> likely_axis(const Capsule<double>& a, const OrientedBox<double>& b) {
  return likely_axis(a.core, b);
}
/// That of a centre and a segment.
inline Vector3<double> likely_axis(const Sphere<double>& a, const Capsule<double>& b) {
  return likely_axis(as_capsule(a), b);
}
/// That of a centre and a box.
inline Vector3<double> likely_axis(const Sphere<double>& a, const OrientedBox<double>& b) {
  return likely_axis(as_capsule(a), b);
}
/// Of the fifteen axes the one with the largest gap for its length.
inline Vector3<double> likely_axis(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  Vector3<double> best = Vector3<double>::Zero();
  double largest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < box_axis_count; ++k) {
    const Vector3<double> n = box_axis(a, b, k);
    const double length = std::sqrt(n.dot(n));
    if (!(length > 0)) continue;
    const double gap = gap_along<double>(a, b, n) / length;
    if (gap > largest) {
      largest = gap;
      best = n.dot(Vector3<double>(a.centre - b.centre)) < 0 ? Vector3<double>(-n) : n;
    }
  }
  return best;
}

/// The same answer as separation(a, b), sooner where the bodies separate as they did before.
///
/// The witness is tried first. If it surely separates them, they separate: that is a proof, and
/// separation(), which is exact, would have said so. If it does not, separation() is asked. So the
/// answer never depends on the witness.
/// @param witness is replaced when the bodies separate along another direction
template <class A, class B>
Separation separation_with_witness(const A& a, const B& b, SeparatingWitness& witness) {
  if (surely_separates(a, b, witness.axis)) return Separation::separating;
  const Separation answer = separation(a, b);
  if (answer == Separation::separating) witness.axis = likely_axis(a, b);
  return answer;
}
// [/witness]

}  // namespace contact
