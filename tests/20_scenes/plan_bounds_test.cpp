// The planner's energy bounds, compared with motions: exact ones in fractions, and seeded scenes of
// balls that are run from impact to impact. A bound is rounded outwards, so it is tested without an
// allowance where the motion is exact, and with that of the run where it is computed.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/scene/scene_runs.hpp>
#include <limits>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Scene;
using contact::SceneBounds;
using generators::Random;
using oracle::exact;
using oracle::Rational;
using plan_scenes::Point;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Smooth hard balls from impact to impact: every pair is tested for its next impact each time.
class PlainRun {
 public:
  explicit PlainRun(const Scene& scene) : scene_(scene) {
    for (const auto& body : scene.bodies) {
      x.push_back(body.position);
      v.push_back(body.velocity);
      top.push_back(std::sqrt(v.back().dot(v.back())));
      far.push_back(0);
    }
    met.assign(x.size() * x.size(), false);
  }

  /// Runs to the end of the scene, or to so many impacts. Samples every body on the way.
  void run(int max_hits) {
    double now = 0;
    for (int hits = 0; hits < max_hits; ++hits) {
      double soonest = scene_.duration - now;
      std::size_t first = x.size();
      std::size_t second = x.size();
      for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t k = 0; k < x.size(); ++k) {
          const double t = next(i, k);
          if (t < soonest) {
            soonest = t;
            first = i;
            second = k;
          }
        }
      }
      for (int piece = 1; piece <= 8; ++piece) look(soonest * piece / 8);
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (!scene_.bodies[i].moves) continue;
        x[i] += v[i] * soonest + scene_.gravity * (soonest * soonest / 2);
        v[i] += scene_.gravity * soonest;
      }
      now += soonest;
      if (first == x.size()) return;
      hit(first, second);
      look(0);
    }
  }

  std::vector<Point> x;
  std::vector<Point> v;
  std::vector<double> top;  ///< the fastest that each was
  std::vector<double> far;  ///< the farthest that each came
  std::vector<bool> met;    ///< by i n + k

 private:
  [[nodiscard]] double radius(std::size_t i) const {
    return contact::inner_radius(scene_.bodies[i].shape);
  }

  void look(double t) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!scene_.bodies[i].moves) continue;
      const Point at = x[i] + v[i] * t + scene_.gravity * (t * t / 2) - scene_.bodies[i].position;
      const Point speed = v[i] + scene_.gravity * t;
      top[i] = std::max(top[i], std::sqrt(speed.dot(speed)));
      far[i] = std::max(far[i], std::sqrt(at.dot(at)));
    }
  }

  [[nodiscard]] double next(std::size_t i, std::size_t k) const {
    if (!scene_.bodies[i].moves || i == k) return never;
    const auto& other = scene_.bodies[k];
    if (const auto* wall = std::get_if<contact::HalfSpaceShape>(&other.shape)) {
      const double s = std::max(0.0, wall->normal.dot(x[i]) - wall->offset - radius(i));
      const double speed = wall->normal.dot(v[i]);
      const double a = wall->normal.dot(scene_.gravity);
      if (s == 0 && speed >= 0 && (speed > 0 ? a >= 0 : true)) return never;
      if (a < 0) {
        const double w = std::sqrt(speed * speed - 2 * a * s);
        return speed > 0 ? (speed + w) / -a : 2 * s / (w - speed);
      }
      const double under = speed * speed - 2 * a * s;
      if (speed >= 0 || under < 0) return never;
      return 2 * s / (std::sqrt(under) - speed);
    }
    if (k < i && other.moves) return never;
    if (!other.moves) return never;
    const Point d = x[i] - x[k];
    const Point w = v[i] - v[k];
    const double reach = radius(i) + radius(k);
    const double b = d.dot(w);
    const double c = std::max(0.0, d.dot(d) - reach * reach);
    const double under = b * b - w.dot(w) * c;
    if (b >= 0 || under <= 0) return never;
    return c / (std::sqrt(under) - b);
  }

  void hit(std::size_t i, std::size_t k) {
    met[i * x.size() + k] = met[k * x.size() + i] = true;
    const auto& a = scene_.bodies[i];
    const auto& b = scene_.bodies[k];
    const double e =
        contact::pair_material(scene_.materials[a.material], scene_.materials[b.material])
            .restitution;
    if (!b.moves) {
      const Point n = std::get<contact::HalfSpaceShape>(b.shape).normal;
      v[i] -= n * ((1 + e) * n.dot(v[i]));
      return;
    }
    const Point d = x[i] - x[k];
    const Point n = d / std::sqrt(d.dot(d));
    const double impulse = (1 + e) * n.dot(v[i] - v[k]) / (1 / a.mass + 1 / b.mass);
    v[i] -= n * (impulse / a.mass);
    v[k] += n * (impulse / b.mass);
  }

  const Scene& scene_;
};

