// Every hypothesis of the planner's proofs has a scene that refutes the proof without it. With the
// hypothesis dropped the plan says "proven" of that scene, and without dropping it does not. What
// is claimed there is then seen to be false: by a run that shares no code with the book's, by exact
// arithmetic, or by a run of the scene as planned with all hypotheses.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/scene/scene_runs.hpp>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "hypotheses_oracle.hpp"
#include "hypotheses_scenes.hpp"
#include "plan_scenes.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Hypothesis;
using contact::Scene;
using hypotheses::Real;
using hypotheses::refuting;
using hypotheses::twins_apart;
using hypotheses::without;
using oracle::exact;
using oracle::Rational;
using plan_scenes::decision;
using plan_scenes::Point;

TEST_CASE("hypotheses: each has a scene that refutes its proof, and each scene a hypothesis") {
  std::set<std::string> named;
  int without_scene = 0;
  for (const Hypothesis& one : contact::proof_hypotheses()) {
    CAPTURE(one.id);
    CHECK_FALSE(contact::proof_claim(hypotheses::proof_of(one.id)).empty());
    without_scene += one.scene.empty() ? 1 : 0;
    if (one.scene.empty()) CHECK(one.why.find("No scene") != std::string_view::npos);
    if (!one.scene.empty()) named.emplace(one.scene);
  }
  CHECK(without_scene <= 2);
  std::set<std::string> found;
  for (const auto& file : contact::scenes::scenes_in(hypotheses::folder()))
    found.insert(file.stem().string());
  CHECK(named == found);
}

TEST_CASE("hypotheses: with one dropped the plan says that its scene is proven, otherwise not") {
  for (const Hypothesis& one : contact::proof_hypotheses()) {
    const std::string_view proof = hypotheses::proof_of(one.id);
    if (one.scene.empty() || proof == "first-hits") continue;
    CAPTURE(one.id, one.scene);
    const Scene scene = refuting(one.scene);
    const Effect effect = hypotheses::effect_of(proof);
    CHECK(decision(scene, effect).on);
    const Decision wrong = decision(scene, effect, without(one.id));
    CHECK_FALSE(wrong.on);
    CHECK(wrong.proven);
    bool dropped = false;
    for (const auto& condition : wrong.because)
      dropped = dropped || (condition.hypothesis == one.id && condition.right_is == "dropped");
    CHECK(dropped);
  }
}

TEST_CASE("hypotheses: the lesson's table has each row of the code's table, in its order") {
  std::ifstream lesson(CONTACT_SOURCE_DIR "/chapters/20_scenes/lesson.md");
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(lesson, line);) {
    if (line.find("| Proof | Hypothesis |") == 0) inside = true;
    if (inside && (line.empty() || line[0] != '|')) break;
    if (inside) rows.push_back(line);
  }
  std::vector<std::string> right{"| Proof | Hypothesis | Why | Scene |",
                                 "| --- | --- | --- | --- |"};
  std::string_view last;
  for (const Hypothesis& one : contact::proof_hypotheses()) {
    const std::string_view proof = hypotheses::proof_of(one.id);
    const std::string sign = one.relation == contact::Relation::equal
                                 ? ": "
                                 : (one.relation == contact::Relation::less ? " < " : " ≤ ");
    const std::string claim = proof == last ? "" : contact::proof_claim(proof);
    const std::string scene = one.scene.empty() ? "–" : "`" + std::string(one.scene) + "`";
    right.push_back("| " + claim + " | " + std::string(one.condition) + sign +
                    std::string(one.right_is) + " | " + std::string(one.why) + " | " + scene +
                    " |");
    last = proof;
  }
  REQUIRE(rows.size() == right.size());
  for (std::size_t k = 0; k < rows.size(); ++k) CHECK(rows[k] == right[k]);
}

TEST_CASE("hypotheses: an unknown one cannot be dropped") {
  const Scene scene = refuting("ball_on_floor");
  CHECK_THROWS_AS(contact::plan_scene(scene, without("weightless/no-moon")), std::invalid_argument);
}

namespace {

/// The largest displacement of a body of a scene from its start, run as planned, at sixteen times.
double displaced(const Scene& scene, std::size_t body, int axis) {
  const auto run = plan_scenes::run_of(scene);
  double most = 0;
  for (int k = 1; k <= 16; ++k) {
    run->advance(scene.duration * k / 16);
    most = std::max(most, std::abs(run->position(body)(axis) - scene.bodies[body].position(axis)));
  }
  return most;
}

}  // namespace

TEST_CASE("hypotheses of rest: gravity presses a ball on its floor all the time") {
  for (const char* name : {"ball_on_floor", "elastic_ball_on_floor"}) {
    const Scene scene = refuting(name);
    // Free it would fall 45 m.
    CHECK(displaced(scene, 1, 2) <= 1e-9);
  }
}

TEST_CASE("hypotheses of rest: a rotating rod pushes a ball to four times the speed of its hit") {
  const Scene scene = refuting("rod_pushes_ball");
  const auto run = plan_scenes::run_of(scene);
  run->advance(scene.duration);
  CHECK(run->velocity(1).norm() > 2);
}

TEST_CASE("hypotheses of rest: a soft ball is reversed by a wall that only a hard one touches") {
  const Scene scene = refuting("spring_presses");
  const auto run = plan_scenes::run_of(scene);
  double moved = 0;
  for (int k = 1; k <= 64; ++k) {
    run->advance(scene.duration * k / 64);
    moved = std::max(moved, std::abs(run->position(1).x() - 0.5));
  }
  // 2 kg m/s went through the hard ball into the wall, in half an oscillation of √(m/k).
  CHECK(moved <= 1e-9);
  CHECK(std::abs(run->velocity(2).x() - 1) <= 1e-3);
  const double half = 3.141592653589793 / std::sqrt(200.0);
  CHECK(std::abs(run->position(2).x() - (1.5 + scene.duration - 1 - half)) <= 1e-3);
}

