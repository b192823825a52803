// What is right is computed from the definition of a cell. The first questions of a test each bring
// one mistake to light that no question before did, so that the mistake is known by it.
#include "cells_of_a_box.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <10_broad_phase/cells_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using cells_with_mistakes::Number;
using cells_with_mistakes::Range;
using cells_with_mistakes::Shared;
using exercise::Box;

constexpr std::int64_t kFar = 1000000000000000000;

void check_cell(std::int64_t x, std::int64_t edge) {
  const auto with = [&](Number number) {
    return [&, number] { return cells_with_mistakes::cell_with(number, x, edge); };
  };
  ask("Which cell has the coordinate?")
      .given("x", x)
      .given("edge", edge)
      .suspect("cell-truncated", with(Number::truncated))
      .suspect("cell-rounded", with(Number::rounded))
      .suspect("cell-mirrored", with(Number::mirrored))
      .suspect("every-negative-lowered", with(Number::lowered))
      .suspect("cell-in-double", with(Number::in_double))
      .answer([&] { return exercise::cell_of(x, edge); })
      .equals(cells_with_mistakes::cell_of(x, edge));
}

void check_cells(const Box& box, std::int64_t edge) {
  const auto with = [&](Range range) {
    return [&, range] { return cells_with_mistakes::cells_of(box, edge, range); };
  };
  ask("In which cells has the box a point?")
      .given("box", box)
      .given("edge", edge)
      .suspect("end-on-border-left-out", with(Range::open))
      .suspect("cell-after-the-last", with(Range::one_more))
      .suspect("lower-corner-alone", with(Range::lower_corner))
      .suspect("cell-of-the-centre", with(Range::centre))
      .suspect("cells-by-size", with(Range::by_size))
      .suspect("width-for-both-axes", with(Range::width_twice))
      .answer([&] { return exercise::cells_of(box, edge); })
      .equals(cells_with_mistakes::cells_of(box, edge));
}

void check_compared(const Box& a, const Box& b, std::int64_t edge) {
  const auto with = [&](Shared shared) {
    return [&, shared] { return cells_with_mistakes::compared_in(a, b, edge, shared); };
  };
  ask("In which cell are the boxes compared?")
      .given("a", a)
      .given("b", b)
      .given("edge", edge)
      .suspect("smaller-of-the-firsts", with(Shared::smaller_first))
      .suspect("last-common-cell", with(Shared::last))
      .suspect("cell-of-one-box", with(Shared::of_a))
      .suspect("cell-of-one-box", with(Shared::of_b))
      .suspect("one-common-axis", with(Shared::one_axis))
      .suspect("single-cell-not-shared", with(Shared::longer))
      .answer([&] { return exercise::compared_in(a, b, edge); })
      .equals(cells_with_mistakes::compared_in(a, b, edge));
}

bool is_edge(std::int64_t edge) { return edge >= 1 && edge <= kFar; }
bool is_box(const Box& box) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (box.low[axis] < -kFar || box.high[axis] > kFar || box.low[axis] > box.high[axis])
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a cell begins at its lower border and ends before the next") {
  check_cell(37, 10);
  check_cell(30, 10);
  check_cell(39, 10);
  check_cell(40, 10);
  check_cell(0, 10);
  check_cell(9, 10);
  check_cell(5, 1);
  check_cell(4, 9);
}

TEST_CASE("cells continue below zero") {
  check_cell(-27, 10);
  check_cell(-30, 10);
  check_cell(-10, 10);
  check_cell(-1, 10);
  check_cell(-31, 10);
  check_cell(-7, 1);
  check_cell(-1, kFar);
}

TEST_CASE("large whole numbers are divided without rounding") {
  check_cell(kFar - 1, 1);
  check_cell(-kFar, 3);
  check_cell(kFar, kFar);
  check_cell(kFar - 1, kFar);
  check_cell(-kFar, kFar);
  check_cell(1 - kFar, kFar);
  check_cell(999999999999999999, 1000000000);
}

