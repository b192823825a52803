// Hard balls from event to event: runs that are composed, stopped and resumed, against each other
// and against closed forms.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/events/hard_spheres.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "hard_setups.hpp"
#include "support/generators.hpp"

using contact::HardBall;
using contact::HardSphereEffects;
using contact::HardSphereEnd;
using contact::HardSphereHit;
using contact::HardSphereObserver;
using contact::HardSpheres;
using contact::HardSphereSetup;
using contact::Vector3;
using generators::Random;
using generators::tried;
using hard_setups::ball;
using hard_setups::everything;
using hard_setups::largest_overlap;
using hard_setups::Log;
using hard_setups::random_setup;
using hard_setups::u;

namespace {

constexpr auto no_limit = std::numeric_limits<std::uint64_t>::max();

HardBall fixed_ball(const Vector3<double>& x, double radius) {
  return {x, Vector3<double>::Zero(), radius, 0, 0, false};
}

void check_same_bits(const contact::HardSphereRun& a, const contact::HardSphereRun& b,
                     std::size_t balls) {
  REQUIRE(a.now() == b.now());
  for (std::size_t i = 0; i < balls; ++i) {
    for (int k = 0; k < 3; ++k) {
      REQUIRE(a.position(i)(k) == b.position(i)(k));
      REQUIRE(a.velocity(i)(k) == b.velocity(i)(k));
    }
  }
}

void check_same_hits(const Log& a, const Log& b) {
  REQUIRE(a.hits.size() == b.hits.size());
  for (std::size_t i = 0; i < a.hits.size(); ++i) {
    REQUIRE(a.hits[i].time == b.hits[i].time);
    REQUIRE(a.hits[i].ball == b.hits[i].ball);
    REQUIRE(a.hits[i].partner == b.hits[i].partner);
    REQUIRE(a.hits[i].impulse == b.hits[i].impulse);
  }
}

}  // namespace

TEST_CASE("a composition without an inactive effect gives the same bits as all effects") {
  Random random(11);
  for (int n = 0; n < tried(12); ++n) {
    const HardSphereSetup setup = random_setup(random, 24, true, n % 2 == 0 ? 10 : 0);
    HardSpheres<everything> full(setup);
    HardSpheres<HardSphereEffects{3, true, true, true, false}> all_pairs(setup);
    HardSpheres<HardSphereEffects{3, true, false, false, true}> least(setup);
    Log of_full;
    Log of_pairs;
    Log of_least;
    full.advance(3, no_limit, &of_full);
    all_pairs.advance(3, no_limit, &of_pairs);
    least.advance(3, no_limit, &of_least);
    REQUIRE(of_full.hits.size() > 100);
    check_same_hits(of_full, of_pairs);
    check_same_hits(of_full, of_least);
    check_same_bits(full, all_pairs, setup.balls.size());
    check_same_bits(full, least, setup.balls.size());
    if (n % 2 == 1) {
      HardSpheres<HardSphereEffects{3, false, false, false, true}> floating(setup);
      floating.advance(3);
      check_same_bits(full, floating, setup.balls.size());
    }
  }
}

TEST_CASE("a motion in a plane, or on a line, is the same without the other coordinates") {
  Random random(12);
  for (int n = 0; n < tried(12); ++n) {
    const int flat = n % 3;
    HardSphereSetup setup;
    for (int i = 0; i < 16; ++i) {
      Vector3<double> x{1.3 * (i % 4) + 1, 1.3 * (i / 4) + 1, 0};
      Vector3<double> v{random.uniform(-3, 3), random.uniform(-3, 3), 0};
      std::swap(x(2), x(flat));
      std::swap(v(2), v(flat));
      x(flat) = 0.7;
      setup.balls.push_back(ball(x, v));
    }
    for (int k = 0; k < 3; ++k) {
      setup.walls.push_back({Vector3<double>::Unit(k), 0, 0});
      setup.walls.push_back({-Vector3<double>::Unit(k), -6, 0});
    }
    const std::array<int, 3> axes{flat == 0 ? 1 : 0, flat == 2 ? 1 : 2, flat};
    setup.gravity(axes[0]) = -10;
    HardSpheres<HardSphereEffects{3, true, false, false, true}> space(setup);
    HardSpheres<HardSphereEffects{2, true, false, false, true}> plane(setup, axes);
    space.advance(4);
    plane.advance(4);
    REQUIRE(space.counts().hits > 100);
    check_same_bits(space, plane, setup.balls.size());
    REQUIRE(plane.bytes_per_state() < space.bytes_per_state());
  }
}

