/// @file
/// Two segments of the plane: whether and how they meet, and where, by the textbook's methods and
/// by one that is never wrong.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/error_free.hpp>
#include <contact/polygon.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace contact {

/// All points of the plane from a to b, both included. It may be a single point.
template <Ring S>
struct Segment2 {
  Vector2<S> a = Vector2<S>::Zero();  ///< m
  Vector2<S> b = Vector2<S>::Zero();  ///< m
};

/// How two segments meet.
enum class Meeting {
  none,        ///< no common point
  crossing,    ///< one common point, which is an end of neither
  touching,    ///< one common point, which is an end of at least one of them
  overlapping  ///< a common segment that is longer than a point
};

/// How and where two segments meet.
template <Scalar S>
struct SegmentCrossing {
  Meeting meeting = Meeting::none;        ///< how
  S along_first = S(0);                   ///< the point's fraction of the first segment, 0 to 1
  S along_second = S(0);                  ///< its fraction of the second segment, 0 to 1
  Vector2<S> point = Vector2<S>::Zero();  ///< m; the common point, or the start of the overlap
  Segment2<S> overlap;   ///< m; in the direction of the first segment; else twice the point
  S along_bound = S(0);  ///< the exact fractions differ from the two by at most this
  S point_bound = S(0);  ///< m; each coordinate of the exact point differs by at most this
};

