// Scenes whose truth is known, in the book and in other programs. usage: scene_peers [part] [runs]
// with part one of balls, plane, drop, shots, pairs, stack; without, all.
//
// Times are processor times of one thread, which a neighbour on the same machine lengthens less
// than it does the time on the clock. The programs take their runs in turns. Of each step the
// median of the runs counts; then the median over the steps is shown, their mean, and the worst.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "box_pairs.hpp"
#include "programs.hpp"
#include "summary.hpp"

namespace {

using scene_programs::Balls;
using scene_programs::Motion;
using scene_programs::Run;
using scene_programs::Stack;

struct Program {
  const char* name;
  std::unique_ptr<Run> (*balls)(const Balls&);
  std::unique_ptr<Run> (*stack)(const Stack&);
  bool plane;    ///< moves in the plane
  bool space;    ///< moves in space
  bool bullets;  ///< has continuous detection, as an option
};

std::vector<Program> programs() {
  std::vector<Program> all;
#ifdef CONTACT_HAS_BOOK
  all.push_back({"Contact Hours", scene_programs::book, scene_programs::book, true, true, false});
#endif
#ifdef CONTACT_HAS_BULLET
  all.push_back({"Bullet", scene_programs::bullet, scene_programs::bullet, false, true, true});
#endif
#ifdef CONTACT_HAS_ODE
  all.push_back({"ODE", scene_programs::ode, scene_programs::ode, false, true, false});
#endif
#ifdef CONTACT_HAS_BOX2D
  all.push_back({"Box2D", scene_programs::box2d, scene_programs::box2d, true, false, true});
#endif
  return all;
}

constexpr double kStep = 1.0 / 60;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// splitmix64: the same numbers on every machine.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double next(double low, double high) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * (static_cast<double>(z >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

/// n balls on a jittered lattice of spacing 1.2 in a box 1.5 times as high.
Balls lattice(std::size_t n, int dimension) {
  Balls scene;
  scene.dimension = dimension;
  std::size_t side = 1;
  while ((dimension == 3 ? side * side * side : side * side) < n) ++side;
  Numbers numbers(6);
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<std::size_t, 3> place{i % side, dimension == 3 ? i / side % side : 0,
                                           dimension == 3 ? i / side / side : i / side};
    Motion motion;
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (dimension == 2 && k == 1) continue;
      motion.place[k] = (static_cast<double>(place[k]) + 0.5) * 1.2 + numbers.next(-0.09, 0.09);
    }
    do {
      square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        motion.velocity[k] = dimension == 2 && k == 1 ? 0 : numbers.next(-3, 3);
        square += motion.velocity[k] * motion.velocity[k];
      }
    } while (square > 9);
    scene.balls.push_back(motion);
  }
  const double edge = static_cast<double>(side) * 1.2;
  for (std::size_t k = 0; k < 3; ++k) {
    if (dimension == 2 && k == 1) continue;
    scene_programs::Wall low;
    low.normal[k] = 1;
    scene_programs::Wall high;
    high.normal[k] = -1;
    high.offset = -(k == 2 ? 1.5 : 1) * edge;
    scene.walls.push_back(low);
    scene.walls.push_back(high);
  }
  return scene;
}

/// Kinetic energy, and that of weight over the ground, of balls of 1 kg. J
double energy(const std::vector<Motion>& balls, double gravity) {
  double sum = 0;
  for (const Motion& ball : balls) {
    double square = 0;
    for (const double v : ball.velocity) square += v * v;
    sum += square / 2 + gravity * ball.place[2];
  }
  return sum;
}

/// The largest overlap of a ball with a ball or a wall, m; by cells as wide as a ball.
double largest_overlap(const Balls& scene, const std::vector<Motion>& balls) {
  const double width = 2 * scene.radius;
  using Cell = std::array<long long, 3>;
  std::vector<std::pair<Cell, std::size_t>> cells;
  double worst = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<long long>(std::floor(balls[i].place[k] / width));
    cells.emplace_back(cell, i);
    for (const scene_programs::Wall& wall : scene.walls) {
      double distance = -wall.offset;
      for (std::size_t k = 0; k < 3; ++k) distance += wall.normal[k] * balls[i].place[k];
      worst = std::max(worst, scene.radius - distance);
    }
  }
  std::sort(cells.begin(), cells.end());
  for (const auto& [cell, i] : cells) {
    for (long long near = 0; near < 27; ++near) {
      const Cell other{cell[0] + near % 3 - 1, cell[1] + near / 3 % 3 - 1, cell[2] + near / 9 - 1};
      auto at = std::lower_bound(cells.begin(), cells.end(), std::pair{other, std::size_t{0}});
      for (; at != cells.end() && at->first == other; ++at) {
        if (at->second <= i) continue;
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double d = balls[i].place[k] - balls[at->second].place[k];
          square += d * d;
        }
        worst = std::max(worst, width - std::sqrt(square));
      }
    }
  }
  return worst;
}

