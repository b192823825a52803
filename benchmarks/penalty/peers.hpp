/// @file
/// Other programs' soft contacts: a ball dropped on a plane, and a stack of balls, each behind one
/// function. Their headers stay in their own files.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace peers {

/// A contact spring with a damper, a ball on it, and a step.
struct Scene {
  double stiffness = 0;  ///< of the contact of a ball with the plane, or of two balls, N/m
  double damping = 0;    ///< of the same contact, N·s/m
  double mass = 1;       ///< kg
  double radius = 0.5;   ///< m
  double gravity = 10;   ///< m/s²
  double step = 0;       ///< s
};

/// What a program makes of a scene. An empty function: it has no such scene.
struct Program {
  std::string name;
  /// Height of the lowest point of a ball above the plane, m, at the start and after each step.
  std::function<std::vector<double>(const Scene&, double height, int steps)> drop;
  /// How far each of a number of balls on a vertical line has sunk after some steps, from the
  /// bottom up, m. At the start they touch without an overlap.
  std::function<std::vector<double>(const Scene&, int balls, int steps)> stack;
};

std::vector<Program> ode_programs();
std::vector<Program> bullet_programs();
/// What ODE has reported so far; it is not printed.
struct Messages {
  std::size_t internal_errors = 0;  ///< of the solver of dWorldStep, "LCP internal error"
  std::size_t others = 0;
};
Messages ode_messages();

}  // namespace peers
