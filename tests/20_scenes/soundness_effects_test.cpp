// A plan leaves out only what it may: the run that it decides on, compared with runs with more
// effects. Positions agree within the error of the decision, up to the horizon.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_runs.hpp>
#include <vector>

#include "plan_scenes.hpp"
#include "soundness.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Plan;
using contact::PlanOptions;
using contact::Scene;
using contact::SceneRun;
using generators::Random;
using generators::tried;
using plan_scenes::Point;
using soundness::all_physics;
using soundness::comparable_time;
using soundness::farthest_apart;
using soundness::max_moves;
using soundness::scenes_of_the_book;

namespace {

/// How many effects were forced on, and with how many of them every bit was the same.
struct Compared {
  int effects = 0;
  int same_bits = 0;
  int rounded = 0;     ///< that may differ in rounding
  int scenes = 0;      ///< that can be run in steps
  int met = 0;         ///< of these, in how many something touched something in the time compared
  double largest = 0;  ///< by which one did, m
};

/// Whether an effect that is proven inactive keeps every bit if it is forced on. All do, except the
/// gyroscopic term of an angular velocity that a mirror keeps along a principal axis: ω × I ω is 0,
/// but computing with it rounds differently.
bool keeps_bits(const Plan& plan, const contact::Decision& decision) {
  if (decision.effect != Effect::gyroscopic_term) return true;
  if (!contact::decision_on(plan, Effect::rotation).on) return true;
  return contact::is_proven(decision.tried.at(0)) || contact::is_proven(decision.tried.at(1));
}

/// The largest effect of such rounding, m: in these scenes, of some metres and seconds. A search
/// for an impact ends where two are within 2^-40 of their sizes of touching, and rounding decides
/// at which test that is. The largest that was measured is 3.2e-12.
constexpr double spin_rounding = 0x1p-36;

/// Whether a plan says that bounces that it leaves out, sleep, or a crowd's late hits have no
/// bound.
bool may_add_up(const Plan& plan) {
  return std::isinf(contact::decision_on(plan, Effect::resting).error) ||
         std::isinf(contact::decision_on(plan, Effect::step_size).error) ||
         std::isinf(contact::decision_on(plan, Effect::sleeping).error);
}

/// Until when an effect that is proven to do nothing is tried: until two steps after the first two
/// bodies touch, if that takes no more than so many moves. Bits can be compared beyond the horizon.
double met_time(const Scene& scene, const Plan& plan, double most, double end, bool& met) {
  const auto run = contact::scenes::make_run(scene, plan);
  const auto movers = static_cast<double>(std::count_if(
      scene.bodies.begin(), scene.bodies.end(), [](const auto& body) { return body.moves; }));
  const double last = std::min(most, 40 * max_moves / movers * plan.step);
  const auto touched = [&] { return run->counts().contacts > 0 || run->counts().hits > 0; };
  double time = 0;
  while (time < last && !touched()) run->advance(time = std::min(last, time + plan.step));
  met = touched();
  return std::max(end, std::min(last, time + 2 * plan.step));
}

/// A scene step by step as planned, compared with runs with each effect that its plan leaves out by
/// a proof, for at most `most` seconds; rotation where several contacts are solved together, for
/// two steps, or not at all.
void compare_with_each_effect(const Scene& scene, double most, Compared& compared) {
  PlanOptions options;
  const Plan planned = contact::plan_scene(scene);
  // From event to event there is nothing to switch on: step by step there is.
  options.step = planned.step > 0 ? planned.step : std::min(scene.duration / 128, 1.0 / 240);
  const Plan plan = contact::plan_scene(scene, options);
  const double end = std::min(most, comparable_time(scene, plan));
  for (const Plan* one : {&planned, &plan}) {
    REQUIRE((one->error <= one->tolerance || may_add_up(*one)));
  }
  bool met = false;
  const double bits_until = met_time(scene, plan, most, end, met);
  ++compared.scenes;
  if (met) ++compared.met;
  PlanOptions all = options;
  double left_out = 0;
  for (const Effect effect : all_physics) {
    const contact::Decision& decision = contact::decision_on(plan, effect);
    if (decision.on || !decision.proven) continue;
    PlanOptions with = options;
    with.overrides.with = {effect};
    // Where many contacts are solved together a last bit soon decides which bodies touch, and
    // neither run is nearer the truth.
    const bool same = keeps_bits(plan, decision);
    const bool crowded =
        !same && contact::decision_on(plan, Effect::several_contacts).on && scene.bodies.size() > 6;
    const auto less = contact::scenes::make_run(scene, plan);
    const auto more = contact::scenes::make_run(scene, contact::plan_scene(scene, with));
    double until = crowded ? std::min(end, 2 * plan.step) : end;
    if (same && decision.error == 0) until = bits_until;
    const double apart = farthest_apart(scene, *less, *more, until);
    CAPTURE(scene.name, contact::effect_name(effect), apart);
    if (apart == 0) ++compared.same_bits;
    ++compared.effects;
    REQUIRE(apart <= decision.error + (same ? 0 : spin_rounding));
    if (!same) ++compared.rounded;
    if (!same) compared.largest = std::max(compared.largest, apart - decision.error);
    if (crowded) continue;
    all.overrides.with.push_back(effect);
    left_out += decision.error;
  }
  // All that is left out, at once: the errors add up to the tolerance at most.
  const auto less = contact::scenes::make_run(scene, plan);
  const auto more = contact::scenes::make_run(scene, contact::plan_scene(scene, all));
  const double apart = farthest_apart(scene, *less, *more, end);
  CAPTURE(scene.name, apart, left_out);
  REQUIRE(apart <= left_out + spin_rounding);
  REQUIRE(left_out <= plan.tolerance);
}

/// Up to four bodies of any shape that may lie, slide, fly, rotate, fall or meet, on a floor or
/// without one.
Scene random_bodies(Random& random) {
  Scene scene = plan_scenes::empty(0.5 * random.integer(0, 2), random.chance(0.5) ? 0 : 0.4,
                                   random.uniform(0.1, 1), random.chance(0.2) ? 0 : 1e-6);
  scene.gravity = random.chance(0.3) ? Point::Zero() : Point(0, 0, -random.uniform(1, 10));
  const bool floor = random.chance(0.8);
  if (floor) plan_scenes::wall(scene, Point::UnitZ(), 0);
  const bool along_a_line = random.chance(0.3);
  const int count = random.integer(1, 4);
  for (int i = 0; i < count; ++i) {
    const Point half(random.uniform(0.2, 0.5), random.uniform(0.2, 0.5), random.uniform(0.2, 0.5));
    const bool lies = floor && random.chance(0.6);
    const Point place(1.6 * (i % 2), along_a_line ? 0 : 1.6 * (i / 2),
                      along_a_line && i > 1 ? 4.0 : 1);
    const auto at = [&](double low) { return Point(place.x(), place.y(), lies ? low : place.z()); };
    Point velocity = Point::Zero();
    if (random.chance(0.7)) velocity.x() = random.uniform(-3, 3);
    if (!along_a_line && random.chance(0.5)) velocity.y() = random.uniform(-3, 3);
    if (!lies && random.chance(0.5)) velocity.z() = random.uniform(-3, 3);
    const double mass = random.uniform(0.5, 4);
    const int shape = random.integer(0, 3);
    if (shape == 0)
      plan_scenes::ball(scene, half.x(), mass, at(half.x()), velocity);
    else if (shape == 1 && !lies)
      plan_scenes::add(scene, contact::CapsuleShape{half.x(), half.y()}, mass, at(1), velocity);
    else
      plan_scenes::box(scene, half, mass, at(half.z()), velocity);
    if (!lies && random.chance(0.3))
      scene.bodies.back().angular_velocity = Point(0, 0, random.uniform(-5, 5));
  }
  return scene;
}

}  // namespace

