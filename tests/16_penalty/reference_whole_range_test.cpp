// The bounds that the headers state, over the whole ranges that they state: by fractions, square
// roots of fractions and intervals (classes (a) to (c) of the oracle).
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/penalty_force.hpp>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <contact/tolerance.hpp>
#include <contact/trampoline.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace whole_range_test {
namespace {

using contact::PenaltyScheme;
using contact::SpringDamper;
using contact::Vector3;
using generators::Random;
using oracle::Interval;
using oracle::Rational;
using oracle::Surd;

constexpr double kUnit = 0x1p-53;

template <class S>
double last() {
  return double(contact::tolerance::unit_roundoff<S>);
}

/// Exponents of two of 1e±120 for double, of 1e±15 for float.
template <class S>
constexpr int kRange = sizeof(S) == sizeof(float) ? 49 : 398;

/// Stiffness and mass of any size in the range; c² too.
template <class S>
struct Wide {
  SpringDamper<S> spring;
  S mass;

  explicit Wide(Random& random)
      : spring{S(std::abs(random.magnitude(-kRange<S>, kRange<S>))),
               S(random.chance(0.2) ? 0
                                    : std::abs(random.magnitude(-kRange<S> / 2, kRange<S> / 2)))},
        mass(S(std::abs(random.magnitude(-kRange<S>, kRange<S>)))) {
    if (random.chance(0.5)) {  // near critical damping
      const double c = 2 * std::sqrt(double(spring.stiffness)) * std::sqrt(double(mass));
      const S near = S(c * random.uniform(0.5, 1.5));
      const double square = double(near) * double(near);
      if (square > std::ldexp(1.0, -kRange<S>) && square < std::ldexp(1.0, kRange<S>))
        spring.damping = near;
    }
  }
};

double middle(const Interval& x) { return oracle::nearest(Rational((x.low() + x.high()) / 2)); }

bool within(double got, const Interval& value, double room) {
  if (!std::isfinite(got)) return false;
  const Interval off = (Interval(oracle::exact(got), value.bits()) - value) / value;
  return off.high() <= oracle::exact(room) && off.low() >= -oracle::exact(room);
}

/// Whether a result is a normal number of its type, so that a relative error is meant.
template <class S>
bool is_normal(const Interval& value) {
  return value.low() > 2 * oracle::exact(std::numeric_limits<S>::min()) &&
         value.high() < oracle::exact(std::numeric_limits<S>::max()) / 2;
}

TEMPLATE_TEST_CASE("step limits over the whole stated range", "", float, double) {
  using S = TestType;
  Random random(1711);
  const std::array<PenaltyScheme, 4> schemes{
      PenaltyScheme::explicit_euler, PenaltyScheme::semi_implicit_euler,
      PenaltyScheme::implicit_damper, PenaltyScheme::position_verlet};
  for (int i = 0; i < generators::tried(1500); ++i) {
    const Wide<S> wide(random);
    const Rational k = oracle::exact(wide.spring.stiffness);
    const Rational c = oracle::exact(wide.spring.damping);
    const Rational m = oracle::exact(wide.mass);
    const Rational minus = c * c - 4 * k * m;
    const Rational plus = c * c + 4 * k * m;
    const Surd semi{-c / k, 1 / k, plus};
    const std::array<Surd, 4> right{minus > 0 ? Surd{c / k, -1 / k, minus} : Surd{c / k, 0, 0},
                                    semi, Surd{c / k, 1 / k, plus}, semi};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const double limit = double(contact::step_limit(schemes[s], wide.spring, wide.mass));
      INFO(wide.spring.stiffness << " " << wide.spring.damping << " " << wide.mass << " " << s);
      REQUIRE(oracle::error(limit, right[s]) <= 8 * last<S>() * oracle::nearest(right[s]));
    }
  }
}

TEMPLATE_TEST_CASE("limits by bisection over the whole stated range", "", float, double) {
  using S = TestType;
  Random random(1712);
  const S u = contact::tolerance::unit_roundoff<S>;
  for (int i = 0; i < generators::tried(200); ++i) {
    const Wide<S> wide(random);
    for (const PenaltyScheme scheme :
         {PenaltyScheme::velocity_verlet, PenaltyScheme::runge_kutta_4}) {
      const S limit = contact::step_limit(scheme, wide.spring, wide.mass);
      INFO(wide.spring.stiffness << " " << wide.spring.damping << " " << wide.mass);
      const auto grows = [&](const S& h) {
        return contact::step_behaviour(scheme, wide.spring, wide.mass, h) ==
               contact::StepBehaviour::grows;
      };
      REQUIRE(grows(limit * (S(1) + S(16) * u)));
      REQUIRE(!grows(limit * (S(1) - S(16) * u)));
    }
  }
}

