// Sixteen bodies on a line collide ten million times, two at a time. Their momentum should not
// change at all; how far does it drift?
#include <array>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/impulse.hpp>
#include <cstdint>
#include <cstdio>

constexpr std::size_t bodies = 16;

/// splitmix64, so that every machine runs the same collisions.
std::uint64_t next(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

enum class Way {
  formulas,  ///< each new velocity from its own formula
  impulses,  ///< one impulse, given to one body and taken from the other
  grid       ///< the same with momenta and impulses that are whole multiples of 2^-k
};

template <class S>
struct Bodies {
  std::array<S, bodies> mass, velocity, momentum;
};

/// A multiple of 2^-k for which sums of momenta are exact.
template <class S>
S on_grid(S x) {
  const S step = sizeof(S) == sizeof(float) ? S(0x1p-14) : S(0x1p-40);
  return std::nearbyint(x / step) * step;
}

// [collide]
template <class S>
void collide(Bodies<S>& all, std::size_t a, std::size_t b, Way way) {
  const S ma = all.mass[a];
  const S mb = all.mass[b];
  S& va = all.velocity[a];
  S& vb = all.velocity[b];
  if (way == Way::formulas) {  // an elastic collision: each velocity by itself
    const S before_a = va;
    va = ((ma - mb) * va + S(2) * mb * vb) / (ma + mb);
    vb = ((mb - ma) * vb + S(2) * ma * before_a) / (ma + mb);
    return;
  }
  S impulse = S(2) * (va - vb) * (ma * mb / (ma + mb));
  if (way == Way::impulses) {
    va = contact::velocity_after(ma, va, S(-impulse));
    vb = contact::velocity_after(mb, vb, impulse);
    return;
  }
  impulse = on_grid(impulse);
  all.momentum[a] -= impulse;  // exact, and so is the next
  all.momentum[b] += impulse;
  va = all.momentum[a] / ma;
  vb = all.momentum[b] / mb;
}
// [/collide]

/// |total − total before| over Σ m|v|, without rounding until the quotient.
template <class S>
double drift(Way way, int collisions) {
  Bodies<S> all{};
  std::uint64_t state = 12;
  for (std::size_t i = 0; i < bodies; ++i) {
    all.mass[i] = S(1) + S(next(state) >> 60) / S(4);
    all.momentum[i] = on_grid(S(int(next(state) >> 56) - 128) / S(16));
    all.velocity[i] = all.momentum[i] / all.mass[i];
  }
  const auto total = [&] {
    contact::Exact sum;
    for (std::size_t i = 0; i < bodies; ++i) {
      sum += way == Way::grid
                 ? contact::Exact(double(all.momentum[i]))
                 : contact::Exact(double(all.mass[i])) * contact::Exact(double(all.velocity[i]));
    }
    return sum;
  };
  const auto before = total();
  double size = 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    size += double(all.mass[i]) * std::abs(double(all.velocity[i]));
  }
  for (int c = 0; c < collisions; ++c) {
    const std::uint64_t bits = next(state);
    const std::size_t a = bits % bodies;
    const std::size_t b = (a + 1 + (bits >> 32) % (bodies - 1)) % bodies;
    collide(all, a, b, way);
  }
  return std::abs(rounded<double>(total() - before)) / size;
}

int main() {
  std::printf("drift of the total momentum over sum of m|v|\n");
  std::printf("collisions  type    formulas  impulses  on a grid\n");
  for (const int collisions : {10000, 1000000, 10000000}) {
    std::printf("%-11d float   %.0e     %.0e     %g\n", collisions,
                drift<float>(Way::formulas, collisions), drift<float>(Way::impulses, collisions),
                drift<float>(Way::grid, collisions));
    std::printf("%-11s double  %.0e     %.0e     %g\n", "",
                drift<double>(Way::formulas, collisions), drift<double>(Way::impulses, collisions),
                drift<double>(Way::grid, collisions));
  }
}
