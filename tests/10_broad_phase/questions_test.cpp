#include "support/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <contact/moving_boxes.hpp>
#include <contact/periodic_grid.hpp>
#include <contact/regions.hpp>
#include <contact/sweep_pairs.hpp>
#include <contact/tree_pairs.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace questions_test {

namespace {

using contact::Aabb;
using contact::Vector3;
using Boxes = std::vector<Aabb<double>>;
using Span = std::span<const Aabb<double>>;

/// A box from low to high along x, and from 0 to 1 along y and z.
Aabb<double> along_x(double low, double high) { return {{low, 0, 0}, {high, 1, 1}}; }

/// Cubes of 1 m, each `apart` m from the next along an axis.
Boxes in_a_row(int count, int axis, double apart) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    Vector3<double> low = Vector3<double>::Zero();
    low[axis] = i * apart;
    boxes.push_back({low, low + Vector3<double>::Ones()});
  }
  return boxes;
}

/// The scene of the example's row "one 20 km wide": 999 boxes of 1 m at random positions in a cube
/// of 40 m, from the same numbers, and one that contains all of them.
Boxes one_huge() {
  Boxes boxes;
  std::uint64_t state = 1;
  for (int i = 0; i < 999; ++i) {
    Vector3<double> low = Vector3<double>::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      low[axis] = 40 * static_cast<double>(state >> 11) * 0x1p-53;
    }
    boxes.push_back({low, low + Vector3<double>::Ones()});
  }
  boxes.push_back({Vector3<double>::Constant(-1e4), Vector3<double>::Constant(1e4)});
  return boxes;
}

/// The steps after which a body that moves along x has left its fat box for the first time.
int steps_until_renewed(double margin, double step) {
  contact::FatBoxPairs<double> fat(margin);
  for (int k = 0;; ++k) {
    const Boxes boxes{along_x(k * step, 1 + k * step)};
    fat.update(Span(boxes));
    if (k > 0 && fat.renewed() > 0) return k;
  }
}

}  // namespace

KEY("count-of-pairs") {
  const Boxes boxes = in_a_row(200, 0, 2);
  return static_cast<double>(contact::all_pairs(Span(boxes)).box_tests);
}

KEY("ends-on-the-border") {
  const contact::Regions<double> hall({std::vector<double>{0, 2, 4, 6}, {}, {}});
  return static_cast<double>(hall.of(along_x(2, 4)).regions());
}

KEY("who-reports") {
  const contact::Regions<double> regions({std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}, {}, {}});
  const contact::RegionRange a = regions.of(along_x(3, 7)), b = regions.of(along_x(5, 9));
  return static_cast<double>(std::max(a.low[0], b.low[0]));
}

KEY("cell-of-minus") {
  // Eight cells of 1 m: the last one is the one before cell 0.
  CHECK(contact::periodic_cell(-0.3, 8.0, 8u) == 7);
  return std::floor(-0.3 / 1.0);
}

KEY("why-rounding-is-harmless") {
  // Points at the borders of cells of 0.1 m. One function, whatever it rounds, keeps their order; a
  // quotient and a product with the reciprocal do not always agree.
  const auto quotient = [](double x) { return contact::grid_cell(x, 0.0, 0.1); };
  const auto product = [](double x) { return static_cast<std::uint32_t>(x * (1 / 0.1)); };
  bool one_function = true, two_functions = true;
  for (int i = 1; i < 1000; ++i) {
    const double p = i / 10.0, low = std::nextafter(p, 0.0), high = std::nextafter(p, 1e9);
    one_function = one_function && quotient(low) <= quotient(p) && quotient(p) <= quotient(high);
    two_functions = two_functions && product(p) <= quotient(p);
  }
  return questions::Claim{one_function, two_functions};
}

KEY("cells-entered") {
  contact::BoxProfile profile;
  profile.count = 1;
  profile.mean_extent = Vector3<double>::Ones();
  return contact::expected_grid_entries(profile, 2.0);
}

