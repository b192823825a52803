// Three discs on an air table, event-driven or in fixed time steps.
#include <array>
#include <contact/billiard_table.hpp>
#include <contact/figure.hpp>

constexpr int max_events = 13;
constexpr int positions = max_events + 2;
constexpr int samples = 61;

// Positions off the table are moved to its edge.
struct Input {
  contact::Vector2<double> centre_a, centre_b, centre_c;  // m
  contact::Vector2<double> velocity_a;                    // m/s; B and C are at rest
  contact::Vector2<double> guess;                         // of the reader
  double time;                                            // s
  double restitution;
  double step;  // s, of the time steps; 0: none
  double show;  // 0: only until two discs touch; 1: everything
};

struct Output {
  double problem;
  double side, radius, duration;
  double shown;                         // time shown, s
  std::array<double, positions> times;  // of start, events and end, as far as shown
  std::array<contact::Vector2<double>, positions> path_a, path_b, path_c;
  double events;                                 // number shown
  double first_touch;                            // time of the first touch of two discs; 0 if none
  double touches;                                // whether they do
  contact::Vector2<double> now_a, now_b, now_c;  // at the time, or at the end of what is shown
  contact::Vector2<double> touch_a, touch_b;     // the two discs at their first touch
  double energy, momentum_x, momentum_y;         // at that time, of 1 kg each
  std::array<contact::Vector2<double>, samples> steps_a, steps_b, steps_c;
  double stepped;       // whether those are filled
  double cushion_time;  // when B first reaches a cushion; 0 if it does not, or is not shown
  contact::Vector2<double> b_at_cushion;
  double guessed;         // the guess is within a radius of where B first reaches a cushion
  double guessed_unseen;  // goal of a question: that, while only the time before the touch is shown
};

using Vector = contact::Vector2<double>;
using Discs = std::vector<contact::Disc<double>>;

constexpr double table_side = 1.6;
constexpr double disc_radius = 0.1;
constexpr double table_duration = 3;

/// The nearest position at which a disc lies on the table.
Vector on_table(const Vector& p) {
  return p.cwiseMax(disc_radius).cwiseMin(table_side - disc_radius);
}

Output compute(const Input& in) {
  Output out{};
  for (const Vector* v : {&in.centre_a, &in.centre_b, &in.centre_c, &in.velocity_a, &in.guess}) {
    if (v->cwiseAbs().maxCoeff() > 100) out.problem = contact::figure::too_large;
  }
  if (in.restitution > 1) out.problem = contact::figure::too_large;
  if (in.restitution < 0 || (in.step != 0 && in.step < 0.01)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  out.side = table_side;
  out.radius = disc_radius;
  out.duration = table_duration;
  const contact::Table<double> table{table_side, table_side, in.restitution, in.restitution};
  const Discs start{contact::disc<double>(1, disc_radius, on_table(in.centre_a), in.velocity_a),
                    contact::disc<double>(1, disc_radius, on_table(in.centre_b), Vector(0, 0)),
                    contact::disc<double>(1, disc_radius, on_table(in.centre_c), Vector(0, 0))};

  // The whole future, event by event.
  std::vector<double> times{0};
  std::vector<Discs> states{start};
  double first_touch = -1;
  double cushion_time = -1;
  Vector b_at_cushion(0, 0);
  Discs discs = start;
  const auto seen = [&](const contact::TableEvent<double>& event, const Discs& now) {
    times.push_back(event.time);
    states.push_back(now);
    if (event.second >= 0 && first_touch < 0) {
      first_touch = event.time;
      out.touch_a = now[static_cast<std::size_t>(event.first)].centre;
      out.touch_b = now[static_cast<std::size_t>(event.second)].centre;
    }
    if (event.second < 0 && event.first == 1 && cushion_time < 0) {
      cushion_time = event.time;
      b_at_cushion = now[1].centre;
    }
  };
  const double played = contact::play(table, discs, table_duration, max_events, seen);
  out.touches = first_touch >= 0 ? 1 : 0;
  out.first_touch = std::max(0.0, first_touch);
  out.shown = in.show != 0 || first_touch < 0 ? played : first_touch;

  // The part that is shown: positions at the events, then at the end.
  const auto position_at = [&](double t) {
    std::size_t i = 0;
    while (i + 1 < times.size() && times[i + 1] <= t) ++i;
    Discs now = states[i];
    contact::move_on(now, t - times[i]);
    return now;
  };
  int filled = 0;
  const auto add = [&](double t, const Discs& now) {
    const auto k = static_cast<std::size_t>(filled++);
    out.times[k] = t;
    out.path_a[k] = now[0].centre;
    out.path_b[k] = now[1].centre;
    out.path_c[k] = now[2].centre;
  };
  for (std::size_t i = 0; i < times.size() && times[i] <= out.shown; ++i) add(times[i], states[i]);
  out.events = filled - 1;
  while (filled < positions) add(out.shown, position_at(out.shown));

  const Discs now = position_at(std::clamp(in.time, 0.0, out.shown));
  out.now_a = now[0].centre;
  out.now_b = now[1].centre;
  out.now_c = now[2].centre;
  for (const auto& d : now) {
    out.energy += contact::kinetic_energy(d);
    out.momentum_x += d.mass * d.velocity.x();
    out.momentum_y += d.mass * d.velocity.y();
  }

  if (in.step > 0 && in.show != 0) {
    out.stepped = 1;
    // Sixty positions are enough to draw; the last one is the present state of the steps.
    Discs stepped = start;
    std::size_t k = 0;
    const auto keep = [&](double t, const Discs& at) {
      while (k < samples && double(k) * table_duration / (samples - 1) <= t + 1e-9) {
        out.steps_a[k] = at[0].centre;
        out.steps_b[k] = at[1].centre;
        out.steps_c[k] = at[2].centre;
        ++k;
      }
    };
    keep(0, stepped);
    contact::play_in_steps(table, stepped, table_duration, in.step, keep);
    while (k < samples) keep(table_duration, stepped);
  }

  if (cushion_time >= 0) {
    if (cushion_time <= out.shown) {
      out.cushion_time = cushion_time;
      out.b_at_cushion = b_at_cushion;
    }
    out.guessed =
        cushion_time <= out.shown && (on_table(in.guess) - b_at_cushion).norm() <= disc_radius;
    out.guessed_unseen =
        in.show == 0 && (on_table(in.guess) - b_at_cushion).norm() <= disc_radius ? 1 : 0;
  }
  return out;
}

FIGURE(Input,
       FIELDS(centre_a, centre_b, centre_c, velocity_a, guess, time, restitution, step, show),
       Output,
       FIELDS(problem, side, radius, duration, shown, times, path_a, path_b, path_c, events,
              first_touch, touches, now_a, now_b, now_c, touch_a, touch_b, energy, momentum_x,
              momentum_y, steps_a, steps_b, steps_c, stepped, cushion_time, b_at_cushion, guessed,
              guessed_unseen))
