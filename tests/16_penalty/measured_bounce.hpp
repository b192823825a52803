/// @file
/// Methods for the height to which a dropped ball bounces, as the ladder measures them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/fixed_step_bounce.hpp>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <cstddef>
#include <vector>

#include "support/ladder.hpp"

namespace measured_bounce {

using contact::PenaltyScheme;
using contact::StepRule;
using Spring = contact::SpringDamper<double>;

/// A ball that is dropped on a level floor.
struct Input {
  double mass = 1;          ///< kg
  double height = 1;        ///< of the drop, m
  double gravity = 9.8125;  ///< m/s²
  double restitution = 1;
  /// Contacts with that restitution which, without a damper, are 10 cm, 1 cm and 1 mm deep.
  std::array<Spring, 3> springs = {};

  double speed() const { return std::sqrt(2 * gravity * height); }
};

inline constexpr std::array<double, 3> depths{0.1, 0.01, 0.001};  ///< m
enum Depth : std::size_t { soft, medium, stiff };                 ///< which of them

/// Height of the bounce, as a share of that of the drop.
using Answer = double;

/// e², without rounding: e is a whole number of 256ths.
inline Answer truth(const Input& input) { return input.restitution * input.restitution; }

/// Wrong is a height that is off by more than a hundredth of the drop's; the error is that share.
inline ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.error = std::abs(got - right);
  verdict.wrong = !(verdict.error <= 0.01);
  return verdict;
}

/// How a penalty method is set.
struct Setting {
  const char* id;
  const char* title;
  PenaltyScheme scheme;
  Depth depth;
  double step;  ///< s
};

// [in-steps]
/// The ball in steps of one scheme, from the drop until it moves down again after its contact; 0 if
/// it is still in contact after ten times as long as the fall takes.
inline Answer in_steps(const Input& input, const Setting& setting) {
  const Spring& spring = input.springs[setting.depth];
  const auto max_steps = static_cast<int>(10 * input.speed() / input.gravity / setting.step);
  contact::PenaltyState<double> state{-input.height, 0};
  bool rises = false;
  for (int i = 0; i < max_steps; ++i) {
    state = contact::penalty_step(setting.scheme, state, spring, input.mass, setting.step,
                                  input.gravity);
    if (rises && state.approach >= 0) break;
    rises = state.approach < 0;
  }
  return std::max(0.0, -state.penetration) / input.height;
}
// [/in-steps]

/// The contact by its closed form, in which gravity is left out.
inline Answer closed_form(const Input& input, Depth depth) {
  const auto impact = contact::spring_impact(input.springs[depth], input.mass, input.speed());
  const double leaving = impact.restitution * input.speed();
  const double rise = leaving * leaving / (2 * input.gravity) - impact.left_overlap;
  return std::max(0.0, rise) / input.height;
}

inline contact::BouncingBall<double> rigid(const Input& input) {
  return {input.height, 0, input.gravity, input.restitution};
}

/// An impulse in fixed steps, until the ball moves down again.
inline Answer impulse_in_steps(const Input& input, StepRule rule, double step) {
  const auto max_steps = static_cast<int>(10 * input.speed() / input.gravity / step);
  const auto ball = rigid(input);
  contact::BounceState<double> state{input.height, 0, 0, false};
  double highest = 0;
  for (int i = 0; i < max_steps && state.bounces < 2; ++i) {
    state = contact::bounce_step(state, ball, step, rule);
    if (state.bounces == 1) highest = std::max(highest, state.height);
    if (state.bounces > 0 && !(state.velocity > 0)) break;
  }
  return highest / input.height;
}

/// An impulse at the exact time: the ball rises by v'² / (2 g).
inline Answer impulse(const Input& input) {
  return contact::peak_height(rigid(input), 1) / input.height;
}

/// From 2^low m to 2^high m, with a restitution in whole 256ths.
inline Input drop(generators::Random& random, int low, int high, double least, double most) {
  Input input;
  input.mass = std::abs(random.magnitude(-3, 3));
  input.height = std::abs(random.magnitude(low, high - 1));
  input.restitution = std::ldexp(std::round(std::ldexp(random.uniform(least, most), 8)), -8);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const double k =
        contact::stiffness_for_depth<double>(input.mass, input.speed(), input.gravity, depths[i]);
    input.springs[i] = contact::spring_for_restitution(k, input.mass, input.restitution);
  }
  return input;
}

