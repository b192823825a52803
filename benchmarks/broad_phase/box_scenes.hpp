/// @file
/// Families of boxes for the comparison, and the settings in which the cheapest method is
/// predicted.
///
/// Coordinates are multiples of 2^-8 m below 2^15 m: exact in float, and so are the middles and
/// sizes in double in which other programs keep boxes. All are asked about the same boxes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "peers.hpp"
#include "support/generators.hpp"

namespace box_scenes {

using Box = contact::Aabb<double>;
using Boxes = std::vector<Box>;
using Point = contact::Vector3<double>;
using generators::Random;

/// How boxes are distributed.
enum class Family {
  uniform,      ///< cubes of about 1 m, one for each 8 m³
  crowded,      ///< one for each 1 m³
  clusters,     ///< in balls of 64 boxes, far from each other
  one_huge,     ///< uniform, with one that contains all
  mixed_sizes,  ///< edges from 1/8 m to 32 m, every magnitude alike
  rods,         ///< 32 m long, each along a random axis
  on_a_floor,   ///< uniform in a layer of 2 m
  on_a_line,    ///< all along z
  equal_lows    ///< in columns: equal coordinates on x and y
};
inline constexpr std::array<Family, 9> all{
    Family::uniform, Family::crowded,    Family::clusters,  Family::one_huge,  Family::mixed_sizes,
    Family::rods,    Family::on_a_floor, Family::on_a_line, Family::equal_lows};

inline const char* name(Family family) {
  constexpr std::array<const char*, 9> names{"uniform",        "crowded",
                                             "clusters",       "one huge among them",
                                             "sizes 1 to 256", "rods of 1 m × 32 m",
                                             "on the floor",   "on a line z",
                                             "columns"};
  return names[static_cast<std::size_t>(family)];
}

/// The nearest multiple of 2^-8 m.
inline double stored(double x) { return std::ldexp(std::round(std::ldexp(x, 8)), -8); }

inline Point drawn(Random& random, const Point& low, const Point& high) {
  const double x = random.uniform(low.x(), high.x());
  const double y = random.uniform(low.y(), high.y());
  const double z = random.uniform(low.z(), high.z());
  return {stored(x), stored(y), stored(z)};
}
inline Box box_at(const Point& low, const Point& size) { return {low, Point(low + size)}; }

/// n boxes of edges from 1/2 m to 3/2 m times a factor 2^0 … 2^spread, one for each `room` m³ of a
/// cube.
inline Boxes in_a_cube(Random& random, std::size_t n, double room, int spread) {
  const double half = std::cbrt(static_cast<double>(n) * room) / 2;
  Boxes boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const Point low = drawn(random, Point::Constant(-half), Point::Constant(half));
    const double factor = std::ldexp(1.0, random.integer(0, spread));
    const Point size = drawn(random, Point::Constant(0.5), Point::Constant(1.5)) * factor;
    boxes.push_back(box_at(low, size));
  }
  return boxes;
}

/// n boxes of a family.
inline Boxes make(Family family, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const double count = static_cast<double>(n);
  const Point small = Point::Constant(0.5), large = Point::Constant(1.5);
  Boxes boxes;
  if (family == Family::crowded) return in_a_cube(random, n, 1, 0);
  if (family == Family::uniform || family == Family::one_huge) {
    boxes = in_a_cube(random, n, 8, 0);
    const double half = stored(std::cbrt(count) + 2);
    if (family == Family::one_huge) boxes[n / 2] = {Point::Constant(-half), Point::Constant(half)};
    return boxes;
  }
  const double side = std::cbrt(count);
  Point middle = Point::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    switch (family) {
      case Family::clusters:
        if (i % 64 == 0) {
          middle = drawn(random, Point::Constant(-20 * side), Point::Constant(20 * side));
        }
        boxes.push_back(
            box_at(drawn(random, middle - Point::Constant(3), middle + Point::Constant(3)),
                   drawn(random, small, large)));
        break;
      case Family::mixed_sizes: {
        const Point low = drawn(random, Point::Constant(-6 * side), Point::Constant(6 * side));
        const double factor = std::ldexp(1.0, random.integer(-3, 4));
        boxes.push_back(
            box_at(low, stored(factor) * drawn(random, Point::Ones(), 2 * Point::Ones())));
        break;
      }
      case Family::rods: {
        const Point low = drawn(random, Point::Constant(-4 * side), Point::Constant(4 * side));
        Point size = drawn(random, small, large);
        size(random.integer(0, 2)) = 32;
        boxes.push_back(box_at(low, size));
        break;
      }
      case Family::on_a_floor: {
        const double half = std::sqrt(2 * count);
        boxes.push_back(box_at(drawn(random, Point(-half, -half, 0), Point(half, half, 1)),
                               drawn(random, small, large)));
        break;
      }
      case Family::on_a_line:
        boxes.push_back(box_at(drawn(random, Point(0, 0, -count), Point(0, 0, count)),
                               drawn(random, small, large)));
        break;
      default: {  // columns, 4 m apart
        const int columns = std::max(1, static_cast<int>(side));
        const double x = 4.0 * random.integer(0, columns - 1);
        const double y = 4.0 * random.integer(0, columns - 1);
        const double z = stored(random.uniform(0, 4 * side));
        boxes.push_back(box_at(Point(x, y, z), Point::Ones()));
        break;
      }
    }
  }
  return boxes;
}

/// The same boxes after a step in which each has moved by at most `most` m on each axis.
inline Boxes moved(const Boxes& boxes, double most, std::uint64_t seed) {
  Random random(seed);
  Boxes after;
  for (const Box& box : boxes) {
    const Point by = drawn(random, Point::Constant(-most), Point::Constant(most));
    after.push_back({Point(box.low + by), Point(box.high + by)});
  }
  return after;
}

/// The boxes as others receive them.
inline peers::Boxes plain(const Boxes& boxes) {
  peers::Boxes made;
  made.reserve(boxes.size());
  for (const Box& box : boxes) {
    made.push_back(
        {{box.low.x(), box.low.y(), box.low.z()}, {box.high.x(), box.high.y(), box.high.z()}});
  }
  return made;
}

/// A setting in which the cheapest method is predicted.
struct Setting {
  std::size_t count;
  int spread;   ///< sizes differ by a factor of up to 2^spread
  double room;  ///< m³ for each box
};

/// Counts from 8 to 10,000, sizes alike or up to 1 : 64, from packed to sparse.
inline std::vector<Setting> settings() {
  std::vector<Setting> all_settings;
  for (const std::size_t count : {8U, 32U, 128U, 1000U, 10000U}) {
    for (const int spread : {0, 6}) {
      for (const double room : {0.25, 8.0, 1000.0}) {
        // 10,000 of them would touch by the million.
        if (count > 1000 && spread > 0 && room < 1000) continue;
        all_settings.push_back({count, spread, room});
      }
    }
  }
  return all_settings;
}

}  // namespace box_scenes