/// A few balls, some of them flying towards each other, over a floor, in a box or in free space.
Scene random_scene(Random& random) {
  const int kind = random.integer(0, 3);
  const double e = random.chance(0.5) ? 1.0 : random.uniform(0.5, 1);
  const double duration = random.uniform(0.2, 2);
  Scene scene = plan_scenes::empty(e, 0, duration, 1e-6);
  if (kind != 3) {
    const double g = random.uniform(0, 12);
    scene.gravity = {0, 0, -g};
  }
  if (kind == 0) plan_scenes::wall(scene, Point::UnitZ(), 0);
  if (kind == 1) plan_scenes::walls(scene, {8, 8, 8});
  const int balls = random.integer(1, 6);
  while (static_cast<int>(scene.bodies.size()) < balls + 7) {
    const double radius = random.uniform(0.1, 0.5);
    const double px = random.uniform(0.6, 7.4);
    const double py = random.uniform(0.6, 7.4);
    const double pz = random.uniform(0.6, 7.4);
    const double vx = random.uniform(-4, 4);
    const double vy = random.uniform(-4, 4);
    const double vz = random.uniform(-4, 4);
    const double mass = random.uniform(0.1, 3);
    bool free = true;
    for (const auto& body : scene.bodies) {
      if (!body.moves) continue;
      const Point d = body.position - Point(px, py, pz);
      free = free && std::sqrt(d.dot(d)) > contact::inner_radius(body.shape) + radius + 0.01;
    }
    if (free)
      plan_scenes::ball(scene, radius, mass, {px, py, pz}, {vx, vy, vz});
    else
      plan_scenes::ball(scene, radius, mass, {px + 40 + 10 * double(scene.bodies.size()), 4, 4});
    if (kind == 1 && !free) scene.bodies.pop_back();
    if (static_cast<int>(scene.bodies.size()) >= balls + 6) break;
  }
  return scene;
}

}  // namespace

TEST_CASE("no motion is faster or goes farther than the bounds, and no other pairs meet") {
  Random random(20);
  int hits = 0;
  int pairs_left_out = 0;
  for (int trial = 0; trial < generators::tried(2000); ++trial) {
    const Scene scene = random_scene(random);
    const SceneBounds bounds = contact::scene_bounds(scene);
    PlainRun run(scene);
    run.run(300);
    const std::size_t n = scene.bodies.size();
    std::vector<bool> may(n * n, false);
    for (const auto& pair : bounds.pairs)
      may[pair.a * n + pair.b] = may[pair.b * n + pair.a] = true;
    for (std::size_t i = 0; i < n; ++i) {
      if (!scene.bodies[i].moves) continue;
      // The run rounds some thousands of times; its energy is off by far less than 1e-11 of itself.
      INFO("trial " << trial << ", body " << i);
      REQUIRE(run.top[i] <= bounds.bodies[i].speed * (1 + 1e-11));
      REQUIRE(run.far[i] <= bounds.bodies[i].travel * (1 + 1e-11));
      for (std::size_t k = 0; k < n; ++k) {
        if (run.met[i * n + k]) ++hits;
        REQUIRE((!run.met[i * n + k] || may[i * n + k]));
        if (k != i && !may[i * n + k]) ++pairs_left_out;
      }
    }
  }
  // The test is only meaningful if balls do meet, and if some pairs are left out.
  CHECK(hits > generators::tried(2000));
  CHECK(pairs_left_out > generators::tried(500));
}

