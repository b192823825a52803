// A body on a spring, drawn with its position to the right and its velocity upwards: the exact
// motion is a circle, the numerical one is not.
#include <algorithm>
#include <contact/figure.hpp>
#include <contact/spring_motion.hpp>

using Vector2 = Eigen::Matrix<double, 2, 1>;

struct Input {
  Vector2 start;      // position, m, and velocity divided by ω, m
  double step;        // h, s; ω is 1
  double integrator;  // 0 to 4, as Integrator
};

constexpr int points = 257;
constexpr double two_swings = 12.566370614359172;  // 4π

struct Output {
  double problem;
  std::array<double, points> positions, speed;  // after each step; the last is repeated
  std::array<double, 97> round_x, round_y;      // the exact motion, for one period
  double steps;                                 // in two periods
  double kept;                                  // energy after these, over that of the start
  double largest;                               // largest energy, over that of the start
  Vector2 last, truth;                          // numerical and exact state after these steps
  double off;                                   // distance of these, m
  double flies_away;  // goal: not explicit Euler, and a hundred times the energy
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.step > 0)) out.problem = contact::figure::not_positive;
  if (in.step > 100 || in.integrator > 4 || in.start.cwiseAbs().maxCoeff() > 1e50) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.step < 0.01 || in.integrator < 0 || in.start.norm() < 1e-50)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  const auto spring = contact::linear_spring(1.0);
  const auto integrator = static_cast<contact::Integrator>(static_cast<int>(in.integrator));
  const int steps = static_cast<int>(std::min(double{points - 1}, two_swings / in.step));
  contact::MotionState<double> now{in.start.x(), in.start.y()};
  const double energy = contact::spring_energy(spring, now);
  for (std::size_t i = 0; i < out.round_x.size(); ++i) {
    const double t = two_swings / 2 * static_cast<double>(i) / 96;
    const auto there = contact::spring_motion(spring, now, t);
    out.round_x[i] = there.position;
    out.round_y[i] = there.velocity;
  }
  for (int i = 0; i < points; ++i) {
    if (i > 0 && i <= steps) now = contact::motion_step(integrator, now, in.step, spring);
    out.positions[static_cast<std::size_t>(i)] = now.position;
    out.speed[static_cast<std::size_t>(i)] = now.velocity;
    out.largest = std::max(out.largest, contact::spring_energy(spring, now) / energy);
  }
  const auto truth = contact::spring_motion(spring, {in.start.x(), in.start.y()}, steps * in.step);
  out.steps = steps;
  out.kept = contact::spring_energy(spring, now) / energy;
  out.last = {now.position, now.velocity};
  out.truth = {truth.position, truth.velocity};
  out.off = (out.last - out.truth).norm();
  out.flies_away = integrator != contact::Integrator::explicit_euler && out.largest >= 100 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(start, step, integrator), Output,
       FIELDS(problem, positions, speed, round_x, round_y, steps, kept, largest, last, truth, off,
              flies_away))
