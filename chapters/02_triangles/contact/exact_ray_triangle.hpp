/// @file
/// Ray and segment against triangle, decided without error for every finite input: floating point
/// where its own error bound allows it, exact arithmetic where not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/filter.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <limits>
#include <optional>

namespace contact {

/// float or double: the types whose every finite value is a double.
template <class S>
concept FloatOrDouble = std::same_as<S, float> || std::same_as<S, double>;

/// The query as differences of stored points. With T = double each difference is rounded once, with
/// T = Exact not at all.
template <Ring T>
struct LineAndTriangle {
  /// From the start of the line to its second point, or the ray's direction.
  Vector3<T> direction;
  /// Vertex a, relative to the start of the line.
  Vector3<T> a;
  /// Vertex b, relative to the start of the line.
  Vector3<T> b;
  /// Vertex c, relative to the start of the line.
  Vector3<T> c;
  /// Vertex a, relative to the end of the segment; unused for a ray.
  Vector3<T> end_a;
  /// The edge from a to b.
  Vector3<T> ab;
  /// The edge from a to c.
  Vector3<T> ac;
};

/// The five numbers whose signs determine the answer, and the denominator. Each is the determinant
/// of three differences, six times the volume of a tetrahedron:
/// - of_a = d·(b × c), of_b = d·(c × a), of_c = d·(a × b): on which side of each edge the line
///   passes;
/// - start = a·(ab × ac), end = end_a·(ab × ac): on which side of the plane the start and the end
///   are;
/// - denominator = d·(ab × ac) = of_a + of_b + of_c;
///
/// so that w_a = of_a/denominator and so on, and t = start/denominator.
enum class Determinant { of_a, of_b, of_c, start, end, denominator };

/// Calls volume(p, q, r) with the three rows of a determinant.
template <Ring T, class Volume>
auto evaluate(const LineAndTriangle<T>& x, Determinant which, const Volume& volume) {
  switch (which) {
    case Determinant::of_a:
      return volume(x.direction, x.b, x.c);
    case Determinant::of_b:
      return volume(x.direction, x.c, x.a);
    case Determinant::of_c:
      return volume(x.direction, x.a, x.b);
    case Determinant::start:
      return volume(x.a, x.ab, x.ac);
    case Determinant::end:
      return volume(x.end_a, x.ab, x.ac);
    case Determinant::denominator:
      break;
  }
  return volume(x.direction, x.ab, x.ac);
}

/// One query: a line and a triangle. The exact differences are computed only if the filter is not
/// certain.
class ExactQuery {
 public:
  /// @param filtered false omits the filter: the same answers, slower, to measure what it saves
  ExactQuery(const Ray<double>& ray, const Triangle<double>& triangle, bool filtered)
      : start_(ray.origin),
        second_(ray.direction),
        triangle_(triangle),
        is_segment_(false),
        filtered_(filtered) {
    if (filtered_) rounded_ = differences<double>();
  }
  /// The same for a segment.
  ExactQuery(const Segment<double>& segment, const Triangle<double>& triangle, bool filtered)
      : start_(segment.start),
        second_(segment.end),
        triangle_(triangle),
        is_segment_(true),
        filtered_(filtered) {
    if (filtered_) rounded_ = differences<double>();
  }

  /// Whether every coordinate is finite; the other functions require it.
  bool finite() const {
    return all_finite(start_) && all_finite(second_) && all_finite(triangle_.a) &&
           all_finite(triangle_.b) && all_finite(triangle_.c);
  }

  // [decide]
  /// Whether the line meets the triangle. The query must be finite.
  bool meets() {
    // The line passes through the triangle if it passes all three edges on the same side; the
    // denominator has that sign too.
    int side = 0;
    for (const Determinant edge : {Determinant::of_a, Determinant::of_b, Determinant::of_c}) {
      const int s = sign(edge);
      if (s * side < 0) return false;
      if (s != 0) side = s;
    }
    if (side == 0) return false;  // all three are 0: in the plane, or the triangle has no area
    if (sign(Determinant::start) * side < 0) return false;  // the plane is behind the start
    return !is_segment_ || sign(Determinant::end) * side <= 0;
  }
  // [/decide]

  /// The hit of a query that meets.
  template <FloatOrDouble S>
  TriangleHit<S> hit() {
    const double last = is_segment_ ? 1.0 : std::numeric_limits<double>::infinity();
    const S t = ratio<S>(Determinant::start, last);
    const S of_a = ratio<S>(Determinant::of_a, 1.0);
    const S of_b = ratio<S>(Determinant::of_b, 1.0);
    const S of_c = ratio<S>(Determinant::of_c, 1.0);
    return {t, {of_a, of_b, of_c}};
  }

