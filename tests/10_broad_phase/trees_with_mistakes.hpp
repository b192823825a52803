/// @file
/// Boxes of a tree and its cost, from the bodies below each node or with one mistake that people
/// make: what the test of the exercise compares with and recognises.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "refit.hpp"

namespace trees_with_mistakes {

using exercise::Box;
using exercise::Node;
using Nodes = std::vector<Node>;
using Boxes = std::vector<Box>;

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

inline Box enclosing(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

// ---------------------------------------------------------------- boxes

/// The box around all bodies below a node.
inline Box around(const Nodes& nodes, int number, const Boxes& bodies) {
  const Node& node = nodes[at(number)];
  if (node.body >= 0) return bodies[at(node.body)];
  return enclosing(around(nodes, node.left, bodies), around(nodes, node.right, bodies));
}

/// How the boxes are computed.
enum class Fit {
  rightly,
  leaves_alone,
  parents_first,
  later_first,
  grown,
  overall,
  origin,
  counted
};

inline Boxes refit(const Nodes& nodes, const Boxes& boxes, const Boxes& bodies,
                   Fit fit = Fit::rightly) {
  Boxes fitted = boxes;
  const int n = static_cast<int>(nodes.size());
  int leaf = 0;
  for (int i = 0; i < n; ++i) {
    const int body = nodes[at(i)].body;
    if (body >= 0) fitted[at(i)] = bodies[at(fit == Fit::counted ? leaf++ : body)];
  }
  if (fit == Fit::leaves_alone) return fitted;
  const auto combine = [&](int i) {
    const Node& node = nodes[at(i)];
    if (node.body < 0) fitted[at(i)] = enclosing(fitted[at(node.left)], fitted[at(node.right)]);
  };
  if (fit == Fit::parents_first || fit == Fit::later_first) {
    for (int i = 0; i < n; ++i) combine(fit == Fit::parents_first ? i : n - 1 - i);
    return fitted;
  }
  // As often as the tree may be deep.
  for (int round = 0; round < n; ++round)
    for (int i = 0; i < n; ++i) combine(i);
  const Box all = fitted[0];
  for (int i = 0; i < n; ++i) {
    Box& box = fitted[at(i)];
    if (nodes[at(i)].body >= 0) continue;
    if (fit == Fit::grown) box = enclosing(box, boxes[at(i)]);
    if (fit == Fit::overall) box = all;
    if (fit == Fit::origin) box = enclosing(box, {{0, 0}, {0, 0}});
    if (fit == Fit::rightly) box = around(nodes, i, bodies);
  }
  return fitted;
}

// ---------------------------------------------------------------- cost

/// What is summed, and by what it is divided.
enum class Sum { rightly, with_leaves, areas, undivided, without_root, point_divided };

inline double size(const Box& box, Sum sum) {
  const Eigen::Vector2d extent = box.high - box.low;
  return sum == Sum::areas ? extent.x() * extent.y() : extent.x() + extent.y();
}

inline double cost(const Nodes& nodes, const Boxes& boxes, Sum sum = Sum::rightly) {
  const double root = size(boxes[0], sum);
  if (root == 0 && sum != Sum::point_divided) return 0;
  double total = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].body >= 0 && sum != Sum::with_leaves) continue;
    if (i == 0 && sum == Sum::without_root) continue;
    total += size(boxes[i], sum);
  }
  return sum == Sum::undivided ? total : total / root;
}

// ---------------------------------------------------------------- rebuild

/// What is compared.
enum class Decide { rightly, root_alone, undivided, at_twice };

inline bool needs_rebuild(const Nodes& nodes, const Boxes& built, const Boxes& now,
                          Decide decide = Decide::rightly) {
  if (decide == Decide::root_alone)
    return size(now[0], Sum::rightly) > 2 * size(built[0], Sum::rightly);
  const Sum sum = decide == Decide::undivided ? Sum::undivided : Sum::rightly;
  const double before = 2 * trees_with_mistakes::cost(nodes, built, sum),
               after = trees_with_mistakes::cost(nodes, now, sum);
  return decide == Decide::at_twice ? after >= before : after > before;
}

}  // namespace trees_with_mistakes
