// Scenes step by step: impacts between two steps, one by one and in the order of their times.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/kept_tolerance.hpp>
#include <contact/scene/scene_runs.hpp>
#include <cstdint>
#include <limits>
#include <vector>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using generators::Random;
using plan_scenes::Point;
using plan_scenes::run_of;
using plan_scenes::stepped;
using stepped_scenes::any_direction;
using stepped_scenes::bits_of;
using stepped_scenes::has_stage;
using stepped_scenes::Hits;
using stepped_scenes::with;
using stepped_scenes::with_gravity;
using stepped_scenes::without;

TEST_CASE("hits of an unfinished step are reported at the end, with their time") {
  class ToldHits final : public contact::SceneObserver {
   public:
    std::vector<double> times;
    bool on_hit(const contact::SceneHit& hit) override {
      times.push_back(hit.time);
      return true;
    }
  };
  // It falls 1 m in the root of 0.2 s, between 0.4 s and 0.5 s.
  Scene scene = with_gravity(0.5, 0.25, 1, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 1.5}, {1, 0, 0});
  ToldHits hits;
  auto run = run_of(scene, stepped(0.1));
  run->advance(0.475, std::numeric_limits<std::uint64_t>::max(), &hits);
  CHECK(hits.times.empty());
  CHECK(run->counts().hits == 1);
  run->report_unfinished(hits);
  REQUIRE(hits.times.size() == 1);
  CHECK(std::abs(hits.times[0] - std::sqrt(0.2)) <= 1e-12);
}

TEST_CASE("a bullet does not pass, unless detection is forced off") {
  Random random(7);
  int passed = 0;
  for (int i = 0; i < generators::tried(200); ++i) {
    const double e = random.uniform(0, 1);
    const double half = random.uniform(0.001, 0.01);
    const double v = random.uniform(100, 1000);
    const double y = random.uniform(-0.5, 0.5);
    Scene scene = plan_scenes::empty(e, 0, 2 / v, 1e-6);
    plan_scenes::box(scene, {half, 1, 1}, 0, {0, 0, 0});
    plan_scenes::ball(scene, 0.004, 0.01, {-1 - random.uniform(), y, 0}, {v, 0, 0});
    // The plate's thickness is passed in a tenth of a step.
    const PlanOptions options = stepped(20 * (half + 0.004) / v);
    auto run = run_of(scene, options);
    run->advance(scene.duration);
    const double way = -half - 0.004 - scene.bodies[1].position.x();
    CAPTURE(e, half, v);
    CHECK(std::abs(run->velocity(1).x() + e * v) <= 1e-9 * v);
    CHECK(std::abs(run->position(1).x() - (-half - 0.004 - e * (2 - way))) <= 1e-9);
    CHECK(run->counts().hits == 1);
    PlanOptions off = options;
    off.overrides.without = {Effect::continuous_detection};
    auto blind = run_of(scene, off);
    CHECK_FALSE(has_stage(*blind, "time of impact"));
    blind->advance(scene.duration);
    passed += blind->velocity(1).x() == v ? 1 : 0;
  }
  // Nine of ten tests miss it.
  CHECK(passed > generators::tried(200) / 2);
}

TEST_CASE("the material of a pair is what the format says: the smoother, the less elastic") {
  Scene scene = with_gravity(0.9, 0.9, 1, 1e-6);
  scene.materials.push_back({"other", 0.25, 0.1, std::nullopt, 0});
  plan_scenes::wall(scene, Point::UnitZ(), 0).material = 1;
  plan_scenes::box(scene, {0.5, 0.5, 0.1}, 2, {0, 0, 0.1}, {3, 0, 0});
  plan_scenes::ball(scene, 0.25, 1, {10, 0, 5.25});
  auto run = run_of(scene);
  run->advance(1);
  // 0.1 · 10 m/s² for a second; and the ball hits the floor after a second at 10 m/s.
  CHECK(std::abs(run->velocity(1).x() - 2) <= 1e-9);
  run->advance(1.1);
  CHECK(std::abs(run->velocity(2).z() - (2.5 - 1)) <= 1e-8);
}

