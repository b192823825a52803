// One impact in closed form against intervals (class (c) of the oracle), and the formulas
// themselves against the power series of the motion, which does not use them (class (d)). U is the
// unit roundoff of double, in which everything is computed; u that of the type.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/restitution.hpp>
#include <contact/spring_impact.hpp>
#include <contact/tolerance.hpp>
#include <contact/trampoline.hpp>
#include <limits>
#include <string>
#include <utility>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace spring_impact_test {

using contact::ContactRelease;
using contact::SpringDamper;
using generators::Random;
using oracle::Interval;
using oracle::Rational;
using support::refusal;

namespace {

constexpr double kUnit = 0x1p-53;

/// Around 2^1000 the sum in a root needs twice as many bits as the square.
unsigned bits_for(double z) { return z > 1e6 || z < 1e-6 ? 2400 : 320; }

template <class S>
double last(const S&) {
  return double(contact::tolerance::unit_roundoff<S>);
}

/// θ / sin θ by the interval library. The caller handles ζ = 1.
Interval arc_over_sine(const Interval& z, bool below_one) {
  const Interval one(Rational(1), z.bits());
  if (below_one) return acos(z) / sqrt((one - z) * (one + z));
  const Interval root = sqrt((z - one) * (z + one));
  return log(z + root) / root;
}

/// Whether got is within `room` times the value, for a value that is not 0.
bool within(double got, const Interval& value, double room) {
  if (!std::isfinite(got)) return false;
  const Interval off = (Interval(oracle::exact(got), value.bits()) - value) / value;
  const Rational allowed = oracle::exact(room);
  return off.high() <= allowed && off.low() >= -allowed;
}

/// Damping ratios of every magnitude, and as close to 1 as numbers allow.
double any_ratio(Random& random, int i) {
  switch (i % 5) {
    case 0:
      return random.uniform();
    case 1:
      return 1 + random.uniform(-0x1p-10, 0x1p-10);
    case 2: {
      double z = 1;
      for (int n = random.integer(1, 6); n > 0; --n) z = std::nextafter(z, i % 2 == 0 ? 0.0 : 2.0);
      return z;
    }
    case 3:
      return std::abs(random.magnitude(-60, 0));
    default:
      return std::abs(random.magnitude(0, i % 2 == 0 ? 20 : 1000));
  }
}

/// x and ẋ of ẍ = load − ω² x − 2 γ ẋ from x = 0 and ẋ = v, after time t, by their power series in
/// intervals. For ω t and 2 γ t up to 9 the omitted terms are below 2^-250.
struct Motion {
  Interval position;
  Interval speed;
};
Motion motion(const Rational& square, const Rational& twice_gamma, const Rational& load,
              const Rational& v, const Rational& t) {
  constexpr unsigned bits = 384;
  const auto lift = [](const Rational& x) { return Interval(x, bits); };
  const Interval a = lift(square * t * t);
  const Interval b = lift(twice_gamma * t);
  // With s = t' / t: x'' = load t² − a x − b x'.
  Interval earlier = lift(0);
  Interval now = lift(v * t);
  Interval position = now;
  Interval speed = now;
  for (int n = 0; n < 130; ++n) {
    Interval next =
        -(a * earlier / lift(Rational((n + 1) * (n + 2)))) - b * now / lift(Rational(n + 2));
    if (n == 0) next = next + lift(load * t * t / 2);
    position = position + next;
    speed = speed + next * lift(Rational(n + 2));
    earlier = now;
    now = next;
  }
  return {position, speed / lift(t)};
}

double middle(const Interval& x) { return oracle::nearest(Rational((x.low() + x.high()) / 2)); }

}  // namespace

TEST_CASE("θ / sin θ is right for every damping ratio") {
  Random random(1611);
  for (int i = 0; i < generators::tried(5000); ++i) {
    const double z = any_ratio(random, i);
    if (z == 1) continue;
    const Interval exact = arc_over_sine(Interval(oracle::exact(z), bits_for(z)), z < 1);
    INFO(z);
    REQUIRE(within(contact::arc_over_sine(z), exact, 80 * kUnit));
    REQUIRE(
        within(double(contact::arc_over_sine(float(z < 1e38 ? z : 1))),
               z < 1e38 && float(z) != 1.0F
                   ? arc_over_sine(Interval(oracle::exact(float(z)), bits_for(z)), float(z) < 1.0F)
                   : Interval(oracle::Rational(1), 64),
               80 * kUnit + last(1.0F) * 1.001 + (z > 1e37 ? 1e-3 : 0)));
  }
  CHECK(contact::arc_over_sine(1.0) == 1.0);
  CHECK(within(contact::arc_over_sine(0.0), Interval::pi(128) / Interval(Rational(2), 128),
               20 * kUnit));
  CHECK(contact::arc_over_sine(std::numeric_limits<double>::infinity()) > 0);
}

