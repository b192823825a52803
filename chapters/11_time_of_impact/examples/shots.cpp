// 10,000 pairs of balls whose relative paths begin at random positions: how many of the touches do
// slices of the step find, how late, and what do bisection and the previous free state add?
#include <algorithm>
#include <contact/bisection.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/relative_motion.hpp>
#include <contact/shapes.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/tunnelling.hpp>
#include <cstdint>
#include <cstdio>

namespace {

using Vector = contact::Vector3<double>;

/// A linear congruential generator: the same numbers everywhere.
class Numbers {
 public:
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 1;
};

constexpr double radius_sum = 0.5, path = 6;

// [tell]
/// Shots of 6 m in the step at a ball: the centres touch at a distance of 0.5 m.
void tell(int slices) {
  Numbers numbers;
  int touches = 0, missed = 0;
  double latest = 0, deepest = 0, bisected = 0;
  for (int shot = 0; shot < 10000; ++shot) {
    const double x = numbers.between(-3.5, -2.5), y = numbers.between(-0.6, 0.6);
    const contact::MovingPoint<double> ball{{x, y, 0}, {path, 0, 0}}, target;
    const contact::Sphere<double> a{ball.start, radius_sum}, b{target.start, 0};
    const auto exact = contact::moving_spheres_impact<double>(a, ball.displacement, b, {0, 0, 0});
    if (!exact) continue;
    ++touches;
    const auto overlap = [&](double t) {
      const Vector at = ball.start + t * ball.displacement;
      return at.dot(at) <= radius_sum * radius_sum;
    };
    const auto found = contact::sliced_step(overlap, 1.0, slices);
    if (!found) {
      ++missed;
      deepest = std::max(deepest, radius_sum - contact::closest_approach(ball, target).distance);
      continue;
    }
    latest = std::max(latest, found->hit - *exact);
    bisected = std::max(bisected, contact::bisect_impact(overlap, *found, 10).hit - *exact);
  }
  const double bound = contact::missed_chord(radius_sum, path / slices).depth;
  std::printf("%6d %8d %7d %9.4f %9.4f", slices, touches, missed, deepest, bound);
  if (missed < touches) std::printf(" %9.4f %12.6f", latest, bisected);
  std::printf("\n");
}
// [/tell]

}  // namespace

int main() {
  std::printf("                       deepest   at most   at most        after\n");
  std::printf("slices  touches  missed  missed     proved      late  10 halvings\n");
  for (const int slices : {1, 3, 6, 10, 30, 100}) tell(slices);
}