TEST_CASE(
    "each effect that a plan leaves out of the book's scenes makes at most the error that it "
    "says") {
  Compared compared;
  // Where less is tried, one scene of four.
  const std::size_t every = generators::sanitized ? 4 : 1;
  const std::vector<Scene> scenes = scenes_of_the_book();
  for (std::size_t s = 0; s < scenes.size(); s += every)
    compare_with_each_effect(scenes[s], scenes[s].duration, compared);
  CAPTURE(compared.scenes, compared.met, compared.same_bits);
  CHECK(compared.same_bits > tried(120));
  CHECK(compared.scenes == static_cast<int>((scenes.size() + every - 1) / every));
  CHECK(4 * compared.met >= 3 * compared.scenes);
}

TEST_CASE(
    "each effect that a plan leaves out of random scenes makes at most the error that it says") {
  Random random(23);
  Compared compared;
  for (int trial = 0; trial < tried(400); ++trial) {
    const Scene scene = random_bodies(random);
    CAPTURE(trial);
    compare_with_each_effect(scene, 0.05, compared);
  }
  CAPTURE(compared.effects, compared.same_bits);
  CHECK(compared.effects > tried(1200));
  CHECK(compared.same_bits > tried(1000));
  CHECK(compared.rounded > 0);
  // If none of them differed, all would have to have the same bits. Of few, none may.
  if (tried(8) == 8) CHECK(compared.largest > 0);
}

