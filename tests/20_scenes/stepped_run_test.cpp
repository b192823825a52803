// Scenes step by step: closed forms, what is kept, that the same gives the same bits, and that what
// is off is neither computed nor stored.
#include <algorithm>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/stepped/step_solver.hpp>
#include <contact/trampoline.hpp>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using contact::SceneRun;
using generators::Random;
using plan_scenes::Point;

namespace {

std::unique_ptr<SceneRun> run_of(const Scene& scene, const PlanOptions& options = {}) {
  return contact::scenes::make_run(scene, contact::plan_scene(scene, options));
}

PlanOptions with(std::vector<Effect> effects) {
  PlanOptions options;
  options.overrides.with = std::move(effects);
  return options;
}
PlanOptions without(std::vector<Effect> effects) {
  PlanOptions options;
  options.overrides.without = std::move(effects);
  return options;
}
PlanOptions stepped(double step) {
  PlanOptions options;
  options.step = step;
  return options;
}

bool has_stage(const SceneRun& run, const std::string& name) {
  const auto stages = run.stages();
  return std::any_of(stages.begin(), stages.end(),
                     [&](const contact::SceneStage& stage) { return stage.name == name; });
}

Scene with_gravity(double restitution, double friction, double duration, double tolerance) {
  Scene scene = plan_scenes::empty(restitution, friction, duration, tolerance);
  scene.gravity = Point(0, 0, -10);
  return scene;
}

/// All that a run says of its bodies, as bits.
std::vector<std::uint64_t> bits_of(const Scene& scene, const SceneRun& run) {
  std::vector<std::uint64_t> bits;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (const Point& v : {run.position(i), run.velocity(i), run.spin(i), run.orientation(i).v})
      for (int k = 0; k < 3; ++k) bits.push_back(std::bit_cast<std::uint64_t>(v(k)));
    bits.push_back(std::bit_cast<std::uint64_t>(run.orientation(i).w));
  }
  return bits;
}

Point total_momentum(const Scene& scene, const SceneRun& run) {
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].moves) sum += run.velocity(i) * scene.bodies[i].mass;
  return sum;
}

Point any_direction(Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    const Point v(x, y, z);
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

void any_body(Random& random, Scene& scene, const Point& x) {
  const int kind = random.integer(0, 2);
  const double a = random.uniform(0.2, 0.4);
  const double b = random.uniform(0.2, 0.4);
  const double c = random.uniform(0.2, 0.4);
  const double mass = random.uniform(1, 3);
  contact::SceneShape shape = contact::BallShape{a};
  if (kind == 1) shape = contact::BoxShape{Point(a, b, c) / 2};
  if (kind == 2) shape = contact::CapsuleShape{a / 2, b / 2};
  contact::SceneBody& body = plan_scenes::add(scene, shape, mass, x);
  const Point axis = any_direction(random);
  const double angle = random.uniform(0, 3);
  body.orientation = contact::exponential<double>(axis * angle);
}

/// Four bodies of any kind that fly at the middle from all sides, turning.
Scene crash(Random& random, double restitution, double friction) {
  Scene scene = plan_scenes::empty(restitution, friction, 1, 1e-6);
  for (const Point& corner :
       {Point(1, 1, 1), Point(-1, -1, 1), Point(-1, 1, -1), Point(1, -1, -1)}) {
    any_body(random, scene, corner);
    contact::SceneBody& body = scene.bodies.back();
    const Point aside = any_direction(random);
    body.velocity = -2 * corner + 0.3 * aside;
    body.spin = 3 * any_direction(random);
  }
  return scene;
}

}  // namespace

TEST_CASE("what the book's scenes expect comes out, where they go step by step") {
  const auto folder = std::filesystem::path(CONTACT_SOURCE_DIR) / "chapters/20_scenes/scenes";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 29);
  int tried = 0;
  for (const auto& file : files) {
    const Scene scene = contact::scenes::read_scene(file);
    if (generators::tried(8) < 8 && scene.bodies.size() > 500) continue;
    const auto plan = contact::plan_scene(scene);
    CAPTURE(scene.name);
    CHECK_FALSE(contact::scenes::run_refusal(scene, plan));
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
  // Friction is even until the box stops within some step; there the solver stops it at the step's
  // end. It comes v h/2 in place of v²/(2 μ g), at most μ g h²/8 more.
  Random random(1);
  for (int i = 0; i < generators::tried(64); ++i) {
    const double mu = random.uniform(0.1, 1);
    const double v = random.uniform(0.5, 3);
    Scene scene = with_gravity(0, mu, 1.5 * v / (mu * 10), 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::box(scene, {0.5, 0.5, 0.1}, random.uniform(0.5, 5), {0, 0, 0.1}, {v, 0, 0});
    auto run = run_of(scene);
    run->advance(scene.duration);
    const double h = run->step();
    const double rest = v * v / (20 * mu);
    CAPTURE(mu, v, h);
    CHECK(run->position(1).x() >= rest - 1e-9);
    CHECK(run->position(1).x() <= rest + mu * 10 * h * h / 8 + 1e-9);
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

TEST_CASE("without contacts a spin stays, or the angular momentum does") {
  Random random(3);
  for (int i = 0; i < generators::tried(24); ++i) {
    Scene scene = with_gravity(0.5, 0.5, 2, 1e-6);
    auto& body = plan_scenes::box(scene, {0.1, 0.2, 0.3}, 2, {0, 0, 100});
    body.spin = any_direction(random) * random.uniform(0.5, 5);
    const Point momentum = body.inertia * body.spin;
    const double energy = body.spin.dot(momentum) / 2;
    auto run = run_of(scene);
    CHECK(has_stage(*run, "rotation"));
    CHECK_FALSE(has_stage(*run, "contacts"));
    run->advance(2);
    const auto turn = contact::matrix_of(run->orientation(0));
    const Point seen = turn.transpose() * run->spin(0);
    const Point own = body.inertia * seen;
    const Point later = turn * own;
    // The momentum is kept by construction, but for rounding. The energy is off by that of the
    // turn: ω T (2^-7)^4/120 of itself at most, about 3e-10 here.
    CHECK((later - momentum).norm() <= 1e-12);
    CHECK(std::abs(seen.dot(own) / 2 - energy) <= 1e-9 * energy);
    // Free fall is exact: 5 t² = 20 m in 2 s, whatever the step.
    CHECK(std::abs(run->position(0).z() - 80) <= 1e-11);
  }
  Scene scene = plan_scenes::empty(0, 0, 1, 1e-6);
  auto& box = plan_scenes::box(scene, {0.1, 0.2, 0.3}, 2, {0, 0, 0});
  box.spin = {0, 0, 3};
  auto run = run_of(scene);
  run->advance(1);
  CHECK((run->spin(0) - box.spin).norm() <= 1e-14);
}

TEST_CASE("collisions keep momentum, and make no energy") {
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
      // Each impulse is given to one and taken from the other: rounding alone, some hundreds of
      // them of at most 10 N s.
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

TEST_CASE("a ball that falls on a soft floor comes to lie m g/k deep") {
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

/// Where a ball is that falls on a floor which gives way like a spring, without loss: its height
/// over the floor at rest, in closed form.
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

TEST_CASE("springs push in parts as short as the tolerance asks for") {
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
    CAPTURE(i, mass, stiffness, height, scene.duration, plan.spring_part, springs.error);
    if (!(springs.error > 0)) continue;  // more than a thousand parts a step
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
    if (plan.spring_part < 0.9 * longest) ++shorter;
    // As the stiffest spring alone would have it.
    plan.spring_part = 0;
    if (farthest() > *scene.tolerance.position) ++needed;
  }
  CAPTURE(shorter, needed);
  CHECK(shorter > generators::tried(24) / 3);
  CHECK(needed > 0);
}

TEST_CASE("boxes on top of each other stay, turning or not") {
  for (const int count : {1, 3, 10}) {
    Scene scene = with_gravity(0, 0.5, 2, 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    for (int i = 0; i < count; ++i) plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 0.5 + i});
    for (const PlanOptions& options :
         {PlanOptions{}, with({Effect::rotation}), without({Effect::sleeping}),
          without({Effect::continuous_detection})}) {
      auto run = run_of(scene, options);
      run->advance(2);
      for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        CAPTURE(count, i);
        // What the sweeps leave, below the tolerance by a factor of ten.
        CHECK((run->position(i) - scene.bodies[i].position).norm() <= 1e-7);
        CHECK(run->velocity(i).norm() <= 1e-7);
      }
    }
  }
}

TEST_CASE("what has been at rest for a second sleeps, and wakes when it is hit") {
  Scene scene = with_gravity(0, 0.5, 3, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 0.5});
  plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 1.5});
  plan_scenes::ball(scene, 0.1, 1, {-5, 0, 1.5}, {3, 0, 7});
  auto run = run_of(scene);
  CHECK(has_stage(*run, "sleep"));
  run->advance(1);
  CHECK(run->counts().rests == 2);
  CHECK((run->position(2) - Point(0, 0, 1.5)).norm() <= 1e-9);
  CHECK(run->velocity(2) == Point(0, 0, 0));
  run->advance(3);
  CHECK(run->position(2).x() > 0.01);
}

