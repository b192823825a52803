// A force drawn by hand and its effect on a body: area, average, velocity.
// Times are in ms and forces in kN, so that an area is in N·s.
#include <algorithm>
#include <contact/figure.hpp>
#include <contact/impulse.hpp>

constexpr int samples = 33;
constexpr int moments = 65;

struct Input {
  std::array<double, samples - 2> drawn;  // kN, at equal times; the force is 0 at both ends
  double duration;                        // ms
  double mass;                            // kg
  double speed;                           // with which the body comes in, against the force, m/s
  double beside;                          // 1: also what F_p T would do is drawn; 0: not
};

struct Output {
  double problem;
  std::array<double, samples> time;             // ms
  std::array<double, samples> force;            // kN
  std::array<double, samples - 1> split_time;   // where a piece crosses the axis, or its middle
  std::array<double, samples - 1> split_force;  // and the force there
  double impulse;                               // N·s
  double average;                               // kN
  double largest;                               // of the force, by size, with its sign
  double before;                                // velocity, m/s: minus the speed
  double change;                                // of the velocity, m/s
  double after;                                 // m/s
  double to_stop;                               // the impulse that would stop the body, N·s
  std::array<double, moments> moment;           // ms
  std::array<double, moments> velocity_at;      // m/s
  double peak_impulse;                          // F_p T, N·s
  double peak_after;                            // the velocity that it would give, m/s
  std::array<double, moments> peak_at;          // and before that
  double stops_gently;  // goal of a question: a body with momentum stops, and no force above 1.5 kN
};

namespace {

// WRONG: as if the largest force lasted the whole time. The box is as high as the maximum of the
// curve, and its area is larger.
double largest_force_times_time(double largest, double duration) { return largest * duration; }

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.duration > 0) || !(in.mass > 0)) out.problem = contact::figure::not_positive;
  std::array<double, samples> heights{};
  std::copy(in.drawn.begin(), in.drawn.end(), heights.begin() + 1);
  for (const double f : heights) {
    if (std::abs(f) > 1e100) out.problem = contact::figure::too_large;
  }
  if (in.duration > 1e100 || in.mass > 1e100 || std::abs(in.speed) > 1e100) {
    out.problem = contact::figure::too_large;
  }
  if (in.duration < 1e-100 || in.mass < 1e-100) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  std::vector<double> time;
  std::vector<contact::Vector3<double>> force;
  for (int i = 0; i < samples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    time.push_back(in.duration * i / (samples - 1));
    force.push_back({heights[at], 0, 0});
    out.time[at] = time[at];
    out.force[at] = heights[at];
    if (std::abs(heights[at]) > std::abs(out.largest)) out.largest = heights[at];
  }
  for (std::size_t i = 0; i + 1 < samples; ++i) {
    const double first = heights[i];
    const double second = heights[i + 1];
    const bool crosses = (first < 0 && second > 0) || (first > 0 && second < 0);
    const double share = crosses ? first / (first - second) : 0.5;
    out.split_time[i] = time[i] + share * (time[i + 1] - time[i]);
    out.split_force[i] = crosses ? 0 : 0.5 * (first + second);
  }

  const auto curve = contact::force_curve(time, force);
  out.impulse = contact::impulse(curve).x();
  out.average = contact::average_force(curve).x();
  out.before = -in.speed;
  out.after = contact::velocity_after(in.mass, out.before, out.impulse);
  out.change = out.after - out.before;
  out.to_stop = contact::impulse_of_change<double>(in.mass, {out.before, 0, 0}, {0, 0, 0}).x();
  for (int i = 0; i < moments; ++i) {
    const auto at = static_cast<std::size_t>(i);
    out.moment[at] = in.duration * i / (moments - 1);
    out.velocity_at[at] = contact::velocity_after(
        in.mass, out.before, contact::impulse_until(curve, out.moment[at]).x());
    out.peak_at[at] = contact::velocity_after(
        in.mass, out.before, largest_force_times_time(out.largest, out.moment[at]));
  }
  out.peak_impulse = largest_force_times_time(out.largest, in.duration);
  out.peak_after = contact::velocity_after(in.mass, out.before, out.peak_impulse);
  const bool moving = std::abs(out.to_stop) >= 2;
  out.stops_gently = moving && std::abs(out.after) <= 0.2 && std::abs(out.largest) <= 1.5 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(drawn, duration, mass, speed, beside), Output,
       FIELDS(problem, time, force, split_time, split_force, impulse, average, largest, before,
              change, after, to_stop, moment, velocity_at, peak_impulse, peak_after, peak_at,
              stops_gently))