// ---------------------------------------------------------------- elastic balls in a box

void elastic(const std::vector<Program>& all, std::size_t n, int dimension, int wanted_runs,
             Summary& summary) {
  constexpr std::size_t steps = 100;
  const int runs = n < 10000 ? wanted_runs : (wanted_runs + 1) / 2;  // a run is long enough there
  const Balls scene = lattice(n, dimension);
  std::vector<Program> able;
  for (const Program& program : all)
    if (dimension == 3 ? program.space : program.plane) able.push_back(program);
  std::vector<std::vector<std::vector<double>>> times(able.size(),
                                                      std::vector<std::vector<double>>(steps));
  std::vector<double> gain(able.size());
  std::vector<double> overlap(able.size());
  const double before = energy(scene.balls, scene.gravity);
  for (int round = 0; round < runs; ++round) {
    for (std::size_t p = 0; p < able.size(); ++p) {
      const auto run = able[p].balls(scene);
      for (std::size_t step = 0; step < steps; ++step) {
        const double start = processor_seconds();
        run->step(kStep);
        times[p][step].push_back(1000 * (processor_seconds() - start));
        if (round == 0) overlap[p] = std::max(overlap[p], largest_overlap(scene, run->read()));
      }
      overlap[p] = std::max(overlap[p], run->overlap_between_steps());
      gain[p] = energy(run->read(), scene.gravity) / before - 1;
    }
  }
  std::printf(
      "%zu elastic %s, 100 steps of 1/60 s, medians of %d runs, ms of processor a step\n"
      "  %-14s %9s %9s %9s %15s %15s\n",
      n, dimension == 3 ? "balls" : "discs in the plane", runs, "", "median", "mean", "worst",
      "energy change", "largest overlap");
  for (std::size_t p = 0; p < able.size(); ++p) {
    std::vector<double> step_times;
    for (const auto& of_step : times[p]) step_times.push_back(median(of_step));
    double sum = 0;
    for (const double t : step_times) sum += t;
    std::printf("  %-14s %9.3f %9.3f %9.3f %+15.1e %15.1e\n", able[p].name, median(step_times),
                sum / static_cast<double>(steps),
                *std::max_element(step_times.begin(), step_times.end()), gain[p], overlap[p]);
    const std::string these = std::to_string(n) + (dimension == 3 ? " balls" : " discs");
    summary.add(these + ", ms a step", able[p].name, "%.3f", median(step_times));
    summary.add("  " + these + ", worst step, ms", able[p].name, "%.3f",
                *std::max_element(step_times.begin(), step_times.end()));
    summary.add("  " + these + ", energy gained", able[p].name, "%+.1e", gain[p]);
    summary.add("  " + these + ", overlap, m", able[p].name, "%.1e", overlap[p]);
  }
  std::printf("\n");
}

// ---------------------------------------------------------------- one ball that never stops

void drop(const std::vector<Program>& all, Summary& summary) {
  std::printf(
      "a ball dropped from 10 m, e = 1: how high it comes after 60 s, m, and how far that is "
      "off\n");
  for (const Program& program : all) {
    Balls scene;
    scene.dimension = program.space ? 3 : 2;
    scene.walls.push_back({{0, 0, 1}, 0});
    scene.balls.push_back({{0, 0, 10.5}, {}});
    const auto run = program.balls(scene);
    for (int step = 0; step < 3600; ++step) run->step(kStep);
    const Motion ball = run->read()[0];
    const double apex =
        ball.place[2] - scene.radius + ball.velocity[2] * ball.velocity[2] / (2 * scene.gravity);
    std::printf("  %-14s %15.9f %+10.1e\n", program.name, apex, apex - 10);
    summary.add("a drop of 10 m: off after 60 s, m", program.name, "%+.1e", apex - 10);
  }
  std::printf("\n");
}

// ---------------------------------------------------------------- bullets and a thin wall

