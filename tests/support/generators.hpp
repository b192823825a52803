/// @file
/// Inputs for tests and ladders, the same on every machine: seeded, with distributions of our own
/// (those of the standard library differ between libraries). Needs Eigen only, so a ladder can use
/// it in the page.
///
///     generators::Random random(42);
///     for (int i = 0; i < 10000; ++i) {
///       const auto family = generators::all_families[i % generators::all_families.size()];
///       const auto triangle = generators::triangle(random, family);
///       const auto ray = generators::ray(random, family, triangle);
///     }
///
/// Several draws in one expression are written in braces, where the order is fixed:
/// `{random.uniform(), random.uniform()}`.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace generators {

/// Whether sanitizers watch this build. They look at how the code runs, and each makes it slow.
#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// How many cases of `wanted` this build tries: an eighth shows sanitizers all of the code.
constexpr int tried(int wanted) { return sanitized ? wanted / 8 : wanted; }

/// splitmix64 (Steele, Lea and Flood, 2014): the state counts, a mixer scrambles. 2^64 numbers,
/// every seed a good one.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// A multiple of 2^-53 in [0, 1).
  double uniform() { return std::ldexp(static_cast<double>(bits() >> 11), -53); }
  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// A whole number from low to high, both included. (The bias of the remainder is below 2^-32 for
  /// 32-bit ranges.)
  int integer(int low, int high) {
    const auto count = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(bits() % count));
  }
  bool chance(double probability) { return uniform() < probability; }
  /// ±2^e m with e from low to high and m in [1, 2): every magnitude alike.
  double magnitude(int low_exponent, int high_exponent) {
    const int exponent = integer(low_exponent, high_exponent);
    const double size = std::ldexp(uniform(1, 2), exponent);
    return chance(0.5) ? size : -size;
  }

 private:
  std::uint64_t state_;
};

/// Bit patterns without a pattern: every finite number of the type, subnormals included, and every
/// exponent alike.
template <std::floating_point S = double>
S any_finite(Random& random) {
  using Bits = std::conditional_t<sizeof(S) == sizeof(float), std::uint32_t, std::uint64_t>;
  for (;;) {
    const S x = std::bit_cast<S>(static_cast<Bits>(random.bits()));
    if (std::isfinite(x)) return x;
  }
}
inline contact::Vector3<double> any_vector(Random& random) {
  return contact::Vector3<double>{any_finite(random), any_finite(random), any_finite(random)};
}

/// What makes an input near-degenerate, or not.
enum class Family {
  random,    ///< coordinates in [-1, 1): nothing special
  grid,      ///< whole numbers from -4 to 4: exact coincidences everywhere
  shared,    ///< aimed at an edge or a vertex of the triangle; a neighbour shares an edge
  coplanar,  ///< in the triangle's plane, exactly (on a grid) or to the last bit
  grazing,   ///< ends, centres and radii a few ulps from touching
  far,       ///< random, moved up to 2^24 away from the origin
  huge,      ///< random, times 2^200 to 2^320
  tiny       ///< random, times 2^-320 to 2^-200
};

inline constexpr std::array<Family, 8> all_families{
    Family::random,  Family::grid, Family::shared, Family::coplanar,
    Family::grazing, Family::far,  Family::huge,   Family::tiny};

inline constexpr std::string_view name(Family family) {
  constexpr std::array<std::string_view, 8> names{
      "random",   "integer grid", "shared edges and vertices",
      "coplanar", "grazing",      "far from the origin",
      "huge",     "tiny"};
  return names[static_cast<std::size_t>(family)];
}

using Point = contact::Vector3<double>;

