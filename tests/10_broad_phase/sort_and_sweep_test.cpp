// What is right is found by comparing all pairs. The first questions of a test each bring one
// mistake to light that no question before did, so that the mistake is known by it.
#include "sort_and_sweep.hpp"

#include <limits>

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <10_broad_phase/sweep_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::Box;
using sweep_with_mistakes::Order;
using sweep_with_mistakes::Ways;
using Boxes = std::vector<Box>;

void check_order(const Boxes& boxes) {
  const auto with = [&](Order order) {
    return [&, order] { return sweep_with_mistakes::order_along_x(boxes, order); };
  };
  ask("In which order do the boxes start along x?")
      .given("boxes", boxes)
      .suspect("not-sorted", with(Order::not_at_all))
      .suspect("sorted-along-y", with(Order::along_y))
      .suspect("sorted-by-the-ends", with(Order::by_ends))
      .suspect("equal-starts-reversed", with(Order::larger_first))
      .suspect("equal-starts-by-ends", with(Order::ties_by_ends))
      .answer([&] { return exercise::order_along_x(boxes); })
      .equals(sweep_with_mistakes::order_along_x(boxes));
}

void check_sweep(const Boxes& boxes) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return sweep_with_mistakes::sweep(boxes, ways); };
  };
  ask("Which boxes touch, and how many pairs are compared along y?")
      .given("boxes", boxes)
      .suspect("not-sorted", with({.order = Order::not_at_all}))
      .suspect("sorted-by-the-ends", with({.order = Order::by_ends}))
      .suspect("end-at-a-start-missed", with({.ends_missed = true}))
      .suspect("touch-along-y-missed", with({.y_missed = true}))
      .suspect("next-box-alone", with({.next_alone = true}))
      .suspect("stopped-at-one-apart", with({.stops_early = true}))
      .suspect("touching-along-x-alone", with({.x_alone = true}))
      .suspect("positions-for-indices", with({.positions = true}))
      .suspect("pair-by-starts", with({.as_swept = true}))
      .suspect("pairs-as-they-were-found", with({.unsorted = true}))
      .suspect("touching-pairs-counted", with({.touching_counted = true}))
      .suspect("every-pair-compared", with({.no_stop = true}))
      .suspect("box-beyond-the-end-counted", with({.beyond_counted = true}))
      .answer([&] { return exercise::sort_and_sweep(boxes); })
      .equals(sweep_with_mistakes::all_pairs(boxes));
}

/// Boxes whose starts repeat after so many.
Boxes many(int starts) {
  Boxes boxes;
  for (int i = 0; i < 40; ++i) {
    const double x = 7 * i % starts;
    boxes.push_back({{x, 0}, {x + i, 1}});
  }
  return boxes;
}

bool are_boxes(const Boxes& boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [](const Box& box) {
    return box.low.allFinite() && box.high.allFinite() &&
           (box.low.array() <= box.high.array()).all();
  });
}

/// The sweep visits them in the order 1, 4, 2, 0, 3, 5.
Boxes several() {
  return {{{6, 0}, {9, 3}},  {{0, 0}, {4, 5}}, {{3, 4}, {7, 6}},
          {{8, 2}, {12, 5}}, {{1, 7}, {2, 9}}, {{8.5, 1}, {10, 4}}};
}

}  // namespace

TEST_CASE("boxes are in the order in which they start") {
  check_order({{{5, 2}, {6, 3}}, {{1, 1}, {9, 4}}, {{3, 3}, {4, 7}}});
  check_order(several());
  check_order({{{-2, 5}, {3, 6}}, {{-7, 2}, {-4, 3}}, {{-9, 4}, {8, 5}}, {{0, 1}, {1, 2}}});
  check_order({{{4, 4}, {5, 5}}});
  check_order(many(40));
  check_order({});
}