TEST_CASE("a run that is stopped, saved and resumed gives the bits of an uninterrupted one") {
  Random random(13);
  for (int n = 0; n < tried(12); ++n) {
    HardSphereSetup setup = random_setup(random, 16, n % 2 == 0, 10);
    setup.restitution = {n % 3 == 0 ? 1 : 0.9};
    HardSpheres<everything> whole(setup);
    HardSpheres<everything> first(setup);
    REQUIRE(whole.advance(1.5) == HardSphereEnd::reached);
    REQUIRE(first.advance(1.5, 37, nullptr) == HardSphereEnd::out_of_events);
    const auto kept = first.checkpoint();
    HardSpheres<everything> second(setup);
    second.restore(kept);
    REQUIRE(second.advance(1.5) == HardSphereEnd::reached);
    check_same_bits(whole, second, setup.balls.size());
    REQUIRE(whole.counts().hits == second.counts().hits);
    // Asked a little at a time, watched, and with a budget of one hit each.
    HardSpheres<everything> asked(setup);
    Log log;
    while (asked.advance(std::min(1.5, asked.now() + 0.01), 1, &log) != HardSphereEnd::reached ||
           asked.now() < 1.5) {
    }
    check_same_bits(whole, asked, setup.balls.size());
    REQUIRE(log.hits.size() == whole.counts().hits);
  }
}

TEST_CASE("a ball dropped from 10 m comes back to 10 m after a minute, to the last bits") {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -10};
  setup.cutoff = 0x1p-30;
  setup.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
  setup.balls = {ball({0, 0, 10.5}, {0, 0, 0})};
  HardSpheres<HardSphereEffects{1, true, false, false, false}> run(setup, {2, 0, 1});
  REQUIRE(run.advance(60) == HardSphereEnd::reached);
  CHECK(run.counts().hits == 21);
  const double z = run.position(0).z() - 0.5;
  const double v = run.velocity(0).z();
  // Height and v² / 2 g round a few times each.
  CHECK(std::abs(z + v * v / 20 - 10) <= 64 * u * 10);
  // After an hour a hit still sends it up as fast as the first one did.
  struct Rebounds final : HardSphereObserver {
    explicit Rebounds(const contact::HardSphereRun& watched) : run(watched) {}
    const contact::HardSphereRun& run;
    std::vector<double> speeds;
    bool on_hit(const HardSphereHit&) override {
      speeds.push_back(run.velocity(0).z());
      return true;
    }
  } rebounds(run);
  run.advance(3600, no_limit, &rebounds);
  REQUIRE(rebounds.speeds.size() > 1000);
  for (const double speed : rebounds.speeds) REQUIRE(speed == std::sqrt(200.0));
}

TEST_CASE("two balls: the closed form of an oblique hit") {
  // Unit balls, one at rest; the other moves along x with an offset of 1.2: sin = 0.6 at contact.
  HardSphereSetup setup;
  setup.balls = {ball({0, 0, 0}, {0, 0, 0}, 1), ball({-5, 1.2, 0}, {1, 0, 0}, 1)};
  HardSpheres<HardSphereEffects{2, false, false, false, false}> run(setup);
  Log log;
  run.advance(10, no_limit, &log);
  REQUIRE(log.hits.size() == 1);
  CHECK(std::abs(log.hits[0].time - 3.4) <= 64 * u);
  CHECK((run.velocity(0) - Vector3<double>(0.64, -0.48, 0)).norm() <= 64 * u);
  CHECK((run.velocity(1) - Vector3<double>(0.36, 0.48, 0)).norm() <= 64 * u);
}