void shots(const std::vector<Program>& all, Summary& summary) {
  constexpr int count = 1000;
  std::printf(
      "%d shots of 20 to 100 m/s at a plate of 0.02 m, ball of radius 0.02 m, no gravity, "
      "2 s\n  %-32s %13s %28s\n",
      count, "", "went through", "worst error of the others, m");
  for (const Program& program : all) {
    for (const bool bullets : {false, true}) {
      Numbers numbers(60);
      int through = 0;
      double worst = 0;
      for (int i = 0; i < count; ++i) {
        const double speed = numbers.next(20, 100);
        const double away = numbers.next(1, 5);
        Balls scene;
        scene.dimension = program.space ? 3 : 2;
        scene.radius = 0.02;
        scene.gravity = 0;
        scene.plate = 0.02;
        scene.bullets = bullets;
        scene.balls.push_back({{-away, 0, 0}, {speed, 0, 0}});
        const auto run = program.balls(scene);
        for (int step = 0; step < 120; ++step) run->step(kStep);
        const double x = run->read()[0].place[0];
        // It meets the plate with its centre at −0.03 and flies back as fast.
        const double right = -0.06 - (speed * 2 - away);
        if (x > 0) {
          ++through;
        } else {
          worst = std::max(worst, std::abs(x - right));
        }
      }
      const std::string name =
          program.name +
          std::string(!program.bullets ? "" : (bullets ? ", as bullets" : ", as they come"));
      std::printf("  %-32s %13d ", name.c_str(), through);
      const std::string way = bullets ? "as bullets" : "as they come";
      summary.add(std::to_string(count) + " shots " + way + ": through", program.name, "%.0f",
                  through);
      if (through < count) {
        std::printf("%28.1e\n", worst);
      } else {
        std::printf("%28s\n", "-");
      }
      if (!program.bullets) break;
    }
  }
  std::printf("\n");
}

// ---------------------------------------------------------------- ten boxes at rest

void stack(std::vector<Program> all, int runs, Summary& summary) {
#ifdef CONTACT_HAS_BOOK
  // What the plan leaves out of this scene, to see what that is worth.
  Program everything = all.front();
  everything.name = "all effects on";
  everything.stack = scene_programs::book_with_everything;
  all.insert(all.begin() + 1, everything);
#endif
  constexpr std::size_t steps = 600;
  std::printf(
      "ten boxes of 1 m on each other, friction 0.5, 10 s: nothing should move\n"
      "  %-14s %10s %9s %9s %14s %14s %14s\n",
      "", "median, ms", "mean", "worst", "sideways, m", "downwards, m", "speed, m/s");
  for (const Program& program : all) {
    std::vector<double> times;
    double sideways = 0;
    double down = 0;
    double speed = 0;
    for (int round = 0; round < runs; ++round) {
      const auto run = program.stack({});
      for (std::size_t step = 0; step < steps; ++step) {
        const double start = processor_seconds();
        run->step(kStep);
        times.push_back(1000 * (processor_seconds() - start));
      }
      const std::vector<Motion> end = run->read();
      for (std::size_t i = 0; i < end.size(); ++i) {
        const Motion& box = end[i];
        sideways = std::max(sideways, std::hypot(box.place[0], box.place[1]));
        down = std::max(down, std::abs(box.place[2] - (static_cast<double>(i) + 0.5)));
        speed = std::max(speed, std::hypot(box.velocity[0], box.velocity[1], box.velocity[2]));
      }
    }
    const double mean =
        std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
    std::printf("  %-14s %10.3f %9.3f %9.3f %14.1e %14.1e %14.1e\n", program.name, median(times),
                mean, *std::max_element(times.begin(), times.end()), sideways, down, speed);
    summary.add("ten boxes at rest, ms a step", program.name, "%.3f", median(times));
    summary.add("  ten boxes, mean ms", program.name, "%.3f", mean);
    summary.add("  ten boxes, sideways, m", program.name, "%.1e", sideways);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // each table as soon as it is there
  const std::string_view part = argc > 1 ? argv[1] : "all";
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  const std::vector<Program> all = programs();
  std::vector<std::string> names;
  for (const Program& program : all) names.emplace_back(program.name);
  Summary summary(names);
  bool known = false;
  const auto wanted = [&](std::string_view name) {
    const bool yes = part == "all" || part == name;
    known = known || yes;
    return yes;
  };
  if (wanted("balls"))
    for (const std::size_t n : {100, 1000, 10000}) elastic(all, n, 3, runs, summary);
  if (wanted("plane"))
    for (const std::size_t n : {100, 1000, 10000}) elastic(all, n, 2, runs, summary);
  if (wanted("drop")) drop(all, summary);
  if (wanted("shots")) shots(all, summary);
#ifdef CONTACT_HAS_BOOK
  if (wanted("pairs")) box_pairs::compare_all(2000, runs, summary);
#endif
  if (wanted("stack")) stack(all, runs, summary);
  if (!known) {
    std::fprintf(stderr, "usage: scene_peers [balls|plane|drop|shots|pairs|stack|all] [runs]\n");
    return 2;
  }
  summary.print();
}
