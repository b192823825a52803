/// @file
/// Random pairs of convex bodies, including nearly degenerate ones.
#pragma once

#include <cmath>

#include "random_poses.hpp"
#include "shape_oracle.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using contact::Matrix3;
using contact::OrientedBox;
using contact::Segment;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using random_poses::any_point;
using random_poses::direction;
using random_poses::turn;
using shape_oracle::ExactBox;

using V = Vector3<double>;
using Box = OrientedBox<double>;

inline V grid_point(Random& random, int most) {
  const int x = random.integer(-most, most);
  const int y = random.integer(-most, most);
  return V(x, y, random.integer(-most, most));
}

inline V sizes(Random& random) {
  const double x = random.uniform(0.2, 2);
  const double y = random.uniform(0.2, 2);
  return {x, y, random.uniform(0.2, 2)};
}

/// The families of pairs.
enum class Kind { any, grid, rational, parallel, nearly_parallel, grazing };

inline constexpr Kind kinds[] = {
    Kind::any, Kind::grid, Kind::rational, Kind::parallel, Kind::nearly_parallel, Kind::grazing};

inline Box box(Random& random, Kind kind) {
  if (kind == Kind::grid) {
    const auto r = shape_oracle::rotation(random, true);
    V half = grid_point(random, 2).cwiseAbs() + V(1, 1, 1);
    return {grid_point(random, 4), shape_oracle::rounded(r), half};
  }
  if (kind == Kind::rational) {
    const auto r = shape_oracle::rotation(random, false);
    V half = grid_point(random, 2).cwiseAbs() + V(1, 1, 1);
    return {grid_point(random, 4), shape_oracle::rounded(r), half};
  }
  const V position = any_point(random, 3);
  const Matrix3<double> axes = turn(random);
  return {position, axes, sizes(random)};
}

/// A box whose axes are related to those of another.
inline Box partner(Random& random, Kind kind, const Box& a) {
  Box b = box(random, kind);
  if (kind == Kind::parallel || kind == Kind::grazing) b.axes = a.axes;
  if (kind == Kind::nearly_parallel) {
    const double angle = std::ldexp(random.uniform(1, 2), random.integer(-50, -8));
    b.axes =
        contact::matrix_of(contact::exponential<double>(V(direction(random) * angle))) * a.axes;
  }
  if (kind == Kind::grazing) {
    // Face to face, up to a few ulps.
    const int axis = random.integer(0, 2);
    const V n = a.axes.col(axis);
    const V side = a.axes.col((axis + 1) % 3);
    b.centre =
        a.centre + n * (a.half_lengths(axis) + b.half_lengths(axis)) + side * random.uniform(-1, 1);
    b.centre = generators::detail::nudged(random, b.centre, 2);
  }
  return b;
}

inline Segment<double> segment(Random& random, Kind kind) {
  if (kind == Kind::grid || kind == Kind::rational) {
    const V start = grid_point(random, 4);
    return {start, grid_point(random, 4)};
  }
  const V start = any_point(random, 3);
  return {start, any_point(random, 3)};
}

inline Segment<double> partner(Random& random, Kind kind, const Segment<double>& a) {
  Segment<double> b = segment(random, kind);
  if (kind == Kind::parallel) {
    b.end = b.start + (a.end - a.start) * random.integer(-2, 2);
  }
  if (kind == Kind::nearly_parallel) {
    const double off = std::ldexp(random.uniform(1, 2), random.integer(-50, -8));
    if (random.chance(0.5)) b.start = a.start + direction(random) * off;
    b.end = b.start + (a.end - a.start) + direction(random) * off;
  }
  if (kind == Kind::grazing) {  // they cross, or almost do
    const V meeting = a.start + random.uniform() * (a.end - a.start);
    const V d = direction(random);
    b = {generators::detail::nudged(random, V(meeting - d), 2), V(meeting + d)};
  }
  return b;
}

inline double size_of(const V& v) { return v.cwiseAbs().sum(); }
inline double size_of(const Segment<double>& s) { return size_of(s.start) + size_of(s.end); }
inline double size_of(const Box& b) { return size_of(b.centre) + b.half_lengths.sum(); }

/// The exact gaps along the fifteen axes: the largest, as g / √n².
inline oracle::Surd widest(const ExactBox& a, const ExactBox& b) {
  std::optional<oracle::Surd> best;
  for (int k = 0; k < contact::box_axis_count; ++k) {
    const Vector n = contact::box_axis<Rational>(a, b, k);
    const Rational squared = n.dot(n);
    if (squared == 0) continue;
    const auto room =
        oracle::divided_by_root(contact::separation_along<Rational>(a, b, n), squared);
    if (!best || oracle::compare(room, *best) > 0) best = room;
  }
  return *best;
}

}  // namespace reference
