/// @file
/// Expected numbers of comparisons, by counting positions or with one mistake that people make:
/// what the test of the exercise compares with and recognises.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "which_phase.hpp"

namespace phases_with_mistakes {

using exercise::Grid;
using exercise::Kind;
using exercise::Method;
using exercise::World;
using Kinds = std::vector<Kind>;
using Whole = std::int64_t;

inline Whole count_of(const Kinds& kinds) {
  Whole n = 0;
  for (const Kind& kind : kinds) n += kind.count;
  return n;
}

// ---------------------------------------------------------------- pairs

enum class Pairs { rightly, both_ways, with_itself, kinds_apart, in_32_bits };

inline Whole all_pairs(const Kinds& kinds, Pairs pairs = Pairs::rightly) {
  const Whole n = count_of(kinds);
  if (pairs == Pairs::both_ways) return n * (n - 1);
  if (pairs == Pairs::with_itself) return n * (n + 1) / 2;
  if (pairs == Pairs::in_32_bits) {
    const auto short_n = static_cast<std::uint32_t>(n);
    return std::uint32_t{short_n * (short_n - 1)} / 2;
  }
  if (pairs == Pairs::kinds_apart) {
    Whole sum = 0;
    for (const Kind& kind : kinds) sum += kind.count * (kind.count - 1) / 2;
    return sum;
  }
  return n * (n - 1) / 2;
}

/// The sum over all pairs of squares of a share that depends on both sizes.
template <class Share>
double sum_over_pairs(const Kinds& kinds, bool apart, Share share) {
  double sum = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (apart && j < i) continue;
      const Whole pairs =
          i == j ? kinds[i].count * (kinds[i].count - 1) / 2 : kinds[i].count * kinds[j].count;
      if (pairs != 0) sum += static_cast<double>(pairs) * share(kinds[i].size, kinds[j].size);
    }
  }
  return sum;
}

/// The share of the pairs of positions of an axis for which something holds.
template <class Holds>
double counted(Whole length, Holds holds) {
  Whole sum = 0;
  for (Whole x = 0; x < length; ++x)
    for (Whole y = 0; y < length; ++y) sum += holds(x, y) ? 1 : 0;
  return static_cast<double>(sum) / static_cast<double>(length * length);
}

// ---------------------------------------------------------------- sweep

enum class Sweep { rightly, one_direction, touching_apart, without_ends, mean_size, kinds_apart };

inline double overlap(Whole length, Whole a, Whole b, Sweep sweep = Sweep::rightly) {
  if (sweep == Sweep::without_ends)
    return std::min(1.0, static_cast<double>(1 + a + b) / static_cast<double>(length));
  return counted(length, [&](Whole x, Whole y) {
    if (sweep == Sweep::one_direction) return x <= y && y <= x + a;
    if (sweep == Sweep::touching_apart) return x < y + b && y < x + a;
    return x <= y + b && y <= x + a;
  });
}

inline double sweep(const Kinds& kinds, const World& world, Sweep how = Sweep::rightly) {
  if (how == Sweep::mean_size) {
    const Whole n = count_of(kinds);
    Whole sizes = 0;
    for (const Kind& kind : kinds) sizes += kind.count * kind.size;
    const Whole mean = n == 0 ? 0 : sizes / n;
    return sum_over_pairs(kinds, false,
                          [&](Whole, Whole) { return overlap(world.width, mean, mean); });
  }
  return sum_over_pairs(kinds, how == Sweep::kinds_apart,
                        [&](Whole a, Whole b) { return overlap(world.width, a, b, how); });
}

// ---------------------------------------------------------------- grid

enum class Cells { rightly, of_corners, one_axis, touching, by_area, kinds_apart };

inline double shared(Whole length, Whole edge, Whole a, Whole b, Cells cells) {
  if (cells == Cells::touching) return overlap(length, a, b);
  const Whole to_a = cells == Cells::of_corners ? 0 : a, to_b = cells == Cells::of_corners ? 0 : b;
  return counted(length, [&](Whole x, Whole y) {
    return x / edge <= (y + to_b) / edge && y / edge <= (x + to_a) / edge;
  });
}

inline Grid grid(const Kinds& kinds, const World& world, Whole edge, Cells cells = Cells::rightly) {
  Grid expected{0, 0};
  for (const Kind& kind : kinds) {
    Whole crossed = 0;
    for (Whole x = 0; x < edge; ++x) crossed += (x + kind.size) / edge;
    double along = 1 + static_cast<double>(crossed) / static_cast<double>(edge);
    if (cells == Cells::by_area)
      along = std::max(1.0, static_cast<double>(kind.size) / static_cast<double>(edge));
    if (cells == Cells::of_corners) along = 1;
    expected.entries += static_cast<double>(kind.count) * along * along;
  }
  expected.compared = sum_over_pairs(kinds, cells == Cells::kinds_apart, [&](Whole a, Whole b) {
    const double along_x = shared(world.width, edge, a, b, cells);
    return cells == Cells::one_axis ? along_x : along_x * shared(world.height, edge, a, b, cells);
  });
  return expected;
}

// ---------------------------------------------------------------- choice

enum class Choice { rightly, no_sorting, no_entries, last };

/// What each method costs, in the order of Method.
inline std::array<double, 3> costs(const Kinds& kinds, const World& world, Whole edge,
                                   Choice choice = Choice::rightly) {
  const Whole n = count_of(kinds);
  Whole levels = 0;
  for (Whole power = 1; power < n; power *= 2) ++levels;
  const Grid expected = phases_with_mistakes::grid(kinds, world, edge);
  return {static_cast<double>(phases_with_mistakes::all_pairs(kinds)),
          phases_with_mistakes::sweep(kinds, world) +
              (choice == Choice::no_sorting ? 0.0 : static_cast<double>(n * levels)),
          expected.compared + (choice == Choice::no_entries ? 0.0 : expected.entries)};
}

inline Method choose(const Kinds& kinds, const World& world, Whole edge,
                     Choice choice = Choice::rightly) {
  const std::array<double, 3> all = costs(kinds, world, edge, choice);
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (choice == Choice::last ? all[i] <= all[best] : all[i] < all[best]) best = i;
  return static_cast<Method>(best);
}

/// Whether no two of the smallest costs are equal but for rounding.
inline bool is_clear(const Kinds& kinds, const World& world, Whole edge) {
  std::array<double, 3> all = costs(kinds, world, edge);
  std::sort(all.begin(), all.end());
  return all[1] - all[0] > 1e-6 * (1 + all[1]);
}

}  // namespace phases_with_mistakes
