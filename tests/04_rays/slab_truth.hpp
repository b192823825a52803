/// @file
/// Boxes and k-DOPs in fractions: quotients, and comparisons with those of the chapter.
#pragma once

#include <04_rays/lines.hpp>
#include <catch2/catch_test_macros.hpp>
#include <map>
#include <vector>

namespace rays {

/// low ≤ start + t speed ≤ high.
struct ExactSlab {
  Rational start, speed, low, high;
};

/// Where a line is in all slabs.
struct SlabTruth {
  bool meets = true;
  std::optional<Rational> entry, exit;
  int entry_face = -1, exit_face = -1;

  bool hits(bool ends) const { return meets && (!exit || (*exit >= 0 && (!ends || *entry <= 1))); }
  bool inside() const { return !entry || *entry < 0; }
};

inline SlabTruth truth(const std::vector<ExactSlab>& slabs) {
  SlabTruth found;
  int k = 0;
  for (const auto& [start, speed, low, high] : slabs) {
    if (speed == 0) {
      if (start < low || start > high) found.meets = false;
    } else {
      Rational first = (low - start) / speed, last = (high - start) / speed;
      const bool backwards = speed < 0;
      if (backwards) std::swap(first, last);
      if (!found.entry || first > *found.entry) {
        found.entry = first;
        found.entry_face = 2 * k + (backwards ? 1 : 0);
      }
      if (!found.exit || last < *found.exit) {
        found.exit = last;
        found.exit_face = 2 * k + (backwards ? 0 : 1);
      }
    }
    ++k;
  }
  if (found.entry && *found.entry > *found.exit) found.meets = false;
  return found;
}

/// Requires that hits, passage and first_hit of a body say what the slabs say.
/// @param share of the larger t by which both may be off
template <class S, class Line, class Body, class Hits>
void compare_slabs(const Line& line, const Body& body, const std::vector<ExactSlab>& slabs,
                   const Hits& hits, double share, std::map<int, int>& seen) {
  constexpr bool ends = contact::has_end<Line>;
  const SlabTruth right = truth(slabs);
  REQUIRE(hits(line, body) == right.hits(ends));
  const auto through = passage(line, body);
  const auto hit = first_hit(line, body);
  REQUIRE(through.has_value() == right.meets);
  REQUIRE(hit.has_value() == right.hits(ends));
  ++seen[right.hits(ends) ? 1 : 0];
  if (!right.meets) return;
  REQUIRE(through->entry_face == right.entry_face);
  REQUIRE(through->exit_face == right.exit_face);
  REQUIRE(through->entry <= through->exit);
  double largest = 0;
  if (right.entry) {
    const oracle::Surd entry{*right.entry}, exit{*right.exit};
    if (*right.entry == *right.exit) ++seen[2];
    largest = std::max(std::abs(oracle::nearest(entry)), std::abs(oracle::nearest(exit)));
    REQUIRE(t_is(through->entry, entry, largest, share));
    REQUIRE(t_is(through->exit, exit, largest, share));
    REQUIRE(std::abs(double(through->entry_normal.norm()) - 1) < 4e-7);
  } else {
    REQUIRE(through->entry == -std::numeric_limits<S>::infinity());
    REQUIRE(through->entry_normal == Vector3<S>::Zero());
  }
  if (!hit) return;
  REQUIRE(hit->inside == right.inside());
  REQUIRE(contact::all_finite(hit->normal));
  if (hit->inside) {
    ++seen[3];
    REQUIRE(hit->t == S(0));
    REQUIRE(hit->face == -1);
    REQUIRE(hit->point == contact::start_of(line));
    return;
  }
  REQUIRE(hit->t >= S(0));
  REQUIRE(!std::signbit(hit->t));
  if (ends) REQUIRE(hit->t <= S(1));
  REQUIRE(t_is(hit->t, oracle::Surd{*right.entry}, largest, share));
  REQUIRE(hit->face == right.entry_face);
  REQUIRE(hit->normal == through->entry_normal);
  REQUIRE(!hit->point.hasNaN());
  // The point, from the exact t.
  const Ray<Rational> exact = exact_line(line);
  for (int k = 0; k < 3; ++k) {
    const Rational coordinate = exact.origin(k) + *right.entry * exact.direction(k);
    const double step = largest * std::abs(oracle::nearest(exact.direction(k)));
    const double size = std::abs(oracle::nearest(exact.origin(k))) + step;
    if (!(size < 1e290) || !std::isfinite(double(hit->point(k)))) continue;
    const double room = (std::is_same_v<S, float> ? 0x1p-23 : 0x1p-50) * size + share * step +
                        0x1p-1072 * (1 + std::abs(oracle::nearest(exact.direction(k)))) +
                        double(std::numeric_limits<S>::denorm_min());
    REQUIRE(oracle::error(double(hit->point(k)), coordinate) <= room);
  }
}

}  // namespace rays
