/// @file
/// The polytopes of convex bodies, in exact numbers, with all of their edges and faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <utility>
#include <vector>

#include "support/oracle.hpp"

namespace pair_truth {

using oracle::Integer;
using oracle::Rational;
using oracle::Vector;
using Whole = contact::Vector3<Integer>;
using Near = contact::Vector3<double>;

/// A polytope with a radius. Edges and faces may be more than it has: each is a segment or triangle
/// of the polytope, and all that bound it are among them.
struct Core {
  std::vector<Vector> vertices;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::array<int, 3>> faces;
  Rational radius{0};
};

namespace detail {

inline Whole cross(const Whole& a, const Whole& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}
inline Integer dot(const Whole& a, const Whole& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
inline bool is_zero(const Whole& v) { return v.x() == 0 && v.y() == 0 && v.z() == 0; }

/// The least power of two that makes all coordinates whole.
inline Integer common_denominator(const std::vector<Vector>& points) {
  Integer all = 1;
  for (const Vector& p : points) {
    for (int i = 0; i < 3; ++i) {
      const Integer d = boost::multiprecision::denominator(p(i));
      if (d > all) all = d;
    }
  }
  return all;
}
/// (p − origin) times `scale`, which makes both whole.
inline Whole whole(const Vector& p, const Vector& origin, const Integer& scale) {
  Whole w;
  for (int i = 0; i < 3; ++i) {
    const auto times = [&](const Rational& x) {
      return Integer(boost::multiprecision::numerator(x) *
                     (scale / boost::multiprecision::denominator(x)));
    };
    w(i) = times(p(i)) - times(origin(i));
  }
  return w;
}
/// The mantissa, rounded towards 0, and the power of two.
inline double mantissa(const Integer& x, long& power) {
  return mpz_get_d_2exp(&power, x.backend().data());
}
/// v / 2^power, rounded.
inline Near near(const Whole& v, long power) {
  Near made;
  for (int i = 0; i < 3; ++i) {
    long own = 0;
    const double m = mantissa(v(i), own);
    const long shift = std::clamp<long>(own - power, -2000, 2000);
    made(i) = std::ldexp(m, static_cast<int>(shift));
  }
  return made;
}
/// The power of two that exceeds all coordinates.
inline long power_of(const Whole& v) {
  long most = -100000;
  for (int i = 0; i < 3; ++i) {
    long own = 0;
    if (mantissa(v(i), own) != 0) most = std::max(most, own);
  }
  return most;
}
/// A vector of length about 1 in the direction of v.
inline Near unit(const Whole& v) { return near(v, power_of(v)).normalized(); }

}  // namespace detail

/// @name The cores of the stored numbers, with vertices in the order of contact::vertex()
/// @{
inline Core core_of(const contact::Sphere<double>& b) {
  return {{oracle::exact(b.centre)}, {}, {}, oracle::exact(b.radius)};
}
inline Core core_of(const contact::Segment<double>& s, double radius) {
  return {{oracle::exact(s.start), oracle::exact(s.end)}, {{0, 1}}, {}, oracle::exact(radius)};
}
inline Core core_of(const contact::Capsule<double>& b) { return core_of(b.core, b.radius); }
inline Core core_of(const contact::Triangle<double>& b) {
  return {{oracle::exact(b.a), oracle::exact(b.b), oracle::exact(b.c)},
          {{0, 1}, {1, 2}, {2, 0}},
          {{0, 1, 2}},
          0};
}
inline Core core_of(const contact::Lozenge<double>& b) {
  const Vector o = oracle::exact(b.corner);
  const Vector e = oracle::exact(b.first_edge), f = oracle::exact(b.second_edge);
  return {{o, Vector(o + e), Vector(o + f), Vector(o + e + f)},
          {{0, 1}, {1, 3}, {3, 2}, {2, 0}},
          {{0, 1, 3}, {0, 3, 2}},
          oracle::exact(b.radius)};
}
/// The parallelepiped of the stored numbers.
inline Core core_of(const contact::OrientedBox<double>& b) {
  Core core;
  const Vector centre = oracle::exact(b.centre);
  std::array<Vector, 3> half;
  for (int i = 0; i < 3; ++i) {
    half[static_cast<std::size_t>(i)] =
        oracle::exact(contact::Vector3<double>(b.axes.col(i))) * oracle::exact(b.half_lengths(i));
  }
  for (int k = 0; k < 8; ++k) {
    Vector corner = centre;
    for (int i = 0; i < 3; ++i) {
      const Vector& h = half[static_cast<std::size_t>(i)];
      corner = (k >> i & 1) != 0 ? Vector(corner + h) : Vector(corner - h);
      if ((k >> i & 1) == 0) core.edges.push_back({k, k | 1 << i});
    }
    core.vertices.push_back(corner);
  }
  for (int i = 0; i < 3; ++i) {
    const int j = 1 << (i + 1) % 3, l = 1 << (i + 2) % 3;
    for (const int side : {0, 1 << i}) {
      core.faces.push_back({side, side | j, side | j | l});
      core.faces.push_back({side, side | j | l, side | l});
    }
  }
  return core;
}
/// The hull of points. Faces are all triangles of three points with all others on one side.
inline Core core_of_points(std::vector<Vector> points, const Rational& radius) {
  Core core{std::move(points), {}, {}, radius};
  const Integer scale = detail::common_denominator(core.vertices);
  std::vector<Whole> w;
  for (const Vector& v : core.vertices) w.push_back(detail::whole(v, core.vertices[0], scale));
  const int n = static_cast<int>(w.size());
  const auto at = [&w](int i) -> const Whole& { return w[static_cast<std::size_t>(i)]; };
  std::vector<char> is_edge(static_cast<std::size_t>(n * n), 0);
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = j + 1; k < n; ++k) {
        const Whole normal = detail::cross(at(j) - at(i), at(k) - at(i));
        if (detail::is_zero(normal)) continue;
        bool above = false, below = false;
        for (int m = 0; m < n && !(above && below); ++m) {
          const int side = detail::dot(normal, Whole(at(m) - at(i))).sign();
          above = above || side > 0;
          below = below || side < 0;
        }
        if (above && below) continue;
        core.faces.push_back({i, j, k});
        for (const auto& [p, q] : {std::pair{i, j}, std::pair{j, k}, std::pair{i, k}}) {
          is_edge[static_cast<std::size_t>(p * n + q)] = 1;
        }
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      if (core.faces.empty() || is_edge[static_cast<std::size_t>(i * n + j)] != 0) {
        core.edges.push_back({i, j});
      }
    }
  }
  return core;
}
inline Core core_of(const contact::ConvexHull<double>& b) {
  std::vector<Vector> points;
  for (const auto& v : b.vertices) points.push_back(oracle::exact(v));
  return core_of_points(std::move(points), oracle::exact(b.radius));
}
/// @}

}  // namespace pair_truth
