/// @file
/// Other programs' broad phases, each behind one class. Their headers stay in their own files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace peers {

/// A box along the axes.
struct Limits {
  std::array<double, 3> low{}, high{};
};
using Boxes = std::vector<Limits>;
/// The indices of two boxes, in either order.
using Pair = std::array<std::uint32_t, 2>;
using Pairs = std::vector<Pair>;

/// What a broad phase holds from step to step.
class Search {
 public:
  Search() = default;
  virtual ~Search() = default;
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
  /// Finds the pairs that touch. The first call receives the boxes; each later one the same number
  /// of boxes, which have moved.
  /// @param pairs receives them in any order; what it held is removed
  virtual void find(const Boxes& boxes, Pairs& pairs) = 0;
};

/// A broad phase that can be made as often as it is asked.
struct BroadPhase {
  std::string name;
  std::function<std::unique_ptr<Search>()> make;
  std::size_t max_boxes = SIZE_MAX;  ///< it takes too long for more
};

/// btDbvt with the leaves inserted one by one, btDbvtBroadphase with its cache of pairs, and
/// bt32BitAxisSweep3.
std::vector<BroadPhase> bullet_phases();
/// box_self_intersection_d.
std::vector<BroadPhase> cgal_phases();
/// The managers with a dynamic tree, with an array of its nodes, with sweep and prune, and with a
/// sorted list.
std::vector<BroadPhase> fcl_phases();
std::vector<BroadPhase> coal_phases();
/// The spaces: hash, quadtree, and sweep and prune.
std::vector<BroadPhase> ode_phases();
/// b3DynamicTree, in float, built at once.
std::vector<BroadPhase> box3d_phases();

/// A broad phase that is a class.
template <class Made, class... Arguments>
BroadPhase phase(std::string name, Arguments... arguments) {
  return {std::move(name), [=] { return std::make_unique<Made>(arguments...); }};
}

}  // namespace peers
