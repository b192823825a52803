// Boxes on contact springs: how far each contact sags under all the boxes above it, and what steps
// of semi-implicit and of implicit Euler make of the stack after gravity is switched on.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/spring_stack.hpp>
#include <cstddef>
#include <utility>
#include <vector>

constexpr std::size_t max_boxes = 10, samples = 301;
constexpr double mass = 10, side = 0.5, gravity = 9.81;  // kg, m, m/s²
constexpr double last_time = 3;                          // s

struct Input {
  double boxes;      // how many
  double stiffness;  // of each contact, N/m
  double step;       // s
  double scheme;     // 0 semi-implicit Euler, 1 implicit Euler
  double time;       // at which the stack is drawn, s
};

struct Output {
  double problem;
  double boxes, mass, side;
  std::array<double, max_boxes> sag, at_rest;    // of each contact and of each box at rest, m
  std::array<double, max_boxes> overlap, lower;  // the same at that time
  double top_sag;                                // of the highest box at rest, m
  std::array<double, samples> moment, top;       // how far the highest box has sunk, m
  double limit, limit_of_one;                    // of semi-implicit Euler: the stack's, one box's
  double slowest, fastest;                       // periods of the stack, s
  double energy;  // about the rest at that time, over that at the start
  // Goals of questions.
  double grows;       // steps of semi-implicit Euler that grow, though one box would be stable
  double early_rest;  // implicit Euler has lost 99.9 % of the energy by then
  double shallow;     // at least five boxes, and no contact sags by more than a hundredth of a box
};

namespace {

using Stack = contact::SpringStack<double>;
using State = contact::StackState<double>;

/// The energy of springs and motion about the stack at rest.
double energy_about_rest(const Stack& stack, const State& state, const State& rest) {
  State from_rest = state;
  for (std::size_t i = 0; i < stack.size(); ++i) from_rest.displacement[i] -= rest.displacement[i];
  return contact::stack_energy(stack, from_rest);
}

void run(const Stack& stack, const Input& in, const State& rest, Output& out) {
  const auto steps = static_cast<int>(std::round(last_time / in.step));
  const auto shown = static_cast<int>(std::round(std::clamp(in.time, 0.0, last_time) / in.step));
  const std::size_t highest = stack.size() - 1;
  State state = contact::unloaded(stack);
  const double start = energy_about_rest(stack, state, rest);
  std::size_t sample = 0;
  for (int i = 0;; ++i) {
    // Each sample is of the last step that has ended by then.
    for (; sample < samples && int(sample) * steps < (i + 1) * int(samples - 1); ++sample) {
      out.moment[sample] = i * in.step;
      out.top[sample] = state.displacement[highest];
    }
    if (i == shown) {
      for (std::size_t k = 0; k <= highest; ++k) {
        out.lower[k] = state.displacement[k];
        out.overlap[k] = state.displacement[k] - (k > 0 ? state.displacement[k - 1] : 0);
      }
      out.energy = energy_about_rest(stack, state, rest) / start;
    }
    if (i >= std::max(steps, shown)) return;
    // [steps]
    state = in.scheme == 1 ? contact::implicit_stack_step(stack, state, in.step, gravity)
                           : contact::semi_implicit_stack_step(stack, state, in.step, gravity);
    // [/steps]
    for (double& x : state.displacement) x = std::clamp(x, -1e9, 1e9);
  }
}

Stack equal_boxes(std::size_t n, double stiffness) {
  return contact::spring_stack(std::vector<double>(n, mass), std::vector<double>(n, stiffness));
}

double period(const Stack& stack, std::size_t j) {
  return 6.283185307179586 / std::sqrt(contact::frequency_bounds(stack, j).above);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.stiffness > 0) || !(in.step > 0)) out.problem = contact::figure::not_positive;
  if (in.stiffness > 1e9 || in.step > last_time) out.problem = contact::figure::too_large;
  if (out.problem == 0 && (in.stiffness < 1 || in.step < 1e-3)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;
  const auto n = static_cast<std::size_t>(std::clamp(std::round(in.boxes), 1.0, double(max_boxes)));
  out.boxes = double(n);
  out.mass = mass;
  out.side = side;
  const Stack stack = equal_boxes(n, in.stiffness);
  const std::vector<double> sag = contact::stack_sag(stack, gravity);
  const State rest = contact::stack_at_rest(stack, gravity);
  for (std::size_t i = 0; i < n; ++i) {
    out.sag[i] = sag[i];
    out.at_rest[i] = rest.displacement[i];
  }
  out.top_sag = rest.displacement.back();
  out.limit = contact::stack_step_limit(stack);
  out.limit_of_one = contact::stack_step_limit(equal_boxes(1, in.stiffness));
  out.slowest = period(stack, 0);
  out.fastest = period(stack, n - 1);
  run(stack, in, rest, out);
  const bool explicitly = in.scheme != 1;
  out.grows = explicitly && in.step > out.limit * 1.001 && in.step < out.limit_of_one ? 1 : 0;
  out.early_rest = !explicitly && out.energy <= 1e-3 ? 1 : 0;
  out.shallow = n >= 5 && sag[0] <= side / 100 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(boxes, stiffness, step, scheme, time), Output,
       FIELDS(problem, boxes, mass, side, sag, at_rest, overlap, lower, top_sag, moment, top, limit,
              limit_of_one, slowest, fastest, energy, grows, early_rest, shallow))
