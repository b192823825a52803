// Event-driven runs that go on step by step, and bounces that are left out.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/scene_runs.hpp>
#include <cstdint>
#include <limits>
#include <string>

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
using stepped_scenes::bits_of;
using stepped_scenes::Hits;
using stepped_scenes::total_momentum;
using stepped_scenes::with;
using stepped_scenes::with_gravity;
using stepped_scenes::without;

TEST_CASE("where events do not end the run goes on step by step, and says so") {
  Scene scene = with_gravity(0.5, 0, 4, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 1});
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 3});
  CHECK_FALSE(run_of(scene)->event_driven());
  auto run = run_of(scene, with({Effect::event_driven}));
  CHECK(run->event_driven());
  CHECK_FALSE(run->fallback());
  CHECK(run->advance(3) == contact::SceneRunEnd::reached);
  CHECK_FALSE(run->event_driven());
  REQUIRE(run->fallback());
  CHECK(run->fallback()->time > 0.4);
  CHECK(run->fallback()->why.find("again and again") != std::string::npos);
  // It goes on from a checkpoint too.
  auto other = run_of(scene, with({Effect::event_driven}));
  other->restore(run->checkpoint());
  run->advance(4);
  other->advance(4);
  CHECK(bits_of(scene, *run) == bits_of(scene, *other));
  CHECK(other->counts().hits == run->counts().hits);
  CHECK(std::abs(run->position(1).z() - 0.5) <= 1e-6);
  CHECK(std::abs(run->position(2).z() - 1.5) <= 1e-3);
  // A budget does the same.
  auto budget =
      contact::scenes::make_run(scene, contact::plan_scene(scene, with({Effect::event_driven})), 2);
  CHECK(budget->advance(4) == contact::SceneRunEnd::reached);
  REQUIRE(budget->fallback());
  CHECK(budget->fallback()->why == "the budget of 2 hits ran out");
}

TEST_CASE(
    "a run that goes on in steps has the tolerance that bounces from event to event have left") {
  struct Slowest final : contact::SceneObserver {
    double speed = 100;
    bool on_hit(const contact::SceneHit& hit) override {
      speed = std::min(speed, hit.impulse.norm() / 1.9);  // (1 + e) m v
      return true;
    }
  } slowest;
  Scene scene = with_gravity(0.9, 0, 20, 1e-4);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 1});
  const auto plan = contact::plan_scene(scene);
  REQUIRE(plan.cutoff > 0);
  const auto run = contact::scenes::make_run(scene, plan, 5);
  run->advance(20, std::numeric_limits<std::uint64_t>::max(), &slowest);
  REQUIRE(run->fallback());
  CHECK(run->counts().rests > 0);
  // Half of the tolerance is left, and half of that is for bounces: v²/(2 g) = 25 µm.
  const double rest = std::sqrt(20 * 0.25e-4);
  CHECK(slowest.speed >= rest);
  CHECK(slowest.speed <= rest / 0.9);
}

TEST_CASE("forced off, gravity and restitution are off from event to event too") {
  Scene scene = with_gravity(1, 0, 1, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 3}, {1, 0, 0});
  auto run = run_of(scene, without({Effect::gravity}));
  CHECK(run->event_driven());
  run->advance(1);
  CHECK(run->position(1) == Point(1, 0, 3));
  scene.bodies[1].velocity = {0, 0, -10};
  auto dull = run_of(scene, without({Effect::restitution, Effect::gravity}));
  dull->advance(1);
  CHECK(std::abs(dull->position(1).z() - 0.5) <= 1e-9);
}

TEST_CASE("the bounces that a run leaves out are those that its plan leaves out") {
  Random random(71);
  int rested = 0;
  for (int i = 0; i < generators::tried(100); ++i) {
    const double tolerance = std::pow(10, random.uniform(-14, -3));
    Scene scene = with_gravity(random.uniform(0.2, 0.7), 0, 10, tolerance);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::ball(scene, 0.25, 1, {0, 0, random.uniform(0.5, 2)});
    const auto plan = contact::plan_scene(scene);
    const contact::Decision& events = contact::decision_on(plan, Effect::event_driven);
    REQUIRE(events.on);
    const auto run = contact::scenes::make_run(scene, plan);
    run->advance(10);
    CAPTURE(tolerance, events.error, run->counts().hits);
    CHECK(run->counts().rest_error <= events.error);
    // And not many times fewer than possible: of two successive bounces the second is e² as high.
    if (run->counts().rests == 0) continue;
    ++rested;
    CHECK(run->counts().rest_error >= events.error * 0.03);
  }
  CHECK(rested > generators::tried(100) / 2);
}

