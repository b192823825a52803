// Compares boxes on a plane in the book, Bullet, ODE, Box2D 3, Box3D and Jolt where the right
// answer is known: at rest, ten on each other, a heavy one on a light one, sliding to rest, a rod
// that bounces on both ends, a scene that is symmetric.
// usage:
//   contact_peers [RUNS [SCENE]]    all scenes or one; times are medians of so many runs
//   contact_peers --write FILE      the scenes, for mujoco_peer.py
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/contact_world.hpp>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../comparison.hpp"
#include "peers.hpp"

namespace {

using peers::Motion;
using peers::Numbers;
using peers::Program;
using peers::Scene;
using V = contact::Vector3<double>;

// ----------------------------------------------------------------------------------- the book

V vector(const Numbers& x) { return {x[0], x[1], x[2]}; }
Numbers numbers(const V& x) { return {x.x(), x.y(), x.z()}; }

class BookWorld final : public peers::World {
 public:
  BookWorld(const Scene& scene, int iterations, bool jacobi, double relaxation) {
    settings_.gravity = {0, 0, -scene.gravity};
    settings_.step = scene.step;
    settings_.rest_speed = 0;
    settings_.solver.jacobi = jacobi;
    settings_.solver.relaxation = relaxation;
    if (iterations > 0) {
      settings_.solver.iterations = iterations;
      settings_.solver.tolerance = 0;
    }
    bodies_.push_back(contact::ground<double>({V::UnitZ(), 0.0}));
    bodies_.back().friction = scene.friction;
    for (const peers::Box& box : scene.boxes) {
      bodies_.push_back(contact::solid_box<double>(box.mass, vector(box.size), vector(box.centre)));
      bodies_.back().motion.velocity = vector(box.velocity);
      bodies_.back().friction = scene.friction;
      bodies_.back().restitution = scene.restitution;
    }
  }
  void step() override { contact::step_contacts(bodies_, memory_, settings_); }
  std::vector<Motion> read() const override {
    std::vector<Motion> all;
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      const auto& m = bodies_[i].motion;
      all.push_back({numbers(m.position), numbers(m.velocity), numbers(m.angular_velocity)});
    }
    return all;
  }

 private:
  std::vector<contact::ShapedBody<double>> bodies_;
  contact::StepMemory<double> memory_;
  contact::StepSettings<double> settings_;
};

