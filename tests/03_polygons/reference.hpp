/// @file
/// The answers about polygons and segments in fractions, by other methods than the chapter's; and
/// random polygons that are hard.
#pragma once

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <contact/perimeter.hpp>
#include <contact/polygon_in_space.hpp>
#include <optional>
#include <vector>

namespace polygons {

using contact::Meeting;
using contact::Polygon;
using contact::Rule;
using contact::Segment2;
using contact::Vector2;
using contact::Vector3;
using contact::Where;
using generators::Random;
using oracle::Rational;

using Exact2 = Vector2<Rational>;
using ExactPolygon = Polygon<Rational>;

template <class S>
Exact2 exact(const Vector2<S>& v) {
  return {oracle::exact(v.x()), oracle::exact(v.y())};
}
template <class S>
ExactPolygon exact(const Polygon<S>& polygon) {
  ExactPolygon result;
  for (const auto& v : polygon) result.push_back(exact(v));
  return result;
}

inline Rational cross(const Exact2& u, const Exact2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Whether p is on the segment from a to b: p − a and p − b point in opposite directions, or p is
/// an end.
inline bool on_segment(const Exact2& a, const Exact2& b, const Exact2& p) {
  const Exact2 to_a = a - p, to_b = b - p;
  return cross(to_a, to_b) == 0 && to_a.dot(to_b) <= 0;
}

/// The winding number, or nothing on the boundary. The ray leaves p in the direction (1, e) with an
/// infinitely small e > 0, so no vertex is on it: a vertex at p's level is below the ray in front
/// of p and above its line behind p. The chapter's rule for such vertices is another one.
inline std::optional<int> winding(const ExactPolygon& polygon, const Exact2& p) {
  int sum = 0;
  const std::size_t n = polygon.size();
  // The sign of cross((1, e), v) = v.y − e v.x.
  const auto above = [](const Exact2& v) { return v.y() != 0 ? v.y() > 0 : v.x() < 0; };
  for (std::size_t i = 0; i < n; ++i) {
    if (on_segment(polygon[i], polygon[(i + 1) % n], p)) return std::nullopt;
    const Exact2 a = polygon[i] - p, b = polygon[(i + 1) % n] - p;
    if (above(a) == above(b)) continue;
    const Rational area = cross(a, b);
    if (area > 0 && above(b)) ++sum;
    if (area < 0 && above(a)) --sum;
  }
  return sum;
}

inline Where where(const ExactPolygon& polygon, const Exact2& p, Rule rule) {
  const std::optional<int> n = winding(polygon, p);
  if (!n) return Where::on;
  return (rule == Rule::non_zero ? *n != 0 : *n % 2 != 0) ? Where::inside : Where::outside;
}

/// How two segments meet, and the common part, in fractions.
struct Common {
  Meeting meeting = Meeting::none;
  Exact2 first = Exact2(0, 0);  ///< the point, or the start of the overlap along the first segment
  Exact2 last = Exact2(0, 0);   ///< the end of the overlap
};
inline Common common(const Exact2& a, const Exact2& b, const Exact2& c, const Exact2& d) {
  // All candidates for ends of the common part: ends on the other segment, and the crossing of the
  // lines.
  std::vector<Exact2> points;
  const auto add = [&points](const Exact2& p) {
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  };
  for (const Exact2& p : {a, b}) {
    if (on_segment(c, d, p)) add(p);
  }
  for (const Exact2& p : {c, d}) {
    if (on_segment(a, b, p)) add(p);
  }
  Common result;
  if (points.size() == 2) {
    result.meeting = Meeting::overlapping;
    const Exact2 direction = b - a;
    const bool swapped = direction.dot(points[1] - points[0]) < 0;
    result.first = points[swapped ? 1 : 0];
    result.last = points[swapped ? 0 : 1];
    return result;
  }
  if (points.size() == 1) {
    result.meeting = Meeting::touching;
    result.first = result.last = points[0];
    return result;
  }
  const Rational determinant = cross(b - a, d - c);
  if (determinant == 0) return result;
  const Rational t = cross(c - a, d - c) / determinant, s = cross(c - a, b - a) / determinant;
  if (t < 0 || t > 1 || s < 0 || s > 1) return result;
  result.meeting = Meeting::crossing;
  const Exact2 step = b - a;
  result.first = result.last = Exact2(a.x() + t * step.x(), a.y() + t * step.y());
  return result;
}
template <class S>
Common common(const Segment2<S>& s, const Segment2<S>& t) {
  return common(exact(s.a), exact(s.b), exact(t.a), exact(t.b));
}

/// A coordinate of a kind that is hard for signs.
inline constexpr int kinds = 7;
template <class S = double>
S coordinate(Random& random, int kind) {
  const double whole = random.integer(-3, 3);
  constexpr bool wide = sizeof(S) == sizeof(double);
  switch (kind) {
    case 0:
      return S(whole);
    case 1:
      return S(random.uniform(-1, 1));
    case 2:  // tenths: collinear on paper, not as stored
      return S(whole / 10 + random.integer(0, 1));
    case 3:  // a few ulps apart
      return S(0.5) + S(whole) * std::numeric_limits<S>::epsilon();
    case 4:  // at the largest scales
      return S(whole * (wide ? 0x1p1021 : 0x1p125));
    case 5:  // at the smallest
      return S(whole * (wide ? 0x1p-1074 : 0x1p-149));
    default:  // all scales in one polygon
      return random.chance(0.3) ? S(whole)
                                : S(whole * (random.chance(0.5) ? (wide ? 1e-150 : 1e-30)
                                                                : (wide ? 1e150 : 1e30)));
  }
}
template <class S = double>
Vector2<S> point(Random& random, int kind) {
  const S x = coordinate<S>(random, kind);
  return {x, coordinate<S>(random, kind)};
}
template <class S = double>
Polygon<S> polygon(Random& random, int kind, int fewest, int most) {
  Polygon<S> result;
  for (int n = random.integer(fewest, most); n > 0; --n) {
    result.push_back(point<S>(random, kind));
    if (random.chance(0.05)) result.push_back(result.back());
  }
  return result;
}

/// A point that is as close to a boundary as its type allows, or on it, or anywhere.
template <class S = double>
Vector2<S> point_near(Random& random, int kind, const Polygon<S>& polygon) {
  if (polygon.empty() || random.chance(0.3)) return point<S>(random, kind);
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(polygon.size()) - 1));
  const Vector2<S>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
  if (random.chance(0.15)) return a;
  if (random.chance(0.2)) return {point<S>(random, kind).x(), a.y()};  // at a vertex's level
  const S t = random.chance(0.5) ? S(0.5) : S(random.uniform());
  Vector2<S> p(a.x() + t * (b.x() / 2 - a.x() / 2) * 2, a.y() + t * (b.y() / 2 - a.y() / 2) * 2);
  if (random.chance(0.5)) {
    const auto infinity = std::numeric_limits<S>::infinity();
    p.x() = std::nextafter(p.x(), random.chance(0.5) ? infinity : -infinity);
  }
  return contact::all_finite(p) ? p : a;
}

}  // namespace polygons
