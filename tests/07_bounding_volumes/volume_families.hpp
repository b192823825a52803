/// @file
/// Sets of points around which to put volumes, by name, for tests, the ladder and the comparison
/// with other programs. Eigen only: the ladder uses them in the page.
///
///     generators::Random random(1);
///     for (const auto family : volume_families::all) {
///       const auto points = volume_families::points<float>(random, family, 100);  // or <double>
///       smallest_sphere<float>(points);
///     }
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/frame.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <span>
#include <string_view>
#include <support/generators.hpp>
#include <utility>
#include <vector>

namespace volume_families {

using generators::Random;

/// How a set of points is drawn.
enum class Family {
  in_box,        ///< anywhere in a box whose edges differ
  on_ball,       ///< on a sphere, rounded: all are nearly as far from its centre
  cospherical,   ///< whole numbers exactly on a sphere, moved by whole numbers
  grid,          ///< whole numbers from -4 to 4: many extremes alike
  collinear,     ///< on a line, or off it by some ulps
  coplanar,      ///< in an oblique plane, or off it by some ulps
  duplicates,    ///< four positions, most of them stored many times
  few,           ///< one to four points, at times whole numbers
  far_6,         ///< a box of size 1 at a distance of about 10⁶
  far_12,        ///< a box of size 1 at a distance of about 10¹²
  mesh_vertices  ///< those of a star or torus, oblique: a body's, with its symmetry
};
inline constexpr std::array<Family, 11> all{
    Family::in_box,    Family::on_ball,  Family::cospherical,  Family::grid,
    Family::collinear, Family::coplanar, Family::duplicates,   Family::few,
    Family::far_6,     Family::far_12,   Family::mesh_vertices};
/// The name of a family.
inline constexpr std::string_view name(Family family) {
  constexpr std::array<std::string_view, all.size()> names{"in a box",
                                                           "on a ball",
                                                           "cospherical, whole",
                                                           "grid",
                                                           "nearly collinear",
                                                           "nearly coplanar",
                                                           "duplicates",
                                                           "few points",
                                                           "1e6 from the origin",
                                                           "1e12 from the origin",
                                                           "mesh vertices"};
  return names[static_cast<std::size_t>(family)];
}

template <std::floating_point S>
using Points = std::vector<contact::Vector3<S>>;

namespace detail {

using Point = contact::Vector3<double>;

/// Each coordinate in [-1, 1).
inline Point in_cube(Random& random) {
  return Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}
inline Point on_grid(Random& random, int size) {
  return Point{double(random.integer(-size, size)), double(random.integer(-size, size)),
               double(random.integer(-size, size))};
}
/// Of length 1, rounded; every direction alike.
inline Point direction(Random& random) {
  for (;;) {
    const Point v = in_cube(random);
    const double squared = v.dot(v);
    if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
  }
}

/// A point with whole coordinates on the sphere around the origin with radius² = 8109 = 3² · 17 ·
/// 53: (x, y, z) in any order with any signs.
inline Point on_whole_sphere(Random& random) {
  constexpr std::array<std::array<int, 3>, 8> found{{{90, 3, 0},
                                                     {88, 19, 2},
                                                     {80, 35, 22},
                                                     {78, 45, 0},
                                                     {74, 43, 28},
                                                     {72, 54, 3},
                                                     {64, 62, 13},
                                                     {58, 53, 44}}};
  std::array<int, 3> v = found[static_cast<std::size_t>(random.integer(0, 7))];
  std::swap(v[0], v[static_cast<std::size_t>(random.integer(0, 2))]);
  std::swap(v[1], v[static_cast<std::size_t>(random.integer(1, 2))]);
  for (int& x : v) x = random.chance(0.5) ? x : -x;
  return Point{double(v[0]), double(v[1]), double(v[2])};
}

/// The vertices of a star or a torus, oblique to the axes, in random order; the first `count`.
inline std::vector<Point> of_mesh(Random& random, int count) {
  const bool star = random.chance(0.5);
  const contact::Mesh<double> mesh =
      star ? contact::star_mesh(1, 2, 2) : contact::torus_mesh(2, 0.5, 24, 16);
  const Point z = direction(random);
  const auto frame = contact::frame_on_normal<double>(Point::Zero(), z);
  std::vector<Point> points;
  for (const Point& v : mesh.vertices) points.push_back(contact::position_in_world(frame, v));
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    std::swap(points[i], points[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  if (points.size() > static_cast<std::size_t>(count)) {
    points.resize(static_cast<std::size_t>(count));
  }
  return points;
}

/// What all points of a set share.
struct Setting {
  Point position, u, v, size;
  double ulps;  ///< how far points are off a line or a plane, as a share of the size
};
inline Setting setting(Random& random) {
  const Point position = in_cube(random), u = direction(random), v = direction(random);
  const Point size{random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2)};
  return {position, u, v, size, random.chance(0.5) ? 0 : std::ldexp(1.0, -random.integer(20, 52))};
}

inline Point far(Random& random, double distance, const Point& direction) {
  return distance * direction + in_cube(random);
}
inline Point point(Random& random, Family family, const Setting& all) {
  switch (family) {
    case Family::on_ball:
      return all.position + all.size.x() * direction(random);
    case Family::cospherical:
      return on_whole_sphere(random) + Point(100 * all.position).array().round().matrix();
    case Family::grid:
      return on_grid(random, 4);
    case Family::collinear: {
      const double at = random.uniform(-1, 1);
      return all.position + at * all.u + all.ulps * in_cube(random);
    }
    case Family::coplanar: {
      const double at_u = random.uniform(-1, 1), at_v = random.uniform(-1, 1);
      return all.position + at_u * all.u + at_v * all.v + all.ulps * in_cube(random);
    }
    case Family::far_6:
      return far(random, 1e6, all.u);
    case Family::far_12:
      return far(random, 1e12, all.u);
    default:
      return all.position + all.size.cwiseProduct(in_cube(random));
  }
}

/// In double.
inline std::vector<Point> draw(Random& random, Family family, int count) {
  if (family == Family::mesh_vertices) return of_mesh(random, count);
  const Setting shared = setting(random);
  const int drawn = family == Family::few          ? random.integer(1, 4)
                    : family == Family::duplicates ? std::min(count, 4)
                                                   : count;
  const bool whole = family == Family::few && random.chance(0.5);
  std::vector<Point> points;
  for (int i = 0; i < drawn; ++i) {
    points.push_back(whole ? on_grid(random, 4) : point(random, family, shared));
  }
  if (family == Family::duplicates) {
    while (static_cast<int>(points.size()) < count) {
      points.push_back(points[static_cast<std::size_t>(random.integer(0, drawn - 1))]);
    }
  }
  return points;
}

}  // namespace detail

/// A set of points of a family, rounded to S. In float, points of `far_12` are alike or far apart:
/// an ulp is 65,536 there.
/// @param count at least 1; fewer are drawn of `few` and from small meshes
template <std::floating_point S>
Points<S> points(Random& random, Family family, int count) {
  Points<S> result;
  for (const auto& p : detail::draw(random, family, count)) {
    result.push_back(generators::rounded<S>(p));
  }
  return result;
}

/// The same points at another scale.
template <std::floating_point S>
Points<S> scaled(Points<S> points, S by) {
  for (auto& p : points) p *= by;
  return points;
}

/// A set of the family whose turn it is in a test's case i: from 1 to `most` points.
template <class S>
Points<S> drawn(Random& random, int i, int most = 20) {
  const auto family = all[static_cast<std::size_t>(i) % all.size()];
  const int count = random.integer(1, most);
  return points<S>(random, family, count);
}
/// Points as the functions take them, so that their type is deduced.
template <class S>
std::span<const contact::Vector3<S>> span_of(const Points<S>& points) {
  return points;
}

}  // namespace volume_families
