// A ball between two walls of springs and dampers, in time steps: its states in the plane of
// penetration and speed, and its energy after each bounce, for each integration scheme. No other
// force acts, and flights are exact, so that contacts alone change the energy.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/bounce_energy.hpp>
#include <contact/figure.hpp>
#include <contact/penalty_step.hpp>
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_damper.hpp>
#include <contact/spring_impact.hpp>
#include <cstddef>

using Point = contact::Vector2<double>;
using contact::ContactRelease;
using contact::PenaltyScheme;
using contact::PenaltyState;
using contact::StepBehaviour;

constexpr std::size_t schemes = 7, bounces = 12, states = 300, samples = 65;
constexpr double mass = 1, speed = 2, distance = 1;  // kg, m/s, m between the walls

struct Input {
  double step;       // h, s
  double stiffness;  // k, N/m
  double ratio;      // the damping ratio ζ
  double scheme;     // as PenaltyScheme
  double phase;      // overlap at the first step that ends in one, as a share of h v
};

struct Output {
  double problem;
  double mass, damping;  // kg, N·s/m
  // The first state with an overlap, and the next one by semi-implicit Euler on a spring that is
  // not left, whichever scheme is chosen.
  double first_overlap, first_approach;
  double next_penetration, next_approach;
  double rate;  // ω₀, rad/s
  // Stability of the chosen scheme on a spring that it never leaves: 0 decays, 1 bounded, 2 grows;
  // the smallest step for which it grows, and whether there is one.
  double behaviour, limit, has_limit;
  double semi_implicit_limit;  // of that scheme, whichever is chosen, s
  // States in contact, and those before and after: penetration in units of v / ω₀, and speed of
  // approach in units of v; the bounce that each belongs to, from 0.
  double recorded;
  std::array<Point, states> trace;
  std::array<double, states> trace_bounce;
  std::array<Point, samples> exact;  // the first impact by its closed form
  // Energy after each bounce over that at the start, of scheme s after n bounces: [13 s + n]; how
  // many bounces there were.
  std::array<double, schemes*(bounces + 1)> energy;
  std::array<double, schemes> counted;
  double kept;        // by the closed form, e²
  double first_kept;  // by the chosen scheme in its first bounce
  double steps;       // in the first contact
  // For an undamped spring and semi-implicit Euler: bounds on that, else 0; the step for which they
  // are 10 %.
  double min_kept, max_kept, ten_percent;
  // Goals of questions.
  double gains;         // more than 1.5 times the energy after one bounce, below the limit
  double grows;         // ten times the energy after at most 12 bounces
  double damps_itself;  // no damper, and a bounce loses half of the energy
};

