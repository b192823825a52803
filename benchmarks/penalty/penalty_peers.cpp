// Compares soft contacts with their closed form: a ball that falls on a plane, and a stack of ten
// balls, in the book's time steps, in ODE and in Bullet, with settings that mean the same spring
// and damper. usage:
//   penalty_peers [HEIGHTS]          each drop from so many heights from 1 m to 1.1 m
//   penalty_peers --write FOLDER     writes the scenes and the right answers, for mujoco_peer.py
#include <algorithm>
#include <cmath>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <contact/spring_stack.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "../comparison.hpp"
#include "closed_form.hpp"
#include "peers.hpp"

namespace {

using closed_form::Bounce;
using contact::PenaltyScheme;
using peers::Program;
using peers::Scene;

constexpr int balls = 10;
constexpr double seconds_of_a_drop = 1.25;
constexpr double seconds_of_a_stack = 60;

// ---------------------------------------------------------------------------- the book's programs

std::vector<double> drop_by(PenaltyScheme scheme, const Scene& scene, double height, int steps) {
  const auto spring = contact::spring_damper(scene.stiffness, scene.damping);
  contact::PenaltyState<double> now{-height, 0};
  std::vector<double> heights{height};
  for (int i = 0; i < steps; ++i) {
    now = contact::penalty_step(scheme, now, spring, scene.mass, scene.step, scene.gravity);
    heights.push_back(-now.penetration);
  }
  return heights;
}

/// A chain of contact_force() in steps of semi-implicit Euler.
std::vector<double> chain(const Scene& scene, int count, int steps) {
  const auto spring = contact::spring_damper(scene.stiffness, scene.damping);
  const auto n = static_cast<std::size_t>(count);
  std::vector<double> sunk(n), velocity(n), force(n + 1);
  for (int i = 0; i < steps; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double below = j > 0 ? sunk[j - 1] : 0;
      const double below_velocity = j > 0 ? velocity[j - 1] : 0;
      force[j] = contact::contact_force(spring, sunk[j] - below, velocity[j] - below_velocity);
    }
    for (std::size_t j = 0; j < n; ++j) {
      velocity[j] += scene.step * (scene.gravity + (force[j + 1] - force[j]) / scene.mass);
      sunk[j] += scene.step * velocity[j];
    }
  }
  return sunk;
}

/// The book's implicit step of a stack, which needs no damper.
std::vector<double> implicit_chain(const Scene& scene, int count, int steps) {
  const auto n = static_cast<std::size_t>(count);
  const auto stack = contact::spring_stack<double>(std::vector<double>(n, scene.mass),
                                                   std::vector<double>(n, scene.stiffness));
  auto now = contact::unloaded(stack);
  for (int i = 0; i < steps; ++i)
    now = contact::implicit_stack_step(stack, now, scene.step, scene.gravity);
  return now.displacement;
}

std::vector<Program> programs() {
  const auto scheme = [](const char* name, PenaltyScheme by) {
    return Program{name,
                   [by](const Scene& scene, double height, int steps) {
                     return drop_by(by, scene, height, steps);
                   },
                   {}};
  };
  std::vector<Program> all{
      scheme("Contact Hours, explicit Euler", PenaltyScheme::explicit_euler),
      scheme("Contact Hours, semi-implicit", PenaltyScheme::semi_implicit_euler),
      scheme("Contact Hours, implicit damper", PenaltyScheme::implicit_damper),
      scheme("Contact Hours, implicit Euler", PenaltyScheme::implicit_euler),
      scheme("Contact Hours, velocity Verlet", PenaltyScheme::velocity_verlet),
      scheme("Contact Hours, Runge-Kutta 4", PenaltyScheme::runge_kutta_4)};
  all[1].stack = chain;
  all[3].stack = implicit_chain;
#ifdef CONTACT_HAS_ODE
  for (const auto& program : peers::ode_programs()) all.push_back(program);
#endif
#ifdef CONTACT_HAS_BULLET
  for (const auto& program : peers::bullet_programs()) all.push_back(program);
#endif
  return all;
}