TEST_CASE("however slowly, a ball that falls along a wall bounces off it") {
  // Its horizontal path is the unfolded one, with e of the speed after each wall; gravity does not
  // matter.
  Random random(81);
  for (int i = 0; i < generators::tried(24); ++i) {
    const double e = random.uniform(0.5, 0.95);
    const double speed = random.uniform(0.02, 0.09);
    const double way = random.uniform(0.01, 0.1);
    Scene scene = with_gravity(e, 0, 20, 1e-2);
    plan_scenes::wall(scene, Point::UnitX(), -1);
    plan_scenes::wall(scene, -Point::UnitX(), -1);
    plan_scenes::ball(scene, 0.1, 1, {0.9 - way, 0, 0}, {speed, 0, 0});
    const auto plan = contact::plan_scene(scene);
    auto run = contact::scenes::make_run(scene, plan);
    Hits hits;
    run->advance(20, std::numeric_limits<std::uint64_t>::max(), &hits);
    double x = 0.9 - way;
    double v = speed;
    double left = 20;
    std::size_t bounces = 0;
    for (;;) {
      const double flight = ((v > 0 ? 0.9 : -0.9) - x) / v;
      if (flight > left) break;
      x += v * flight;
      left -= flight;
      v *= -e;
      ++bounces;
    }
    x += v * left;
    CAPTURE(e, speed, way, run->step());
    CHECK(hits.seen.size() == bounces);
    // Positions far down are rounded: 2 km at 2^-40 of that, at each touch.
    CHECK(std::abs(run->position(2).x() - x) <= 1e-7);
    CHECK(std::abs(run->velocity(2).x() - v) <= 1e-12);
    CHECK(contact::decision_on(plan, Effect::resting).error == 0);
    CHECK(plan.error <= 1e-2);
  }
}

TEST_CASE("under a ceiling a slow ball bounces as a fast one does") {
  // It arrives with w, leaves with e w, and falls.
  Random random(82);
  for (int i = 0; i < generators::tried(24); ++i) {
    const double e = random.uniform(0.5, 0.95);
    const double w = random.uniform(0.01, 0.05);
    const double up = random.uniform(0.001, 0.01);
    Scene scene = with_gravity(e, 0, 1, 1e-2);
    plan_scenes::wall(scene, -Point::UnitZ(), -1);
    plan_scenes::wall(scene, Point::UnitX(), -1);
    const double v = std::sqrt(w * w + 20 * up);
    plan_scenes::ball(scene, 0.1, 1, {0, 0, 0.9 - up}, {0, 0, v});
    const auto run = run_of(scene, stepped(1.0 / 60));
    run->advance(1);
    const double t = 1 - (v - w) / 10;
    CAPTURE(e, w, up);
    CHECK(run->counts().hits == 1);
    CHECK(std::abs(run->position(2).z() - (0.9 - e * w * t - 5 * t * t)) <= 1e-9);
  }
}

TEST_CASE("bodies that fall together hit each other however slowly, and the run ends") {
  // Balls in a row, the first slow: with e each hit passes on (1 + e)/2 of the speed. Final speeds
  // are products of these as long as no ball is caught up with, which does not happen in 10 s.
  const double e = 0.9;
  Scene scene = with_gravity(e, 0, 10, 1e-2);
  plan_scenes::ball(scene, 0.1, 1, {0, 0, 0}, {0.05, 0, 0});
  plan_scenes::ball(scene, 0.1, 1, {0.25, 0, 0});
  plan_scenes::ball(scene, 0.1, 1, {0.5, 0, 0});
  const auto plan = contact::plan_scene(scene);
  auto run = contact::scenes::make_run(scene, plan);
  Hits hits;
  run->advance(10, std::numeric_limits<std::uint64_t>::max(), &hits);
  const double on = (1 + e) / 2;
  const double back = (1 - e) / 2;
  REQUIRE(hits.seen.size() == 2);
  CHECK(std::abs(hits.seen[0].time - 0.05 / 0.05) <= 1e-9);
  CHECK(std::abs(hits.seen[1].time - (1 + 0.05 / (0.05 * on))) <= 1e-9);
  CHECK(std::abs(run->velocity(0).x() - 0.05 * back) <= 1e-12);
  CHECK(std::abs(run->velocity(1).x() - 0.05 * on * back) <= 1e-12);
  CHECK(std::abs(run->velocity(2).x() - 0.05 * on * on) <= 1e-12);
  CHECK(plan.error == 0);
  // Between two that approach, the middle one hits infinitely often: each time a part of the
  // distance is left, and when rounding cannot distinguish it from zero all three are solved
  // together.
  Scene caught = with_gravity(0.5, 0, 10, 1e-2);
  plan_scenes::ball(caught, 0.1, 1e3, {-0.3, 0, 0}, {0.05, 0, 0});
  plan_scenes::ball(caught, 0.1, 1, {0.03, 0, 0});
  plan_scenes::ball(caught, 0.1, 1e3, {0.3, 0, 0}, {-0.05, 0, 0});
  const auto squeezed = run_of(caught);
  squeezed->advance(5);
  const contact::SceneRunCounts counts = squeezed->counts();
  CHECK(counts.hits > 10);
  CHECK(counts.substeps < 20 * counts.steps);
  squeezed->advance(10);
  CHECK(squeezed->counts().hits == counts.hits);
  CHECK(total_momentum(caught, *squeezed).head<2>().norm() <= 1e-9);
}

