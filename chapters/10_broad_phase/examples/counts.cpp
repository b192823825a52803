// How many boxes each broad phase compares in seven scenes, and what else it does; and which one is
// predicted to be the cheapest.
#include <array>
#include <contact/aabb.hpp>
#include <contact/broad_phase_cost.hpp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

namespace {

using Vector = contact::Vector3<double>;
using Boxes = std::vector<contact::Aabb<double>>;

/// A linear congruential generator: the same numbers everywhere.
class Numbers {
 public:
  /// From low on, less than high.
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 1;
};

void add(Boxes& boxes, Numbers& numbers, std::size_t count, const Vector& space, double edge) {
  for (std::size_t i = 0; i < count; ++i) {
    Vector low = Vector::Zero();
    for (int axis = 0; axis < 3; ++axis) low[axis] = numbers.between(0, space[axis]);
    boxes.push_back({low, low + Vector::Constant(edge)});
  }
}

Boxes scene(std::size_t count, const Vector& space, double edge) {
  Boxes boxes;
  Numbers numbers;
  add(boxes, numbers, count, space, edge);
  return boxes;
}

void tell(const char* name, const Boxes& boxes) {
  const std::span<const contact::Aabb<double>> all(boxes);
  const contact::PairSearch grid = contact::grid_pairs(all), tree = contact::tree_pairs(all);
  constexpr std::array names{"all pairs", "sweep", "grid", "tree"};
  const auto cheapest = static_cast<std::size_t>(contact::broad_phase_cost(all).cheapest());
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%-22s%8llu%8llu%8llu%8llu%8llu%8llu%8llu  %s\n", name, number(grid.pairs.size()),
              number(contact::all_pairs(all).box_tests),
              number(contact::sweep_pairs(all).box_tests), number(grid.box_tests),
              number(grid.other_steps), number(tree.box_tests), number(tree.other_steps),
              names.at(cheapest));
}

}  // namespace

int main() {
  std::printf("%54s%16s\n", "grid", "tree");
  std::printf("%-22s%8s%8s%8s%8s%8s%8s%8s  %s\n", "1,000 boxes of 1 m", "touch", "pairs", "sweep",
              "tests", "steps", "tests", "nodes", "predicted");
  tell("in a cube of 12 m", scene(1000, {12, 12, 12}, 1));
  tell("in a cube of 40 m", scene(1000, {40, 40, 40}, 1));
  tell("on a floor of 60 m", scene(1000, {60, 60, 0.1}, 1));
  tell("in a row of 1,000 m", scene(1000, {1000, 0.1, 0.1}, 1));
  Boxes mixed = scene(990, {40, 40, 40}, 1);
  Numbers numbers;
  add(mixed, numbers, 10, {30, 30, 30}, 10);
  tell("ten of them 10 m wide", mixed);
  Boxes huge = scene(999, {40, 40, 40}, 1);
  huge.push_back({Vector::Constant(-1e4), Vector::Constant(1e4)});
  tell("one 20 km wide", huge);
  tell("only 20 boxes", scene(20, {6, 6, 6}, 1));
}
