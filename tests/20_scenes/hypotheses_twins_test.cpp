// The hypotheses of the horizon: scenes whose twins, which start an ulp away, diverge beyond the
// tolerance within the scene, although without one of the hypotheses the plan says that nothing
// spreads, or that the horizon is later.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/scene/scene_runs.hpp>
#include <string>
#include <vector>

#include "hypotheses_oracle.hpp"
#include "hypotheses_scenes.hpp"
#include "plan_scenes.hpp"

using contact::Decision;
using contact::Effect;
using contact::Hypothesis;
using contact::Scene;
using hypotheses::ball_among_posts;
using hypotheses::ball_among_walls;
using hypotheses::balls_on_line;
using hypotheses::Real;
using hypotheses::refuting;
using hypotheses::twins_apart;
using hypotheses::without;
using plan_scenes::decision;
using plan_scenes::Point;

namespace {

/// Moves the velocity of a ball by so many ulps along x.
constexpr auto along_x = [](auto& run, Real ulps) { run.velocity.x += ulps; };
/// The same along the other axis of the plane.
constexpr auto along_y = [](auto& run, Real ulps) { run.velocity.y += ulps; };

double tolerance_of(const Scene& scene) { return *scene.tolerance.position; }

}  // namespace

TEST_CASE("hypotheses of flat walls: twins of a ball among slopes, rough walls, in a corner") {
  for (const char* name : {"two_slopes", "rough_corner", "into_a_corner"}) {
    CAPTURE(name);
    const Scene scene = refuting(name);
    const auto run = ball_among_walls(scene, scene.bodies[1].name == "wall_y" ? 1 : 2);
    CHECK(twins_apart(run, scene.duration, along_x) > 100 * tolerance_of(scene));
  }
}

TEST_CASE("hypotheses of flat walls: equal order of hits in a square corner, and at π/3") {
  // The same start as into_a_corner, between walls whose angle divides π.
  for (const double degrees : {90.0, 60.0}) {
    CAPTURE(degrees);
    Scene scene = refuting("into_a_corner");
    const double half = degrees / 360 * 3.14159265358979323846;
    for (const int side : {0, 1}) {
      const Point normal(side == 0 ? std::cos(half) : -std::cos(half), 0, std::sin(half));
      scene.bodies[static_cast<std::size_t>(side)].shape = contact::HalfSpaceShape{normal, 0};
    }
    CHECK(twins_apart(ball_among_walls(scene, 2), scene.duration, along_x) < 1e-13);
  }
}

TEST_CASE("hypotheses of flat walls and lines: twins of a ball that grazes a ceiling") {
  const Scene scene = refuting("grazes_a_ceiling");
  CHECK(twins_apart(ball_among_walls(scene, 2), scene.duration, along_y) >
        100 * tolerance_of(scene));
  // Away from the graze they stay together: the plan says so, and it is proven.
  Scene lower = scene;
  lower.bodies[2].velocity.z() = 3.9;
  CHECK_FALSE(decision(lower, Effect::horizon).on);
  CHECK(twins_apart(ball_among_walls(lower, 2), lower.duration, along_y) < tolerance_of(lower));
}

TEST_CASE("hypotheses of flat walls: twins of a ball among round posts") {
  const Scene scene = refuting("ball_among_posts");
  CHECK(twins_apart(ball_among_posts(scene), scene.duration, along_y) > 100 * tolerance_of(scene));
}

TEST_CASE("hypotheses of flat walls: twins of a die") {
  const Scene scene = refuting("elastic_die");
  Scene other = scene;
  other.bodies[1].angular_velocity.x() *= 1 + 0x1p-52;
  const auto run = plan_scenes::run_of(scene);
  const auto twin = plan_scenes::run_of(other);
  run->advance(scene.duration);
  twin->advance(scene.duration);
  CHECK((run->position(1) - twin->position(1)).norm() > 100 * tolerance_of(scene));
}

TEST_CASE("hypotheses of flat walls: twins of a soft ball between three walls") {
  const Scene scene = refuting("soft_triangle");
  const auto end = [&](double ulps) {
    std::vector<double> x{scene.bodies[3].position.x() + ulps * 0x1p-53,
                          scene.bodies[3].position.y()};
    std::vector<double> v{scene.bodies[3].velocity.x(), scene.bodies[3].velocity.y()};
    hypotheses::leapfrog(
        x, v, {1, 1}, 1e-3, 60000,
        [&](const std::vector<double>& at, const std::vector<double>&, std::vector<double>& f) {
          f = {0, 0};
          for (int k = 0; k < 3; ++k) {
            const auto& wall =
                std::get<contact::HalfSpaceShape>(scene.bodies[static_cast<std::size_t>(k)].shape);
            const double gap =
                wall.normal.x() * at[0] + wall.normal.y() * at[1] - wall.offset - 0.5;
            for (int i = 0; i < 2 && gap < 0; ++i)
              f[static_cast<std::size_t>(i)] -= 20 * gap * wall.normal(i);
          }
        });
    return Point(x[0], x[1], 0);
  };
  CHECK((end(1) - end(-1)).norm() > 10 * tolerance_of(scene));
}