TEST_CASE("exponential and logarithm by the four basic operations") {
  Random random(1612);
  for (int i = 0; i < generators::tried(5000); ++i) {
    const double y = i % 2 == 0 ? random.uniform(0, 708) : std::abs(random.magnitude(-60, 8));
    INFO(y);
    REQUIRE(within(contact::detail::decay(y), exp(-Interval(oracle::exact(y), 256)), 4 * kUnit));
    double x =
        i % 2 == 0 ? random.uniform() : std::ldexp(random.uniform(1, 2), -random.integer(1, 1000));
    if (i % 10 == 0) x = 1 - std::ldexp(1.0, -random.integer(1, 53));
    if (x <= 0 || x >= 1) continue;
    INFO(x);
    REQUIRE(within(contact::detail::log_of_inverse(x), -log(Interval(oracle::exact(x), 1200)),
                   10 * kUnit));
  }
  CHECK(contact::detail::decay(0) == 1);
  CHECK(contact::detail::log_of_inverse(1) == 0);
  CHECK(contact::detail::decay(1e308) == 0);
  CHECK(contact::detail::decay(745) > 0);
}

TEST_CASE("restitution of a damping ratio, for both rules") {
  Random random(1613);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const double z = any_ratio(random, i);
    if (z == 1) continue;
    INFO(z);
    const unsigned bits = bits_for(z);
    const Interval x(oracle::exact(z), bits);
    const Interval one(Rational(1), bits);
    const Interval y = Interval(Rational(2), bits) * x * arc_over_sine(x, z < 1);
    const double most = middle(y);
    if (most < 700) {
      REQUIRE(within(contact::restitution_of_damping(z, ContactRelease::at_zero_force), exp(-y),
                     (8 + 90 * most) * kUnit));
    }
    const double glued = contact::restitution_of_damping(z, ContactRelease::at_zero_penetration);
    REQUIRE(glued <= contact::restitution_of_damping(z, ContactRelease::at_zero_force));
    if (z > 1) {
      REQUIRE(glued == 0);
      continue;
    }
    const Interval late = Interval::pi(bits) * x / sqrt((one - x) * (one + x));
    if (middle(late) < 700) {
      REQUIRE(within(glued, exp(-late), (8 + (90 + 6 / (1 - z)) * middle(late)) * kUnit));
    }
  }
  for (const ContactRelease rule :
       {ContactRelease::at_zero_force, ContactRelease::at_zero_penetration})
    CHECK(contact::restitution_of_damping(0.0, rule) == 1);
  CHECK(contact::restitution_of_damping(1.0, ContactRelease::at_zero_penetration) == 0);
  CHECK(within(contact::restitution_of_damping(1.0, ContactRelease::at_zero_force),
               exp(-Interval(Rational(2), 128)), 200 * kUnit));
}