TEST_CASE("a table cancels gravity to the last bit") {
  Random random(33);
  std::uint64_t hits = 0;
  for (int trial = 0; trial < tried(80); ++trial) {
    Scene scene = plan_scenes::empty(random.chance(0.5) ? 1 : random.uniform(0.3, 1), 0, 1, 1e-6);
    scene.gravity = {0, 0, -random.uniform(1, 20)};
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::wall(scene, Point::UnitX(), -1);
    const int count = random.integer(2, 5);
    for (int i = 0; i < count; ++i) {
      const double vx = random.uniform(-3, 3);
      const double vy = random.uniform(-1, 1);
      const double mass = random.uniform(0.5, 4);
      plan_scenes::ball(scene, 0.25, mass, {0.7 * i, 0.1 * (i % 2), 0.25}, {vx, vy, 0});
    }
    PlanOptions options;
    options.step = 1.0 / 240;
    const Plan plan = contact::plan_scene(scene, options);
    REQUIRE_FALSE(contact::decision_on(plan, Effect::gravity).on);
    options.overrides.with = {Effect::gravity};
    const auto less = contact::scenes::make_run(scene, plan);
    const auto more = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
    CAPTURE(trial);
    REQUIRE(farthest_apart(scene, *less, *more, 1) == 0);
    hits += less->counts().hits;
  }
  CHECK(hits > tried(80));
}

namespace {

/// Up to three boxes that tumble, fall a little and meet nothing. Gravity, tumbling, float: what
/// each would be off by if it were left out is about the same.
Scene random_tumbling(Random& random, double tolerance) {
  Scene scene = plan_scenes::empty(1, 0, random.uniform(0.1, 1), tolerance);
  const double t = scene.duration;
  const double slight = std::exp2(random.uniform(-14, -10));
  scene.gravity = {0, slight * random.uniform(0.1, 2) / t, -slight * random.uniform(0.1, 2) / t};
  const int count = random.integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const double a = random.uniform(0.2, 1);
    const double b = random.uniform(0.2, 1);
    const double far = slight / 0x1p-13 * random.uniform(100, 1000);
    const double fast = std::sqrt(slight * random.uniform(0.1, 2)) / t;
    auto& body = plan_scenes::box(scene, {a, b, 1}, 1, {far + 10 * i, far, -far}, {1, 0, 0});
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    body.angular_velocity = fast * Point(x, y, 0.5);
  }
  return scene;
}

/// The largest distance of a box's vertex between two runs.
double corners_apart(const Scene& scene, const SceneRun& one, const SceneRun& other) {
  double farthest = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Point moved = one.position(i) - other.position(i);
    const auto here = contact::matrix_of(one.orientation(i));
    const auto there = contact::matrix_of(other.orientation(i));
    const Point half = std::get<contact::BoxShape>(scene.bodies[i].shape).half_lengths;
    for (int k = 0; k < 8; ++k) {
      const Point corner(k % 2 == 0 ? half.x() : -half.x(), k / 2 % 2 == 0 ? half.y() : -half.y(),
                         k / 4 == 0 ? half.z() : -half.z());
      const Point at = here * corner - there * corner;
      farthest = std::max(farthest, (moved + at).norm());
    }
  }
  return farthest;
}

}  // namespace

