/// @file
/// The right answers: a ball that falls on a spring with a damper, under gravity, until the contact
/// would pull.
///
/// The motion is that of a linear equation, x″ = g − (c x′ + k x) / m. Its power series is summed
/// until nothing changes, over times so short that the terms decrease; the ends of the contact are
/// bisected. The book's closed form is not used, so it can be compared.
#pragma once

#include <algorithm>
#include <cmath>

#include "peers.hpp"

namespace closed_form {

/// Penetration, m, and speed of approach, m/s.
struct State {
  double x = 0, v = 0;
};

/// The state after a time t, at most `short_time`, by the power series.
inline State after(const peers::Scene& scene, const State& start, double t) {
  const double square = scene.stiffness / scene.mass;
  const double twice = scene.damping / scene.mass;
  State sum = start;
  double x = start.x, v = start.v;  // x⁽ⁿ⁾ tⁿ / n! and x⁽ⁿ⁺¹⁾ tⁿ / n!
  for (int n = 1; n <= 40; ++n) {
    const double load = n == 1 ? scene.gravity : 0;
    const double next = (load - square * x - twice * v) * t / n;
    x = v * t / n;
    v = next;
    sum.x += x;
    sum.v += v;
  }
  return sum;
}
inline double short_time(const peers::Scene& scene) {
  return 0.25 / (std::sqrt(scene.stiffness / scene.mass) + scene.damping / scene.mass);
}

/// The state at which `ended` first becomes true, with its time added to `t`.
template <class Ended>
State until(const peers::Scene& scene, State state, double& t, Ended ended) {
  const double h = short_time(scene);
  State next = after(scene, state, h);
  while (!ended(next)) {
    state = next;
    t += h;
    next = after(scene, state, h);
  }
  double low = 0, high = h;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (ended(after(scene, state, middle)) ? high : low) = middle;
  }
  t += high;
  return after(scene, state, high);
}

/// What is compared.
struct Bounce {
  double height = 0;    ///< of the lowest point at the top of the flight after the contact, m
  double duration = 0;  ///< of the overlap, s
  double depth = 0;     ///< greatest penetration, m
};

/// A drop from a height. A contact that ends at zero force leaves an overlap, which opens in free
/// flight; that counts as overlap.
inline Bounce bounce(const peers::Scene& scene, double height) {
  const double g = scene.gravity;
  const auto force = [&](const State& s) { return scene.stiffness * s.x + scene.damping * s.v; };
  double t = 0;
  State state{0, std::sqrt(2 * g * height)};
  state = until(scene, state, t, [](const State& s) { return s.v <= 0; });
  Bounce result;
  result.depth = state.x;
  // Of a body that never leaves, the motion is followed for a while only.
  const double patience = t + 1000 * short_time(scene);
  state = until(scene, state, t, [&](const State& s) { return force(s) <= 0 || t > patience; });
  const double up = -state.v;
  const double rise = up * up / (2 * g) - state.x;
  if (up <= 0 || rise < 0) return result;
  result.height = rise;
  result.duration = t + (up - std::sqrt(std::max(0.0, up * up - 2 * g * state.x))) / g;
  return result;
}

/// The same from heights after each step: in between, a straight line.
inline Bounce seen(const peers::Scene& scene, const std::vector<double>& heights) {
  const std::size_t n = heights.size();
  const auto crossing = [&](std::size_t i) {  // between i − 1 and i, in steps
    return static_cast<double>(i - 1) + heights[i - 1] / (heights[i - 1] - heights[i]);
  };
  Bounce result;
  std::size_t i = 1;
  while (i < n && heights[i] > 0) ++i;
  if (i == n) return result;
  const double touch = crossing(i);
  for (; i < n && heights[i] <= 0; ++i) result.depth = std::max(result.depth, -heights[i]);
  if (i == n) return result;
  result.duration = (crossing(i) - touch) * scene.step;
  for (; i < n && heights[i] > 0; ++i) result.height = std::max(result.height, heights[i]);
  return result;
}

}  // namespace closed_form
