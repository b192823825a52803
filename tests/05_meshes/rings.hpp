/// @file
/// Polygons with holes for tests: on a grid, star-shaped, and nearly degenerate.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/polygon.hpp>
#include <limits>
#include <support/generators.hpp>
#include <utility>
#include <vector>

namespace rings {

using generators::Random;
using Point = contact::Vector2<double>;
using Polygon = contact::Polygon<double>;
using Rings = std::vector<Polygon>;

inline Point grid_point(Random& random, int low, int high) {
  const int x = random.integer(low, high);
  const int y = random.integer(low, high);
  return {double(x), double(y)};
}

/// Points sorted by their direction from a centre, one in each direction: star-shaped, unless the
/// directions leave half a turn free.
inline Polygon star(Random& random, const Point& centre, int count, double size, bool whole) {
  std::vector<Point> offsets;
  for (int i = 0; i < count; ++i) {
    if (whole) {
      offsets.push_back(grid_point(random, -int(size), int(size)));
    } else {
      const double x = random.uniform(-size, size);
      const double y = random.uniform(-size, size);
      offsets.push_back({x, y});
    }
  }
  const auto upper = [](const Point& v) { return v.y() > 0 || (v.y() == 0 && v.x() > 0); };
  const auto before = [&upper](const Point& v, const Point& w) {
    if (upper(v) != upper(w)) return upper(v);
    return v.x() * w.y() - v.y() * w.x() > 0;
  };
  offsets.erase(
      std::remove_if(offsets.begin(), offsets.end(), [](const Point& v) { return v.isZero(0); }),
      offsets.end());
  std::stable_sort(offsets.begin(), offsets.end(), before);
  Polygon polygon;
  for (const Point& v : offsets) {
    if (polygon.empty() || before(polygon.back(), v)) polygon.push_back(v);
  }
  for (Point& v : polygon) v += centre;
  return polygon;
}

/// A polygon that grows by a vertex put into an edge, wherever that keeps it simple. `keeps`
/// decides for all rings.
template <class Keeps>
void grow(Random& random, Rings& all, std::size_t r, int tries, int low, int high,
          const Keeps& keeps) {
  for (int i = 0; i < tries; ++i) {
    Rings changed = all;
    Polygon& ring = changed[r];
    const int edge = random.integer(0, static_cast<int>(ring.size()) - 1);
    const Point p = grid_point(random, low, high);
    ring.insert(ring.begin() + edge + 1, p);
    if (keeps(changed)) all = std::move(changed);
  }
}

/// A grid polygon with as many holes as fit of some that are tried, each grown likewise.
template <class Keeps>
Rings on_grid(Random& random, int size, const Keeps& keeps) {
  Rings all;
  const auto add_triangle = [&](const Point& corner, int width) {
    Rings changed = all;
    const Point a = grid_point(random, 0, width);
    const Point b = grid_point(random, 0, width);
    const Point c = grid_point(random, 0, width);
    changed.push_back({corner + a, corner + b, corner + c});
    if (keeps(changed)) all = std::move(changed);
  };
  if (random.chance(0.5)) {
    const double s = size;
    all.push_back({Point(0, 0), Point(s, 0), Point(s, s), Point(0, s)});
  }
  while (all.empty()) add_triangle(Point(0, 0), size);
  grow(random, all, 0, random.integer(0, 10), 0, size, keeps);
  const int holes = random.integer(0, 25);
  for (int i = 0; i < holes; ++i) {
    const std::size_t count = all.size();
    const int width = random.integer(1, 3);
    const Point corner = grid_point(random, 0, size - width);
    add_triangle(corner, width);
    if (all.size() > count) {
      grow(random, all, count, random.integer(0, 20), 0, size, keeps);
    }
  }
  grow(random, all, 0, random.integer(0, 100), 0, size, keeps);
  for (Polygon& ring : all) {
    if (random.chance(0.5)) std::reverse(ring.begin(), ring.end());
    const int start = random.integer(0, static_cast<int>(ring.size()) - 1);
    std::rotate(ring.begin(), ring.begin() + start, ring.end());
  }
  return all;
}

/// A star with stars in it: often valid, not always.
inline Rings stars(Random& random, bool whole) {
  Rings all;
  const double size = whole ? 30 : 1;
  const int count = random.integer(3, 24);
  all.push_back(star(random, Point(0, 0), count, size, whole));
  const int holes = random.integer(0, 3);
  for (int i = 0; i < holes; ++i) {
    Point centre(0, 0);
    if (whole) {
      centre = grid_point(random, -15, 15);
    } else {
      const double x = random.uniform(-0.5, 0.5);
      const double y = random.uniform(-0.5, 0.5);
      centre = {x, y};
    }
    const int vertices = random.integer(3, 8);
    all.push_back(star(random, centre, vertices, whole ? 5 : 0.15, whole));
  }
  return all;
}

/// All coordinates by an affine map that rounds, and each then moved by up to 2 ulps: what was
/// straight is nearly straight.
inline Rings nearly(Random& random, Rings all) {
  const double scale = std::ldexp(random.uniform(1, 2), random.integer(-300, 300));
  const double skew = random.uniform(-1, 1);
  const double shift = random.chance(0.5) ? 0 : scale * std::ldexp(1.0, random.integer(0, 30));
  for (Polygon& ring : all) {
    for (Point& v : ring) {
      v = Point(shift + scale * (v.x() + skew * v.y()), scale * (v.y() - skew * v.x()));
      for (int k = 0; k < 2; ++k) {
        for (int step = random.integer(-2, 2); step != 0; step += step > 0 ? -1 : 1) {
          const double end = std::numeric_limits<double>::infinity();
          v[k] = std::nextafter(v[k], step > 0 ? end : -end);
        }
      }
    }
  }
  return all;
}

}  // namespace rings