TEST_CASE("a box is in each cell in which it has a point") {
  check_cells({{3, 14}, {27, 65}}, 10);
  check_cells({{8, 44}, {12, 51}}, 10);
  check_cells({{-38, -14}, {-12, 21}}, 10);
  check_cells({{2, 3}, {7, 8}}, 10);
  check_cells({{5, 33}, {5, 33}}, 10);
  check_cells({{1 - kFar, 2 - kFar}, {kFar - 1, kFar - 3}}, 1000);
}

TEST_CASE("a box that ends on a border has a point in the next cell") {
  check_cells({{5, 14}, {20, 33}}, 10);
  check_cells({{5, 14}, {12, 40}}, 10);
  check_cells({{-40, -35}, {-20, -30}}, 10);
  check_cells({{30, 20}, {30, 20}}, 10);
  check_cells({{-kFar, 1 - kFar}, {kFar, kFar - 1}}, 1);
  check_cells({{-10, -10}, {0, 0}}, 10);
}

TEST_CASE("a pair is compared in the first cell that both have") {
  check_compared({{3, 24}, {48, 68}}, {{22, 5}, {91, 47}}, 10);
  check_compared({{22, 5}, {91, 47}}, {{3, 24}, {48, 68}}, 10);
  check_compared({{-58, -37}, {4, 12}}, {{-22, -61}, {35, -15}}, 10);
  check_compared({{0, 0}, {10, 10}}, {{10, 10}, {20, 20}}, 10);
  check_compared({{2, 3}, {4, 5}}, {{6, 7}, {8, 9}}, 10);
  check_compared({{0, 0}, {99, 99}}, {{40, 50}, {45, 55}}, 10);
}

TEST_CASE("boxes that share no cell are not compared") {
  check_compared({{13, 24}, {28, 38}}, {{22, 25}, {41, 37}}, 10);
  check_compared({{3, 24}, {18, 38}}, {{22, 25}, {41, 37}}, 10);
  check_compared({{24, 3}, {38, 18}}, {{25, 22}, {37, 41}}, 10);
  check_compared({{0, 0}, {9, 9}}, {{10, 10}, {20, 20}}, 10);
  check_compared({{-5, -5}, {-1, -1}}, {{0, 0}, {5, 5}}, 10);
  check_compared({{5, 5}, {9, 9}}, {{-9, -9}, {-5, -5}}, 10);
}

TEST_CASE("random boxes agree with the definition of a cell") {
  generators::Random random(seed(0));
  const auto judged_cell = [](std::int64_t x, std::int64_t edge) {
    return is_edge(edge) && x >= -kFar && x <= kFar;
  };
  const auto judged_cells = [](const Box& box, std::int64_t edge) {
    return is_edge(edge) && is_box(box);
  };
  const auto judged_pair = [](const Box& a, const Box& b, std::int64_t edge) {
    return is_edge(edge) && is_box(a) && is_box(b);
  };
  for (int asked = 0; asked < 300; ++asked) {
    const std::int64_t scale = asked % 4 == 0 ? 20000000000000000 : 1;
    // Both boxes are moved by as much. Otherwise two runs would often ask for the same small
    // numbers.
    const std::int64_t moved = scale == 1 ? random.integer(-3000, 1000) : 0;
    const auto number = [&](int low, int high) {
      const std::int64_t steps = random.integer(low, high);
      const std::int64_t rest = random.integer(-1, 1);
      return scale * steps + rest + moved;
    };
    const auto box = [&] {
      const std::int64_t left = number(-40, 20), below = number(-40, 20);
      const std::int64_t width = random.integer(0, 25), height = random.integer(0, 25);
      return Box{{left, below}, {left + scale * width, below + scale * height}};
    };
    const std::int64_t edge = scale * random.integer(1, 9);
    const Box a = box(), b = box();
    shrinkable(check_cell, judged_cell, a.low[0], edge);
    shrinkable(check_cells, judged_cells, a, edge);
    shrinkable(check_compared, judged_pair, a, b, edge);
  }
}