KEY("twenty-seven") {
  const contact::PeriodicGrid<double> grid{Vector3<double>::Ones(), {2, 2, 2}};
  return static_cast<double>(contact::periodic_neighbours({0, 1, 0}, grid).size());
}

KEY("comparisons-of-a-sweep") {
  const Boxes boxes{along_x(0, 3), along_x(1, 2), along_x(2, 5), along_x(4, 6)};
  CHECK(contact::sweep_pairs(Span(boxes), 0).box_tests == 4);
  return static_cast<double>(contact::overlaps_on_axis(Span(boxes), 0));
}

KEY("axis-for-a-tower") {
  const Boxes tower = in_a_row(100, 2, 1);
  CHECK(contact::sweep_pairs(Span(tower), 0).box_tests == 4950);
  CHECK(contact::sweep_pairs(Span(tower), 2).box_tests == 99);
  return contact::best_sweep_axis(Span(tower)) == 2 ? 1 : 0;
}

KEY("tree-once") {
  // All boxes touch, so each pair is compared; one comparison more would be one twice.
  const Boxes boxes(100, along_x(0, 1));
  const contact::PairSearch search = contact::tree_pairs(Span(boxes));
  return questions::Claim{search.box_tests == 4950 && search.pairs.size() == 4950,
                          search.box_tests > 4950};
}

KEY("exchanged-places") {
  contact::IncrementalSweep<double> sweep(0);
  const auto boxes_at = [](const std::array<double, 5>& starts) {
    Boxes boxes;
    for (const double x : starts) boxes.push_back(along_x(x, x + 0.1));
    return boxes;
  };
  const Boxes before = boxes_at({0, 1, 2, 3, 4}), now = boxes_at({1, 0, 3, 4, 2});
  sweep.update(Span(before));
  return static_cast<double>(sweep.update(Span(now)).other_steps);
}

KEY("leaves-its-fat-box") { return static_cast<double>(steps_until_renewed(0.10, 0.04)); }

KEY("cross-without-meeting") {
  // The one passes x = 5 m in the first half of the step, the other in the second.
  const Boxes start{{{0, 4.5, 0}, {1, 5.5, 1}}, {{4.5, 30, 0}, {5.5, 31, 1}}};
  const Boxes end{{{30, 4.5, 0}, {31, 5.5, 1}}, {{4.5, 0, 0}, {5.5, 1, 1}}};
  const Boxes over = contact::boxes_over_step(Span(start), Span(end));
  CHECK(contact::boxes_touch(over[0], over[1]));
  bool touched = false;
  for (int k = 0; k <= 1000; ++k) {
    const double t = k / 1000.0;
    const auto at = [&](std::size_t i) {
      return Aabb<double>{start[i].low + t * (end[i].low - start[i].low),
                          start[i].high + t * (end[i].high - start[i].high)};
    };
    touched = touched || contact::boxes_touch(at(0), at(1));
  }
  return touched ? 0 : 1;
}

KEY("share-on-an-axis") {
  contact::BoxProfile profile;
  profile.count = 2;
  profile.spread = Vector3<double>::Constant(20);
  profile.mean_extent = profile.mean_square_extent = profile.largest_extent =
      Vector3<double>::Ones();
  return 100 * contact::expected_axis_share(profile, 0);
}

KEY("one-huge-body") {
  const Boxes boxes = one_huge();
  const contact::PairSearch tree = contact::tree_pairs(Span(boxes));
  // The numbers of the explanation.
  CHECK(tree.box_tests == 1633);
  CHECK(tree.other_steps == 3478);
  CHECK(contact::sweep_pairs(Span(boxes)).box_tests < contact::pair_count(boxes.size()) / 2);
  return tree.box_tests + tree.other_steps < 10000 ? 0 : 2;
}

}  // namespace questions_test