namespace {

/// Follows the ball for 12 bounces: `visit` gets each step that starts or ends in a contact, and
/// `bounced` the speed after each bounce.
template <class Visit, class Bounced>
void follow(PenaltyScheme scheme, const contact::SpringDamper<double>& spring, const Input& in,
            const Visit& visit, const Bounced& bounced) {
  constexpr int max_steps = 6000;
  // [walls]
  PenaltyState<double> now{-(1 - in.phase) * in.step * speed, speed};
  std::size_t made = 0;
  for (int i = 0; i < max_steps && made < bounces; ++i) {
    const auto next = contact::penalty_step<double>(scheme, now, spring, mass, in.step, 0);
    if (now.penetration >= 0 || next.penetration >= 0) visit(made, now, next);
    if (now.penetration >= 0 && next.penetration < 0) bounced(++made, next.approach);
    now = next;
    // Halfway to the other wall the distance to it counts; the walls are alike.
    if (now.penetration < -distance / 2 && now.approach < 0) {
      now = {-distance - now.penetration, -now.approach};
    }
    if (std::abs(now.approach) > 1e6 * speed) return;
  }
  // [/walls]
}

void run_all(const contact::SpringDamper<double>& spring, const Input& in, PenaltyScheme chosen,
             Output& out) {
  const double depth = speed / out.rate;
  for (std::size_t s = 0; s < schemes; ++s) {
    const auto scheme = static_cast<PenaltyScheme>(s);
    const std::size_t first = s * (bounces + 1);
    out.energy[first] = 1;
    const auto add = [&](std::size_t bounce, const PenaltyState<double>& state) {
      const auto i = static_cast<std::size_t>(out.recorded);
      if (i == states) return;
      out.trace[i] = {state.penetration / depth, state.approach / speed};
      out.trace_bounce[i] = double(bounce);
      out.recorded += 1;
    };
    follow(
        scheme, spring, in,
        [&](std::size_t bounce, const PenaltyState<double>& now, const PenaltyState<double>& next) {
          if (scheme != chosen) return;
          if (bounce == 0 && now.penetration >= 0) out.steps += 1;
          const auto i = static_cast<std::size_t>(out.recorded);
          if (i == 0 || out.trace_bounce[i - 1] != double(bounce)) add(bounce, now);
          add(bounce, next);
        },
        [&](std::size_t n, double approach) {
          out.energy[first + n] = approach / speed * (approach / speed);
          out.counted[s] = double(n);
        });
  }
}

void closed_form(const Input& in, Output& out) {
  const contact::SpringDamper<double> spring{in.stiffness, out.damping};
  const auto impact = contact::spring_impact(spring, mass, speed);
  out.kept = impact.restitution * impact.restitution;
  const double depth = speed / out.rate;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = impact.duration * double(i) / double(samples - 1);
    const auto state = contact::damped_motion<double>({0, speed}, spring, mass, 0, t);
    out.exact[i] = {state.penetration / depth, state.approach / speed};
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.step > 0) || !(in.stiffness > 0)) out.problem = contact::figure::not_positive;
  if (in.step > 1e3 || in.stiffness > 1e9 || in.ratio > 100 || in.phase >= 1) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.step < 1e-6 || in.stiffness < 1e-3 || in.ratio < 0 || in.phase < 0)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;
  const auto chosen =
      static_cast<PenaltyScheme>(static_cast<int>(std::clamp(in.scheme, 0.0, schemes - 1.0)));
  out.mass = mass;
  out.damping = 2 * in.ratio * std::sqrt(in.stiffness) * std::sqrt(mass);
  const contact::SpringDamper<double> spring{in.stiffness, out.damping};
  out.rate = contact::natural_frequency(spring, mass);
  out.behaviour = double(static_cast<int>(contact::step_behaviour(chosen, spring, mass, in.step)));
  out.limit = contact::step_limit(chosen, spring, mass);
  out.has_limit = std::isfinite(out.limit) ? 1 : 0;
  const auto semi = PenaltyScheme::semi_implicit_euler;
  out.semi_implicit_limit = contact::step_limit(semi, spring, mass);
  out.first_overlap = in.phase * in.step * speed;
  out.first_approach = speed;
  const auto next =
      contact::spring_step<double>(semi, {out.first_overlap, speed}, spring, mass, in.step, 0);
  out.next_penetration = next.penetration;
  out.next_approach = next.approach;
  run_all(spring, in, chosen, out);
  closed_form(in, out);
  const std::size_t at = static_cast<std::size_t>(chosen) * (bounces + 1);
  out.first_kept = out.energy[at + 1];
  if (chosen == semi && in.ratio == 0) {
    out.ten_percent = contact::step_for_energy(spring, mass, 0.1);
    const auto factor = contact::bounce_energy_factor(spring, mass, in.step);
    out.min_kept = factor.min;
    out.max_kept = factor.max;
  }
  out.gains = in.step < out.limit && out.first_kept > 1.5 ? 1 : 0;
  for (std::size_t n = 1; n <= bounces; ++n) {
    if (out.energy[at + n] > 10) out.grows = 1;
  }
  const bool first = out.counted[static_cast<std::size_t>(chosen)] >= 1;
  out.damps_itself = in.ratio == 0 && first && out.first_kept <= 0.5 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(step, stiffness, ratio, scheme, phase), Output,
       FIELDS(problem, mass, damping, first_overlap, first_approach, next_penetration,
              next_approach, rate, behaviour, limit, has_limit, semi_implicit_limit, recorded,
              trace, trace_bounce, exact, energy, counted, kept, first_kept, steps, min_kept,
              max_kept, ten_percent, gains, grows, damps_itself))