TEST_CASE("what creeps does not sleep if it would come farther than the tolerance") {
  // A smooth slope of 1e-9: in 100 s a block comes ½ · 1e-8 · 1e4 m = 5e-5 m.
  Scene scene = with_gravity(0, 0, 100, 1e-6);
  scene.gravity = {1e-8, 0, -10};
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 0.5});
  auto run = run_of(scene, stepped(0.05));
  REQUIRE(has_stage(*run, "sleep"));
  run->advance(100);
  CHECK(std::abs(run->position(1).x() - 5e-5) <= 1e-9);
}

TEST_CASE("hits of a step that is not done are told at the end, at their time") {
  class Hits final : public contact::SceneObserver {
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
  Hits hits;
  auto run = run_of(scene, stepped(0.1));
  run->advance(0.475, std::numeric_limits<std::uint64_t>::max(), &hits);
  CHECK(hits.times.empty());
  CHECK(run->counts().hits == 1);
  run->tell_unfinished(hits);
  REQUIRE(hits.times.size() == 1);
  CHECK(std::abs(hits.times[0] - std::sqrt(0.2)) <= 1e-12);
}

TEST_CASE("a bullet does not pass, unless somebody forces detection off") {
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
  // Nine of ten looks miss it.
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

TEST_CASE("the same scene gives the same bits, wherever one looks on the way") {
  Random random(8);
  for (int i = 0; i < generators::tried(24); ++i) {
    Scene scene = crash(random, 0.5, 0.3);
    scene.gravity = Point(0, 0, -10);
    plan_scenes::wall(scene, Point::UnitZ(), -2);
    auto one = run_of(scene, stepped(1.0 / 60));
    auto other = run_of(scene, stepped(1.0 / 60));
    one->advance(1);
    for (int k = 0; k < 7; ++k) {
      other->advance(other->now() + random.uniform(0, 0.1));
      if (k != 3) continue;
      // And from here on another that goes on from a checkpoint.
      const auto kept = other->checkpoint();
      const auto there = bits_of(scene, *other);
      other = run_of(scene, stepped(1.0 / 60));
      other->restore(kept);
      CHECK(other->now() == kept.now);
      CHECK(bits_of(scene, *other) == there);
    }
    other->advance(1);
    CHECK(bits_of(scene, *one) == bits_of(scene, *other));
    CHECK(one->counts().hits == other->counts().hits);
    CHECK(one->counts().sweeps == other->counts().sweeps);
  }
}

TEST_CASE("a checkpoint of something else is refused") {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-6);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 0}, {1, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {5, 0, 0});
  auto run = run_of(scene, stepped(0.1));
  auto events = run_of(scene);
  REQUIRE(events->event_driven());
  CHECK_THROWS_AS(run->restore(events->checkpoint()), std::invalid_argument);
  CHECK_THROWS_AS(events->restore(run->checkpoint()), std::invalid_argument);
  auto kept = run->checkpoint();
  kept.numbers.pop_back();
  CHECK_THROWS_AS(run->restore(kept), std::invalid_argument);
}

TEST_CASE("what no effect needs is not stored, and what is off is no stage") {
  Scene smooth = with_gravity(0.5, 0, 1, 1e-6);
  plan_scenes::wall(smooth, Point::UnitZ(), 0);
  plan_scenes::ball(smooth, 0.5, 1, {0, 0, 2});
  plan_scenes::ball(smooth, 0.5, 1, {0.2, 0, 4});
  auto run = run_of(smooth, stepped(0.01));
  const std::size_t least = 4 * sizeof(double);  // in a plane
  const std::size_t turning = least + sizeof(double) + sizeof(contact::Rotor<double>);
  const std::size_t resting = sizeof(double) + sizeof(std::int32_t);
  for (const char* name : {"rotation", "springs", "broad phase"})
    CHECK_FALSE(has_stage(*run, name));
  for (const char* name : {"gravity", "contacts", "time of impact"}) CHECK(has_stage(*run, name));
  PlanOptions bare = stepped(0.01);
  bare.overrides.without = {Effect::sleeping, Effect::gravity, Effect::resting,
                            Effect::continuous_detection, Effect::restitution};
  auto least_run = run_of(smooth, bare);
  CHECK(least_run->bytes_per_body() == least);
  for (const char* name :
       {"sleep", "waking", "gravity", "contact forces", "time of impact", "bounces"})
    CHECK_FALSE(has_stage(*least_run, name));
  bare.overrides.with = {Effect::rotation};
  CHECK(run_of(smooth, bare)->bytes_per_body() == turning);
  bare.overrides.without.erase(bare.overrides.without.begin());
  bare.overrides.with.push_back(Effect::sleeping);
  CHECK(run_of(smooth, bare)->bytes_per_body() == turning + resting);
}

