/// @file
/// Pairs of moving spheres for the tests, the ladder and the comparison with other programs: a
/// general family, and special ones. Moving points have theirs in families_points.hpp, boxes that
/// turn in families_turning.hpp, boxes that translate in boxes.hpp.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <string_view>

#include "support/generators.hpp"

namespace families {

using generators::Random;
using V = contact::Vector3<double>;

inline V in_box(Random& random, double size) {
  return V{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}
inline V whole_in_box(Random& random, int size) {
  return V{double(random.integer(-size, size)), double(random.integer(-size, size)),
           double(random.integer(-size, size))};
}
/// A multiple of 2^-bits next to x, so that sums and differences of such numbers are exact.
inline V on_grid(const V& x, int bits) {
  return x.unaryExpr(
      [bits](double c) { return std::ldexp(std::round(std::ldexp(c, bits)), -bits); });
}
/// A vector perpendicular to w, up to rounding, and 0 if w is.
inline V across(Random& random, const V& w) { return V(w.cross(in_box(random, 1))); }

/// Two spheres that translate in a step.
template <std::floating_point S>
struct MovingSpheres {
  contact::Sphere<S> a, b;                             ///< at the start, m
  contact::Vector3<S> displacement_a, displacement_b;  ///< in the step, m
};

/// The families of pairs of spheres.
enum class Spheres {
  random,           ///< any positions and displacements; about half of them aimed at each other
  graze,            ///< the paths pass at a distance of the sum of the radii, up to rounding
  fast,             ///< a hundred radii and more in the step
  start_in_touch,   ///< touching exactly at the start: approaching, sliding or separating
  overlapping,      ///< overlapping at the start
  apart,            ///< separating from the start
  crossing,         ///< paths that cross, passed at different times
  at_the_end,       ///< touching at the end of the step, up to rounding
  same_motion,      ///< equal displacements, or none
  far,              ///< close to each other and far from the origin
  nearly_touching,  ///< a gap of a few ulps of the centres
  one_large,        ///< a marble and a planet
  points,           ///< without radius, one or both
  huge,             ///< times 2^200 to 2^320 in double, 2^20 to 2^40 in float
  tiny              ///< times 2^-320 to 2^-200 in double, 2^-40 to 2^-20 in float
};

inline constexpr std::array<Spheres, 15> all_spheres{Spheres::random,
                                                     Spheres::graze,
                                                     Spheres::fast,
                                                     Spheres::start_in_touch,
                                                     Spheres::overlapping,
                                                     Spheres::apart,
                                                     Spheres::crossing,
                                                     Spheres::at_the_end,
                                                     Spheres::same_motion,
                                                     Spheres::far,
                                                     Spheres::nearly_touching,
                                                     Spheres::one_large,
                                                     Spheres::points,
                                                     Spheres::huge,
                                                     Spheres::tiny};

inline constexpr std::string_view name(Spheres family) {
  constexpr std::array<std::string_view, 15> names{
      "random",          "graze",          "fast",       "start in touch", "overlapping",
      "apart",           "crossing paths", "at the end", "same motion",    "far away",
      "nearly touching", "one large",      "points",     "huge",           "tiny"};
  return names[static_cast<std::size_t>(family)];
}

/// Pairs of spheres of a family.
template <std::floating_point S>
MovingSpheres<S> spheres(Random& random, Spheres family) {
  V centre_a = in_box(random, 4), centre_b = in_box(random, 4);
  double radius_a = random.uniform(0.125, 1), radius_b = random.uniform(0.125, 1);
  V displacement_a = in_box(random, 4), displacement_b = in_box(random, 4);
  const V between = centre_b - centre_a;
  // Each draw has a statement of its own: compilers differ in the order within an expression.
  if (random.chance(0.5)) {
    const double share = random.uniform(0.5, 2);
    displacement_a = displacement_b + between * share + in_box(random, 0.5);
  }
  switch (family) {
    case Spheres::graze: {
      // At the closest point of its path, b is a perpendicular of that length away.
      const V w = displacement_b - displacement_a, side = across(random, w);
      centre_b = centre_a + side * ((radius_a + radius_b) / side.norm()) - w * random.uniform();
      break;
    }
    case Spheres::fast: {
      const double times = random.uniform(50, 5000);
      displacement_a = displacement_b + between * times + in_box(random, 2);
      break;
    }
    case Spheres::start_in_touch: {
      centre_a = whole_in_box(random, 3);
      const int k = random.integer(0, 2);
      radius_a = random.integer(1, 4) / 4.0;
      radius_b = random.integer(1, 4) / 4.0;
      centre_b = centre_a;
      centre_b(k) += radius_a + radius_b;
      displacement_a = whole_in_box(random, 1);
      displacement_b = whole_in_box(random, 1);
      break;
    }
    case Spheres::overlapping:
      centre_b =
          centre_a + between * (random.uniform(0, 0.99) * (radius_a + radius_b) / between.norm());
      break;
    case Spheres::apart:
      displacement_b = displacement_a + between * random.uniform(0, 2);
      break;
    case Spheres::crossing: {
      const V cross = in_box(random, 2);
      const double first = random.uniform(0.1, 0.3), second = random.uniform(0.7, 0.9);
      displacement_a = in_box(random, 8);
      displacement_b = in_box(random, 8);
      centre_a = cross - displacement_a * first;
      centre_b = cross - displacement_b * second;
      break;
    }
    case Spheres::at_the_end: {
      const V apart = in_box(random, 1).normalized() * (radius_a + radius_b);
      centre_b = centre_a + displacement_a - displacement_b + apart;
      break;
    }
    case Spheres::same_motion:
      displacement_a = random.chance(0.25) ? V(V::Zero()) : displacement_b;
      if (displacement_a == V::Zero()) displacement_b = displacement_a;
      break;
    case Spheres::far: {
      const V shift = in_box(random, sizeof(S) == sizeof(double) ? 1e8 : 1e3);
      centre_a += shift;
      centre_b += shift;
      break;
    }
    case Spheres::nearly_touching: {
      const V apart =
          between.normalized() * ((radius_a + radius_b) * (1 + random.magnitude(-52, -44)));
      centre_b = centre_a + apart;
      break;
    }
    case Spheres::one_large: {
      const double size = std::ldexp(1, random.integer(8, 20));
      centre_b = centre_a + between * (size / 4);
      radius_b = between.norm() * (size / 4) - radius_a - random.uniform(0, 1);
      displacement_b = V(V::Zero());
      displacement_a = between * random.uniform(-1, 1);
      break;
    }
    case Spheres::points:
      radius_a = 0;
      if (random.chance(0.5)) radius_b = 0;
      centre_a = whole_in_box(random, 3);
      centre_b = whole_in_box(random, 3);
      displacement_a = whole_in_box(random, 3);
      displacement_b = whole_in_box(random, 3);
      break;
    case Spheres::huge:
    case Spheres::tiny: {
      const bool wide = sizeof(S) == sizeof(double);
      const int power = wide ? random.integer(200, 320) : random.integer(20, 40);
      const double scale = std::ldexp(1, family == Spheres::huge ? power : -power);
      centre_a *= scale;
      centre_b *= scale;
      displacement_a *= scale;
      displacement_b *= scale;
      radius_a *= scale;
      radius_b *= scale;
      break;
    }
    case Spheres::random:
      break;
  }
  const auto stored = [](const V& v) { return contact::Vector3<S>(v.cast<S>()); };
  return {{stored(centre_a), static_cast<S>(radius_a)},
          {stored(centre_b), static_cast<S>(radius_b)},
          stored(displacement_a),
          stored(displacement_b)};
}

}  // namespace families
