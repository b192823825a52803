// advance.hpp: from impact to impact between walls, in fractions.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/advance.hpp>
#include <contact/bouncing.hpp>
#include <contact/integrators.hpp>
#include <numbers>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::MotionState;
using contact::Plane;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using reference::fraction;
using reference::point;
using reference::positive;

namespace {

/// A box from (0, 0, 0) to `size`.
template <class S>
std::vector<Plane<S>> box(const Vector3<S>& size) {
  std::vector<Plane<S>> walls;
  for (int axis = 0; axis < 3; ++axis) {
    Vector3<S> normal = Vector3<S>::Zero();
    normal(axis) = S(1);
    walls.push_back({normal, S(0)});
    walls.push_back({Vector3<S>(-normal), S(-size(axis))});
  }
  return walls;
}

/// The position of a point that bounces between 0 and `length` with k = 1: a folded straight line.
Rational folded(const Rational& x, const Rational& length) {
  Rational rest = x / (2 * length);
  const oracle::Integer whole = numerator(rest) / denominator(rest);
  rest -= Rational(whole);
  if (rest < 0) rest += 1;
  return rest * 2 <= 1 ? Rational(rest * 2 * length) : Rational((2 - 2 * rest) * length);
}

}  // namespace

TEST_CASE("advancing in a box is a folded straight line, exactly, in fractions") {
  Random random(1909);
  int impacts = 0;
  for (int i = 0; i < 400; ++i) {
    oracle::Vector size;
    oracle::Vector start;
    const Rational radius = positive(random, 1) / 3;
    for (int axis = 0; axis < 3; ++axis) {
      size(axis) = 2 * radius + positive(random, 3);
      start(axis) = radius + (size(axis) - 2 * radius) * random.integer(0, 6) / 6;
    }
    const oracle::Vector velocity = point(random, 6);
    const Rational step = positive(random, 3);
    const auto rules = contact::impact_rules<Rational>(1, 0, 1000);
    const auto got = contact::advance_straight<Rational>({start, velocity}, radius, step,
                                                         box<Rational>(size), rules);
    REQUIRE(got.end == contact::AdvanceEnd::used_up);
    REQUIRE(got.time_left == 0);
    for (int axis = 0; axis < 3; ++axis) {
      const Rational wanted =
          radius + folded(start(axis) - radius + velocity(axis) * step, size(axis) - 2 * radius);
      REQUIRE(got.state.position(axis) == wanted);
      REQUIRE(abs(got.state.velocity(axis)) == abs(velocity(axis)));
    }
    impacts += got.impacts;
  }
  CHECK(impacts > 2000);
}

TEST_CASE("two half steps are one step") {
  Random random(1910);
  for (int i = 0; i < 300; ++i) {
    const oracle::Vector size(Rational(3), Rational(2), Rational(4));
    const oracle::Vector start(positive(random, 2), Rational(1), positive(random, 3));
    const oracle::Vector velocity = point(random, 9);
    const auto rules = contact::impact_rules<Rational>(Rational(random.integer(1, 4)) / 4, 0, 1000);
    const auto walls = box<Rational>(size);
    const Rational step = positive(random, 1);
    const auto whole =
        contact::advance_straight<Rational>({start, velocity}, 0, step, walls, rules);
    const auto half =
        contact::advance_straight<Rational>({start, velocity}, 0, step / 3, walls, rules);
    const auto rest =
        contact::advance_straight<Rational>(half.state, 0, step * 2 / 3, walls, rules);
    REQUIRE(rest.state.position == whole.state.position);
    REQUIRE(rest.state.velocity == whole.state.velocity);
    REQUIRE(half.impacts + rest.impacts == whole.impacts);
  }
}

TEST_CASE("in a wedge of angle θ there are at most ⌈π/θ⌉ impacts without loss") {
  // The tangent of the wedge's angle is 3/4: 36.87°, and 180/36.87 = 4.9. Its walls have rational
  // unit normals.
  const std::vector<Plane<Rational>> walls{
      {oracle::Vector(0, 0, 1), 0}, {oracle::Vector(Rational(3) / 5, 0, Rational(-4) / 5), 0}};
  Random random(1911);
  int most = 0;
  for (int i = 0; i < 400; ++i) {
    const Rational x = 1 + positive(random, 3);
    const Rational z = x * random.integer(1, 8) / 12;
    const oracle::Vector velocity(-positive(random, 5), 0, fraction(random, 5));
    const auto got =
        contact::advance_straight<Rational>({oracle::Vector(x, 0, z), velocity}, 0, 1000, walls,
                                            contact::impact_rules<Rational>(1, 0, 100));
    REQUIRE(got.end == contact::AdvanceEnd::used_up);
    REQUIRE(got.impacts <= 5);
    REQUIRE(got.state.velocity.dot(got.state.velocity) == velocity.dot(velocity));
    for (const auto& wall : walls) REQUIRE(wall.normal.dot(got.state.position) >= wall.offset);
    most = std::max(most, got.impacts);
  }
  CHECK(most == 5);
}