TEST_CASE("hypotheses of a line: twins of five soft balls between two soft walls") {
  const Scene scene = refuting("five_soft_balls");
  std::vector<double> mass;
  for (std::size_t k = 2; k < 7; ++k) mass.push_back(scene.bodies[k].mass);
  const auto end = [&](double ulps) {
    std::vector<double> x;
    std::vector<double> v;
    for (std::size_t k = 2; k < 7; ++k) {
      x.push_back(scene.bodies[k].position.x() + (k == 2 ? ulps * 0x1p-52 : 0));
      v.push_back(scene.bodies[k].velocity.x());
    }
    hypotheses::leapfrog(
        x, v, mass, 1e-3, 40000,
        [](const std::vector<double>& at, const std::vector<double>&, std::vector<double>& f) {
          f.assign(5, 0);
          const auto push = [&](int left, int right, double gap) {
            if (gap > 0) return;
            if (left >= 0) f[static_cast<std::size_t>(left)] += 100 * gap;
            if (right < 5) f[static_cast<std::size_t>(right)] -= 100 * gap;
          };
          push(-1, 0, at[0] - 0.3);
          for (int k = 0; k < 4; ++k)
            push(k, k + 1,
                 at[static_cast<std::size_t>(k) + 1] - at[static_cast<std::size_t>(k)] - 0.6);
          push(4, 5, 5.7 - at[4]);
        });
    return x;
  };
  const std::vector<double> one = end(1);
  const std::vector<double> other = end(-1);
  double apart = 0;
  for (std::size_t k = 0; k < 5; ++k) apart = std::max(apart, std::abs(one[k] - other[k]));
  CHECK(apart > 100 * tolerance_of(scene));
}

TEST_CASE("hypotheses of a line: twins of two that fall, and of three masses at one instant") {
  const auto first_faster = [](auto& run, Real ulps) { run.velocity[0] += 8 * ulps; };
  const Scene falling = refuting("two_fall_on_a_line");
  CHECK(twins_apart(balls_on_line(falling, 2), falling.duration, first_faster) >
        100 * tolerance_of(falling));
  const Scene three = refuting("three_masses_at_once");
  CHECK(std::abs(twins_apart(balls_on_line(three, 0), 4, first_faster) - 1.12) < 0.01);
  // Before the horizon that the plan gives they are together; it is before their hits, at 1 s.
  const Decision horizon = decision(three, Effect::horizon);
  REQUIRE(horizon.value);
  CHECK(*horizon.value > 0.1);
  CHECK(*horizon.value <= 1);
  CHECK(twins_apart(balls_on_line(three, 0), *horizon.value, first_faster) < 1e-13);
}

TEST_CASE("hypotheses of a line: three equal masses at one instant exchange their velocities") {
  Scene scene = refuting("three_masses_at_once");
  for (auto& body : scene.bodies) {
    body.mass = 1;
    body.inertia = contact::solid_inertia(body.shape, 1);
  }
  CHECK_FALSE(decision(scene, Effect::horizon).on);
  const auto first_faster = [](auto& run, Real ulps) { run.velocity[0] += 8 * ulps; };
  CHECK(twins_apart(balls_on_line(scene, 0), 4, first_faster) < 1e-13);
  // With e = 1/2 they do not.
  scene.materials[0].restitution = 0.5;
  CHECK(decision(scene, Effect::horizon).on);
  CHECK(twins_apart(balls_on_line(scene, 0), 4, first_faster) > 0.1);
}

TEST_CASE("hypotheses of first hits: the horizon includes how oblique they are, and their order") {
  for (const Hypothesis& one : contact::proof_hypotheses()) {
    if (hypotheses::proof_of(one.id) != "first-hits" || one.scene.empty()) continue;
    CAPTURE(one.id);
    const Scene scene = refuting(one.scene);
    const auto run = ball_among_posts(scene);
    const Decision right = decision(scene, Effect::horizon);
    const Decision wrong = decision(scene, Effect::horizon, without(one.id));
    REQUIRE(right.value);
    REQUIRE(wrong.value);
    const auto apart = [&](double time) { return twins_apart(run, time, along_y); };
    // Twins are within the tolerance until the horizon, and not until that of the weaker rule.
    CHECK(apart(*right.value) <= tolerance_of(scene));
    CHECK(apart(std::min(*wrong.value, scene.duration)) > tolerance_of(scene));
    CHECK(*right.value > 1.9);
  }
}
