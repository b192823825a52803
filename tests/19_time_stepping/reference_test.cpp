// Steps, flights and advances against fractions (class (a) of the oracle), square roots of
// fractions (b), intervals (c) and closed forms (d). Integrators run on fractions themselves, so
// that what they do to energy is not a measurement but an identity. u is the unit roundoff.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/advance.hpp>
#include <contact/ballistic.hpp>
#include <contact/bouncing.hpp>
#include <contact/integrators.hpp>
#include <contact/rollback.hpp>
#include <contact/spring_motion.hpp>
#include <limits>
#include <string>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::Integrator;
using contact::MotionState;
using contact::Plane;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

using Line = MotionState<Rational>;

/// A fraction with a small denominator, from −bound to bound.
Rational fraction(Random& random, int bound) {
  const int denominator = random.integer(1, 12);
  return Rational(random.integer(-bound * denominator, bound * denominator)) / denominator;
}
Rational positive(Random& random, int bound) {
  const int denominator = random.integer(1, 12);
  return Rational(random.integer(1, bound * denominator)) / denominator;
}
oracle::Vector point(Random& random, int bound) {
  const Rational x = fraction(random, bound);
  const Rational y = fraction(random, bound);
  const Rational z = fraction(random, bound);
  return {x, y, z};
}

constexpr std::array all_integrators{Integrator::position_first, Integrator::velocity_first,
                                     Integrator::velocity_verlet, Integrator::position_verlet,
                                     Integrator::runge_kutta_4};

}  // namespace

TEST_CASE("in a free fall Euler is off by g h t / 2, up or down, and the others not at all") {
  Random random(1901);
  for (int i = 0; i < 300; ++i) {
    const oracle::Vector gravity = point(random, 12);
    const MotionState<oracle::Vector> start{point(random, 5), point(random, 9)};
    const Rational h = positive(random, 1) / 10;
    const int steps = random.integer(1, 20);
    const Rational t = h * steps;
    const oracle::Vector right = oracle::ballistic(start.position, start.velocity, gravity, t);
    const oracle::Vector off = gravity * Rational(h * t / 2);
    const auto law = [&gravity](const oracle::Vector&) { return gravity; };
    for (const Integrator integrator : all_integrators) {
      const auto got = contact::integrate(integrator, start, h, steps, law);
      oracle::Vector wanted = right;
      if (integrator == Integrator::position_first) wanted -= off;
      if (integrator == Integrator::velocity_first) wanted += off;
      REQUIRE(got.position == wanted);
      REQUIRE(got.velocity == oracle::Vector(start.velocity + gravity * t));
    }
    const auto flown = contact::ballistic_motion(start, gravity, t);
    REQUIRE(flown.position == right);
    REQUIRE(flown.velocity == oracle::Vector(start.velocity + gravity * t));
  }
}

TEST_CASE("what each step does to the energy of a spring, as identities") {
  Random random(1902);
  for (int i = 0; i < 300; ++i) {
    const auto spring = contact::linear_spring<Rational>(positive(random, 5));
    const Rational w = spring.angular_frequency;
    const Rational h = positive(random, 1) / 4;
    const Rational z2 = w * w * h * h;
    const Line before{fraction(random, 3), fraction(random, 3)};
    const Rational kinetic = before.velocity * before.velocity;
    const Rational stretch = w * w * before.position * before.position;
    const auto parts = [&w](const Line& s) {
      return std::pair<Rational, Rational>(s.velocity * s.velocity,
                                           w * w * s.position * s.position);
    };
    const Rational energy = contact::spring_energy(spring, before);
    REQUIRE(energy == (kinetic + stretch) / 2);

    const Line explicit_euler = contact::position_first_step(before, h, spring);
    REQUIRE(contact::spring_energy(spring, explicit_euler) == energy * (1 + z2));

    const Line euler = contact::velocity_first_step(before, h, spring);
    const auto kept = [&](const Line& s) {
      const auto [k, p] = parts(s);
      return Rational(k + p - h * w * w * s.position * s.velocity);
    };
    REQUIRE(kept(euler) == kept(before));

    const auto by_velocity = parts(contact::velocity_verlet_step(before, h, spring));
    REQUIRE(by_velocity.first + by_velocity.second * (1 - z2 / 4) ==
            kinetic + stretch * (1 - z2 / 4));
    const auto by_position = parts(contact::position_verlet_step(before, h, spring));
    REQUIRE(by_position.first * (1 - z2 / 4) + by_position.second ==
            kinetic * (1 - z2 / 4) + stretch);

    const Line kutta = contact::runge_kutta_4_step(before, h, spring);
    const Rational z6 = z2 * z2 * z2;
    REQUIRE(contact::spring_energy(spring, kutta) == energy * (1 - z6 / 72 + z6 * z2 / 576));
  }
}

