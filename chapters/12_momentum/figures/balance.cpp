// Four bodies on a line that collide repeatedly: the drift of their total momentum in three
// programs.
#include <algorithm>
#include <contact/figure.hpp>
#include <contact/momentum_balance.hpp>
#include <cstdint>
#include <limits>

constexpr std::size_t count = 4;
constexpr std::size_t samples = 101;

struct Input {
  double v0, v1, v2, v3;  // initial, m/s
  double power;           // 10^power collisions in all; rounded down
  double wide;            // 1: in double precision; 0: in single
  double order;           // seed of the sequence of collisions
  double share;           // position of the reading, % of all collisions
};

struct Output {
  double problem;
  double collisions, read_at;                            // in all, and where they are read off
  std::array<double, count> mass;                        // kg, as stored
  double before, size;                                   // Σ m v and Σ m|v| at first, N·s
  std::array<double, samples> formulas, impulses, grid;  // drift of the total, in u Σ m|v|
  std::array<double, 3> read;                            // the same where it is read off
  std::array<double, 3> off;                             // and in N·s
  double most;                                           // the largest of the three curves
};

namespace {

using contact::MomentumUpdate;

constexpr double masses[count] = {1, 1.3, 1.9, 2.7};
constexpr double fastest = 100;  // m/s; then no momentum reaches 2^10 N·s

/// splitmix64: the same collisions wherever it runs.
std::uint64_t next(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

template <class S>
void run(const Input& in, Output& out) {
  const S unit = sizeof(S) == sizeof(float) ? S(0x1p-14) : S(0x1p-40);  // N·s
  const double u = double(std::numeric_limits<S>::epsilon()) / 2;
  const double velocity[count] = {in.v0, in.v1, in.v2, in.v3};
  std::vector<contact::MomentumBody<S>> first;
  for (std::size_t i = 0; i < count; ++i) {
    const S mass = S(masses[i]);
    first.push_back(contact::momentum_body(mass, S(velocity[i]) * mass, unit));
    out.mass[i] = double(mass);
    out.before += double(first[i].momentum);
    out.size += std::abs(double(first[i].momentum));
  }
  const auto all = static_cast<std::size_t>(out.collisions);
  const auto read_at = static_cast<std::size_t>(out.read_at);
  std::size_t way = 0;
  for (auto* curve : {&out.formulas, &out.impulses, &out.grid}) {
    const auto update = static_cast<MomentumUpdate>(way);
    auto bodies = first;
    const contact::Exact before = contact::stored_momentum(bodies, update);
    const auto drift = [&] {
      return rounded<double>(contact::stored_momentum(bodies, update) - before);
    };
    const auto in_units = [&](double off) { return out.size > 0 ? off / (u * out.size) : 0; };
    std::uint64_t state = 12 + static_cast<std::uint64_t>(in.order);
    std::size_t sample = 0;
    for (std::size_t c = 0;; ++c) {
      if (c * (samples - 1) == sample * all) {
        (*curve)[sample] = in_units(drift());
        out.most = std::max(out.most, std::abs((*curve)[sample++]));
      }
      if (c == read_at) {
        out.off[way] = drift();
        out.read[way] = in_units(out.off[way]);
      }
      if (c == all) break;
      const std::uint64_t bits = next(state);
      const std::size_t a = bits % count;
      const std::size_t b = (a + 1 + (bits >> 32) % (count - 1)) % count;
      contact::collide_with_update(bodies[a], bodies[b], update, unit);
    }
    ++way;
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const double v : {in.v0, in.v1, in.v2, in.v3}) {
    if (std::abs(v) > fastest) out.problem = contact::figure::too_large;
  }
  if (in.power > 5 || in.order > 1e6 || in.share > 100) out.problem = contact::figure::too_large;
  if (in.power < 2 || in.order < 0 || in.share < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  out.collisions = 1;
  for (int k = 0; k < static_cast<int>(in.power); ++k) out.collisions *= 10;
  out.read_at = std::round(in.share / 100 * out.collisions);
  if (in.wide > 0.5) {
    run<double>(in, out);
  } else {
    run<float>(in, out);
  }
  return out;
}

FIGURE(Input, FIELDS(v0, v1, v2, v3, power, wide, order, share), Output,
       FIELDS(problem, collisions, read_at, mass, before, size, formulas, impulses, grid, read, off,
              most))