TEST_CASE("the damping ratio of a restitution is the inverse function") {
  Random random(1614);
  const auto exponent = [](const Rational& z) {
    const Interval x(z, 2400);
    return Interval(Rational(2), 2400) * x * arc_over_sine(x, z < 1);
  };
  for (int i = 0; i < generators::tried(1500); ++i) {
    double e = i % 3 == 0 ? std::ldexp(random.uniform(1, 2), -random.integer(1, 400))
                          : random.uniform(1e-6, 1);
    if (i % 10 == 0) e = 1 - std::ldexp(1.0, -random.integer(1, 50));
    INFO(e);
    const Interval l = -log(Interval(oracle::exact(e), 2400));
    const double room = 200 * (1 + middle(l)) * kUnit;
    // 2 ζ θ / sin θ increases with ζ: too small a little below, too large a little above.
    const double z = contact::damping_ratio_for(e, ContactRelease::at_zero_force);
    const Rational less = oracle::exact(z) * (1 - oracle::exact(room));
    const Rational more = oracle::exact(z) * (1 + oracle::exact(room));
    REQUIRE((exponent(less) - l).sign() == -1);
    REQUIRE((exponent(more) - l).sign() == 1);

    const Interval pi = Interval::pi(2400);
    REQUIRE(within(contact::damping_ratio_for(e, ContactRelease::at_zero_penetration),
                   l / sqrt(pi * pi + l * l), 200 * kUnit));
  }
  for (const ContactRelease rule :
       {ContactRelease::at_zero_force, ContactRelease::at_zero_penetration})
    CHECK(contact::damping_ratio_for(1.0, rule) == 0);
  CHECK(contact::damping_ratio_for(0.0, ContactRelease::at_zero_penetration) == 1);
  CHECK(refusal([] {
          contact::damping_ratio_for(0.0, ContactRelease::at_zero_force);
        }).find("restitution") != std::string::npos);
  for (const double e : {-0.5, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(!refusal([e] {
             contact::damping_ratio_for(e, ContactRelease::at_zero_penetration);
           }).empty());
  }
  CHECK(!refusal([] { contact::spring_for_restitution(0.0, 1.0, 0.5); }).empty());
  CHECK(refusal([] { contact::spring_for_restitution(1.0, -1.0, 0.5); }).find("mass") !=
        std::string::npos);
}

TEMPLATE_TEST_CASE("the formulas of an impact agree with the motion", "", float, double) {
  using S = TestType;
  Random random(1615);
  int soft = 0;
  for (int i = 0; i < generators::tried(80); ++i) {
    const S m = S(random.uniform(0.1, 10));
    const S k = S(random.uniform(1, 1000));
    const double z = i % 4 == 0 ? random.uniform(1, 4) : random.uniform(0, 0.95);
    const S c = S(2 * z * std::sqrt(double(k)) * std::sqrt(double(m)));
    const S v = S(random.uniform(0.1, 10));
    const auto spring = contact::spring_damper(k, c);
    const Rational square = oracle::exact(k) / oracle::exact(m);
    const Rational twice_gamma = oracle::exact(c) / oracle::exact(m);
    const auto at = [&](S t) {
      return motion(square, twice_gamma, 0, oracle::exact(v), oracle::exact(t));
    };
    const auto force = [&](const Motion& x) {
      return double(k) * middle(x.position) + double(c) * middle(x.speed);
    };
    // A time has an error of some hundred u, a velocity ω v times that, a position v times that.
    const double rate = std::sqrt(double(k) / double(m));
    const double room = 2000 * last(S(1)) * (1 + z);
    const double scale = double(v) / rate;

    const auto free = contact::spring_impact(spring, m, v, ContactRelease::at_zero_force);
    const Motion deepest = at(free.time_of_depth);
    REQUIRE(std::abs(middle(deepest.speed)) <= room * double(v));
    REQUIRE(std::abs(middle(deepest.position) - double(free.max_depth)) <= room * scale);
    const Motion end = at(free.duration);
    REQUIRE(std::abs(force(end)) <= room * double(m) * double(v) * rate * (1 + 2 * z));
    REQUIRE(std::abs(middle(end.speed) + double(free.restitution * v)) <= room * double(v));
    REQUIRE(std::abs(middle(end.position) - double(free.left_overlap)) <= room * scale);
    // At the greatest penetration the spring holds the fraction e of the kinetic energy before.
    REQUIRE(std::abs(double(k) * double(free.max_depth) * double(free.max_depth) -
                     double(free.restitution) * double(m) * double(v) * double(v)) <=
            room * double(m) * double(v) * double(v));

    double most = double(c) * double(v);  // at the first touch
    for (int n = 1; n <= 16; ++n) {
      const Motion x = at(S(double(free.duration) * n / 16));
      REQUIRE(force(x) >= -room * double(free.max_force));
      REQUIRE(force(x) <= double(free.max_force) * (1 + room));
      REQUIRE(middle(x.position) <= double(free.max_depth) * (1 + room));
      most = std::max(most, force(x));
    }
    // Between two samples a sine exceeds the larger one by at most 1 − cos(π/32) of its amplitude.
    REQUIRE(most >= double(free.max_force) * 0.99);

    const auto glued = contact::spring_impact(spring, m, v, ContactRelease::at_zero_penetration);
    REQUIRE(glued.max_depth == free.max_depth);
    REQUIRE(glued.time_of_depth == free.time_of_depth);
    REQUIRE(glued.left_overlap == S(0));
    if (contact::damping_regime(spring, m) != contact::DampingRegime::underdamped) {
      REQUIRE(std::isinf(glued.duration));
      REQUIRE(glued.restitution == S(0));
      continue;
    }
    ++soft;
    const Motion out = at(glued.duration);
    REQUIRE(std::abs(middle(out.position)) <= 4 * room * scale);
    REQUIRE(std::abs(middle(out.speed) + double(glued.restitution * v)) <= 4 * room * double(v));
    REQUIRE(force(out) <= room * double(free.max_force));  // then it pulls, or is 0
    // The velocities afterwards are those of an impulse with this restitution.
    const contact::Vector3<S> up(S(0), S(0), S(1));
    const auto bounced = contact::after_bounce<S>(up * S(-v), up, glued.restitution);
    REQUIRE(std::abs(double(bounced.z()) - double(glued.restitution) * double(v)) <=
            24 * last(S(1)) * double(v));
  }
  CHECK(soft > generators::tried(40));
}

TEMPLATE_TEST_CASE("the numbers of an impact are within their error bounds", "", float, double) {
  using S = TestType;
  Random random(1619);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const S m = S(std::abs(random.magnitude(-20, 20)));
    const S k = S(std::abs(random.magnitude(-20, 20)));
    const S v = S(std::abs(random.magnitude(-10, 10)));
    const double z = any_ratio(random, 1 + i % 3 + 5 * i);
    const S c = S(2 * z * std::sqrt(double(k)) * std::sqrt(double(m)));
    const auto spring = contact::spring_damper(k, c);
    constexpr unsigned bits = 512;
    const auto lift = [](const Rational& x) { return Interval(x, bits); };
    const Rational four = 4 * oracle::exact(k) * oracle::exact(m);
    const Rational rest = four - oracle::exact(c) * oracle::exact(c);
    if (rest == 0) continue;
    const Interval ratio = lift(oracle::exact(c)) / sqrt(lift(four));
    const Interval root = sqrt(lift(Rational(abs(rest) / four)));
    const Interval arc = rest > 0 ? acos(ratio) / root : log(ratio + root) / root;
    const Interval rate = sqrt(lift(Rational(oracle::exact(k) / oracle::exact(m))));
    const Interval y = lift(2) * ratio * arc;
    const double room = (100 + 100 * middle(y)) * kUnit + 1.001 * last(S(1));
    const auto free = contact::spring_impact(spring, m, v);
    REQUIRE(within(double(free.restitution), exp(-y), room));
    REQUIRE(within(double(free.duration), lift(2) * arc / rate, room));
    REQUIRE(within(double(free.time_of_depth), arc / rate, room));
    REQUIRE(
        within(double(free.max_depth), lift(oracle::exact(v)) / rate * exp(-(y / lift(2))), room));
    if (rest < 0) continue;
    const auto glued = contact::spring_impact(spring, m, v, ContactRelease::at_zero_penetration);
    const Interval turn = Interval::pi(bits);
    REQUIRE(within(double(glued.duration), turn / (rate * root), room));
    const Interval late = turn * ratio / root;
    if (middle(late) > 80) continue;  // close to the smallest numbers of the type
    REQUIRE(within(double(glued.restitution), exp(-late),
                   (100 + 100 * middle(late)) * kUnit + 1.001 * last(S(1))));
  }
}

