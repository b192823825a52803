// Long after the horizon no position can be predicted. What can be predicted concerns many runs
// with different starts: conserved quantities, and averages, which have known values or agree with
// those of the same scenes in another kind of run. All are compared to 4.4 standard errors of a
// mean: one comparison of a hundred thousand fails by chance, and seeds are fixed.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_runs.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Plan;
using contact::PlanOptions;
using contact::Scene;
using contact::SceneRun;
using generators::Random;
using generators::tried;
using plan_scenes::Point;

namespace {

/// A mean over many runs.
struct Average {
  double mean = 0;
  double error = 0;  ///< one standard error of the mean
};

Average average_of(const std::vector<double>& found) {
  const auto count = static_cast<double>(found.size());
  double sum = 0;
  double squares = 0;
  for (const double x : found) sum += x;
  for (const double x : found) squares += (x - sum / count) * (x - sum / count);
  return {sum / count, std::sqrt(squares / (count * (count - 1)))};
}

/// That a mean may have its known value; and that so many runs would have shown a deviation of more
/// than some five times the largest error.
void within_chance(const Average& found, double must_be, double largest_error) {
  CAPTURE(found.mean, must_be, found.error);
  CHECK(found.error < largest_error);
  CHECK(std::abs(found.mean - must_be) < 4.4 * found.error);
}

/// Runs gases with different starts, so that they are independent, to twice their horizon and more,
/// and takes the mean of a measured quantity. Energies are conserved.
/// @param number_of of a test, so that each has its own gases
/// @param make a scene from random numbers
/// @param measure takes the initial scene and the run at its end
template <class Make, class Measure>
Average long_after(std::uint64_t number_of, const Make& make, const Measure& measure) {
  Random random(number_of);
  std::vector<double> found;
  for (int run = 0; run < tried(800); ++run) {
    const Scene scene = make(random);
    const Plan plan = contact::plan_scene(scene);
    REQUIRE(plan.step == 0);
    REQUIRE(*contact::decision_on(plan, Effect::horizon).value < scene.duration / 2);
    const auto gas = contact::scenes::make_run(scene, plan);
    const double energy = gas->energy();
    gas->advance(scene.duration);
    REQUIRE(std::abs(gas->energy() / energy - 1) < 1e-12);
    found.push_back(measure(scene, *gas));
  }
  return average_of(found);
}

/// Sixteen balls in a room of 4 m, or in a plane of it.
Scene gas_of_sixteen(Random& random, int dimension) {
  Scene scene = plan_scenes::empty(1, 0, 24, 1e-6);
  scene.gravity = Point::Zero();
  plan_scenes::walls(scene, Point(4, 4, 4));
  for (int i = 0; i < 16; ++i) {
    Point x(0.6 + i % 3 * 1.4, 0.6 + i / 3 % 3 * 1.4, 0.6 + i / 9 * 1.4);
    if (dimension == 2) x = Point(0.5 + i % 4, 0.5 + i / 4, 2);
    Point v = Point::Zero();
    for (int k = 0; k < dimension; ++k) v(k) = random.uniform(-1, 1);
    plan_scenes::ball(scene, 0.4, 1, x, v);
  }
  return scene;
}

/// The mean of v⁴ over the square of the mean of v².
double spread_of_speeds(const Scene& scene, const contact::SceneRun& gas) {
  double square = 0;
  double fourth = 0;
  double count = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    const double v = gas.velocity(i).squaredNorm();
    square += v;
    fourth += v * v;
    count += 1;
  }
  return fourth * count / (square * square);
}

}  // namespace

// The velocities of n equal elastic balls are evenly distributed over a sphere in d n dimensions.
// Then a ball's share of Σ v² has a beta distribution, and the mean of v⁴ over the square of the
// mean of v² is (d + 2)/d · d n/(d n + 2).
TEST_CASE("long after the horizon the speeds of a gas have the right distribution") {
  const auto found = long_after(
      22, [](Random& random) { return gas_of_sixteen(random, 3); }, spread_of_speeds);
  within_chance(found, 5.0 / 3 * 48 / 50, 0.8 / std::sqrt(tried(800)));
}

TEST_CASE("long after the horizon the speeds of discs have the right distribution") {
  const auto found = long_after(
      23, [](Random& random) { return gas_of_sixteen(random, 2); }, spread_of_speeds);
  within_chance(found, 2.0 * 32 / 34, 0.8 / std::sqrt(tried(800)));
}

TEST_CASE("long after the horizon light and heavy balls have their shares of the energy") {
  // Initially all of the energy is in the light ones; on average each ball gets the same.
  const auto make = [](Random& random) {
    Scene scene = gas_of_sixteen(random, 3);
    scene.duration = 80;
    for (std::size_t i = 0; i < scene.bodies.size(); i += 4) {
      if (!scene.bodies[i].moves) continue;
      scene.bodies[i].mass = 8;
      scene.bodies[i].inertia *= 8;
      scene.bodies[i].velocity.setZero();
    }
    return scene;
  };
  const auto share = [](const Scene& scene, const contact::SceneRun& gas) {
    double heavy = 0;
    double all = 0;
    double count = 0;
    double heavies = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (!scene.bodies[i].moves) continue;
      const double energy = scene.bodies[i].mass * gas.velocity(i).squaredNorm() / 2;
      const bool is_heavy = scene.bodies[i].mass > 1;
      all += energy;
      heavy += is_heavy ? energy : 0;
      count += 1;
      heavies += is_heavy ? 1 : 0;
    }
    return heavy / all - heavies / count;
  };
  within_chance(long_after(24, make, share), 0, 0.2 / std::sqrt(tried(800)));
}

