/// @file
/// Contacts with friction: right answers, and methods as they are often written.
///
/// One contact that acts through both centres of mass, or whose lever arms are parallel to its
/// normal: normal and friction are independent, and a sliding contact has one square root (class
/// (b)). Several contacts in the plane y = 0: each is open, sticks, or slides to one of two sides;
/// every combination is solved in fractions, and all that satisfy Coulomb's law must give the same
/// velocities (class (a)).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hard_problem.hpp"
#include "support/hard_cases.hpp"

namespace hard_friction {

using hard_problem::as;
using hard_problem::BodyContact;
using hard_problem::Case;
using hard_problem::iterate;
using hard_problem::Json;
using hard_problem::Problem;
using hard_problem::problem;
using hard_problem::Rational;
using hard_problem::right;
using hard_problem::RigidBody;
using hard_problem::Rule;
using hard_problem::V;
using hard_problem::Vector;
using oracle::Surd;

// ---------------------------------------------------------------------------------- one contact

inline Json exact_single(const Case& c) {
  const auto p = problem<Rational>(c);
  if (p.contacts.size() != 1) throw std::invalid_argument(c.name() + ": not one contact");
  const BodyContact<Rational>& at = p.contacts.front();
  const auto& a = p.bodies[static_cast<std::size_t>(at.a)];
  const auto& b = p.bodies[static_cast<std::size_t>(at.b)];
  for (const auto* body : {&a, &b}) {
    const Vector turned = body->inverse_inertia * (at.point - body->position).cross(at.normal);
    if (turned != Vector(0, 0, 0)) throw std::invalid_argument(c.name() + ": normal impulse turns");
  }
  const Vector relative = velocity_at(a, at.point) - velocity_at(b, at.point);
  const Vector slip = relative - at.normal * at.normal.dot(relative);
  const Rational opening = at.normal.dot(relative) - at.min_velocity;
  const Rational normal = opening < 0 ? Rational(-opening / (a.inverse_mass + b.inverse_mass)) : 0;
  const Rational square = slip.dot(slip);
  const Rational k =
      square > 0
          ? Rational(contact::inverse_effective_mass<Rational>(a, b, at.point, slip, slip) / square)
          : Rational(1);
  const Rational most = at.friction * normal;
  const bool sticks = square <= k * k * most * most;
  // The impulse of friction is slip times this factor.
  const Surd factor = sticks ? Surd{Rational(-1) / k, 0, 0} : Surd{0, -most / square, square};
  Json motion = Json::array();
  for (std::size_t i = 0; i < p.bodies.size(); ++i) {
    const auto& body = p.bodies[i];
    const Rational side = static_cast<int>(i) == at.a ? 1 : (static_cast<int>(i) == at.b ? -1 : 0);
    const Vector plain = body.velocity + at.normal * (side * normal * body.inverse_mass);
    const Vector turn =
        body.inverse_inertia * Vector((at.point - body.position).cross(slip)) * side;
    for (int x = 0; x < 3; ++x) {
      motion.push_back(hard_cases::hex(
          oracle::nearest(Surd(factor * Rational(side * body.inverse_mass * slip(x)) + plain(x)))));
    }
    for (int x = 0; x < 3; ++x)
      motion.push_back(
          hard_cases::hex(oracle::nearest(Surd(factor * turn(x) + body.angular_velocity(x)))));
  }
  return Json{{"class", "b"}, {"contact", sticks ? "sticks" : "slides"}, {"motion", motion}};
}

// -------------------------------------------------------------------------- contacts in the plane

enum class State { open, sticks, slides_up, slides_down, idle };

/// The velocities of the bodies for these states, if Coulomb's law holds: normals push or open,
/// sticking friction is inside the cone, sliding friction is opposite to the slip.
inline std::optional<std::vector<RigidBody<Rational>>> after_states(
    const Problem<Rational>& p, const std::vector<State>& states) {
  std::vector<BodyContact<Rational>> rows;  // the normal of each contact, then its tangent
  for (const BodyContact<Rational>& c : p.contacts) {
    rows.push_back(c);
    rows.push_back(c);
    rows.back().normal = Vector(c.normal.z(), 0, -c.normal.x());
    rows.back().min_velocity = 0;
  }
  const auto matrix = contact::inverse_effective_mass_matrix(p.bodies, rows);
  std::vector<Rational> constant;
  for (const auto& row : rows)
    constant.push_back(contact::contact_velocity(p.bodies, row) - row.min_velocity);
  // Unknowns: for each contact that is not open its normal impulse, and if it sticks its friction.
  std::vector<std::vector<Rational>> effect;  // of each unknown on all rows
  std::vector<std::size_t> wanted;            // rows whose velocity must vanish
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] == State::open) continue;
    const Rational mu = p.contacts[i].friction;
    const Rational share = states[i] == State::slides_up     ? Rational(-mu)
                           : states[i] == State::slides_down ? mu
                                                             : Rational(0);
    effect.emplace_back();
    for (std::size_t r = 0; r < rows.size(); ++r)
      effect.back().push_back(matrix[r][2 * i] + share * matrix[r][2 * i + 1]);
    wanted.push_back(2 * i);
    if (states[i] != State::sticks) continue;
    effect.emplace_back();
    for (std::size_t r = 0; r < rows.size(); ++r) effect.back().push_back(matrix[r][2 * i + 1]);
    wanted.push_back(2 * i + 1);
  }
  std::vector<std::vector<Rational>> system;
  std::vector<Rational> target;
  for (const std::size_t r : wanted) {
    system.emplace_back();
    for (const auto& column : effect) system.back().push_back(column[r]);
    target.push_back(-constant[r]);
  }
  const auto solved = contact::detail::solve_linear<Rational>(system, target);
  if (!solved) return std::nullopt;
  std::vector<Rational> impulses(rows.size(), Rational(0));
  std::size_t next = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] == State::open) continue;
    const Rational normal = (*solved)[next++];
    impulses[2 * i] = normal;
    const Rational most = p.contacts[i].friction * normal;
    if (states[i] == State::sticks) impulses[2 * i + 1] = (*solved)[next++];
    if (states[i] == State::slides_up) impulses[2 * i + 1] = -most;
    if (states[i] == State::slides_down) impulses[2 * i + 1] = most;
    if (normal < 0 || abs(impulses[2 * i + 1]) > most) return std::nullopt;
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    Rational opening = constant[2 * i];
    Rational slip = constant[2 * i + 1];
    for (std::size_t r = 0; r < rows.size(); ++r) {
      opening += matrix[2 * i][r] * impulses[r];
      slip += matrix[2 * i + 1][r] * impulses[r];
    }
    if (opening < 0 || (states[i] == State::slides_up && slip < 0) ||
        (states[i] == State::slides_down && slip > 0) || (states[i] == State::idle && slip != 0))
      return std::nullopt;
  }
  return contact::after_normal_impulses(p.bodies, rows, impulses);
}