// --------------------------------------------------------------------------------------- scenes

struct Ground {
  const char* name;
  double stiffness, ratio;
};
constexpr Ground grounds[] = {{"soft ground without damper", 1e3, 0},
                              {"soft ground", 1e3, 0.2},
                              {"hard ground", 1e4, 0.2},
                              {"hard ground, critically damped", 1e4, 1},
                              {"stiff ground", 1e6, 0.2}};
struct Pace {
  const char* name;
  double step;
};
constexpr Pace paces[] = {
    {"1/60 s", 1.0 / 60}, {"1/240 s", 1.0 / 240}, {"1/1000 s", 1e-3}, {"1/10000 s", 1e-4}};

Scene scene_of(const Ground& ground, double step) {
  Scene scene;
  scene.stiffness = ground.stiffness;
  scene.damping = 2 * ground.ratio * std::sqrt(ground.stiffness * scene.mass);
  scene.step = step;
  return scene;
}
int steps_in(double seconds, double step) { return static_cast<int>(std::lround(seconds / step)); }
/// Long enough for a damped body to rest.
double seconds_to_rest(const Scene& scene) {
  return 80 * scene.mass / scene.damping + 80 * scene.damping / scene.stiffness;
}
/// Heights from 1 m to 1.1 m, spread by the golden ratio: no fall is a whole number of steps.
std::vector<double> heights_of(std::size_t count) {
  std::vector<double> heights;
  double share = 0;
  for (std::size_t i = 0; i < count; ++i) {
    share += 0.6180339887498949;
    if (share >= 1) share -= 1;
    heights.push_back(1 + 0.1 * share);
  }
  return heights;
}

// --------------------------------------------------------------------------------------- drops

/// Relative errors; NaN: not asked.
struct Errors {
  double height = 0, duration = 0, depth = 0;
  double rest = std::numeric_limits<double>::quiet_NaN();
  double time = 0;  ///< of a step, ns
};
/// Keeps the error that is farther from 0.
void keep(double& worst, double got, double right) {
  const double error = std::isfinite(got) ? got / right - 1 : 1e300;
  if (std::abs(error) > std::abs(worst)) worst = error;
}

Errors errors_of(const Program& program, const Scene& scene, const std::vector<double>& heights) {
  Errors errors;
  const int steps = steps_in(seconds_of_a_drop, scene.step);
  const double start = comparison::processor_time();
  std::vector<std::vector<double>> seen;
  for (const double height : heights) seen.push_back(program.drop(scene, height, steps));
  errors.time =
      (comparison::processor_time() - start) / steps / static_cast<double>(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const Bounce right = closed_form::bounce(scene, heights[i]);
    const Bounce got = closed_form::seen(scene, seen[i]);
    keep(errors.height, got.height, right.height);
    keep(errors.duration, got.duration, right.duration);
    keep(errors.depth, got.depth, right.depth);
  }
  if (scene.damping > 0) {
    const int rest = steps_in(seconds_to_rest(scene), scene.step);
    const double sag = scene.mass * scene.gravity / scene.stiffness;
    errors.rest = 0;
    keep(errors.rest, -program.drop(scene, 0, rest).back(), sag);
  }
  return errors;
}

void print_error(double error) {
  if (std::isnan(error)) {
    std::printf(" %10s", "-");
  } else if (std::abs(error) > 1e6) {
    std::printf(" %10s", "grows");
  } else {
    std::printf(" %+10.1e", error);
  }
}

/// The book's formula without gravity, which counts the contact only.
Errors errors_without_gravity(const Scene& scene, const std::vector<double>& heights) {
  Errors errors;
  for (const double height : heights) {
    const double v = std::sqrt(2 * scene.gravity * height);
    const auto impact = contact::spring_impact(
        contact::spring_damper(scene.stiffness, scene.damping), scene.mass, v);
    const Bounce right = closed_form::bounce(scene, height);
    const double up = impact.restitution * v;
    keep(errors.height, up * up / (2 * scene.gravity) - impact.left_overlap, right.height);
    keep(errors.duration, impact.duration + impact.left_overlap / up, right.duration);
    keep(errors.depth, impact.max_depth, right.depth);
  }
  return errors;
}

