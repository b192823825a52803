// A random search for scenes in which a plan says what is not true. Scenes are made to be near the
// edges of proofs: hits at the same instant, paths that graze a post or a ceiling, walls at any
// angle, friction, losses, springs, equal and different masses. What the plan says of rest and of
// the horizon is compared with runs that share no code with the book's, of the scene and of twins.
// With a hypothesis dropped the same search finds that the claim is false.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <string>
#include <vector>

#include "hypotheses_oracle.hpp"
#include "hypotheses_scenes.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"

using contact::Decision;
using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using generators::Random;
using generators::tried;
using hypotheses::Flat;
using hypotheses::Real;
using hypotheses::twins_apart;
using plan_scenes::Point;

namespace {

/// Paths that only add up rounding errors stay as close as this in all of these scenes.
constexpr double added_up = 1e-9;

/// How many claims were attacked, and how many were false.
struct Attacks {
  int rest = 0;
  int nothing_spreads = 0;
  int until = 0;
  int refuted = 0;
};

/// Whether the impacts of a run accumulate before the end.
template <class Run>
bool comes_to_rest(Run run, double end) {
  int short_flights = 0;
  for (int hit = 0; hit < 20000; ++hit) {
    const auto flight = run.hit(static_cast<Real>(end));
    if (!flight) return false;
    short_flights = *flight < 1e-7 ? short_flights + 1 : 0;
    if (short_flights > 100) return true;
  }
  return false;
}

/// Attacks what a plan says of a scene.
/// @param rests whether impacts accumulate: with gravity, a contact then lasts and is pressed
/// @param apart the distance of twins at a time
template <class Rests, class Apart>
void attack(const Scene& scene, const PlanOptions& options, const Rests& rests, const Apart& apart,
            Attacks& attacks) {
  const contact::Plan plan = contact::plan_scene(scene, options);
  const Decision& resting = contact::decision_on(plan, Effect::resting);
  const Decision& horizon = contact::decision_on(plan, Effect::horizon);
  const int before = attacks.refuted;
  if (resting.proven && !resting.on) {
    ++attacks.rest;
    if (scene.gravity.z() < 0 && rests()) ++attacks.refuted;
  }
  if (horizon.proven && !horizon.on) {
    ++attacks.nothing_spreads;
    if (apart(scene.duration) > added_up) ++attacks.refuted;
  }
  bool bound = false;
  for (const std::string& notice : plan.notices)
    bound = bound || notice.find("by a bound") != std::string::npos;
  if (horizon.value && bound) {
    ++attacks.until;
    if (apart(std::min(*horizon.value, scene.duration)) > *scene.tolerance.position)
      ++attacks.refuted;
  }
  if (attacks.refuted == before || !options.dropped.empty()) return;
  std::string what;
  for (const auto& body : scene.bodies)
    what += body.name + " at " + std::to_string(body.position.x()) + " " +
            std::to_string(body.position.y()) + " " + std::to_string(body.position.z()) + ", v " +
            std::to_string(body.velocity.x()) + " " + std::to_string(body.velocity.z()) + "\n";
  UNSCOPED_INFO(what << resting.why << "\n" << horizon.why);
  CHECK(attacks.refuted == before);
}

/// One ball among one to four half-spaces, in the plane of x and z.
void ball_and_walls(Random& random, const PlanOptions& options, Attacks& attacks) {
  const double e = random.chance(0.5) ? 1 : random.uniform(0.3, 0.95);
  const double friction = random.chance(0.3) ? random.uniform(0.1, 1) : 0;
  Scene scene = plan_scenes::empty(e, friction, friction > 0 ? 64 : 16, 1e-6);
  scene.gravity = random.chance(0.6) ? Point(0, 0, -8) : Point::Zero();
  Point v(random.uniform(-3, 3), 0, random.uniform(-3, 3));
  Point x(0, 0, random.uniform(2, 3));
  const int kind = random.integer(0, 3);
  if (kind == 0) {  // level and vertical walls; the ball may fly into a corner
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    if (random.chance(0.7)) plan_scenes::wall(scene, Point::UnitX(), -2);
    if (random.chance(0.4)) plan_scenes::wall(scene, -Point::UnitX(), -2);
    if (random.chance(0.4)) plan_scenes::wall(scene, -Point::UnitZ(), -4);
    x = {0, 0, 2};
    if (random.chance(0.4)) v = {-1, 0, -1};  // at 1.5 m from both
  } else if (kind == 1) {                     // floor and ceiling, near the energy of a graze
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::wall(scene, -Point::UnitZ(), -2);
    x = {0, 0, 0.75};
    const double above = 0.75;  // v²/2 = g · above
    v = {0, 0, std::sqrt(2 * 8 * above)};
    if (random.chance(0.5)) v.z() *= 1 + std::pow(10.0, -random.uniform(0, 16));
    if (random.chance(0.3)) v.x() = 1;
  } else {  // a V of any angle
    const double half =
        kind == 2 ? 3.14159265358979323846 / (2 * random.integer(2, 6)) : random.uniform(0.3, 1.4);
    plan_scenes::wall(scene, Point(std::cos(half), 0, std::sin(half)).normalized(), 0);
    plan_scenes::wall(scene, Point(-std::cos(half), 0, std::sin(half)).normalized(), 0);
    x = {0, 0, random.uniform(2, 3)};
    if (random.chance(0.5)) v = {0, 0, -random.uniform(0.5, 2)};
    if (half < 0.6) x.z() *= 2;
  }
  plan_scenes::ball(scene, 0.5, 1, x, v);
  const auto run = hypotheses::ball_among_walls(scene, 2);
  attack(
      scene, options, [&] { return comes_to_rest(run, scene.duration); },
      [&](double time) {
        const double sideways =
            twins_apart(run, time, [](auto& twin, Real ulps) { twin.velocity.x += 4 * ulps; });
        return std::max(sideways, twins_apart(run, time, [](auto& twin, Real ulps) {
                          twin.velocity.y += 4 * ulps;
                        }));
      },
      attacks);
}

/// One to four balls on a line, perhaps above a floor and below a ceiling, perhaps arriving at one
/// instant.
void balls_on_a_line(Random& random, const PlanOptions& options, Attacks& attacks) {
  constexpr double losses[] = {1, 1, 0.5, 0};
  Scene scene = plan_scenes::empty(losses[random.integer(0, 3)], 0, 16, 1e-6);
  scene.gravity = random.chance(0.4) ? Point(0, 0, -8) : Point::Zero();
  const bool alike = random.chance(0.3);
  const bool at_once = random.chance(0.5);
  const int count = random.integer(1, 4);
  for (int k = 0; k < count; ++k) {
    const double mass = alike ? 1 : random.integer(1, 4);
    // All reach the second ball, or where it would be, at 1 s.
    const double away = 1 - k;
    const double speed = at_once ? away : random.uniform(-2, 2);
    plan_scenes::ball(scene, 0.25, mass, {0, 0, 3 + 1.5 * k}, {0, 0, speed});
  }
  if (scene.gravity.z() != 0 || random.chance(0.5)) plan_scenes::wall(scene, Point::UnitZ(), 0);
  if (random.chance(0.3)) plan_scenes::wall(scene, -Point::UnitZ(), -9);
  const auto run = hypotheses::balls_on_line(scene, 2);
  attack(
      scene, options, [&] { return comes_to_rest(run, scene.duration); },
      [&](double time) {
        if (scene.materials[0].restitution == 0) return 0.0;  // hits without end
        double apart = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
          apart = std::max(apart, twins_apart(run, time, [&](auto& twin, Real ulps) {
                             twin.velocity[k] += 8 * ulps;
                           }));
        return apart;
      },
      attacks);
}

/// A ball that meets or just misses a fixed one.
void ball_and_post(Random& random, const PlanOptions& options, Attacks& attacks) {
  Scene scene = plan_scenes::empty(1, 0, 16, std::pow(10.0, -random.integer(3, 12)));
  scene.gravity.setZero();
  const double share = std::pow(10.0, -random.uniform(0, 17));
  const double aside = random.chance(0.8) ? 1 - share : 1 + share;
  plan_scenes::ball(scene, 0.5, 0, Point::Zero());
  plan_scenes::ball(scene, 0.5, 1, {-2, aside, 0}, {random.uniform(0.5, 2), 0, 0});
  const auto run = hypotheses::ball_among_posts(scene);
  attack(
      scene, options, [] { return false; },
      [&](double time) {
        return twins_apart(run, time, [](auto& twin, Real ulps) { twin.position.y += ulps / 2; });
      },
      attacks);
}

/// Attacks so many scenes of each kind.
Attacks search(std::uint64_t seed, int scenes, const PlanOptions& options) {
  Random random(seed);
  Attacks attacks;
  for (int k = 0; k < scenes; ++k) {
    ball_and_walls(random, options, attacks);
    balls_on_a_line(random, options, attacks);
    ball_and_post(random, options, attacks);
    if (attacks.refuted > 0 && !options.dropped.empty()) break;
  }
  return attacks;
}

}  // namespace

TEST_CASE("claims: no scene of a search refutes what its plan says is proven, or a bound") {
  const Attacks attacks = search(271, tried(1000), {});
  CAPTURE(attacks.rest, attacks.nothing_spreads, attacks.until);
  CHECK(attacks.refuted == 0);
  CHECK(attacks.rest > tried(700));
  CHECK(attacks.nothing_spreads > tried(300));
  CHECK(attacks.until > tried(300));
}

TEST_CASE("claims: with a hypothesis dropped the search refutes the claim") {
  for (const char* id :
       {"elastic-balls/elastic", "elastic-balls/smooth-beside-others", "last-bounce/ends-before",
        "last-bounce/one-partner", "weightless/no-gravity", "flat-walls/level-walls",
        "flat-walls/smooth-beside-others", "flat-walls/square-corners",
        "flat-walls/no-grazed-ceiling", "one-line/one-falls", "one-line/equal-or-alone",
        "one-line/no-grazed-ceiling", "first-hits/obliqueness"}) {
    CAPTURE(id);
    CHECK(search(272, 2000, hypotheses::without(id)).refuted > 0);
  }
}
