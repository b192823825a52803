#include "which_phase.hpp"

namespace exercise {
namespace {

std::int64_t count_of(const std::vector<Kind>& kinds) {
  std::int64_t n = 0;
  for (const Kind& kind : kinds) n += kind.count;
  return n;
}

// The sum over all pairs of squares of the share that their kinds have.
template <class Share>
double sum_over_pairs(const std::vector<Kind>& kinds, Share share) {
  double sum = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const double n = static_cast<double>(kinds[i].count);
    sum += n * (n - 1) / 2 * share(kinds[i].size, kinds[i].size);
    for (std::size_t j = i + 1; j < kinds.size(); ++j)
      sum += n * static_cast<double>(kinds[j].count) * share(kinds[i].size, kinds[j].size);
  }
  return sum;
}

// The share of pairs of positions on an axis at which squares share a cell.
double share_of_cells(std::int64_t length, std::int64_t edge, std::int64_t a, std::int64_t b) {
  //? For each position of one square, the others that share a cell are without gaps.
  std::int64_t shared = 0;
  for (std::int64_t x = 0; x < length; ++x) {
    //? The other square must start before the last cell of the first one ends, and end in its first
    //? cell or later.
    //? gap: x / edge * edge - b
    //? gap: ((x + a) / edge + 1) * edge
    const std::int64_t from = std::max<std::int64_t>(x / edge * edge - b, 0);
    const std::int64_t to = std::min(((x + a) / edge + 1) * edge, length);
    shared += to - from;
  }
  return static_cast<double>(shared) / static_cast<double>(length * length);
}

}  // namespace

std::int64_t all_pairs(const std::vector<Kind>& kinds) {
  //? Each with each of the others, and half of that, because a pair has no order.
  //? gap: n * (n - 1) / 2
  const std::int64_t n = count_of(kinds);
  return n * (n - 1) / 2;
}

double sweep(const std::vector<Kind>& kinds, const World& world) {
  //? A square of size s that starts at x overlaps those that start at x + 1 to x + s, as far as the
  //? world has such positions: of all x, s * width less 1 + 2 + ... + s.
  //? gap: s * world.width - s * (s + 1) / 2
  const auto later = [&](std::int64_t size) {
    const std::int64_t s = std::min(size, world.width);
    return s * world.width - s * (s + 1) / 2;
  };
  //? Either starts later, or both start at the same x.
  //? gap: world.width + later(a) + later(b)
  return sum_over_pairs(kinds, [&](std::int64_t a, std::int64_t b) {
    return static_cast<double>(world.width + later(a) + later(b)) /
           static_cast<double>(world.width * world.width);
  });
}

Grid grid(const std::vector<Kind>& kinds, const World& world, std::int64_t edge) {
  //? A square crosses size / edge borders on average on each axis.
  //? gap: 1 + static_cast<double>(kind.size) / static_cast<double>(edge)
  double entries = 0;
  for (const Kind& kind : kinds) {
    const double cells = 1 + static_cast<double>(kind.size) / static_cast<double>(edge);
    entries += static_cast<double>(kind.count) * cells * cells;
  }
  //? Squares share a cell if they do so on both axes, which are independent.
  //? gap: share_of_cells(world.height, edge, a, b)
  const double compared = sum_over_pairs(kinds, [&](std::int64_t a, std::int64_t b) {
    return share_of_cells(world.width, edge, a, b) * share_of_cells(world.height, edge, a, b);
  });
  return {entries, compared};
}

Method choose(const std::vector<Kind>& kinds, const World& world, std::int64_t edge) {
  //? Sorting halves its lists until one square is left in each.
  //? gap: std::int64_t{1} << levels
  const std::int64_t n = count_of(kinds);
  int levels = 0;
  while ((std::int64_t{1} << levels) < n) ++levels;
  //? Each method also pays for what it does before it compares.
  //? gap: expected.compared + expected.entries
  const Grid expected = grid(kinds, world, edge);
  const double pairs = static_cast<double>(all_pairs(kinds));
  const double by_sweep = sweep(kinds, world) + static_cast<double>(n * levels);
  const double by_grid = expected.compared + expected.entries;
  //? Of equals, the first stays.
  //? gap: by_grid < std::min(pairs, by_sweep)
  if (by_grid < std::min(pairs, by_sweep)) return Method::grid;
  return by_sweep < pairs ? Method::sweep : Method::all_pairs;
}

}  // namespace exercise
