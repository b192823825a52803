// Up to 5,000 discs that move in a room and bounce softly off each other and the walls, and one of
// the reader's: the pairs of boxes that each broad phase compares.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/box_tree.hpp>
#include <contact/broad_phase_cost.hpp>
#include <contact/figure.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

using Point = contact::Vector2<double>;
using Boxes = std::vector<contact::Aabb<double>>;

struct Input {
  double number;  // of discs besides the reader's
  double method;  // 0 all pairs, 1 sweep along x, 2 grid, 3 tree
  double edge;    // of the grid's cells, m
  Point yours;    // centre of the reader's disc, m; the other discs do not feel it
  double radius;  // of the reader's disc, m
  double mixed;   // 1: discs of four sizes
  double time;    // s
};

constexpr std::size_t max_discs = 5000, few_discs = 8, max_boxes = 48;
constexpr std::size_t across = 50, bins = 100;

struct Output {
  double problem;
  double count;                         // of discs, without the reader's
  std::array<double, 4> radii;          // of disc i: radii[i % 4]
  std::array<Point, max_discs> centre;  // m
  // 3 touches yours, 2 is compared with yours, 1 touches another, 0 none of these.
  std::array<double, max_discs> state;
  double compared;                      // pairs by the chosen method
  double all_pairs, sweep, grid, tree;  // pairs compared by each
  double entries;                       // of boxes in cells, and pairs skipped there
  double nodes;                         // comparisons of two nodes of the tree
  double touching;                      // pairs of boxes that touch
  double cheapest;                      // the method that the cost model predicts
  double compared_with_yours, touching_yours;
  // The grid: comparisons in each cell, if the cells are not too many to be drawn.
  double cells;  // along each side of the room; 0 if they are
  std::array<double, across * across> in_cell;
  double max_in_cell;
  std::array<double, bins> at_x;  // the sweep: comparisons at each position of its line
  double max_at_x;
  // The tree: the boxes that meet yours, as many as are drawn.
  double boxes;
  std::array<Point, max_boxes> box_low, box_high;
  // For a reader's function on whole numbers: the box of the reader's disc and the edge, in µm, the
  // cells in which the box has a point, and 1 if the grid enters it in the same ones.
  Point low, high;
  double whole_edge;
  Point first_cell, last_cell;
  double same_cells;
  // For one that sweeps: (radius, radius), and the boxes of the first discs, low and high.
  Point reach;
  std::array<std::array<Point, 2>, few_discs> few;
  // Goals of questions.
  double many_cells;     // the grid compares the reader's disc with all
  double grid_is_worse;  // than all pairs, by comparisons and entries
};