TEMPLATE_TEST_CASE("an impact over the whole stated range", "", float, double) {
  using S = TestType;
  Random random(1713);
  constexpr unsigned bits = 2600;
  const auto lift = [](const Rational& x) { return Interval(x, bits); };
  int normal = 0;
  for (int i = 0; i < generators::tried(300); ++i) {
    const Wide<S> wide(random);
    const S v = S(std::abs(random.magnitude(-20, 20)));
    const Rational k = oracle::exact(wide.spring.stiffness);
    const Rational c = oracle::exact(wide.spring.damping);
    const Rational m = oracle::exact(wide.mass);
    const Rational rest = 4 * k * m - c * c;
    if (rest == 0 || c == 0) continue;
    const Interval ratio = lift(c) / sqrt(lift(Rational(4 * k * m)));
    const Interval root = sqrt(lift(Rational(abs(rest) / (4 * k * m))));
    const Interval arc = rest > 0 ? acos(ratio) / root : log(ratio + root) / root;
    const Interval rate = sqrt(lift(Rational(k / m)));
    const Interval y = lift(2) * ratio * arc;
    const double room = (100 + 100 * middle(y)) * kUnit + 1.001 * last<S>();
    const auto free = contact::spring_impact(wide.spring, wide.mass, v);
    const auto fits = [&](const S& got, const Interval& right) {
      if (!is_normal<S>(right)) return true;
      ++normal;
      return within(double(got), right, room);
    };
    INFO(wide.spring.stiffness << " " << wide.spring.damping << " " << wide.mass << " " << v);
    REQUIRE(fits(free.restitution, exp(-y)));
    REQUIRE(fits(free.duration, lift(2) * arc / rate));
    REQUIRE(fits(free.time_of_depth, arc / rate));
    const Interval size = lift(oracle::exact(v)) / rate;
    REQUIRE(fits(free.max_depth, size * exp(-(y / lift(2)))));
    REQUIRE(fits(free.left_overlap, size * lift(2) * ratio * exp(-y)));
    const Interval force = ratio.low() >= Rational(1, 2)
                               ? lift(c * oracle::exact(v))
                               : lift(m * oracle::exact(v)) * rate *
                                     exp(-(ratio * (lift(3) * arc - Interval::pi(bits) / root)));
    if (ratio.low() >= Rational(1, 2) || ratio.high() < Rational(1, 2)) {
      REQUIRE(fits(free.max_force, force));
    }
    const auto glued = contact::spring_impact(wide.spring, wide.mass, v,
                                              contact::ContactRelease::at_zero_penetration);
    if (rest < 0) continue;
    REQUIRE(fits(glued.duration, Interval::pi(bits) / (rate * root)));
  }
  CHECK(normal > generators::tried(800));
}

TEMPLATE_TEST_CASE("damping ratio and frequency of numbers of every size", "", float, double) {
  using S = TestType;
  Random random(1714);
  int tested = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    const S k = std::abs(generators::any_finite<S>(random));
    const S m = std::abs(generators::any_finite<S>(random));
    const S c = std::abs(generators::any_finite<S>(random));
    if (k == S(0) || m == S(0) || !std::isnormal(c)) continue;
    const Rational product = oracle::exact(k) * oracle::exact(m);
    const Surd ratio{0, oracle::exact(c) / (2 * product), product};
    const Surd rate{0, 1 / oracle::exact(m), product};
    INFO(k << " " << c << " " << m);
    REQUIRE(oracle::error(double(contact::natural_frequency(SpringDamper<S>{k, c}, m)), rate) <=
            3.01 * last<S>() * oracle::nearest(rate));
    const double exact = oracle::nearest(ratio);
    const S got = contact::damping_ratio(SpringDamper<S>{k, c}, m);
    if (exact < double(std::numeric_limits<S>::min()) * 2) {
      REQUIRE(got <= std::numeric_limits<S>::min() * S(3));
    } else if (exact < double(std::numeric_limits<S>::max()) / 4) {
      ++tested;
      REQUIRE(oracle::error(double(got), ratio) <= 5.01 * last<S>() * exact);
    } else {
      REQUIRE(got >= std::numeric_limits<S>::max() / S(8));
    }
  }
  CHECK(tested > generators::tried(2000));
}

template <class S>
Vector3<S> any_direction(Random& random) {
  const Vector3<double> v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
  return Vector3<S>((v / v.norm()).template cast<S>());
}

