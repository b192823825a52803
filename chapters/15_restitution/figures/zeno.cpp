// A ball that is dropped and bounces: its heights, its impacts, when they end, and what resting
// early leaves out.
#include <algorithm>
#include <contact/bouncing.hpp>
#include <contact/figure.hpp>

struct Input {
  double height;       // of the drop, m
  double rebound;      // height of the first rebound, m: decides k
  double gravity;      // m/s²
  double time;         // s
  double rest_height;  // bounces lower than this are left out, m
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
  double bounces;        // until now; infinite at rest
  double rest_speed;     // m/s
  double rest_from;      // when the ball that rests early does, s
  double rest_bounces;   // its impacts
  double ends_at_three;  // goal: everything is over after 3 s
};

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
  const double first = contact::first_impact_time(ball);
  double leaving = out.speed;
  std::size_t at = 0;
  const auto mark = [&](double t, double y) {
    out.moment[at] = t;
    out.path[at++] = y;
  };
  for (int i = 0; i <= pieces; ++i) {
    const double share = double(i) / pieces;
    mark(first * share, i == pieces ? 0 : in.height * (1 - share * share));
  }
  for (std::size_t n = 0; n < arcs; ++n) {
    leaving *= out.k;
    out.impact[n] = contact::impact_time(ball, static_cast<long long>(n) + 1);
    const double flight = 2 * leaving / in.gravity;
    out.peak_time[n] = out.impact[n] + flight / 2;
    out.peak[n] = leaving * leaving / (2 * in.gravity);
    const int parts = n + 1 < arcs ? 2 * pieces : pieces + 1;
    for (int i = 1; i <= parts; ++i) {
      const double share = double(i) / (2 * pieces);
      mark(out.impact[n] + flight * share, 4 * out.peak[n] * share * (1 - share));
    }
  }
  while (at < points) {
    const double t = out.moment[at - 1];
    mark(t, out.path[at - 1]);
  }
  out.shown_until = std::min(out.end, out.moment[points - 1]);

  out.now = in.time;
  const auto now = contact::bounce_at(ball, in.time);
  out.height_now = now.height;
  out.velocity_now = now.velocity;
  out.bounces = now.bounces;
  out.rest_speed = contact::rest_speed(in.rest_height, in.gravity);
  // The first impact that the ball leaves with the rest speed or less.
  leaving = out.speed * out.k;
  long long n = 1;
  while (leaving > out.rest_speed && n < 100000) {
    leaving *= out.k;
    ++n;
  }
  out.rest_bounces = leaving > out.rest_speed ? std::numeric_limits<double>::infinity() : double(n);
  out.rest_from = leaving > out.rest_speed ? std::numeric_limits<double>::infinity()
                                           : contact::impact_time(ball, n);
  out.ends_at_three = std::abs(out.end - 3) <= 0.02 && in.height >= 0.5 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(height, rebound, gravity, time, rest_height), Output,
       FIELDS(problem, k, speed, end, shown_until, impact, peak_time, peak, moment, path, now,
              height_now, velocity_now, bounces, rest_speed, rest_from, rest_bounces,
              ends_at_three))