TEST_CASE("places and velocities have no coordinate that never changes") {
  Scene line = with_gravity(0.5, 0, 2, 1e-6);
  plan_scenes::wall(line, Point::UnitZ(), 0);
  plan_scenes::ball(line, 0.5, 1, {0.3, -0.7, 2});
  Scene plane = line;
  plan_scenes::ball(plane, 0.5, 1, {0.5, -0.7, 4});
  Scene space = plane;
  plan_scenes::ball(space, 0.5, 1, {0.4, -0.6, 6});
  const auto kept = [](const Scene& scene) {
    return run_of(scene, stepped(0.01))->bytes_per_body() -
           (has_stage(*run_of(scene, stepped(0.01)), "sleep")
                ? sizeof(double) + sizeof(std::int32_t)
                : 0);
  };
  CHECK(kept(line) == 2 * sizeof(double));
  CHECK(kept(plane) == 4 * sizeof(double));
  CHECK(kept(space) == 6 * sizeof(double));
  for (const Scene& scene : {line, plane}) {
    auto few = run_of(scene, stepped(0.01));
    PlanOptions options = stepped(0.01);
    options.overrides.with = {Effect::third_dimension, Effect::second_dimension};
    auto all = run_of(scene, options);
    CHECK(few->bytes_per_body() < all->bytes_per_body());
    few->advance(2);
    all->advance(2);
    CHECK(few->counts().hits > 0);
    CHECK(bits_of(scene, *few) == bits_of(scene, *all));
  }
}

TEST_CASE(
    "balls that roll in a plane have one number for their spins, and the bits of all effects") {
  int hits = 0;
  for (int axis = 0; axis < 3; ++axis) {  // across the plane
    const Point across = Point::Unit(axis);
    const Point along = Point::Unit((axis + 1) % 3);
    const Point up = Point::Unit((axis + 2) % 3);
    Scene scene = with_gravity(0, 0.3, 2, 1e-6);
    scene.gravity = -10 * up;
    plan_scenes::wall(scene, up, 0);
    plan_scenes::wall(scene, -along, -3);
    for (int i = 0; i < 4; ++i) {
      const Point at = (1.25 * i) * along + (0.5 + 0.75 * (i % 2)) * up;
      plan_scenes::ball(scene, 0.5, 1, at - 4 * along);
      scene.bodies.back().velocity = (3 - i) * along + 0.5 * up;
      scene.bodies.back().spin = (2.0 * i - 3) * across;
    }
    PlanOptions options = stepped(0.01);
    auto few = run_of(scene, options);
    options.overrides.with = {Effect::third_dimension};
    auto all = run_of(scene, options);
    CHECK(all->bytes_per_body() - few->bytes_per_body() == 4 * sizeof(double));
    few->advance(2);
    all->advance(2);
    hits += static_cast<int>(few->counts().hits);
    CHECK(bits_of(scene, *few) == bits_of(scene, *all));
    auto again = run_of(scene, stepped(0.01));
    again->restore(few->checkpoint());
    CHECK(bits_of(scene, *again) == bits_of(scene, *few));
  }
  CHECK(hits > 12);
}

TEST_CASE("a smooth ball that moves in a plane or on a line keeps a spin about any axis") {
  Scene scene = with_gravity(1, 0, 1, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 2}).spin = {3, 4, 12};
  PlanOptions options = stepped(0.1);
  options.overrides.with = {Effect::rotation};
  for (const double speed : {0.0, 1.0}) {  // on a line, in a plane
    scene.bodies[1].velocity = {speed, 0, 0};
    auto run = run_of(scene, options);
    run->advance(1);
    CHECK(run->spin(1) == scene.bodies[1].spin);
  }
}

TEST_CASE("the gyroscopic term brings spins along where rotation is off") {
  Scene scene = with_gravity(0, 0.5, 1, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, {0.5, 0.4, 0.3}, 1, {0, 0, 0.3});
  CHECK_FALSE(has_stage(*run_of(scene, without({Effect::rotation})), "rotation"));
  PlanOptions options = with({Effect::gyroscopic_term});
  options.overrides.without = {Effect::rotation, Effect::sleeping};
  auto run = run_of(scene, options);
  CHECK(has_stage(*run, "rotation"));
  // One number for its place and one for its velocity, and two for spins that two mirrors forbid.
  CHECK(run->bytes_per_body() == 4 * sizeof(double) + sizeof(contact::Rotor<double>));
  run->advance(1);
  CHECK((run->position(1) - Point(0, 0, 0.3)).norm() <= 1e-9);
  CHECK(run->spin(1).norm() <= 1e-9);
}

TEST_CASE("what is proved inactive gives the same bits when it is forced on") {
  const auto same = [](const Scene& scene, Effect effect, double step) {
    auto off = stepped(step);
    const auto plan = contact::plan_scene(scene, off);
    CAPTURE(contact::effect_name(effect));
    REQUIRE_FALSE(contact::decision_on(plan, effect).on);
    auto on = off;
    on.overrides.with = {effect};
    auto one = run_of(scene, off);
    auto other = run_of(scene, on);
    one->advance(scene.duration);
    other->advance(scene.duration);
    CHECK(one->counts().hits > 0);
    CHECK(bits_of(scene, *one) == bits_of(scene, *other));
  };
  Random random(9);
  for (int i = 0; i < generators::tried(24); ++i) {
    // Without gravity: balls in a box.
    Scene gas = plan_scenes::empty(random.chance(0.5) ? 1 : 0, 0, 2, 1e-3);
    plan_scenes::walls(gas, {3, 3, 3});
    for (int k = 0; k < 6; ++k) {
      const Point v = any_direction(random) * 3;
      plan_scenes::ball(gas, 0.3, random.uniform(1, 2), {0.6 + k % 2, 0.6 + k / 2 % 2, 0.6 + k / 4},
                        v);
    }
    same(gas, Effect::gravity, 0.02);
    same(gas, Effect::friction, 0.02);
    same(gas, Effect::broad_phase, 0.02);
    same(gas, Effect::rotation, 0.02);
    same(gas, Effect::penalty_contact, 0.02);
    if (gas.materials[0].restitution == 0) same(gas, Effect::restitution, 0.02);
    // With friction balls turn, but need no gyroscopic term.
    gas.materials[0].friction = 0.4;
    same(gas, Effect::gyroscopic_term, 0.02);
  }
}

