// What a plan leaves out is left out rightly: the run that it decides on, beside runs with more in
// them. Where nothing but a proof of "does nothing" stands behind a decision the bits must be the
// same; elsewhere places agree within what the decision says, up to the horizon.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_make.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
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

// A run in these tests is over when so many moves of bodies are.
constexpr double most_moves = tried(4000);

std::vector<Scene> scenes_of_the_book() {
  std::vector<Scene> scenes;
  for (const auto& file :
       contact::scenes::scenes_in(CONTACT_SOURCE_DIR "/chapters/20_scenes/scenes"))
    scenes.push_back(contact::scenes::read_scene(file));
  return scenes;
}

/// Until when places can be compared: the end, the horizon, or what there is time for. Where bodies
/// with corners turn no horizon is known, and every moment costs more: an eighth of the time.
double comparable_time(const Scene& scene, const Plan& plan) {
  double end = scene.duration;
  const auto& horizon = contact::decision_on(plan, Effect::horizon);
  if (horizon.value) end = std::min(end, *horizon.value);
  const double moves = horizon.on && !horizon.value ? most_moves / 8 : most_moves;
  const auto movers = static_cast<double>(std::count_if(
      scene.bodies.begin(), scene.bodies.end(), [](const auto& body) { return body.moves; }));
  const double step = plan.step > 0 ? plan.step : 1.0 / 60;
  return std::min(end, moves / movers * step);
}

bool same_lie(const contact::Rotor<double>& one, const contact::Rotor<double>& other) {
  return one.w == other.w && one.v == other.v;
}

/// The largest distance between the same bodies of two runs, at sixteen times; 0 only if all bits
/// of places, velocities and spins agree, and of how bodies lie that are no balls.
double farthest_apart(const Scene& scene, SceneRun& one, SceneRun& other, double end) {
  double farthest = 0;
  for (int k = 1; k <= 16; ++k) {
    one.advance(end * k / 16);
    other.advance(end * k / 16);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const double apart = (one.position(i) - other.position(i)).norm();
      farthest = std::max(farthest, apart);
      const bool ball = std::holds_alternative<contact::BallShape>(scene.bodies[i].shape);
      if (one.velocity(i) != other.velocity(i) || one.spin(i) != other.spin(i) ||
          (!ball && !same_lie(one.orientation(i), other.orientation(i))))
        farthest = std::max(farthest, std::numeric_limits<double>::denorm_min());
    }
  }
  return farthest;
}

/// Effects that a run step by step can have beside those of its plan, each of which takes nothing
/// away from its accuracy.
constexpr Effect all_physics[] = {Effect::gravity,         Effect::rotation,
                                  Effect::gyroscopic_term, Effect::friction,
                                  Effect::restitution,     Effect::continuous_detection,
                                  Effect::broad_phase,     Effect::several_contacts,
                                  Effect::resting,         Effect::penalty_contact};

/// Balls that do not touch yet between walls: on a line, in a plane or in space, alike or not, with
/// gravity or without, elastic or not.
Scene random_balls(Random& random) {
  const int dimension = random.integer(1, 3);
  const bool alike = random.integer(0, 1) == 1;
  const double e = random.integer(0, 2) > 0 ? 1 : random.uniform(0.5, 1);
  Scene scene = plan_scenes::empty(e, 0, 2, 1e-6);
  scene.gravity = Point::Zero();
  if (random.integer(0, 1) == 1)
    scene.gravity(random.integer(0, dimension - 1)) = -random.uniform(1, 10);
  plan_scenes::walls(scene, Point(8, 8, 8));
  const int count = random.integer(1, 8);
  for (int i = 0; i < count; ++i) {
    Point x = Point::Constant(4);
    Point v = Point::Zero();
    const int places[3] = {dimension == 1 ? i : i % 2, i / 2 % (dimension == 2 ? 4 : 2), i / 4};
    for (int k = 0; k < dimension; ++k) {
      x(k) = dimension == 1 ? 0.5 + places[k] : 1 + 1.7 * places[k];
      v(k) = random.uniform(-3, 3);
    }
    const double radius = alike ? 0.25 : random.uniform(0.1, 0.49);
    const double mass = alike ? 1 : random.uniform(0.5, 4);
    plan_scenes::ball(scene, radius, mass, x, v);
  }
  return scene;
}