std::vector<Program> programs() {
  const auto book = [](bool jacobi, double relaxation) {
    return [jacobi, relaxation](const Scene& scene, int iterations) {
      return std::make_unique<BookWorld>(scene, iterations, jacobi, relaxation);
    };
  };
  const double relaxation = contact::StepSettings<double>{}.solver.relaxation;
  std::vector<Program> all{{"Contact Hours", book(false, relaxation), "iterations"},
                           {"Contact Hours, relaxation 1", book(false, 1), "iterations"},
                           {"Contact Hours, Jacobi", book(true, 1), "iterations"}};
  const auto add = [&all](const std::vector<Program>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
#ifdef CONTACT_HAS_BULLET
  add(peers::bullet_programs());
#endif
#ifdef CONTACT_HAS_ODE
  add(peers::ode_programs());
#endif
#ifdef CONTACT_HAS_BOX2D_V3
  add(peers::box2d_v3_programs());
#endif
#ifdef CONTACT_HAS_BOX3D
  add(peers::box3d_programs());
#endif
#ifdef CONTACT_HAS_JOLT
  add(peers::jolt_programs());
#endif
  return all;
}

// ------------------------------------------------------------------------------------- scenes

Scene one_box() {
  Scene scene;
  scene.friction = 0.5;
  scene.boxes = {{1, {1, 1, 1}, {0, 0, 0.5}, {}}};
  return scene;
}
Scene ten_boxes() {
  Scene scene = one_box();
  scene.boxes.clear();
  for (int i = 0; i < 10; ++i) scene.boxes.push_back({1, {1, 1, 1}, {0, 0, 0.5 + i}, {}});
  return scene;
}
Scene heavy_on_light() {
  Scene scene = one_box();
  scene.boxes.push_back({1000, {1, 1, 1}, {0, 0, 1.5}, {}});
  return scene;
}
/// The box slides along x, or along (3, 4).
Scene sliding(bool oblique) {
  Scene scene = one_box();
  scene.boxes = {{1, {1, 1, 0.25}, {0, 0, 0.125}, {}}};
  scene.boxes[0].velocity = oblique ? Numbers{3, 4, 0} : Numbers{5, 0, 0};
  return scene;
}
/// A rod falls with 2 m/s, without gravity, and reaches the ground after a tenth of a second.
Scene falling_rod(double restitution) {
  Scene scene;
  scene.gravity = 0;
  scene.restitution = restitution;
  scene.boxes = {{1, {2, 0.2, 0.2}, {0, 0, 0.3}, {0, 0, -2}}};
  return scene;
}
/// A plank falls on two boxes, symmetric about x = 0.
Scene plank() {
  Scene scene;
  scene.friction = 0.5;
  scene.restitution = 0.25;
  scene.boxes = {{1, {0.5, 0.5, 1}, {-1, 0, 0.5}, {}},
                 {1, {0.5, 0.5, 1}, {1, 0, 0.5}, {}},
                 {2, {3, 0.5, 0.25}, {0, 0, 1.375}, {0, 0, -1.3}}};
  return scene;
}

std::vector<std::vector<Motion>> run(const Program& program, const Scene& scene, int steps,
                                     int iterations = 0) {
  const auto world = program.make(scene, iterations);
  std::vector<std::vector<Motion>> seen{world->read()};
  for (int i = 0; i < steps; ++i) {
    world->step();
    seen.push_back(world->read());
  }
  return seen;
}
int steps_in(double seconds, const Scene& scene) {
  return static_cast<int>(std::lround(seconds / scene.step));
}
double length(const Numbers& x) { return std::hypot(x[0], x[1], x[2]); }
/// Of the surface: a corner of a box of 1 m moves with at most √3/2 of the angular velocity.
double speed(const Motion& m) { return length(m.velocity) + 0.87 * length(m.angular_velocity); }

// ------------------------------------------------------------------------------------- tables

void rest(const std::vector<Program>& all, const char* title, const Scene& scene, double seconds) {
  std::printf("%s, %g s: it should not move\n  %-28s %11s %11s %11s %11s %11s\n", title, seconds,
              "", "sideways, m", "down, m", "after 10 s", "speed, m/s", "ns a step");
  for (const Program& program : all) {
    const int steps = steps_in(seconds, scene);
    const double start = comparison::processor_time();
    const auto seen = run(program, scene, steps);
    const double elapsed = (comparison::processor_time() - start) / steps;
    double sideways = 0, down = 0, late = 0, fastest = 0;
    const auto& tenth = seen[static_cast<std::size_t>(steps_in(std::min(10.0, seconds), scene))];
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      const Numbers& from = scene.boxes[i].centre;
      const Numbers& to = seen.back()[i].centre;
      sideways = std::max(sideways, std::hypot(to[0] - from[0], to[1] - from[1]));
      down = std::max(down, from[2] - to[2]);
      const Numbers& then = tenth[i].centre;
      late = std::max(late, length({to[0] - then[0], to[1] - then[1], to[2] - then[2]}));
      for (std::size_t s = seen.size() / 2; s < seen.size(); ++s)
        fastest = std::max(fastest, speed(seen[s][i]));
    }
    std::printf("  %-28s %11.1e %11.1e %11.1e %11.1e %11.0f\n", program.name.c_str(), sideways,
                down, late, fastest, elapsed);
    std::fflush(stdout);
  }
  std::printf("\n");
}