namespace {

/// The largest number of impacts in a wedge of 20 degrees, over 5,000 directions that lead into it.
int max_impacts_at_twenty_degrees(double restitution, int allowed) {
  const double wedge = std::numbers::pi / 9;
  const std::vector<Plane<double>> walls{{{0, 0, 1}, 0},
                                         {{std::sin(wedge), 0, -std::cos(wedge)}, 0}};
  const auto rules = contact::impact_rules<double>(restitution, 0, allowed);
  int most = 0;
  for (int i = -2000; i < 3000; ++i) {
    const double way = std::numbers::pi * (1 + i / 9000.0);
    const auto got = contact::advance_straight<double>(
        {{std::cos(wedge / 2), 0, std::sin(wedge / 2)}, {std::cos(way), 0, std::sin(way)}}, 0, 1e9,
        walls, rules);
    most = std::max(most, got.impacts);
  }
  return most;
}

}  // namespace

TEST_CASE("with losses a wedge of angle θ can have more than ⌈π/θ⌉ impacts") {
  CHECK(max_impacts_at_twenty_degrees(1, 1000) == 9);
  CHECK(max_impacts_at_twenty_degrees(0.5, 1000) == 39);
  // Infinitely many: as many as are allowed.
  CHECK(max_impacts_at_twenty_degrees(0.1, 1000) == 1000);
}

TEST_CASE("simultaneous impacts are all handled, in the order of the list") {
  const auto walls = box<Rational>(oracle::Vector(2, 2, 2));
  const auto rules = contact::impact_rules<Rational>(1, 0, 10);
  // Into the corner: three walls at once, after half of the step.
  const auto got = contact::advance_straight<Rational>(
      {oracle::Vector(1, 1, 1), oracle::Vector(-2, -2, -2)}, 0, 1, walls, rules);
  CHECK(got.impacts == 3);
  CHECK(got.state.position == oracle::Vector(1, 1, 1));
  CHECK(got.state.velocity == oracle::Vector(2, 2, 2));
  CHECK(got.wall == 4);
  // An impact exactly at the end of the step counts.
  const auto end = contact::advance_straight<Rational>(
      {oracle::Vector(1, 1, 1), oracle::Vector(-1, 0, 0)}, 0, 1, walls, rules);
  CHECK(end.impacts == 1);
  CHECK(end.state.velocity == oracle::Vector(1, 0, 0));
  // A ball that touches a wall and moves away from it, or along it, does not hit it.
  const auto away = contact::advance_straight<Rational>(
      {oracle::Vector(0, 0, 1), oracle::Vector(1, 0, 0)}, 0, 1, walls, rules);
  CHECK(away.impacts == 0);
  CHECK(away.wall == -1);
}

TEST_CASE("when the limit on impacts is reached, the unused time is returned") {
  const std::vector<Plane<Rational>> gap{{oracle::Vector(1, 0, 0), 0},
                                         {oracle::Vector(-1, 0, 0), Rational(-1)}};
  const auto got = contact::advance_straight<Rational>(
      {oracle::Vector(Rational(1) / 2, 0, 0), oracle::Vector(1, 0, 0)}, 0, 10, gap,
      contact::impact_rules<Rational>(1, 0, 3));
  CHECK(got.end == contact::AdvanceEnd::out_of_impacts);
  CHECK(got.impacts == 3);
  CHECK(got.time_left == Rational(13) / 2);
  CHECK(got.state.position.x() == 0);
  CHECK(got.state.velocity.x() == -1);
  // With a limit of 0 the ball stops at the first wall, which it still approaches.
  const auto none = contact::advance_straight<Rational>(
      {oracle::Vector(Rational(1) / 2, 0, 0), oracle::Vector(1, 0, 0)}, 0, 10, gap,
      contact::impact_rules<Rational>(1, 0, 0));
  CHECK(none.end == contact::AdvanceEnd::out_of_impacts);
  CHECK(none.impacts == 0);
  CHECK(none.wall == 1);
  CHECK(none.time_left == Rational(19) / 2);
  CHECK(none.state.velocity.x() == 1);
}

