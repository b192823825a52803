// momentum.hpp and momentum_balance.hpp against rational arithmetic on the stored numbers (class
// (a) of the oracle). u is the unit roundoff of the type. A bound in a comment of the reference is
// tested without an allowance.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impulse.hpp>
#include <contact/momentum.hpp>
#include <contact/momentum_balance.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::PointMass;
using contact::Vector3;
using generators::any_finite;
using generators::any_vector;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::impulses;
using rounding::error;
using rounding::eta;
using rounding::gamma;
using rounding::nearest;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

template <class S>
std::vector<PointMass<S>> bodies(Random& random, int low, int high) {
  std::vector<PointMass<S>> all;
  const int n = random.integer(1, 20);
  const auto number = [&] { return static_cast<S>(random.magnitude(low, high)); };
  for (int i = 0; i < n; ++i) {
    const S mass = std::abs(number());
    const Vector3<S> position{number(), number(), number()};
    const Vector3<S> velocity{number(), number(), number()};
    all.push_back(contact::point_mass(mass, position, velocity));
  }
  return all;
}

template <class S>
struct ExactSums {
  Rational mass = 0;
  Vector momentum = Vector::Zero();
  Vector scale = Vector::Zero();  // Σ m |v|
};

template <class S>
ExactSums<S> exact_sums(const std::vector<PointMass<S>>& all) {
  ExactSums<S> sums;
  for (const auto& body : all) {
    const Rational m = oracle::exact(body.mass);
    sums.mass += m;
    for (int k = 0; k < 3; ++k) {
      sums.momentum(k) += m * oracle::exact(body.velocity(k));
      sums.scale(k) += m * abs(oracle::exact(body.velocity(k)));
    }
  }
  return sums;
}

}  // namespace

TEMPLATE_TEST_CASE("momentum, its scale and the velocity of the centre agree with fractions", "",
                   float, double) {
  using S = TestType;
  Random random(1204);
  for (int i = 0; i < 2500; ++i) {
    const int range = i % 2 == 0 ? 3 : 25;
    auto all = bodies<S>(random, -range, range);
    if (random.chance(0.3)) {  // every body has an opposite: the total is zero
      for (std::size_t n = all.size(), k = 0; k < n; ++k) {
        all.push_back(all[k]);
        all.back().velocity = -all.back().velocity;
      }
    }
    const int n = static_cast<int>(all.size());
    const auto sums = exact_sums(all);
    const auto total = contact::total_momentum(all);
    const auto scale = contact::momentum_scale(all);
    const auto centre = contact::centre_velocity(all);
    REQUIRE(centre.has_value());
    REQUIRE(error(contact::total_mass(all), sums.mass) <= gamma<S>(n - 1) * sums.mass);
    for (int k = 0; k < 3; ++k) {
      const Rational cancelled = 3 * n * n * u<S>() * u<S>() * sums.scale(k);
      REQUIRE(error(total(k), sums.momentum(k)) <= u<S>() * abs(sums.momentum(k)) + cancelled);
      REQUIRE(error(scale(k), sums.scale(k)) <= gamma<S>(n) * sums.scale(k));
      const Rational mean = sums.momentum(k) / sums.mass;
      REQUIRE(error((*centre)(k), mean) <= (n + 2) * u<S>() * abs(mean) + cancelled / sums.mass);
    }
  }
}

