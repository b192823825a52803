#include "refit.hpp"

namespace exercise {
namespace {

double size(const Box& box) { return (box.high - box.low).sum(); }

}  // namespace

std::vector<Box> refit(const std::vector<Node>& nodes, const std::vector<Box>& boxes,
                       const std::vector<Box>& bodies) {
  //? Each node is listed after its parent, so in reverse each comes after its children.
  //? gap: order.push_back(child)
  std::vector<int> order{0};
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Node& node = nodes[static_cast<std::size_t>(order[k])];
    for (const int child : {node.left, node.right})
      if (child >= 0) order.push_back(child);
  }
  std::vector<Box> fitted = boxes;
  for (auto number = order.rbegin(); number != order.rend(); ++number) {
    //? A leaf has the box of its body, wherever the leaf is in the list.
    //? gap: bodies[static_cast<std::size_t>(node.body)]
    const Node& node = nodes[static_cast<std::size_t>(*number)];
    Box& box = fitted[static_cast<std::size_t>(*number)];
    if (node.body >= 0) {
      box = bodies[static_cast<std::size_t>(node.body)];
      continue;
    }
    //? The old box says nothing: it may be too large.
    //? gap: left.low.cwiseMin(right.low)
    //? gap: left.high.cwiseMax(right.high)
    const Box &left = fitted[static_cast<std::size_t>(node.left)],
              &right = fitted[static_cast<std::size_t>(node.right)];
    box = {left.low.cwiseMin(right.low), left.high.cwiseMax(right.high)};
  }
  return fitted;
}

double cost(const std::vector<Node>& nodes, const std::vector<Box>& boxes) {
  //? All lines that meet any box meet the root's. If this is a point, nothing is to be divided.
  //? gap: size(boxes[0])
  const double root = size(boxes[0]);
  if (root == 0) return 0;
  //? Leaves are not counted: they hold the bodies themselves.
  //? gap: nodes[i].body < 0
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].body < 0) sum += size(boxes[i]);
  return sum / root;
}

bool needs_rebuild(const std::vector<Node>& nodes, const std::vector<Box>& built,
                   const std::vector<Box>& now) {
  //? The cost does not change if everything grows alike.
  //? gap: cost(nodes, now) > 2 * cost(nodes, built)
  return cost(nodes, now) > 2 * cost(nodes, built);
}

}  // namespace exercise
