// What is right is found by counting all pairs of positions. The first questions of a test each
// bring one mistake to light that no question before did, so that the mistake is known by it.
#include "which_phase.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <10_broad_phase/phases_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::Grid;
using exercise::World;
using phases_with_mistakes::Cells;
using phases_with_mistakes::Choice;
using phases_with_mistakes::Kinds;
using phases_with_mistakes::Pairs;
using phases_with_mistakes::Sweep;

constexpr double kRelative = 1e-9;

void check_pairs(const Kinds& kinds) {
  const auto with = [&](Pairs pairs) {
    return [&, pairs] { return phases_with_mistakes::all_pairs(kinds, pairs); };
  };
  ask("How many pairs of squares are there?")
      .given("kinds", kinds)
      .suspect("pairs-both-ways", with(Pairs::both_ways))
      .suspect("each-with-itself", with(Pairs::with_itself))
      .suspect("kinds-kept-apart", with(Pairs::kinds_apart))
      .suspect("pairs-in-32-bits", with(Pairs::in_32_bits))
      .answer([&] { return exercise::all_pairs(kinds); })
      .equals(phases_with_mistakes::all_pairs(kinds));
}

void check_sweep(const Kinds& kinds, const World& world) {
  const auto with = [&](Sweep how) {
    return [&, how] { return phases_with_mistakes::sweep(kinds, world, how); };
  };
  const double right = phases_with_mistakes::sweep(kinds, world);
  ask("How many pairs is a sweep along x expected to compare?")
      .given("kinds", kinds)
      .given("world", world)
      .suspect("one-direction-alone", with(Sweep::one_direction))
      .suspect("touching-not-counted", with(Sweep::touching_apart))
      .suspect("world-without-ends", with(Sweep::without_ends))
      .suspect("mean-size-for-all", with(Sweep::mean_size))
      .suspect("kinds-kept-apart", with(Sweep::kinds_apart))
      .answer([&] { return exercise::sweep(kinds, world); })
      .close_to(right, within(kRelative * right));
}

void check_grid(const Kinds& kinds, const World& world, std::int64_t edge) {
  const auto with = [&](Cells cells) {
    return [&, cells] { return phases_with_mistakes::grid(kinds, world, edge, cells); };
  };
  const Grid right = phases_with_mistakes::grid(kinds, world, edge);
  ask("How many entries has a grid, and how many pairs does it compare?")
      .given("kinds", kinds)
      .given("world", world)
      .given("edge", edge)
      .suspect("grid-of-corners", with(Cells::of_corners))
      .suspect("cells-shared-on-one-axis", with(Cells::one_axis))
      .suspect("touching-for-a-shared-cell", with(Cells::touching))
      .suspect("cells-by-area", with(Cells::by_area))
      .suspect("kinds-kept-apart", with(Cells::kinds_apart))
      .answer([&] { return exercise::grid(kinds, world, edge); })
      .close_to(right, within(Grid{kRelative * right.entries, kRelative * right.compared}));
}

void check_choice(const Kinds& kinds, const World& world, std::int64_t edge) {
  const auto with = [&](Choice choice) {
    return [&, choice] { return phases_with_mistakes::choose(kinds, world, edge, choice); };
  };
  ask("Which method is expected to cost least?")
      .given("kinds", kinds)
      .given("world", world)
      .given("edge", edge)
      .suspect("sorting-for-nothing", with(Choice::no_sorting))
      .suspect("entries-for-nothing", with(Choice::no_entries))
      .suspect("last-of-equal-methods", with(Choice::last))
      .answer([&] { return exercise::choose(kinds, world, edge); })
      .equals(phases_with_mistakes::choose(kinds, world, edge));
}

}  // namespace

TEST_CASE("each pair is counted once") {
  check_pairs({{7, 3}});
  check_pairs({{4, 1}, {5, 2}});
  check_pairs({{100000, 1}});
  check_pairs({{1000000, 1}, {0, 5}, {1000000, 2}, {1, 9}});
  check_pairs({});
  check_pairs({{1, 4}});
}

TEST_CASE("a sweep compares the pairs that overlap along x") {
  check_sweep({{10, 3}}, {20, 50});
  check_sweep({{100, 0}}, {30, 10});
  check_sweep({{6, 19}}, {20, 5});
  check_sweep({{6, 20}}, {20, 5});
  check_sweep({{6, 5000}}, {20, 5});
  check_sweep({{6, 5}}, {1, 70});
  check_sweep({{1000000, 2}}, {100, 1});
}

TEST_CASE("squares of different sizes are compared too") {
  check_sweep({{10, 1}, {4, 16}}, {40, 50});
  check_sweep({{50, 2}, {1, 60}}, {60, 50});
  check_sweep({{3, 2}, {0, 7}, {5, 9}}, {30, 50});
}

TEST_CASE("a grid enters squares in cells and compares those that share one") {
  check_grid({{10, 3}}, {40, 60}, 4);
  check_grid({{12, 2}, {5, 9}}, {30, 20}, 5);
  check_grid({{100, 0}}, {30, 12}, 6);
  check_grid({{9, 4}}, {16, 8}, 4);
  check_grid({{9, 50}, {3, 1}}, {20, 10}, 10);
  check_grid({{5, 3}}, {10, 10}, 1);
}

TEST_CASE("the cheapest method is chosen, and the first of several") {
  check_choice({{3, 1}}, {100, 100}, 10);
  check_choice({{1, 1}}, {100, 100}, 10);
  check_choice({}, {100, 100}, 10);
  check_choice({{1000, 2}}, {120, 120}, 4);
  check_choice({{1000, 2}}, {120, 1}, 1);
  check_choice({{1000, 60}}, {120, 120}, 2);
  check_choice({{16, 2}}, {10, 10}, 10);
  check_choice({{9, 100}}, {100, 100}, 50);
  check_choice({{16, 0}}, {100, 100}, 20);
  check_choice({{17, 0}}, {100, 100}, 20);
}

TEST_CASE("random worlds agree with counting") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 40; ++asked) {
    const std::int64_t edge = random.integer(1, 8);
    const int columns = random.integer(1, 8), rows = random.integer(1, 8);
    const World world{edge * columns, edge * rows};
    Kinds kinds;
    const int count = random.integer(1, 3);
    for (int i = 0; i < count; ++i) {
      const int squares = random.integer(0, asked % 2 == 0 ? 30 : 3000);
      const std::int64_t size = random.integer(0, 19);
      kinds.push_back({squares, size});
    }
    check_pairs(kinds);
    check_sweep(kinds, world);
    check_grid(kinds, world, edge);
    if (phases_with_mistakes::is_clear(kinds, world, edge)) check_choice(kinds, world, edge);
  }
}