TEST_CASE("a ball between two walls hits as often as its speed says, however long the step is") {
  // Its centre has 2 mm from wall to wall and starts halfway: at v it reaches a wall after 1 mm,
  // and then after each 2 mm. Friction stops a rotation of 1 rad/s within the first few hits: that
  // takes I ω²/2 = 0.002 J at most, of 50 J.
  for (const double step : {1.0 / 60, 1.0 / 7, 0.001}) {
    for (const double friction : {0.0, 0.001}) {
      Scene scene = plan_scenes::empty(1, friction, 0.3, 1e-3);
      plan_scenes::wall(scene, Point(1, 0, 0), -0.101);
      plan_scenes::wall(scene, Point(-1, 0, 0), -0.101);
      plan_scenes::ball(scene, 0.1, 1, Point::Zero(), Point(10, 0, 0));
      scene.bodies.back().angular_velocity = Point(0, 0, friction > 0 ? 1 : 0);
      const auto run = run_of(scene, stepped(step));
      const double first = run->energy();
      run->advance(0.29995);  // 2.9995 m of motion: between two hits
      CHECK(run->counts().hits == 1500);
      CHECK(run->counts().crowded_steps == 0);
      const double rubbed = friction > 0 ? 0.0021 : 0;
      CHECK(run->energy() <= first * (1 + 1e-12));
      CHECK(run->energy() >= (first - rubbed) * (1 - 1e-12));
    }
  }
  // With e the n-th flight takes 1/eⁿ times as long as the first. With d = 2 mm and v = 10 m/s:
  Scene scene = plan_scenes::empty(0.999, 0, 0.3, 1e-6);
  plan_scenes::wall(scene, Point(1, 0, 0), -0.101);
  plan_scenes::wall(scene, Point(-1, 0, 0), -0.101);
  plan_scenes::ball(scene, 0.1, 1, Point::Zero(), Point(10, 1, 0));
  const auto run = run_of(scene, stepped(1.0 / 60));
  run->advance(0.3);
  std::uint64_t hits = 0;
  double speed = 10;
  for (double t = 0.001 / speed; t < 0.3; t += 0.002 / speed) {
    ++hits;
    speed *= 0.999;
  }
  CHECK(run->counts().hits == hits);
  // Each hit rounds a few times: for 916 of them less than 1e-12 of the energy.
  CHECK(std::abs(run->energy() - (speed * speed + 1) / 2) < 1e-11);
}

TEST_CASE("a ball between two heavy ones conserves energy, in long steps as in short ones") {
  std::vector<double> energies;
  std::vector<std::uint64_t> hits;
  for (const double step : {1.0 / 60, 1e-4}) {
    Scene scene = plan_scenes::empty(1, 0, 0.05, 1e-6);
    plan_scenes::ball(scene, 0.4, 1e6, Point(-0.502, 0, 0));
    plan_scenes::ball(scene, 0.4, 1e6, Point(0.502, 0, 0));
    plan_scenes::ball(scene, 0.1, 1, Point(0, 0.0001, 0), Point(10, 0, 0));
    const auto run = run_of(scene, stepped(step));
    run->advance(0.05);
    CHECK(run->counts().crowded_steps == 0);
    energies.push_back(run->energy());
    hits.push_back(run->counts().hits);
  }
  CHECK(hits[0] == hits[1]);
  CHECK(hits[0] > 20);
  for (const double energy : energies) CHECK(std::abs(energy - 50) < 50 * 1e-11);
}

TEST_CASE("a step with more impacts than are taken one by one ends, and is counted") {
  // 32 balls may have 65536/32² hits a step. One alone, at 1000 m/s and with 2 mm of room, would
  // have 8333.
  Scene scene = plan_scenes::empty(1, 0, 0.1, 1e-3);
  plan_scenes::wall(scene, Point(1, 0, 0), -0.101);
  plan_scenes::wall(scene, Point(-1, 0, 0), -0.101);
  plan_scenes::ball(scene, 0.1, 1, Point::Zero(), Point(1000, 0, 0));
  for (int k = 1; k < 32; ++k) plan_scenes::ball(scene, 0.1, 1, Point(0, k, 0));
  const auto run = run_of(scene, stepped(1.0 / 60));
  const double energy = run->energy();
  run->advance(1.0 / 60);
  CHECK(run->counts().max_impacts == 64);
  CHECK(run->counts().crowded_steps == 1);
  CHECK(run->counts().hits >= 64);
  CHECK(std::abs(run->energy() - energy) <= 1e-12 * energy);
  const contact::SceneCheckpoint kept = run->checkpoint();
  const auto again = run_of(scene, stepped(1.0 / 60));
  again->restore(kept);
  CHECK(again->counts().crowded_steps == 1);
}

TEST_CASE("long boxes in a narrow room conserve energy, however often they hit in a step") {
  for (const int count : {3, 8}) {
    CAPTURE(count);
    Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
    plan_scenes::walls(scene, Point::Constant(count == 8 ? 2 : 1.44));
    Random random(31);
    for (int k = 0; k < count; ++k) {
      const Point at(0.35 + 0.65 * (k % 2), 0.35 + 0.65 * (k / 2 % 2), 0.35 + 0.65 * (k / 4));
      plan_scenes::box(scene, {0.3, 0.1, 0.1}, 1, at, any_direction(random) * 15).angular_velocity =
          any_direction(random) * 10;
    }
    const auto run = run_of(scene);
    const double energy = run->energy();
    run->advance(generators::tried(8) / 8.0);
    CHECK(run->counts().crowded_steps >= (generators::sanitized ? 1u : 3u));
    CHECK(run->energy() < energy * (1 + 1e-3));
    CHECK(run->energy() > energy * (1 - 1e-2));
  }
}

