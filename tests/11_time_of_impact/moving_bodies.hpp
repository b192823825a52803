/// @file
/// Random pairs of translating bodies of all kinds with a core and a radius.
#pragma once

#include <array>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/quaternion.hpp>
#include <contact/support.hpp>
#include <cstddef>
#include <string>
#include <variant>

#include "support/generators.hpp"

namespace moving_bodies {

using generators::Random;
using V = contact::Vector3<double>;
using Body = std::variant<contact::Sphere<double>, contact::Capsule<double>,
                          contact::Lozenge<double>, contact::OrientedBox<double>,
                          contact::Triangle<double>, contact::ConvexHull<double>>;
inline constexpr int kinds = 6;

/// Two bodies and their displacements.
struct Pair {
  Body a, b;
  V displacement_a = V::Zero();
  V displacement_b = V::Zero();
};

/// The families of pairs: of any orientation; on integers; of no thickness; a small fast body and a
/// thin one; of extreme sizes; far from the origin; sliding along each other.
enum class Family { plain, whole, flat, bullet, sized, far, sliding };
inline constexpr std::array<Family, 7> families{Family::plain,  Family::whole, Family::flat,
                                                Family::bullet, Family::sized, Family::far,
                                                Family::sliding};

inline V in_cube(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {x, y, z};
}

inline V on_integers(Random& random, int size) {
  const int x = random.integer(-size, size);
  const int y = random.integer(-size, size);
  const int z = random.integer(-size, size);
  return {double(x), double(y), double(z)};
}

/// How the coordinates of a body are drawn.
struct Style {
  bool whole = false;   ///< integers, and axis-aligned
  bool flat = false;    ///< half lengths and radii are often 0, and points often equal
  double extent = 1.0;  ///< m
};

inline Body body(Random& random, int kind, const V& centre, const Style& style) {
  const auto offset = [&]() -> V {
    if (style.flat && random.chance(0.3)) return V::Zero();
    return style.whole ? on_integers(random, 1) : V(in_cube(random, style.extent));
  };
  const auto length = [&]() -> double {
    if (style.flat && random.chance(0.5)) return 0;
    return style.whole ? random.integer(1, 2) : random.uniform(0.05, 1) * style.extent;
  };
  const auto point = [&]() -> V { return centre + offset(); };
  switch (kind) {
    case 0:
      return contact::Sphere<double>{centre, length()};
    case 1: {
      const V start = point();
      const V end = point();
      return contact::Capsule<double>{{start, end}, length()};
    }
    case 2: {
      const V corner = point();
      const V first = offset();
      const V second = offset();
      return contact::Lozenge<double>{corner, first, second, length()};
    }
    case 3: {
      const double x = length();
      const double y = length();
      const double z = length();
      const V axis = in_cube(random, 3);
      contact::Matrix3<double> axes = contact::Matrix3<double>::Identity();
      if (!style.whole)
        axes = contact::matrix_of(contact::normalised(contact::exponential<double>(axis)));
      return contact::OrientedBox<double>{centre, axes, V(x, y, z)};
    }
    case 4: {
      const V p = point();
      const V q = point();
      return contact::Triangle<double>{p, q, point()};
    }
    default: {
      contact::ConvexHull<double> hull;
      for (int count = random.integer(1, 9); count > 0; --count) hull.vertices.push_back(point());
      if (random.chance(0.5)) hull.radius = length();
      return hull;
    }
  }
}

/// The body at a time, up to rounding.
inline Body moved(const Body& body, const V& by) {
  Body result = body;
  std::visit(
      [&by](auto& b) {
        if constexpr (requires { b.vertices; }) {
          for (V& v : b.vertices) v += by;
        } else if constexpr (requires { b.core; }) {
          b.core.start += by;
          b.core.end += by;
        } else if constexpr (requires { b.corner; }) {
          b.corner += by;
        } else if constexpr (requires { b.a; }) {
          b.a += by;
          b.b += by;
          b.c += by;
        } else {
          b.centre += by;
        }
      },
      result);
  return result;
}

/// A pair of the family and of two kinds.
inline Pair make(Random& random, Family family, int kind_a, int kind_b) {
  Style style_a;
  style_a.whole = family == Family::whole || family == Family::sliding;
  style_a.flat = family == Family::flat || random.chance(0.1);
  if (family == Family::sized) style_a.extent = std::ldexp(1.0, random.integer(-300, 300));
  const double size = style_a.extent;
  Style style_b = style_a;
  if (family == Family::bullet) style_a.extent = 0.01;
  V at_a = style_a.whole ? on_integers(random, 3) : V(in_cube(random, 3 * size));
  V at_b = style_a.whole ? on_integers(random, 3) : V(in_cube(random, 3 * size));
  if (family == Family::far) {
    const V shift = in_cube(random, 1e7);
    at_a += shift;
    at_b += shift;
  }
  Pair pair{body(random, kind_a, at_a, style_a), body(random, kind_b, at_b, style_b), {}, {}};
  pair.displacement_a = style_a.whole ? on_integers(random, 4) : V(in_cube(random, 3 * size));
  pair.displacement_b = style_a.whole ? on_integers(random, 4) : V(in_cube(random, 3 * size));
  if (random.chance(0.5)) {
    const double share = random.chance(0.5) ? 1 : random.uniform(0.5, 3);
    pair.displacement_b = pair.displacement_a + (at_a - at_b) * share;
  }
  if (family == Family::bullet)
    pair.displacement_a = pair.displacement_b + (at_b - at_a) * random.uniform(0.9, 300);
  if (family == Family::sliding) {
    const int axis = random.integer(0, 2);
    pair.displacement_a(axis) = pair.displacement_b(axis) = 0;
  }
  return pair;
}

}  // namespace moving_bodies