TEST_CASE("Verlet's steps go back to where they came from, and the others do not") {
  Random random(1903);
  for (int i = 0; i < 200; ++i) {
    const Rational pull = positive(random, 4);
    const auto law = [&pull](const Rational& x) { return Rational(-pull * x * (1 + x * x)); };
    const Line start{positive(random, 2), fraction(random, 2)};
    const Rational h = positive(random, 1) / 8;
    for (const Integrator integrator : all_integrators) {
      const Line there = contact::motion_step(integrator, start, h, law);
      const Line back = contact::motion_step(integrator, there, Rational(-h), law);
      const bool same = back.position == start.position && back.velocity == start.velocity;
      const bool verlet =
          integrator == Integrator::velocity_verlet || integrator == Integrator::position_verlet;
      REQUIRE(same == verlet);
    }
  }
}

TEST_CASE("halving the step halves, quarters or divides by sixteen the error") {
  // The leading term of the error is c hᵖ t, the next one of order h^(p+1): with ω h = 1/50 and
  // halved, the ratio is 2ᵖ to within some per cent. A tenth is asked for.
  const auto spring = contact::linear_spring(1.0);
  const MotionState<double> start{1, 0.5};
  const double t = 2;
  const auto truth = contact::spring_motion(spring, start, t);
  const auto off = [&](Integrator integrator, int steps) {
    const auto end = contact::integrate(integrator, start, t / steps, steps, spring);
    return std::hypot(end.position - truth.position, end.velocity - truth.velocity);
  };
  for (const auto& [integrator, ratio] :
       {std::pair(Integrator::position_first, 2.0), std::pair(Integrator::velocity_first, 2.0),
        std::pair(Integrator::velocity_verlet, 4.0), std::pair(Integrator::position_verlet, 4.0),
        std::pair(Integrator::runge_kutta_4, 16.0)}) {
    const double found = off(integrator, 100) / off(integrator, 200);
    INFO(static_cast<int>(integrator) << ": " << found);
    CHECK(found > 0.9 * ratio);
    CHECK(found < 1.1 * ratio);
  }
}

TEMPLATE_TEST_CASE("steps in floating point are near the steps in fractions", "", float, double) {
  using S = TestType;
  Random random(1904);
  for (int i = 0; i < 500; ++i) {
    const S w = S(random.uniform(0.5, 4));
    const S h = S(random.uniform(0.001, 0.2));
    const S x = S(random.uniform(-3, 3));
    const S v = S(random.uniform(-3, 3));
    const auto spring = contact::linear_spring(w);
    const auto exact = contact::linear_spring(oracle::exact(w));
    for (const Integrator integrator : all_integrators) {
      const auto got = contact::motion_step(integrator, MotionState<S>{x, v}, h, spring);
      const Line right = contact::motion_step(integrator, Line{oracle::exact(x), oracle::exact(v)},
                                              oracle::exact(h), exact);
      // Runge and Kutta's step has the longest chain: 40 roundings, of numbers no larger than
      // (1 + ω² + ω) (|x| + |v|) < 21 · 6.
      REQUIRE(oracle::exact(oracle::error(double(got.position), right.position)) <=
              40 * 126 * u<S>());
      REQUIRE(oracle::exact(oracle::error(double(got.velocity), right.velocity)) <=
              40 * 126 * u<S>());
    }
  }
}

TEST_CASE("the motion on a spring agrees with intervals") {
  Random random(1905);
  for (int i = 0; i < 600; ++i) {
    const double w = random.uniform(0.1, 20);
    const double t = random.uniform(-30, 30);
    const double x = random.uniform(-2, 2);
    const double v = random.uniform(-2, 2);
    const auto got = contact::spring_motion(contact::linear_spring(w), {x, v}, t);
    const auto number = [](double value) { return oracle::Interval(oracle::exact(value), 160); };
    const oracle::Interval angle = number(w) * number(t);
    const auto place = oracle::enclose(number(x) * cos(angle) + number(v) / number(w) * sin(angle));
    const auto speed = oracle::enclose(number(v) * cos(angle) - number(w) * number(x) * sin(angle));
    const double room = (8 + 2 * w * std::abs(t)) * 0x1p-53 * (std::abs(x) + std::abs(v) / w);
    REQUIRE(place.error(got.position) <= room);
    REQUIRE(speed.error(got.velocity) <= w * room);
  }
}

