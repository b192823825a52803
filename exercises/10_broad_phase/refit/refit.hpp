/// @file
/// Exercise: the boxes of a tree after its leaves have moved, and whether the tree is still good.
///
/// Node 0 is the root. Each other node is a child of exactly one node, which may have a smaller or
/// a larger number: insertions and rotations have changed the tree. Coordinates are whole numbers
/// from -100000 to 100000, in m, and a tree has at most 1000 nodes.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A box: all points from low to high on both axes, ends included. It may have no width or height.
struct Box {
  Eigen::Vector2d low;
  Eigen::Vector2d high;  ///< no coordinate is less than in low
};

/// A node of a tree: an inner node with two children, or a leaf with a body.
struct Node {
  int left;   ///< number of a node; -1 for a leaf
  int right;  ///< number of another node; -1 for a leaf
  int body;   ///< index of a body, each in one leaf; -1 for an inner node
};

/// The boxes of all nodes after the bodies have moved: of a leaf that of its body, of an inner node
/// the smallest box that encloses those of its children. The nodes stay as they are.
///
/// @param nodes at least one
/// @param boxes of the nodes, before the bodies moved
/// @param bodies their boxes now
std::vector<Box> refit(const std::vector<Node>& nodes, const std::vector<Box>& boxes,
                       const std::vector<Box>& bodies);

/// How many inner nodes a search visits: the sum of width + height of the boxes of all inner nodes,
/// the root included, divided by width + height of the root's box.
///
/// A line meets boxes in proportion to their perimeters, so of the random lines that meet the
/// root's box one meets so many boxes of inner nodes on average. If the root's box is a point, 0. A
/// number may be off by a relative error of 1e-12.
///
/// @param boxes of the nodes
double cost(const std::vector<Node>& nodes, const std::vector<Box>& boxes);

/// Whether the tree should be built anew: its cost is more than twice what it was.
///
/// @param built boxes of the nodes when the tree was built
/// @param now boxes of the nodes now
bool needs_rebuild(const std::vector<Node>& nodes, const std::vector<Box>& built,
                   const std::vector<Box>& now);

}  // namespace exercise