TEST_CASE("a ball between two walls hits as often as its speed says, however long the step is") {
  // Its middle has 2 mm from wall to wall and starts halfway: at v it comes to a wall after 1 mm,
  // and after each 2 mm from there. Friction stops a spin of 1 rad/s within the first few hits:
  // that takes I ω²/2 = 0.002 J at most, of 50 J.
  for (const double step : {1.0 / 60, 1.0 / 7, 0.001}) {
    for (const double friction : {0.0, 0.001}) {
      Scene scene = plan_scenes::empty(1, friction, 0.3, 1e-3);
      plan_scenes::wall(scene, Point(1, 0, 0), -0.101);
      plan_scenes::wall(scene, Point(-1, 0, 0), -0.101);
      plan_scenes::ball(scene, 0.1, 1, Point::Zero(), Point(10, 0, 0));
      scene.bodies.back().spin = Point(0, 0, friction > 0 ? 1 : 0);
      const auto run = run_of(scene, stepped(step));
      const double first = run->energy();
      run->advance(0.29995);  // 2.9995 m of way: between two hits
      CHECK(run->counts().hits == 1500);
      CHECK(run->counts().crowded_steps == 0);
      const double rubbed = friction > 0 ? 0.0021 : 0;
      CHECK(run->energy() <= first * (1 + 1e-12));
      CHECK(run->energy() >= (first - rubbed) * (1 - 1e-12));
    }
  }
  // With e the n-th way takes 1/eⁿ times as long as the first. With d = 2 mm and v = 10 m/s:
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
  // Each hit rounds a few times: 916 of them come to less than 1e-12 of the energy.
  CHECK(std::abs(run->energy() - (speed * speed + 1) / 2) < 1e-11);
}

TEST_CASE("a ball between two heavy ones keeps its energy, in long steps as in short ones") {
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
  CHECK(run->counts().most_impacts == 64);
  CHECK(run->counts().crowded_steps == 1);
  CHECK(run->counts().hits >= 64);
  CHECK(std::abs(run->energy() - energy) <= 1e-12 * energy);
  const contact::SceneCheckpoint kept = run->checkpoint();
  const auto again = run_of(scene, stepped(1.0 / 60));
  again->restore(kept);
  CHECK(again->counts().crowded_steps == 1);
}

TEST_CASE("in a crowd all impacts of a step are taken at once, and nothing leaves its box") {
  Random random(10);
  Scene scene = with_gravity(0.5, 0.3, 1, 1e-3);
  plan_scenes::walls(scene, {2, 2, 40});
  for (int k = 0; k < 100; ++k) {
    const double x = 0.45 + 0.5 * (k % 4) + random.uniform(-0.01, 0.01);
    const double y = 0.45 + 0.5 * (k / 4 % 4) + random.uniform(-0.01, 0.01);
    plan_scenes::ball(scene, 0.15, 1, {std::min(x, 1.8), std::min(y, 1.8), 0.5 + 0.4 * (k / 16)});
  }
  auto run = run_of(scene);
  CHECK_FALSE(has_stage(*run, "time of impact"));
  const double energy = run->energy();
  run->advance(1);
  CHECK(run->counts().hits > 100);
  CHECK(run->energy() < energy);
  for (std::size_t i = 6; i < scene.bodies.size(); ++i) {
    CAPTURE(i);
    for (int k = 0; k < 2; ++k) {
      CHECK(run->position(i)(k) > 0.1);
      CHECK(run->position(i)(k) < 1.9);
    }
    CHECK(run->position(i).z() > 0.1);
  }
}

namespace {

/// Bodies on a lattice with 0.4 m between them, flying and turning anywhere.
template <class Add>
Scene lattice_of(int count, const Point& gravity, const Add& add) {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
  scene.gravity = gravity;
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  plan_scenes::walls(scene, Point::Constant(1.4 * side));
  Random random(21);
  for (int k = 0; k < count; ++k) {
    const Point cell(k % side, k / side % side, k / side / side);
    contact::SceneBody& body = add(scene, (cell + Point::Constant(0.5)) * 1.4);
    body.velocity = any_direction(random) * 2;
    body.spin = any_direction(random);
  }
  return scene;
}

contact::SceneBody& lattice_ball(Scene& scene, const Point& at) {
  return plan_scenes::ball(scene, 0.5, 1, at);
}
contact::SceneBody& lattice_box(Scene& scene, const Point& at) {
  return plan_scenes::box(scene, {0.3, 0.25, 0.35}, 1, at);
}

}  // namespace

TEST_CASE("an elastic crowd keeps its energy, though its impacts are taken at once") {
  for (const bool boxes : {false, true}) {
    CAPTURE(boxes);
    const Scene scene = lattice_of(100, Point::Zero(), boxes ? lattice_box : lattice_ball);
    const auto run = run_of(scene, without({Effect::event_driven}));
    REQUIRE_FALSE(run->event_driven());
    const double energy = run->energy();
    run->advance(1);
    CHECK(run->counts().hits > 200);
    // Corners turn on while they come to touch, and overlaps are pushed out.
    CHECK(std::abs(run->energy() - energy) < (boxes ? 1e-3 : 1e-6) * energy);
  }
}

TEST_CASE("a crowd of light and heavy balls keeps its energy, and nobody comes into anybody") {
  // Sweeps alone lose a thousandth, and overlap by a ninth of a ball; who is flung out between two
  // heavy ones meets somebody who was not near before.
  for (const double heavy : {1e3, 1e6}) {
    CAPTURE(heavy);
    Scene scene = lattice_of(100, Point::Zero(), lattice_ball);
    for (std::size_t i = 6; i < scene.bodies.size(); ++i) {
      if (i % 2 == 0) continue;
      scene.bodies[i].mass *= heavy;
      scene.bodies[i].inertia *= heavy;
    }
    const auto run = run_of(scene, without({Effect::event_driven}));
    const double energy = run->energy();
    run->advance(1);
    CHECK(run->counts().hits > 200);
    CHECK(std::abs(run->energy() - energy) < 1e-7 * energy);
    CHECK(run->counts().largest_overlap < 1.0 / 64);
  }
}

