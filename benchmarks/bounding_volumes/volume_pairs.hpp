/// @file
/// Pairs of bounding volumes as stored, and whether they have a point in common: by fractions,
/// which none of the methods uses.
#pragma once

#include <support/generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "volume_scenes.hpp"

namespace volume_pairs {

using generators::Random;
using oracle::Rational;
using volume_scenes::Point;
using volume_scenes::Points;
template <class Volume>
using Pair = std::array<Volume, 2>;

/// Pairs with the right answers: 1 they have a point in common, 0 they have none, −1 not known.
template <class Volume>
struct Pairs {
  std::string title;
  std::vector<Pair<Volume>> pairs;
  std::vector<signed char> right;
};

inline Point in_cube(Random& random) {
  return Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}
inline Point direction(Random& random) {
  for (;;) {
    const Point v = in_cube(random);
    const double squared = v.dot(v);
    if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
  }
}

// ---------------------------------------------------------------- spheres

inline bool meet(const Pair<contact::Sphere<double>>& pair) {
  const oracle::Vector d =
      volume_scenes::exact(pair[0].centre) - volume_scenes::exact(pair[1].centre);
  const Rational reach = oracle::exact(pair[0].radius) + oracle::exact(pair[1].radius);
  return volume_scenes::dot(d, d) <= reach * reach;
}
/// Two spheres whose centres are up to 2 m from the origin, or so that they touch but for rounding.
inline Pair<contact::Sphere<double>> spheres(Random& random, bool touching) {
  const Point centre = 2 * in_cube(random);
  const double radius = random.uniform(0.3, 1.5);
  const double other = random.uniform(0.3, 1.5);
  const Point at = 2 * in_cube(random), towards = direction(random);
  return {{{centre, radius}, {touching ? centre + (radius + other) * towards : at, other}}};
}

// ---------------------------------------------------------------- boxes with the world's axes

inline bool meet(const Pair<peers::Limits>& pair) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (pair[0].high[k] < pair[1].low[k] || pair[1].high[k] < pair[0].low[k]) return false;
  }
  return true;
}
inline Pair<peers::Limits> limits(Random& random, bool touching) {
  Pair<peers::Limits> pair;
  for (peers::Limits& box : pair) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = random.uniform(-2, 2), half = random.uniform(0.2, 1.4);
      box.low[k] = at - half;
      box.high[k] = at + half;
    }
  }
  if (touching) {
    const auto k = static_cast<std::size_t>(random.integer(0, 2));
    const double width = pair[1].high[k] - pair[1].low[k];
    const double at = pair[0].high[k];
    pair[1].low[k] = random.chance(0.5) ? at : std::nextafter(at, 10.0);
    pair[1].high[k] = pair[1].low[k] + width;
  }
  return pair;
}

// ---------------------------------------------------------------- oriented boxes

using Box = contact::OrientedBox<double>;

/// Whether one of fifteen axes separates the stored parallelepipeds: exact, as are their axes.
inline bool meet(const Pair<Box>& pair) {
  std::array<std::array<oracle::Vector, 3>, 2> axes, normals;
  std::vector<oracle::Vector> candidates;
  for (std::size_t b = 0; b < 2; ++b) {
    for (std::size_t i = 0; i < 3; ++i) {
      axes[b][i] = volume_scenes::exact(Point(pair[b].axes.col(static_cast<int>(i))));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      candidates.push_back(volume_scenes::cross(axes[b][(i + 1) % 3], axes[b][(i + 2) % 3]));
    }
  }
  for (const auto& a : axes[0]) {
    for (const auto& b : axes[1]) candidates.push_back(volume_scenes::cross(a, b));
  }
  const oracle::Vector d =
      volume_scenes::exact(pair[0].centre) - volume_scenes::exact(pair[1].centre);
  return std::none_of(candidates.begin(), candidates.end(), [&](const oracle::Vector& n) {
    Rational reach = 0;
    for (std::size_t b = 0; b < 2; ++b) {
      for (std::size_t i = 0; i < 3; ++i) {
        reach += abs(volume_scenes::dot(n, axes[b][i])) *
                 oracle::exact(pair[b].half_lengths[static_cast<int>(i)]);
      }
    }
    return abs(volume_scenes::dot(n, d)) > reach;
  });
}

enum class Contact { none, corner_on_face, edge_on_edge, parallel };