TEST_CASE("a bouncing ball with e < 1 follows the closed form and then rests") {
  Random random(14);
  for (int n = 0; n < tried(50); ++n) {
    const double height = random.uniform(0.5, 5);
    const double e = random.uniform(0.1, 0.9);
    HardSphereSetup setup;
    setup.gravity = {0, 0, -9.81};
    setup.restitution = {e};
    setup.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
    setup.balls = {ball({0, 0, height + 0.5}, {1, 0, 0})};
    HardSpheres<HardSphereEffects{3, true, false, true, false}> run(setup);
    const contact::BouncingBall<double> law{height, 0, 9.81, e};
    for (int k = 1; k <= 60; ++k) {
      const double t = k * 0.15;
      REQUIRE(run.advance(t) == HardSphereEnd::reached);
      const auto right = contact::bounce_at(law, t);
      const double room = run.counts().rest_error + 1e-11;
      REQUIRE(std::abs(run.position(0).z() - 0.5 - right.height) <= room);
      REQUIRE(std::abs(run.position(0).x() - t) <= 1e-13);
      // The documented error of lying down.
      REQUIRE(run.counts().rest_error <= 9.81 * setup.cutoff * setup.cutoff / 8);
    }
    REQUIRE(run.advance(1000) == HardSphereEnd::reached);
    CHECK(run.rests_on(0) == 0);
    CHECK(run.velocity(0) == Vector3<double>(1, 0, 0));
    CHECK(run.position(0).z() == 0.5);
  }
}

TEST_CASE("a resting ball is hit, flies, and rests again") {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -10};
  setup.restitution = {0.5};
  setup.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
  setup.balls = {ball({0, 0, 0.5}, {0, 0, 0}), ball({-3, 0, 0.75}, {4, 0, 2})};
  HardSpheres<everything> run(setup);
  REQUIRE(run.advance(0.1) == HardSphereEnd::reached);
  CHECK(run.rests_on(0) == 0);
  CHECK(run.rests_on(1) == -1);
  Log log;
  REQUIRE(run.advance(20, no_limit, &log) == HardSphereEnd::reached);
  bool met = false;
  for (const auto& hit : log.hits) met = met || std::max(hit.ball, hit.partner) == 1;
  CHECK(met);
  CHECK(run.rests_on(0) == 0);
  CHECK(run.rests_on(1) == 0);
  CHECK(run.velocity(0).z() == 0);
  CHECK(largest_overlap(run, setup) <= 1e-12);
}

TEST_CASE("on a slope a ball slides down with g sin, without friction") {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -10};
  setup.restitution = {0.0};
  const Vector3<double> normal(0.6, 0, 0.8);
  setup.walls = {{normal, 0, 0}};
  setup.balls = {ball(normal * 0.5, {0, 0, 0})};
  HardSpheres<everything> run(setup);
  REQUIRE(run.advance(2) == HardSphereEnd::reached);
  // Down the slope: (0.8, 0, −0.6) 10 · 0.6 t²/2.
  const Vector3<double> right = normal * 0.5 + Vector3<double>(0.8, 0, -0.6) * 12;
  CHECK((run.position(0) - right).norm() <= 1e-13);
}

TEST_CASE("fixed balls push back, with gravity and without") {
  Random random(15);
  for (int n = 0; n < tried(20); ++n) {
    HardSphereSetup setup = random_setup(random, 8, n % 2 == 0, n % 3 == 0 ? 0 : 10);
    const Vector3<double> peg{3, 3, 3};
    std::erase_if(setup.balls,
                  [&](const HardBall& b) { return (b.position - peg).norm() < b.radius + 1.001; });
    if (setup.balls.empty()) continue;
    setup.balls.push_back(fixed_ball(peg, 1));
    HardSpheres<HardSphereEffects{3, true, true, false, true}> run(setup);
    HardSpheres<HardSphereEffects{3, true, true, false, false}> pairs(setup);
    const double before = run.energy();
    Log log;
    REQUIRE(run.advance(4, no_limit, &log) == HardSphereEnd::reached);
    pairs.advance(4);
    check_same_bits(run, pairs, setup.balls.size());
    CHECK(run.position(setup.balls.size() - 1) == peg);
    CHECK(std::abs(run.energy() - before) <= 1e-12 * before);
    CHECK(largest_overlap(run, setup) <= 1e-12);
  }
}