inline Json exact_planar(const Case& c) {
  const auto p = problem<Rational>(c);
  constexpr std::array all{State::open, State::sticks, State::slides_up, State::slides_down,
                           State::idle};
  std::size_t combinations = 1;
  for (std::size_t i = 0; i < p.contacts.size(); ++i) combinations *= all.size();
  std::optional<Json> motion;
  for (std::size_t code = 0; code < combinations; ++code) {
    std::vector<State> states;
    std::size_t rest = code;
    for (std::size_t i = 0; i < p.contacts.size(); ++i) {
      states.push_back(all[rest % all.size()]);
      rest /= all.size();
    }
    const auto bodies = after_states(p, states);
    if (!bodies) continue;
    const Json found = hard_problem::motion_of(*bodies);
    if (motion && *motion != found) throw std::invalid_argument(c.name() + ": several solutions");
    motion = found;
  }
  if (!motion) throw std::invalid_argument(c.name() + ": no solution");
  return Json{{"class", "a"}, {"motion", *motion}};
}

// ----------------------------------------------------------------------------------------- methods

inline std::vector<double> last_normals(const Case& c) {
  return c.has("last") ? c.numbers("last") : std::vector<double>(c.numbers("friction").size(), 0.0);
}
/// Normal impulses as if there were no friction, then friction of at most μ times these.
inline std::vector<RigidBody<double>> normals_first(const Problem<double>& p) {
  Problem<double> smooth = p;
  for (auto& c : smooth.contacts) c.friction = 0;
  Rule rule{1000};
  rule.accumulate = true;
  std::vector<double> normals;
  smooth.bodies = iterate(smooth, rule, &normals);
  rule.normals = normals;
  rule.friction_only = true;
  return iterate(Problem<double>{smooth.bodies, p.contacts}, rule);
}

inline void add_methods(hard_cases::Runner& runner, const std::string& question) {
  const auto method = [&](const char* name, auto solve) {
    runner.method(question, name, [solve](const Case& c, const Json& answer) {
      return right<double>(c, solve(c), answer);
    });
  };
  const auto rule = [](int iterations, bool accumulate) {
    Rule made{iterations};
    made.accumulate = accumulate;
    return made;
  };
  method("one contact after the other",
         [=](const Case& c) { return iterate(problem<double>(c), rule(1, false)); });
  method("each change clamped, a hundred iterations",
         [=](const Case& c) { return iterate(problem<double>(c), rule(100, false)); });
  method("normals first, then friction",
         [](const Case& c) { return normals_first(problem<double>(c)); });
  method("friction by the last step's normals", [=](const Case& c) {
    Rule made = rule(1000, true);
    made.normals = last_normals(c);
    return iterate(problem<double>(c), made);
  });
  method("pyramid along the axes", [=](const Case& c) {
    Rule made = rule(1000, true);
    made.pyramid = true;
    return iterate(problem<double>(c), made);
  });
  method("masses in place of effective masses", [=](const Case& c) {
    Rule made = rule(100, true);
    made.by_mass = true;
    return iterate(problem<double>(c), made);
  });
  method("one point for the manifold", [=](const Case& c) {
    return iterate(hard_problem::with_mean_points(problem<double>(c)), rule(1000, true));
  });
  runner.method(question, "float, a thousand iterations", [=](const Case& c, const Json& answer) {
    return right<float>(c, iterate(problem<float>(c), rule(1000, true)), answer);
  });
  method("ten iterations",
         [](const Case& c) { return hard_problem::by_book(problem<double>(c), 10); });
  method("book", [](const Case& c) { return hard_problem::by_book(problem<double>(c), 200000); });
}

inline void add(hard_cases::Runner& runner) {
  runner.question("friction", exact_single);
  add_methods(runner, "friction");
  runner.question("planar friction", exact_planar);
  add_methods(runner, "planar friction");
}

}  // namespace hard_friction