TEST_CASE("all that a plan leaves out of free flights at once keeps the tolerance") {
  Random random(27);
  int together = 0;
  int refused = 0;
  int beyond_one = 0;
  for (int trial = 0; trial < tried(600); ++trial) {
    Scene scene = random_tumbling(random, 1e3);
    // With so much tolerance all effects are left out, and the plan gives the error of each.
    const Plan most = contact::plan_scene(scene);
    constexpr Effect effects[] = {Effect::gyroscopic_term, Effect::gravity,
                                  Effect::double_precision};
    for (const Effect effect : effects) REQUIRE(contact::decision_on(most, effect).error > 0);
    scene.tolerance.position = most.error * random.uniform(0.2, 1.2);
    const Plan plan = contact::plan_scene(scene);
    REQUIRE(plan.error <= *scene.tolerance.position);
    PlanOptions everything;
    int off = 0;
    double largest = 0;
    for (const Effect effect : effects) {
      const auto& decision = contact::decision_on(plan, effect);
      const double alone = contact::decision_on(most, effect).error;
      if (decision.on) refused += alone <= *scene.tolerance.position ? 1 : 0;
      if (!decision.on) ++off;
      if (!decision.on) largest = std::max(largest, decision.error);
      everything.overrides.with.push_back(effect);
    }
    everything.overrides.with.push_back(Effect::rotation);
    together += off >= 2 ? 1 : 0;
    const auto less = contact::scenes::make_run(scene, plan);
    const auto more = contact::scenes::make_run(scene, contact::plan_scene(scene, everything));
    REQUIRE_FALSE(more->event_driven());
    for (int k = 1; k <= 4; ++k) {
      less->advance(scene.duration * k / 4);
      more->advance(scene.duration * k / 4);
    }
    const double apart = corners_apart(scene, *less, *more);
    CAPTURE(trial, off, apart, plan.error);
    // Some 60 steps at positions of up to 10 km, each rounded a few times.
    REQUIRE(apart <= plan.error + 1e-9);
    beyond_one += apart > largest ? 1 : 0;
  }
  // Two and three errors together; effects that would fit alone, and are on all the same; and
  // motions for which the largest of the errors is no bound, so that it must be the sum.
  CAPTURE(together, refused, beyond_one);
  CHECK(together > tried(600) / 4);
  CHECK(refused > tried(600) / 4);
  CHECK(beyond_one > 0);
}

TEST_CASE("without detection between steps the error is at most what the plan says") {
  Random random(29);
  int off = 0;
  for (int trial = 0; trial < tried(2000); ++trial) {
    const double e = random.chance(0.4) ? 1 : random.uniform(0, 1);
    const double friction = random.chance(0.5) ? 0 : random.uniform(0, 0.5);
    const double duration = random.uniform(0.1, 4);
    Scene scene = plan_scenes::empty(e, friction, duration, std::exp2(random.uniform(-10, 3)));
    const bool on_floor = random.chance(0.5);
    scene.gravity = {0, 0, on_floor ? -random.uniform(1, 12) : 0};
    const Point v(random.uniform(-2, 2), 0, random.uniform(-4, 1));
    if (on_floor) {
      const double side = random.chance(0.8) ? 1 : -1;  // over a floor, or under a ceiling
      plan_scenes::wall(scene, side * Point::UnitZ(), 0);
      plan_scenes::ball(scene, 0.5, 1, {0, 0, side * random.uniform(0.51, 3)}, side * v);
    } else {
      // At each other, in any direction.
      plan_scenes::ball(scene, 0.5, 1, {0, 0, random.uniform(1.2, 4)}, {0, 0, 2 * v.z()});
      plan_scenes::ball(scene, 0.5, random.chance(0.5) ? 1 : 1e6, {random.uniform(-1, 1), 0, 0});
    }
    PlanOptions options;
    options.step = std::exp2(random.uniform(-11, -5));
    const Plan plan = contact::plan_scene(scene, options);
    const auto& decision = contact::decision_on(plan, Effect::continuous_detection);
    if (decision.on) continue;
    ++off;
    options.overrides.with = {Effect::continuous_detection};
    const auto late = contact::scenes::make_run(scene, plan);
    const auto right = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
    const double apart = farthest_apart(scene, *late, *right, duration);
    CAPTURE(trial, e, friction, apart, decision.error);
    REQUIRE(apart <= decision.error + 1e-9);
    REQUIRE(decision.error <= *scene.tolerance.position);
  }
  CHECK(off > tried(300));
}