TEST_CASE("a box that rotates in a plane stays in it to the last bit, whatever it hits") {
  Scene scene = plan_scenes::empty(1, 0.5, 0.5, 1e-3);
  for (const Point& way : {Point(1, 0, 0), Point(0, 1, 0)}) {
    plan_scenes::wall(scene, way, -0.56);
    plan_scenes::wall(scene, -way, -0.56);
  }
  plan_scenes::box(scene, {0.5, 0.2, 0.3}, 1, {0, 0, 4}, {40, 15, 0}).angular_velocity = {0, 0, 30};
  PlanOptions in_space;
  in_space.overrides.with = {Effect::third_dimension};
  const auto flat = run_of(scene);
  const auto all = run_of(scene, in_space);
  CHECK(flat->bytes_per_body() < all->bytes_per_body());
  flat->advance(0.5);
  all->advance(0.5);
  CHECK(flat->counts().crowded_steps > 0);
  CHECK(all->position(4).z() == 4);
  CHECK(all->velocity(4).z() == 0);
  CHECK(all->angular_velocity(4).head<2>() == Eigen::Vector2d::Zero());
  CHECK(all->orientation(4).v.head<2>() == Eigen::Vector2d::Zero());
  CHECK(bits_of(scene, *flat) == bits_of(scene, *all));
}

TEST_CASE("a capsule perpendicular to the plane bounces off a box's edge and keeps all energy") {
  // Edge and capsule are parallel, and touch along a line of which the manifold has one end.
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
  auto& turned = plan_scenes::box(scene, {0.3, 0.3, 0.2}, 2, {0, 0, 0});
  turned.orientation = contact::exponential<double>(Point(0, 0, 0.7));
  turned.angular_velocity = {0, 0, 1};
  plan_scenes::add(scene, contact::CapsuleShape{0.1, 0.12}, 1, {-2, 0.1, 0}, {5, 0, 0});
  REQUIRE_FALSE(plan_scenes::is_on(scene, Effect::third_dimension));
  const auto run = run_of(scene);
  const double energy = run->energy();
  run->advance(1);
  CHECK(run->counts().hits > 0);
  CHECK(std::abs(run->energy() - energy) < 1e-9 * energy);
}

TEST_CASE("boxes on a line hit as often with rotation as without") {
  Scene scene = plan_scenes::empty(1, 0, 0.2, 1e-9);
  plan_scenes::wall(scene, Point(1, 0, 0), -1.01);
  plan_scenes::wall(scene, Point(-1, 0, 0), -1.01);
  plan_scenes::box(scene, Point::Constant(0.5), 1, {-0.505, 0, 0}, {20, 0, 0});
  plan_scenes::box(scene, Point::Constant(0.5), 3, {0.5, 0, 0}, {-1, 0, 0});
  const auto still = run_of(scene);
  const auto turning = run_of(scene, with({Effect::rotation, Effect::gyroscopic_term}));
  still->advance(0.2);
  turning->advance(0.2);
  CHECK(still->counts().hits > 100);
  CHECK(bits_of(scene, *still) == bits_of(scene, *turning));
}

TEST_CASE(
    "touching balls share a hit in steps and pass it on from event to event, and steps say so") {
  // Both are answers of a model: of all contacts at once, or of one after the other.
  Scene scene = plan_scenes::empty(1, 0, 3, 1e-6);
  plan_scenes::ball(scene, 0.5, 1, {-1, 0, 0}, {1, 0, 0});
  for (int k = 1; k <= 4; ++k) plan_scenes::ball(scene, 0.5, 1, {1.0 * k, 0, 0});
  const auto speeds = [&](Effect effect, bool on, std::vector<double> wanted) {
    const auto options = on ? stepped_scenes::with({effect}) : stepped_scenes::without({effect});
    const auto plan = contact::plan_scene(scene, options);
    auto run = contact::scenes::make_run(scene, plan);
    run->advance(3);
    CAPTURE(on);
    for (std::size_t k = 0; k < wanted.size(); ++k)
      CHECK(std::abs(run->velocity(k).x() - wanted[k]) <= 1e-9);
    return contact::kept_tolerance(plan, *run);
  };
  speeds(Effect::event_driven, true, {0, 0, 0, 0, 1});
  const auto kept = speeds(Effect::event_driven, false, {-0.6, 0.4, 0.4, 0.4, 0.4});
  CHECK(std::abs(kept.until - 1) <= 1e-9);
  CHECK(kept.why.find("all at once") != std::string::npos);
}
