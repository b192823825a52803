// A ball hits the ground, and one number goes from soft through harder to rigid: the force over
// time, whose area stays the same, and the velocity over time, which becomes a jump. Gravity is
// left out, so that every curve is a closed form.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/penalty_force.hpp>
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_impact.hpp>
#include <contact/squash.hpp>
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
  double force_now;                // by the chosen rule, N
  double velocity_now;             // upwards, m/s
  // The same as the ball of a reader's function, on the half-space z ≤ 0.
  Vector centre, ball_velocity;
  double ball_radius, touches;
  double push;         // the force of the rule that never pulls, N; positive upwards
  Vector push_vector;  // the same, computed from the ball
  // Goals of questions.
  double pulled;       // a contact that may pull pulls at the time of the drawing
  double hard_bounce;  // a contact of less than 0.05 s that keeps at least 80 % of the speed
};

namespace {

using Spring = contact::SpringDamper<double>;

/// 100^x for x from 0 to 1, with the same bits everywhere.
double hundred_to(double x) { return 1 / contact::detail::decay(4.605170185988092 * x); }

using Samples = std::array<double, samples>;

// [curves]
/// The curves from one time to another, of a mass that stays attached: its force may be a pull.
void sample(const Spring& spring, double from, double to, Samples& moment, Samples& force,
            Samples& velocity) {
  for (std::size_t i = 0; i < samples; ++i) {
    moment[i] = from + (to - from) * double(i) / double(samples - 1);
    const contact::PenaltyState<double> start{0, speed};
    const auto state = contact::damped_motion<double>(start, spring, mass, 0, moment[i]);
    force[i] = spring.stiffness * state.penetration + spring.damping * state.approach;
    velocity[i] = -state.approach;
  }
}
// [/curves]

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
  const Spring spring{out.stiffness, out.damping};
  const auto impact = contact::spring_impact(spring, mass, speed, rule);
  out.duration = impact.duration;
  out.max_depth = impact.max_depth;
  out.max_force = impact.max_force;
  out.left_overlap = impact.left_overlap;

  const auto duration = [&spring](ContactRelease end) {
    return std::min(contact::spring_impact(spring, mass, speed, end).duration, last_moment);
  };
  const double let_go = duration(ContactRelease::at_zero_force);
  const double apart = duration(ContactRelease::at_zero_penetration);
  sample(spring, 0, let_go, out.moment, out.force, out.velocity);
  out.pulls = in.ratio > 0 && apart > let_go ? 1 : 0;
  sample(spring, let_go, apart, out.pull_moment, out.pull_force, out.pull_velocity);

  contact::ImpactMoment<double> now{{speed * in.time, speed}};
  if (in.time >= 0) now = contact::impact_at(spring, mass, speed, in.time, rule);
  out.penetration = now.state.penetration;
  out.approach = now.state.approach;
  out.velocity_now = -now.state.approach;
  out.force_now = now.force;
  out.pulled = now.force < 0 ? 1 : 0;
}

/// The ball of the drawing as a ball in space, and the force on it that never pulls.
void as_ball(Output& out) {
  out.centre = {0, 0, radius - out.penetration};
  out.ball_velocity = {0, 0, out.velocity_now};
  out.ball_radius = radius;
  if (out.rigid == 1) return;
  const contact::PenaltyBall<double> ball{{out.centre, radius}, out.ball_velocity};
  const contact::Plane<double> ground{Vector(0, 0, 1), 0};
  const Spring spring{out.stiffness, out.damping};
  const auto push = contact::half_space_force(ball, ground, spring);
  out.touches = push.touching ? 1 : 0;
  out.push_vector = push.force;
  out.push = contact::contact_force(spring, out.penetration, out.approach);
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
  const bool by_force = rule == ContactRelease::at_zero_force;
  out.restitution = by_force ? out.at_zero_force : out.at_zero_penetration;
  out.impulse = mass * (1 + out.restitution) * speed;
  if (in.hardness == 1) {
    rigidly(in, out);
  } else {
    softly(in, rule, out);
  }
  const auto shape = contact::squash(radius, out.penetration, contact::SquashKeeps::area);
  out.half_width = shape.across;
  out.half_height = shape.along;
  as_ball(out);
  out.hard_bounce = out.duration <= 0.05 && out.restitution >= 0.8 && out.rigid == 0 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(hardness, ratio, time, release), Output,
       FIELDS(problem, rigid, stiffness, damping, at_zero_force, at_zero_penetration, restitution,
              impulse, duration, max_depth, max_force, left_overlap, moment, force, velocity, pulls,
              pull_moment, pull_force, pull_velocity, penetration, approach, half_width,
              half_height, force_now, velocity_now, centre, ball_velocity, ball_radius, touches,
              push, push_vector, pulled, hard_bounce))
