// A ball hits the ground, and one number goes from soft through harder to rigid: the force over
// time, whose area stays the same, and the velocity over time, which becomes a jump. Gravity is
// left out, so that every curve is a closed form.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/penalty_force.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/spring_damper.hpp>
#include <contact/spring_impact.hpp>
#include <cstddef>
#include <limits>

using Vector = contact::Vector3<double>;
using contact::ContactRelease;

constexpr std::size_t samples = 97;
constexpr double mass = 1, speed = 2, radius = 0.5;  // kg, m/s, m
constexpr double last_moment = 0.5;                  // at which the curves end, s
constexpr double softest = 100;                      // N/m

struct Input {
  double hardness;  // 0 soft; the stiffness is 100 · 100^hardness N/m; 1 is rigid
  double ratio;     // the damping ratio ζ
  double time;      // at which the ball is drawn, s after the first touch
  double release;   // 0 the contact never pulls, 1 it may pull until the overlap is gone
};

struct Output {
  double problem;
  double rigid;                               // 1: an impulse and no force
  double stiffness, damping;                  // N/m, N·s/m; 0 if rigid
  double at_zero_force, at_zero_penetration;  // the coefficients of restitution
  double restitution;                         // the one of the chosen rule
  double impulse;                             // m (1 + e) v, N·s
  double duration, max_depth, max_force;      // s, m, N
  double left_overlap;                        // when the force ends, m
  // While the contact lasts, at most to the last moment: the force, and the velocity upwards.
  std::array<double, samples> moment, force, velocity;
  // What a contact that may pull does between zero force and zero penetration.
  double pulls;
  std::array<double, samples> pull_moment, pull_force, pull_velocity;
  // At the time of the drawing.
  double penetration, approach;    // m, m/s
  double half_width, half_height;  // of the squashed ball, m
  double bottom;                   // height of its lowest point, m
  double force_now;                // by the chosen rule, N
  double velocity_now;             // upwards, m/s
  // The same as the ball of a reader's function, on the half-space z ≤ 0.
  Vector centre, ball_velocity;
  double ball_radius, touches, push;  // the force of the rule that never pulls, N
  // Goals of questions.
  double pulled;       // a contact that may pull pulls at the time of the drawing
  double hard_bounce;  // a contact of less than 0.05 s that keeps at least 80 % of the speed
};

namespace {

struct Motion {
  double penetration, approach;
};

// [motion]
/// Penetration and speed of approach a time t after the first touch, as long as spring and damper
/// stay attached: d = v t e^(−ζ ω t) S and ḋ = v e^(−ζ ω t) (C − ζ ω t S), where C and S are cos y
/// and sin y / y of y = √(1 − ζ²) ω t, which continue through ζ = 1 as cosh and sinh.
Motion attached(double ratio, double rate, double t) {
  const double square = (1 - ratio) * (1 + ratio) * rate * t * rate * t;  // y²
  const double faded = ratio * rate * t;
  double cosine = 0, share = 0;  // with the factor e^(−ζ ω t)
  if (std::abs(square) < 0.01) {
    const double decay = contact::detail::decay(faded);
    cosine = decay * (1 - square / 2 * (1 - square / 12 * (1 - square / 30)));
    share = decay * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)));
  } else if (square > 0) {
    const double decay = contact::detail::decay(faded);
    const auto turn = contact::sine_cosine(std::sqrt(square));
    cosine = decay * turn.cosine;
    share = decay * turn.sine / std::sqrt(square);
  } else {
    const double y = std::sqrt(-square);
    const double slow = contact::detail::decay(faded - y), fast = contact::detail::decay(faded + y);
    cosine = (slow + fast) / 2;
    share = (slow - fast) / (2 * y);
  }
  return {speed * t * share, speed * (cosine - faded * share)};
}
// [/motion]

/// 100^x for x from 0 to 1, with the same bits everywhere.
double hundred_to(double x) { return 1 / contact::detail::decay(4.605170185988092 * x); }

/// The curves from one time to another; the force of a contact that may pull.
void sample(const contact::SpringDamper<double>& spring, double ratio, double from, double to,
            std::array<double, samples>& moment, std::array<double, samples>& force,
            std::array<double, samples>& velocity) {
  const double rate = contact::natural_frequency(spring, mass);
  for (std::size_t i = 0; i < samples; ++i) {
    moment[i] = from + (to - from) * double(i) / double(samples - 1);
    const Motion m = attached(ratio, rate, moment[i]);
    force[i] = spring.stiffness * m.penetration + spring.damping * m.approach;
    velocity[i] = -m.approach;
  }
}