namespace detail {

/// Coordinates before a family's scale and position are applied.
inline Point base_point(Random& random, Family family) {
  if (family == Family::grid || family == Family::coplanar) {
    return Point{double(random.integer(-4, 4)), double(random.integer(-4, 4)),
                 double(random.integer(-4, 4))};
  }
  return Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// x moved by up to count ulps in each coordinate.
inline Point nudged(Random& random, Point x, int count) {
  for (int i = 0; i < 3; ++i) {
    const int steps = random.integer(-count, count);
    for (int k = 0; k < std::abs(steps); ++k) {
      x(i) = std::nextafter(x(i), steps > 0 ? std::numeric_limits<double>::infinity()
                                            : -std::numeric_limits<double>::infinity());
    }
  }
  return x;
}

/// The size of a triangle's largest edge coordinate: the scale on which to draw what belongs to it.
inline double extent(const contact::Triangle<double>& t) {
  return std::max((t.b - t.a).cwiseAbs().maxCoeff(), (t.c - t.a).cwiseAbs().maxCoeff());
}

/// A point of the triangle's plane (rounded unless the triangle is on a grid and the weights are
/// whole).
inline Point in_plane(Random& random, const contact::Triangle<double>& t, bool whole) {
  const double u = whole ? random.integer(-2, 2) : random.uniform(-1, 2);
  const double v = whole ? random.integer(-2, 2) : random.uniform(-1, 2);
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

/// A point off the triangle: anywhere within about twice its extent.
inline Point near_triangle(Random& random, Family family, const contact::Triangle<double>& t) {
  if (family == Family::grid || family == Family::coplanar) return base_point(random, family);
  const double size = 2 * extent(t);
  return t.a + size * Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

}  // namespace detail

/// A point on its own.
inline Point point(Random& random, Family family) {
  const Point x = detail::base_point(random, family);
  if (family == Family::far)
    return x + Point{random.magnitude(10, 24), random.magnitude(10, 24), random.magnitude(10, 24)};
  if (family == Family::huge) return x * std::ldexp(1.0, random.integer(200, 320));
  if (family == Family::tiny) return x * std::ldexp(1.0, -random.integer(200, 320));
  return x;
}

/// Three vertices of one scale and position. They may be collinear (often on a grid, otherwise
/// rarely).
inline contact::Triangle<double> triangle(Random& random, Family family) {
  contact::Triangle<double> t{detail::base_point(random, family),
                              detail::base_point(random, family),
                              detail::base_point(random, family)};
  if (family == Family::far) {
    const Point place{random.magnitude(10, 24), random.magnitude(10, 24), random.magnitude(10, 24)};
    t = {t.a + place, t.b + place, t.c + place};
  }
  if (family == Family::huge || family == Family::tiny) {
    const int power = random.integer(200, 320);
    const double scale = std::ldexp(1.0, family == Family::huge ? power : -power);
    t = {t.a * scale, t.b * scale, t.c * scale};
  }
  return t;
}

/// A triangle with area: draws again while the computed normal is zero.
inline contact::Triangle<double> proper_triangle(Random& random, Family family) {
  for (;;) {
    const contact::Triangle<double> t = triangle(random, family);
    const double size = detail::extent(t);
    if (!(size > 0)) continue;
    const Point ab = (t.b - t.a) / size;
    const Point ac = (t.c - t.a) / size;
    if (ab.cross(ac).cwiseAbs().maxCoeff() > 0) return t;
  }
}

/// A triangle on the other side of the edge a b: it has the same two corners, in the opposite
/// order.
inline contact::Triangle<double> neighbour(Random& random, Family family,
                                           const contact::Triangle<double>& t) {
  return {t.b, t.a, detail::near_triangle(random, family, t)};
}

/// A point as the family relates it to a triangle: on an edge or vertex (shared), in its plane
/// (coplanar), a few ulps from its plane (grazing), anywhere near it (the rest).
inline Point point(Random& random, Family family, const contact::Triangle<double>& t) {
  switch (family) {
    case Family::shared: {
      const std::array<Point, 3> corners{t.a, t.b, t.c};
      const auto i = static_cast<std::size_t>(random.integer(0, 2));
      if (random.chance(0.3)) return corners[i];
      return corners[i] + random.uniform() * (corners[(i + 1) % 3] - corners[i]);
    }
    case Family::coplanar:
      return detail::in_plane(random, t, true);
    case Family::grazing:
      return detail::nudged(random, detail::in_plane(random, t, false), 4);
    default:
      return detail::near_triangle(random, family, t);
  }
}

/// A segment as the family relates it to a triangle. Grazing ends (or starts) at a point of the
/// plane, give or take ulps; shared passes through a point of an edge; coplanar has one or both
/// ends in the plane.
inline contact::Segment<double> segment(Random& random, Family family,
                                        const contact::Triangle<double>& t) {
  const Point target = point(random, family, t);
  Point other = detail::near_triangle(random, family, t);
  if (family == Family::coplanar && random.chance(0.5)) other = point(random, family, t);
  if (family == Family::shared) return {other, target + (target - other)};
  if (random.chance(0.5)) return {target, other};
  return {other, target};
}

/// A ray as the family relates it to a triangle: aimed at a point of it that the family likes, or
/// lying in its plane.
inline contact::Ray<double> ray(Random& random, Family family, const contact::Triangle<double>& t) {
  const Point target = point(random, family, t);
  Point origin = detail::near_triangle(random, family, t);
  if (family == Family::coplanar && random.chance(0.5)) origin = point(random, family, t);
  if (family == Family::random || family == Family::far || family == Family::huge ||
      family == Family::tiny) {
    // Aim into the plane of the triangle, so that hits and misses are about equally many.
    const Point aim = detail::in_plane(random, t, false);
    return {origin, aim - origin};
  }
  return {origin, target - origin};
}

/// A plane with a unit normal rounded in double. On a grid: along an axis, with a whole offset.
inline contact::Plane<double> plane(Random& random, Family family) {
  if (family == Family::grid || family == Family::coplanar) {
    Point normal = Point::Zero();
    normal(random.integer(0, 2)) = random.chance(0.5) ? 1 : -1;
    return {normal, double(random.integer(-4, 4))};
  }
  Point direction = Point::Zero();
  double length_squared = 0;
  while (!(length_squared > 0.01 && length_squared <= 1)) {
    direction = Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    length_squared = direction.dot(direction);
  }
  const Point normal = direction / std::sqrt(length_squared);
  return {normal, normal.dot(point(random, family))};
}

/// A sphere as the family relates it to the plane of a triangle; grazing ones touch it to within a
/// few ulps.
inline contact::Sphere<double> sphere(Random& random, Family family,
                                      const contact::Triangle<double>& t) {
  const Point centre = detail::near_triangle(random, family, t);
  if (family == Family::grid || family == Family::coplanar)
    return {centre, double(random.integer(0, 4))};
  const double size = detail::extent(t);
  double radius = size * random.uniform(0, 2);
  if (family == Family::grazing || family == Family::shared) {
    const Point ab = (t.b - t.a) / size;
    const Point ac = (t.c - t.a) / size;
    const Point normal = ab.cross(ac);
    const double length = std::sqrt(normal.dot(normal));
    radius = length > 0 ? std::abs(normal.dot(Point(centre - t.a))) / length : 0.0;
    for (int k = random.integer(-3, 3); k != 0; k += k > 0 ? -1 : 1) {
      radius =
          std::abs(std::nextafter(radius, k > 0 ? std::numeric_limits<double>::infinity() : 0.0));
    }
  }
  return {centre, radius};
}

/// A shape's coordinates rounded to another type, as a float program would have stored them.
template <class To, class From>
contact::Vector3<To> rounded(const contact::Vector3<From>& v) {
  return {static_cast<To>(v.x()), static_cast<To>(v.y()), static_cast<To>(v.z())};
}
template <class To, class From>
contact::Triangle<To> rounded(const contact::Triangle<From>& t) {
  return {rounded<To>(t.a), rounded<To>(t.b), rounded<To>(t.c)};
}
template <class To, class From>
contact::Segment<To> rounded(const contact::Segment<From>& s) {
  return {rounded<To>(s.start), rounded<To>(s.end)};
}
template <class To, class From>
contact::Ray<To> rounded(const contact::Ray<From>& r) {
  return {rounded<To>(r.origin), rounded<To>(r.direction)};
}
template <class To, class From>
contact::Sphere<To> rounded(const contact::Sphere<From>& s) {
  return {rounded<To>(s.centre), static_cast<To>(s.radius)};
}

}  // namespace generators