TEST_CASE("the bound of a ball alone is its closed form, rounded up by little") {
  Random random(21);
  for (int trial = 0; trial < generators::tried(2000); ++trial) {
    const double v = random.uniform(0, 50);
    const double g = random.uniform(0, 20);
    const double t = random.uniform(0.01, 10);
    const double mass = std::ldexp(random.uniform(1, 2), random.integer(-20, 20));
    Scene scene = plan_scenes::empty(1, 0, t, 1e-6);
    scene.gravity = {0, 0, -g};
    plan_scenes::ball(scene, 0.5, mass, Point::Zero(), {0, 0, -v});
    const SceneBounds bounds = contact::scene_bounds(scene);
    const Rational speed = exact(v) + exact(g) * exact(t);
    const Rational travel = exact(v) * exact(t) + exact(g) * exact(t) * exact(t) / 2;
    REQUIRE(exact(bounds.bodies[0].speed) >= speed);
    REQUIRE(exact(bounds.bodies[0].speed) <= speed * (1 + Rational(1) / 1000000000));
    REQUIRE(exact(bounds.bodies[0].travel) >= travel);
    REQUIRE(exact(bounds.bodies[0].travel) <= travel * (1 + Rational(1) / 1000000000));
  }
}

TEST_CASE("over a floor a ball is never faster than after falling to the floor") {
  Random random(22);
  for (int trial = 0; trial < generators::tried(2000); ++trial) {
    const double height = random.uniform(0, 30);
    const double v = random.uniform(-20, 20);
    const double g = random.uniform(0.1, 20);
    Scene scene = plan_scenes::empty(1, 0, 1000, 1e-6);
    scene.gravity = {0, 0, -g};
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::ball(scene, 0.5, 2, {0, 0, height + 0.5}, {0, 0, v});
    const double bound = contact::scene_bounds(scene).bodies[1].speed;
    const Rational rise = exact(height + 0.5) - exact(0.5);
    const Rational squared = exact(v) * exact(v) + 2 * exact(g) * rise;
    REQUIRE(exact(bound) * exact(bound) >= squared);
    // And its gain in a dip of the tolerance, no less and no more.
    REQUIRE(bound * bound >= (oracle::nearest(squared) + 2 * g * 1e-6) * (1 - 1e-12));
    REQUIRE(bound * bound <= (oracle::nearest(squared) + 2 * g * 1e-6) * (1 + 1e-9));
  }
}

TEST_CASE("a compliant floor lets a ball fall farther by its compression") {
  // At the lowest point of a drop from height h on a spring the speed is 0; before, it is largest
  // where the spring carries the weight, m g/k deep: v² = 2 g h + m g²/k.
  Scene scene = plan_scenes::empty(0, 0, 100, 1e-6);
  scene.materials[0].stiffness = 64;
  scene.gravity = {0, 0, -8};
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 2, {0, 0, 4.5});
  // Two equal springs in a row: k = 32.
  const double squared = 2 * 8.0 * 4 + 2 * 8.0 * 8 / 32;
  const double bound = contact::scene_bounds(scene).bodies[1].speed;
  CHECK(bound * bound >= squared);
  CHECK(bound * bound <= (squared + 2 * 8.0 * 1e-6) * (1 + 1e-9));
}

