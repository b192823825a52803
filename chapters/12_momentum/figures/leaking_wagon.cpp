// A wagon whose mass changes while it rolls: its velocity by the law for matter that comes and
// goes, and by F = d(mv)/dt for the wagon alone.
#include <contact/figure.hpp>
#include <contact/impulse.hpp>
#include <contact/momentum.hpp>
#include <contact/variable_mass.hpp>

struct Input {
  double velocity;  // of the wagon at first, m/s
  double rate;      // kg/s: how much sand runs out, or how much rain falls in
  double apart;     // u, velocity of the sand as seen from the wagon when it has just left, m/s
  double force;     // along the track, N
  double rains;     // 1: rain that falls straight down joins; 0: sand leaves
  double time;      // s
};

constexpr double at_first = 4000;  // kg, all of it
constexpr double least = 400;      // kg: the wagon without its load
constexpr double seconds = 10;
constexpr int moments = 51;

struct Output {
  double problem;
  std::array<double, moments> moment;    // s
  std::array<double, moments> velocity;  // m/s
  std::array<double, moments> alone;     // by d(mv)/dt = F, m/s
  double mass;                           // at the time, kg
  double relative;                       // velocity of the matter as seen from the wagon then, m/s
  double velocity_now, alone_now;        // m/s
  double place, place_alone;             // m
  double thrust;                         // u dm/dt, N
  double p_given;                        // p at first and all that F has given, kg·m/s
  double p_all, p_all_alone;             // of wagon and all matter, by either, kg·m/s
  double agree;                          // whether both laws give one velocity, to a thousandth
};

namespace {

using Vector = contact::Vector3<double>;

// WRONG, d(mv)/dt = F: as if what leaves left its momentum behind. A law about always the same
// matter is asked of a wagon that loses some. It is right only for matter that is at rest over the
// ground, before it joins or after it has left.
double velocity_by_own_momentum(double momentum, double mass) { return momentum / mass; }

struct State {
  double velocity, place, carried;  // m/s, m, and the momentum of the matter outside, kg·m/s
};

/// The stream of matter: its velocity as seen from a wagon with a velocity, and dm/dt.
struct Stream {
  double rate, apart;
  bool rains;

  double seen_from(double velocity) const { return rains ? -velocity : apart; }
  double mass_rate() const { return rains ? rate : -rate; }
};

/// A short time on, by the middle of it.
State advanced(const State& s, const Stream& stream, double force, double mass, double h) {
  const double mass_rate = stream.mass_rate();
  const auto acceleration = [&](double m, double v) {
    return contact::acceleration_with_exchange<double>(m, {force, 0, 0},
                                                       {stream.seen_from(v), 0, 0}, mass_rate)
        .x();
  };
  const double middle = s.velocity + acceleration(mass, s.velocity) * (h / 2);
  const double step = acceleration(mass + mass_rate * (h / 2), middle) * h;
  // What leaves has the velocity of the wagon, and u besides.
  const double over_ground = middle + stream.seen_from(middle);
  return {s.velocity + step, s.place + middle * h, s.carried - mass_rate * over_ground * h};
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const double x : {in.velocity, in.rate, in.apart, in.force, in.time}) {
    if (std::abs(x) > 1e30) out.problem = contact::figure::too_large;
  }
  // More would leave less than the empty wagon.
  if (in.rate > (at_first - least) / seconds || in.time > seconds) {
    out.problem = contact::figure::too_large;
  }
  if (in.rate < 0 || in.time < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  const Stream stream{in.rate, in.apart, in.rains > 0.5};
  const auto mass_at = [&](double t) { return at_first + stream.mass_rate() * t; };
  const double p =
      contact::momentum(contact::point_mass<double>(at_first, {0, 0, 0}, {in.velocity, 0, 0})).x();
  const auto alone_at = [&](double t) {
    return velocity_by_own_momentum(p + in.force * t, mass_at(t));
  };
  constexpr int parts = 4;  // steps between two moments
  State right{in.velocity, 0, 0};
  for (int i = 0; i < moments; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double t = seconds * i / (moments - 1);
    out.moment[at] = t;
    out.velocity[at] = right.velocity;
    out.alone[at] = alone_at(t);
    const double h = seconds / (moments - 1) / parts;
    for (int k = 0; k < parts; ++k) {
      right = advanced(right, stream, in.force, mass_at(t + k * h), h);
    }
  }

  // The same up to the time that is looked at.
  constexpr int steps = 200;
  const double h = in.time / steps;
  State now{in.velocity, 0, 0};
  State alone{in.velocity, 0, 0};
  for (int k = 0; k < steps; ++k) {
    now = advanced(now, stream, in.force, mass_at(k * h), h);
    const double middle = alone_at((k + 0.5) * h);
    alone.place += middle * h;
    alone.carried -= stream.mass_rate() * (middle + stream.seen_from(middle)) * h;
  }
  out.mass = mass_at(in.time);
  out.velocity_now = now.velocity;
  out.relative = stream.seen_from(now.velocity);
  out.alone_now = alone_at(in.time);
  out.place = now.place;
  out.place_alone = alone.place;
  out.thrust = out.relative * stream.mass_rate();
  out.p_given = p + in.force * in.time;
  out.p_all = out.mass * now.velocity + now.carried;
  out.p_all_alone = out.mass * out.alone_now + alone.carried;
  const double off = std::abs(out.alone_now - out.velocity_now);
  out.agree = off <= 1e-3 * std::abs(out.velocity_now) ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(velocity, rate, apart, force, rains, time), Output,
       FIELDS(problem, moment, velocity, alone, mass, relative, velocity_now, alone_now, place,
              place_alone, thrust, p_given, p_all, p_all_alone, agree))