TEMPLATE_TEST_CASE("whether a ball touches a half-space is decided exactly, at every size", "",
                   float, double) {
  using S = TestType;
  Random random(1715);
  std::array<int, 3> signs{};
  int lifted = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    const S scale = S(std::ldexp(1.0, random.integer(-60, 60)));
    const Vector3<double> centre{random.uniform(-4, 4), random.uniform(-4, 4),
                                 random.uniform(-4, 4)};
    contact::Sphere<S> ball{Vector3<S>(centre.cast<S>()) * scale, S(0)};
    contact::Plane<S> plane{any_direction<S>(random), S(random.uniform(-4, 4)) * scale};
    if (i % 3 == 0) {  // on a grid, where touching is common
      ball.centre =
          Vector3<S>{S(random.integer(-9, 9)), S(random.integer(-9, 9)), S(random.integer(-9, 9))} *
          scale;
      plane = {Vector3<S>(S(0), S(0), S(1)), S(random.integer(-9, 9)) * scale};
    }
    ball.radius = std::max(S(0), S(plane.normal.dot(ball.centre) - plane.offset));
    if (i % 2 == 0) ball.radius = std::nextafter(ball.radius, S(random.chance(0.5) ? 0 : 1e30));
    const Rational depth =
        oracle::exact(ball.radius) -
        (oracle::exact(plane.normal).dot(oracle::exact(ball.centre)) - oracle::exact(plane.offset));
    const int right = oracle::sign(depth);
    REQUIRE(contact::overlap_sign(ball, plane) == right);
    REQUIRE(contact::overlap_sign(oracle::exact(ball), oracle::exact(plane)) == right);
    const auto force = contact::half_space_force<S>({ball, Vector3<S>::Zero()}, plane,
                                                    SpringDamper<S>{S(1), S(0)});
    REQUIRE(force.touching == (right >= 0));
    REQUIRE(force.penetration >= S(0));
    ++signs[std::size_t(right + 1)];
    const S rounded = ball.radius - (plane.normal.dot(ball.centre) - plane.offset);
    lifted += (rounded < S(0)) != (right < 0) ? 1 : 0;
  }
  for (const int count : signs) CHECK(count > generators::tried(300));
  CHECK(lifted > generators::tried(100));  // where the rounded penetration has the wrong sign
}

TEMPLATE_TEST_CASE("a number that is not finite gives no contact", "", float, double) {
  using S = TestType;
  const S inf = std::numeric_limits<S>::infinity();
  const S nan = std::numeric_limits<S>::quiet_NaN();
  const contact::Plane<S> floor{Vector3<S>(S(0), S(0), S(1)), S(0)};
  const SpringDamper<S> spring{S(1), S(1)};
  const auto at = [](const S& height, const S& radius) {
    return contact::PenaltyBall<S>{{Vector3<S>(S(0), S(0), height), radius}, Vector3<S>::Zero()};
  };
  const auto still = at(S(0), S(1));
  for (const S bad : {inf, S(-inf), nan}) {
    CHECK(!contact::half_space_force(at(bad, S(1)), floor, spring).touching);
    CHECK(!contact::half_space_force(at(S(0), bad), floor, spring).touching);
    CHECK(!contact::ball_ball_force(at(bad, S(1)), still, spring).touching);
    CHECK(!contact::ball_ball_force(still, at(S(0), bad), spring).touching);
  }
  CHECK(contact::contact_force(spring, nan, S(1)) == S(0));
}

TEMPLATE_TEST_CASE("a jump on a trampoline with numbers of every size", "", float, double) {
  using S = TestType;
  Random random(1716);
  const int range = sizeof(S) == sizeof(float) ? 12 : 100;
  for (int i = 0; i < generators::tried(600); ++i) {
    const S m = S(std::abs(random.magnitude(-range, range)));
    const S k = S(std::abs(random.magnitude(-range, range)));
    const S g = S(std::abs(random.magnitude(-range, range)));
    const S h = S(std::abs(random.magnitude(-range, range)));
    const auto jump = contact::trampoline_jump(contact::trampoline(m, k, g, h));
    const Rational sag = oracle::exact(m) * oracle::exact(g) / oracle::exact(k);
    const Surd depth{sag, 1, sag * sag + 2 * sag * oracle::exact(h)};
    const double room = 40 * last<S>();
    INFO(m << " " << k << " " << g << " " << h);
    REQUIRE(oracle::error(double(jump.max_depth), depth) <= room * oracle::nearest(depth));
    REQUIRE(oracle::error(double(jump.sag), Surd{sag, 0, 0}) <= room * oracle::nearest(sag));
    // 2 (π − β) / ω₀ with tan² β = 2 H / s.
    constexpr unsigned bits = 1024;
    const Interval tangent = sqrt(Interval(Rational(2 * oracle::exact(h) / sag), bits));
    const Interval turned = Interval::pi(bits) - atan(tangent);
    const Interval rate = sqrt(Interval(Rational(oracle::exact(k) / oracle::exact(m)), bits));
    REQUIRE(within(double(jump.contact_time), Interval(Rational(2), bits) * turned / rate, room));
  }
}

}  // namespace
}  // namespace whole_range_test
