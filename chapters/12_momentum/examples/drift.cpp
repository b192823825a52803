// Sixteen bodies on a line collide ten million times, two at a time: the drift of their total
// momentum.
#include <cmath>
#include <contact/momentum_balance.hpp>
#include <cstdint>
#include <cstdio>
#include <vector>

using contact::MomentumUpdate;

constexpr std::size_t count = 16;

/// splitmix64, so that every machine runs the same collisions.
std::uint64_t next(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// |total − total before| over Σ m|v|, exact except for the quotient.
template <class S>
double drift(MomentumUpdate update, int collisions) {
  const S unit = sizeof(S) == sizeof(float) ? S(0x1p-14) : S(0x1p-40);  // N·s
  std::vector<contact::MomentumBody<S>> bodies;
  double size = 0;
  std::uint64_t state = 12;
  for (std::size_t i = 0; i < count; ++i) {
    const S mass = S(1) + S(next(state) >> 60) / S(4);
    const S momentum = S(int(next(state) >> 56) - 128) / S(16);
    bodies.push_back(contact::momentum_body(mass, momentum, unit));
    size += double(mass) * std::abs(double(bodies.back().velocity));
  }
  const auto before = contact::stored_momentum(bodies, update);
  for (int c = 0; c < collisions; ++c) {
    const std::uint64_t bits = next(state);
    const std::size_t a = bits % count;
    const std::size_t b = (a + 1 + (bits >> 32) % (count - 1)) % count;
    contact::collide_with_update(bodies[a], bodies[b], update, unit);
  }
  return std::abs(rounded<double>(contact::stored_momentum(bodies, update) - before)) / size;
}

int main() {
  std::printf("drift of the total momentum over sum of m|v|\n");
  std::printf("collisions  type    formulas  impulses  on a grid\n");
  for (const int collisions : {10000, 1000000, 10000000}) {
    std::printf("%-11d float   %.0e     %.0e     %g\n", collisions,
                drift<float>(MomentumUpdate::formulas, collisions),
                drift<float>(MomentumUpdate::impulses, collisions),
                drift<float>(MomentumUpdate::grid, collisions));
    std::printf("%-11s double  %.0e     %.0e     %g\n", "",
                drift<double>(MomentumUpdate::formulas, collisions),
                drift<double>(MomentumUpdate::impulses, collisions),
                drift<double>(MomentumUpdate::grid, collisions));
  }
}