TEST_CASE("totals and means are right for any bit patterns") {
  Random random(1205);
  const double big = std::numeric_limits<double>::max();
  for (int i = 0; i < 4000; ++i) {
    std::vector<PointMass<double>> all;
    for (int n = random.integer(1, 6); n > 0; --n) {
      double mass = std::abs(any_finite(random));
      if (mass == 0) mass = 1;
      Vector3<double> velocity = any_vector(random);
      if (random.chance(0.2)) velocity = {big, -big, 5e-324};
      all.push_back({mass, any_vector(random), velocity});
    }
    const int n = static_cast<int>(all.size());
    const auto sums = exact_sums(all);
    const auto total = contact::total_momentum(all);
    const auto centre = contact::centre_velocity(all);
    REQUIRE(contact::all_finite(*contact::centre_of_mass(all)));
    for (int k = 0; k < 3; ++k) {
      const Rational cancelled = 3 * n * n * u<double>() * u<double>() * sums.scale(k);
      REQUIRE_FALSE(std::isnan(total(k)));
      if (std::isfinite(total(k))) {
        REQUIRE(error(total(k), sums.momentum(k)) <=
                u<double>() * abs(sums.momentum(k)) + cancelled + eta<double>());
      } else {
        REQUIRE(std::isinf(oracle::nearest(sums.momentum(k))));
      }
      const Rational mean = sums.momentum(k) / sums.mass;
      REQUIRE(error((*centre)(k), mean) <=
              (n + 2) * u<double>() * abs(mean) + cancelled / sums.mass + eta<double>());
    }
  }
  CHECK_FALSE(contact::centre_velocity<double>({}).has_value());
  CHECK_FALSE(contact::centre_of_mass<double>({}).has_value());
  CHECK(contact::total_momentum<double>({}) == Vector3<double>(0, 0, 0));
}

TEST_CASE("the lecture's players: 90 kg at 6 m/s and 80 kg at -7 m/s") {
  const std::vector<PointMass<double>> players{{90, {0, 0, 0}, {6, 0, 0}},
                                               {80, {0, 0, 0}, {-7, 0, 0}}};
  CHECK(contact::momentum(players[0]) == Vector3<double>(540, 0, 0));
  CHECK(contact::total_momentum(players) == Vector3<double>(-20, 0, 0));
  CHECK(contact::momentum_scale(players) == Vector3<double>(1100, 0, 0));
  CHECK(contact::centre_velocity(players)->x() == oracle::nearest(Rational(-2) / 17));
}

TEST_CASE("no internal impulse changes the velocity of the centre of mass, in fractions") {
  Random random(1206);
  for (int i = 0; i < 300; ++i) {
    const auto fraction = [&] { return Rational(random.integer(-50, 50)) / random.integer(1, 9); };
    const auto vector = [&] { return Vector{fraction(), fraction(), fraction()}; };
    const Rational m1 = Rational(random.integer(1, 50)) / random.integer(1, 9);
    const Rational m2 = Rational(random.integer(1, 50)) / random.integer(1, 9);
    const Vector v1 = vector();
    const Vector v2 = vector();
    const Vector j = vector();
    const std::vector<PointMass<Rational>> before{{m1, Vector::Zero(), v1},
                                                  {m2, Vector::Zero(), v2}};
    const std::vector<PointMass<Rational>> after{
        {m1, Vector::Zero(), contact::velocity_after<Rational>(m1, v1, Vector(-j))},
        {m2, Vector::Zero(), contact::velocity_after<Rational>(m2, v2, j)}};
    REQUIRE(contact::total_momentum(before) == contact::total_momentum(after));
    REQUIRE(*contact::centre_velocity(before) == *contact::centre_velocity(after));
    REQUIRE(contact::impulse_of_change(m2, v2, after[1].velocity) == j);

    const auto apart = contact::push_off(m1, m2, v1, j);
    REQUIRE(Vector(apart.second - apart.first) == j);
    REQUIRE(Vector(apart.first * m1 + apart.second * m2) == Vector(v1 * Rational(m1 + m2)));
    REQUIRE(contact::impulse_of_change(m2, v1, apart.second) == apart.impulse);
    REQUIRE(contact::impulse_of_change(m1, v1, apart.first) == Vector(-apart.impulse));
  }
}

TEST_CASE("a push-off is accurate for masses of any ratio, and does not overflow") {
  Random random(1207);
  for (int i = 0; i < 3000; ++i) {
    const double m1 = std::abs(random.magnitude(-1000, 1023));
    const double m2 = std::abs(random.magnitude(-1000, 1023));
    const Vector3<double> v{random.magnitude(-5, 5), random.magnitude(-5, 5), 0};
    const Vector3<double> relative{random.magnitude(-5, 5), random.magnitude(-5, 5), 0};
    const auto got = contact::push_off(m1, m2, v, relative);
    const Rational whole = oracle::exact(m1) + oracle::exact(m2);
    for (int k = 0; k < 2; ++k) {
      const Rational first =
          oracle::exact(v(k)) - oracle::exact(relative(k)) * oracle::exact(m2) / whole;
      const Rational second =
          oracle::exact(v(k)) + oracle::exact(relative(k)) * oracle::exact(m1) / whole;
      const Rational room =
          4 * u<double>() * (abs(oracle::exact(v(k))) + abs(oracle::exact(relative(k))));
      REQUIRE(error(got.first(k), first) <= room);
      REQUIRE(error(got.second(k), second) <= room);
      REQUIRE_FALSE(std::isnan(got.impulse(k)));
    }
  }
}

