/// @file
/// Methods for the impulses of a stack of boxes at rest, as the ladder measures them.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/contact_active_set.hpp>
#include <contact/contact_solver.hpp>
#include <cstddef>
#include <vector>

#include "support/ladder.hpp"

namespace measured_stack {

/// Boxes above each other after gravity has acted for a step, with the impulses of the step before.
struct Input {
  std::vector<contact::RigidBody<double>> bodies;      ///< the ground, then the boxes from below
  std::vector<contact::BodyContact<double>> contacts;  ///< below each box
  std::vector<contact::ContactImpulse<double>> before;
  double speed = 1;  ///< that gravity has given, m/s
};

/// The largest speed after the impulses, over the one that gravity has given. At rest it is 0.
using Answer = double;

inline Answer truth(const Input&) { return 0; }

/// Wrong is a box that moves with more than a hundredth of the speed that gravity gives it in a
/// step.
inline ladder::Verdict judge(const Answer& got, const Answer&) {
  ladder::Verdict verdict;
  verdict.error = got;
  verdict.wrong = !(got <= 0.01);
  return verdict;
}

inline Answer fastest(const Input& input, const std::vector<contact::RigidBody<double>>& bodies) {
  double most = 0;
  for (const auto& body : bodies) most = std::max(most, std::abs(body.velocity.z()));
  return most / input.speed;
}

inline Answer iterated(const Input& input, int iterations, bool warm, double relaxation,
                       bool jacobi = false) {
  contact::SolverSettings<double> settings;
  settings.iterations = iterations;
  settings.relaxation = relaxation;
  settings.jacobi = jacobi;
  const std::vector<contact::ContactImpulse<double>> none;
  return fastest(input, contact::solve_contacts(input.bodies, input.contacts,
                                                warm ? input.before : none, settings)
                            .bodies);
}

/// The active-set solve, after some iterations from 0.
inline Answer active_set(const Input& input, int iterations) {
  contact::SolverSettings<double> settings;
  settings.iterations = iterations;
  const auto start = contact::solve_contacts(input.bodies, input.contacts, {}, settings);
  const auto solved = contact::solve_active_set(input.bodies, input.contacts, start.impulses);
  return fastest(input, solved ? solved->bodies : start.bodies);
}

// [from-above]
/// For a stack alone, without iterations: each contact carries all boxes above it.
inline Answer from_above(const Input& input) {
  std::vector<double> impulses(input.contacts.size(), 0);
  double above = 0;
  for (std::size_t i = input.contacts.size(); i-- > 0;) {
    above += input.bodies[i + 1].mass;
    impulses[i] = above * input.speed;
  }
  return fastest(input, contact::after_normal_impulses(input.bodies, input.contacts, impulses));
}
// [/from-above]

/// @param heavy the mass of the highest box over that of the others
inline Input stack(generators::Random& random, int boxes, double heavy) {
  using Vector = contact::Vector3<double>;
  const Vector zero = Vector::Zero();
  Input input;
  input.speed = 0.1635;
  const double kilograms = random.uniform(1, 10);
  input.bodies.push_back(contact::immovable<double>(zero, zero, zero));
  std::vector<double> masses;
  for (int i = 0; i < boxes; ++i) {
    const double size = random.uniform(0.9, 1.1);
    masses.push_back(kilograms * size * (i + 1 == boxes ? heavy : 1));
    const Vector at(0, 0, i + 0.5);
    input.bodies.push_back(contact::rigid_body_from_axes<double>(
        masses.back(), Vector(1, 1, 1), contact::Matrix3<double>::Identity(), at,
        Vector(0, 0, -input.speed), zero));
    input.contacts.push_back({i + 1, i, Vector(0, 0, i), Vector(0, 0, 1), 0, 0});
  }
  // In the step before, the highest box was a tenth lighter: something has been put on it.
  input.before.resize(masses.size());
  double above = -0.1 * masses.back();
  for (std::size_t i = masses.size(); i-- > 0;) {
    above += masses[i];
    input.before[i].normal = above * input.speed;
  }
  return input;
}

inline ladder::Example shown(const Input& input, const Answer& got, bool warm, int iterations) {
  ladder::Example example;
  const auto boxes = static_cast<double>(input.contacts.size());
  const double ratio = input.bodies.back().mass / input.bodies[1].mass;
  example.facts = {ladder::number("boxes", boxes),
                   ladder::number("mass of the highest over the lowest", ratio),
                   ladder::number("largest speed by this method, of that by gravity", got)};
  if (iterations == 0 || iterations > 32 || boxes > 10) {
    example.note = "The figure has at most 10 boxes and 32 iterations of Gauss-Seidel.";
    return example;
  }
  example.figure = "stack";
  example.fields = {{"boxes", {boxes}},
                    {"iterations", {double(iterations)}},
                    {"warm", {warm ? 1.0 : 0.0}},
                    {"ratio", {ratio}},
                    {"time", {1}}};
  example.note = "The figure shows as many boxes, of which all but the highest are equal.";
  return example;
}

inline ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("How many iterations does a stack need?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, int boxes, double heavy) {
    ladder.family(
        id, title, [=](generators::Random& random) { return stack(random, boxes, heavy); }, true);
  };
  family("three", "3 boxes", 3, 1);
  family("ten", "10 boxes", 10, 1);
  family("thirty", "30 boxes", 30, 1);
  family("heavy-top", "10 boxes, the highest 100 times as heavy", 10, 100);
  ladder.at_most(20);

