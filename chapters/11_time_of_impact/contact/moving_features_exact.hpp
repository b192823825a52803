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

/// The positions of moving vectors at a time.
inline Triple<Exact> at_time(const MovingVector& v, const Exact& t) {
  return {v[0].at(t), v[1].at(t), v[2].at(t)};
}

/// The bounds of a first time; none if it does not exist.
using FirstTime = std::optional<ExactRoot>;

inline FirstTime earlier(const FirstTime& x, const FirstTime& y) {
  if (!x || !y) return x ? x : y;
  return ExactRoot{std::min(x->low, y->low), std::min(x->high, y->high)};
}

// [condition-at-a-root]
/// Whether a condition holds for moving vectors at a root: with the vectors there if the root is a
/// dyadic number, else with polynomials and their signs at it.
/// @param holds holds(vectors, sign), for vectors of numbers with + − × and a function sign
template <std::size_t N, class Condition>
bool holds_at(const ExactRoot& root, const ExactPolynomial& equation,
              const std::array<MovingVector, N>& moving, const Condition& holds) {
  if (root.low == root.high) {
    std::array<Triple<Exact>, N> now;
    for (std::size_t i = 0; i < N; ++i) now[i] = at_time(moving[i], root.low);
    return holds(now, [](const Exact& x) { return x.sign(); });
  }
  return holds(moving, [&](const ExactPolynomial& q) { return sign_at_root(q, equation, root); });
}

/// The first root of p from 0 to 1 at which a condition holds.
/// @param p not 0
template <std::size_t N, class Condition>
FirstTime first_root(const ExactPolynomial& p, const std::array<MovingVector, N>& moving,
                     const Condition& holds) {
  const ExactRoots all = exact_roots(p);
  for (const ExactRoot& isolated : all.roots) {
    const ExactRoot root = refined(isolated, all.polynomial);
    if (holds_at(root, all.polynomial, moving, holds)) return root;
  }
  return std::nullopt;
}
// [/condition-at-a-root]

/// Whether a condition holds at the start of the step.
template <std::size_t N, class Condition>
bool holds_at_start(const std::array<MovingVector, N>& moving, const Condition& holds) {
  return holds_at({Exact(0.0), Exact(0.0)}, {}, moving, holds);
}

template <class T, class Sign>
bool is_null(const Triple<T>& v, const Sign& sign) {
  return sign(v[0]) == 0 && sign(v[1]) == 0 && sign(v[2]) == 0;
}

// [point-on-segment]
/// Whether a point is on a segment, from its ends as seen from the point: if and only if they have
/// opposite directions or one is 0, that is, if a × b = 0 and a · b ≤ 0. That holds for a segment
/// of length 0, too.
template <class T, class Sign>
bool on_segment(const Triple<T>& a, const Triple<T>& b, const Sign& sign) {
  return is_null(cross(a, b), sign) && sign(dot(a, b)) <= 0;
}

/// The first time from 0 to 1 at which a point is on a segment. If it is on its line all the time,
/// it can only come onto the segment at an end of it, where a · b = 0.
inline FirstTime first_time_on_segment(const MovingVector& a, const MovingVector& b) {
  const std::array<MovingVector, 2> ends{a, b};
  const auto holds = [](const auto& now, const auto& sign) {
    return on_segment(now[0], now[1], sign);
  };
  if (holds_at_start(ends, holds)) return ExactRoot{Exact(0.0), Exact(0.0)};
  const MovingVector off_line = cross(a, b);
  for (const ExactPolynomial& p : off_line) {
    if (!p.is_zero()) return first_root(p, ends, holds);
  }
  const ExactPolynomial along = dot(a, b);
  return along.is_zero() ? std::nullopt : first_root(along, ends, holds);
}
// [/point-on-segment]