 private:
  Vector3<double> start_, second_;  // a ray's origin and direction, a segment's start and end
  Triangle<double> triangle_;
  bool is_segment_, filtered_;
  LineAndTriangle<double> rounded_;
  std::optional<LineAndTriangle<Exact>> exact_;

  template <Ring T>
  LineAndTriangle<T> differences() const {
    const auto as = [](const Vector3<double>& v) {
      return Vector3<T>(T(v.x()), T(v.y()), T(v.z()));
    };
    const Vector3<T> start = as(start_), second = as(second_);
    const Vector3<T> a = as(triangle_.a), b = as(triangle_.b), c = as(triangle_.c);
    LineAndTriangle<T> x{second, a - start, b - start, c - start, a, b - a, c - a};
    if (is_segment_) {
      x.direction = second - start;
      x.end_a = a - second;
    }
    return x;
  }

  Bounded roughly(Determinant which) const { return evaluate(rounded_, which, bounded_volume); }

  Exact exactly(Determinant which) {
    if (!exact_) exact_ = differences<Exact>();
    return evaluate(*exact_, which, [](const auto& p, const auto& q, const auto& r) {
      return Exact(p.dot(Vector3<Exact>(q.cross(r))));
    });
  }

  // [sign]
  /// The sign of a determinant: from the filter if it is certain, else from exact arithmetic.
  int sign(Determinant which) {
    if (filtered_) {
      const int certain = roughly(which).certain_sign();
      if (certain != 0) return certain;
    }
    return exactly(which).sign();
  }
  // [/sign]

  /// numerator/denominator, which is known to be between 0 and `high`.
  ///
  /// From the filter's values n and d it is off by at most (n.bound + |n/d| d.bound)/|D| with |D| ≥
  /// |d| − d.bound, and by u |n/d| for the division. If that is not below 2^-40 max(1, |n/d|), the
  /// exact quotient is taken and rounded once.
  template <FloatOrDouble S>
  S ratio(Determinant numerator, double high) {
    if (filtered_) {
      const Bounded n = roughly(numerator);
      const Bounded d = roughly(Determinant::denominator);
      const double value = n.value / d.value;
      const double error = n.bound + std::abs(value) * d.bound;
      const double room = 0x1p-41 * (std::abs(d.value) - d.bound) * std::max(1.0, std::abs(value));
      // Clamping to the range of the exact ratio cannot increase the error.
      if (error < room) return static_cast<S>(std::clamp(value, 0.0, high));
    }
    return quotient<S>(exactly(numerator), exactly(Determinant::denominator));
  }
};

/// The answer to a query.
template <FloatOrDouble S>
std::optional<TriangleHit<S>> answer(ExactQuery query) {
  if (!query.finite() || !query.meets()) return std::nullopt;
  return query.hit<S>();
}

/// A ray of floats, unchanged, as doubles.
template <FloatOrDouble S>
Ray<double> in_double(const Ray<S>& ray) {
  return {ray.origin.template cast<double>(), ray.direction.template cast<double>()};
}
/// A segment of floats, unchanged, as doubles.
template <FloatOrDouble S>
Segment<double> in_double(const Segment<S>& segment) {
  return {segment.start.template cast<double>(), segment.end.template cast<double>()};
}
/// A triangle of floats, unchanged, as doubles.
template <FloatOrDouble S>
Triangle<double> in_double(const Triangle<S>& triangle) {
  return {triangle.a.template cast<double>(), triangle.b.template cast<double>(),
          triangle.c.template cast<double>()};
}

/// (e) The exact test, for a Ray or a Segment of float or double: a floating-point filter, then
/// exact arithmetic.
///
/// The decision is right for every finite input; rounding, overflow and underflow do not affect it.
/// Touching counts; a line in the plane, a zero direction and a triangle without area give no hit,
/// decided exactly. An input that is not finite is no hit.
///
/// Limits: t is within 2^-40 max(1, |t|) of the exact value and each weight within 2^-40, and then
/// rounded to S. All are in range (t ≥ 0, for a segment t ≤ 1, weights from 0 to 1); the sum of the
/// weights is off by 2^-38 at most (float: and three roundings). A ray's t may lie beyond the
/// largest number of S: then it is infinite.
///
/// Source: the filter is a semi-static one after
/// Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
/// 1997; the determinants are those of Möller and Trumbore.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<TriangleHit<S>> intersect_exact(const Line& line, const Triangle<S>& triangle) {
  return answer<S>(ExactQuery(in_double(line), in_double(triangle), true));
}

/// (e) without its filter: the same decision, every determinant in exact arithmetic; t and the
/// weights are rounded once.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<TriangleHit<S>> intersect_exact_unfiltered(const Line& line,
                                                         const Triangle<S>& triangle) {
  return answer<S>(ExactQuery(in_double(line), in_double(triangle), false));
}

}  // namespace contact