TEMPLATE_TEST_CASE("a flight of any length is right to some digits of its parts", "", float,
                   double) {
  using S = TestType;
  Random random(1906);
  for (int i = 0; i < 2000; ++i) {
    const S x = S(random.magnitude(-6, 6));
    const S v = S(random.magnitude(-6, 6));
    const S a = S(random.magnitude(-6, 6));
    const S t = S(std::abs(random.magnitude(-6, 6)));
    const auto got = contact::ballistic_motion(MotionState<S>{x, v}, a, t);
    const Rational way = oracle::exact(v) * oracle::exact(t);
    const Rational fall = oracle::exact(a) * oracle::exact(t) * oracle::exact(t) / 2;
    const Rational size = abs(oracle::exact(x)) + abs(way) + abs(fall);
    const Rational right = oracle::exact(x) + way + fall;
    REQUIRE(oracle::exact(oracle::error(double(got.position), right)) <= 4 * u<S>() * size);
  }
}

namespace {

/// The first t ≥ 0 at which gap + rate t + a t²/2 ≤ 0 for a gap that gets smaller, as a number with
/// one root; nothing if there is none.
std::optional<Surd> closing(const Rational& gap, const Rational& rate, const Rational& a) {
  const bool shrinks = rate < 0 || (rate == 0 && a < 0);
  if (gap <= 0) {
    if (shrinks) return Surd{0, 0, 0};
    if (a >= 0) return std::nullopt;
  }
  const Rational square = rate * rate - 2 * a * gap;
  if (a == 0) return rate < 0 ? std::optional<Surd>(Surd{-gap / rate, 0, 0}) : std::nullopt;
  if (square < 0) return gap <= 0 ? std::optional<Surd>(Surd{-rate / a, 0, 0}) : std::nullopt;
  if (gap > 0 && a > 0 && rate >= 0) return std::nullopt;
  // For a > 0 the smaller root of the two that are positive, for a < 0 the only or the later one:
  // (−rate − √square) / a in both cases.
  return Surd{-rate / a, -1 / a, square};
}

}  // namespace

TEMPLATE_TEST_CASE("whether and when a gap closes", "", float, double) {
  using S = TestType;
  Random random(1907);
  int never = 0;
  int grazing = 0;
  for (int i = 0; i < 12000; ++i) {
    S gap = S(std::abs(random.magnitude(-8, 8)));
    S rate = S(random.magnitude(-6, 6));
    S a = S(random.magnitude(-6, 6));
    const int kind = random.integer(0, 9);
    if (kind == 0) gap = S(0);
    if (kind == 1) gap = -gap;
    if (kind == 2) a = S(0);
    if (kind == 3) rate = S(0);
    if (kind >= 6) {  // a ceiling that is only just reached, or not
      a = std::abs(a);
      rate = -std::abs(rate);
      gap = rate * rate / (S(2) * a);
      for (int steps = random.integer(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1) {
        gap = std::nextafter(gap, steps > 0 ? S(1e9) : S(0));
      }
    }
    if (kind == 9) {  // exactly
      const int p = random.integer(-3, 3);
      a = S(std::ldexp(1.0, p));
      rate = -S(random.integer(1, 64));
      gap = rate * rate / (S(2) * a);
    }
    const auto right = closing(oracle::exact(gap), oracle::exact(rate), oracle::exact(a));
    const auto got = contact::closing_time(gap, rate, a);
    INFO("gap " << gap << " rate " << rate << " a " << a);
    REQUIRE(got.has_value() == right.has_value());
    never += !right;
    if (!right) continue;
    grazing += right->d == 0 && right->b != 0;
    const double off = oracle::error(double(*got), *right);
    REQUIRE(oracle::exact(off) <= 16 * u<S>() * oracle::exact(*got));
  }
  CHECK(never > 1000);
  CHECK(grazing > 1000);
}

TEST_CASE("sizes do not matter to a closing gap, but for the largest and smallest") {
  Random random(1908);
  for (int i = 0; i < 2000; ++i) {
    const double gap = std::abs(random.magnitude(-2, 2));
    const double rate = random.magnitude(-2, 2);
    const double a = random.magnitude(-2, 2);
    const auto plain = contact::closing_time(gap, rate, a);
    const int metres = random.integer(-120, 120);
    const int seconds = random.integer(-60, 60);
    const auto scaled =
        contact::closing_time(std::ldexp(gap, metres), std::ldexp(rate, metres - seconds),
                              std::ldexp(a, metres - 2 * seconds));
    REQUIRE(plain.has_value() == scaled.has_value());
    if (plain) REQUIRE(*scaled == std::ldexp(*plain, seconds));
  }
  // Total: the worst finite numbers give a number or nothing.
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double gap : {0.0, tiny, 1.0, huge, -huge, -tiny}) {
    for (const double rate : {0.0, tiny, -tiny, 1.0, -1.0, huge, -huge}) {
      for (const double a : {0.0, tiny, -tiny, 1.0, -1.0, huge, -huge}) {
        const auto t = contact::closing_time(gap, rate, a);
        CHECK((!t || (std::isfinite(*t) && *t >= 0)));
      }
    }
  }
}

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

