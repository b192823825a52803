/// @file
/// The sets of points of the comparison with other programs, and what is right of a sphere or a box
/// around them: by fractions, which none of the methods uses.
#pragma once

#include <07_bounding_volumes/volume_families.hpp>
#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/measured_shapes.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "peers.hpp"

namespace volume_scenes {

using oracle::Rational;
using volume_families::Family;
using Point = contact::Vector3<double>;
using Points = std::vector<Point>;

/// Sets of points of one family, all of about the same number of points.
struct Scene {
  std::string name, title;
  std::vector<Points> sets;
  peers::Sets plain;
};

inline peers::Numbers plain(const Point& p) { return {p.x(), p.y(), p.z()}; }
inline void add(Scene& to, Points points) {
  to.plain.emplace_back();
  for (const Point& p : points) to.plain.back().push_back(plain(p));
  to.sets.push_back(std::move(points));
}

/// Sets with as many points each, and about `total` points of all.
inline Scene scene(Family family, std::size_t size, std::size_t total) {
  const std::string title(volume_families::name(family));
  Scene scene{{}, title, {}, {}};
  for (const char c : title) {
    if (c != ',') scene.name += c == ' ' ? '_' : c;
  }
  scene.name += "_" + std::to_string(size);
  generators::Random random(static_cast<std::uint64_t>(family) + 1);
  const std::size_t count = std::clamp<std::size_t>(total / size, 1, 200);
  for (std::size_t i = 0; i < count; ++i) {
    add(scene, volume_families::points<double>(random, family, static_cast<int>(size)));
  }
  return scene;
}
/// Whether sets of a family have as many points.
inline bool has(Family family, std::size_t size) {
  if (family == Family::few) return size == 10;
  return family != Family::mesh_vertices || size <= 100;
}

/// For the boxes: sets that are not flat, and the vertices of shapes that the lesson measures.
inline std::vector<Scene> box_scenes(std::size_t total) {
  std::vector<Scene> scenes;
  for (const std::size_t size : {10U, 100U, 1000U, 10000U}) {
    for (const Family family : {Family::in_box, Family::on_ball, Family::cospherical, Family::grid,
                                Family::far_6, Family::mesh_vertices}) {
      if (has(family, size)) scenes.push_back(scene(family, size, total));
    }
  }
  for (const contact::MeasuredShape& shape : contact::measured_shapes()) {
    scenes.push_back({shape.name, std::string("vertices of the shape ") + shape.name, {}, {}});
    add(scenes.back(), shape.mesh.vertices);
  }
  return scenes;
}

inline std::string title_of(const Scene& scene) {
  const auto [least, most] =
      std::minmax_element(scene.sets.begin(), scene.sets.end(),
                          [](const Points& a, const Points& b) { return a.size() < b.size(); });
  std::string size = std::to_string(most->size());
  if (least->size() < most->size()) size = std::to_string(least->size()) + " to " + size;
  const std::size_t sets = scene.sets.size();
  return scene.title + ", " + std::to_string(sets) + (sets == 1 ? " set" : " sets") + " of " +
         size + " points";
}

/// All coordinates as fractions.
inline oracle::Vector exact(const Point& p) {
  return {oracle::exact(p.x()), oracle::exact(p.y()), oracle::exact(p.z())};
}
/// A product of Eigen's needs more of a number type than fractions have.
inline Rational dot(const oracle::Vector& a, const oracle::Vector& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
inline oracle::Vector cross(const oracle::Vector& a, const oracle::Vector& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

inline double largest_coordinate(const Points& points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

// ---------------------------------------------------------------- spheres

/// Whether a point is outside a ball whose centre and radius are doubles. Of a double that is far
/// from a decision, the sign is right: it has a relative error of less than 1e-14.
inline bool outside(const peers::Ball& ball, const Point& p) {
  const Point c(ball.centre[0], ball.centre[1], ball.centre[2]), d = p - c;
  const double squared = d.dot(d), limit = ball.radius * ball.radius;
  if (limit > 1e-200 && limit < 1e200 && squared > 1e-200 && squared < 1e200) {
    if (squared < limit * (1 - 1e-12)) return false;
    if (squared > limit * (1 + 1e-12)) return true;
  }
  if (!std::isfinite(c.sum()) || !std::isfinite(ball.radius)) return true;
  const oracle::Vector away = exact(p) - exact(c);
  const Rational radius = oracle::exact(ball.radius);
  return radius < 0 || dot(away, away) > radius * radius;
}
inline bool misses_a_point(const peers::Ball& ball, const Points& points) {
  return std::any_of(points.begin(), points.end(),
                     [&ball](const Point& p) { return outside(ball, p); });
}

/// The smallest sphere of a support: of points that all are on its surface, with weights that are
/// not negative and give its centre. Nothing if they have none such.
struct Smallest {
  oracle::Vector centre;
  Rational squared_radius;
};
inline std::optional<Smallest> smallest_of_support(const Points& points,
                                                   std::span<const int> support) {
  const auto at = [&](std::size_t i) {
    return exact(points[static_cast<std::size_t>(support[i])]);
  };
  const std::size_t n = support.size() - 1;
  const oracle::Vector base = at(0);
  std::array<oracle::Vector, 3> v;
  for (std::size_t i = 0; i < n; ++i) v[i] = at(i + 1) - base;
  // Σ wⱼ vᵢ·vⱼ = vᵢ·vᵢ/2, by elimination.
  std::array<std::array<Rational, 4>, 3> m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(v[i], v[j]);
    m[i][n] = dot(v[i], v[i]) / 2;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (m[k][k] == 0) return std::nullopt;  // a Gram matrix: no other pivot is needed
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j <= n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  Smallest smallest{base, 0};
  Rational rest = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational weight = m[i][n] / m[i][i];
    if (weight < 0) return std::nullopt;
    rest -= weight;
    for (int k = 0; k < 3; ++k) smallest.centre[k] += weight * v[i][k];
  }
  if (rest < 0) return std::nullopt;
  const oracle::Vector radius = smallest.centre - base;
  smallest.squared_radius = dot(radius, radius);
  return smallest;
}

/// The radius of the smallest sphere, proven: the support is one of some points, so no smaller
/// sphere contains these, and its smallest sphere contains all. Nothing if that is not so.
inline std::optional<double> proven_radius(const Points& points, std::span<const int> support) {
  const std::optional<Smallest> smallest = smallest_of_support(points, support);
  if (!smallest) return std::nullopt;
  // Doubles decide for points far inside: their differences from a point of the set and those of
  // the centre are rounded relative to the size of the set.
  const Point& base = points[static_cast<std::size_t>(support[0])];
  const oracle::Vector from_base = smallest->centre - exact(base);
  const Point centre(oracle::nearest(from_base.x()), oracle::nearest(from_base.y()),
                     oracle::nearest(from_base.z()));
  const double limit = oracle::nearest(smallest->squared_radius);
  for (const Point& p : points) {
    const Point away = (p - base) - centre;
    if (limit > 1e-200 && limit < 1e200 && away.dot(away) < limit * (1 - 1e-9)) continue;
    const oracle::Vector exactly = exact(p) - smallest->centre;
    if (dot(exactly, exactly) > smallest->squared_radius) return std::nullopt;
  }
  return std::sqrt(limit);
}

/// How far a radius may be off without being wrong: 1e-9 of it, and what coordinates of the centre
/// lose as doubles.
inline double tolerated(double radius, const Points& points) {
  return 1e-9 * radius + 2 * std::numeric_limits<double>::epsilon() * largest_coordinate(points);
}
/// A sphere that misses a point by more than is tolerated, or is larger than the smallest by more.
inline bool is_wrong(peers::Ball ball, double smallest, const Points& points) {
  const double room = tolerated(smallest, points);
  if (!(std::abs(ball.radius - smallest) <= room)) return true;
  ball.radius += room;
  return misses_a_point(ball, points);
}

// ---------------------------------------------------------------- boxes

/// The volume of a box as stored.
inline double volume(const peers::Box& box) {
  const auto axis = [&box](std::size_t i) {
    return Point(box.axes[i][0], box.axes[i][1], box.axes[i][2]);
  };
  return 8 * box.half_lengths[0] * box.half_lengths[1] * box.half_lengths[2] *
         std::abs(axis(0).dot(axis(1).cross(axis(2))));
}

/// The three coordinates of a point along stored axes, and their limits, all times |det axes|.
struct InBox {
  std::array<Rational, 3> at, limit;
};
inline InBox in_box(const peers::Box& box, const Point& p) {
  const auto vector = [](const peers::Numbers& x) { return exact(Point(x[0], x[1], x[2])); };
  const std::array<oracle::Vector, 3> axes{vector(box.axes[0]), vector(box.axes[1]),
                                           vector(box.axes[2])};
  const oracle::Vector away = exact(p) - vector(box.centre);
  InBox result;
  const Rational determinant = abs(dot(axes[0], cross(axes[1], axes[2])));
  for (std::size_t i = 0; i < 3; ++i) {
    result.at[i] = abs(dot(away, cross(axes[(i + 1) % 3], axes[(i + 2) % 3])));
    result.limit[i] = determinant * oracle::exact(box.half_lengths[i]);
  }
  return result;
}
/// Whether a point is outside by more than `room` times the largest half length: decided exactly
/// where doubles leave a doubt.
inline bool misses_a_point(const peers::Box& box, const Points& points, double room = 0) {
  const Point c(box.centre[0], box.centre[1], box.centre[2]);
  const double size = *std::max_element(box.half_lengths.begin(), box.half_lengths.end());
  const double doubt = 1e-9 * size + 1e-14 * largest_coordinate(points);
  return std::any_of(points.begin(), points.end(), [&](const Point& p) {
    bool near = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point axis(box.axes[i][0], box.axes[i][1], box.axes[i][2]);
      const double beyond = std::abs(axis.dot(p - c)) - box.half_lengths[i] - room * size;
      if (beyond > doubt) return true;
      near = near || beyond > -doubt;
    }
    if (!near) return false;
    const InBox exactly = in_box(box, p);
    const Rational more = oracle::exact(room * size);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational limit = exactly.limit[i] + (room > 0 ? more : Rational(0));
      if (exactly.at[i] > limit) return true;
    }
    return false;
  });
}

}  // namespace volume_scenes
