/// @file
/// Points of sets for which signs of determinants are hard: nearly or exactly in a plane or on a
/// line, on a sphere, at extreme scales, a few ulps apart.
#pragma once

#include <contact/vector.hpp>
#include <support/generators.hpp>

namespace hard_points {

/// The number of kinds.
inline constexpr int kKinds = 8;

/// A point of a set of a kind from 0 to kKinds − 1.
inline contact::Vector3<double> draw(generators::Random& random, int kind) {
  const auto whole = [&](int size) { return double(random.integer(-size, size)); };
  switch (kind) {
    case 0: {
      const double x = whole(2), y = whole(2);
      return {x, y, whole(2)};
    }
    case 1: {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      return {x, y, random.uniform(-1, 1)};
    }
    case 2: {  // nearly in a plane: rounded combinations
      const double x = whole(10) / 10, y = whole(10) / 10;
      return {x, y, 0.3 * x + 0.7 * y};
    }
    case 3: {  // nearly on a line
      const double t = random.uniform();
      return {0.1 + 0.7 * t, 0.3 - 0.2 * t, 0.9 * t};
    }
    case 4: {  // nearly on a sphere
      contact::Vector3<double> v{random.uniform(-1, 1), random.uniform(-1, 1),
                                 random.uniform(-1, 1)};
      return v / v.norm();
    }
    case 5: {  // exactly in a plane
      const double x = whole(4), y = whole(4);
      return {x, y, x + 2 * y};
    }
    case 6: {  // at extreme scales
      const double scale = random.chance(0.5) ? 0x1p-540 : 0x1p500;
      const double x = whole(3) * scale, y = whole(3) * scale;
      return {x, y, whole(3) * scale};
    }
    default: {  // a few ulps apart
      const auto near = [&] { return 0.5 + whole(3) * 0x1p-53; };
      const double x = near(), y = near();
      return {x, y, near()};
    }
  }
}

}  // namespace hard_points