TEST_CASE("long after the horizon with gravity each axis has a third of the kinetic energy") {
  const auto make = [](Random& random) {
    Scene scene = gas_of_sixteen(random, 3);
    scene.gravity = {0, 0, -0.25};
    return scene;
  };
  const auto upright = [](const Scene& scene, const contact::SceneRun& gas) {
    double along = 0;
    double all = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (!scene.bodies[i].moves) continue;
      along += gas.velocity(i).z() * gas.velocity(i).z();
      all += gas.velocity(i).squaredNorm();
    }
    return along / all;
  };
  within_chance(long_after(25, make, upright), 1.0 / 3, 0.2 / std::sqrt(tried(800)));
}

namespace {

/// A scene's runs from event to event and step by step, both to its end.
struct Both {
  std::unique_ptr<SceneRun> events;
  std::unique_ptr<SceneRun> steps;
};

Both both_ways(const Scene& scene, double step) {
  PlanOptions by_events;
  by_events.overrides.with = {Effect::event_driven};
  PlanOptions by_steps;
  by_steps.step = step;
  by_steps.overrides.with = {Effect::continuous_detection};
  const Plan plan = contact::plan_scene(scene, by_steps);
  REQUIRE(*contact::decision_on(plan, Effect::horizon).value < scene.duration / 2);
  Both both;
  both.events = contact::scenes::make_run(scene, contact::plan_scene(scene, by_events));
  both.steps = contact::scenes::make_run(scene, plan);
  REQUIRE(both.events->event_driven());
  REQUIRE_FALSE(both.steps->event_driven());
  both.events->advance(scene.duration);
  both.steps->advance(scene.duration);
  return both;
}

/// A few balls of two sizes and masses in a room of 3 m.
Scene a_few_balls(Random& random, double restitution, double gravity, double duration) {
  Scene scene = plan_scenes::empty(restitution, 0, duration, 1e-6);
  scene.gravity = {0, 0, -gravity};
  plan_scenes::walls(scene, Point(3, 3, 3));
  for (int i = 0; i < 6; ++i) {
    const double x = 0.6 + 1.4 * (i % 2) + random.uniform(0, 0.3);
    const double y = 0.6 + 1.4 * (i / 2 % 2) + random.uniform(0, 0.3);
    const double z = 0.6 + 1.4 * (i / 4) + random.uniform(0, 0.3);
    const double vx = random.uniform(-2, 2);
    const double vy = random.uniform(-2, 2);
    const double vz = random.uniform(-2, 2);
    const bool large = i % 2 == 0;
    plan_scenes::ball(scene, large ? 0.5 : 0.4, large ? 2 : 1, {x, y, z}, {vx, vy, vz});
  }
  return scene;
}

double kinetic_energy(const Scene& scene, const SceneRun& run, int axis) {
  double twice = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& body = scene.bodies[i];
    if (body.moves) twice += body.mass * run.velocity(i)(axis) * run.velocity(i)(axis);
  }
  return twice / 2;
}

double kinetic_energy(const Scene& scene, const SceneRun& run) {
  return kinetic_energy(scene, run, 0) + kinetic_energy(scene, run, 1) +
         kinetic_energy(scene, run, 2);
}

}  // namespace

// With gravity there is no formula at hand for the distribution of speeds and heights. The same
// scenes run in both ways; the difference of the two ends of a scene has the mean 0 if both have
// the same distribution, whatever their correlation.
TEST_CASE("long after the horizon steps give the averages of event-driven runs") {
  Random random(28);
  std::vector<double> upright;
  std::vector<double> energy;
  std::vector<double> spread;
  std::vector<double> third;
  for (int run = 0; run < tried(160); ++run) {
    const Scene scene = a_few_balls(random, 1, 1, 12);
    const Both both = both_ways(scene, 1.0 / 20);
    const double first = contact::scenes::make_run(scene, contact::plan_scene(scene))->energy();
    REQUIRE(std::abs(both.events->energy() / first - 1) < 1e-12);
    REQUIRE(std::abs(both.steps->energy() / first - 1) < 1e-9);
    const auto share = [&](const SceneRun& of) {
      return kinetic_energy(scene, of, 2) / kinetic_energy(scene, of);
    };
    upright.push_back(share(*both.steps) - share(*both.events));
    third.push_back(share(*both.steps));
    energy.push_back((kinetic_energy(scene, *both.steps) - kinetic_energy(scene, *both.events)) /
                     first);
    spread.push_back(spread_of_speeds(scene, *both.steps) - spread_of_speeds(scene, *both.events));
  }
  const double root = std::sqrt(tried(160));
  within_chance(average_of(third), 1.0 / 3, 0.3 / root);
  within_chance(average_of(upright), 0, 0.4 / root);
  within_chance(average_of(energy), 0, 0.4 / root);
  within_chance(average_of(spread), 0, 1.5 / root);
}

