// A wagon whose mass changes: its velocity by the law for variable mass, and by F = d(mv)/dt for
// the wagon alone.
#include <contact/figure.hpp>
#include <contact/variable_mass.hpp>

struct Input {
  double velocity;  // of the wagon initially, m/s
  double rate;      // kg/s: of the sand that runs out or the rain that falls in
  double apart;     // u, velocity of the sand relative to the wagon just after it has left, m/s
  double force;     // along the track, N
  double rains;     // 1: rain that falls vertically joins; 0: sand leaves
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
  double relative;                       // velocity of the matter relative to the wagon then, m/s
  double velocity_now, alone_now;        // m/s
  double position, position_alone;       // m
  double thrust;                         // u dm/dt, N
  double p_given;                        // initial p plus F t, kg·m/s
  double p_all, p_all_alone;             // of wagon and all matter, by either, kg·m/s
  double agree;                          // whether both laws give one velocity, to a thousandth
};

namespace {

using contact::AfterStream;

/// The stream of matter; along the track, which is x.
struct Stream {
  double velocity, force, apart, mass_rate;
  bool rains;

  AfterStream<double> after(double t) const {
    return rains ? *contact::after_stream_over_ground<double>(
                       at_first, {velocity, 0, 0}, {force, 0, 0}, {0, 0, 0}, mass_rate, t)
                 : *contact::after_stream_from_body<double>(
                       at_first, {velocity, 0, 0}, {force, 0, 0}, {apart, 0, 0}, mass_rate, t);
  }

  // WRONG, d(mv)/dt = F: as if matter that leaves left its momentum behind. The law holds for a
  // closed set of matter, and the wagon is none. It is right only for matter at rest over the
  // ground, before it joins or after it has left.
  AfterStream<double> by_own_momentum(double t) const {
    auto after = *contact::after_stream_over_ground<double>(at_first, {velocity, 0, 0},
                                                            {force, 0, 0}, {0, 0, 0}, mass_rate, t);
    // Matter that leaves has the wagon's velocity plus u.
    if (!rains) after.carried_off.x() = -mass_rate * (after.displacement.x() + apart * t);
    return after;
  }
};

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const double x : {in.velocity, in.rate, in.apart, in.force, in.time}) {
    if (std::abs(x) > 1e30) out.problem = contact::figure::too_large;
  }
  // A larger loss would leave less than the empty wagon.
  if (in.rate > (at_first - least) / seconds || in.time > seconds) {
    out.problem = contact::figure::too_large;
  }
  if (in.rate < 0 || in.time < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  const bool rains = in.rains > 0.5;
  const Stream stream{in.velocity, in.force, in.apart, rains ? in.rate : -in.rate, rains};
  for (int i = 0; i < moments; ++i) {
    const auto at = static_cast<std::size_t>(i);
    out.moment[at] = seconds * i / (moments - 1);
    out.velocity[at] = stream.after(out.moment[at]).velocity.x();
    out.alone[at] = stream.by_own_momentum(out.moment[at]).velocity.x();
  }
  const auto now = stream.after(in.time);
  const auto alone = stream.by_own_momentum(in.time);
  const auto all = [](const AfterStream<double>& after) {
    return after.mass * after.velocity.x() + after.carried_off.x();
  };
  out.mass = now.mass;
  out.velocity_now = now.velocity.x();
  out.relative = rains ? -out.velocity_now : in.apart;
  out.alone_now = alone.velocity.x();
  out.position = now.displacement.x();
  out.position_alone = alone.displacement.x();
  out.thrust = out.relative * stream.mass_rate;
  out.p_given = at_first * in.velocity + in.force * in.time;
  out.p_all = all(now);
  out.p_all_alone = all(alone);
  const double off = std::abs(out.alone_now - out.velocity_now);
  out.agree = off <= 1e-3 * std::abs(out.velocity_now) ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(velocity, rate, apart, force, rains, time), Output,
       FIELDS(problem, moment, velocity, alone, mass, relative, velocity_now, alone_now, position,
              position_alone, thrust, p_given, p_all, p_all_alone, agree))