namespace {

constexpr double side = 10;     // of the room, m
constexpr double share = 0.12;  // of the room that the discs cover
constexpr int steps_per_second = 30, seconds = 8;
constexpr double step = 1.0 / steps_per_second;
/// Of overlap: acceleration per depth, 1/s².
constexpr double stiffness = 200;

struct Disc {
  Point centre, velocity;
  double radius;
};
using Discs = std::vector<Disc>;

/// A multiple of 2^-32 in [0, 1), from a counter (splitmix64's mixer).
double random_share(std::uint64_t& counter) {
  std::uint64_t z = (counter += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 32) * 0x1p-32;
}

/// The four sizes of discs: all equal, or from a third of a radius to 1.76 of them.
std::array<double, 4> radii_of(std::size_t number, bool mixed) {
  const double mean = std::sqrt(share * side * side / (3.141592653589793 * double(number)));
  if (!mixed) return {mean, mean, mean, mean};
  // The squares of these have the mean 1, so that the discs cover as much.
  return {mean / 3, mean / 2, 0.75 * mean, 1.757 * mean};
}

Discs at_start(std::size_t number, bool mixed) {
  const std::array<double, 4> radii = radii_of(number, mixed);
  const double speed = 12 * radii_of(number, false)[0];
  std::uint64_t counter = 1;
  Discs discs(number);
  for (std::size_t i = 0; i < number; ++i) {
    Disc& disc = discs[i];
    disc.radius = radii[i % 4];
    disc.centre.x() = disc.radius + random_share(counter) * (side - 2 * disc.radius);
    disc.centre.y() = disc.radius + random_share(counter) * (side - 2 * disc.radius);
    disc.velocity.x() = speed * (random_share(counter) - 0.5);
    disc.velocity.y() = speed * (random_share(counter) - 0.5);
  }
  return discs;
}

/// Flat, so that the third axis separates nothing.
contact::Aabb<double> box_of(const Point& centre, double radius) {
  auto box = contact::aabb_of_sphere<double>({{centre.x(), centre.y(), 0}, radius});
  box.low.z() = box.high.z() = 0;
  return box;
}

Boxes boxes_of(const Discs& discs) {
  Boxes boxes;
  for (const Disc& disc : discs) boxes.push_back(box_of(disc.centre, disc.radius));
  return boxes;
}

/// One step of semi-implicit Euler with springs between discs that overlap. The grid finds them.
void move(Discs& discs) {
  for (const auto [a, b] : contact::grid_pairs<double>(boxes_of(discs)).pairs) {
    Disc &one = discs[a], &other = discs[b];
    const Point between = other.centre - one.centre;
    const double distance = std::sqrt(between.squaredNorm());
    const double depth = one.radius + other.radius - distance;
    if (!(depth > 0) || !(distance > 0)) continue;
    const Point pushed = step * stiffness * depth / distance * between;
    one.velocity -= pushed;
    other.velocity += pushed;
  }
  for (Disc& disc : discs) {
    for (int k = 0; k < 2; ++k) {
      const double below = disc.radius - disc.centre(k);
      const double above = disc.centre(k) + disc.radius - side;
      disc.velocity(k) += step * stiffness * 2 * (std::max(below, 0.0) - std::max(above, 0.0));
    }
    disc.centre += step * disc.velocity;
  }
}

/// The discs at a time. States of whole seconds are kept, so that a slider can go back.
Discs at_time(std::size_t number, bool mixed, double time) {
  using Kind = std::pair<std::size_t, bool>;
  static Kind kept_kind;
  static std::map<int, Discs> kept;
  if (kept_kind != Kind(number, mixed) || kept.empty()) {
    kept.clear();
    kept[0] = at_start(number, mixed);
    kept_kind = {number, mixed};
  }
  const int wanted = static_cast<int>(std::floor(time * steps_per_second));
  const auto before = std::prev(kept.upper_bound(wanted));
  int now = before->first;
  Discs discs = before->second;
  while (now < wanted) {
    move(discs);
    if (++now % steps_per_second == 0) kept.emplace(now, discs);
  }
  // The last state as well: a film goes on from it.
  static int last = 0;
  if (last != now && last % steps_per_second != 0) kept.erase(last);
  kept.emplace(last = now, discs);
  for (Disc& disc : discs) disc.centre += (time - now * step) * disc.velocity;
  return discs;
}

int cell(double x, double edge) { return static_cast<int>(contact::grid_cell(x, 0.0, edge)); }

struct Cells {
  std::array<int, 2> first, last;
  Cells(const contact::Aabb<double>& box, double edge)
      : first{cell(box.low.x(), edge), cell(box.low.y(), edge)},
        last{cell(box.high.x(), edge), cell(box.high.y(), edge)} {}
  bool many() const {
    const auto cells = double(last[0] - first[0] + 1) * double(last[1] - first[1] + 1);
    return cells > double(contact::max_cells_of_a_box);
  }
  bool shares(const Cells& other) const {
    return first[0] <= other.last[0] && other.first[0] <= last[0] && first[1] <= other.last[1] &&
           other.first[1] <= last[1];
  }
};

/// The comparisons that the grid makes in each cell: of pairs of which it is the first in common.
void count_in_cells(const Boxes& boxes, double edge, Output& out) {
  if (!(edge >= side / double(across))) return;
  out.cells = std::ceil(side / edge);
  const int cells = static_cast<int>(out.cells);
  std::vector<Cells> ranges;
  std::vector<std::vector<std::size_t>> in_cell(std::size_t(cells * cells));
  const auto index = [&](int x, int y) {
    return std::size_t(std::min(y, cells - 1) * cells + std::min(x, cells - 1));
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Cells& of = ranges.emplace_back(boxes[i], edge);
    if (of.many()) continue;
    for (int x = of.first[0]; x <= std::min(of.last[0], cells - 1); ++x) {
      for (int y = of.first[1]; y <= std::min(of.last[1], cells - 1); ++y)
        in_cell[index(x, y)].push_back(i);
    }
  }
  for (std::size_t at = 0; at < in_cell.size(); ++at) {
    for (const std::size_t i : in_cell[at]) {
      for (const std::size_t j : in_cell[at]) {
        if (j >= i) break;
        const int x = std::max(ranges[i].first[0], ranges[j].first[0]);
        const int y = std::max(ranges[i].first[1], ranges[j].first[1]);
        if (index(x, y) == at) ++out.in_cell[at];
      }
    }
    out.max_in_cell = std::max(out.max_in_cell, out.in_cell[at]);
  }
}

/// The comparisons of the sweep at each position: when a box begins, it is compared with those that
/// have begun and not ended.
void count_along_x(const Boxes& boxes, Output& out) {
  std::vector<double> lows, highs;
  for (const auto& box : boxes) {
    lows.push_back(box.low.x());
    highs.push_back(box.high.x());
  }
  std::sort(lows.begin(), lows.end());
  std::sort(highs.begin(), highs.end());
  std::size_t ended = 0;
  for (std::size_t begun = 0; begun < lows.size(); ++begun) {
    while (ended < highs.size() && highs[ended] < lows[begun]) ++ended;
    const double bin = std::clamp(lows[begun] / side * double(bins), 0.0, double(bins - 1));
    out.at_x[std::size_t(bin)] += double(begun - ended);
  }
  out.max_at_x = *std::max_element(out.at_x.begin(), out.at_x.end());
}

/// Which boxes a query of the tree for yours compares, and the nodes that it enters.
void ask_tree(const Boxes& boxes, const contact::Aabb<double>& yours, std::vector<char>& compared,
              Output& out) {
  const contact::BoxTree<double> tree(boxes);
  std::size_t entered = 0;
  const auto enters = [&](const contact::Aabb<double>& box) {
    if (!contact::boxes_touch(box, yours)) return false;
    if (entered < max_boxes) {
      out.box_low[entered] = box.low.head<2>();
      out.box_high[entered] = box.high.head<2>();
    }
    ++entered;
    return true;
  };
  contact::visit_box_hierarchy(tree.hierarchy(), enters, [&](int at) {
    compared[std::size_t(tree.hierarchy().order[std::size_t(at)])] = 1;
    return false;
  });
  out.boxes = double(std::min(entered, max_boxes));
}

/// Marks the boxes that the chosen method compares with the last one, which is yours.
std::vector<char> compared_with_yours(const Input& in, const Boxes& boxes, Output& out) {
  const contact::Aabb<double>& yours = boxes.back();
  std::vector<char> compared(boxes.size(), in.method == 0 ? 1 : 0);
  if (in.method == 1) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      compared[i] = boxes[i].low.x() <= yours.high.x() && yours.low.x() <= boxes[i].high.x();
    count_along_x(boxes, out);
  } else if (in.method == 2) {
    const Cells mine(yours, in.edge);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Cells other(boxes[i], in.edge);
      compared[i] = mine.many() || other.many() || mine.shares(other);
    }
    count_in_cells(boxes, in.edge, out);
    out.many_cells = mine.many() ? 1 : 0;
  } else if (in.method == 3) {
    ask_tree(boxes, yours, compared, out);
  }
  compared.back() = 0;
  return compared;
}