// No external force: eight balls that approach from all corners.
TEST_CASE(
    "long after the horizon what no wall changes is conserved in steps and from event to event") {
  Random random(31);
  for (int trial = 0; trial < tried(16); ++trial) {
    const double e = trial % 2 == 0 ? 1 : 0.75;
    Scene scene = plan_scenes::empty(e, 0, 128, 1e-6);
    scene.gravity.setZero();
    for (int i = 0; i < 8; ++i) {
      const Point corner(i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 - 0.5);
      const double push = random.uniform(1, 2);
      const double aside = random.uniform(-0.2, 0.2);
      const double mass = random.uniform(1, 4);
      plan_scenes::ball(scene, 0.5, mass, corner * 3, {aside - push * corner.x(), aside, aside});
      scene.bodies.back().velocity.y() -= push * corner.y();
      scene.bodies.back().velocity.z() -= push * corner.z();
    }
    const Both both = both_ways(scene, 1.0 / 8);
    const auto kept = [&](const auto& position, const auto& velocity) {
      Point momentum = Point::Zero();
      Point turning = Point::Zero();
      for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        momentum += scene.bodies[i].mass * velocity(i);
        turning += scene.bodies[i].mass * Point(position(i).cross(velocity(i)));
      }
      return std::pair(momentum, turning);
    };
    const auto first = kept([&](std::size_t i) { return scene.bodies[i].position; },
                            [&](std::size_t i) { return scene.bodies[i].velocity; });
    for (const SceneRun* run : {both.events.get(), both.steps.get()}) {
      const auto last = kept([&](std::size_t i) { return run->position(i); },
                             [&](std::size_t i) { return run->velocity(i); });
      CAPTURE(trial, run->event_driven());
      CHECK(run->counts().hits >= 8);
      // Some hundred roundings of up to 32 kg m/s; as many of that times a position, of 256 m at
      // most, and two of a position in each step.
      CHECK((last.first - first.first).norm() <= 100 * 0x1p-53 * 32);
      const double rounded = 100 + 2 * static_cast<double>(run->counts().steps);
      CHECK((last.second - first.second).norm() <= rounded * 0x1p-53 * 32 * 256);
      const double before = contact::scenes::make_run(scene, contact::plan_scene(scene))->energy();
      if (e == 1) CHECK(std::abs(run->energy() / before - 1) <= 1e-12);
      if (e < 1) CHECK(run->energy() < before);
    }
  }
}

// A gas that loses energy in hits cools: the slower it is the fewer hits there are.
TEST_CASE("long after the horizon a gas that loses energy has cooled as much in steps") {
  Random random(29);
  std::vector<double> cooled;
  std::vector<double> lost;
  for (int run = 0; run < tried(160); ++run) {
    const Scene scene = a_few_balls(random, 0.95, 0, 16);
    const Both both = both_ways(scene, 1.0 / 20);
    const double first = contact::scenes::make_run(scene, contact::plan_scene(scene))->energy();
    cooled.push_back(std::log(both.steps->energy() / both.events->energy()));
    lost.push_back(std::log(first / both.events->energy()));
  }
  const double root = std::sqrt(tried(160));
  within_chance(average_of(cooled), 0, 1 / root);
  // Three quarters of it are lost: hits that took a fifth more of it would be seen.
  CHECK(average_of(lost).mean > 1.4);
}

// Elastic and smooth: on average each degree of freedom has the same energy. A box has three of
// translation and three of rotation, a ball three of translation.
TEST_CASE(
    "long after the first hits a third of the energy of a box and a ball is rotation of the box") {
  Random random(30);
  std::vector<double> turning;
  for (int run = 0; run < tried(64); ++run) {
    Scene scene = plan_scenes::empty(1, 0, 10, 1e-3);
    scene.gravity.setZero();
    plan_scenes::walls(scene, Point(2, 2, 2));
    const auto any = [&](double size) {
      const double x = random.uniform(-size, size);
      const double y = random.uniform(-size, size);
      return Point(x, y, random.uniform(-size, size));
    };
    plan_scenes::box(scene, {0.4, 0.3, 0.2}, 1, Point::Constant(0.6), any(2)).angular_velocity =
        any(3);
    plan_scenes::ball(scene, 0.35, 1, Point::Constant(1.5), any(2));
    const auto gas = contact::scenes::make_run(scene, contact::plan_scene(scene));
    const double first = gas->energy();
    gas->advance(scene.duration);
    REQUIRE(std::abs(gas->energy() / first - 1) < 1e-9);
    turning.push_back(1 - kinetic_energy(scene, *gas) / gas->energy());
  }
  within_chance(average_of(turning), 3.0 / 9, 0.3 / std::sqrt(tried(64)));
}
