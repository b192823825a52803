// Scenes step by step: how bodies move, slide, bounce and react to springs, compared with closed
// forms.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/trampoline.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Scene;
using generators::Random;
using plan_scenes::Point;
using plan_scenes::run_of;
using plan_scenes::stepped;
using stepped_scenes::any_body;
using stepped_scenes::any_direction;
using stepped_scenes::crash;
using stepped_scenes::has_stage;
using stepped_scenes::total_momentum;
using stepped_scenes::with_gravity;

TEST_CASE("the book's scenes give what they expect, where they go step by step") {
  const auto folder = std::filesystem::path(CONTACT_SOURCE_DIR) / "chapters/20_scenes/scenes";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 29);
  int tried = 0;
  for (const auto& file : files) {
    const Scene scene = contact::scenes::read_scene(file);
    if (generators::sanitized && scene.bodies.size() > 20) continue;
    const auto plan = contact::plan_scene(scene);
    CAPTURE(scene.name);
    auto run = contact::scenes::make_run(scene, plan);
    if (run->event_driven()) continue;
    ++tried;
    auto wanted = scene.expect;
    std::stable_sort(wanted.begin(), wanted.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    CHECK_FALSE(wanted.empty());
    for (const auto& expectation : wanted) {
      REQUIRE(run->advance(expectation.time) == contact::SceneRunEnd::reached);
      const double got = contact::scene_quantity(scene, *run, expectation);
      CAPTURE(expectation.quantity, expectation.body, expectation.time, got, expectation.value);
      CHECK(std::abs(got - expectation.value) <= expectation.within);
    }
  }
  CHECK(tried >= 12);
}

