/// @file
/// Lines and triangles over all finite doubles, on the border between hit and miss.
#pragma once

#include <support/generators.hpp>

#include <02_triangles/families.hpp>
#include <array>
#include <bit>
#include <cmath>
#include <contact/shapes.hpp>
#include <cstdint>
#include <limits>

namespace adversarial {

using Point = contact::Vector3<double>;
using generators::Random;

/// A line as two points or as a point and a direction: the caller uses it as a segment or as a ray.
struct Case {
  Point start, second;
  contact::Triangle<double> triangle;
};

/// Any finite double; every bit pattern is as likely as another.
inline double any_double(Random& random) {
  for (;;) {
    const double x = std::bit_cast<double>(random.bits());
    if (std::isfinite(x)) return x;
  }
}

template <class Draw>
Point point(Draw draw) {
  const double x = draw();
  const double y = draw();
  const double z = draw();
  return {x, y, z};
}

template <class Draw>
Case five_points(Draw draw) {
  const Point start = point(draw);
  const Point second = point(draw);
  const Point a = point(draw);
  const Point b = point(draw);
  const Point c = point(draw);
  return {start, second, {a, b, c}};
}

/// Random bit patterns: exponents from the whole range in one query.
inline Case bit_patterns(Random& random) {
  return five_points([&] { return any_double(random); });
}

/// Small whole numbers times one power of two from the smallest to the largest: every coincidence
/// of a grid, where products underflow or overflow.
inline Case scaled_grid(Random& random) {
  const int power = random.integer(-1074, 1020);
  return five_points([&] { return std::ldexp(double(random.integer(-3, 3)), power); });
}

/// As scaled_grid, with each coordinate a few ulps off now and then.
inline Case nudged_grid(Random& random) {
  const int power = random.chance(0.5) ? random.integer(-20, 20) : random.integer(-1060, 1000);
  return five_points([&] {
    double x = std::ldexp(double(random.integer(-3, 3)), power);
    if (random.chance(0.3)) {
      x = std::nextafter(x, random.chance(0.5) ? std::numeric_limits<double>::max()
                                               : -std::numeric_limits<double>::max());
    }
    return x;
  });
}

/// Coordinates from a list of extreme values.
inline Case extremes(Random& random) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  constexpr double normal = std::numeric_limits<double>::min();
  constexpr double large = std::numeric_limits<double>::max();
  constexpr std::array<double, 12> list{0.0, -0.0, tiny,  -tiny,  normal, -normal,
                                        1.0, -1.0, large, -large, 1e300,  -1e-300};
  return five_points([&] { return list[static_cast<std::size_t>(random.integer(0, 11))]; });
}

/// Through a point of an edge or a vertex up to rounding, at any scale.
inline Case through_edge(Random& random) {
  const double scale = random.chance(0.3) ? std::ldexp(1.0, random.integer(-1040, 1010)) : 1.0;
  const auto draw = [&] { return random.uniform(-1, 1); };
  Case c = five_points(draw);
  const double share = random.chance(0.2) ? 0.0 : random.uniform();
  const Point target = c.triangle.a + share * (c.triangle.b - c.triangle.a);
  c.second = random.chance(0.5) ? Point(target - c.start) : Point(target + (target - c.start));
  c.start *= scale;
  c.second *= scale;
  c.triangle = {c.triangle.a * scale, c.triangle.b * scale, c.triangle.c * scale};
  return c;
}

/// A triangle thinner than its rounding errors, or without area: c is on a b up to rounding.
inline Case sliver(Random& random) {
  Case c = through_edge(random);
  const auto& [a, b, unused] = c.triangle;
  c.triangle.c = a + random.uniform(-0.5, 1.5) * (b - a);
  return c;
}

using Generator = Case (*)(Random&);
inline constexpr std::array<Generator, 6> all{bit_patterns, scaled_grid,  nudged_grid,
                                              extremes,     through_edge, sliver};

}  // namespace adversarial
