// 1,000 boxes of 1 m move in random directions: what a step costs with an order, with pairs, and
// with fat boxes kept from the step before.
#include <contact/aabb.hpp>
#include <contact/moving_boxes.hpp>
#include <contact/sweep_and_prune.hpp>
#include <contact/sweep_pairs.hpp>
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
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  Vector in_cube(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return {x, y, z};
  }

 private:
  std::uint64_t state_ = 1;
};

// [tell]
/// Ten steps, in each of which no coordinate changes by more than `step`, m.
void tell(double step) {
  Numbers numbers;
  Boxes boxes;
  std::vector<Vector> moves;
  for (int i = 0; i < 1000; ++i) {
    const Vector low = numbers.in_cube(0, 40);
    boxes.push_back({low, low + Vector::Ones()});
    moves.push_back(numbers.in_cube(-step, step));
  }
  contact::IncrementalSweep<double> sweep(0);
  contact::SweepAndPrune<double> prune;
  contact::FatBoxPairs<double> fat(0.1);
  std::uint64_t moved = 0, swept = 0, pruned = 0, exchanged = 0, compared = 0, renewed = 0;
  constexpr int steps = 10;
  for (int k = 0; k <= steps; ++k) {
    const std::span<const contact::Aabb<double>> now(boxes);
    const contact::PairSearch one = sweep.update(now), two = prune.update(now),
                              three = fat.update(now);
    if (k > 0) {
      swept += one.box_tests, moved += one.other_steps;
      pruned += two.box_tests, exchanged += two.other_steps;
      compared += three.box_tests, renewed += fat.renewed();
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      boxes[i].low += moves[i];
      boxes[i].high += moves[i];
    }
  }
  const auto mean = [](std::uint64_t sum) { return static_cast<double>(sum) / steps; };
  std::printf("%5g m%10.0f%10.0f%10.0f%10.0f%10.0f%10.0f%s\n", step, mean(swept), mean(moved),
              mean(pruned), mean(exchanged), mean(compared), mean(renewed),
              prune.resorted() ? "  sorted anew" : "");
}
// [/tell]

}  // namespace

int main() {
  std::printf("%7s%20s%20s%20s\n", "", "order kept", "pairs kept", "fat boxes kept");
  std::printf("%7s%10s%10s%10s%10s%10s%10s\n", "a step", "tests", "moves", "tests", "moves",
              "tests", "renewed");
  for (const double step : {0.0, 0.001, 0.01, 0.1, 1.0}) tell(step);
}
