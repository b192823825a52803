// A ball that is dropped and bounces: its heights, its impacts, their end, and the effect of an
// early rest. Beside it, on request, a ball that bounces by a k that was measured wrongly.
#include <algorithm>
#include <contact/bouncing.hpp>
#include <contact/figure.hpp>

struct Input {
  double height;       // of the drop, m
  double rebound;      // height of the first rebound, m: decides k
  double gravity;      // m/s²
  double time;         // s
  double rest_height;  // bounces lower than this are left out, m
  double beside;       // 1: also a ball whose k is rebound / height; 0: not
};

constexpr int arcs = 16;
constexpr int pieces = 8;
constexpr int points = 2 * arcs * pieces + 2;

struct Output {
  double problem;
  double k;
  double speed;                             // at the first impact, m/s
  double end;                               // s; infinite for k = 1
  double shown_until;                       // where the drawing ends, s
  std::array<double, arcs> impact;          // s
  std::array<double, arcs> peak_time;       // between this impact and the next
  std::array<double, arcs> peak;            // m
  std::array<double, points> moment, path;  // a curve through all of it: s, m
  double now, height_now, velocity_now;
  double bounces;       // until now; infinite at rest
  double rest_speed;    // m/s
  double rest_from;     // when the ball that rests early does, s
  double rest_bounces;  // its impacts
  double wrong_k;       // rebound / height
  double wrong_end;     // s
  std::array<double, arcs> wrong_peak_time, wrong_peak;
  std::array<double, points> wrong_moment, wrong_path;
  double ends_at_three;  // goal: everything is over after 3 s
};

namespace {

// WRONG: the share of the energy, not of the speed. A ball that bounces by it does not rise to the
// height that was measured.
double measured_without_root(double drop, double rebound) { return rebound / drop; }

/// The peaks of a ball, and a curve through its flights.
void trace(const contact::BouncingBall<double>& ball, std::array<double, arcs>& peak_time,
           std::array<double, arcs>& peak, std::array<double, points>& moment,
           std::array<double, points>& path) {
  std::size_t at = 0;
  const auto mark = [&](double t, double y) {
    moment[at] = t;
    path[at++] = y;
  };
  const double first = contact::first_impact_time(ball);
  for (int i = 0; i <= pieces; ++i) {
    const double share = double(i) / pieces;
    mark(first * share, i == pieces ? 0 : ball.height * (1 - share * share));
  }
  for (std::size_t n = 0; n < arcs; ++n) {
    const auto number = static_cast<long long>(n) + 1;
    const double impact = contact::impact_time(ball, number);
    const double flight = contact::impact_time(ball, number + 1) - impact;
    peak_time[n] = impact + flight / 2;
    peak[n] = contact::peak_height(ball, number);
    const int parts = n + 1 < arcs ? 2 * pieces : pieces + 1;
    for (int i = 1; i <= parts; ++i) {
      const double share = double(i) / (2 * pieces);
      mark(impact + flight * share, 4 * peak[n] * share * (1 - share));
    }
  }
  while (at < points) mark(moment[at - 1], path[at - 1]);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.height > 0) || !(in.gravity > 0)) out.problem = contact::figure::not_positive;
  if (in.height > 1e100 || in.gravity > 1e100 || in.rebound > in.height || in.time > 1e100) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.height < 1e-100 || in.gravity < 1e-100 || in.rebound < 0 ||
                           in.rest_height < 0 || in.time < 0)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  out.k = std::min(1.0, contact::restitution_from_heights(in.height, in.rebound));
  const auto ball = contact::bouncing_ball(in.height, 0.0, in.gravity, out.k);
  out.speed = contact::impact_speed(ball);
  out.end = contact::rest_time(ball);
  for (std::size_t n = 0; n < arcs; ++n) {
    out.impact[n] = contact::impact_time(ball, static_cast<long long>(n) + 1);
  }
  trace(ball, out.peak_time, out.peak, out.moment, out.path);
  out.shown_until = std::min(out.end, out.moment[points - 1]);

  out.now = in.time;
  const auto now = contact::bounce_at(ball, in.time);
  out.height_now = now.height;
  out.velocity_now = now.velocity;
  out.bounces = now.bounces;
  out.rest_speed = contact::rest_speed(in.rest_height, in.gravity);
  const auto rest = contact::early_rest(ball, out.rest_speed);
  out.rest_bounces = rest.impacts;
  out.rest_from = rest.time;

  out.wrong_k = std::min(1.0, measured_without_root(in.height, in.rebound));
  const auto wrong = contact::bouncing_ball(in.height, 0.0, in.gravity, out.wrong_k);
  out.wrong_end = contact::rest_time(wrong);
  trace(wrong, out.wrong_peak_time, out.wrong_peak, out.wrong_moment, out.wrong_path);
  out.ends_at_three = std::abs(out.end - 3) <= 0.02 && in.height >= 0.5 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(height, rebound, gravity, time, rest_height, beside), Output,
       FIELDS(problem, k, speed, end, shown_until, impact, peak_time, peak, moment, path, now,
              height_now, velocity_now, bounces, rest_speed, rest_from, rest_bounces, wrong_k,
              wrong_end, wrong_peak_time, wrong_peak, wrong_moment, wrong_path, ends_at_three))