/// The cell of a whole number, without rounding.
double whole_cell(double x, double edge) {
  const auto number = static_cast<std::int64_t>(x), size = static_cast<std::int64_t>(edge);
  const std::int64_t quotient = number / size;
  return double(quotient - (number % size < 0 ? 1 : 0));
}

void in_whole_numbers(const Input& in, const contact::Aabb<double>& yours, Output& out) {
  const auto whole = [](double x) { return std::round(1e6 * x); };
  out.whole_edge = whole(in.edge);
  const double radius = whole(in.radius);
  bool same = true;
  const Cells entered(yours, in.edge);
  for (int k = 0; k < 2; ++k) {
    out.low(k) = whole(in.yours(k)) - radius;
    out.high(k) = whole(in.yours(k)) + radius;
    out.first_cell(k) = whole_cell(out.low(k), out.whole_edge);
    out.last_cell(k) = whole_cell(out.high(k), out.whole_edge);
    same = same && out.first_cell(k) == entered.first[std::size_t(k)] &&
           out.last_cell(k) == entered.last[std::size_t(k)];
  }
  out.same_cells = same ? 1 : 0;
}

void search(const Input& in, const Boxes& boxes, Output& out) {
  // [compared]
  const std::span<const contact::Aabb<double>> all = boxes;
  const contact::PairGrid<double> grid{{0, 0, 0}, in.edge};
  const contact::PairSearch by_grid = contact::grid_pairs(all, grid);
  const contact::PairSearch by_tree = contact::tree_pairs(all);
  out.all_pairs = double(contact::pair_count(all.size()));
  out.sweep = double(contact::overlaps_on_axis(all, 0));
  out.grid = double(by_grid.box_tests);
  out.entries = double(by_grid.other_steps);
  out.tree = double(by_tree.box_tests);
  out.nodes = double(by_tree.other_steps);
  out.cheapest = double(contact::broad_phase_cost(all).cheapest());
  // [/compared]
  const contact::PairSearch found = in.method == 0   ? contact::all_pairs(all)
                                    : in.method == 1 ? contact::sweep_pairs(all, 0)
                                    : in.method == 2 ? by_grid
                                                     : by_tree;
  out.compared = double(found.box_tests);
  out.touching = double(found.pairs.size());
  out.grid_is_worse = out.grid + out.entries > out.all_pairs ? 1 : 0;

  const std::vector<char> compared = compared_with_yours(in, boxes, out);
  for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
    out.state[i] = compared[i] ? 2 : 0;
    out.compared_with_yours += compared[i] ? 1 : 0;
  }
  const std::size_t yours = boxes.size() - 1;
  for (const auto [a, b] : found.pairs) {
    if (b == yours) {
      out.state[a] = 3;
      ++out.touching_yours;
    } else {
      for (const std::size_t i : {a, b}) out.state[i] = std::max(out.state[i], 1.0);
    }
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (in.yours.cwiseAbs().maxCoeff() > 1e3 || in.radius > 1e3 || in.edge > 1e3)
    out.problem = contact::figure::too_large;
  if (!(in.radius >= 1e-6) || !(in.edge >= 1e-3)) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  const auto number =
      static_cast<std::size_t>(std::clamp(std::round(in.number), 1.0, double(max_discs)));
  const bool mixed = in.mixed == 1;
  const Discs discs = at_time(number, mixed, std::clamp(in.time, 0.0, double(seconds)));
  out.count = double(number);
  out.radii = radii_of(number, mixed);
  for (std::size_t i = 0; i < number; ++i) out.centre[i] = discs[i].centre;
  Boxes boxes = boxes_of(discs);
  boxes.push_back(box_of(in.yours, in.radius));
  search(in, boxes, out);
  out.reach = Point::Constant(in.radius);
  for (std::size_t i = 0; i < std::min(number, few_discs); ++i)
    out.few[i] = {boxes[i].low.head<2>(), boxes[i].high.head<2>()};
  in_whole_numbers(in, boxes.back(), out);
  return out;
}

FIGURE(Input, FIELDS(number, method, edge, yours, radius, mixed, time), Output,
       FIELDS(problem, count, radii, centre, state, compared, all_pairs, sweep, grid, tree, entries,
              nodes, touching, cheapest, compared_with_yours, touching_yours, cells, in_cell,
              max_in_cell, at_x, max_at_x, boxes, box_low, box_high, low, high, whole_edge,
              first_cell, last_cell, same_cells, reach, few, many_cells, grid_is_worse))