void compare_drops(const std::vector<Program>& all, const std::vector<double>& heights) {
  for (const Ground& ground : grounds) {
    for (const Pace& pace : paces) {
      const Scene scene = scene_of(ground, pace.step);
      std::printf("%s, steps of %s: k = %g N/m, damping ratio %g, %zu heights, relative errors\n",
                  ground.name, pace.name, ground.stiffness, ground.ratio, heights.size());
      std::printf("  %-34s %10s %10s %10s %10s %10s\n", "", "ns a step", "bounce", "duration",
                  "depth", "rest");
      const auto row = [](const std::string& name, const Errors& errors) {
        std::printf("  %-34s", name.c_str());
        if (errors.time > 0) {
          std::printf(" %10.0f", errors.time);
        } else {
          std::printf(" %10s", "-");
        }
        for (const double error : {errors.height, errors.duration, errors.depth, errors.rest})
          print_error(error);
        std::printf("\n");
      };
      for (const Program& program : all) {
        if (program.drop) row(program.name, errors_of(program, scene, heights));
      }
      row("closed form without gravity", errors_without_gravity(scene, heights));
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}

// ---------------------------------------------------------------------------- the step for 1 %

void compare_steps(const std::vector<Program>& all, const std::vector<double>& heights) {
  std::printf(
      "the longest step, of 1/60 s divided by powers of 2, from which on no shorter one has an "
      "error "
      "above 1 %% of the bounce, ms\n");
  std::printf("  %-34s", "");
  for (const Ground& ground : grounds) std::printf(" %8g/%-3g", ground.stiffness, ground.ratio);
  std::printf("\n");
  for (const Program& program : all) {
    if (!program.drop) continue;
    std::printf("  %-34s", program.name.c_str());
    for (const Ground& ground : grounds) {
      double found = 0;
      for (int i = 11; i >= 0; --i) {
        const Scene scene = scene_of(ground, std::ldexp(1.0 / 60, -i));
        double worst = 0;
        for (const double height : heights) {
          const auto seen = program.drop(scene, height, steps_in(seconds_of_a_drop, scene.step));
          keep(worst, closed_form::seen(scene, seen).height,
               closed_form::bounce(scene, height).height);
        }
        if (std::abs(worst) > 0.01) break;
        found = scene.step;
      }
      if (found > 0) {
        std::printf(" %12.4f", 1000 * found);
      } else {
        std::printf(" %12s", "-");
      }
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\n");
}

// ------------------------------------------------------------------------------ the same steps?

/// How far the heights of the other programs are from those of the book's implicit Euler, whose
/// steps ODE's are by its formulas.
void compare_steps_with_implicit_euler(const std::vector<Program>& all,
                                       const std::vector<double>& heights) {
  std::printf("largest difference from the book's implicit Euler after any step, all grounds, m\n");
  std::printf("  %-34s", "");
  for (const Pace& pace : paces) std::printf(" %10s", pace.name);
  std::printf("\n");
  for (const Program& program : all) {
    if (!program.drop || program.name.starts_with("Contact Hours")) continue;
    std::printf("  %-34s", program.name.c_str());
    for (const Pace& pace : paces) {
      double largest = 0;
      for (const Ground& ground : grounds) {
        const Scene scene = scene_of(ground, pace.step);
        for (const double height : heights) {
          const int steps = steps_in(seconds_of_a_drop, scene.step);
          const auto book = drop_by(PenaltyScheme::implicit_euler, scene, height, steps);
          const auto other = program.drop(scene, height, steps);
          for (std::size_t i = 0; i < book.size(); ++i)
            largest = std::max(largest, std::abs(book[i] - other[i]));
        }
      }
      std::printf(" %10.1e", largest);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\n");
}

// --------------------------------------------------------------------------------------- stacks

constexpr Ground stack_ground{"ten balls", 1e4, 0.25};
constexpr Pace stack_paces[] = {paces[0], paces[1], paces[2]};

void compare_stacks(const std::vector<Program>& all) {
  const Scene first = scene_of(stack_ground, 1);
  const double sag = first.mass * first.gravity / first.stiffness;
  std::printf(
      "ten balls on each other for %g s: k = %g N/m, damping ratio %g of one ball; sag of the top, "
      "%g m, relative errors\n",
      seconds_of_a_stack, stack_ground.stiffness, stack_ground.ratio,
      sag * balls * (balls + 1) / 2);
  std::printf("  %-34s", "");
  for (const Pace& pace : stack_paces) std::printf(" %10s", pace.name);
  std::printf("\n");
  for (const Program& program : all) {
    if (!program.stack) continue;
    std::printf("  %-34s", program.name.c_str());
    for (const Pace& pace : stack_paces) {
      const Scene scene = scene_of(stack_ground, pace.step);
      const auto sunk = program.stack(scene, balls, steps_in(seconds_of_a_stack, pace.step));
      double error = 0;
      keep(error, sunk.back(), sag * balls * (balls + 1) / 2);
      print_error(error);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\n");
}

// --------------------------------------------------------------------------------------- to a file

void write(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / "drops.tsv");
  file.precision(17);
  for (const Ground& ground : grounds) {
    for (const Pace& pace : paces) {
      const Scene scene = scene_of(ground, pace.step);
      for (const double height : heights_of(16)) {
        const Bounce right = closed_form::bounce(scene, height);
        file << ground.name << "\t" << pace.name << "\t" << scene.stiffness << "\t" << scene.damping
             << "\t" << scene.mass << "\t" << scene.radius << "\t" << scene.gravity << "\t"
             << scene.step << "\t" << steps_in(seconds_of_a_drop, scene.step) << "\t"
             << (scene.damping > 0 ? steps_in(seconds_to_rest(scene), scene.step) : 0) << "\t"
             << height << "\t" << right.height << "\t" << right.duration << "\t" << right.depth
             << "\n";
      }
    }
  }
  std::ofstream stacks(folder / "stacks.tsv");
  stacks.precision(17);
  for (const Pace& pace : stack_paces) {
    const Scene scene = scene_of(stack_ground, pace.step);
    stacks << pace.name << "\t" << scene.stiffness << "\t" << scene.damping << "\t" << scene.mass
           << "\t" << scene.radius << "\t" << scene.gravity << "\t" << scene.step << "\t"
           << steps_in(seconds_of_a_stack, pace.step) << "\t" << balls << "\n";
  }
  std::ofstream limits(folder / "limits.tsv");
  limits.precision(17);
  for (const Ground& ground : grounds) {
    const Scene scene = scene_of(ground, 1);
    if (scene.damping == 0) continue;
    limits << ground.name << "\t" << scene.stiffness << "\t" << scene.damping << "\t" << scene.mass
           << "\t" << scene.radius << "\t" << scene.gravity << "\t"
           << contact::step_limit(PenaltyScheme::semi_implicit_euler,
                                  contact::spring_damper(scene.stiffness, scene.damping),
                                  scene.mass)
           << "\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string(argv[1]) == "--write") {
    write(argv[2]);
    return 0;
  }
  const std::size_t count = comparison::number(argc, argv, 1, 16);
  const auto all = programs();
  compare_drops(all, heights_of(count));
  compare_steps(all, heights_of(std::min<std::size_t>(count, 8)));
  compare_steps_with_implicit_euler(all, heights_of(count));
  compare_stacks(all);
#ifdef CONTACT_HAS_ODE
  const auto messages = peers::ode_messages();
  std::printf("ODE reported internal errors of its exact solver: %zu, and other things: %zu\n",
              messages.internal_errors, messages.others);
#endif
  return 0;
}
