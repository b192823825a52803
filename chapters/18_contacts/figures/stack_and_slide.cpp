// Three scenes of many contacts: a stack of boxes in time steps with a given number of iterations,
// a box that slides to rest, and a row of balls resolved one pair after the other or all at once.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/collision_1d.hpp>
#include <contact/contact_solver.hpp>
#include <contact/cradle.hpp>
#include <contact/figure.hpp>
#include <cstddef>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;

constexpr std::size_t most_boxes = 10, most_balls = 7, stack_steps = 180, samples = 61;
constexpr double gravity = 9.8125, last_time = 3;             // m/s², s
constexpr double mass = 10, side = 0.5, stack_rate = 60;      // kg, m, 1/s
constexpr double ball_mass = 0.25, radius = 0.2, impact = 1;  // kg, m, s
constexpr double settled = 1e-9;                              // m/s
constexpr int most_iterations = 2000;

struct Input {
  double mode;         // 0 the stack, 1 the box that slides, 2 the row of balls
  double boxes;        // how many
  double iterations;   // in each step
  double warm;         // 1: each step starts with the impulses of the step before
  double ratio;        // mass of the highest box over that of the others
  double speed;        // of the box at the start, m/s
  double friction;     // μ
  double rate;         // steps per second of the box
  double balls;        // how many
  double moving;       // how many of them arrive together
  double restitution;  // of the balls
  double time;         // of what is drawn, s
};

/// Numbers of the scenes that are not chosen are 0.
struct Output {
  double problem;
  double boxes, side;
  // By box or by the contact below it, from the lowest, at the time: heights of the lower edges, m;
  // impulses of the step, and those that would carry what is above, N·s.
  std::array<double, most_boxes> lower, load, weight;
  std::array<double, stack_steps + 1>
      sunk;         // how far the highest box is too low after each step, m
  double sunk_now;  // m
  double residual;  // at the time, m/s
  double needed;  // iterations of one step from 0 to a residual of 1e-9 m/s; −1: more than 2,000
  double speed, friction;                           // of the box that slides
  double normal_impulse, friction_impulse;          // of the step at the time, N·s
  double position, velocity;                        // at the time, m and m/s
  std::array<double, samples> moment, path, exact;  // s; positions by steps and by formula, m
  double distance, by_mean;  // until the box is at rest: by the velocity after each step, and by
                             // the mean of those before and after, m
  double formula, duration;  // v² / (2 μ g), m, and v / (μ g), s
  double balls, moving, radius;
  // One pair after the other, and all at once: positions at the time and velocities afterwards.
  std::array<double, most_balls> one_by_one, at_once, one_position, once_position;
  double collisions;               // of pairs
  double one_energy, once_energy;  // over that before
  // Goals of questions.
  double sinks;   // the stack has sunk by more than 1 cm
  double warmed;  // at least eight boxes, at most ten iterations, and less than 1 cm after 3 s
  double differ;  // the two results of the row differ
};

namespace {

using Body = contact::RigidBody<double>;
using Contacts = std::vector<contact::BodyContact<double>>;
using Settings = contact::SolverSettings<double>;

const Vector up(0, 1, 0), nowhere = Vector::Zero();

Body block(double kilograms, const Vector& position, const Vector& velocity) {
  return contact::rigid_body_from_axes<double>(kilograms, Vector(1, 1, 1),
                                               contact::Matrix3<double>::Identity(), position,
                                               velocity, nowhere);
}

Body ground() { return contact::immovable<double>(nowhere, nowhere, nowhere); }

std::size_t whole(double x, double low, double high) {
  return static_cast<std::size_t>(std::clamp(std::round(x), low, high));
}

/// Boxes 1, 2, … on the ground, which is body 0.
std::vector<Body> stack_of(std::size_t n, double ratio) {
  std::vector<Body> bodies{ground()};
  for (std::size_t i = 0; i < n; ++i) {
    const double kilograms = i + 1 == n ? mass * ratio : mass;
    bodies.push_back(block(kilograms, up * (side * double(i)), nowhere));
  }
  return bodies;
}

/// One contact below the middle of each box; positions are those of the lower edges.
Contacts stack_contacts(const std::vector<Body>& bodies) {
  Contacts contacts;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Vector& at = bodies[i].position;
    const double below = i > 1 ? bodies[i - 1].position.y() + side : 0;
    const double room = -std::max(at.y() - below, 0.0) * stack_rate;
    contacts.push_back({int(i), int(i) - 1, at, up, 0, room});
  }
  return contacts;
}