inline Box box(Random& random) {
  Box made;
  made.centre = 2 * in_cube(random);
  const Point x = direction(random), y = direction(random);
  const Point z = x.cross(y) / std::sqrt(x.cross(y).dot(x.cross(y)));
  made.axes.col(0) = x;
  made.axes.col(1) = z.cross(x);
  made.axes.col(2) = z;
  made.half_lengths = {random.uniform(0.2, 1.4), random.uniform(0.2, 1.4),
                       random.uniform(0.2, 1.4)};
  return made;
}
/// The point with the given coordinates along the axes.
inline Point at(const Box& box, const Point& along) {
  return box.centre + box.axes * box.half_lengths.cwiseProduct(along);
}
/// Two boxes; the second is moved so that both touch, but for rounding.
inline Pair<Box> boxes(Random& random, Contact contact) {
  const Box first = box(random);
  Box second = box(random);
  if (contact == Contact::none) return {first, second};
  const auto share = [&random] { return random.uniform(-0.9, 0.9); };
  Point here, there;  // of the first and of the second, to be in one position
  if (contact == Contact::parallel) {
    second.axes = first.axes;
    here = {1, share(), share()};
    there = {-1, share(), share()};
  } else if (contact == Contact::corner_on_face) {
    here = {1, share(), share()};
    for (int i = 0; i < 3; ++i) {  // the corner that is deepest along the face's normal
      there[i] = second.axes.col(i).dot(first.axes.col(0)) > 0 ? -1 : 1;
    }
  } else {
    const Point normal = first.axes.col(0).cross(second.axes.col(0));
    here[0] = share();
    there[0] = share();
    for (int i = 1; i < 3; ++i) {
      here[i] = first.axes.col(i).dot(normal) > 0 ? 1 : -1;
      there[i] = second.axes.col(i).dot(normal) > 0 ? -1 : 1;
    }
  }
  second.centre += at(first, here) - at(second, there);
  return {first, second};
}

inline peers::Box plain(const Box& box) {
  const auto axis = [&box](int i) { return volume_scenes::plain(Point(box.axes.col(i))); };
  return {volume_scenes::plain(box.centre),
          {axis(0), axis(1), axis(2)},
          volume_scenes::plain(Point(box.half_lengths))};
}

// ---------------------------------------------------------------- bodies for slabs

/// Two bodies of 20 points: anywhere, or so that an edge of each crosses the other's in one point,
/// and the plane of both separates the other points. Coordinates on the edges are whole multiples
/// of 2^-53 from 1/2 to 3/4, so that the common point is exact, and a sum of two is rounded.
inline Pair<Points> bodies(Random& random, bool touching) {
  constexpr int count = 20;
  Pair<Points> pair;
  if (!touching) {
    for (Points& points : pair) {
      const Point centre = 1.5 * in_cube(random);
      for (int i = 0; i < count; ++i) points.push_back(centre + in_cube(random));
    }
    return pair;
  }
  constexpr std::array<std::array<int, 3>, 7> normals{
      {{1, 1, 0}, {1, 0, -1}, {0, 1, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}}};
  const auto& n = normals[static_cast<std::size_t>(random.integer(0, 6))];
  const Point normal(n[0], n[1], n[2]);
  const auto whole = [&random](double most) {
    return std::ldexp(std::floor(0x1p53 * most * random.uniform()), -53);
  };
  const Point common{0.5625 + whole(0.125), 0.5625 + whole(0.125), 0.5625 + whole(0.125)};
  for (std::size_t side = 0; side < 2; ++side) {
    Point along{whole(0.03), whole(0.03), whole(0.03)};
    const int last = n[2] != 0 ? 2 : 1;  // so that normal · along = 0
    along[last] = 0;
    along[last] = -normal[last] * normal.dot(along);
    pair[side].push_back(common + along);
    pair[side].push_back(common - along);
    while (pair[side].size() < count) {
      const Point p = common + 0.2 * in_cube(random);
      const double beyond = normal.dot(p - common);
      if (side == 0 ? beyond < -0.01 : beyond > 0.01) pair[side].push_back(p);
    }
  }
  return pair;
}

inline peers::Points plain(const Points& points) {
  peers::Points numbers;
  for (const Point& p : points) numbers.push_back(volume_scenes::plain(p));
  return numbers;
}

}  // namespace volume_pairs