TEST_CASE("a box slides to rest after v²/(2 μ g)") {
  // Friction is constant until the box stops, in the middle of some step.
  Random random(1);
  for (int i = 0; i < generators::tried(64); ++i) {
    const double mu = random.uniform(0.1, 1);
    const double v = random.uniform(0.5, 3);
    Scene scene = with_gravity(0, mu, 1.5 * v / (mu * 10), 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::box(scene, {0.5, 0.5, 0.1}, random.uniform(0.5, 5), {0, 0, 0.1}, {v, 0, 0});
    auto run = run_of(scene);
    run->advance(scene.duration);
    const double rest = v * v / (20 * mu);
    CAPTURE(mu, v);
    CHECK(std::abs(run->position(1).x() - rest) <= 1e-9);
    CHECK(std::abs(run->position(1).z() - 0.1) <= 1e-9);
    CHECK(run->velocity(1).norm() <= 1e-9);
  }
}

TEST_CASE("a block on a slope of 3 in 4 slides if μ < 3/4") {
  Random random(2);
  for (int i = 0; i < generators::tried(64); ++i) {
    const bool slides = i % 2 == 0;
    const double mu = slides ? random.uniform(0, 0.74) : random.uniform(0.76, 2);
    Scene scene = with_gravity(0, mu, 1, 1e-6);
    plan_scenes::wall(scene, {0.6, 0, 0.8}, 0);
    auto& block = plan_scenes::box(scene, {1, 0.5, 0.25}, 2, Point(0.6, 0, 0.8) * 0.25);
    // By the angle whose half has the cosine 3/√10: the block's z is the slope's normal.
    block.orientation = {3 / std::sqrt(10.0), {0, 1 / std::sqrt(10.0), 0}};
    auto run = run_of(scene);
    run->advance(1);
    const double way = slides ? (6 - mu * 8) / 2 : 0;
    const Point moved = run->position(1) - block.position;
    CAPTURE(mu, way);
    CHECK(std::abs(moved.x() - 0.8 * way) <= 1e-8);
    CHECK(std::abs(moved.z() + 0.6 * way) <= 1e-8);
    CHECK(std::abs(moved.y()) <= 1e-9);
  }
}

TEST_CASE("without contacts an angular velocity is constant, or the angular momentum is") {
  Random random(3);
  for (int i = 0; i < generators::tried(24); ++i) {
    Scene scene = with_gravity(0.5, 0.5, 2, 1e-6);
    auto& body = plan_scenes::box(scene, {0.1, 0.2, 0.3}, 2, {0, 0, 100});
    body.angular_velocity = any_direction(random) * random.uniform(0.5, 5);
    const Point momentum = body.inertia * body.angular_velocity;
    const double energy = body.angular_velocity.dot(momentum) / 2;
    auto run = run_of(scene);
    CHECK(has_stage(*run, "rotation"));
    CHECK_FALSE(has_stage(*run, "contacts"));
    run->advance(2);
    const auto turn = contact::matrix_of(run->orientation(0));
    const Point seen = turn.transpose() * run->angular_velocity(0);
    const Point own = body.inertia * seen;
    const Point later = turn * own;
    // The angular momentum is conserved by construction, up to rounding. The error of the energy is
    // that of the rotation: ω T (2^-7)^4/120 of itself at most, about 3e-10 here.
    CHECK((later - momentum).norm() <= 1e-12);
    CHECK(std::abs(seen.dot(own) / 2 - energy) <= 1e-9 * energy);
    // Free fall is exact: 5 t² = 20 m in 2 s, whatever the step.
    CHECK(std::abs(run->position(0).z() - 80) <= 1e-11);
  }
  Scene scene = plan_scenes::empty(0, 0, 1, 1e-6);
  auto& box = plan_scenes::box(scene, {0.1, 0.2, 0.3}, 2, {0, 0, 0});
  box.angular_velocity = {0, 0, 3};
  auto run = run_of(scene);
  run->advance(1);
  CHECK((run->angular_velocity(0) - box.angular_velocity).norm() <= 1e-14);
}

TEST_CASE("collisions conserve momentum, and create no energy") {
  Random random(4);
  int met = 0;
  for (int i = 0; i < generators::tried(80); ++i) {
    Scene scene = crash(random, random.uniform(0, 1), random.chance(0.5) ? 0 : 0.5);
    auto run = run_of(scene, stepped(1.0 / 60));
    const Point before = total_momentum(scene, *run);
    double energy = run->energy();
    for (int k = 1; k <= 20; ++k) {
      run->advance(k * 0.05);
      CAPTURE(i, k, energy, run->energy());
      // Each impulse acts on both with opposite signs: rounding alone, some hundreds of them of at
      // most 10 N s.
      CHECK((total_momentum(scene, *run) - before).norm() <= 1e-12);
      CHECK(run->energy() <= energy * (1 + 1e-9));
      energy = run->energy();
    }
    met += run->counts().hits > 0 ? 1 : 0;
  }
  // They fly at one point, so nearly all of them meet.
  CHECK(met > generators::tried(80) / 2);
}

TEST_CASE("a ball bounces to e² of its height, whatever the step") {
  Random random(5);
  for (int i = 0; i < generators::tried(100); ++i) {
    const double e = random.uniform(0.3, 1);
    const double height = random.uniform(0.5, 3);
    const double fall = std::sqrt(height / 5);
    const double apex = fall * (1 + e);  // down, and up again at e times the speed
    Scene scene = with_gravity(e, 0, apex * 1.01, 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::ball(scene, 0.25, 2, {0, 0, height + 0.25});
    auto run = run_of(scene, stepped(random.uniform(0.001, 0.1)));
    CHECK_FALSE(run->event_driven());
    run->advance(apex);
    CAPTURE(e, height);
    CHECK(std::abs(run->position(1).z() - 0.25 - e * e * height) <= 1e-11);
    CHECK(std::abs(run->velocity(1).z()) <= 1e-11);
    CHECK(run->counts().hits == 1);
  }
}

TEST_CASE("a ball that falls on a compliant floor comes to rest m g/k deep") {
  Random random(6);
  for (int i = 0; i < generators::tried(32); ++i) {
    const double mass = random.uniform(0.5, 4);
    const double k = random.uniform(500, 5000);
    const double rate = std::sqrt(k / mass);
    // With c = 2 √(k m) it creeps back as fast as it can: after 40/ω nothing is left of the fall.
    Scene scene = with_gravity(1, 0, 1 + 40 / rate, 1e-6);
    scene.materials.push_back({"soft", 1, 0, k, 2 * std::sqrt(k * mass)});
    plan_scenes::wall(scene, Point::UnitZ(), 0).material = 1;
    plan_scenes::ball(scene, 0.25, mass, {0, 0, 0.3});
    auto run = run_of(scene);
    CHECK(has_stage(*run, "springs"));
    run->advance(scene.duration);
    CAPTURE(mass, k);
    CHECK(std::abs(0.25 - run->position(1).z() - mass * 10 / k) <= 1e-9);
    CHECK(run->velocity(1).norm() <= 1e-9);
  }
}

namespace {

/// The height of a ball that falls on a compliant floor without loss, above the floor at rest, in
/// closed form.
double height_on_spring(const contact::Trampoline<double>& jump, double t) {
  const auto of = contact::trampoline_jump(jump);
  const double rate = std::sqrt(jump.stiffness / jump.mass);
  const double fast = std::sqrt(2 * jump.gravity * jump.height);
  // From the middle of a flight on all repeats.
  const double since = std::fmod(t, of.air_time + of.contact_time);
  const auto flight = [&](double from_top) {
    return jump.height - jump.gravity * from_top * from_top / 2;
  };
  if (since < of.air_time / 2) return flight(since);
  const double on = since - of.air_time / 2;
  if (on > of.contact_time) return flight(since - of.air_time - of.contact_time);
  return of.sag * (std::cos(rate * on) - 1) - fast / rate * std::sin(rate * on);
}

}  // namespace

TEST_CASE("springs push in substeps as short as the tolerance requires") {
  Random random(61);
  int shorter = 0;
  int needed = 0;
  for (int i = 0; i < generators::tried(24); ++i) {
    const double mass = random.uniform(0.5, 4);
    const double stiffness = std::exp2(random.uniform(8, 13));
    const double height = random.uniform(0.1, 1);
    Scene scene = with_gravity(1, 0, random.uniform(1, 2), std::exp2(random.uniform(-19, -8)));
    scene.materials.push_back({"soft", 1, 0, stiffness, 0});
    plan_scenes::wall(scene, Point::UnitZ(), 0).material = 1;
    plan_scenes::ball(scene, 0.25, mass, {0, 0, 0.25 + height});
    contact::Plan plan = contact::plan_scene(scene);
    const contact::Decision& springs = contact::decision_on(plan, Effect::penalty_contact);
    REQUIRE(springs.on);
    CAPTURE(i, mass, stiffness, height, scene.duration, plan.spring_substep, springs.error);
    if (!(springs.error > 0)) continue;  // more than a thousand substeps a step
    CHECK(springs.error <= *scene.tolerance.position);
    const auto jump = contact::trampoline(mass, stiffness, 10.0, height);
    const auto farthest = [&] {
      const auto run = contact::scenes::make_run(scene, plan);
      double apart = 0;
      for (int k = 1; k <= 40; ++k) {
        const double t = scene.duration * k / 40;
        run->advance(t);
        apart = std::max(apart, std::abs(run->position(1).z() - 0.25 - height_on_spring(jump, t)));
      }
      return apart;
    };
    CHECK(farthest() <= springs.error);
    const double longest = 1 / (128 * std::sqrt(stiffness / mass));
    if (plan.spring_substep < 0.9 * longest) ++shorter;
    // As the stiffest spring alone would have it.
    plan.spring_substep = 0;
    if (farthest() > *scene.tolerance.position) ++needed;
  }
  CAPTURE(shorter, needed);
  CHECK(shorter > generators::tried(24) / 3);
  CHECK(needed > 0);
}

TEST_CASE("bodies dropped into a box stay in it and lose energy") {
  Random random(11);
  for (int i = 0; i < generators::tried(16); ++i) {
    Scene scene = with_gravity(0.3, 0.5, 2, 1e-3);
    plan_scenes::walls(scene, {2, 2, 10});
    for (int k = 0; k < 6; ++k) any_body(random, scene, {0.5 + k % 2, 0.5 + k / 2 % 2, 1.0 + k});
    auto run = run_of(scene);
    const double energy = run->energy();
    run->advance(2);
    CHECK(run->energy() < energy);
    for (std::size_t b = 6; b < scene.bodies.size(); ++b) {
      CAPTURE(i, b);
      // Its centre is inside: a body that rests on the floor may overlap it by the overlap that
      // pushing out leaves.
      for (int k = 0; k < 3; ++k) {
        CHECK(run->position(b)(k) > 0.05);
        CHECK(run->position(b)(k) < (k < 2 ? 1.95 : 9.95));
      }
    }
  }
}

TEST_CASE("a hull meets half-spaces and balls") {
  Scene scene = with_gravity(0, 0.5, 1, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  contact::HullShape cube;
  for (int k = 0; k < 8; ++k)
    cube.points.push_back(Point(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1) * 0.1);
  plan_scenes::add(scene, cube, 1, {0, 0, 0.6});
  auto run = run_of(scene);
  run->advance(1);
  CHECK(std::abs(run->position(1).z() - 0.1) <= 1e-9);
  plan_scenes::ball(scene, 0.1, 1, {0, 0, 2});
  run = run_of(scene);
  run->advance(1);
  CHECK(std::abs(run->position(2).z() - 0.3) <= 1e-6);
}
