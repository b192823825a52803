/// @file
/// The first time at which a moving point is on a moving segment or triangle, or two moving
/// segments have a common point: decided without rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <contact/exact.hpp>
#include <contact/exact_roots.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// A vector whose coordinates are polynomials of the time.
using MovingVector = Triple<ExactPolynomial>;

/// The vector between two points that move in straight lines, from 0 to 1.
/// @param from, to positions at t = 0 and at t = 1, m, finite
inline MovingVector moving_vector(const std::array<Vector3<double>, 2>& from,
                                  const std::array<Vector3<double>, 2>& to) {
  MovingVector between;
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t end) { return Exact(to[end](k)) - Exact(from[end](k)); };
    between[static_cast<std::size_t>(k)] = ExactPolynomial::between(at(0), at(1));
  }
  return between;
}

inline ExactPolynomial squared(const MovingVector& v) { return dot(v, v); }

/// A time at which an equation holds, for the sign of other polynomials.
struct ExactMoment {
  ExactPolynomial equation;
  ExactRoot root;

  /// The start of the step.
  static ExactMoment start() { return {{}, {Exact(0.0), Exact(0.0)}}; }
  int sign_of(const ExactPolynomial& q) const { return sign_at_root(q, equation, root); }
};

/// The bounds of a first time; none if it does not exist.
using FirstTime = std::optional<ExactRoot>;

inline FirstTime earlier(const FirstTime& x, const FirstTime& y) {
  if (!x || !y) return x ? x : y;
  return ExactRoot{std::min(x->low, y->low), std::min(x->high, y->high)};
}

/// The first root of p from 0 to 1 at which a condition holds.
/// @param p not 0
template <class Condition>
FirstTime first_root(const ExactPolynomial& p, const Condition& holds) {
  const ExactRoots all = exact_roots(p);
  for (const ExactRoot& root : all.roots) {
    if (holds(ExactMoment{all.polynomial, root})) return root;
  }
  return std::nullopt;
}

// [point-on-segment]
/// Two ends of a segment as seen from a point: the point is on the segment if and only if they have
/// opposite directions or one is 0, that is, if a × b = 0 and a · b ≤ 0. That holds for a segment
/// of length 0, too.
struct SeenSegment {
  ExactPolynomial off_line;  ///< |a × b|²
  ExactPolynomial along;     ///< a · b

  SeenSegment(const MovingVector& a, const MovingVector& b)
      : off_line(squared(cross(a, b))), along(dot(a, b)) {}

  bool contains_point(const ExactMoment& moment) const {
    return moment.sign_of(off_line) == 0 && moment.sign_of(along) <= 0;
  }
  /// The first time from 0 to 1 at which the point is on the segment. If it is on its line all the
  /// time, it can only come onto the segment at an end of it, where a · b = 0.
  FirstTime first_time() const {
    const ExactPolynomial& p = off_line.is_zero() ? along : off_line;
    const auto holds = [&](const ExactMoment& moment) { return contains_point(moment); };
    if (holds(ExactMoment::start())) return ExactRoot{Exact(0.0), Exact(0.0)};
    return p.is_zero() ? std::nullopt : first_root(p, holds);
  }
};
// [/point-on-segment]

// [point-on-triangle]
/// The first time from 0 to 1 at which a point is on a triangle, from its vertices as seen from the
/// point.
///
/// Then they lie in a plane with it: the volume a · (b × c) is 0, a cubic of the time. At a root of
/// it the normal n = a × b + b × c + c × a decides: if it is not 0, the point is on the triangle if
/// and only if no edge has it on its outer side, n · (a × b) ≥ 0 and so on; if it is 0, the
/// triangle is the union of its edges. If the volume is 0 all the time and the point is not on the
/// triangle at the start, it comes onto it through an edge: in the interior of a triangle with area
/// it would have been there just before, because the areas change continuously.
inline FirstTime first_time_on_triangle(const MovingVector& a, const MovingVector& b,
                                        const MovingVector& c) {
  const MovingVector ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  MovingVector n;
  for (std::size_t k = 0; k < 3; ++k) n[k] = ab[k] + bc[k] + ca[k];
  const std::array<SeenSegment, 3> edges{SeenSegment{a, b}, SeenSegment{b, c}, SeenSegment{c, a}};
  const auto contains_point = [&](const ExactMoment& moment) {
    if (moment.sign_of(squared(n)) == 0) {
      return std::any_of(edges.begin(), edges.end(),
                         [&](const SeenSegment& edge) { return edge.contains_point(moment); });
    }
    return moment.sign_of(dot(n, ab)) >= 0 && moment.sign_of(dot(n, bc)) >= 0 &&
           moment.sign_of(dot(n, ca)) >= 0;
  };
  const ExactPolynomial volume = dot(a, bc);
  if (!volume.is_zero()) return first_root(volume, contains_point);
  if (contains_point(ExactMoment::start())) return ExactRoot{Exact(0.0), Exact(0.0)};
  return earlier(earlier(edges[0].first_time(), edges[1].first_time()), edges[2].first_time());
}
// [/point-on-triangle]

// [segments-cross]
/// The first time from 0 to 1 at which the segments from p to q and from r to s have a common
/// point, from the differences of their ends p − r, p − s, q − r and q − s.
///
/// Then the four points lie in a plane: the volume w · (u × v) is 0, a cubic, with u = q − p, v =
/// s − r, w = r − p. At a root of it, with m = u × v, the lines meet at the fractions m · (w ×
/// v)/m² of the first segment and m · (w × u)/m² of the second. If m = 0, the segments are parallel
/// or one is a point: then they meet if and only if an end of one is on the other. If the volume is
/// 0 all the time and they are disjoint at the start, the first common point is an end of one: if
/// they cross inside both, they also did just before.
inline FirstTime first_time_of_segments(const MovingVector& pr, const MovingVector& ps,
                                        const MovingVector& qr, const MovingVector& qs) {
  const MovingVector none;
  const MovingVector rp = minus(none, pr), sp = minus(none, ps), sq = minus(none, qs);
  const MovingVector u = minus(qr, pr), v = minus(pr, ps), m = cross(u, v);
  const std::array<SeenSegment, 4> ends{SeenSegment{rp, sp}, SeenSegment{qr, qs},
                                        SeenSegment{rp, minus(none, qr)}, SeenSegment{sp, sq}};
  const ExactPolynomial whole = squared(m);
  const ExactPolynomial on_first = dot(m, cross(rp, v)), on_second = dot(m, cross(rp, u));
  const auto meet = [&](const ExactMoment& moment) {
    if (moment.sign_of(whole) == 0) {
      return std::any_of(ends.begin(), ends.end(),
                         [&](const SeenSegment& end) { return end.contains_point(moment); });
    }
    return moment.sign_of(on_first) >= 0 && moment.sign_of(whole - on_first) >= 0 &&
           moment.sign_of(on_second) >= 0 && moment.sign_of(whole - on_second) >= 0;
  };
  const ExactPolynomial volume = dot(rp, m);
  if (!volume.is_zero()) return first_root(volume, meet);
  if (meet(ExactMoment::start())) return ExactRoot{Exact(0.0), Exact(0.0)};
  return earlier(earlier(ends[0].first_time(), ends[1].first_time()),
                 earlier(ends[2].first_time(), ends[3].first_time()));
}
// [/segments-cross]

}  // namespace contact::detail