// [point-on-triangle]
/// Whether a point in the plane of a triangle is on it, from the vertices as seen from the point:
/// if the normal n = a × b + b × c + c × a is not 0, if and only if no edge has the point on its
/// outer side, n · (a × b) ≥ 0 and so on; if it is 0, the triangle is the union of its edges.
template <class T, class Sign>
bool on_triangle(const std::array<Triple<T>, 3>& x, const Sign& sign) {
  const Triple<T> n = cross(minus(x[1], x[0]), minus(x[2], x[0]));
  if (is_null(n, sign)) {
    return on_segment(x[0], x[1], sign) || on_segment(x[1], x[2], sign) ||
           on_segment(x[2], x[0], sign);
  }
  return sign(dot(n, cross(x[0], x[1]))) >= 0 && sign(dot(n, cross(x[1], x[2]))) >= 0 &&
         sign(dot(n, cross(x[2], x[0]))) >= 0;
}

/// The first time from 0 to 1 at which a point is on a triangle, from its vertices as seen from the
/// point.
///
/// Then they lie in a plane with it: the volume a · (b × c) is 0, a cubic of the time, and
/// on_triangle() decides at its roots. If the volume is 0 all the time and the point is not on the
/// triangle at the start, it comes onto it through an edge: in the interior of a triangle with area
/// it would have been there just before, because the areas change continuously.
inline FirstTime first_time_on_triangle(const MovingVector& a, const MovingVector& b,
                                        const MovingVector& c) {
  const std::array<MovingVector, 3> vertices{a, b, c};
  const auto holds = [](const auto& now, const auto& sign) { return on_triangle(now, sign); };
  const ExactPolynomial volume = dot(a, cross(b, c));
  if (!volume.is_zero()) return first_root(volume, vertices, holds);
  if (holds_at_start(vertices, holds)) return ExactRoot{Exact(0.0), Exact(0.0)};
  return earlier(earlier(first_time_on_segment(a, b), first_time_on_segment(b, c)),
                 first_time_on_segment(c, a));
}
// [/point-on-triangle]

// [segments-cross]
/// Whether the segments from p to q and from r to s, in one plane, have a common point, from p − r,
/// p − s, q − r and q − s.
///
/// With u = q − p, v = s − r, w = r − p and m = u × v: if m is not 0, the lines meet at the
/// fractions m · (w × v)/m² of the first segment and m · (w × u)/m² of the second. If it is 0, the
/// segments are parallel or one is a point: then they meet if and only if an end of one is on the
/// other.
template <class T, class Sign>
bool segments_meet(const std::array<Triple<T>, 4>& x, const Sign& sign) {
  const auto& [pr, ps, qr, qs] = x;
  const Triple<T> u = minus(qr, pr), v = minus(pr, ps), m = cross(u, v);
  if (is_null(m, sign)) {
    // Seen from the other side all vectors are reversed, which changes neither × nor ·.
    return on_segment(pr, ps, sign) || on_segment(qr, qs, sign) || on_segment(pr, qr, sign) ||
           on_segment(ps, qs, sign);
  }
  const T whole = dot(m, m);
  for (const Triple<T>& other : {v, u}) {
    const T part = dot(m, cross(other, pr));  // m · (w × other)
    if (sign(part) < 0 || sign(whole - part) < 0) return false;
  }
  return true;
}

/// The first time from 0 to 1 at which two segments have a common point, from the differences of
/// their ends as for segments_meet().
///
/// Then the four ends lie in a plane: the volume w · (u × v) is 0, a cubic, and segments_meet()
/// decides at its roots. If it is 0 all the time and they are disjoint at the start, the first
/// common point is an end of one: if they cross inside both, they also did just before.
inline FirstTime first_time_of_segments(const MovingVector& pr, const MovingVector& ps,
                                        const MovingVector& qr, const MovingVector& qs) {
  const std::array<MovingVector, 4> differences{pr, ps, qr, qs};
  const auto holds = [](const auto& now, const auto& sign) { return segments_meet(now, sign); };
  const ExactPolynomial volume = dot(pr, cross(minus(qr, pr), minus(pr, ps)));
  if (!volume.is_zero()) return first_root(volume, differences, holds);
  if (holds_at_start(differences, holds)) return ExactRoot{Exact(0.0), Exact(0.0)};
  return earlier(earlier(first_time_on_segment(pr, ps), first_time_on_segment(qr, qs)),
                 earlier(first_time_on_segment(pr, qr), first_time_on_segment(ps, qs)));
}
// [/segments-cross]

}  // namespace contact::detail