void slides(const std::vector<Program>& all) {
  std::printf(
      "a flat box slides to rest with 5 m/s, friction 0.5: v^2 / (2 mu g) = 2.5 m\n"
      "  %-28s %14s %14s %14s\n",
      "", "along x, off", "(3, 4), off", "beside it, m");
  for (const Program& program : all) {
    std::printf("  %-28s", program.name.c_str());
    for (const bool oblique : {false, true}) {
      if (oblique && program.plane_only) {
        std::printf(" %14s %14s", "-", "-");
        continue;
      }
      const Scene scene = sliding(oblique);
      const Numbers end = run(program, scene, steps_in(4, scene)).back()[0].centre;
      const double along = oblique ? 0.6 * end[0] + 0.8 * end[1] : end[0];
      std::printf(" %+14.2e", along - 2.5);
      if (oblique) std::printf(" %+14.2e", 0.6 * end[1] - 0.8 * end[0]);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\n");
}

void rods(const std::vector<Program>& all) {
  std::printf(
      "a rod falls flat with 2 m/s: afterwards 2 e m/s upwards, and no rotation\n"
      "  %-28s %14s %14s %14s %14s\n",
      "", "e = 1, off", "rad/s", "e = 1/2, off", "rad/s");
  for (const Program& program : all) {
    std::printf("  %-28s", program.name.c_str());
    for (const double e : {1.0, 0.5}) {
      const Scene scene = falling_rod(e);
      const Motion end = run(program, scene, steps_in(0.5, scene)).back()[0];
      std::printf(" %+14.2e %14.2e", end.velocity[2] - 2 * e, length(end.angular_velocity));
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\n");
}

void symmetry(const std::vector<Program>& all) {
  std::printf(
      "a plank falls on two boxes, 5 s: how far the right half is from the mirror image of the "
      "left, m\n");
  for (const Program& program : all) {
    const Scene scene = plank();
    double most = 0;
    for (const auto& now : run(program, scene, steps_in(5, scene))) {
      most = std::max({most, std::abs(now[0].centre[0] + now[1].centre[0]),
                       std::abs(now[0].centre[2] - now[1].centre[2]), std::abs(now[2].centre[0])});
    }
    std::printf("  %-28s %11.1e\n", program.name.c_str(), most);
    std::fflush(stdout);
  }
  std::printf("\n");
}

/// The largest speed after the first step of boxes that should stay at rest: nothing is known of
/// earlier impulses, so it is the residual of the solver. ODE's exact solver gives up on the
/// redundant contacts of two boxes with friction ("LCP internal error"), and they fall freely.
double first_residual(const Program& program, const Scene& scene, int iterations) {
  const auto world = program.make(scene, iterations);
  world->step();
  double most = 0;
  for (const Motion& m : world->read()) most = std::max(most, speed(m));
  return most;
}
/// The smallest power of 2 up to 16,384 with which the first step leaves no box faster, 0 for an
/// exact solver that does; nothing, if none does.
std::optional<int> iterations_for(const Program& program, const Scene& scene, double speed) {
  if (program.counts.empty()) {
    if (first_residual(program, scene, 0) <= speed) return 0;
    return std::nullopt;
  }
  for (int iterations = 1; iterations <= 16384; iterations *= 2)
    if (first_residual(program, scene, iterations) <= speed) return iterations;
  return std::nullopt;
}
/// Of the step alone, in microseconds: the world is made before. The second of two such steps is
/// timed, since the first one fetches what the program before has pushed out of the caches.
double time_of_first_step(const Program& program, const Scene& scene, int iterations) {
  double taken = 0;
  for (int i = 0; i < 2; ++i) {
    const auto world = program.make(scene, iterations);
    const double start = comparison::processor_time();
    world->step();
    taken = comparison::processor_time() - start;
  }
  return taken / 1000;
}
/// The programs take turns, so that a machine that grows slower does so for all of them.
void residuals(const std::vector<Program>& all, const char* title, const Scene& scene, int runs) {
  constexpr double wanted[] = {1e-2, 1e-3, 1e-6, 1e-9};
  struct Cell {
    std::optional<int> iterations;
    std::vector<double> times{};
  };
  std::vector<std::vector<Cell>> rows;
  for (const Program& program : all) {
    auto& row = rows.emplace_back();
    for (const double speed : wanted) row.push_back({iterations_for(program, scene, speed)});
  }
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < all.size(); ++i)
      for (Cell& cell : rows[i])
        if (cell.iterations)
          cell.times.push_back(time_of_first_step(all[i], scene, *cell.iterations));
  std::printf(
      "%s, first step: the number of iterations or substeps (tried: powers of 2, up to 16,384) "
      "until no box is faster, and the time of that step, us\n  %-28s",
      title, "");
  for (const double r : wanted) std::printf(" %7.0e m/s %9s", r, "us");
  std::printf("\n");
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::printf("  %-28s", all[i].name.c_str());
    for (Cell& cell : rows[i]) {
      if (!cell.iterations) {
        std::printf(" %11s %9s", "-", "-");
        continue;
      }
      std::printf(" %11d %9.1f", *cell.iterations, comparison::spread(cell.times).median);
    }
    std::printf("  %s\n", all[i].counts.empty() ? "exact solver" : all[i].counts.c_str());
  }
  std::printf("\n");
}

// ------------------------------------------------------------------------------------ to a file

void write(const char* name) {
  std::ofstream file(name);
  file.precision(17);
  const auto add = [&file](const char* scene_name, const Scene& scene, double seconds) {
    for (const peers::Box& box : scene.boxes) {
      file << scene_name << "\t" << scene.gravity << "\t" << scene.friction << "\t"
           << scene.restitution << "\t" << scene.step << "\t" << steps_in(seconds, scene) << "\t"
           << box.mass;
      for (const Numbers* list : {&box.size, &box.centre, &box.velocity})
        for (const double x : *list) file << "\t" << x;
      file << "\n";
    }
  };
  add("one", one_box(), 60);
  add("ten", ten_boxes(), 60);
  add("heavy", heavy_on_light(), 10);
  add("slides", sliding(false), 4);
  add("slides obliquely", sliding(true), 4);
  add("rod, e = 1", falling_rod(1), 0.5);
  add("rod, e = 1/2", falling_rod(0.5), 0.5);
  add("plank", plank(), 5);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string(argv[1]) == "--write") {
    write(argv[2]);
    return 0;
  }
  const int runs = static_cast<int>(comparison::number(argc, argv, 1, 9));
  const std::string only = argc > 2 ? argv[2] : "";
  const auto asked = [&only](const char* name) { return only.empty() || only == name; };
  const auto all = programs();
  if (asked("box")) rest(all, "a box on the plane", one_box(), 60);
  if (asked("stack")) rest(all, "ten boxes on each other", ten_boxes(), 60);
  if (asked("heavy")) rest(all, "1000 kg on 1 kg", heavy_on_light(), 10);
  if (asked("slides")) slides(all);
  if (asked("rod")) rods(all);
  if (asked("symmetry")) symmetry(all);
  if (asked("residual")) {
    residuals(all, "ten boxes", ten_boxes(), runs);
    residuals(all, "1000 kg on 1 kg", heavy_on_light(), runs);
  }
  return 0;
}