TEST_CASE("balls that roll on a floor hit each other however slowly") {
  // The floor's normal is vertical: it changes nothing along the line of the balls. The rolling one
  // pushes the other down by friction of at most μ P, and so the floor's friction on that is at
  // most μ² P. For the balls to separate with e v the hit must be (1 + e) v = 2 P, plus the floor's
  // friction.
  Random random(83);
  for (int i = 0; i < generators::tried(16); ++i) {
    const double e = random.uniform(0.5, 0.95);
    const double v = random.uniform(0.02, 0.09);
    Scene scene = with_gravity(e, 0.2, 2, 1e-2);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    auto& cue = plan_scenes::ball(scene, 0.1, 1, {0, 0, 0.1}, {v, 0, 0});
    cue.angular_velocity = Point(0, v / 0.1, 0);
    plan_scenes::ball(scene, 0.1, 1, {0.2 + v * 0.5, 0, 0.1});
    auto run = run_of(scene);
    Hits hits;
    run->advance(0.6, std::numeric_limits<std::uint64_t>::max(), &hits);
    CAPTURE(e, v, hits.seen.size());
    REQUIRE_FALSE(hits.seen.empty());
    CHECK(std::abs(hits.seen[0].time - 0.5) <= 1e-6);
    const double push = std::abs(hits.seen[0].impulse.x());
    CHECK(push >= (1 + e) * v / 2 * (1 - 1e-6));
    CHECK(push <= (1 + e) * v / (2 - 0.2 * 0.2) * (1 + 1e-6));
  }
}

TEST_CASE("on a steep slope bounces are left out by their height along its normal") {
  // Along the normal a ball bounces as on a level floor with g cos α. The bounces left out are at
  // most as high as the plan says, and the first bounce is far higher.
  Random random(84);
  int rested = 0;
  for (int i = 0; i < generators::tried(24); ++i) {
    const double slant = random.uniform(0.005, 0.05);
    const Point n(std::sqrt(1 - slant * slant), 0, slant);
    const double e = 0.8;
    const double g = 10 * slant;
    const double height = random.uniform(0.02, 0.04);
    Scene scene = with_gravity(e, 0, 12, 1e-2);
    plan_scenes::wall(scene, n, 0);
    plan_scenes::ball(scene, 0.1, 1, n * (0.1 + height));
    const auto plan = contact::plan_scene(scene, stepped(1.0 / 30));
    const double error = contact::decision_on(plan, Effect::resting).error;
    auto run = contact::scenes::make_run(scene, plan);
    CAPTURE(slant, height, error);
    CHECK(error <= 0.5e-2);
    rested += error > 0;
    // Its flights, one after the other.
    double start = -std::sqrt(2 * height / g);  // of the first, as if it had bounced before
    double up = std::sqrt(2 * g * height);
    double most = 0;
    for (int k = 1; k <= 240; ++k) {
      const double t = 0.05 * k;
      run->advance(t);
      while (t > start + 2 * up / g && up > 1e-9) {
        start += 2 * up / g;
        up *= e;
      }
      const double into = t - start;
      const double right = std::max(0.0, (up - g * into / 2) * into);
      most = std::max(most, std::abs(n.dot(run->position(1)) - 0.1 - right));
    }
    // Its positions are rounded at 720 m, which each bounce passes on.
    CHECK(most <= error + 1e-7);
  }
  CHECK(rested > generators::tried(24) / 2);
}