TEST_CASE("a run without a bound on its hits is rejected, and never hangs") {
  // Three balls on a line with e below 7 − 4√3: hits pile up before a finite time.
  HardSphereSetup line;
  line.restitution = {0.01};
  line.balls = {ball({0, 0, 0}, {1, 0, 0}), ball({1.5, 0, 0}, {0, 0, 0}),
                ball({3, 0, 0}, {-1, 0, 0})};
  HardSpheres<HardSphereEffects{1, false, false, true, false}> collapse(line);
  CHECK(collapse.advance(10) == HardSphereEnd::endless_hits);
  CHECK(collapse.counts().endless_ball == 1);
  // A ball that would lie on another.
  HardSphereSetup stack;
  stack.gravity = {0, 0, -10};
  stack.restitution = {0.5};
  stack.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
  stack.balls = {ball({0, 0, 0.5}, {0, 0, 0}), ball({0, 0, 2}, {0, 0, 0})};
  HardSpheres<everything> pile(stack);
  CHECK(pile.advance(10) == HardSphereEnd::endless_hits);
  CHECK(pile.now() < 3);
  // In a groove one ball touches two walls.
  HardSphereSetup groove;
  groove.gravity = {0, 0, -10};
  groove.restitution = {0.5};
  groove.walls = {{Vector3<double>(0.6, 0, 0.8), 0, 0}, {Vector3<double>(-0.6, 0, 0.8), 0, 0}};
  groove.balls = {ball({0.1, 0, 2}, {0, 0, 0})};
  HardSpheres<everything> wedge(groove);
  CHECK(wedge.advance(10) == HardSphereEnd::endless_hits);
}

TEST_CASE("state that no effect needs is not stored") {
  using D3 = HardSpheres<HardSphereEffects{3, false, false, false, true}>;
  using G3 = HardSpheres<HardSphereEffects{3, true, false, false, true}>;
  using F3 = HardSpheres<everything>;
  using D1 = HardSpheres<HardSphereEffects{1, false, false, false, false}>;
  HardSphereSetup setup;
  setup.balls = {ball({0, 0, 0}, {0, 0, 0})};
  // Position, velocity, time and the last partner; resting uses what alignment left over.
  CHECK(D1(setup).bytes_per_state() == 2 * 8 + 8 + 8);
  CHECK(D3(setup).bytes_per_state() == 6 * 8 + 8 + 8);
  CHECK(G3(setup).bytes_per_state() == 6 * 8 + 8 + 8);
  CHECK(F3(setup).bytes_per_state() == 6 * 8 + 8 + 16 + 16);
  const HardSphereSetup gas = contact::dilute_gas(1000, 1);
  const HardSphereSetup more = contact::dilute_gas(8000, 1);
  const double growth =
      static_cast<double>(D3(more).bytes()) / static_cast<double>(D3(gas).bytes());
  CHECK(growth <= std::pow(8, 1.1));
}

TEST_CASE("an invalid setup is rejected with its fault") {
  const auto refusal = [](auto change) -> std::string {
    HardSphereSetup setup;
    setup.balls = {ball({0, 0, 0}, {0, 0, 0}), ball({2, 0, 0}, {0, 0, 0})};
    setup.walls = {{Vector3<double>(0, 0, 1), -9, 0}};
    change(setup);
    try {
      contact::require_hard_sphere_setup(setup);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto has = [](const std::string& text, const std::string& substep) {
    return text.find(substep) != std::string::npos;
  };
  CHECK(refusal([](HardSphereSetup&) {}).empty());
  CHECK(has(refusal([](auto& s) { s.balls[1].mass = -1; }), "balls[1].mass = -1"));
  CHECK(has(refusal([](auto& s) { s.balls[0].radius = 0; }), "balls[0].radius = 0"));
  CHECK(has(refusal([](auto& s) { s.balls[0].position.x() = std::nan(""); }), "balls[0].position"));
  CHECK(has(refusal([](auto& s) { s.restitution = {1.5}; }), "restitution = 1.5"));
  CHECK(has(refusal([](auto& s) { s.restitution = {1, 1}; }), "2 entries"));
  CHECK(has(refusal([](auto& s) { s.restitution = {1, 0.5, 0.25, 1}; }), "either order"));
  CHECK(has(refusal([](auto& s) { s.walls[0].normal *= 2; }), "walls[0].normal"));
  CHECK(has(refusal([](auto& s) { s.walls[0].material = 3; }), "walls[0].material = 3"));
  CHECK(has(refusal([](auto& s) { s.cutoff = -1; }), "cutoff = -1"));
  CHECK(has(refusal([](auto& s) { s.balls[0].moves = false; }), "at least one must move"));
  HardSphereSetup heavy;
  heavy.gravity = {0, 0, -1};
  heavy.balls = {ball({0, 0, 0}, {0, 0, 0})};
  CHECK_THROWS_AS((HardSpheres<HardSphereEffects{3, false, true, true, true}>(heavy)),
                  std::invalid_argument);
}
