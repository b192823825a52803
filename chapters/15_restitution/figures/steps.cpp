// A bouncing ball in fixed time steps, beside the exact solution: the effect of each rule for a
// step with an impact on the heights.
#include <algorithm>
#include <contact/figure.hpp>
#include <contact/fixed_step_bounce.hpp>

struct Input {
  double height;  // of the drop, m
  double step;    // s
  double k;
  double rule;  // 0 to 4, as StepRule
};

constexpr int points = 241;
constexpr int stepped_points = 401;
constexpr double seconds = 6;
constexpr double gravity = 9.81;

struct Output {
  double problem;
  std::array<double, points> moment, truth;  // s, m
  std::array<double, stepped_points> stepped_time, stepped;
  double steps;                      // in all
  double true_bounces, bounces;      // in 6 s
  double true_height, last_height;   // after 6 s, m
  double highest;                    // after the first impact, m
  double last_peak, true_last_peak;  // highest of the last 1.5 s, m
  double gains;                      // goal: comes back a third higher
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.height > 0) || !(in.step > 0)) out.problem = contact::figure::not_positive;
  if (in.height > 1e100 || in.step > 1e100 || in.k > 1 || in.rule > 4) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.height < 1e-100 || in.step < 1e-4 || in.k < 0 || in.rule < 0)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  const auto ball = contact::bouncing_ball(in.height, 0.0, gravity, in.k);
  constexpr double late = seconds - 1.5;
  for (int i = 0; i < points; ++i) {
    const auto at = static_cast<std::size_t>(i);
    out.moment[at] = seconds * i / (points - 1);
    out.truth[at] = contact::bounce_at(ball, out.moment[at]).height;
    if (out.moment[at] >= late) out.true_last_peak = std::max(out.true_last_peak, out.truth[at]);
  }
  const auto after = contact::bounce_at(ball, seconds);
  out.true_bounces = after.bounces;
  out.true_height = after.height;

  const auto rule = static_cast<contact::StepRule>(static_cast<int>(in.rule));
  const int steps = static_cast<int>(seconds / in.step);
  const int thin = (steps + stepped_points - 2) / (stepped_points - 1);  // one point in so many
  contact::BounceState<double> state{in.height, 0, 0, false};
  std::size_t at = 0;
  out.stepped_time[at] = 0;
  out.stepped[at++] = in.height;
  for (int i = 1; i <= steps; ++i) {
    state = contact::bounce_step(state, ball, in.step, rule);
    if (state.bounces > 0) out.highest = std::max(out.highest, state.height);
    if (i * in.step >= late) out.last_peak = std::max(out.last_peak, state.height);
    if (i % std::max(1, thin) == 0 && at < stepped_points) {
      out.stepped_time[at] = i * in.step;
      out.stepped[at++] = state.height;
    }
  }
  for (const std::size_t last = at - 1; at < stepped_points; ++at) {
    out.stepped_time[at] = out.stepped_time[last];
    out.stepped[at] = out.stepped[last];
  }
  out.steps = steps;
  out.bounces = state.bounces;
  out.last_height = state.height;
  out.gains = out.highest >= 4 * in.height / 3 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(height, step, k, rule), Output,
       FIELDS(problem, moment, truth, stepped_time, stepped, steps, true_bounces, bounces,
              true_height, last_height, highest, last_peak, true_last_peak, gains))