TEST_CASE("near critical damping the time of separation is that of the stored numbers") {
  // c² = 4 k m − δ with k and m near 1: rounding c / (2 √k √m) to ζ would lose δ altogether.
  Random random(1616);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double k = random.uniform(1, 2);
    const double m = random.uniform(1, 2);
    double c = 2 * std::sqrt(k) * std::sqrt(m);
    for (int n = random.integer(2, 9); n > 0; --n) c = std::nextafter(c, 0.0);
    const auto spring = contact::spring_damper(k, c);
    if (contact::damping_regime(spring, m) != contact::DampingRegime::underdamped) continue;
    const Rational rest =
        4 * oracle::exact(k) * oracle::exact(m) - oracle::exact(c) * oracle::exact(c);
    const Interval duration = Interval(Rational(2), 512) * Interval::pi(512) *
                              Interval(oracle::exact(m), 512) / sqrt(Interval(rest, 512));
    REQUIRE(
        within(contact::spring_impact(spring, m, 1.0, ContactRelease::at_zero_penetration).duration,
               duration, 100 * kUnit));
  }
}

TEST_CASE("an impact penetrates as much as its stiffness was chosen for") {
  Random random(1617);
  for (int i = 0; i < generators::tried(2000); ++i) {
    // Without damper: k d² / 2 = m v² / 2 + m g d, in fractions.
    const Rational m{random.integer(1, 99), random.integer(1, 99)};
    const Rational v{random.integer(0, 99), random.integer(1, 99)};
    const Rational g(random.integer(0, 20));
    const Rational d{random.integer(1, 99), random.integer(1, 9999)};
    const Rational k = contact::stiffness_for_depth(m, v, g, d);
    REQUIRE(k * d * d == m * v * v + 2 * m * g * d);
    if (g != 0 || v == 0) continue;
    const double depth = oracle::nearest(d);
    for (const double ratio : {0.0, 0.3, 1.5}) {
      const double stiff = oracle::nearest(k);
      const double mass = oracle::nearest(m);
      const double c = 2 * ratio * std::sqrt(stiff) * std::sqrt(mass);
      const auto impact =
          contact::spring_impact(contact::spring_damper(stiff, c), mass, oracle::nearest(v));
      REQUIRE(impact.max_depth <= depth * (1 + 100 * kUnit));
      REQUIRE((ratio > 0 || impact.max_depth >= depth * (1 - 100 * kUnit)));
    }
  }
}