namespace {

/// The velocities of two bodies after an elastic collision, in fractions.
template <class S>
std::array<Rational, 2> after_collision(const contact::MomentumBody<S>& a,
                                        const contact::MomentumBody<S>& b) {
  const Rational ma = oracle::exact(a.mass), mb = oracle::exact(b.mass);
  const Rational va = oracle::exact(a.velocity), vb = oracle::exact(b.velocity);
  return {((ma - mb) * va + 2 * mb * vb) / (ma + mb), ((mb - ma) * vb + 2 * ma * va) / (ma + mb)};
}

/// A bound on the error of m v of the first body in one collision by formulas: six roundings, of
/// which at most five affect each term.
template <class S>
double room_of_formula(const contact::MomentumBody<S>& a, const contact::MomentumBody<S>& b,
                       double roundoff) {
  const double ma = double(a.mass), mb = double(b.mass);
  return 5.1 * roundoff * ma *
         (std::abs(ma - mb) * std::abs(double(a.velocity)) +
          2 * mb * std::abs(double(b.velocity))) /
         (ma + mb);
}

template <class S>
void check_bookings(Random& random) {
  using contact::MomentumUpdate;
  const double roundoff = double(contact::tolerance::unit_roundoff<S>);
  const S unit = S(std::ldexp(1.0, sizeof(S) == sizeof(float) ? -14 : -40));
  constexpr std::size_t n = 16;
  std::vector<contact::MomentumBody<S>> first;
  for (std::size_t i = 0; i < n; ++i) {
    const S mass = S(random.uniform(0.5, 3));
    const S momentum = S(random.uniform(-8, 8));
    first.push_back(contact::momentum_body(mass, momentum, unit));
    REQUIRE(abs(oracle::exact(first[i].momentum) - oracle::exact(momentum)) <=
            oracle::exact(unit) / 2);
    REQUIRE(denominator(Rational(oracle::exact(first[i].momentum) / oracle::exact(unit))) == 1);
  }
  for (const MomentumUpdate update :
       {MomentumUpdate::formulas, MomentumUpdate::impulses, MomentumUpdate::grid}) {
    auto bodies = first;
    const auto total_of = [&] {
      Rational sum = 0;
      for (const auto& body : bodies) {
        sum += update == MomentumUpdate::grid
                   ? oracle::exact(body.momentum)
                   : oracle::exact(body.mass) * oracle::exact(body.velocity);
      }
      return sum;
    };
    const Rational before = total_of();
    double room = 0;  // bound on the sum of the rounding errors of all collisions
    for (int c = 0; c < generators::tried(40000); ++c) {
      const auto i = static_cast<std::size_t>(random.integer(0, int(n) - 1));
      const auto j = (i + static_cast<std::size_t>(random.integer(1, int(n) - 1))) % n;
      auto& a = bodies[i];
      auto& b = bodies[j];
      const auto was_a = a;
      const auto was_b = b;
      const double formula_a = room_of_formula(a, b, roundoff);
      const double formula_b = room_of_formula(b, a, roundoff);
      contact::collide_with_update(a, b, update, unit);
      // The quotient J / m and the sum are rounded, and |J| is no more than m|v| + m|v'|.
      const auto sum_room = [roundoff](const auto& was, const auto& is) {
        const double m = double(is.mass);
        return 1.1 * roundoff * m *
               (2 * std::abs(double(is.velocity)) + std::abs(double(was.velocity)));
      };
      if (update == MomentumUpdate::formulas) room += formula_a + formula_b;
      if (update == MomentumUpdate::impulses) room += sum_room(was_a, a) + sum_room(was_b, b);
      if (c >= generators::tried(2000)) continue;
      Rational change = 0, scale = 0;  // the bound in the comment
      for (const auto& [was, is] : {std::pair(was_a, a), std::pair(was_b, b)}) {
        const Rational m = oracle::exact(is.mass);
        change += update == MomentumUpdate::grid
                      ? oracle::exact(is.momentum) - oracle::exact(was.momentum)
                      : Rational(m * (oracle::exact(is.velocity) - oracle::exact(was.velocity)));
        scale += m * (abs(oracle::exact(was.velocity)) + abs(oracle::exact(is.velocity)));
      }
      REQUIRE(abs(change) <=
              (update == MomentumUpdate::grid ? Rational(0) : Rational(16 * u<S>() * scale)));
      // Each program computes the same exact velocities, with errors. An impulse has five
      // roundings, and its use two more; on a grid the impulse and the stored momentum each have an
      // error of half a unit in addition.
      const auto right = after_collision(was_a, was_b);
      const double impulse = std::abs(double(a.velocity) - double(was_a.velocity)) * double(a.mass);
      const double by_impulse =
          8 * roundoff * impulse + (update == MomentumUpdate::grid ? double(unit) : 0.0);
      const auto close = [&](const auto& body, const auto& was, const Rational& v, double formula) {
        const double m = double(body.mass);
        const double wide = update == MomentumUpdate::formulas
                                ? formula
                                : by_impulse + 4 * roundoff * m * std::abs(double(was.velocity));
        REQUIRE(abs(oracle::exact(body.velocity) - v) * oracle::exact(body.mass) <=
                oracle::exact(wide + 4 * roundoff * m * std::abs(double(body.velocity))));
      };
      close(a, was_a, right[0], formula_a);
      close(b, was_b, right[1], formula_b);
    }
    const Rational drift = total_of() - before;
    INFO("booking " << int(update) << ", drift " << oracle::nearest(drift) << ", room " << room);
    if (update == MomentumUpdate::grid) {
      CHECK(drift == 0);
    } else {
      CHECK(drift != 0);
      CHECK(abs(drift) <= oracle::exact(room));
    }
    CHECK(rounded<double>(contact::stored_momentum(bodies, update)) == oracle::nearest(total_of()));
  }
}

}  // namespace

