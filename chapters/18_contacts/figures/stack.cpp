// A stack of boxes in time steps with a given number of iterations: started from 0 in each step,
// and with the impulses of the step before.
#include <algorithm>
#include <array>
#include <contact/contact_solver.hpp>
#include <contact/figure.hpp>
#include <cstddef>
#include <vector>

#include "blocks.hpp"

constexpr std::size_t max_boxes = 10, stack_steps = 180;
constexpr double side = 0.5, step_rate = 60;  // m, 1/s
constexpr double goal = 0.01;                 // m
constexpr double settled = 1e-9;              // m/s
constexpr int max_iterations = 2000;

struct Input {
  double boxes;       // how many
  double iterations;  // in each step
  double warm;        // 1: each step starts with the impulses of the step before
  double ratio;       // mass of the highest box over that of the others
  double time;        // of what is drawn, s
};

struct Output {
  double problem;
  double boxes, side, goal;  // how many; m; how far the question lets the stack sink, m
  // By box or by the contact below it, from the lowest, at the time: heights of the lower edges, m;
  // impulses of the step, and those that would carry what is above, N·s.
  std::array<double, max_boxes> lower, load, weight;
  // How far the highest box is too low after each step, m.
  std::array<double, stack_steps + 1> sunk_from_zero, sunk_warm;
  double sunk_now;  // m
  double residual;  // of the step before the time, m/s
  double needed;    // iterations of one step from 0 to a residual of 1e-9 m/s; −1: over 2,000
  double warmed;    // goal of a question: at least eight boxes, at most ten iterations, and
                    // less than 1 cm after 3 s
};

namespace {

using blocks::Body;

constexpr double h = 1 / step_rate;

/// Boxes 1, 2, … on the ground, which is body 0.
std::vector<Body> stack_of(std::size_t n, double ratio) {
  std::vector<Body> bodies{blocks::ground()};
  for (std::size_t i = 0; i < n; ++i) {
    const double kilograms = i + 1 == n ? blocks::mass * ratio : blocks::mass;
    bodies.push_back(
        blocks::block(kilograms, blocks::up() * (side * double(i)), blocks::Vector::Zero()));
  }
  return bodies;
}

/// One contact below the middle of each box; positions are those of the lower edges.
blocks::Contacts stack_contacts(const std::vector<Body>& bodies) {
  blocks::Contacts contacts;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const blocks::Vector& at = bodies[i].position;
    const double below = i > 1 ? bodies[i - 1].position.z() + side : 0;
    const double room = -std::max(at.z() - below, 0.0) * step_rate;
    contacts.push_back({int(i), int(i) - 1, at, blocks::up(), 0, room});
  }
  return contacts;
}

/// What is drawn of a stack that starts its steps in one of the two ways.
struct Stack {
  std::array<double, stack_steps + 1> sunk{};
  std::array<double, max_boxes> lower{}, load{};
  double residual = 0;
};

Stack follow(const Input& in, bool warm) {
  Stack result;
  const std::size_t n = blocks::whole(in.boxes, 1, double(max_boxes));
  const std::size_t shown = blocks::whole(in.time * step_rate, 0, double(stack_steps));
  std::vector<Body> bodies = stack_of(n, in.ratio);
  blocks::Settings settings;
  settings.iterations = int(blocks::whole(in.iterations, 1, 32));
  settings.tolerance = 0;
  std::vector<contact::ContactImpulse<double>> impulses;
  for (std::size_t s = 0; s <= stack_steps; ++s) {
    result.sunk[s] = side * double(n - 1) - bodies[n].position.z();
    if (s == shown)
      for (std::size_t i = 0; i < n; ++i) result.lower[i] = bodies[i + 1].position.z();
    if (s == stack_steps) break;
    // [stack-step]
    blocks::fall(bodies, h);
    if (!warm) impulses.clear();
    const auto solved = contact::solve_contacts(bodies, stack_contacts(bodies), impulses, settings);
    bodies = solved.bodies;
    impulses = solved.impulses;
    for (Body& body : bodies) body.position += body.velocity * h;
    // [/stack-step]
    if (s > 0 && s >= shown) continue;
    for (std::size_t i = 0; i < n; ++i) result.load[i] = impulses[i].normal;
    result.residual = solved.report.residual;
  }
  return result;
}

/// How many iterations one step from 0 takes.
double needed_from_zero(std::size_t n, double ratio) {
  std::vector<Body> bodies = stack_of(n, ratio);
  blocks::fall(bodies, h);
  blocks::Settings settings;
  settings.iterations = max_iterations;
  settings.tolerance = settled;
  const auto report = contact::solve_contacts(bodies, stack_contacts(bodies), {}, settings).report;
  return report.residual <= settled * 1.01 ? report.iterations : -1;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.ratio > 0)) out.problem = contact::figure::not_positive;
  if (in.ratio > 1e4) out.problem = contact::figure::too_large;
  if (out.problem == 0 && in.ratio < 1e-4) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  const std::size_t n = blocks::whole(in.boxes, 1, double(max_boxes));
  const Stack from_zero = follow(in, false), warm = follow(in, true);
  const Stack& shown = in.warm < 0.5 ? from_zero : warm;
  out.boxes = double(n);
  out.side = side;
  out.goal = goal;
  out.lower = shown.lower;
  out.load = shown.load;
  out.residual = shown.residual;
  out.sunk_from_zero = from_zero.sunk;
  out.sunk_warm = warm.sunk;
  out.sunk_now = shown.sunk[blocks::whole(in.time * step_rate, 0, double(stack_steps))];
  double above = 0;
  for (std::size_t i = n; i-- > 0;) {
    above += i + 1 == n ? blocks::mass * in.ratio : blocks::mass;
    out.weight[i] = above * blocks::gravity * h;
  }
  out.needed = needed_from_zero(n, in.ratio);
  const bool few = blocks::whole(in.iterations, 1, 32) <= 10;
  out.warmed = n >= 8 && few && shown.sunk[stack_steps] < goal ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(boxes, iterations, warm, ratio, time), Output,
       FIELDS(problem, boxes, side, goal, lower, load, weight, sunk_from_zero, sunk_warm, sunk_now,
              residual, needed, warmed))
