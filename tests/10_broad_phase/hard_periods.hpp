/// @file
/// Cells and pairs in a periodic space, as they are often written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/periodic_grid.hpp>
#include <cstdint>
#include <set>
#include <vector>

#include "hard_boxes.hpp"

namespace hard_periods {

using hard_boxes::Box;
using hard_boxes::Boxes;
using hard_boxes::Case;
using hard_boxes::Json;
using hard_boxes::Pairs;
using hard_boxes::Rational;
using hard_boxes::V;

/// The largest whole number that is at most x.
inline Rational floor(const Rational& x) {
  using boost::multiprecision::denominator;
  using boost::multiprecision::numerator;
  auto quotient = numerator(x) / denominator(x);  // towards 0
  if (Rational(quotient) > x) quotient -= 1;
  return Rational(quotient);
}

/// Whether a and b + k·period touch on an axis for a whole number k.
inline bool touch_on_axis(const Box& a, const Box& b, int axis, double period) {
  const Rational p = oracle::exact(period);
  const Rational least = (oracle::exact(a.low(axis)) - oracle::exact(b.high(axis))) / p;
  const Rational most = (oracle::exact(a.high(axis)) - oracle::exact(b.low(axis))) / p;
  return floor(most) >= least;
}
inline bool touch_exactly(const Box& a, const Box& b, const V& period) {
  for (int k = 0; k < 3; ++k) {
    if (!touch_on_axis(a, b, k, period(k))) return false;
  }
  return true;
}

/// The minimum image: the middles' difference is reduced to at most half a period, rounded.
inline bool touch_by_minimum_image(const Box& a, const Box& b, const V& period) {
  for (int k = 0; k < 3; ++k) {
    double d = (a.low(k) + a.high(k)) / 2 - (b.low(k) + b.high(k)) / 2;
    d -= period(k) * std::round(d / period(k));
    if (!(std::abs(d) <= (a.high(k) - a.low(k)) / 2 + (b.high(k) - b.low(k)) / 2)) return false;
  }
  return true;
}

/// The box itself and its images one period away on each axis, in double.
inline bool touch_with_images(const Box& a, const Box& b, const V& period, int from) {
  for (int k = 0; k < 3; ++k) {
    bool touch = false;
    for (int image = from; image <= 1; ++image) {
      const double shift = image * period(k);
      if (a.low(k) <= b.high(k) + shift && b.low(k) + shift <= a.high(k)) touch = true;
    }
    if (!touch) return false;
  }
  return true;
}

/// The cell of x: floor(x · cells / period) modulo cells, by fractions.
inline std::uint32_t cell_exactly(double x, double period, std::uint32_t cells) {
  const Rational index = floor(oracle::exact(x) * cells / oracle::exact(period));
  const Rational rest = index - floor(index / cells) * cells;
  return static_cast<std::uint32_t>(oracle::nearest(rest));
}

using Cell = std::array<std::uint32_t, 3>;
inline std::array<std::uint32_t, 3> three(const Case& c, const char* field) {
  const V v = c.vector(field);
  return {static_cast<std::uint32_t>(v.x()), static_cast<std::uint32_t>(v.y()),
          static_cast<std::uint32_t>(v.z())};
}

/// How many different cells are at most one step away on each axis, by listing all 27.
inline std::size_t neighbours_by_listing(const Cell& cell, const Cell& cells) {
  std::set<std::array<std::int64_t, 3>> all;
  for (int i = 0; i < 27; ++i) {
    const std::array<std::int64_t, 3> step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    std::array<std::int64_t, 3> other{};
    for (std::size_t k = 0; k < 3; ++k)
      other[k] = (std::int64_t{cell[k]} + step[k] + cells[k]) % std::int64_t{cells[k]};
    all.insert(other);
  }
  return all.size();
}
/// The product of what `along` counts on each axis.
template <class Along>
std::size_t product(const Cell& cell, const Cell& cells, Along along) {
  std::size_t all = 1;
  for (std::size_t k = 0; k < 3; ++k) all *= along(cell[k], cells[k]);
  return all;
}

inline void ask_pairs(hard_cases::Runner& runner) {
  runner.question("periodic pairs", [](const Case& c) {
    const V period = c.vector("period");
    return Json{{"class", "a"},
                {"pairs", hard_boxes::as_json(hard_boxes::pairs_by(
                              hard_boxes::stored_boxes(c), [&](const Box& a, const Box& b) {
                                return touch_exactly(a, b, period);
                              }))}};
  });
  const auto method = [&runner](const char* name, auto find) {
    runner.method("periodic pairs", name, [find](const Case& c, const Json& answer) {
      return hard_boxes::as_json(find(hard_boxes::stored_boxes(c), c.vector("period"))) ==
             answer.at("pairs");
    });
  };
  const auto by = [](auto touch) {
    return [touch](const Boxes& boxes, const V& period) {
      return hard_boxes::pairs_by(boxes,
                                  [&](const Box& a, const Box& b) { return touch(a, b, period); });
    };
  };
  method("no images",
         by([](const Box& a, const Box& b, const V&) { return contact::boxes_touch(a, b); }));
  method("images beyond the upper border only",
         by([](const Box& a, const Box& b, const V& p) { return touch_with_images(a, b, p, 0); }));
  method("images one period away",
         by([](const Box& a, const Box& b, const V& p) { return touch_with_images(a, b, p, -1); }));
  method("minimum image of the middles", by(touch_by_minimum_image));
  method("27 neighbours of two cells each", [](const Boxes& boxes, const V& period) {
    // With two cells along an axis, the neighbours on both sides are one cell: found twice.
    Pairs pairs;
    for (const auto& pair : contact::periodic_all_pairs<double>(boxes, period).pairs) {
      bool twice = false;
      for (int k = 0; k < 3; ++k) {
        twice = twice || contact::periodic_cell(boxes[pair.a].low(k), period(k), 2U) !=
                             contact::periodic_cell(boxes[pair.b].low(k), period(k), 2U);
      }
      for (int i = twice ? 0 : 1; i < 2; ++i) pairs.push_back(pair);
    }
    return pairs;
  });
  method("book: all pairs", [](const Boxes& boxes, const V& period) {
    return contact::periodic_all_pairs<double>(boxes, period).pairs;
  });
  for (const auto& [name, cells] : {std::pair{"book: 4 × 3 × 2 cells", Cell{4, 3, 2}},
                                    std::pair{"book: 1 × 2 × 64 cells", Cell{1, 2, 64}}}) {
    method(name, [cells = cells](const Boxes& boxes, const V& period) {
      return contact::periodic_grid_pairs<double>(boxes, {period, cells}).pairs;
    });
  }
}

inline void ask_cells(hard_cases::Runner& runner) {
  runner.question("cell", [](const Case& c) {
    const auto cells = static_cast<std::uint32_t>(c.number("cells"));
    return Json{{"class", "a"}, {"cell", cell_exactly(c.number("x"), c.number("period"), cells)}};
  });
  const auto method = [&runner](const char* name, auto cell_of) {
    runner.method("cell", name, [cell_of](const Case& c, const Json& answer) {
      return cell_of(c.number("x"), c.number("period"), c.number("cells")) ==
             answer.at("cell").get<double>();
    });
  };
  method("converted to int, % cells", [](double x, double period, double cells) {
    const auto index = hard_boxes::to_int32(x / (period / cells));
    return static_cast<double>(index % static_cast<std::int64_t>(cells));
  });
  method("floor, % cells", [](double x, double period, double cells) {
    const auto index = hard_boxes::to_int32(std::floor(x / (period / cells)));
    return static_cast<double>(index % static_cast<std::int64_t>(cells));
  });
  method("x − period · floor(x / period)", [](double x, double period, double cells) {
    const double rest = x - period * std::floor(x / period);
    return std::floor(rest * cells / period);
  });
  method("times a rounded 1/edge", [](double x, double period, double cells) {
    const double scale = 1 / (period / cells);
    const double index = std::floor(x * scale);
    return index - cells * std::floor(index / cells);
  });
  method("kept from 0 to the last cell", [](double x, double period, double cells) {
    return std::clamp(std::floor(x * cells / period), 0.0, cells - 1);
  });
  method("in float", [](double x, double period, double cells) {
    const auto p = static_cast<float>(period), n = static_cast<float>(cells);
    const float index = std::floor(static_cast<float>(x) / p * n);
    return static_cast<double>(index - n * std::floor(index / n));
  });
  method("1e-9 added", [](double x, double period, double cells) {
    const double index = std::floor(x / period * cells + 1e-9);
    return index - cells * std::floor(index / cells);
  });
  method("book", [](double x, double period, double cells) {
    return static_cast<double>(
        contact::periodic_cell(x, period, static_cast<std::uint32_t>(cells)));
  });
}

inline void ask_neighbours(hard_cases::Runner& runner) {
  runner.question("neighbours", [](const Case& c) {
    return Json{{"class", "a"},
                {"cells", neighbours_by_listing(three(c, "cell"), three(c, "cells"))}};
  });
  const auto method = [&runner](const char* name, auto count) {
    runner.method("neighbours", name, [count](const Case& c, const Json& answer) {
      return count(three(c, "cell"), three(c, "cells")) == answer.at("cells").get<std::size_t>();
    });
  };
  method("always 27", [](const Cell&, const Cell&) { return std::size_t{27}; });
  method("cut off at the border", [](const Cell& cell, const Cell& cells) {
    return product(cell, cells, [](std::uint32_t i, std::uint32_t n) {
      return std::size_t{1} + (i > 0 ? 1 : 0) + (i + 1 < n ? 1 : 0);
    });
  });
  method("wrapped at the upper border only", [](const Cell& cell, const Cell& cells) {
    return product(cell, cells, [](std::uint32_t i, std::uint32_t n) {
      return std::size_t{1} + (i > 0 ? 1 : 0) + (n > 1 ? 1 : 0);
    });
  });
  method("3 on each axis, at most as many as cells", [](const Cell& cell, const Cell& cells) {
    const std::size_t all = std::size_t{cells[0]} * cells[1] * cells[2];
    return std::min(
        product(cell, cells, [](std::uint32_t, std::uint32_t) { return std::size_t{3}; }), all);
  });
  method("book", [](const Cell& cell, const Cell& cells) {
    return contact::periodic_neighbours<double>(cell, {V::Ones(), cells}).size();
  });
}

}  // namespace hard_periods
