/// @file
/// Lists of boxes for the tests of the chapter: a general family, and special ones.
#pragma once

#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <string_view>
#include <vector>

#include "support/generators.hpp"

namespace families {

using generators::Random;

/// The families of lists of boxes.
enum class Boxes {
  scattered,    ///< random sizes and positions
  grid,         ///< integers: faces coincide everywhere
  equal,        ///< many copies of a few boxes
  points,       ///< without extent, several at one position
  one_huge,     ///< one that contains all the others, and one that contains half of them
  on_a_line,    ///< all positions on one axis
  touching,     ///< a row in which each ends where the next begins, exactly or one ulp off
  far,          ///< close to each other and far from the origin
  huge,         ///< up to the largest numbers
  tiny,         ///< down to the smallest
  clusters,     ///< a few clusters far apart
  mixed_sizes,  ///< every order of magnitude
  rods,         ///< long on one axis, thin on the others
  borders,      ///< faces at multiples of 1/4, negative ones, 0 and −0 among them
  columns,      ///< equal coordinates on two axes
  nested        ///< each contains the next
};

inline constexpr std::array<Boxes, 16> all{
    Boxes::scattered, Boxes::grid,      Boxes::equal,    Boxes::points,
    Boxes::one_huge,  Boxes::on_a_line, Boxes::touching, Boxes::far,
    Boxes::huge,      Boxes::tiny,      Boxes::clusters, Boxes::mixed_sizes,
    Boxes::rods,      Boxes::borders,   Boxes::columns,  Boxes::nested};

inline constexpr std::string_view name(Boxes family) {
  constexpr std::array<std::string_view, 16> names{
      "scattered", "grid",    "equal",   "points", "one huge", "on a line",
      "touching",  "far",     "huge",    "tiny",   "clusters", "mixed sizes",
      "rods",      "borders", "columns", "nested"};
  return names[static_cast<std::size_t>(family)];
}

template <class S>
contact::Vector3<S> in_box(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

/// A box with a corner at low and extents of at least 0 and less than size.
template <class S>
contact::Aabb<S> box_at(Random& random, const contact::Vector3<S>& low, double size) {
  contact::Vector3<S> extent = in_box<S>(random, size).cwiseAbs();
  return contact::aabb_from_corners<S>(low, low + extent);
}

template <class S>
contact::Vector3<S> whole_in_box(Random& random, int size) {
  const int x = random.integer(-size, size);
  const int y = random.integer(-size, size);
  const int z = random.integer(-size, size);
  return {S(x), S(y), S(z)};
}

/// n boxes of a family.
template <class S>
std::vector<contact::Aabb<S>> make(Random& random, Boxes family, int n) {
  using V = contact::Vector3<S>;
  const double side = std::max(1.0, std::sqrt(double(n)));
  std::vector<contact::Aabb<S>> boxes;
  const V far_position = in_box<S>(random, 1e6);
  S edge = 0;
  for (int i = 0; i < n; ++i) {
    switch (family) {
      case Boxes::scattered:
        boxes.push_back(box_at<S>(random, in_box<S>(random, side), 1.5));
        break;
      case Boxes::grid: {
        const V low = whole_in_box<S>(random, 3);
        const V extent = whole_in_box<S>(random, 2).cwiseAbs();
        boxes.push_back({low, low + extent});
        break;
      }
      case Boxes::equal:
        boxes.push_back({V::Constant(S(i % 3)), V::Constant(S(i % 3) + S(0.5))});
        break;
      case Boxes::points: {
        const V at = whole_in_box<S>(random, 2);
        boxes.push_back({at, at});
        break;
      }
      case Boxes::one_huge:
        boxes.push_back(box_at<S>(random, in_box<S>(random, side), 0.5));
        if (i == n / 2) boxes.back() = {V::Constant(S(-1e6)), V::Constant(S(1e6))};
        if (i == n / 3) boxes.back() = {V::Constant(S(-1e6)), V(S(0), S(1e6), S(1e6))};
        break;
      case Boxes::on_a_line: {
        V low = V::Zero();
        low.y() = static_cast<S>(random.uniform(-side, side));
        boxes.push_back({low, low + V::Constant(S(0.25))});
        break;
      }
      case Boxes::touching: {
        V low = V::Zero();
        low.x() = edge;
        const int nudge = random.integer(-1, 1);
        if (nudge != 0) low.x() = std::nextafter(edge, edge + S(nudge));
        edge = low.x() + static_cast<S>(random.uniform(0.1, 1.0));
        V high = V::Ones();
        high.x() = edge;
        boxes.push_back({low, high});
        break;
      }
      case Boxes::far:
        boxes.push_back(box_at<S>(random, far_position + in_box<S>(random, side / 8), 1));
        break;
      case Boxes::huge: {
        const S largest = std::numeric_limits<S>::max();
        const V a = in_box<S>(random, 1) * largest;
        const V b = in_box<S>(random, 1) * largest;
        boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
        break;
      }
      case Boxes::tiny: {
        const V low = whole_in_box<S>(random, 9) * std::numeric_limits<S>::denorm_min();
        const V extent =
            whole_in_box<S>(random, 3).cwiseAbs() * std::numeric_limits<S>::denorm_min();
        boxes.push_back({low, low + extent});
        break;
      }
      case Boxes::clusters: {
        const V crowd = V::Constant(S(1000 * random.integer(-2, 2)));
        boxes.push_back(box_at<S>(random, crowd + in_box<S>(random, 3), 1));
        break;
      }
      case Boxes::mixed_sizes: {
        const double size = std::abs(random.magnitude(-8, 4));
        boxes.push_back(box_at<S>(random, in_box<S>(random, side), size));
        break;
      }
      case Boxes::rods: {
        boxes.push_back(box_at<S>(random, in_box<S>(random, side), 0.25));
        boxes.back().high(random.integer(0, 2)) += static_cast<S>(side);
        break;
      }
      case Boxes::borders: {
        const V low = whole_in_box<S>(random, 9) / S(4);
        const V high = low + whole_in_box<S>(random, 3).cwiseAbs() / S(4);
        const bool negative = random.chance(0.5);
        // A face at 0 is at −0 for half of the boxes.
        const auto signed_zero = [negative](S x) { return x == S(0) && negative ? -S(0) : x; };
        boxes.push_back({low.unaryExpr(signed_zero), high.unaryExpr(signed_zero)});
        break;
      }
      case Boxes::columns: {
        V low = whole_in_box<S>(random, 1) * S(3);
        low.z() = static_cast<S>(random.uniform(-side, side));
        boxes.push_back({low, low + V::Ones()});
        break;
      }
      case Boxes::nested:
        boxes.push_back({V::Constant(S(i - n)), V::Constant(S(n - i))});
        break;
    }
  }
  return boxes;
}

}  // namespace families