TEST_CASE(
    "a ball whose hit is late by a step is in the floor, and still no faster than the bound") {
  // A drop of 2 m with a step as long as the tolerance allows. The run is sampled within its steps.
  Scene scene = plan_scenes::empty(1, 0, 1.5, 0.25);
  scene.gravity = {0, 0, -8};
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 2.5});
  contact::PlanOptions options;
  double dip = 0;
  for (const double h : {0.0078, 0.0079, 0.0080, 0.0081}) {
    options.step = h;
    const contact::Plan plan = contact::plan_scene(scene, options);
    REQUIRE_FALSE(contact::decision_on(plan, contact::Effect::continuous_detection).on);
    const auto run = contact::scenes::make_run(scene, plan);
    const SceneBounds bounds = contact::scene_bounds(scene);
    for (int k = 1; k <= 1000; ++k) {
      run->advance(1.5 * k / 1000);
      dip = std::max(dip, 0.5 - run->position(1).z());
      REQUIRE(run->velocity(1).norm() <= bounds.bodies[1].speed);
    }
  }
  CHECK(dip > 0.01);
  CHECK(dip <= 0.25);
}

TEST_CASE(
    "a ball reaches a body at exactly the distance that it travels, and not one a little farther") {
  // 3 m in 1 s at 3 m/s: both balls' radii are 1, so the distance of 3 is just closed.
  const auto meets = [](double gap) {
    Scene scene = plan_scenes::empty(1, 0, 1, 1e-6);
    plan_scenes::ball(scene, 1, 1, Point::Zero(), {3, 0, 0});
    plan_scenes::ball(scene, 1, 1, {2 + gap, 0, 0});
    return !contact::scene_bounds(scene).pairs.empty();
  };
  CHECK(meets(3));
  CHECK(meets(std::nextafter(3.0, 0)));
  CHECK_FALSE(meets(3 * (1 + 1e-9)));
}

TEST_CASE("a disturbed ball disturbs others, one after the other") {
  // A row: only the first moves, each can only push the next. With all the energy the last of the
  // row moves 8 m, so it just closes a distance of 8 m and not one of a little more.
  const auto reached = [](double gap) {
    Scene scene = plan_scenes::empty(1, 0, 4, 1e-6);
    plan_scenes::ball(scene, 0.5, 1, Point::Zero(), {2, 0, 0});
    for (int k = 1; k < 5; ++k) plan_scenes::ball(scene, 0.5, 1, {2.0 * k, 0, 0});
    plan_scenes::ball(scene, 0.5, 1, {9 + gap, 0, 0});
    const SceneBounds bounds = contact::scene_bounds(scene);
    for (std::size_t i = 0; i < 5; ++i) CHECK(bounds.bodies[i].disturbed);
    CHECK(bounds.bodies[4].travel >= 8);
    return bounds.bodies[5].disturbed;
  };
  CHECK(reached(8));
  CHECK_FALSE(reached(8 * (1 + 1e-9)));
}

TEST_CASE("a crowd is bounded as a whole, and finds balls that touch") {
  const auto crowd = [](double spacing) {
    Scene scene = plan_scenes::empty(1, 0, 1, 1e-6);
    for (int i = 0; i < 1331; ++i)
      plan_scenes::ball(scene, 0.5, 1,
                        {spacing * (i % 11), spacing * (i / 11 % 11), spacing * (i / 121)});
    scene.bodies[7].velocity = {3, 0, 0};
    return contact::scene_bounds(scene);
  };
  const SceneBounds apart = crowd(1.25);
  REQUIRE(apart.crowded);
  REQUIRE(apart.pairs.size() == 1);
  CHECK(apart.pairs[0].count == 1331.0 * 1330 / 2);
  CHECK(apart.pairs[0].apart);
  CHECK(apart.speed >= 3);
  CHECK(apart.speed <= 3 * (1 + 1e-9));
  CHECK_FALSE(crowd(1).pairs[0].apart);
}