/// Where a point is that bounces between 0 and `length` without loss: a straight line, folded.
Rational folded(const Rational& x, const Rational& length) {
  Rational rest = x / (2 * length);
  const oracle::Integer whole = numerator(rest) / denominator(rest);
  rest -= Rational(whole);
  if (rest < 0) rest += 1;
  return rest * 2 <= 1 ? Rational(rest * 2 * length) : Rational((2 - 2 * rest) * length);
}

}  // namespace

TEST_CASE("advancing in a box is a straight line, folded: exactly, in fractions") {
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

TEST_CASE("in a wedge there is an end of impacts, at most the angles that fit into half a turn") {
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

TEST_CASE("impacts at one time are met in the order of the list, and all of them") {
  const auto walls = box<Rational>(oracle::Vector(2, 2, 2));
  const auto rules = contact::impact_rules<Rational>(1, 0, 10);
  // Into the corner, three walls at once, at half of the step.
  const auto got = contact::advance_straight<Rational>(
      {oracle::Vector(1, 1, 1), oracle::Vector(-2, -2, -2)}, 0, 1, walls, rules);
  CHECK(got.impacts == 3);
  CHECK(got.state.position == oracle::Vector(1, 1, 1));
  CHECK(got.state.velocity == oracle::Vector(2, 2, 2));
  CHECK(got.wall == 4);
  // An impact at the very end belongs to the step.
  const auto end = contact::advance_straight<Rational>(
      {oracle::Vector(1, 1, 1), oracle::Vector(-1, 0, 0)}, 0, 1, walls, rules);
  CHECK(end.impacts == 1);
  CHECK(end.state.velocity == oracle::Vector(1, 0, 0));
  // What touches a wall and moves away from it, or along it, does not meet it.
  const auto away = contact::advance_straight<Rational>(
      {oracle::Vector(0, 0, 1), oracle::Vector(1, 0, 0)}, 0, 1, walls, rules);
  CHECK(away.impacts == 0);
  CHECK(away.wall == -1);
}

TEST_CASE("a number of impacts that is spent is said, with the time that is left") {
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
  // With none allowed it stops at the first wall, which it still approaches.
  const auto none = contact::advance_straight<Rational>(
      {oracle::Vector(Rational(1) / 2, 0, 0), oracle::Vector(1, 0, 0)}, 0, 10, gap,
      contact::impact_rules<Rational>(1, 0, 0));
  CHECK(none.end == contact::AdvanceEnd::out_of_impacts);
  CHECK(none.impacts == 0);
  CHECK(none.wall == 1);
  CHECK(none.time_left == Rational(19) / 2);
  CHECK(none.state.velocity.x() == 1);
}

TEST_CASE("a ball on a level floor does what the formula of the bounces says") {
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
    // Near an impact the two may count differently, by rounding.
    if (std::abs(wanted.height) < 1e-9 && !wanted.resting) continue;
    REQUIRE(double(got.impacts) == wanted.bounces);
    REQUIRE((got.end == contact::AdvanceEnd::rests) == wanted.resting);
    // Some 100 impacts at most, each off by 16 u of a time below 10 s, times a speed below 20 m/s.
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

TEST_CASE("without a rest speed, bounces without end spend the rules' number") {
  const auto advance = [](int most) {
    return contact::advance_ballistic<double>(
        {Vector3<double>(0, 0, 1), Vector3<double>(0, 0, 0)}, Vector3<double>(0, 0, -8), 0.0, 2.0,
        {{Vector3<double>(0, 0, 1), 0.0}}, contact::impact_rules(0.5, 0.0, most));
  };
  const auto got = advance(30);
  CHECK(got.end == contact::AdvanceEnd::out_of_impacts);
  CHECK(got.impacts == 30);
  // All impacts are over after 3/2 s: what is left is half a second and a little.
  CHECK(got.time_left > 0.5);
  CHECK(got.time_left < 0.5 + 0x1p-28);
  // A body that lies on the floor from the start rests at once, and has met nothing.
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
    // A slope across a corner.
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
    // A hundred impacts at most for k = 1, each with some 50 roundings of numbers below 300.
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

TEST_CASE("brackets keep their promise, and bisection makes them as narrow as numbers are") {
  Random random(1914);
  for (int i = 0; i < 1000; ++i) {
    const double wall = random.uniform(0.01, 0.99);
    int asked = 0;
    const auto is_free = [&](double t) {
      ++asked;
      return t < wall;
    };
    const int slices = random.integer(1, 20);
    const auto slice = contact::last_free_slice(is_free, 1.0, slices);
    REQUIRE(slice);
    REQUIRE(slice->free < wall);
    REQUIRE(slice->blocked >= wall);
    REQUIRE(slice->blocked - slice->free <= (1 + 1e-12) / slices);
    const double width = random.chance(0.3) ? 0 : std::ldexp(1.0, -random.integer(5, 40));
    const auto bracket = contact::bisected(is_free, *slice, width);
    REQUIRE(bracket.free < wall);
    REQUIRE(bracket.blocked >= wall);
    REQUIRE(bracket.looks == asked);
    if (width > 0) {
      REQUIRE(bracket.blocked - bracket.free <= width);
    } else {
      REQUIRE(bracket.blocked == std::nextafter(bracket.free, 1.0));
      REQUIRE(bracket.blocked == wall);
    }
  }
}

TEST_CASE("what is in and out between two looks is not seen") {
  const auto is_free = [](const Rational& t) {
    return t < Rational(4) / 10 || t > Rational(6) / 10;
  };
  CHECK_FALSE(contact::last_free_slice<Rational>(is_free, 1, 1));
  CHECK_FALSE(contact::last_free_slice<Rational>(is_free, 1, 3));
  const auto seen = contact::last_free_slice<Rational>(is_free, 1, 5);
  REQUIRE(seen);
  CHECK(seen->free == Rational(1) / 5);
  CHECK(seen->blocked == Rational(2) / 5);
}

TEST_CASE("rolling back neither gains energy nor passes the floor, and comes to the truth") {
  Random random(1915);
  for (int i = 0; i < 200; ++i) {
    const double height = random.uniform(0.5, 3);
    const double k = random.chance(0.5) ? 1 : random.uniform(0.5, 0.9);
    const auto ball = contact::bouncing_ball(height, 0.0, 9.81, k);
    const double dt = random.uniform(0.005, 0.03);
    const int steps = static_cast<int>(1.5 / dt);
    contact::BounceState<double> coarse{height, 0, 0, false};
    contact::BounceState<double> fine = coarse;
    double energy = 9.81 * height;
    for (int step = 0; step < steps; ++step) {
      coarse = contact::rolled_back_step<double>(coarse, ball, dt,
                                                 {4, std::numeric_limits<double>::infinity()});
      fine = contact::rolled_back_step<double>(fine, ball, dt, {1, 0x1p-48});
      REQUIRE(coarse.height >= 0);
      REQUIRE(fine.height >= 0);
      const double now = coarse.velocity * coarse.velocity / 2 + 9.81 * coarse.height;
      REQUIRE(now <= energy + 1e-13 * energy);
      energy = std::min(energy, now);
    }
    const auto truth = contact::bounce_at(ball, dt * steps);
    if (truth.resting || truth.bounces > 6 || truth.height < 1e-6) continue;
    CHECK(fine.bounces == truth.bounces);
    // At most seven impacts, each early by 2^-48 s, at speeds below 8 m/s, with 1.5 s to go.
    CHECK(std::abs(fine.height - truth.height) <= 7 * 8 * 0x1p-48 * 8 + 1e-12);
  }
}

TEST_CASE("what cannot be is refused by name") {
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(contains(refusal([] { contact::linear_spring(0.0); }), "angular_frequency = 0"));
  CHECK(contains(refusal([&] { contact::linear_spring(infinite); }), "angular_frequency"));
  CHECK(contains(refusal([] { contact::impact_rules(1.5, 0.0, 1); }), "restitution"));
  CHECK(contains(refusal([] { contact::impact_rules(1.0, -1.0, 1); }), "rest_speed"));
  CHECK(contains(refusal([] { contact::impact_rules(1.0, 0.0, -1); }), "most_impacts = -1"));
  CHECK(contains(refusal([] { contact::impact_rules(std::nan(""), 0.0, 1); }), "restitution"));
}