TEST_CASE("in a crowd what touches somebody who is hit gives way at once") {
  // With the mean of its velocities it would be half a step's way too late: a tenth of a ball.
  Scene scene = plan_scenes::empty(0, 0, 0.1, 1e-3);
  scene.gravity.setZero();
  plan_scenes::ball(scene, 0.5, 1000, {0, 0, 0}, {100, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {1.25, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {2.25, 0, 0});
  for (int k = 0; k < 70; ++k) plan_scenes::ball(scene, 0.5, 1, {0, 5.0 + 2 * k, 0});
  const auto run = run_of(scene);
  run->advance(0.05);
  CHECK(run->velocity(2).x() > 90);
  CHECK(run->counts().largest_overlap < 1e-6);
}

TEST_CASE("a heavy piston does not squeeze a jammed crowd that rubs") {
  Scene scene = plan_scenes::empty(0, 0.5, 0.5, 1e-3);
  scene.gravity.setZero();
  plan_scenes::walls(scene, {5, 5, 5});
  plan_scenes::box(scene, {2.45, 2.45, 0.5}, 1e5, {2.5, 2.5, 4}, {0, 0, -5});
  Random random(12);
  for (int k = 0; k < 75; ++k) {
    const Point cell(k % 5, k / 5 % 5, k / 25);
    plan_scenes::box(scene, {0.35, 0.3, 0.25}, 1, cell + Point::Constant(0.5)).velocity =
        any_direction(random);
  }
  const auto run = run_of(scene);
  run->advance(0.5);
  CHECK(run->energy() < 1e-3 * 1.25e6);
  CHECK(run->counts().largest_overlap < 0.05);
}

TEST_CASE("a crowd that meets no wall keeps its momentum, with friction or without") {
  for (const double friction : {0.0, 0.5}) {
    CAPTURE(friction);
    Scene scene = lattice_of(70, Point::Zero(), lattice_box);
    scene.bodies.erase(scene.bodies.begin(), scene.bodies.begin() + 6);
    scene.materials[0].friction = friction;
    const auto run = run_of(scene);
    const Point moving = total_momentum(scene, *run);
    const double energy = run->energy();
    run->advance(0.5);
    CHECK(run->counts().hits > 20);
    CHECK((total_momentum(scene, *run) - moving).norm() < 1e-11);
    CHECK(run->energy() < energy * (friction > 0 ? 0.99 : 1.0001));
  }
}

TEST_CASE("in a crowd each ball bounces to e² of its height, and two of one mass swap speeds") {
  Scene scene = with_gravity(0.8, 0, 1, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  for (int k = 0; k < 70; ++k) plan_scenes::ball(scene, 0.1, 1 + k, Point(k, 0, 0.2 + 0.01 * k));
  const auto run = run_of(scene, without({Effect::event_driven}));
  run->advance(0.48);  // the lowest has not come down again, the highest has
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    CAPTURE(i);
    const double drop = scene.bodies[i].position.z() - 0.1;
    const double speed = run->velocity(i).z();
    const double apex = run->position(i).z() - 0.1 + speed * speed / 20;
    const double down = std::sqrt(drop / 5);
    if (down < 0.46 && 2.6 * down > 0.5) CHECK(std::abs(apex - 0.64 * drop) <= 1e-12);
  }
  Scene pairs = plan_scenes::empty(1, 0, 1, 1e-3);
  for (int k = 0; k < 35; ++k) {
    plan_scenes::ball(pairs, 0.1, 1, Point(0, k, 0), Point(1 + k, 0, 0));
    plan_scenes::ball(pairs, 0.1, 1, Point(0.3, k, 0), Point(-2, 0, 0));
  }
  const auto swapped = run_of(pairs, without({Effect::event_driven}));
  swapped->advance(0.1);
  for (std::size_t k = 0; k < 35; ++k) {
    CAPTURE(k);
    CHECK(std::abs(swapped->velocity(2 * k).x() + 2) <= 1e-12 * 40);
    CHECK(std::abs(swapped->velocity(2 * k + 1).x() - 1 - static_cast<double>(k)) <= 1e-12 * 40);
  }
}

TEST_CASE("boxes that hit more often in a step than is taken one by one keep their bounces") {
  const Scene scene = lattice_of(20, Point(0, 0, -10), lattice_box);
  const auto run = run_of(scene);
  const double energy = run->energy();
  run->advance(1);
  CHECK(run->counts().crowded_steps > 0);
  CHECK(std::abs(run->energy() - energy) < 0.005 * energy);
  CHECK(run->counts().largest_overlap < 0.05);
}

TEST_CASE("in a crowd thin plates that meet face to face do not pass") {
  for (const double e : {0.0, 0.5, 1.0}) {
    CAPTURE(e);
    Scene scene = plan_scenes::empty(e, 0, 0.1, 1e-3);
    for (int k = 0; k < 35; ++k) {
      plan_scenes::box(scene, {0.02, 0.3, 0.2}, 1, {-0.5, 1.0 * k, 0}, {50, 0, 0});
      plan_scenes::box(scene, {0.02, 0.3, 0.2}, 1, {0.5, 1.0 * k, 0}, {-50, 0, 0});
    }
    const auto run = run_of(scene, with({Effect::continuous_detection}));
    run->advance(0.1);
    for (std::size_t i = 0; i < 70; i += 2) {
      CAPTURE(i);
      CHECK(run->position(i + 1).x() - run->position(i).x() > 0.039);
      CHECK(std::abs(run->velocity(i).x() + e * 50) < 1e-4);
      CHECK(std::abs(run->velocity(i + 1).x() - e * 50) < 1e-4);
    }
  }
}

TEST_CASE("thin plates that a hit turns fast do not turn through each other") {
  for (const std::size_t others : {0, 63}) {
    CAPTURE(others);
    Scene scene = plan_scenes::empty(0, 0.3, 0.05, 1e-3);
    plan_scenes::box(scene, {0.002, 0.3, 0.2}, 1, {-0.5, 0, 0}, {100, 0, 0}).spin = {0, 0.9, 0.6};
    plan_scenes::box(scene, {0.002, 0.3, 0.2}, 1, {0.5, 0, 0}, {-100, 0, 0}).spin = {0, -0.6, 0.4};
    for (std::size_t k = 0; k < others; ++k)
      plan_scenes::ball(scene, 0.1, 1, {100, static_cast<double>(k), 0});
    const auto run = run_of(scene);
    for (int k = 1; k <= 20; ++k) {
      run->advance(0.05 * k / 20);
      CHECK(run->position(0).x() < run->position(1).x());
    }
    CHECK(run->counts().hits > 0);
    CHECK(run->counts().largest_overlap < 0.002);
  }
}

TEST_CASE("plates meet where their edges are, though their spins change by themselves meanwhile") {
  // A plate's spin leans over within a step. Taken for even, plates come into each other by several
  // thicknesses; and where two edges almost touch, a normal that is off looks like a hit for ever.
  Random random(31);
  std::uint64_t hits = 0;
  std::uint64_t crowded = 0;
  for (int n = 0; n < 48; ++n) {
    CAPTURE(n);
    const double half = n % 2 == 0 ? 0.002 : 0.05;
    Scene scene = plan_scenes::empty(1, 0, 0.6, 1e-6);
    for (const double side : {-0.5, 0.5}) {
      const Point aside = any_direction(random) * 0.1;
      auto& plate = plan_scenes::box(scene, {0.25, 0.25, half}, 1, Point(side, 0, 0) + aside,
                                     Point(-4 * side, 0, 0));
      plate.orientation = contact::exponential<double>(any_direction(random) * 3.0);
      plate.spin = any_direction(random) * 50;
    }
    const auto run = run_of(scene);
    const double energy = run->energy();
    run->advance(0.6);
    CHECK(run->counts().largest_overlap < 1e-3 * half);
    CHECK(std::abs(run->energy() - energy) < 1e-11 * energy);
    hits += run->counts().hits;
    crowded += run->counts().crowded_steps;
  }
  CHECK(hits > 40);
  CHECK(crowded < hits / 4);
}

TEST_CASE("towers in a crowd stand as still as they do alone, and come to sleep") {
  Scene scene = with_gravity(0.3, 0.5, 2, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  for (int k = 0; k < 70; ++k)
    plan_scenes::box(scene, Point::Constant(0.5), 1, {4.0 * (k / 7), 0, 0.5 + k % 7});
  const auto run = run_of(scene);
  run->advance(2);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    CAPTURE(i);
    CHECK((run->position(i) - scene.bodies[i].position).norm() < 1e-3);
    CHECK(run->velocity(i).norm() == 0);
  }
}

TEST_CASE("a staggered tower stands still and comes to sleep, whatever lies on what") {
  struct Tower {
    int boxes;
    double heavy;  // kg, of each second one or the topmost
    bool topmost;
    double most;  // m
  };
  for (const Tower& tower :
       {Tower{10, 1, true, 1e-12}, Tower{30, 1, true, 1e-11}, Tower{10, 1e3, true, 1e-9},
        Tower{10, 1e6, true, 1e-7}, Tower{20, 1e6, false, 1e-6}, Tower{40, 1e5, false, 1e-6}}) {
    CAPTURE(tower.boxes, tower.heavy, tower.topmost);
    Scene scene = with_gravity(0, 0.5, 1, 1e-3);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    for (int k = 0; k < tower.boxes; ++k) {
      const bool heavy = tower.topmost ? k == tower.boxes - 1 : k % 2 == 1;
      plan_scenes::box(scene, Point::Constant(0.5), heavy ? tower.heavy : 1,
                       {0.1 * (k % 2), 0, 0.5 + k});
    }
    const auto run = run_of(scene);
    run->advance(1);
    CHECK(run->counts().hits == 0);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
      CAPTURE(i);
      CHECK((run->position(i) - scene.bodies[i].position).norm() < tower.most);
      CHECK(run->velocity(i).norm() == 0);
    }
  }
}

namespace {

/// Boxes on a slope of 3 in 4, each on the one before, the last one of another mass.
Scene boxes_on_a_slope(double friction, double load) {
  Scene scene = with_gravity(0, friction, 0.5, 1e-4);
  const Point normal(0.6, 0, 0.8);
  plan_scenes::wall(scene, normal, 0);
  double low = 0;
  for (const double half : {0.05, 0.05, 0.05, 0.25}) {
    auto& box =
        plan_scenes::box(scene, {0.5, 0.5, half}, half > 0.1 ? load : 1, normal * (low + half));
    // By the angle whose half has the cosine 3/√10: the box's z is the slope's normal.
    box.orientation = {3 / std::sqrt(10.0), {0, 1 / std::sqrt(10.0), 0}};
    low += 2 * half;
  }
  return scene;
}

}  // namespace

TEST_CASE("plates on a slope stay or slide as its angle says, whatever lies on them") {
  // A plate under a load is pushed and rubbed a million times as hard as it is heavy. That rounds
  // to 2⁻⁴⁰ of it a step, and is still below 1e-7 m after thirty. What slides is at its limit on
  // both faces: nothing brings a plate back that has come off the load by a little.
  for (const double load : {1.0, 1e3, 1e6}) {
    for (const double steep : {0.99, 1.01}) {  // times the friction angle's tangent
      const double friction = 0.75 / steep;
      const Scene scene = boxes_on_a_slope(friction, load);
      const auto run = run_of(scene);
      run->advance(0.5);
      const double way = std::max(0.0, 10 * (0.6 - friction * 0.8)) / 8;
      for (std::size_t i = 1; i <= 4; ++i) {
        const Point moved = run->position(i) - scene.bodies[i].position;
        CAPTURE(load, steep, i, way, moved);
        CHECK((moved - Point(0.8, 0, -0.6) * way).norm() < (way > 0 && i < 4 ? 1e-3 : 1e-7));
      }
    }
  }
}

TEST_CASE("a heavy box comes to rest on light ones, which stand or go with it") {
  // μ = 1/2: from 1 m/s it stops after 0.2 s and 0.1 m, or, if that is a rounding later than the
  // end of a step, up to μ g h²/8 farther.
  for (const double load : {1.0, 1e3, 1e6}) {
    for (const double carried : {0.0, 1.0}) {
      Scene scene = with_gravity(0, 0.5, 0.4, 1e-4);
      plan_scenes::wall(scene, Point::UnitZ(), 0);
      for (const double x : {-0.6, 0.6})
        plan_scenes::box(scene, {0.3, 0.5, 0.1}, 1, {x, 0, 0.1}, {carried, 0, 0});
      plan_scenes::box(scene, {1, 0.5, 0.25}, load, {0, 0, 0.45}, {1, 0, 0});
      const auto run = run_of(scene);
      for (const double t : {0.1, 0.4}) {
        run->advance(t);
        const double speed = std::max(0.0, 1 - 5 * t);
        const double way = 0.1 - speed * speed / 10;
        for (std::size_t i = 1; i <= 3; ++i) {
          CAPTURE(load, carried, t, i);
          const double share = i == 3 ? 1 : carried;
          const Point moved = run->position(i) - scene.bodies[i].position;
          const double late = speed > 0 ? 0 : 5 * run->step() * run->step() / 8;
          CHECK((moved - Point::UnitX() * (share * way)).norm() < 1e-6 + late);
          CHECK((run->velocity(i) - Point::UnitX() * (share * speed)).norm() < 1e-6);
        }
      }
    }
  }
}

TEST_CASE("what slides at a slant comes to rest on a straight line, whatever lies on it") {
  const Point way(0.8, 0.6, 0);
  for (const double load : {1.0, 1e3, 1e6}) {
    Scene scene = with_gravity(0, 0.4, 0.6, 1e-4);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::box(scene, {0.5, 0.5, 0.1}, 1, {0, 0, 0.1}, way * 2);
    plan_scenes::box(scene, {0.3, 0.3, 0.1}, load, {0, 0, 0.3}, way * 2);
    const auto run = run_of(scene);
    run->advance(0.6);
    for (std::size_t i = 1; i <= 2; ++i) {
      CAPTURE(load, i);
      const Point moved = run->position(i) - scene.bodies[i].position;
      // 2²/(2 μ g), in thirty steps; a light one below is held by as much as it is drawn.
      CHECK(std::abs(moved.dot(way) - 0.5) < (i == 2 ? 1e-7 : 1e-3));
      CHECK((moved - way * moved.dot(way)).norm() < 1e-7);
      CHECK(run->velocity(i).norm() < 1e-6);
    }
  }
}

TEST_CASE("what falls along a wall that it comes to falls as if nothing cut its steps") {
  for (const int balls : {0, 1, 2, 3}) {
    CAPTURE(balls);
    Scene scene = with_gravity(0, 0, 1.0 / 60, 1e-4);
    plan_scenes::wall(scene, Point::UnitY(), 0);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    // It lies along the wall, one end touches it, and the other comes to it over a millimetre.
    const double angle = std::asin(1e-3 / 0.4);
    auto& capsule =
        plan_scenes::add(scene, contact::CapsuleShape{0.05, 0.2}, 1, {0, 0.0505, 3}, {0, -0.2, 0});
    capsule.orientation = contact::exponential<double>(Point(0, 0, angle)) *
                          contact::exponential<double>(Point(0, std::acos(-1.0) / 2, 0));
    capsule.spin = {0, 0, -1};
    for (int k = 0; k < balls; ++k)
      plan_scenes::ball(scene, 0.05, 1, {2.0 + k, 1, 0.055 + 0.005 * k}, {0, 0, -5});
    const auto run = run_of(scene);
    run->advance(1.0 / 60);
    CHECK(std::abs(run->velocity(2).z() + 10.0 / 60) < 1e-12);
    CHECK(std::abs(run->position(2).z() - (3 - 5.0 / 3600)) < 1e-12);
  }
}

TEST_CASE("an elastic ball comes back up from a box that much lies on") {
  for (const double load : {1.0, 1e4, 1e6}) {
    CAPTURE(load);
    Scene scene = with_gravity(1, 0, 0.4, 1e-3);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::box(scene, {1, 0.5, 0.5}, 1, {0, 0, 0.5});
    plan_scenes::box(scene, {0.5, 0.5, 0.5}, load, {-0.2, 0, 1.5});
    plan_scenes::ball(scene, 0.1, 1e-3, {0.8, 0, 1.3});
    const auto run = run_of(scene);
    run->advance(0.4);  // it falls by 0.2 m in 0.2 s, and is back
    CHECK(run->counts().hits > 0);
    CHECK(std::abs(run->position(3).z() - 1.3) < 1e-3);
  }
}

TEST_CASE("a plate that leaves another with a corner beyond its edge does not fall through it") {
  Scene scene = with_gravity(0, 0.5, 0.1, 1e-4);
  plan_scenes::box(scene, {0.5, 0.5, 0.0005}, 0, {0, 0, -0.0005});
  auto& plate = plan_scenes::box(scene, {0.25, 0.25, 0.0005}, 1, {0.4, 0, 0.0005}, {0, 0, 0.001});
  plate.spin = {0, 0.006, 0};
  const auto run = run_of(scene);
  run->advance(0.1);
  CHECK(std::abs(run->position(1).z() - 0.0005) < 1e-5);
  CHECK(run->counts().largest_overlap < 5e-5);
}

TEST_CASE("long boxes in a narrow room keep their energy, however often they hit in a step") {
  for (const int count : {3, 8}) {
    CAPTURE(count);
    Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
    plan_scenes::walls(scene, Point::Constant(count == 8 ? 2 : 1.44));
    Random random(31);
    for (int k = 0; k < count; ++k) {
      const Point at(0.35 + 0.65 * (k % 2), 0.35 + 0.65 * (k / 2 % 2), 0.35 + 0.65 * (k / 4));
      plan_scenes::box(scene, {0.3, 0.1, 0.1}, 1, at, any_direction(random) * 15).spin =
          any_direction(random) * 10;
    }
    const auto run = run_of(scene);
    const double energy = run->energy();
    run->advance(1);
    CHECK(run->counts().crowded_steps > 2);
    CHECK(run->energy() < energy * (1 + 1e-3));
    CHECK(run->energy() > energy * (1 - 1e-2));
  }
}

TEST_CASE("a box that turns in a plane stays in it to the last bit, whatever it hits") {
  Scene scene = plan_scenes::empty(1, 0.5, 0.5, 1e-3);
  for (const Point& way : {Point(1, 0, 0), Point(0, 1, 0)}) {
    plan_scenes::wall(scene, way, -0.56);
    plan_scenes::wall(scene, -way, -0.56);
  }
  plan_scenes::box(scene, {0.5, 0.2, 0.3}, 1, {0, 0, 4}, {40, 15, 0}).spin = {0, 0, 30};
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
  CHECK(all->spin(4).head<2>() == Eigen::Vector2d::Zero());
  CHECK(all->orientation(4).v.head<2>() == Eigen::Vector2d::Zero());
  CHECK(bits_of(scene, *flat) == bits_of(scene, *all));
}

TEST_CASE("a capsule across the plane bounces off a box's edge and keeps all energy") {
  // Edge and capsule are parallel, and touch along a line of which the manifold has one end.
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
  auto& turned = plan_scenes::box(scene, {0.3, 0.3, 0.2}, 2, {0, 0, 0});
  turned.orientation = contact::exponential<double>(Point(0, 0, 0.7));
  turned.spin = {0, 0, 1};
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

TEST_CASE("what is dropped into a box stays in it and loses energy") {
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
      // Its middle is inside: what rests on the floor may overlap it by what pushing out leaves.
      for (int k = 0; k < 3; ++k) {
        CHECK(run->position(b)(k) > 0.05);
        CHECK(run->position(b)(k) < (k < 2 ? 1.95 : 9.95));
      }
    }
  }
}