namespace segments_detail {

/// Decides how two segments meet; side(a, b, c) is the orientation of three points.
template <Ring S, class Side>
Meeting meet_by(const Segment2<S>& s, const Segment2<S>& t, const Side& side) {
  // [meet]
  const auto apart = [](const S& a, const S& b, const S& c, const S& d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  if (apart(s.a.x(), s.b.x(), t.a.x(), t.b.x()) || apart(s.a.y(), s.b.y(), t.a.y(), t.b.y())) {
    return Meeting::none;
  }
  const int ta = side(s.a, s.b, t.a), tb = side(s.a, s.b, t.b);
  if (ta * tb > 0) return Meeting::none;  // t is on one side of the line of s
  const int sa = side(t.a, t.b, s.a), sb = side(t.a, t.b, s.b);
  if (sa * sb > 0) return Meeting::none;
  if (ta == 0 && tb == 0 && sa == 0 && sb == 0) {
    // On one line, and their boxes meet: the boxes' common part is the box of the common segment.
    const auto one_point = [](const S& a, const S& b, const S& c, const S& d) {
      return std::max(std::min(a, b), std::min(c, d)) == std::min(std::max(a, b), std::max(c, d));
    };
    const bool point = one_point(s.a.x(), s.b.x(), t.a.x(), t.b.x()) &&
                       one_point(s.a.y(), s.b.y(), t.a.y(), t.b.y());
    return point ? Meeting::touching : Meeting::overlapping;
  }
  return ta != 0 && tb != 0 && sa != 0 && sb != 0 ? Meeting::crossing : Meeting::touching;
  // [/meet]
}

/// (b − a) × (d − c) with its error bound, which is that of `bounded_orientation`: four roundings a
/// term.
inline Bounded bounded_cross(const Vector2<double>& a, const Vector2<double>& b,
                             const Vector2<double>& c, const Vector2<double>& d) {
  constexpr double five_u = 2.5 * std::numeric_limits<double>::epsilon();
  const double left = (b.x() - a.x()) * (d.y() - c.y());
  const double right = (b.y() - a.y()) * (d.x() - c.x());
  return {left - right, five_u * (std::abs(left) + std::abs(right)) + 0x1p-1000};
}

/// A quotient of two bounded numbers that is known to be from 0 to 1, with its error bound; the
/// bound is NaN or infinite if nothing is certain.
///
/// |n/d − N/D| ≤ (n.bound + |n/d| d.bound)/|D| with |D| ≥ |d| − d.bound. The rounding of n/d adds u
/// |n/d|, and 4u on everything covers the roundings of the bound itself. Clamping to the range of
/// the exact quotient cannot increase the error.
inline Bounded bounded_fraction(const Bounded& n, const Bounded& d) {
  constexpr double four_u = 2 * std::numeric_limits<double>::epsilon();
  const double value = n.value / d.value;
  const double smallest = std::abs(d.value) - d.bound;
  if (!(smallest > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double error = (n.bound + std::abs(value) * d.bound) / smallest + four_u * std::abs(value);
  return {std::clamp(value, 0.0, 1.0), error * (1 + 2 * four_u) + 0x1p-1000};
}

/// a + t (b − a), for a t from 0 to 1, with its error bound.
///
/// The difference is rounded (u), so is its product with t (u) and the sum (u of the result). An
/// error of t is multiplied by the difference.
inline Bounded bounded_between(double a, double b, const Bounded& t) {
  constexpr double four_u = 2 * std::numeric_limits<double>::epsilon();
  const double step = b - a;
  const double value = a + t.value * step;
  const double error =
      std::abs(step) * t.bound + four_u * (std::abs(t.value * step) + std::abs(value));
  return {value, error * (1 + 2 * four_u) + 0x1p-1000};
}

/// The meeting point of two segments that cross or touch in fractions of exact numbers: along the
/// first n/d, along the second m/d.
struct ExactFractions {
  Exact n;  ///< of the first segment's fraction
  Exact m;  ///< of the second segment's fraction
  Exact d;  ///< denominator, not 0
};
/// Computes them; the segments must not be parallel.
inline ExactFractions exact_fractions(const Segment2<double>& s, const Segment2<double>& t) {
  using polygon_detail::in_exact;
  const Vector2<Exact> a = in_exact(s.a), c = in_exact(t.a);
  const Vector2<Exact> along_s = in_exact(s.b) - a, along_t = in_exact(t.b) - c;
  const Vector2<Exact> between = c - a;
  return {cross2<Exact>(between, along_t), cross2<Exact>(between, along_s),
          cross2<Exact>(along_s, along_t)};
}

/// A segment as doubles.
template <std::floating_point S>
Segment2<double> in_double(const Segment2<S>& s) {
  return {polygon_detail::in_double(s.a), polygon_detail::in_double(s.b)};
}

/// Whether both ends are finite.
template <std::floating_point S>
bool is_finite(const Segment2<S>& s) {
  return all_finite(s.a) && all_finite(s.b);
}

/// The fraction of s at which p is, rounded once, for a p that is on the line of s. A segment that
/// is a point has 0.
template <std::floating_point S>
S fraction_of(const Segment2<S>& s, const Vector2<S>& p) {
  if (p == s.a) return S(0);
  if (p == s.b) return S(1);
  const int k = std::abs(s.b.x() - s.a.x()) >= std::abs(s.b.y() - s.a.y()) ? 0 : 1;
  const Exact start(s.a[k]);
  const Exact length = Exact(s.b[k]) - start;
  return length.sign() == 0 ? S(0) : quotient<S>(Exact(p[k]) - start, length);
}

/// What is common to two segments of one line that overlap or touch.
template <std::floating_point S>
void set_overlap(SegmentCrossing<S>& found, const Segment2<S>& s, const Segment2<S>& t) {
  const auto before = [](const Vector2<S>& p, const Vector2<S>& q) {
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  };
  // If s is a point, the direction of t serves as well as its opposite.
  const bool backwards = before(s.b, s.a);
  const auto earlier = [&](const Vector2<S>& p, const Vector2<S>& q) {
    return backwards ? before(q, p) : before(p, q);
  };
  Segment2<S> u = t;
  if (earlier(u.b, u.a)) std::swap(u.a, u.b);
  found.overlap.a = earlier(s.a, u.a) ? u.a : s.a;
  found.overlap.b = earlier(s.b, u.b) ? s.b : u.b;
  found.point = found.overlap.a;
}

/// The end that two segments which touch have in common.
template <std::floating_point S>
Vector2<S> touching_end(const Segment2<S>& s, const Segment2<S>& t) {
  const auto on = [](const Segment2<S>& u, const Vector2<S>& p) {
    return polygon_detail::in_box(u.a, u.b, p) && polygon_detail::side(u.a, u.b, p) == 0;
  };
  if (on(t, s.a)) return s.a;
  if (on(t, s.b)) return s.b;
  return on(s, t.a) ? t.a : t.b;
}

/// The fractions of a point that two segments share and that is an end of one, and the bound.
template <std::floating_point S>
void set_fractions(SegmentCrossing<S>& found, const Segment2<S>& s, const Segment2<S>& t) {
  found.along_first = fraction_of(s, found.point);
  found.along_second = fraction_of(t, found.point);
  found.along_bound = std::numeric_limits<S>::epsilon() / 4;  // half an ulp below 1
}

}  // namespace segments_detail

/// How two segments meet: the decision.
///
/// Right for every finite input, in any order of the segments and of their ends. Segments that are
/// points: touching if the point is on the other, else none. Collinear segments with a gap, and
/// segments with a coordinate that is not finite: none.
///
/// Boxes are compared first; then each segment's ends must not be on the same side of the line of
/// the other.
template <std::floating_point S>
Meeting meet(const Segment2<S>& s, const Segment2<S>& t) {
  if (!segments_detail::is_finite(s) || !segments_detail::is_finite(t)) return Meeting::none;
  return segments_detail::meet_by(s, t, [](const auto& a, const auto& b, const auto& c) {
    return polygon_detail::side(a, b, c);
  });
}

/// The same with orientations as the scalar rounds them: wrong for segments that nearly touch, that
/// are nearly parallel, or whose products under- or overflow. With S = Exact it is exact. NaN and
/// infinite coordinates are not refused: with them, segments far apart can touch or overlap.
template <Ring S>
Meeting meet_rounded(const Segment2<S>& s, const Segment2<S>& t) {
  return segments_detail::meet_by(s, t, [](const auto& a, const auto& b, const auto& c) {
    const S side = orientation<S>(a, b, c);
    return side > S(0) ? 1 : (side < S(0) ? -1 : 0);
  });
}

// [by-slopes]
/// The common point by the lines y = m x + c through the segments: the first idea.
///
/// Limits: a vertical segment has no slope, so it gives nothing, even where it crosses the other.
/// Steep segments lose digits in c. The tests of the range are on rounded numbers, so a crossing
/// near an end may be lost. Parallel segments give nothing, also if they overlap, and so do
/// segments that are points. NaN gives nothing; an infinite end may give a point, and a difference
/// that overflows a wrong one. All this needs a scalar that can divide by 0.
template <Scalar S>
std::optional<Vector2<S>> crossing_by_slopes(const Segment2<S>& s, const Segment2<S>& t) {
  const S m = (s.b.y() - s.a.y()) / (s.b.x() - s.a.x());
  const S n = (t.b.y() - t.a.y()) / (t.b.x() - t.a.x());
  const S x = ((t.a.y() - n * t.a.x()) - (s.a.y() - m * s.a.x())) / (m - n);
  const auto in_range = [&x](const Segment2<S>& u) {
    return std::min(u.a.x(), u.b.x()) <= x && x <= std::max(u.a.x(), u.b.x());
  };
  if (!in_range(s) || !in_range(t)) return std::nullopt;
  return Vector2<S>(x, s.a.y() + m * (x - s.a.x()));
}
// [/by-slopes]

// [by-parameters]
/// The common point by the fractions of both segments, from a + t (b − a) = c + u (d − c) by
/// Cramer's rule.
///
/// Limits: rounded; a fraction near 0 or 1 may fall on the wrong side, and a denominator that
/// rounds to 0 gives nothing. Parallel segments give nothing, also if they overlap, and so do
/// segments that are points or have a coordinate that is not finite. A denominator that overflows
/// can give `touching` for segments that do not meet. The fraction is off by about
/// 10u |r||s|/|r × s|.
template <Scalar S>
std::optional<SegmentCrossing<S>> crossing_by_parameters(const Segment2<S>& s,
                                                         const Segment2<S>& t) {
  const Vector2<S> along_s = s.b - s.a, along_t = t.b - t.a, between = t.a - s.a;
  const S denominator = cross2<S>(along_s, along_t);
  if (denominator == S(0)) return std::nullopt;
  const S first = cross2<S>(between, along_t) / denominator;
  const S second = cross2<S>(between, along_s) / denominator;
  const auto in_range = [](const S& f) { return S(0) <= f && f <= S(1); };
  if (!in_range(first) || !in_range(second)) return std::nullopt;
  SegmentCrossing<S> found;
  const auto end = [](const S& f) { return f == S(0) || f == S(1); };
  found.meeting = end(first) || end(second) ? Meeting::touching : Meeting::crossing;
  found.along_first = first;
  found.along_second = second;
  found.point = s.a + first * along_s;
  found.overlap = {found.point, found.point};
  return found;
}
// [/by-parameters]

/// How and where two segments meet, every number rounded once: the nearest of its type to the exact
/// one. Slow where they cross: exact arithmetic and four divisions.
///
/// The decision is that of `meet`, none if a coordinate is not finite. Fractions of a segment that
/// is a point are 0. Without a meeting all other fields are 0. The bounds are half an ulp (of the
/// point's larger coordinate; the smallest positive number if that is less), 0 where the point is
/// an end of a segment.
template <std::floating_point S>
SegmentCrossing<S> crossing_to_last_place(const Segment2<S>& s, const Segment2<S>& t) {
  using namespace segments_detail;
  SegmentCrossing<S> found;
  found.meeting = meet(s, t);
  if (found.meeting == Meeting::none) return found;
  if (found.meeting == Meeting::overlapping) {
    set_overlap(found, s, t);
    set_fractions(found, s, t);
    return found;
  }
  if (found.meeting == Meeting::touching) {
    found.point = touching_end(s, t);
    set_fractions(found, s, t);
  } else {
    const Segment2<double> first = in_double(s), second = in_double(t);
    const ExactFractions f = exact_fractions(first, second);
    found.along_first = quotient<S>(f.n, f.d);
    found.along_second = quotient<S>(f.m, f.d);
    for (int k = 0; k < 2; ++k) {
      const Exact start(first.a[k]);
      found.point[k] = quotient<S>(start * f.d + (Exact(first.b[k]) - start) * f.n, f.d);
    }
    found.along_bound = std::numeric_limits<S>::epsilon() / 4;
    found.point_bound = std::max(std::max(ulp(found.point.x()), ulp(found.point.y())) / 2,
                                 std::numeric_limits<S>::denorm_min());
  }
  found.overlap = {found.point, found.point};
  return found;
}

// [crossing]
/// How and where two segments meet: the book's choice.
///
/// The decision is that of `meet`, right for every finite input, and the fields are those of
/// `crossing_to_last_place`. Where segments cross, the fractions and the point are computed in
/// double, and `along_bound` and `point_bound` are proven bounds on their errors; if the fractions'
/// bound is above 2^-40, exact arithmetic computes all of them, to half an ulp. Ends of segments
/// and overlaps are copied without error.
///
/// The point is within its bound of the exact one. It need not be exactly on either segment.
template <std::floating_point S>
SegmentCrossing<S> crossing(const Segment2<S>& s, const Segment2<S>& t) {
  using namespace segments_detail;
  if (meet(s, t) != Meeting::crossing) return crossing_to_last_place(s, t);
  const Segment2<double> first = in_double(s), second = in_double(t);
  const Bounded d = bounded_cross(first.a, first.b, second.a, second.b);
  const Bounded f = bounded_fraction(bounded_cross(first.a, second.a, second.a, second.b), d);
  const Bounded g = bounded_fraction(bounded_cross(first.a, second.a, first.a, first.b), d);
  const Bounded x = bounded_between(first.a.x(), first.b.x(), f);
  const Bounded y = bounded_between(first.a.y(), first.b.y(), f);
  constexpr double most = 0x1p-40;
  if (!(f.bound <= most && g.bound <= most) ||
      !std::isfinite(x.value + y.value + x.bound + y.bound)) {
    return crossing_to_last_place(s, t);
  }
  const double along_bound = std::max(f.bound, g.bound);
  const double point_bound = std::max(x.bound, y.bound);
  SegmentCrossing<S> found;
  found.meeting = Meeting::crossing;
  found.along_first = static_cast<S>(f.value);
  found.along_second = static_cast<S>(g.value);
  found.point = {static_cast<S>(x.value), static_cast<S>(y.value)};
  found.overlap = {found.point, found.point};
  // For floats: half an ulp of float for the conversion, and one ulp to round the bound itself up.
  constexpr S u = std::is_same_v<S, double> ? S(0) : std::numeric_limits<S>::epsilon();
  found.along_bound = static_cast<S>(along_bound) * (1 + u) + u / 2;
  found.point_bound = static_cast<S>(point_bound) * (1 + u) +
                      (u == 0 ? S(0) : std::max(ulp(found.point.x()), ulp(found.point.y())));
  return found;
}
// [/crossing]

}  // namespace contact
