/// @file
/// Broad phases that keep something from step to step, and what they keep too long.
#pragma once

#include <algorithm>
#include <contact/moving_boxes.hpp>
#include <contact/sweep_and_prune.hpp>
#include <contact/sweep_pairs.hpp>
#include <contact/tree_pairs.hpp>
#include <cstdint>
#include <vector>

#include "hard_boxes.hpp"

namespace hard_steps {

using hard_boxes::Box;
using hard_boxes::Boxes;
using hard_boxes::Case;
using hard_boxes::Json;
using hard_boxes::Pairs;
using hard_boxes::V;

/// A sweep along x in a given order: each box is compared with the next ones until one starts
/// beyond its end.
inline Pairs sweep_in_order(const Boxes& boxes, const std::vector<std::uint32_t>& order) {
  Pairs pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (boxes[order[j]].low.x() > boxes[order[i]].high.x()) break;
      if (contact::boxes_touch(boxes[order[i]], boxes[order[j]]))
        pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

inline std::vector<std::uint32_t> order_of(const Boxes& boxes) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return boxes[i].low.x() < boxes[j].low.x();
  });
  return order;
}

/// One pass over the order of the last step that exchanges neighbours.
inline std::vector<std::uint32_t> exchanged_once(std::vector<std::uint32_t> order,
                                                 const Boxes& boxes) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (boxes[order[i]].low.x() < boxes[order[i - 1]].low.x()) std::swap(order[i], order[i - 1]);
  }
  return order;
}

/// Pairs of boxes that touched in the last step, and still do.
inline Pairs kept(const Boxes& before, const Boxes& after) {
  Pairs pairs = contact::all_pairs<double>(before).pairs;
  std::erase_if(pairs, [&](const contact::BoxPair& pair) {
    return !contact::boxes_touch(after[pair.a], after[pair.b]);
  });
  return pairs;
}

/// Pairs whose boxes of the last step, 0.1 m wider on all sides, touch, and that touch now.
inline Pairs fat_forever(const Boxes& before, const Boxes& after) {
  Boxes fat;
  for (const Box& box : before)
    fat.push_back({V(box.low - V::Constant(0.1)), V(box.high + V::Constant(0.1))});
  return kept(fat, after);
}

/// Pairs that are kept, and change only where a start and an end exchange their order on an axis.
/// Of equal ones, the end stands first, and they are not exchanged.
inline Pairs changed_by_exchanges(const Boxes& before, const Boxes& after) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    for (std::uint32_t j = i + 1; j < before.size(); ++j) {
      bool added = false, removed = false;
      const auto compare = [&](double end, double start, double new_end, double new_start) {
        const bool apart = end <= start;
        const bool now_apart = new_end == new_start ? apart : new_end < new_start;
        added = added || (apart && !now_apart);
        removed = removed || (!apart && now_apart);
      };
      for (int k = 0; k < 3; ++k) {
        compare(before[i].high(k), before[j].low(k), after[i].high(k), after[j].low(k));
        compare(before[j].high(k), before[i].low(k), after[j].high(k), after[i].low(k));
      }
      const bool touched = contact::boxes_touch(before[i], before[j]) && !removed;
      if (touched || (added && contact::boxes_touch(after[i], after[j]))) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// The pairs that touch after a step.
inline void ask_steps(hard_cases::Runner& runner) {
  runner.question("after a step", [](const Case& c) {
    return Json{{"class", "a"},
                {"pairs", hard_boxes::as_json(hard_boxes::pairs_by(
                              hard_boxes::stored_boxes(c, "after"), hard_boxes::touch_exactly))}};
  });
  const auto method = [&runner](const char* name, auto find) {
    runner.method("after a step", name, [find](const Case& c, const Json& answer) {
      return hard_boxes::as_json(find(hard_boxes::stored_boxes(c, "before"),
                                      hard_boxes::stored_boxes(c, "after"))) == answer.at("pairs");
    });
  };
  method("the pairs of the last step", [](const Boxes& before, const Boxes&) {
    return contact::all_pairs<double>(before).pairs;
  });
  method("those of the last step that still touch", kept);
  method("the order of the last step", [](const Boxes& before, const Boxes& after) {
    return sweep_in_order(after, order_of(before));
  });
  method("one pass of exchanges", [](const Boxes& before, const Boxes& after) {
    return sweep_in_order(after, exchanged_once(order_of(before), after));
  });
  method("0.1 m wider boxes, kept", fat_forever);
  method("book: incremental sweep", [](const Boxes& before, const Boxes& after) {
    contact::IncrementalSweep<double> sweep(0);
    sweep.update(before);
    return sweep.update(after).pairs;
  });
  method("pairs changed by exchanges, without equal ends", changed_by_exchanges);
  method("book: sweep and prune", [](const Boxes& before, const Boxes& after) {
    contact::SweepAndPrune<double> sweep;
    sweep.update(before);
    return sweep.update(after).pairs;
  });
  method("book: fat boxes", [](const Boxes& before, const Boxes& after) {
    contact::FatBoxPairs<double> fat(0.1);
    fat.update(before);
    return fat.update(after).pairs;
  });
  method("book: tree, refitted", [](const Boxes& before, const Boxes& after) {
    contact::BoxTree<double> tree(before);
    tree.refit(after);
    return tree.pairs().pairs;
  });
}

/// Bodies that translate at constant velocity: the pairs whose boxes over the step touch, on which
/// every broad phase depends that must not miss a contact in the step.
inline void ask_throughout(hard_cases::Runner& runner) {
  runner.question("boxes over a step", [](const Case& c) {
    const Boxes before = hard_boxes::stored_boxes(c, "before");
    const Boxes after = hard_boxes::stored_boxes(c, "after");
    Boxes both;
    for (std::size_t i = 0; i < before.size(); ++i) {
      both.push_back(
          {V(before[i].low.cwiseMin(after[i].low)), V(before[i].high.cwiseMax(after[i].high))});
    }
    return Json{
        {"class", "a"},
        {"pairs", hard_boxes::as_json(hard_boxes::pairs_by(both, hard_boxes::touch_exactly))}};
  });
  const auto method = [&runner](const char* name, auto find) {
    runner.method("boxes over a step", name, [find](const Case& c, const Json& answer) {
      return hard_boxes::as_json(find(hard_boxes::stored_boxes(c, "before"),
                                      hard_boxes::stored_boxes(c, "after"))) == answer.at("pairs");
    });
  };
  method("boxes at the start", [](const Boxes& before, const Boxes&) {
    return contact::all_pairs<double>(before).pairs;
  });
  method("boxes at the end",
         [](const Boxes&, const Boxes& after) { return contact::all_pairs<double>(after).pairs; });
  method("boxes half-way", [](const Boxes& before, const Boxes& after) {
    Boxes middle;
    for (std::size_t i = 0; i < before.size(); ++i) {
      middle.push_back(
          {V((before[i].low + after[i].low) / 2), V((before[i].high + after[i].high) / 2)});
    }
    return contact::all_pairs<double>(middle).pairs;
  });
  method("book", [](const Boxes& before, const Boxes& after) {
    return contact::all_pairs<double>(contact::boxes_over_step<double>(before, after)).pairs;
  });
}

}  // namespace hard_steps
