/// @file
/// What is right about a line and a triangle, in rational arithmetic and by another road than the
/// reference's: the crossing with the plane is found first, by a division, and then judged edge by
/// edge. No determinant is shared with the code under test.
#pragma once

#include <support/oracle.hpp>

#include <contact/shapes.hpp>
#include <optional>

namespace truth {

using oracle::Rational;
using oracle::Vector;

/// The exact hit of the stored numbers.
struct Hit {
  Rational t;
  Vector weights;
};

inline std::optional<Hit> meet(const Vector& origin, const Vector& direction, bool bounded,
                               const contact::Triangle<Rational>& triangle) {
  const Vector normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const Rational rate = normal.dot(direction);
  if (rate == 0) return std::nullopt;
  const Rational t = normal.dot(triangle.a - origin) / rate;
  if (t < 0 || (bounded && t > 1)) return std::nullopt;

  const Vector x = origin + t * direction;
  const auto inner_side = [&](const Vector& p, const Vector& q) -> Rational {
    return normal.dot((q - p).cross(x - p));
  };
  const Vector areas(inner_side(triangle.b, triangle.c), inner_side(triangle.c, triangle.a),
                     inner_side(triangle.a, triangle.b));
  if (areas.x() < 0 || areas.y() < 0 || areas.z() < 0) return std::nullopt;
  const Rational all = normal.dot(normal);
  return Hit{t, Vector(areas.x() / all, areas.y() / all, areas.z() / all)};
}

template <class S>
std::optional<Hit> meet(const contact::Ray<S>& ray, const contact::Triangle<S>& triangle) {
  return meet(oracle::exact(ray.origin), oracle::exact(ray.direction), false,
              oracle::exact(triangle));
}

template <class S>
std::optional<Hit> meet(const contact::Segment<S>& segment, const contact::Triangle<S>& triangle) {
  const Vector start = oracle::exact(segment.start);
  const Vector direction = oracle::exact(segment.end) - start;
  return meet(start, direction, true, oracle::exact(triangle));
}

}  // namespace truth