  struct Setting {
    const char* id;
    const char* title;
    int iterations;
    bool warm;
    double relaxation;
  };
  static const std::vector<Setting> settings{
      {"stack-4", "Gauss-Seidel from 0, 4 iterations", 4, false, 1},
      {"stack-16", "Gauss-Seidel from 0, 16 iterations", 16, false, 1},
      {"stack-64", "Gauss-Seidel from 0, 64 iterations", 64, false, 1},
      {"stack-256", "Gauss-Seidel from 0, 256 iterations", 256, false, 1},
      {"stack-1024", "Gauss-Seidel from 0, 1,024 iterations", 1024, false, 1},
      {"relaxed-64", "over-relaxed by 1.8, 64 iterations", 64, false, 1.8},
      {"relaxed-256", "over-relaxed by 1.8, 256 iterations", 256, false, 1.8},
      {"warm-4", "warm start, 4 iterations", 4, true, 1},
      {"warm-16", "warm start, 16 iterations", 16, true, 1},
      {"warm-relaxed-64", "warm start, over-relaxed by 1.8, 64 iterations", 64, true, 1.8}};
  const auto in_double = [](const char* id, const char* title) {
    return ladder::Method{.id = id, .title = title, .scalar = "double", .exact = false};
  };
  for (const Setting& s : settings) {
    ladder.method(in_double(s.id, s.title), [s](const Input& input) {
      return iterated(input, s.iterations, s.warm, s.relaxation);
    });
  }
  ladder.method(in_double("stack-jacobi-256", "Jacobi from 0, 256 iterations"),
                [](const Input& input) { return iterated(input, 256, false, 1, true); });
  ladder.method(in_double("active-set-4", "4 iterations, then the active-set solve"),
                [](const Input& input) { return active_set(input, 4); });
  ladder.method(in_double("from-above", "weights added from above"), from_above);
  ladder.recommend("active-set-4");
  ladder.show(
      [](const Input& input, const Answer& got, const Answer&, const ladder::Method& method) {
        for (const Setting& s : settings) {
          if (s.id == method.id && s.relaxation == 1)
            return shown(input, got, s.warm, s.iterations);
        }
        return shown(input, got, false, 0);
      });
  return ladder;
}

}  // namespace measured_stack