TEST_CASE("equal starts are in the order of the list") {
  check_order({{{3, 0}, {6, 1}}, {{1, 0}, {9, 1}}, {{3, 0}, {8, 1}}, {{1, 0}, {5, 1}}});
  check_order({{{2, 0}, {2, 1}}, {{2, 5}, {2, 6}}, {{2, 3}, {2, 4}}});
  check_order(many(5));
  check_order({{{0.0, 0}, {1, 1}}, {{-0.0, 0}, {2, 1}}, {{0.0, 0}, {0.5, 1}}});
}

TEST_CASE("pairs that touch are found, and comparisons counted") {
  check_sweep(several());
  check_sweep({{{0, 0}, {1, 1}}, {{2, 0}, {3, 1}}, {{0.5, 0.5}, {0.75, 4}}});
  check_sweep({{{0, 0}, {9, 9}}});
  check_sweep({});
}

TEST_CASE("a pair is named by its smaller index first") {
  check_sweep({{{5, 0}, {8, 2}}, {{1, 1}, {6, 4}}});
  Boxes reversed = several();
  std::reverse(reversed.begin(), reversed.end());
  check_sweep(reversed);
}

TEST_CASE("an end and a start at the same coordinate touch") {
  check_sweep({{{0, 0}, {3, 4}}, {{3, 1}, {5, 6}}});
  check_sweep({{{0, 0}, {3, 4}}, {{1, 4}, {5, 6}}});
  check_sweep({{{0, 0}, {3, 4}}, {{3, -5}, {5, 0}}});
  check_sweep({{{2, 2}, {2, 2}}, {{2, 2}, {2, 2}}, {{2, 0}, {2, 2}}, {{0, 2}, {2, 2}}});
  check_sweep({{{3, 0}, {3, 4}}, {{0, 4}, {3, 4}}, {{3, 4}, {7, 8}}, {{4, 0}, {4, 9}}});
}

TEST_CASE("a long box is compared with all that start before it ends") {
  check_sweep({{{0, 0}, {100, 1}},
               {{1, 5}, {2, 6}},
               {{10, 5}, {11, 6}},
               {{50, 0}, {51, 6}},
               {{99, 1}, {101, 2}},
               {{100, 0}, {101, 1}},
               {{101, 0}, {102, 1}}});
  check_sweep({{{5, 5}, {6, 6}}, {{-9, 0}, {9, 5}}, {{-8, 7}, {-7, 8}}, {{7, 2}, {8, 3}}});
}

TEST_CASE("numbers of any size are compared as they are") {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  constexpr double kHuge = std::numeric_limits<double>::max();
  check_sweep({{{-kHuge, -kHuge}, {-1, kHuge}}, {{-1, 0}, {kHuge, kHuge}}});
  check_sweep({{{-1, 0}, {-kTiny, 1}}, {{kTiny, 0}, {1, 1}}, {{-0.0, 0}, {kTiny, 1}}});
  check_sweep({{{-1, 0}, {-0.0, 1}}, {{0.0, -1}, {1, -0.0}}});
  check_sweep({{{0, 0}, {0.1 + 0.2, 1}}, {{0.3, 0}, {1, 1}}, {{0.1 + 0.2, 0}, {1, 1}}});
}

TEST_CASE("random boxes agree with all pairs") {
  generators::Random random(seed(0));
  const auto judged = [](const Boxes& boxes) { return are_boxes(boxes); };
  for (int asked = 0; asked < 200; ++asked) {
    const int count = random.integer(2, 9);
    const int range = asked % 2 == 0 ? 6 : 30;
    Boxes boxes;
    for (int i = 0; i < count; ++i) {
      const double x = random.integer(-range, range), y = random.integer(-range, range);
      const double width = random.integer(0, 8), height = random.integer(0, 8);
      boxes.push_back({{x, y}, {x + width, y + height}});
    }
    shrinkable(check_order, judged, boxes);
    shrinkable(check_sweep, judged, boxes);
  }
}