TEMPLATE_TEST_CASE("a jump on a trampoline", "", float, double) {
  using S = TestType;
  Random random(1618);
  for (int i = 0; i < generators::tried(300); ++i) {
    const S m = S(random.uniform(20, 100));
    const S k = S(random.uniform(500, 20000));
    const S g = S(random.uniform(1, 20));
    const S h = S(i % 10 == 0 ? 0 : random.uniform(0.001, 10));
    const auto t = contact::trampoline(m, k, g, h);
    const auto jump = contact::trampoline_jump(t);
    const Rational sag = oracle::exact(m) * oracle::exact(g) / oracle::exact(k);
    const oracle::Surd depth{sag, 1, sag * sag + 2 * sag * oracle::exact(h)};
    const double deep = oracle::nearest(depth);
    const double room = 40 * last(S(1));
    REQUIRE(oracle::error(double(jump.sag), oracle::Surd{sag, 0, 0}) <= room * double(jump.sag));
    REQUIRE(oracle::error(double(jump.max_depth), depth) <= room * deep);
    REQUIRE(oracle::error(double(jump.max_force), depth * oracle::exact(k)) <=
            room * deep * double(k));
    REQUIRE(oracle::error(double(jump.air_time),
                          oracle::Surd{0, 2, 2 * oracle::exact(h) / oracle::exact(g)}) <=
            room * double(jump.air_time));
    if (h == S(0)) {
      const Interval pi = Interval::pi(256);
      const Interval period = Interval(Rational(2), 256) * pi *
                              sqrt(Interval(Rational(oracle::exact(m) / oracle::exact(k)), 256));
      REQUIRE(within(double(jump.contact_time), period, room));
      continue;
    }
    // By the power series: at the end of the contact the mat is flat, and the velocity is reversed.
    const double v = std::sqrt(2 * double(g) * double(h));
    const Motion out = motion(oracle::exact(k) / oracle::exact(m), 0, oracle::exact(g),
                              oracle::exact(v), oracle::exact(jump.contact_time));
    const double rate = std::sqrt(double(k) / double(m));
    REQUIRE(std::abs(middle(out.position)) <=
            8 * room * (v + double(g) / rate) * double(jump.contact_time));
    REQUIRE(std::abs(middle(out.speed) + v) <=
            8 * room * (v * rate + double(g)) * double(jump.contact_time));
  }
}

TEST_CASE("a stiff trampoline is a floor, and an invalid one is refused") {
  double before = 10;
  for (int power = 10; power <= 60; power += 10) {
    const auto jump =
        contact::trampoline_jump(contact::trampoline(1.0, std::ldexp(1.0, power), 8.0, 1.0));
    CHECK(jump.air_time == 1);
    CHECK(jump.contact_time < before / 16);
    before = jump.contact_time;
  }
  CHECK(!refusal([] { contact::trampoline(0.0, 1.0, 1.0, 1.0); }).empty());
  CHECK(!refusal([] { contact::trampoline(1.0, 0.0, 1.0, 1.0); }).empty());
  CHECK(!refusal([] { contact::trampoline(1.0, 1.0, 0.0, 1.0); }).empty());
  CHECK(refusal([] { contact::trampoline(1.0, 1.0, 1.0, -1.0); }).find("height = -1") == 0);
}

}  // namespace spring_impact_test