TEST_CASE("a hull meets half-spaces, and is refused beside anything else") {
  Scene scene = with_gravity(0, 0.5, 1, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  contact::HullShape cube;
  for (int k = 0; k < 8; ++k)
    cube.points.push_back(Point(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1) * 0.1);
  plan_scenes::add(scene, cube, 1, {0, 0, 0.6});
  REQUIRE_FALSE(contact::scenes::run_refusal(scene, contact::plan_scene(scene)));
  auto run = run_of(scene);
  run->advance(1);
  CHECK(std::abs(run->position(1).z() - 0.1) <= 1e-9);
  plan_scenes::ball(scene, 0.1, 1, {0, 0, 2});
  const auto refusal = contact::scenes::run_refusal(scene, contact::plan_scene(scene));
  REQUIRE(refusal);
  CHECK(refusal->find("bodies[1].shape (body_1)") != std::string::npos);
  CHECK(refusal->find("half-spaces only") != std::string::npos);
  CHECK_THROWS_AS(run_of(scene), std::invalid_argument);
}

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

TEST_CASE("what goes on in steps has the tolerance that hops from event to event have left") {
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
  // Half of the tolerance is left, and half of that is for hops: v²/(2 g) = 25 µm.
  const double rest = std::sqrt(20 * 0.25e-4);
  CHECK(slowest.speed >= rest);
  CHECK(slowest.speed <= rest / 0.9);
}

TEST_CASE("forced off, gravity and restitution are gone from event to event too") {
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

TEST_CASE("contacts are solved together exactly where bodies that move link them") {
  Random random(31);
  for (int round = 0; round < generators::tried(500); ++round) {
    contact::SteppedSetup setup;
    contact::SteppedState state;
    const int count = random.integer(2, 12);
    setup.bodies.resize(static_cast<std::size_t>(count));
    setup.movers = static_cast<std::size_t>(random.integer(1, count));
    state.sleeps_with.assign(setup.movers, -1);
    for (int& with : state.sleeps_with) with = random.chance(0.1) ? 0 : -1;
    std::vector<contact::BodyContact<double>> contacts(
        static_cast<std::size_t>(random.integer(0, 14)));
    for (auto& one : contacts) {
      one.a = random.integer(0, count - 1);
      one.b = random.integer(0, count - 1);
    }
    // Linked by one body, then by links of links until nothing changes.
    const std::size_t n = contacts.size();
    std::vector<std::vector<bool>> linked(n, std::vector<bool>(n));
    const auto moves = [&](int body) {
      const auto place = static_cast<std::size_t>(body);
      return place < setup.movers && state.sleeps_with[place] < 0;
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (const int body : {contacts[i].a, contacts[i].b})
          if (i == j || (moves(body) && (body == contacts[j].a || body == contacts[j].b)))
            linked[i][j] = true;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (linked[i][k] && linked[k][j]) linked[i][j] = true;
    std::vector<int> island(n, -1);
    const auto found = contact::detail::islands(setup, state, contacts);
    for (std::size_t k = 0; k < found.size(); ++k)
      for (const std::size_t i : found[k]) {
        REQUIRE(island[i] == -1);
        island[i] = static_cast<int>(k);
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) REQUIRE((island[i] == island[j]) == linked[i][j]);
  }
}

TEST_CASE("the hops that a run leaves out are those that its plan leaves out") {
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
    // And not many times fewer than could be: of two hops that follow each other one is e² as high.
    if (run->counts().rests == 0) continue;
    ++rested;
    CHECK(run->counts().rest_error >= events.error * 0.03);
  }
  CHECK(rested > generators::tried(100) / 2);
}

namespace {

/// Hits of a run, as the observer sees them.
struct Hits final : contact::SceneObserver {
  std::vector<contact::SceneHit> seen;
  bool on_hit(const contact::SceneHit& hit) override {
    seen.push_back(hit);
    return true;
  }
};

}  // namespace

TEST_CASE("however slowly, a ball that falls along a wall bounces off it") {
  // Its way across is the unfolded one, with e of the speed after each wall; gravity has no say.
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
    // Places far down are rounded: 2 km at 2^-40 of that, at each touch.
    CHECK(std::abs(run->position(2).x() - x) <= 1e-7);
    CHECK(std::abs(run->velocity(2).x() - v) <= 1e-12);
    CHECK(contact::decision_on(plan, Effect::resting).error == 0);
    CHECK(plan.error <= 1e-2);
  }
}

TEST_CASE("under a ceiling a slow ball bounces as a fast one does") {
  // It comes up with w, leaves with e w, and falls.
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

TEST_CASE("bodies that fall together hit each other however slowly, and come to an end of it") {
  // Balls in a row, the first slow: with e each hit hands on (1 + e)/2 of the speed. What each has
  // in the end is a product of these as long as nobody is caught up with, which 10 s do not do.
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
  // Between two that come together the middle one hits without end: each time a part of the gap is
  // left, and when rounding cannot tell it from none all three are solved together.
  Scene caught = with_gravity(0.5, 0, 10, 1e-2);
  plan_scenes::ball(caught, 0.1, 1e3, {-0.3, 0, 0}, {0.05, 0, 0});
  plan_scenes::ball(caught, 0.1, 1, {0.03, 0, 0});
  plan_scenes::ball(caught, 0.1, 1e3, {0.3, 0, 0}, {-0.05, 0, 0});
  const auto squeezed = run_of(caught);
  squeezed->advance(5);
  const contact::SceneRunCounts counts = squeezed->counts();
  CHECK(counts.hits > 10);
  CHECK(counts.parts < 20 * counts.steps);
  squeezed->advance(10);
  CHECK(squeezed->counts().hits == counts.hits);
  CHECK(total_momentum(caught, *squeezed).head<2>().norm() <= 1e-9);
}

TEST_CASE("balls that roll on a floor hit each other however slowly") {
  // The floor's normal is upright: it changes nothing along the line of the balls. The rolling one
  // rubs the other down by μ P at most, and so the floor rubs that by μ² P at most. For the balls
  // to part with e v the hit must be (1 + e) v = 2 P, and more by what the floor takes.
  Random random(83);
  for (int i = 0; i < generators::tried(16); ++i) {
    const double e = random.uniform(0.5, 0.95);
    const double v = random.uniform(0.02, 0.09);
    Scene scene = with_gravity(e, 0.2, 2, 1e-2);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    auto& cue = plan_scenes::ball(scene, 0.1, 1, {0, 0, 0.1}, {v, 0, 0});
    cue.spin = Point(0, v / 0.1, 0);
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

TEST_CASE("on a steep slope hops are left out by their height along its normal") {
  // Along the normal a ball bounces as on a level floor with g cos α. What is left out is at most
  // what the plan says, and the hop with which it begins is far above that.
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
    double start = -std::sqrt(2 * height / g);  // of the first, as if it had come up before
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
    // Its places are rounded at 720 m, which each bounce hands on.
    CHECK(most <= error + 1e-7);
  }
  CHECK(rested > generators::tried(24) / 2);
}
