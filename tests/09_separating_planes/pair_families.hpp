/// @file
/// Pairs of convex bodies of any two kinds that are hard to decide, for tests, the ladder and the
/// comparison with other programs.
///
///     generators::Random random(1);
///     for (const auto family : pair_families::all) {
///       const auto p = pair_families::pair(random, Kind::capsule, Kind::box, family);
///     }
#pragma once

#include <support/generators.hpp>

#include <array>
#include <cmath>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "pair_bodies.hpp"
#include "random_poses.hpp"

namespace pair_families {

using generators::Random;
using pair_bodies::Body;
using pair_bodies::Frame;
using pair_bodies::Kind;
using pair_bodies::V;

/// How two bodies are drawn.
enum class Family {
  random,           ///< anywhere in a cube of 6 m, 0.4 to 4 m in size
  near,             ///< a gap or a penetration of 10⁻¹² to 10⁻¹ of the sizes
  touching,         ///< touching at vertices, edges, faces or sides, but for an ulp
  grid,             ///< whole numbers and axes of the world, as they touch
  grid_step,        ///< the same, and one step of the last digit off
  deep,             ///< centres within a tenth of the sizes
  equal,            ///< one frame for both, the same body if the kinds are the same
  parallel,         ///< the same axes, touching but for an ulp
  nearly_parallel,  ///< axes rotated by 2⁻⁵⁰ to 2⁻⁸, near or touching
  thin,             ///< one or two sizes are a millionth, touching or near
  large,            ///< one of the two is 10⁸ times as large as the other, touching or near
  far,              ///< 10⁸ m from the origin, touching or near
  scaled            ///< near or touching, times a power of two from 2^-498 to 2^498 (10^150)
};
inline constexpr std::array<Family, 13> all{
    Family::random,          Family::near, Family::touching, Family::grid,
    Family::grid_step,       Family::deep, Family::equal,    Family::parallel,
    Family::nearly_parallel, Family::thin, Family::large,    Family::far,
    Family::scaled};
inline constexpr std::string_view name(Family family) {
  constexpr std::array<std::string_view, all.size()> names{"random",
                                                           "near",
                                                           "touching but for an ulp",
                                                           "grid",
                                                           "one step off a grid",
                                                           "deep",
                                                           "equal poses",
                                                           "parallel",
                                                           "nearly parallel",
                                                           "thin 1:10^6",
                                                           "large 10^8:1",
                                                           "10^8 m away",
                                                           "of any scale"};
  return names[static_cast<std::size_t>(family)];
}

/// Two bodies, with a direction from B to A and a point that may prove how they lie to each other
/// (pair_proofs.hpp).
struct Pair {
  Body a, b;
  V normal = V::UnitZ();
  V point = V::Zero();
};

namespace detail {

inline V sizes(Random& random, double least = 0.2, double most = 2) {
  const double x = random.uniform(least, most);
  const double y = random.uniform(least, most);
  return {x, y, random.uniform(least, most)};
}
inline Frame any_frame(Random& random) {
  const V centre = random_poses::any_point(random, 3);
  const contact::Matrix3<double> axes = random_poses::turn(random);
  return {centre, axes, sizes(random)};
}
/// A matrix that permutes the axes and keeps the orientation.
inline contact::Matrix3<double> permutation(Random& random) {
  contact::Matrix3<double> m = contact::Matrix3<double>::Zero();
  const int first = random.integer(0, 2);
  const bool swap = random.chance(0.5);
  for (int i = 0; i < 3; ++i) m((first + (swap ? 3 - i : i)) % 3, i) = random.chance(0.5) ? 1 : -1;
  if (m.determinant() < 0) m.col(2) = -m.col(2);
  return m;
}
inline Frame whole_frame(Random& random) {
  const int x = random.integer(-4, 4);
  const int y = random.integer(-4, 4);
  const V centre(x, y, random.integer(-4, 4));
  const contact::Matrix3<double> axes = permutation(random);
  const int a = random.integer(1, 3);
  const int b = random.integer(1, 3);
  return {centre, axes, V(a, b, random.integer(1, 3))};
}
inline Body body(Random& random, Kind kind, const Frame& frame) {
  const int corners = random.integer(0, 2);
  Body made = pair_bodies::body_in(random, kind, frame, corners);
  if (kind == Kind::hull && random.chance(0.3)) {
    std::get<contact::ConvexHull<double>>(made).radius = frame.half(0) * random.uniform(0, 0.5);
  }
  return made;
}

// Contacts -----------------------------------------------------------------------------------

/// Directions that a body has: along its edges or axes, and perpendicular to its faces.
inline std::vector<V> directions(const Body& body) {
  struct Of {
    std::vector<V> operator()(const contact::Sphere<double>&) const { return {}; }
    std::vector<V> operator()(const contact::Capsule<double>& b) const {
      return {V(b.core.end - b.core.start)};
    }
    std::vector<V> operator()(const contact::Cylinder<double>& b) const {
      return {V(b.core.end - b.core.start)};
    }
    std::vector<V> operator()(const contact::Lozenge<double>& b) const {
      return {b.first_edge, b.second_edge, V(b.first_edge.cross(b.second_edge))};
    }
    std::vector<V> operator()(const contact::Triangle<double>& b) const {
      const V d = b.b - b.a, e = b.c - b.a;
      return {d, e, V(b.c - b.b), V(d.cross(e))};
    }
    std::vector<V> operator()(const contact::ConvexHull<double>& b) const {
      const V d = b.vertices[2] - b.vertices[0], e = b.vertices[4] - b.vertices[0];
      return {d, e, V(d.cross(e))};
    }
    std::vector<V> operator()(const contact::OrientedBox<double>& b) const {
      return {b.axes.col(0), b.axes.col(1), b.axes.col(2)};
    }
    std::vector<V> operator()(const contact::Ellipsoid<double>& b) const {
      return {b.axes.col(0), b.axes.col(1), b.axes.col(2)};
    }
  };
  return std::visit(Of{}, body);
}

/// A direction along which two bodies may touch: any, perpendicular to a face of one of them, or
/// perpendicular to an edge or axis of each.
inline V contact_direction(Random& random, const Body& a, const Body& b) {
  const std::vector<V> of_a = directions(a), of_b = directions(b);
  const auto one = [&random](const std::vector<V>& from) {
    return from[static_cast<std::size_t>(random.integer(0, static_cast<int>(from.size()) - 1))];
  };
  const int how = random.integer(0, 3);
  V n = V::Zero();
  if (how == 0 && !of_a.empty()) n = one(of_a);
  if (how == 1 && !of_b.empty()) n = one(of_b);
  if (how == 2 && !of_a.empty() && !of_b.empty()) {
    const V d = one(of_a), e = one(of_b);
    n = d.normalized().cross(e.normalized());
  }
  const bool opposite = random.chance(0.5);
  const double largest = n.cwiseAbs().maxCoeff();
  if (!(largest > 0) || (how == 2 && largest < 1e-9)) return random_poses::direction(random);
  const V unit = V(n / largest).normalized();
  return opposite ? V(-unit) : unit;
}

/// A point of a body that is farthest along a unit vector n up to rounding: any of a face or an
/// edge that is perpendicular to n.
inline V farthest(Random& random, const Body& body, const V& n) {
  return std::visit(
      [&](const auto& b) -> V {
        using B = std::decay_t<decltype(b)>;
        if constexpr (contact::PolytopeCore<B>) {
          const double most = n.dot(contact::support(b, n));
          V sum = V::Zero();
          double weights = 0;
          for (int i = 0; i < contact::vertex_count(b); ++i) {
            const V v = contact::vertex(b, i);
            if (n.dot(v) < most - 1e-13 * v.cwiseAbs().sum()) continue;
            const double weight = random.integer(0, 2) + 0.5;
            sum += v * weight;
            weights += weight;
          }
          return sum / weights + n * contact::radius_of(b);
        } else {
          return contact::support(b, n);
        }
      },
      body);
}

/// A is moved until it touches B along n, and then by `gap` along n.
inline Pair put_together(Random& random, const Body& a, const Body& b, const V& n, double gap) {
  const V on_a = farthest(random, a, -n), on_b = farthest(random, b, n);
  return {pair_bodies::moved(a, V(on_b - on_a + n * gap)), b, n, V(on_b + n * (gap / 2))};
}
/// Touching but for an ulp, or with a gap or penetration of 10⁻¹² to 10⁻¹ of `size`.
inline Pair near_or_touching(Random& random, const Body& a, const Body& b, double size,
                             double touching) {
  const V n = contact_direction(random, a, b);
  const bool near = !random.chance(touching);
  const double gap = near ? size * random.magnitude(-40, -4) : 0.0;
  Pair made = put_together(random, a, b, n, gap);
  if (!near) {
    const V nudge = generators::detail::nudged(random, V::Ones(), 2) - V::Ones();
    const V off = nudge * (pair_bodies::size_of(made.a) / 2);
    made.a = pair_bodies::moved(made.a, off);
  }
  return made;
}

// Families -----------------------------------------------------------------------------------

inline Pair on_grid(Random& random, Kind kind_a, Kind kind_b) {
  const Frame f = whole_frame(random), g = whole_frame(random);
  const Body a = pair_bodies::body_in(random, kind_a, f);
  const Body b = pair_bodies::body_in(random, kind_b, g);
  V n = V::Zero();
  n(random.integer(0, 2)) = random.chance(0.5) ? 1 : -1;
  if (random.chance(0.3)) {  // anywhere
    return {a, b, n, V((f.centre + g.centre) / 2)};
  }
  // A vertex or the middle of each, so that all numbers are whole or half of one.
  const auto end = [](const Body& body, const V& along) {
    return std::visit(
        [&along](const auto& x) -> V {
          return contact::support(x, along) + along * contact::radius_of(x);
        },
        body);
  };
  const V at = end(b, n);
  return {pair_bodies::moved(a, V(at - end(a, V(-n)))), b, n, at};
}

inline Frame thin(Random& random, Frame f) {
  const int which = random.integer(0, 2);
  f.half(which) *= 1e-6;
  if (random.chance(0.4)) f.half((which + 1) % 3) *= 1e-6;
  return f;
}

}  // namespace detail

/// Two bodies of a family.
inline Pair pair(Random& random, Kind kind_a, Kind kind_b, Family family) {
  using namespace detail;
  const Frame f = any_frame(random);
  Frame g = any_frame(random);
  const auto two = [&](const Frame& of_a, const Frame& of_b) {
    const Body a = body(random, kind_a, of_a);
    return std::pair<Body, Body>{a, body(random, kind_b, of_b)};
  };
  const auto meeting = [&](const Frame& of_a, const Frame& of_b, double size, double touching) {
    const auto [a, b] = two(of_a, of_b);
    return near_or_touching(random, a, b, size, touching);
  };
  switch (family) {
    case Family::near:
      return meeting(f, g, 1, 0);
    case Family::touching:
      return meeting(f, g, 1, 1);
    case Family::grid:
      return on_grid(random, kind_a, kind_b);
    case Family::grid_step: {
      Pair made = on_grid(random, kind_a, kind_b);
      made.a = pair_bodies::moved(made.a, V(made.normal * random.integer(-1, 1) * 0x1p-48));
      return made;
    }
    case Family::deep: {
      g.centre = f.centre + random_poses::any_point(random, 0.05);
      const auto [a, b] = two(f, g);
      return {a, b, random_poses::direction(random), V((f.centre + g.centre) / 2)};
    }
    case Family::equal: {
      const Body a = body(random, kind_a, f);
      const Body b = kind_a == kind_b ? a : body(random, kind_b, f);
      return {a, b, V(f.axes.col(0)), f.centre};
    }
    case Family::parallel:
      g.axes = f.axes;
      return meeting(f, g, 1, 1);
    case Family::nearly_parallel: {
      const V axis = random_poses::direction(random);
      const double angle = std::abs(random.magnitude(-50, -8));
      g.axes = contact::matrix_of(contact::exponential<double>(V(axis * angle))) * f.axes;
      return meeting(f, g, 1, 0.5);
    }
    case Family::thin: {
      const bool both = random.chance(0.5);
      const Frame first = thin(random, f);
      return meeting(first, both ? thin(random, g) : g, 1e-6, 0.5);
    }
    case Family::large: {
      Frame first = f;
      first.half *= 1e8;
      return meeting(first, g, 1, 0.5);
    }
    case Family::far: {
      g.centre += random_poses::any_point(random, 1e8);
      return meeting(f, g, 1, 0.5);
    }
    case Family::scaled: {
      Pair made = meeting(f, g, 1, 0.5);
      const int power = random.integer(-498, 498);
      const auto scale = [power](const V& v) { return V(v * std::ldexp(1.0, power)); };
      return {pair_bodies::scaled(made.a, power), pair_bodies::scaled(made.b, power), made.normal,
              scale(made.point)};
    }
    default: {
      const auto [a, b] = two(f, g);
      return {a, b, random_poses::direction(random), V((f.centre + g.centre) / 2)};
    }
  }
}

/// Any body and a half-space: perpendicular to a face, or in any direction, touching but for an
/// ulp, or near.
inline std::pair<Body, contact::HalfSpace<double>> with_half_space(Random& random, Kind kind,
                                                                   Family family) {
  const Pair made = pair(random, kind, Kind::sphere, family);
  const V n = family == Family::grid || family == Family::grid_step
                  ? made.normal
                  : V(detail::contact_direction(random, made.a, made.b).normalized());
  const V at = detail::farthest(random, made.a, -n);
  double offset = n.dot(at);
  if (family == Family::random || family == Family::deep) offset += random.uniform(-1, 1);
  if (family == Family::near) offset += random.magnitude(-40, -4);
  if (family == Family::touching || family == Family::grid_step) {
    offset = std::nextafter(offset, random.chance(0.5) ? 9e300 : -9e300);
  }
  return {made.a, {{n, offset}}};
}

}  // namespace pair_families