void fall(std::vector<Body>& bodies, double time) {
  for (Body& body : bodies)
    if (body.inverse_mass > 0) body.velocity.y() -= gravity * time;
}

void stack(const Input& in, Output& out) {
  const std::size_t n = whole(in.boxes, 1, double(most_boxes));
  std::vector<Body> bodies = stack_of(n, in.ratio);
  const double h = 1 / stack_rate;
  double above = 0;
  for (std::size_t i = n; i-- > 0;) {
    above += bodies[i + 1].mass;
    out.weight[i] = above * gravity * h;
  }
  const auto shown = whole(in.time * stack_rate, 0, double(stack_steps));
  Settings settings;
  settings.iterations = int(whole(in.iterations, 1, 32));
  settings.tolerance = 0;
  std::vector<contact::ContactImpulse<double>> impulses;
  for (std::size_t s = 0; s <= stack_steps; ++s) {
    out.sunk[s] = side * double(n - 1) - bodies[n].position.y();
    if (s == shown) {
      out.sunk_now = out.sunk[s];
      for (std::size_t i = 0; i < n; ++i) out.lower[i] = bodies[i + 1].position.y();
    }
    if (s == stack_steps) break;
    // [stack-step]
    fall(bodies, h);
    if (in.warm < 0.5) impulses.clear();
    const auto solved = contact::solve_contacts(bodies, stack_contacts(bodies), impulses, settings);
    bodies = solved.bodies;
    impulses = solved.impulses;
    for (Body& body : bodies) body.position += body.velocity * h;
    // [/stack-step]
    if (s <= shown) {
      for (std::size_t i = 0; i < n; ++i) out.load[i] = solved.impulses[i].normal;
      out.residual = solved.report.residual;
    }
  }
  bodies = stack_of(n, in.ratio);
  fall(bodies, h);
  Settings to_the_end;
  to_the_end.iterations = most_iterations;
  to_the_end.tolerance = settled;
  const auto report =
      contact::solve_contacts(bodies, stack_contacts(bodies), {}, to_the_end).report;
  out.needed = report.residual <= settled * 1.01 ? report.iterations : -1;
  out.boxes = double(n);
  out.side = side;
  out.sinks = out.sunk_now > 0.01 ? 1 : 0;
  out.warmed = n >= 8 && settings.iterations <= 10 && out.sunk[stack_steps] < 0.01 ? 1 : 0;
}

void slide(const Input& in, Output& out) {
  const double h = 1 / in.rate, deceleration = in.friction * gravity;
  out.speed = in.speed;
  out.friction = in.friction;
  out.formula = in.speed * in.speed / (2 * deceleration);
  out.duration = in.speed / deceleration;
  std::vector<Body> bodies{ground(), block(mass, nowhere, Vector(in.speed, 0, 0))};
  std::size_t sample = 0;
  out.velocity = in.speed;
  bool rests = false;
  for (int s = 0; sample < samples || !rests; ++s) {
    const double before = bodies[1].velocity.x(), from = bodies[1].position.x(), now = s * h;
    // [slide-step]
    fall(bodies, h);
    const Contacts contacts{{1, 0, bodies[1].position, up, in.friction, 0}};
    const auto solved = contact::solve_contacts(bodies, contacts);
    bodies = solved.bodies;
    bodies[1].position.x() += bodies[1].velocity.x() * h;
    // [/slide-step]
    const double after = bodies[1].velocity.x(), to = bodies[1].position.x();
    const auto between = [&](double t) { return from + (to - from) * (t - now) / h; };
    for (; sample < samples; ++sample) {
      const double t = last_time * double(sample) / double(samples - 1);
      if (t > now + h) break;
      const double slides = std::min(t, out.duration);
      out.moment[sample] = t;
      out.path[sample] = between(t);
      out.exact[sample] = slides * (in.speed - deceleration * slides / 2);
    }
    if (in.time >= now && in.time <= now + h) {
      out.position = between(in.time);
      out.velocity = after;
      out.normal_impulse = solved.impulses[0].normal;
      out.friction_impulse = solved.impulses[0].tangential.x();
    }
    out.by_mean += (before + after) / 2 * h;
    if (!rests && !(after > 0)) {
      rests = true;
      out.distance = to;
    }
    if (now > 400) break;
  }
}

