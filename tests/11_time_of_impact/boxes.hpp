/// @file
/// Pairs of translating boxes, and exact answers about them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/box_sweep.hpp>
#include <contact/quaternion.hpp>
#include <optional>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace boxes {

using Box = contact::TranslatingBox<double>;
using V = contact::Vector3<double>;
using generators::Random;
using oracle::Rational;

/// The eight corners of a box at the start, as stored, in fractions.
inline std::vector<oracle::Vector> corners(const Box& box) {
  std::array<oracle::Vector, 3> edge;
  for (int k = 0; k < 3; ++k) {
    const V axis = box.frame.axes.col(k);
    edge[static_cast<std::size_t>(k)] = oracle::exact(axis) * oracle::exact(box.half_lengths(k));
  }
  std::vector<oracle::Vector> all;
  for (int i = 0; i < 8; ++i) {
    oracle::Vector corner = oracle::exact(box.frame.origin);
    for (int k = 0; k < 3; ++k) {
      const oracle::Vector& e = edge[static_cast<std::size_t>(k)];
      corner = (i >> k) % 2 == 0 ? oracle::Vector(corner + e) : oracle::Vector(corner - e);
    }
    all.push_back(corner);
  }
  return all;
}

/// The first time in [0, 1] at which the boxes touch, from the projections of all corners on each
/// axis, in fractions.
inline std::optional<Rational> first_touch(const Box& a, const Box& b) {
  const auto at_a = corners(a);
  const auto at_b = corners(b);
  const oracle::Vector w = oracle::exact(b.displacement) - oracle::exact(a.displacement);
  // Edges as differences of corners: 0-1, 0-2, 0-4.
  std::vector<oracle::Vector> axes;
  const std::array<std::size_t, 3> ends{1, 2, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    const oracle::Vector x = at_a[ends[i]] - at_a[0];
    axes.push_back(x.cross(oracle::Vector(at_a[ends[(i + 1) % 3]] - at_a[0])));
    const oracle::Vector y = at_b[ends[i]] - at_b[0];
    axes.push_back(y.cross(oracle::Vector(at_b[ends[(i + 1) % 3]] - at_b[0])));
    for (const std::size_t j : ends) axes.push_back(x.cross(oracle::Vector(at_b[j] - at_b[0])));
  }
  Rational from = 0;
  Rational to = 1;
  for (const oracle::Vector& axis : axes) {
    const auto projection = [&axis](const std::vector<oracle::Vector>& points) {
      Rational low = axis.dot(points[0]);
      Rational high = low;
      for (const oracle::Vector& point : points) {
        const Rational x = axis.dot(point);
        low = std::min(low, x);
        high = std::max(high, x);
      }
      return std::pair(low, high);
    };
    const auto [low_a, high_a] = projection(at_a);
    const auto [low_b, high_b] = projection(at_b);
    const Rational speed = axis.dot(w);
    if (speed == 0) {
      if (low_b > high_a || low_a > high_b) return std::nullopt;
      continue;
    }
    const Rational one = (high_a - low_b) / speed;
    const Rational other = (low_a - high_b) / speed;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  if (from > to) return std::nullopt;
  return from;
}

inline V in_box(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {x, y, z};
}

inline V whole(Random& random, int size) {
  const int x = random.integer(-size, size);
  const int y = random.integer(-size, size);
  const int z = random.integer(-size, size);
  return {double(x), double(y), double(z)};
}

/// The families of pairs.
enum class Kind { plain, grid, last_moment, edges, far, thin_and_fast, aligned, sized };
inline constexpr std::array<Kind, 8> all_kinds{Kind::plain,   Kind::grid, Kind::last_moment,
                                               Kind::edges,   Kind::far,  Kind::thin_and_fast,
                                               Kind::aligned, Kind::sized};

inline contact::Matrix3<double> turned(Random& random) {
  const V axis = in_box(random, 3);
  return contact::matrix_of(contact::normalised(contact::exponential<double>(axis)));
}

/// Two boxes: with any orientation and motion; on integers, axis-aligned; touching exactly at the
/// end of the step, up to rounding; with crossing edges that touch, up to rounding; far from the
/// origin; a bullet and a wall; axis-aligned of any size; of every size together.
inline std::array<Box, 2> make(Random& random, Kind kind) {
  std::array<Box, 2> pair;
  for (Box& box : pair) {
    box.frame.origin = in_box(random, 3);
    box.frame.axes = turned(random);
    box.half_lengths = in_box(random, 1).cwiseAbs() + V::Constant(0.05);
    box.displacement = in_box(random, 3);
  }
  auto& [a, b] = pair;
  if (random.chance(0.5)) b.displacement = a.displacement + (a.frame.origin - b.frame.origin);
  switch (kind) {
    case Kind::grid:
      for (Box& box : pair) {
        box.frame.origin = whole(random, 3);
        box.frame.axes = contact::Matrix3<double>::Identity();
        box.half_lengths = whole(random, 1).cwiseAbs() + V::Constant(1);
        box.displacement = whole(random, 4);
      }
      break;
    case Kind::last_moment: {
      const auto touch = first_touch(a, b);
      if (touch && *touch > 0) {
        const double t = oracle::nearest(*touch);
        a.displacement *= t;
        b.displacement *= t;
      }
      break;
    }
    case Kind::edges: {
      // Rotated by 45 degrees about x and about y, so that an edge of each faces the other.
      const double half = std::sqrt(0.5);
      a.frame.axes << 1, 0, 0, 0, half, -half, 0, half, half;
      b.frame.axes << half, 0, half, 0, 1, 0, -half, 0, half;
      a.half_lengths = b.half_lengths = V(1, 1, 1);
      a.frame.origin = V(0, 0, 0);
      const double up = 2 * std::sqrt(2.0);
      b.frame.origin =
          V(0, 0, std::ldexp(std::round(std::ldexp(up, 51)) + random.integer(-4, 4), -51));
      a.displacement = V(0, 0, 0);
      b.displacement = whole(random, 1);
      b.displacement.z() = 0;
      break;
    }
    case Kind::far: {
      const V shift = in_box(random, 1e7);
      a.frame.origin += shift;
      b.frame.origin += shift;
      break;
    }
    case Kind::thin_and_fast:
      a.half_lengths = V(5, 5, 0.005);
      a.frame.origin = V(0, 0, 0);
      a.displacement = V(0, 0, 0);
      b.half_lengths = V(0.01, 0.01, 0.02);
      b.frame.origin = in_box(random, 4);
      b.frame.origin.z() = random.uniform(1, 20);
      b.displacement = in_box(random, 3);
      b.displacement.z() = -random.uniform(5, 900);
      break;
    case Kind::aligned:
      for (Box& box : pair) box.frame.axes = contact::Matrix3<double>::Identity();
      break;
    case Kind::sized: {
      const int power = random.integer(-90, 90);
      for (Box& box : pair) {
        box.frame.origin *= std::ldexp(1.0, power);
        box.half_lengths *= std::ldexp(1.0, power - random.integer(0, 6));
        box.displacement *= std::ldexp(1.0, power);
      }
      break;
    }
    case Kind::plain:
      break;
  }
  return pair;
}

}  // namespace boxes