/// The run of a scene of hard balls with every effect, needed or not.
std::unique_ptr<contact::HardSphereRun> with_all_effects(const Scene& scene) {
  return contact::make_hard_spheres(contact::hard_sphere_setup(scene).setup,
                                    contact::HardSphereComposition());
}

/// Whether the least composition of a scene of hard balls has the bits of all effects, at eight
/// times and in its count of hits.
bool least_has_the_bits_of_all(const Scene& scene, double end) {
  const auto least = contact::make_hard_spheres(contact::hard_sphere_setup(scene).setup);
  const auto all = with_all_effects(scene);
  for (int k = 1; k <= 8; ++k) {
    least->advance(end * k / 8);
    all->advance(end * k / 8);
    if (least->counts().hits != all->counts().hits) return false;
    for (std::size_t i = 0; i < least->moving(); ++i) {
      if (least->position(i) != all->position(i)) return false;
      if (least->velocity(i) != all->velocity(i)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("hard balls of the book's scenes have the bits of all effects") {
  int runs = 0;
  for (const Scene& scene : scenes_of_the_book()) {
    if (contact::hard_sphere_refusal(scene)) continue;
    if (!contact::decision_on(contact::plan_scene(scene), Effect::event_driven).on) continue;
    CAPTURE(scene.name);
    const double end = scene.bodies.size() > 1000 ? scene.duration / 16 : scene.duration;
    CHECK(least_has_the_bits_of_all(scene, end));
    ++runs;
  }
  CHECK(runs >= 8);
}

TEST_CASE("hard balls of random scenes have the bits of all effects") {
  Random random(20);
  for (int trial = 0; trial < tried(3000); ++trial) {
    CAPTURE(trial);
    REQUIRE(least_has_the_bits_of_all(random_balls(random), 2));
  }
}

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

/// Whether an effect that is proven to do nothing keeps every bit if it is forced on. All do, but
/// the gyroscopic term of a spin that a mirror keeps along a principal axis: ω × I ω is 0, but who
/// computes with it rounds otherwise.
bool keeps_bits(const Plan& plan, const contact::Decision& decision) {
  if (decision.effect != Effect::gyroscopic_term) return true;
  if (!contact::decision_on(plan, Effect::rotation).on) return true;
  return contact::is_proven(decision.tried.at(0)) || contact::is_proven(decision.tried.at(1));
}

/// What such rounding comes to at most, m: of these scenes, of some metres and seconds. A search
/// for an impact ends where two are within 2^-40 of their sizes of touching, and rounding decides
/// at which look that is. The largest that was measured is 3.2e-12.
constexpr double spin_rounding = 0x1p-36;

/// Whether a plan says that hops it leaves out, what sleeps, or a crowd's late hits have no bound.
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
  const double last = std::min(most, 40 * most_moves / movers * plan.step);
  const auto touched = [&] { return run->counts().contacts > 0 || run->counts().hits > 0; };
  double time = 0;
  while (time < last && !touched()) run->advance(time = std::min(last, time + plan.step));
  met = touched();
  return std::max(end, std::min(last, time + 2 * plan.step));
}

/// A scene step by step as planned, beside runs with each effect that its plan leaves out by a
/// proof, for at most `most` seconds; of spins where several contacts are solved together, for two
/// steps, or not at all.
void compare_with_each_effect(const Scene& scene, double most, Compared& compared) {
  PlanOptions options;
  const Plan planned = contact::plan_scene(scene);
  // From event to event there is nothing to switch on: step by step there is.
  options.step = planned.step > 0 ? planned.step : std::min(scene.duration / 128, 1.0 / 240);
  const Plan plan = contact::plan_scene(scene, options);
  if (contact::scenes::run_refusal(scene, plan)) return;
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
    // Where many contacts are solved together a last bit soon decides who touches whom, and neither
    // run is nearer the truth.
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

/// Up to four bodies of any shape that may lie, slide, fly, turn, fall or meet, on a floor or
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
    if (!lies && random.chance(0.3)) scene.bodies.back().spin = Point(0, 0, random.uniform(-5, 5));
  }
  return scene;
}

}  // namespace

TEST_CASE(
    "each effect that a plan leaves out of the book's scenes makes no more error than it says") {
  Compared compared;
  // Where less is tried, one scene of four.
  const std::size_t every = tried(8) == 8 ? 1 : 4;
  const std::vector<Scene> scenes = scenes_of_the_book();
  for (std::size_t s = 0; s < scenes.size(); s += every)
    compare_with_each_effect(scenes[s], scenes[s].duration, compared);
  CAPTURE(compared.scenes, compared.met, compared.same_bits);
  CHECK(compared.same_bits > tried(120));
  CHECK(compared.scenes == static_cast<int>((scenes.size() + every - 1) / every));
  CHECK(4 * compared.met >= 3 * compared.scenes);
}

TEST_CASE("each effect that a plan leaves out of random scenes makes no more error than it says") {
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

TEST_CASE("what a table cancels of gravity is cancelled to the last bit") {
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
    body.spin = fast * Point(x, y, 0.5);
  }
  return scene;
}

/// The largest distance of a corner of a box from where it is in another run.
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
    // With so much tolerance all is left out, and the plan says what each would be off by.
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
    // Some 60 steps at places of up to 10 km, each rounded a few times.
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

TEST_CASE("where impacts are not looked for between steps the error is what the plan says") {
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
      // At each other, at any slant.
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

namespace {

/// The largest distance of a run from event to event from one step by step that has all of physics,
/// up to a time.
double from_steps_with_everything(const Scene& scene, double end, double step) {
  PlanOptions options;
  options.step = step;
  options.overrides.with.assign(std::begin(all_physics), std::end(all_physics));
  const auto events = contact::scenes::make_run(scene, contact::plan_scene(scene));
  const auto steps = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
  REQUIRE(events->event_driven());
  REQUIRE_FALSE(steps->event_driven());
  return farthest_apart(scene, *events, *steps, end);
}

}  // namespace

TEST_CASE("from event to event, the book's scenes go where steps with all of physics go") {
  int runs = 0;
  for (const Scene& scene : scenes_of_the_book()) {
    const Plan plan = contact::plan_scene(scene);
    if (plan.step > 0 || contact::hard_sphere_refusal(scene)) continue;
    if (!scene.tolerance.position || scene.bodies.size() > 100) continue;
    const double end = comparable_time(scene, plan);
    CAPTURE(scene.name, end);
    const double apart = from_steps_with_everything(scene, end, std::min(end / 64, 1.0 / 240));
    CAPTURE(apart);
    CHECK(apart <= *scene.tolerance.position);
    ++runs;
  }
  CHECK(runs >= 6);
}

TEST_CASE("from event to event, random balls go where steps with all of physics go") {
  Random random(21);
  double farthest = 0;
  for (int trial = 0; trial < tried(400); ++trial) {
    const Scene scene = random_balls(random);
    const Plan plan = contact::plan_scene(scene);
    if (plan.step > 0) continue;
    CAPTURE(trial);
    const double end = comparable_time(scene, plan);
    const double apart = from_steps_with_everything(scene, end, std::min(end / 16, 1.0 / 240));
    farthest = std::max(farthest, apart);
    REQUIRE(apart <= *scene.tolerance.position);
  }
  // They are two programs: the same bits everywhere would mean that one of them was asked twice.
  CHECK(farthest > 0);
}

namespace {

/// What moves begins an ulp faster or slower, in turns: in the same plane, or on the same line.
Scene an_ulp_away(Scene scene) {
  double sign = 1;
  for (auto& body : scene.bodies) {
    body.velocity *= 1 + sign * 0x1p-52;
    sign = -sign;
  }
  return scene;
}

/// Balls of many masses that fall on a line, or one between two slopes.
Scene that_falls(Random& random) {
  Scene scene = plan_scenes::empty(1, 0, 40, std::pow(10.0, -random.integer(3, 9)));
  scene.gravity = Point(0, 0, -10);
  if (random.chance(0.5)) {
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    const int count = random.integer(2, 3);
    for (int i = 0; i < count; ++i) {
      const double mass = std::pow(10.0, random.uniform(-1, 1));
      const double speed = random.uniform(-2, 2);
      const double height = 0.5 + i * random.uniform(0.6, 2);
      plan_scenes::ball(scene, 0.25, mass, {0, 0, height}, {0, 0, speed});
    }
    return scene;
  }
  for (const double side : {-1.0, 1.0}) {
    const double slope = random.uniform(0.2, 1.4);
    plan_scenes::wall(scene, Point(side * std::sin(slope), 0, std::cos(slope)).normalized(), 0);
  }
  const double speed = random.uniform(-2, 2);
  const double height = random.uniform(2, 4);
  plan_scenes::ball(scene, 0.125, 1, {0, 0, height}, {speed, 0, 0});
  return scene;
}

/// Balls in a room, in a crowd in the middle of it, or in a plane; one ball among posts, in a cage
/// of posts or of boxes within a room that is much larger, perhaps with somebody heavy beside it.
Scene that_spreads(Random& random) {
  Scene scene = plan_scenes::empty(1, 0, 20, std::pow(10.0, -random.integer(3, 9)));
  scene.gravity = Point::Zero();
  const int kind = random.integer(0, 6);
  if (kind == 6) return that_falls(random);
  const double decades = random.chance(0.5) ? random.uniform(0, 5) : 0;
  const double room = kind == 0 || kind == 2 ? random.uniform(4.6, 12) : 40;
  plan_scenes::walls(scene, Point(room, room, room));
  const Point middle = Point::Constant(room / 2);
  const auto velocity = [&] {
    Point v = Point::Zero();
    for (int k = 0; k < (kind == 2 ? 2 : 3); ++k) v(k) = random.uniform(-1, 1);
    return v;
  };
  if (kind <= 2) {
    // Discs lie in the plane; nothing begins within anything else.
    const double spacing = kind == 1 ? random.uniform(0.9, 1.2) : (room - 0.8) / 3;
    const int count = random.integer(2, 16);
    for (int i = 0; i < count; ++i) {
      Point x = middle + spacing * (Point(i % 3, i / 3 % 3, i / 9) - Point::Ones());
      if (kind == 2)
        x = Point(0.5 + i % 4 * (room - 1) / 4, 0.5 + i / 4 * (room - 1) / 4, room / 2);
      const Point v = velocity();
      plan_scenes::ball(scene, 0.4, std::pow(10.0, decades * random.uniform()), x, v);
    }
    return scene;
  }
  if (decades > 1) plan_scenes::ball(scene, 0.25, std::pow(10.0, decades), {2, 2, 2});
  const Point v = velocity();
  plan_scenes::ball(scene, 0.25, 1, middle, v);
  const double away = random.uniform(0.6, 1.5);
  for (int i = 0; i < 27; ++i) {
    const Point at(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i == 13 || (kind != 3 && at.squaredNorm() > 1)) continue;
    const Point x = middle + (away + 0.3) * at;
    if (kind < 5)
      plan_scenes::ball(scene, kind == 3 ? 0.3 : 0.75 * away, 0, x);
    else
      plan_scenes::box(scene, {0.2, 0.25, 0.3}, 0, x);
  }
  return scene;
}

}  // namespace

TEST_CASE("before the horizon a run that begins an ulp away is within the tolerance") {
  Random random(77);
  int asked = 0;
  int parted_later = 0;
  for (int i = 0; i < tried(400); ++i) {
    const Scene scene = that_spreads(random);
    const Plan plan = contact::plan_scene(scene);
    const auto horizon = contact::decision_on(plan, Effect::horizon).value;
    if (!horizon) continue;
    const auto run = contact::scenes::make_run(scene, plan);
    const auto twin = contact::scenes::make_run(an_ulp_away(scene), plan);
    const auto apart_at = [&](double time) {
      run->advance(time);
      twin->advance(time);
      double apart = 0;
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        apart = std::max(apart, Point(run->position(b) - twin->position(b)).norm());
      return apart;
    };
    CAPTURE(i, *horizon);
    for (const int eighth : {1, 2, 3, 4, 5, 6, 7, 8})
      CHECK(apart_at(std::min(*horizon, 20.0) * eighth / 8) <= *scene.tolerance.position);
    ++asked;
    if (plan.step > 0 || *horizon > 5) continue;
    if (apart_at(20 * *horizon) > *scene.tolerance.position) ++parted_later;
  }
  CHECK(asked > tried(300));
  CHECK(parted_later > tried(8));  // the horizon is no safer than it has to be
}