void row(const Input& in, Output& out) {
  const std::size_t n = whole(in.balls, 2, double(most_balls));
  const std::size_t k = whole(in.moving, 1, double(n - 1));
  std::vector<contact::LineBody<double>> line;
  std::vector<Body> bodies;
  Contacts contacts;
  for (std::size_t i = 0; i < n; ++i) {
    const double velocity = i < k ? 1 : 0;
    line.push_back(contact::line_body<double>(ball_mass, velocity));
    bodies.push_back(block(ball_mass, nowhere, Vector(velocity, 0, 0)));
    if (i == 0) continue;
    contact::BodyContact<double> c{int(i), int(i) - 1, nowhere, Vector(1, 0, 0), 0, 0};
    c.min_velocity = i == k ? in.restitution : 0;
    contacts.push_back(c);
  }
  // [row]
  const auto one_by_one =
      contact::collide_row(line, in.restitution, contact::PairOrder::left_to_right, 2000);
  const auto impulses = contact::complementary_impulses<double>(bodies, contacts);
  if (impulses) bodies = contact::after_normal_impulses(bodies, contacts, *impulses);
  // [/row]
  for (std::size_t i = 0; i < n; ++i) {
    const double place = 2 * radius * (double(i) - double(n - 1) / 2);
    const double t = in.time - impact, before = i < k ? t : 0;
    out.one_by_one[i] = one_by_one.velocities[i];
    out.at_once[i] = bodies[i].velocity.x();
    out.one_position[i] = place + (t < 0 ? before : out.one_by_one[i] * t);
    out.once_position[i] = place + (t < 0 ? before : out.at_once[i] * t);
    out.one_energy += out.one_by_one[i] * out.one_by_one[i] / double(k);
    out.once_energy += out.at_once[i] * out.at_once[i] / double(k);
    if (std::abs(out.one_by_one[i] - out.at_once[i]) > 1e-6) out.differ = 1;
  }
  out.balls = double(n);
  out.moving = double(k);
  out.radius = radius;
  out.collisions = one_by_one.collisions;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.ratio > 0) || !(in.speed > 0) || !(in.friction > 0) || !(in.rate > 0))
    out.problem = contact::figure::not_positive;
  if (in.ratio > 1e4 || in.speed > 10 || in.friction > 10 || in.rate > 1000 || in.restitution > 1) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.ratio < 1e-4 || in.speed < 1e-3 || in.friction < 0.01 ||
                           in.rate < 4 || in.restitution < 0)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;
  if (in.mode == 0) stack(in, out);
  if (in.mode == 1) slide(in, out);
  if (in.mode == 2) row(in, out);
  return out;
}

FIGURE(Input,
       FIELDS(mode, boxes, iterations, warm, ratio, speed, friction, rate, balls, moving,
              restitution, time),
       Output,
       FIELDS(problem, boxes, side, lower, load, weight, sunk, sunk_now, residual, needed, speed,
              friction, normal_impulse, friction_impulse, position, velocity, moment, path, exact,
              distance, by_mean, formula, duration, balls, moving, radius, one_by_one, at_once,
              one_position, once_position, collisions, one_energy, once_energy, sinks, warmed,
              differ))