/// A ball of the same area as a disc that is lower by the penetration: a drawing, nothing computed.
void squash(Output& out) {
  out.half_height = radius - std::max(0.0, out.penetration) / 2;
  out.half_width = radius * radius / out.half_height;
  out.bottom = std::max(0.0, -out.penetration);
}

void as_ball(Output& out) {
  out.centre = {0, 0, radius - out.penetration};
  out.ball_velocity = {0, 0, out.velocity_now};
  out.ball_radius = radius;
}

void rigidly(const Input& in, Output& out) {
  out.rigid = 1;
  out.max_force = std::numeric_limits<double>::infinity();
  out.velocity_now = in.time < 0 ? -speed : out.restitution * speed;
  out.penetration = -out.velocity_now * in.time;
  out.approach = -out.velocity_now;
}

void softly(const Input& in, ContactRelease rule, Output& out) {
  out.stiffness = softest * hundred_to(in.hardness);
  out.damping = 2 * in.ratio * std::sqrt(out.stiffness) * std::sqrt(mass);
  const contact::SpringDamper<double> spring{out.stiffness, out.damping};
  const double rate = contact::natural_frequency(spring, mass);
  const auto impact = contact::spring_impact(spring, mass, speed, rule);
  out.duration = impact.duration;
  out.max_depth = impact.max_depth;
  out.max_force = impact.max_force;
  out.left_overlap = impact.left_overlap;

  const auto pushing = contact::spring_impact(spring, mass, speed, ContactRelease::at_zero_force);
  const auto whole =
      contact::spring_impact(spring, mass, speed, ContactRelease::at_zero_penetration);
  const double let_go = std::min(pushing.duration, last_moment);
  const double apart = std::min(whole.duration, last_moment);
  sample(spring, in.ratio, 0, let_go, out.moment, out.force, out.velocity);
  out.pulls = in.ratio > 0 && apart > let_go ? 1 : 0;
  sample(spring, in.ratio, let_go, apart, out.pull_moment, out.pull_force, out.pull_velocity);

  Motion now{speed * in.time, speed};
  if (in.time > impact.duration) {
    const double left = out.restitution * speed;
    now = {impact.left_overlap - left * (in.time - impact.duration), -left};
  } else if (in.time > 0) {
    now = attached(in.ratio, rate, in.time);
  }
  out.penetration = now.penetration;
  out.approach = now.approach;
  out.velocity_now = -now.approach;
  as_ball(out);
  // In the plane's frame, from the numbers that a reader's function gets.
  const contact::PenaltyBall<double> ball{{out.centre, radius}, out.ball_velocity};
  const contact::Plane<double> ground{Vector(0, 0, 1), 0};
  const auto force = contact::half_space_force(ball, ground, spring);
  out.touches = force.touching ? 1 : 0;
  out.push = force.force.z();
  const bool over = in.time > impact.duration;
  out.force_now = over ? 0 : contact::half_space_force(ball, ground, spring, rule).force.z();
  const double unclamped =
      contact::half_space_force(ball, ground, spring, ContactRelease::at_zero_penetration)
          .force.z();
  out.pulled = rule == ContactRelease::at_zero_penetration && unclamped < 0 ? 1 : 0;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (in.hardness < 0 || in.ratio < 0) out.problem = contact::figure::too_small;
  if (in.hardness > 1 || in.ratio > 100 || std::abs(in.time) > 100) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  const auto rule =
      in.release == 1 ? ContactRelease::at_zero_penetration : ContactRelease::at_zero_force;
  out.at_zero_force = contact::restitution_of_damping(in.ratio, ContactRelease::at_zero_force);
  out.at_zero_penetration =
      contact::restitution_of_damping(in.ratio, ContactRelease::at_zero_penetration);
  out.restitution =
      rule == ContactRelease::at_zero_force ? out.at_zero_force : out.at_zero_penetration;
  out.impulse = mass * (1 + out.restitution) * speed;
  if (in.hardness == 1) {
    rigidly(in, out);
  } else {
    softly(in, rule, out);
  }
  squash(out);
  as_ball(out);
  out.hard_bounce = out.duration <= 0.05 && out.restitution >= 0.8 && out.rigid == 0 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(hardness, ratio, time, release), Output,
       FIELDS(problem, rigid, stiffness, damping, at_zero_force, at_zero_penetration, restitution,
              impulse, duration, max_depth, max_force, left_overlap, moment, force, velocity, pulls,
              pull_moment, pull_force, pull_velocity, penetration, approach, half_width,
              half_height, bottom, force_now, velocity_now, centre, ball_velocity, ball_radius,
              touches, push, pulled, hard_bounce))
