/// @file
/// The right answers about a line and a triangle, in exact arithmetic and by another method than
/// the reference: the crossing with the plane is computed first, then tested edge by edge. No
/// determinant is shared with the code under test.
#pragma once

#include <support/oracle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/shapes.hpp>
#include <cstdint>
#include <optional>

namespace truth {

using oracle::Integer;
using oracle::Rational;
using oracle::Vector;

/// The exact hit.
struct Hit {
  Rational t;
  Vector weights;
};

/// @tparam T Rational or Integer: there is no division before the end, so whole numbers suffice
template <class T>
std::optional<Hit> meet(const contact::Vector3<T>& origin, const contact::Vector3<T>& direction,
                        bool bounded, const contact::Triangle<T>& triangle) {
  using V = contact::Vector3<T>;
  const V normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  T rate = normal.dot(direction);
  if (rate == 0) return std::nullopt;
  T way = normal.dot(triangle.a - origin);
  if (rate < 0) {
    rate = -rate;
    way = -way;
  }
  if (way < 0 || (bounded && way > rate)) return std::nullopt;

  const V x = rate * origin + way * direction;  // the crossing, times rate
  const auto inner_side = [&](const V& p, const V& q) -> T {
    return normal.dot((q - p).cross(x - rate * p));
  };
  const V areas(inner_side(triangle.b, triangle.c), inner_side(triangle.c, triangle.a),
                inner_side(triangle.a, triangle.b));
  if (areas.x() < 0 || areas.y() < 0 || areas.z() < 0) return std::nullopt;
  const Rational all(T(normal.dot(normal) * rate));
  return Hit{
      Rational(way) / Rational(rate),
      Vector(Rational(areas.x()) / all, Rational(areas.y()) / all, Rational(areas.z()) / all)};
}

/// Stored points as whole numbers: all coordinates times one power of two, which changes neither t
/// nor a weight. Rational arithmetic would compute common divisors at each step, which is slow for
/// numbers of a thousand digits.
class Whole {
 public:
  explicit Whole(const std::array<contact::Vector3<double>, 5>& points) {
    for (const auto& point : points) {
      for (const double x : point) {
        int exponent = 0;
        std::frexp(x, &exponent);
        if (x != 0) lowest_ = std::min(lowest_, exponent - 53);
      }
    }
  }
  contact::Vector3<Integer> operator()(const contact::Vector3<double>& v) const {
    return {whole(v.x()), whole(v.y()), whole(v.z())};
  }
  contact::Triangle<Integer> operator()(const contact::Triangle<double>& t) const {
    return {(*this)(t.a), (*this)(t.b), (*this)(t.c)};
  }

 private:
  Integer whole(double x) const {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    const Integer mantissa(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
    return x == 0 ? Integer(0) : Integer(mantissa << (exponent - 53 - lowest_));
  }
  int lowest_ = 1100;
};

template <class S>
std::optional<Hit> meet(const contact::Ray<S>& ray, const contact::Triangle<S>& triangle) {
  const contact::Vector3<double> origin = ray.origin.template cast<double>();
  const contact::Vector3<double> direction = ray.direction.template cast<double>();
  const contact::Triangle<double> t{triangle.a.template cast<double>(),
                                    triangle.b.template cast<double>(),
                                    triangle.c.template cast<double>()};
  const Whole whole({origin, direction, t.a, t.b, t.c});
  return meet<Integer>(whole(origin), whole(direction), false, whole(t));
}

template <class S>
std::optional<Hit> meet(const contact::Segment<S>& segment, const contact::Triangle<S>& triangle) {
  const contact::Vector3<double> start = segment.start.template cast<double>();
  const contact::Vector3<double> end = segment.end.template cast<double>();
  const contact::Triangle<double> t{triangle.a.template cast<double>(),
                                    triangle.b.template cast<double>(),
                                    triangle.c.template cast<double>()};
  const Whole whole({start, end, t.a, t.b, t.c});
  return meet<Integer>(whole(start), whole(end) - whole(start), true, whole(t));
}

}  // namespace truth