TEST_CASE("over many collisions the momentum drifts no farther than the roundings allow") {
  Random random(1211);
  check_bookings<float>(random);
  check_bookings<double>(random);
}

TEST_CASE("a construction refuses bad input, naming the argument and the value") {
  const double inf = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  using V = Vector3<double>;
  const V zero(0, 0, 0);
  for (const double mass : {0.0, -0.0, -1.0, inf, -inf, not_a_number}) {
    const auto message = refusal([&] { contact::point_mass<double>(mass, zero, zero); });
    CHECK((contains(message, "mass = ") && contains(message, contact::number_text(mass))));
  }
  const auto place = refusal([&] { contact::point_mass<double>(1, {0, inf, 0}, zero); });
  CHECK((contains(place, "position") && contains(place, "inf")));
  const auto speed = refusal([&] { contact::point_mass<double>(1, zero, {not_a_number, 0, 0}); });
  CHECK((contains(speed, "velocity") && contains(speed, "nan")));
  const auto one = refusal([&] { contact::force_curve<double>({1}, {zero}); });
  CHECK((contains(one, "time") && contains(one, "1 samples")));
  const auto fewer = refusal([&] { contact::force_curve<double>({1, 2}, {zero}); });
  CHECK((contains(fewer, "force") && contains(fewer, "1 samples")));
  const auto back = refusal([&] { contact::force_curve<double>({1, 3, 3}, {zero, zero, zero}); });
  CHECK((contains(back, "time[2] = 3") && contains(back, "later")));
  const auto wild = refusal([&] { contact::force_curve<double>({1, 2}, {zero, {0, inf, 0}}); });
  CHECK((contains(wild, "force[1]") && contains(wild, "inf")));
  const auto never = refusal([&] {
    contact::force_curve<double>({1, not_a_number}, {zero, zero});
  });
  CHECK((contains(never, "time[1]") && contains(never, "nan")));
}
