// A wall, a ball at rest and a ball that approaches: positions over time, by events and in steps.
#include <algorithm>
#include <contact/figure.hpp>
#include <contact/two_balls_wall.hpp>

struct Input {
  double inner;  // position of the resting ball, m from the wall
  double outer;  // position of the ball that approaches at 1 m/s
  double ratio;  // mass of the outer over that of the inner
  double e;      // restitution of the balls with each other and with the wall
  double step;   // s, of the program in steps
};

constexpr int most = 60;
constexpr int points = most + 2;
constexpr int samples = 129;
constexpr double seconds = 6;

struct Output {
  double problem;
  std::array<double, points> time, inner_at, outer_at;  // at each collision, m
  std::array<double, samples> sample_time, sample_inner, sample_outer;
  double hits;          // collisions in 6 s, or as many as are computed
  double stepped_hits;  // collisions by the program in steps
  double last_time;     // of the last collision computed, s
  double endless;       // 1 if there are infinitely many
  double border;        // the smallest mass ratio for which there are
  double stubborn;      // goal: infinitely many, with e of at least 0.3
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.inner > 0) || !(in.outer > in.inner) || !(in.ratio > 0) || !(in.step > 0)) {
    out.problem = contact::figure::not_positive;
  }
  if (in.outer > 1e6 || in.ratio > 1e9 || in.e > 1 || in.step > seconds) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.inner < 1e-6 || in.ratio < 1e-9 || in.e < 0 || in.step < 0.01)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  const auto start = contact::two_balls_and_wall<double>({1, 0}, {in.ratio, -1}, in.inner,
                                                         in.outer - in.inner, in.e);
  out.inner_at[0] = in.inner;
  out.outer_at[0] = in.outer;
  std::size_t at = 1;
  auto now = start;
  double left = seconds;
  while (left > 0 && at + 1 < points) {
    const auto next = contact::next_hit(now);
    const double until = next ? std::min(next->time, left) : left;
    left -= until;
    double time = until;
    now = contact::two_balls_by_events(now, time, 1);
    out.time[at] = seconds - left;
    out.inner_at[at] = now.wall_gap;
    out.outer_at[at++] = now.wall_gap + now.ball_gap;
  }
  out.hits = static_cast<double>(now.hits);
  out.last_time = out.time[at - 1];
  for (; at < points; ++at) {
    out.time[at] = out.time[at - 1];
    out.inner_at[at] = out.inner_at[at - 1];
    out.outer_at[at] = out.outer_at[at - 1];
  }

  auto stepped = start;
  const int steps = static_cast<int>(seconds / in.step);
  const int thin = std::max(1, (steps + samples - 2) / (samples - 1));
  std::size_t sample = 0;
  for (int i = 0; i <= steps; ++i) {
    if (i > 0) stepped = contact::two_balls_in_steps(stepped, in.step, 1);
    if (i % thin != 0 || sample == samples) continue;
    out.sample_time[sample] = i * in.step;
    out.sample_inner[sample] = stepped.wall_gap;
    out.sample_outer[sample++] = stepped.wall_gap + stepped.ball_gap;
  }
  for (; sample < samples; ++sample) {
    out.sample_time[sample] = out.sample_time[sample - 1];
    out.sample_inner[sample] = out.sample_inner[sample - 1];
    out.sample_outer[sample] = out.sample_outer[sample - 1];
  }
  out.stepped_hits = static_cast<double>(stepped.hits);
  out.endless = contact::collapses(1.0, in.ratio, in.e) ? 1 : 0;
  out.border = 4 * in.e / ((1 - in.e) * (1 - in.e));
  out.stubborn = out.endless > 0 && in.e >= 0.3 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(inner, outer, ratio, e, step), Output,
       FIELDS(problem, time, inner_at, outer_at, sample_time, sample_inner, sample_outer, hits,
              stepped_hits, last_time, endless, border, stubborn))