/// The figure shows the same spring and scheme with the same ω₀ h, between two walls.
inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                             const Setting* setting) {
  ladder::Example example;
  example.facts = {ladder::number("mass, kg", input.mass), ladder::number("drop, m", input.height),
                   ladder::number("restitution", input.restitution),
                   ladder::number("bounce by this method, of the drop", got),
                   ladder::number("right, of the drop", right)};
  if (setting == nullptr) {
    example.note = "The figure does not have this method.";
    return example;
  }
  constexpr double stiffness = 1000, rate = 31.622776601683793;
  const Spring& spring = input.springs[setting->depth];
  const double h = contact::natural_frequency(spring, input.mass) * setting->step / rate;
  example.facts.push_back(ladder::number("k, N/m", spring.stiffness));
  example.facts.push_back(ladder::number("c, N s/m", spring.damping));
  if (h < 1e-4 || h > 0.2) {
    example.note = "In the figure these steps would be too short or too long to be seen.";
    return example;
  }
  example.figure = "step_and_energy";
  example.fields = {{"step", {h}},
                    {"stiffness", {stiffness}},
                    {"ratio", {contact::damping_ratio(spring, input.mass)}},
                    {"scheme", {double(static_cast<int>(setting->scheme))}},
                    {"phase", {0.5}}};
  example.note =
      "The figure shows a spring with as many steps in a contact and the same damping ratio, "
      "without gravity.";
  return example;
}

inline const std::vector<Setting>& settings() {
  using enum PenaltyScheme;
  constexpr double slow = 1.0 / 240, normal = 1e-3, fast = 1e-4, fastest = 1e-5;
  static const std::vector<Setting> all{
      {"soft-240", "10 cm deep, 1/240 s, semi-implicit Euler", semi_implicit_euler, soft, slow},
      {"medium-240", "1 cm deep, 1/240 s, semi-implicit Euler", semi_implicit_euler, medium, slow},
      {"medium-1000", "1 cm deep, 1/1,000 s, semi-implicit Euler", semi_implicit_euler, medium,
       normal},
      {"medium-10000", "1 cm deep, 1/10,000 s, semi-implicit Euler", semi_implicit_euler, medium,
       fast},
      {"stiff-10000", "1 mm deep, 1/10,000 s, semi-implicit Euler", semi_implicit_euler, stiff,
       fast},
      {"stiff-100000", "1 mm deep, 1/100,000 s, semi-implicit Euler", semi_implicit_euler, stiff,
       fastest},
      {"explicit-1000", "1 cm deep, 1/1,000 s, explicit Euler", explicit_euler, medium, normal},
      {"damper-1000", "1 cm deep, 1/1,000 s, implicit damper", implicit_damper, medium, normal},
      {"implicit-1000", "1 cm deep, 1/1,000 s, implicit Euler", implicit_euler, medium, normal},
      {"verlet-1000", "1 cm deep, 1/1,000 s, velocity Verlet", velocity_verlet, medium, normal},
      {"rk4-1000", "1 cm deep, 1/1,000 s, RK4", runge_kutta_4, medium, normal}};
  return all;
}

inline ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("How high does a ball bounce?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, int low, int high, double least,
                                double most) {
    ladder.family(
        id, title, [=](generators::Random& random) { return drop(random, low, high, least, most); },
        true);
  };
  family("bounces", "from 0.5 m to 4 m, e from 0.5 to 0.95", -1, 2, 0.5, 0.95);
  family("elastic", "the same without loss", -1, 2, 1, 1);
  family("dull", "the same, e from 0.05 to 0.3", -1, 2, 0.05, 0.3);
  family("low", "from 1.6 cm to 12.5 cm, e from 0.5 to 0.95", -6, -3, 0.5, 0.95);
  ladder.at_most(200);

  const auto rounded = [](const char* id, const char* title) {
    return ladder::Method{.id = id, .title = title, .scalar = "double", .exact = false};
  };
  for (const Setting& setting : settings()) {
    ladder.method(rounded(setting.id, setting.title),
                  [setting](const Input& input) { return in_steps(input, setting); });
  }
  ladder.method(rounded("closed-form", "1 cm deep, closed form without gravity"),
                [](const Input& input) { return closed_form(input, medium); });
  const auto impulses = [&](const char* id, const char* title, StepRule rule, double step) {
    ladder.method(rounded(id, title),
                  [=](const Input& input) { return impulse_in_steps(input, rule, step); });
  };
  impulses("loop-240", "impulse, 1/240 s, the lecture's loop", StepRule::new_velocity, 1.0 / 240);
  impulses("loop-10000", "impulse, 1/10,000 s, the lecture's loop", StepRule::new_velocity, 1e-4);
  ladder.method({.id = "impulse",
                 .title = "impulse at the exact time of impact",
                 .scalar = "double",
                 .exact = true},
                impulse);
  ladder.recommend("impulse");
  ladder.show(
      [](const Input& input, const Answer& got, const Answer& right, const ladder::Method& method) {
        for (const Setting& setting : settings()) {
          if (setting.id == method.id) return shown(input, got, right, &setting);
        }
        return shown(input, got, right, nullptr);
      });
  return ladder;
}

}  // namespace measured_bounce