TEST_CASE("hypotheses of rest: lossy bounces end before the scene does, by their closed form") {
  for (const char* name : {"lossy_bounces", "ball_on_box"}) {
    const auto bounces = contact::bouncing_ball<double>(2, 0, 8, 0.5);
    const double rest = contact::rest_time(bounces);
    CHECK(rest < refuting(name).duration / 2);
    CHECK(contact::bounce_at(bounces, refuting(name).duration).resting);
  }
}

TEST_CASE("hypotheses of rest: with friction an elastic ball comes to rest in a V") {
  for (const double friction : {0.5, 0.2}) {
    Scene scene = refuting("rough_v");
    scene.materials[0].friction = friction;
    CHECK(decision(scene, Effect::resting).on);
    CHECK(decision(scene, Effect::sleeping).on);
    auto run = hypotheses::ball_among_walls(scene, 2);
    // Its impacts accumulate: two hundred in turn within a microsecond of each other.
    int short_flights = 0;
    for (int hit = 0; hit < 100000 && short_flights < 200; ++hit) {
      const auto flight = run.hit(static_cast<Real>(scene.duration));
      REQUIRE(flight);
      short_flights = *flight < 1e-6 ? short_flights + 1 : 0;
    }
    CHECK(short_flights == 200);
    CHECK(run.now > 13);
    CHECK(run.now < 16);
    CHECK(std::abs(static_cast<double>(run.position.y) - 0.5 / 0.8) < 1e-6);
  }
}

TEST_CASE("hypotheses of rest: the damper of a soft ball ends the bounces of an elastic one") {
  std::vector<double> x{1, 2.5};
  std::vector<double> v{0, 0};
  double highest = 0;  // of the elastic one, after 5 s
  const double h = 1e-5;
  for (int n = 0; n < 1000000; ++n) {
    const double gap = x[1] - x[0] - 1;
    const double push = gap < 0 ? std::max(0.0, -1000 * gap - 20 * (v[1] - v[0])) : 0;
    v[0] += (-10 - push) * h;
    v[1] += (-10 + push) * h;
    x[0] += v[0] * h;
    x[1] += v[1] * h;
    if (x[0] < 0.5) {
      x[0] = 0.5;
      v[0] = std::abs(v[0]);
    }
    if (n * h > 5) highest = std::max(highest, x[0] - 0.5);
  }
  CHECK(highest < 1e-6);
  CHECK(std::abs(x[1] - (1.5 - 10.0 / 1000)) < 1e-5);  // the other lies on it
}

TEST_CASE(
    "hypotheses of rest: after a graze at v² = g R cos θ a ball is pressed onto a fixed one") {
  const Scene scene = refuting("graze_then_press");
  const auto& ball = scene.bodies[1];
  const auto apart = [&](const Rational& t) {  // squared distance less (2.5 + 2.5)²
    const auto at =
        oracle::ballistic(exact(ball.position), exact(ball.velocity), exact(scene.gravity), t);
    return Rational(at.dot(at) - 25);
  };
  CHECK(apart(Rational(1)) == 0);
  for (int k = 1; k <= 64; ++k) {
    CHECK(apart(1 - Rational(k, 128)) > 0);
    CHECK(apart(1 + Rational(k, 128)) < 0);  // there it would be inside, so it is pressed
  }
}

TEST_CASE("hypotheses of rest: a ceiling brings a ball to rest before its floor alone would") {
  const Scene scene = refuting("under_a_ceiling");
  auto run = hypotheses::balls_on_line(scene, 2);
  int hits = 0;
  while (hits < 200 && run.hit(static_cast<Real>(scene.duration))) ++hits;
  CHECK(hits == 200);
  CHECK(run.now < 2);
  CHECK(contact::rest_time(contact::bouncing_ball<double>(0, 20, 10, 0.5)) > scene.duration);
}

TEST_CASE("hypotheses of rest: a ball an ulp deep does not come out of its floor") {
  const Scene scene = refuting("an_ulp_deep");
  const Rational depth = exact(0.5) - exact(scene.bodies[1].position.z());
  const Rational up = exact(scene.bodies[1].velocity.z());
  CHECK(depth > 0);
  CHECK(up * up < 2 * 8 * depth);
}

TEST_CASE("hypotheses of one contact: two hits at one instant, and four vertices at once") {
  const Scene row = refuting("hit_from_both_sides");
  const auto touch = [&](std::size_t i) {  // the middle one is at rest
    const Rational gap = abs(exact(row.bodies[i].position.x())) - 1;
    return Rational(gap / abs(exact(row.bodies[i].velocity.x())));
  };
  CHECK(touch(0) == touch(2));
  const Scene lands = refuting("four_vertices");
  const auto run = plan_scenes::run_of(lands);
  run->advance(lands.duration);
  CHECK(run->counts().contacts >= 4);
}

TEST_CASE("hypotheses of mirrors: each scene leaves the plane that the proof would keep it in") {
  for (const Hypothesis& one : contact::proof_hypotheses()) {
    if (hypotheses::proof_of(one.id) != "mirror") continue;
    CAPTURE(one.id);
    const Scene scene = refuting(one.scene);
    // The axis along which nothing would move.
    const std::string why = decision(scene, Effect::third_dimension, without(one.id)).why;
    const std::string across = "mirror image across ";
    const int axis = why.at(why.find(across) + across.size()) - 'x';
    double moved = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      if (scene.bodies[i].moves) moved = std::max(moved, displaced(scene, i, axis));
    CHECK(moved > 0.01);
  }
}
