/// @file
/// Round bodies and a line, in fractions and square roots: another way than the book's. A body is a
/// union of regions, each where some polynomials in t of degree ≤ 2 are not positive; the ends of
/// the t in a region are roots, so all of them are tried.
#pragma once

#include <04_rays/lines.hpp>
#include <contact/ball_box.hpp>
#include <contact/ray_capsule.hpp>
#include <contact/ray_cone.hpp>
#include <contact/ray_cylinder.hpp>
#include <optional>
#include <vector>

namespace bodies {

using contact::Ray;
using contact::Segment;
using contact::Vector3;
using oracle::Quadratic;
using oracle::Rational;
using oracle::Surd;
using Line = Ray<Rational>;
using Point = Vector3<Rational>;

/// All t at which no polynomial is positive.
using Region = std::vector<Quadratic>;

/// The sign of a polynomial at a number with one root.
inline int sign_at(const Quadratic& q, const Surd& t) {
  return oracle::sign(Surd{q.a * (t.a * t.a + t.b * t.b * t.d) + q.b * t.a + q.c,
                           2 * q.a * t.a * t.b + q.b * t.b, t.d});
}

/// low ≤ at + t rate ≤ high as two polynomials.
inline void between(Region& region, const Rational& at, const Rational& rate, const Rational& low,
                    const Rational& high) {
  region.push_back({0, -rate, low - at});
  region.push_back({0, rate, at - high});
}

/// The first and last t of a region; `unbounded` if it is all t, or empty.
struct Found {
  bool met = false;
  bool low_open = true, high_open = true;  ///< no end
  Surd low, high;
};

inline Found find(const Region& region) {
  std::vector<Surd> tried{{0, 0, 0}};
  for (const Quadratic& q : region) {
    if (q.a == 0 && q.b == 0) {
      if (q.c > 0) return {};
      continue;
    }
    for (const Surd& root : q.roots()) tried.push_back(root);
  }
  Found found;
  const auto in = [&region](const Surd& t) {
    for (const Quadratic& q : region) {
      if (sign_at(q, t) > 0) return false;
    }
    return true;
  };
  // Where a polynomial goes for large t.
  const auto open = [&region](int side) {
    for (const Quadratic& q : region) {
      const int way =
          q.a != 0 ? oracle::sign(q.a) : (q.b != 0 ? side * oracle::sign(q.b) : oracle::sign(q.c));
      if (way > 0) return false;
    }
    return true;
  };
  for (const Surd& t : tried) {
    if (!in(t)) continue;
    if (!found.met || oracle::compare(t, found.low) < 0) found.low = t;
    if (!found.met || oracle::compare(t, found.high) > 0) found.high = t;
    found.met = true;
  }
  found.low_open = found.met && open(-1);
  found.high_open = found.met && open(1);
  return found;
}

/// All t of a body: the regions' union, which is convex.
inline Found find(const std::vector<Region>& regions) {
  Found all;
  for (const Region& region : regions) {
    const Found one = find(region);
    if (!one.met) continue;
    if (!all.met) {
      all = one;
      continue;
    }
    all.low_open = all.low_open || one.low_open;
    all.high_open = all.high_open || one.high_open;
    if (oracle::compare(one.low, all.low) < 0) all.low = one.low;
    if (oracle::compare(one.high, all.high) > 0) all.high = one.high;
  }
  return all;
}

/// Whether a ray or a segment meets the body.
inline bool meets(std::vector<Region> regions, bool has_end) {
  for (Region& region : regions) {
    region.push_back({0, -1, 0});
    if (has_end) region.push_back({0, 1, -1});
    if (find(region).met) return true;
  }
  return false;
}

/// |p + t w|² − r² for the given p and w, by squares.
inline Quadratic ball(const Point& p, const Point& w, const Rational& r) {
  return {w.dot(w), 2 * p.dot(w), p.dot(p) - r * r};
}

struct Core {
  Point start, axis;
  Rational radius;
};
template <class S>
Core core_of(const Segment<S>& segment, S radius) {
  const Point start = oracle::exact(segment.start);
  return {start, oracle::exact(segment.end) - start, oracle::exact(radius)};
}

/// The squared distance from the core's line less r², by subtracting what is along it.
inline Quadratic wall(const Line& line, const Core& core) {
  const Point m = line.origin - core.start;
  const Rational ee = core.axis.dot(core.axis);
  const Point m_off = m - core.axis * Rational(m.dot(core.axis) / ee);
  const Point w_off = line.direction - core.axis * Rational(line.direction.dot(core.axis) / ee);
  return ball(m_off, w_off, core.radius);
}

template <class S>
std::vector<Region> regions(const Line& line, const contact::Cylinder<S>& cylinder) {
  const Core core = core_of(cylinder.core, cylinder.radius);
  const Rational ee = core.axis.dot(core.axis);
  if (ee == 0) return {};
  Region region{wall(line, core)};
  between(region, (line.origin - core.start).dot(core.axis), line.direction.dot(core.axis), 0, ee);
  return {region};
}

/// Beyond each end the distance is that from the end; between them that from the line.
template <class S>
std::vector<Region> regions(const Line& line, const contact::Capsule<S>& capsule) {
  const Core core = core_of(capsule.core, capsule.radius);
  const Rational ee = core.axis.dot(core.axis);
  const Point m = line.origin - core.start, from_end = m - core.axis;
  const Region first{ball(m, line.direction, core.radius)};
  if (ee == 0) return {first};
  const Rational at = m.dot(core.axis), rate = line.direction.dot(core.axis);
  Region before{first[0], {0, rate, at}};
  Region after{ball(from_end, line.direction, core.radius), {0, -rate, ee - at}};
  Region middle{wall(line, core)};
  between(middle, at, rate, 0, ee);
  return {before, middle, after};
}

/// The first point of the wall in fractions: all roots tried.
inline std::optional<Surd> first_on_wall(const Line& line, const Core& core, bool has_end) {
  const Quadratic q = wall(line, core);
  Region ends;
  between(ends, (line.origin - core.start).dot(core.axis), line.direction.dot(core.axis), 0,
          core.axis.dot(core.axis));
  ends.push_back({0, -1, 0});
  if (has_end) ends.push_back({0, 1, -1});
  if (q.a == 0 && q.b == 0) {
    if (q.c != 0) return std::nullopt;
    const Found found = find(ends);
    return found.met ? std::optional(found.low) : std::nullopt;
  }
  for (const Surd& t : q.roots()) {
    bool in = true;
    for (const Quadratic& end : ends) in = in && sign_at(end, t) <= 0;
    if (in) return t;
  }
  return std::nullopt;
}

/// |x|² h·h ≤ (1 + r²/h·h) (x·h)².
template <class S>
std::vector<Region> regions(const Line& line, const contact::Cone<S>& cone) {
  const Core core = core_of(Segment<S>{cone.apex, cone.base}, cone.radius);
  const Rational hh = core.axis.dot(core.axis);
  if (hh == 0) return {};
  const Point m = line.origin - core.start;
  const Point& w = line.direction;
  const Rational at = m.dot(core.axis), rate = w.dot(core.axis);
  const Rational wide = 1 + core.radius * core.radius / hh;
  Region region{{w.dot(w) * hh - wide * rate * rate, 2 * (m.dot(w) * hh - wide * at * rate),
                 m.dot(m) * hh - wide * at * at}};
  between(region, at, rate, 0, hh);
  return {region};
}

/// A box and a radius: by which of its 27 regions the centre is in, below, in or above each slab.
struct RoundedBox {
  Point low, high;
  Rational radius;
};
inline std::vector<Region> regions(const Line& line, const RoundedBox& box) {
  std::vector<Region> all;
  for (int which = 0; which < 27; ++which) {
    Region region;
    Point m(0, 0, 0), w(0, 0, 0);
    bool possible = true;
    int rest = which;
    for (int k = 0; k < 3; ++k, rest /= 3) {
      const Rational at = line.origin(k), rate = line.direction(k);
      if (rest % 3 == 1) {
        between(region, at, rate, box.low(k), box.high(k));
        possible = possible && !(rate == 0 && (at < box.low(k) || at > box.high(k)));
        continue;
      }
      const bool below = rest % 3 == 0;
      const Rational face = below ? box.low(k) : box.high(k);
      m(k) = at - face;
      w(k) = rate;
      region.push_back(below ? Quadratic{0, rate, at - face} : Quadratic{0, -rate, face - at});
      possible = possible && !(rate == 0 && region.back().c > 0);
    }
    region.push_back(ball(m, w, box.radius));
    if (possible) all.push_back(region);
  }
  return all;
}

}  // namespace bodies
