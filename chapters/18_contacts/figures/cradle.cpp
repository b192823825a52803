// A row of equal balls in line, some of which arrive together at 1 m/s: resolved one pair after the
// other, and all contacts at once.
#include <array>
#include <cmath>
#include <contact/collision_1d.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/cradle.hpp>
#include <contact/figure.hpp>
#include <cstddef>
#include <vector>

#include "blocks.hpp"

constexpr std::size_t max_balls = 7;
constexpr double ball_mass = 0.25, radius = 0.2;  // kg, m
constexpr double impact = 1, last_time = 1.8;     // s
constexpr double least = 1e-6;                    // m/s: what counts as a motion
constexpr int max_collisions = 2000;

struct Input {
  double balls;        // how many
  double moving;       // how many of them arrive
  double restitution;  // of each pair
  double time;         // of what is drawn, s
};

/// Numbers of balls that there are not are 0.
struct Output {
  double problem;
  double balls, moving, radius;  // how many; how many arrive; m
  double impact;                 // time of the impact, s
  // One pair after the other, and all at once: velocities after the impact, m/s; positions, m, and
  // velocities, m/s, at the time.
  std::array<double, max_balls> one_after, once_after;
  std::array<double, max_balls> one_position, once_position, one_velocity, once_velocity;
  double one_leave, once_leave;    // balls that move after the impact
  double collisions;               // of pairs
  double one_energy, once_energy;  // over that before
  double differ;                   // whether the two results differ
};

Output compute(const Input& in) {
  Output out{};
  if (in.restitution > 1) out.problem = contact::figure::too_large;
  if (in.restitution < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  const std::size_t n = blocks::whole(in.balls, 2, double(max_balls));
  const std::size_t k = blocks::whole(in.moving, 1, double(n - 1));
  std::vector<contact::LineBody<double>> line;
  std::vector<blocks::Body> bodies;
  blocks::Contacts contacts;
  for (std::size_t i = 0; i < n; ++i) {
    const double velocity = i < k ? 1 : 0;
    line.push_back(contact::line_body<double>(ball_mass, velocity));
    bodies.push_back(
        blocks::block(ball_mass, blocks::Vector::Zero(), blocks::Vector(velocity, 0, 0)));
    if (i == 0) continue;
    // Only the pair that meets approaches before, and it has to separate.
    const double min_velocity = i == k ? in.restitution : 0;
    contacts.push_back(
        {int(i), int(i) - 1, blocks::Vector::Zero(), blocks::Vector(1, 0, 0), 0, min_velocity});
  }
  // [row]
  const auto one_by_one =
      contact::collide_row(line, in.restitution, contact::PairOrder::left_to_right, max_collisions);
  const auto impulses = contact::complementary_impulses<double>(bodies, contacts);
  if (impulses) bodies = contact::after_normal_impulses(bodies, contacts, *impulses);
  // [/row]
  out.balls = double(n);
  out.moving = double(k);
  out.radius = radius;
  out.impact = impact;
  out.collisions = one_by_one.collisions;
  const double t = std::fmin(in.time, last_time) - impact;
  for (std::size_t i = 0; i < n; ++i) {
    const double start = 2 * radius * (double(i) - double(n - 1) / 2);
    const double before = i < k ? 1 : 0;
    const double one = one_by_one.velocities[i], once = bodies[i].velocity.x();
    out.one_after[i] = one;
    out.once_after[i] = once;
    out.one_velocity[i] = t < 0 ? before : one;
    out.once_velocity[i] = t < 0 ? before : once;
    out.one_position[i] = start + out.one_velocity[i] * t;
    out.once_position[i] = start + out.once_velocity[i] * t;
    out.one_leave += std::abs(one) > least ? 1 : 0;
    out.once_leave += std::abs(once) > least ? 1 : 0;
    out.one_energy += one * one / double(k);
    out.once_energy += once * once / double(k);
    if (std::abs(one - once) > least) out.differ = 1;
  }
  return out;
}

FIGURE(Input, FIELDS(balls, moving, restitution, time), Output,
       FIELDS(problem, balls, moving, radius, impact, one_after, once_after, one_position,
              once_position, one_velocity, once_velocity, one_leave, once_leave, collisions,
              one_energy, once_energy, differ))
