// In which cells a box has points is decided by exact numbers, for the edge as it is stored.
#include "cell_rounding.hpp"
#include "cells_as_computed.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Pair;
using given::Cells;

// ---------------------------------------------------------------- exact numbers

/// Whether the box has a point in the cell.
bool has_a_point_in(double low, double high, double cell, double edge) {
  const Exact begin = Exact(cell) * Exact(edge), end = begin + Exact(edge);
  return (Exact(high) - begin).sign() >= 0 && (end - Exact(low)).sign() > 0;
}

// ---------------------------------------------------------------- what the contract allows

bool are_intervals(const Pair& pair, double limit) {
  return pair.low_a <= pair.high_a && pair.low_a >= -limit && pair.high_a <= limit &&
         pair.low_b <= pair.high_b && pair.low_b >= -limit && pair.high_b <= limit;
}
bool is_edge(double edge) { return edge >= 0.01 && edge <= 10; }
bool touch(const Pair& pair) { return pair.low_a <= pair.high_b && pair.low_b <= pair.high_a; }

// ---------------------------------------------------------------- what the given code computes

Cells truncated(const Pair& pair) {
  return given::cells_by_truncation(pair.low_a, pair.high_a, pair.edge);
}

bool is_power_of_two(double edge) {
  int exponent = 0;
  return std::frexp(edge, &exponent) == 0.5;
}

bool same(const Cells& x, const Cells& y) { return x.first == y.first && x.last == y.last; }

bool formulas_agree(const Pair& pair) {
  const auto agree = [&](double low, double high) {
    return same(given::cells_to_store(low, high, pair.edge),
                given::cells_to_search(low, high, pair.edge));
  };
  return agree(pair.low_a, pair.high_a) && agree(pair.low_b, pair.high_b);
}

/// Whether the box has a point in the cell that truncation gives for an end, or rounding down gives
/// this cell too: then a wrong cell is not the fault of truncation.
bool truncation_is_right(const Pair& pair, double cell, double rounded_down) {
  return cell == rounded_down || has_a_point_in(pair.low_a, pair.high_a, cell, pair.edge);
}

/// Whether the boxes have a key in common if the key of cell k is the product k * edge.
bool share_a_product(const Pair& pair) {
  const auto first_of = [&](double low) { return std::floor(low / pair.edge); };
  // The first cell of the box that begins last, if it is a cell of both.
  const double cell = std::max(first_of(pair.low_a), first_of(pair.low_b));
  return cell * pair.edge <= pair.high_a && cell * pair.edge <= pair.high_b;
}

bool begin_alike(const Pair& pair) {
  return std::floor(pair.low_a / pair.edge) == std::floor(pair.low_b / pair.edge);
}

std::string text(const Cells& cells) {
  return "cells " + contact::text_of(cells.first) + " to " + contact::text_of(cells.last);
}

std::string text(const std::vector<double>& keys) { return contact::text_of(keys); }

}  // namespace

TEST_CASE("a box is put in a cell in which it has no point") {
  break_it<Pair>("Which box is put in a cell in which it has no point?")
      .rule("every number is finite", [](const Pair& pair) { return all_finite(pair); })
      .rule("the edge is from 0.01 to 10", [](const Pair& pair) { return is_edge(pair.edge); })
      .rule("no low is above its high, and all are from -100 to 100",
            [](const Pair& pair) { return are_intervals(pair, 100); })
      .suspect_if("break-box-is-not-negative", [](const Pair& pair) { return pair.low_a >= 0; })
      .suspect_if("break-box-has-zero",
                  [](const Pair& pair) { return pair.low_a < 0 && pair.high_a >= 0; })
      .suspect_if("break-cells-agree-below-zero", [](const Pair& pair) { return pair.high_a < 0; })
      .input("pair", [] { return exercise::in_a_cell_without_a_point(); })
      .judge([](const Pair& pair) {
        const Cells cells = truncated(pair);
        const Cells down = given::cells_to_search(pair.low_a, pair.high_a, pair.edge);
        // Truncation is monotonic, so cells between those of the ends have points if these have.
        const bool wrong = !truncation_is_right(pair, cells.first, down.first) ||
                           !truncation_is_right(pair, cells.last, down.last);
        return Judged{wrong, text(cells), "only cells in which the box has a point",
                      wrong ? "In one of these cells the box has no point."
                            : "Each of these cells has a point of the box, or is one that rounding "
                              "down gives too."};
      });
}

TEST_CASE("boxes that touch are lost by the reciprocal") {
  break_it<Pair>("Which boxes have a common point, and a does not find b?")
      .rule("every number is finite", [](const Pair& pair) { return all_finite(pair); })
      .rule("the edge is from 0.01 to 10", [](const Pair& pair) { return is_edge(pair.edge); })
      .rule("no low is above its high, and all are from -100 to 100",
            [](const Pair& pair) { return are_intervals(pair, 100); })
      .rule("the boxes have a common point", touch)
      .suspect_if("break-reciprocal-is-exact",
                  [](const Pair& pair) { return is_power_of_two(pair.edge); })
      .suspect_if("break-quotients-agree", formulas_agree)
      .suspect_if("break-another-cell-is-shared", [](const Pair&) { return true; })
      .input("pair", [] { return exercise::lost_by_the_reciprocal(); })
      .judge([](const Pair& pair) {
        const bool found = given::is_found(pair);
        return Judged{!found, found ? "found" : "not found", "found",
                      "Box a looks in " +
                          text(given::cells_to_search(pair.low_a, pair.high_a, pair.edge)) +
                          ", and box b is stored in " +
                          text(given::cells_to_store(pair.low_b, pair.high_b, pair.edge)) + "."};
      });
}

TEST_CASE("boxes that touch are lost by keys that are added up") {
  break_it<Pair>("Which boxes have a common point, and no key in common?")
      .rule("every number is finite", [](const Pair& pair) { return all_finite(pair); })
      .rule("the edge is from 0.01 to 10", [](const Pair& pair) { return is_edge(pair.edge); })
      .rule("no low is above its high, and all are from -10 to 10",
            [](const Pair& pair) { return are_intervals(pair, 10); })
      .rule("the boxes have a common point", touch)
      .rule("the boxes have a common key if the key of each cell k is k * edge", share_a_product)
      .suspect_if("break-keys-begin-alike", begin_alike)
      .suspect_if("break-keys-are-exact",
                  [](const Pair& pair) { return is_power_of_two(pair.edge); })
      .suspect_if("break-sums-agree", [](const Pair&) { return true; })
      .input("pair", [] { return exercise::lost_by_added_keys(); })
      .judge([](const Pair& pair) {
        const bool share = given::share_a_key(pair);
        const std::vector<double> of_b = given::keys(pair.low_b, pair.high_b, pair.edge);
        return Judged{!share, share ? "a common key" : "no common key", "a common key",
                      "The keys of b are " + text(of_b) + "."};
      });
}