TEST_CASE("a ball on a horizontal floor agrees with the formula of its bounces") {
  Random random(1912);
  int bounced = 0;
  int rested = 0;
  for (int i = 0; i < 1500; ++i) {
    const double height = random.uniform(0.1, 3);
    const double velocity = random.uniform(-4, 4);
    const double gravity = random.uniform(3, 15);
    const double k = random.uniform(0.2, 1);
    const double radius = random.uniform(0, 0.5);
    const double along = random.uniform(-3, 3);
    const double step = random.uniform(0.1, 3);
    const auto ball = contact::bouncing_ball(height, velocity, gravity, k);
    const double rest_speed = 0.05;
    const auto wanted = contact::follow_bounces(ball, step, rest_speed);
    const auto got = contact::advance_ballistic<double>(
        {Vector3<double>(1, 2, height + radius), Vector3<double>(along, 0, velocity)},
        Vector3<double>(0, 0, -gravity), radius, step, {{Vector3<double>(0, 0, 1), 0.0}},
        contact::impact_rules(k, rest_speed, 10000));
    // Near an impact rounding may make the two counts differ.
    if (std::abs(wanted.height) < 1e-9 && !wanted.resting) continue;
    REQUIRE(double(got.impacts) == wanted.bounces);
    REQUIRE((got.end == contact::AdvanceEnd::rests) == wanted.resting);
    // At most about 100 impacts, each with an error of 16 u of a time below 10 s, at most 20 m/s.
    REQUIRE(std::abs(got.state.position.z() - radius - wanted.height) <= 1e-11);
    REQUIRE(std::abs(got.state.position.x() - 1 - along * (step - got.time_left)) <= 1e-12);
    if (wanted.resting) {
      REQUIRE(got.time_left > 0);
      REQUIRE(std::abs(got.state.velocity.z()) <= 1e-16);
    }
    bounced += got.impacts > 0;
    rested += wanted.resting;
  }
  CHECK(bounced > 1000);
  CHECK(rested > 100);
}

TEST_CASE("without a rest speed, infinitely many bounces reach the limit") {
  const auto advance = [](int most) {
    return contact::advance_ballistic<double>(
        {Vector3<double>(0, 0, 1), Vector3<double>(0, 0, 0)}, Vector3<double>(0, 0, -8), 0.0, 2.0,
        {{Vector3<double>(0, 0, 1), 0.0}}, contact::impact_rules(0.5, 0.0, most));
  };
  const auto got = advance(30);
  CHECK(got.end == contact::AdvanceEnd::out_of_impacts);
  CHECK(got.impacts == 30);
  // All impacts are over after 3/2 s: a little more than half a second is unused.
  CHECK(got.time_left > 0.5);
  CHECK(got.time_left < 0.5 + 0x1p-28);
  // A body that lies on the floor at the start rests at once, without an impact.
  const auto lying = contact::advance_ballistic<double>(
      {Vector3<double>(0, 0, 0), Vector3<double>(1, 0, 0)}, Vector3<double>(0, 0, -8), 0.0, 2.0,
      {{Vector3<double>(0, 0, 1), 0.0}}, contact::impact_rules(0.5, 0.0, 30));
  CHECK(lying.end == contact::AdvanceEnd::rests);
  CHECK(lying.impacts == 0);
  CHECK(lying.time_left == 2.0);
}

TEST_CASE("among oblique walls no energy is gained, and no wall is passed") {
  Random random(1913);
  int impacts = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<Plane<double>> walls = box<double>(Vector3<double>(4, 4, 4));
    // An oblique wall that cuts off a corner.
    const Vector3<double> normal =
        Vector3<double>{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}
            .normalized();
    walls.push_back({normal, normal.dot(Vector3<double>(0.5, 0.5, 0.5))});
    const Vector3<double> gravity(0, 0, -9.81);
    const MotionState<Vector3<double>> start{
        Vector3<double>{random.uniform(1.5, 3.5), random.uniform(1.5, 3.5),
                        random.uniform(1.5, 3.5)},
        Vector3<double>{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)}};
    const double k = random.chance(0.5) ? 1 : random.uniform(0.5, 1);
    const auto got = contact::advance_ballistic<double>(start, gravity, 0.25, 2.0, walls,
                                                        contact::impact_rules(k, 1e-3, 400));
    const auto energy = [&](const MotionState<Vector3<double>>& s) {
      return s.velocity.squaredNorm() / 2 + 9.81 * s.position.z();
    };
    const double before = energy(start);
    // At most a hundred impacts for k = 1, each with about 50 roundings of numbers below 300.
    const double room = 100 * 50 * 300 * 0x1p-53;
    REQUIRE(energy(got.state) <= before + room);
    if (k == 1 && got.end == contact::AdvanceEnd::used_up) {
      REQUIRE(energy(got.state) >= before - room);
    }
    for (const auto& wall : walls) {
      REQUIRE(wall.normal.dot(got.state.position) - wall.offset >= 0.25 - 1e-11);
    }
    impacts += got.impacts;
  }
  CHECK(impacts > 3000);
}
