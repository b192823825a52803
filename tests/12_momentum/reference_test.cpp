// Every reference function of the chapter against rational arithmetic on the stored numbers (class
// (a) of the oracle), the rocket against intervals (class (c)). u is the unit roundoff of the type.
// A bound that a comment of the reference gives is tested as it stands, without an allowance.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impulse.hpp>
#include <contact/impulse_sum.hpp>
#include <contact/momentum.hpp>
#include <contact/momentum_balance.hpp>
#include <contact/variable_mass.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::ForceCurve;
using contact::PointMass;
using contact::Vector3;
using generators::any_finite;
using generators::any_vector;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using rounding::error;
using rounding::eta;
using rounding::gamma;
using rounding::nearest;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

template <class S>
Rational sum_of(const std::vector<S>& terms) {
  Rational sum = 0;
  for (const S x : terms) sum += oracle::exact(x);
  return sum;
}
template <class S>
Rational size_of(const std::vector<S>& terms) {
  Rational sum = 0;
  for (const S x : terms) sum += abs(oracle::exact(x));
  return sum;
}

enum class Push { one_way, both_ways, zero_total, spread };

/// Impulses: all one way; to and fro; to and fro with the sum of all before as the last; from 1 to
/// 10^16 in size, and what is large cancels.
template <class S>
std::vector<S> impulses(Random& random, Push push) {
  const int n = random.integer(1, 60);
  std::vector<S> terms;
  for (int i = 0; i < n; ++i) {
    double x = random.uniform(0.001, 1);
    if (push != Push::one_way) x = random.uniform(-1, 1);
    if (push == Push::spread) x = random.magnitude(0, 53);
    terms.push_back(static_cast<S>(x));
  }
  if (push == Push::zero_total) {
    for (int i = 0; i < n; ++i) terms.push_back(-terms[static_cast<std::size_t>(i)]);
  }
  if (push == Push::spread) {
    for (int i = 0; i < n; ++i) {
      const S x = terms[static_cast<std::size_t>(i)];
      if (std::abs(x) > S(1000)) terms.push_back(-x);
    }
  }
  for (std::size_t i = terms.size(); i > 1; --i) {
    std::swap(terms[i - 1], terms[static_cast<std::size_t>(random.integer(0, int(i) - 1))]);
  }
  return terms;
}

constexpr std::array<Push, 4> all_pushes{Push::one_way, Push::both_ways, Push::zero_total,
                                         Push::spread};

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

TEMPLATE_TEST_CASE("every way of adding impulses is as near as its comment says", "", float,
                   double) {
  using S = TestType;
  Random random(1201);
  int zero_totals = 0;
  int cancelled = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto terms = impulses<S>(random, all_pushes[static_cast<std::size_t>(i) % 4]);
    const int n = static_cast<int>(terms.size());
    const Rational right = sum_of(terms);
    const Rational size = size_of(terms);
    const int halvings = static_cast<int>(std::bit_width(static_cast<unsigned>(n - 1)));
    REQUIRE(error(contact::total_in_order(terms), right) <= gamma<S>(n - 1) * size);
    REQUIRE(error(contact::total_pairwise(terms), right) <= gamma<S>(halvings + 4) * size);
    REQUIRE(error(contact::total_compensated(terms), right) <=
            u<S>() * abs(right) + gamma<S>(n - 1) * gamma<S>(n - 1) * size);
    REQUIRE(error(contact::total_kahan(terms), right) <=
            (2 * u<S>() + 8 * n * u<S>() * u<S>()) * size);
    REQUIRE(contact::total_exactly(terms) == nearest<S>(right));
    const S total = contact::total_impulse(terms);
    REQUIRE(error(total, right) <= 3 * u<S>() * abs(right));
    REQUIRE((total == S(0)) == (right == 0));
    zero_totals += right == 0;
    cancelled += abs(right) < size * u<S>();
  }
  CHECK(zero_totals > 500);
  CHECK(cancelled > 900);
}

TEST_CASE("sums of rationals are exact in every order") {
  Random random(1202);
  for (int i = 0; i < 200; ++i) {
    std::vector<Rational> terms;
    for (const double x : impulses<double>(random, Push::spread)) terms.push_back(oracle::exact(x));
    Rational right = 0;
    for (const Rational& x : terms) right += x;
    REQUIRE(contact::total_in_order(terms) == right);
    REQUIRE(contact::total_pairwise(terms) == right);
  }
}

TEST_CASE("a thousand tenths between a large impulse and its opposite, as the lesson tells it") {
  const auto tenths = []<class S>(S, int power) {
    std::vector<S> all(1002, S(0.1F));
    all.front() = std::ldexp(S(1), power);
    all.back() = -all.front();
    return all;
  };
  CHECK(contact::total_in_order(tenths(0.0F, 21)) == 0);
  CHECK(contact::total_in_order(tenths(0.0F, 20)) == 125);
  CHECK(contact::total_in_order(tenths(0.0F, 18)) == 93.75F);
  CHECK(contact::total_in_order(tenths(0.0, 50)) == 0);
  CHECK(contact::total_in_order(tenths(0.0, 49)) == 125);
  CHECK(contact::total_pairwise(tenths(0.0F, 29)) > 0);
  CHECK(contact::total_pairwise(tenths(0.0F, 30)) == 0);
  for (int power = 0; power <= 52; ++power) {
    CAPTURE(power);
    CHECK(std::abs(contact::total_compensated(tenths(0.0F, power)) - 100) < 0.002F);
    // What Kahan's sum hands to the last term is rounded to its digits, which are those just below
    // 2^power: from 2^27 on they are multiples of 8, and 100 is none.
    if (power < 20) continue;
    const float kahan = contact::total_kahan(tenths(0.0F, power));
    CHECK(std::fmod(kahan, std::ldexp(1.0F, power - 24)) == 0);
    CHECK((kahan == 100) == (power < 27));
  }
  CHECK(contact::total_kahan(tenths(0.0F, 32)) == 0);
}

TEST_CASE("a sum that overflows only on the way is finite, and none is ever NaN") {
  const double big = std::numeric_limits<double>::max();
  const std::vector<double> there_and_back{big, big, 3.0, -big, -big};
  CHECK(contact::total_exactly(there_and_back) == 3.0);
  CHECK(contact::total_impulse(there_and_back) == 3.0);
  for (const auto total : {contact::total_in_order<double>, contact::total_pairwise<double>,
                           contact::total_compensated<double>, contact::total_kahan<double>}) {
    CHECK(std::isfinite(total(there_and_back)));
    CHECK(std::abs(total({big, big / 2, -big}) - big / 2) <= 1e-15 * big);
    CHECK(total({big, big}) == std::numeric_limits<double>::infinity());
    CHECK(total({}) == 0.0);
  }
  CHECK(contact::total_exactly<double>({}) == 0.0);
  CHECK(contact::total_impulse<double>({}) == 0.0);
  Random random(1203);
  for (int i = 0; i < 3000; ++i) {
    std::vector<double> terms;
    for (int n = random.integer(0, 12); n > 0; --n) {
      terms.push_back(random.chance(0.5) ? any_finite(random) : random.magnitude(1015, 1023));
    }
    REQUIRE_FALSE(std::isnan(contact::total_in_order(terms)));
    REQUIRE_FALSE(std::isnan(contact::total_pairwise(terms)));
    REQUIRE_FALSE(std::isnan(contact::total_compensated(terms)));
    REQUIRE(contact::total_exactly(terms) == oracle::nearest(sum_of(terms)));
    const double total = contact::total_impulse(terms);
    REQUIRE_FALSE(std::isnan(total));
    if (std::isfinite(total)) {
      REQUIRE(error(total, sum_of(terms)) <= 3 * u<double>() * abs(sum_of(terms)) + eta<double>());
    }
  }
}

TEMPLATE_TEST_CASE("momentum, its scale and the centre's velocity agree with fractions", "", float,
                   double) {
  using S = TestType;
  Random random(1204);
  for (int i = 0; i < 2500; ++i) {
    const int range = i % 2 == 0 ? 3 : 25;
    auto all = bodies<S>(random, -range, range);
    if (random.chance(0.3)) {  // everything comes back the other way: the total is zero
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

TEST_CASE("no push between two bodies moves their centre of mass, in fractions") {
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

TEMPLATE_TEST_CASE("the impulse of a curve is the area under it", "", float, double) {
  using S = TestType;
  Random random(1208);
  for (int i = 0; i < 2500; ++i) {
    std::vector<S> time{static_cast<S>(random.uniform(-1, 1))};
    std::vector<Vector3<S>> force;
    const int n = random.integer(2, 40);
    while (static_cast<int>(time.size()) < n) {
      const S later = time.back() + static_cast<S>(random.uniform(0.001, 0.1));
      time.push_back(later);
    }
    for (int k = 0; k < n; ++k) {
      force.push_back(generators::rounded<S>(Vector3<double>{
          random.uniform(-900, 900), random.magnitude(-10, 10), random.uniform(0, 1)}));
    }
    const ForceCurve<S> curve = contact::force_curve(time, force);
    const auto fast = contact::impulse(curve);
    const auto once = contact::impulse_exactly(curve);
    const auto mean = contact::average_force(curve);
    const Rational duration = oracle::exact(time.back()) - oracle::exact(time.front());
    const Rational many = gamma<S>(n - 2) * gamma<S>(n - 2);  // n − 1 trapezoids
    for (int k = 0; k < 3; ++k) {
      Rational area = 0;
      Rational size = 0;
      for (std::size_t p = 0; p + 1 < time.size(); ++p) {
        const Rational piece = (oracle::exact(time[p + 1]) - oracle::exact(time[p])) *
                               (oracle::exact(force[p](k)) + oracle::exact(force[p + 1](k))) / 2;
        area += piece;
        size += abs(piece);
      }
      REQUIRE(error(fast(k), area) <= (5 * u<S>() + many) * size);
      REQUIRE(once(k) == nearest<S>(area));
      REQUIRE(error(mean(k), area / duration) <= (8 * u<S>() + many) * size / duration);
    }
    CHECK(contact::impulse_until(curve, time.front()) == Vector3<S>::Zero());
    CHECK(contact::impulse_until(curve, time.back()) == fast);
  }
}

TEST_CASE("a curve of very many samples is off by more than a few roundings, and by what is said") {
  const int pieces = 200000;
  std::vector<float> time;
  for (int i = 0; i <= pieces; ++i) time.push_back(static_cast<float>(i));
  const std::vector<Vector3<float>> force(time.size(), Vector3<float>(0.1f, 0, 0));
  const float got = contact::impulse(contact::force_curve(time, force)).x();
  const Rational right = pieces * oracle::exact(0.1f);
  CHECK(error(got, right) > 5 * u<float>() * right);
  CHECK(error(got, right) <=
        (5 * u<float>() + gamma<float>(pieces - 1) * gamma<float>(pieces - 1)) * right);
}

TEST_CASE("the impulse so far grows with the area so far") {
  // A triangle of 6 ms and 4000 N: 12 N·s, of which a quarter by 3/√2 ms.
  const auto curve =
      contact::force_curve<double>({0, 0.003, 0.006}, {{0, 0, 0}, {4000, 0, 0}, {0, 0, 0}});
  CHECK(std::abs(contact::impulse(curve).x() - 12) < 1e-14);
  CHECK(std::abs(contact::average_force(curve).x() - 2000) < 1e-11);
  CHECK(std::abs(contact::impulse_until(curve, 0.003).x() - 6) < 1e-14);
  CHECK(std::abs(contact::impulse_until(curve, 0.003 / std::sqrt(2.0)).x() - 3) < 1e-13);
  CHECK(contact::impulse_until(curve, -1.0).x() == 0);
  CHECK(contact::impulse_until(curve, 9.0) == contact::impulse(curve));
}

TEST_CASE("impulse and average force are finite where only a step on the way overflows") {
  const double big = std::numeric_limits<double>::max();
  const auto wide = contact::force_curve<double>({-big, big}, {{1, 2, 0}, {1, -2, 0}});
  CHECK(contact::average_force(wide) == Vector3<double>(1, 0, 0));
  const auto strong = contact::force_curve<double>({0, 0.25}, {{big, 0, 0}, {big, -big, 0}});
  CHECK(contact::impulse(strong).x() == big / 4);
  CHECK(contact::average_force(strong).x() == big);
  CHECK(contact::average_force(strong).y() == -big / 2);
}

TEST_CASE("matter that joins or leaves takes its own momentum with it") {
  Random random(1209);
  for (int i = 0; i < 300; ++i) {
    const auto fraction = [&] { return Rational(random.integer(-50, 50)) / random.integer(1, 9); };
    const Rational m = Rational(random.integer(1, 50)) / random.integer(1, 9);
    const Rational change = fraction();
    const Vector v{fraction(), fraction(), fraction()};
    const Vector w{fraction(), fraction(), fraction()};
    const auto after = contact::velocity_after_exchange(m, v, change, w);
    REQUIRE(after.has_value() == (m + change > 0));
    if (after) REQUIRE(Vector(*after * Rational(m + change)) == Vector(v * m + w * change));
  }
  const Vector3<double> v(3, 0, 0);
  // Sand runs out of a wagon: it leaves with the wagon's velocity, and nothing happens.
  CHECK(*contact::velocity_after_exchange(5000.0, v, -2000.0, v) == v);
  CHECK(contact::acceleration_with_exchange<double>(5000, {0, 0, 0}, {0, 0, 0}, -100) ==
        Vector3<double>(0, 0, 0));
  // Rain falls into it: it must be brought to the wagon's speed.
  const auto wet = contact::velocity_after_exchange<double>(5000, v, 1000, {0, 0, 0});
  CHECK(wet->x() == 2.5);
  CHECK(contact::acceleration_with_exchange<double>(5000, {0, 0, 0}, -v, 100).x() == -0.06);
  CHECK_FALSE(contact::velocity_after_exchange<double>(5, v, -5, {0, 0, 0}).has_value());
  const double big = std::numeric_limits<double>::max();
  CHECK(contact::velocity_after_exchange<double>(3, {big, 1, 0}, 1, {-big, 1, 0})->x() == big / 2);
  CHECK(contact::velocity_after_exchange<double>(big, v, big, {1, 0, 0})->x() == 2);
  for (int i = 0; i < 3000; ++i) {
    const double m = std::abs(any_finite(random));
    const double change = random.chance(0.3) ? -m * random.uniform() : any_finite(random);
    const Vector3<double> before = any_vector(random);
    const auto after = contact::velocity_after_exchange(m, before, change, any_vector(random));
    if (after) REQUIRE_FALSE(after->hasNaN());
  }
}

TEST_CASE("a rocket that throws its mass away grain by grain gains u ln(m0 / m1)") {
  Random random(1210);
  for (int i = 0; i < 400; ++i) {
    const double before = random.uniform(1, 100);
    double after = before * random.uniform(0.01, 1);
    if (random.chance(0.3)) after = before - std::ldexp(before, -random.integer(20, 52));
    const double exhaust = random.uniform(1, 5000);
    const auto right = oracle::nearest_value([&](unsigned bits) {
      const Rational ratio = oracle::exact(before) / oracle::exact(after);
      return oracle::Interval(oracle::exact(exhaust), bits) * log(oracle::Interval(ratio, bits));
    });
    REQUIRE(right.has_value());
    const double got = contact::rocket_speed_gain(exhaust, before, after);
    // Difference, quotient and product round once each, the logarithm by an ulp; its own slope
    // never makes a relative error larger here.
    REQUIRE(std::abs(got - *right) <= 8 * 0x1p-53 * std::abs(*right));
  }
  // Many small throws come near it from below, and their shortfall halves with their size.
  double shortfall = 0;
  for (const int throws : {100, 200}) {
    double mass = 10;
    Vector3<double> v(0, 0, 0);
    for (int k = 0; k < throws; ++k) {
      const double grain = 5.0 / throws;
      const auto apart = contact::push_off<double>(mass - grain, grain, v, {-1000, 0, 0});
      v = apart.first;
      mass -= grain;
    }
    const double missing = contact::rocket_speed_gain(1000.0, 10.0, 5.0) - v.x();
    CHECK(missing > 0);
    if (shortfall > 0) CHECK(std::abs(shortfall / missing - 2) < 0.02);
    shortfall = missing;
  }
}

TEST_CASE("a steady stream moves a body by the logarithm, and by its momentum") {
  // The textbook's integrals, which divide by the rate, by intervals; the numbers are whole
  // sixteenths, so that the mass that is left is exact.
  Random random(1212);
  const auto some = [&](double size) { return std::round(random.uniform(-size, size) * 16) / 16; };
  for (int i = 0; i < 2000; ++i) {
    const double mass = 8 + std::abs(some(100));
    const double time = 1 + std::abs(some(8));
    double rate = random.chance(0.5) ? some(40) : std::ldexp(some(4), -random.integer(4, 30));
    if (rate == 0) rate = 1;
    const double v0 = some(10);
    const double force = some(50);
    const double u = some(20);
    if (!(mass + rate * time > 0.125)) {
      REQUIRE((mass + rate * time > 0) ==
              contact::after_stream_from_body<double>(mass, {v0, 0, 0}, {force, 0, 0}, {u, 0, 0},
                                                      rate, time)
                  .has_value());
      continue;
    }
    const Rational m0 = oracle::exact(mass);
    const Rational r = oracle::exact(rate);
    const Rational t = oracle::exact(time);
    const Rational m = m0 + r * t;
    const Rational f = oracle::exact(force);
    const Rational v = oracle::exact(v0);
    const Rational w = oracle::exact(u);
    const auto value = [&](const Rational& even, const Rational& logs) {
      return *oracle::nearest_value([&](unsigned bits) {
        return oracle::Interval(even, bits) +
               oracle::Interval(logs, bits) * log(oracle::Interval(Rational(m0 / m), bits));
      });
    };
    const Rational push = f + w * r;
    const auto seen = contact::after_stream_from_body<double>(mass, {v0, 0, 0}, {force, 0, 0},
                                                              {u, 0, 0}, rate, time);
    REQUIRE(seen.has_value());
    const double unit = 0x1p-53;
    const double forces = std::abs(force) + std::abs(u * rate);
    const double gain = value(0, Rational(-1 / r));
    const double far = value(Rational((m0 - m) / (r * r)), Rational(-m / (r * r)));
    REQUIRE(std::abs(seen->velocity.x() - value(v, Rational(-push / r))) <=
            16 * unit * (std::abs(v0) + forces * gain));
    REQUIRE(std::abs(seen->way.x() - value(Rational(v * t + push * (m0 - m) / (r * r)),
                                           Rational(-push * m / (r * r)))) <=
            64 * unit * (std::abs(v0) * time + forces * far));
    // Nothing is lost between the body and the matter.
    const double size = (mass + std::abs(rate) * time) *
                        (std::abs(v0) + std::abs(u) + forces * (gain + far / time));
    REQUIRE(std::abs(seen->mass * seen->velocity.x() + seen->carried_off.x() -
                     (mass * v0 + force * time)) <= 256 * unit * size);

    const auto rain = contact::after_stream_over_ground<double>(mass, {v0, 0, 0}, {force, 0, 0},
                                                                {u, 0, 0}, rate, time);
    REQUIRE(rain.has_value());
    const double all = std::abs(force) + (std::abs(v0) + std::abs(u)) * std::abs(rate);
    REQUIRE(std::abs(rain->velocity.x() - oracle::nearest(Rational((m0 * v + push * t) / m))) <=
            8 * unit * (std::abs(v0) + all * time / seen->mass));
    const double wide = value(Rational(t / r), Rational(m0 / (r * r)));
    REQUIRE(std::abs(rain->way.x() -
                     value(Rational(push / r * t), Rational(-(v - push / r) * m0 / r))) <=
            64 * unit * (std::abs(v0) * time + all * wide));
    REQUIRE(rain->carried_off.x() == -u * (rate * time));
  }
  // Rain into a wagon, sand that runs out of it, and a push without any matter.
  const auto wet =
      contact::after_stream_over_ground<double>(4000, {3, 0, 0}, {0, 0, 0}, {0, 0, 0}, 200, 10);
  CHECK(wet->mass == 6000);
  CHECK(wet->velocity.x() == 2);
  const auto leaks =
      contact::after_stream_from_body<double>(4000, {3, 0, 0}, {0, 0, 0}, {0, 0, 0}, -200, 6);
  CHECK(leaks->velocity == Vector3<double>(3, 0, 0));
  CHECK(leaks->way == Vector3<double>(18, 0, 0));
  CHECK(leaks->carried_off == Vector3<double>(3600, 0, 0));
  const auto pushed =
      contact::after_stream_from_body<double>(4, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}, 0, 2);
  CHECK(pushed->velocity.x() == 4);
  CHECK(pushed->way.x() == 7);
  CHECK(pushed->carried_off.x() == 0);
  // A rocket, by the function for nothing but it, and by a thousand throws.
  const auto rocket =
      contact::after_stream_from_body<double>(10, {0, 0, 0}, {0, 0, 0}, {-1000, 0, 0}, -1, 5);
  CHECK(std::abs(rocket->velocity.x() - contact::rocket_speed_gain(1000.0, 10.0, 5.0)) < 1e-12);
  CHECK_FALSE(contact::after_stream_over_ground<double>(5, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, -1, 5)
                  .has_value());
  double mass = 10;
  Vector3<double> v(0, 0, 0);
  double way = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto after = contact::velocity_after_exchange<double>(
        mass, v, -0.005, Vector3<double>(v + Vector3<double>(-1000, 0, 0)));
    way += (v.x() + after->x()) / 2 * 0.005;
    v = *after;
    mass -= 0.005;
  }
  CHECK(std::abs(rocket->velocity.x() / v.x() - 1) < 1e-3);
  CHECK(std::abs(rocket->way.x() / way - 1) < 1e-3);
}

namespace {

/// The velocities of two bodies after an elastic collision, in fractions.
template <class S>
std::array<Rational, 2> after_collision(const contact::BookedBody<S>& a,
                                        const contact::BookedBody<S>& b) {
  const Rational ma = oracle::exact(a.mass), mb = oracle::exact(b.mass);
  const Rational va = oracle::exact(a.velocity), vb = oracle::exact(b.velocity);
  return {((ma - mb) * va + 2 * mb * vb) / (ma + mb), ((mb - ma) * vb + 2 * ma * va) / (ma + mb)};
}

/// What the roundings of one collision by formulas may put on m v of the first body: six of them,
/// of which five meet each term at most.
template <class S>
double room_of_formula(const contact::BookedBody<S>& a, const contact::BookedBody<S>& b,
                       double roundoff) {
  const double ma = double(a.mass), mb = double(b.mass);
  return 5.1 * roundoff * ma *
         (std::abs(ma - mb) * std::abs(double(a.velocity)) +
          2 * mb * std::abs(double(b.velocity))) /
         (ma + mb);
}

template <class S>
void check_bookings(Random& random) {
  using contact::Booking;
  const double roundoff = double(contact::tolerance::unit_roundoff<S>);
  const S unit = S(std::ldexp(1.0, sizeof(S) == sizeof(float) ? -14 : -40));
  constexpr std::size_t n = 16;
  std::vector<contact::BookedBody<S>> first;
  for (std::size_t i = 0; i < n; ++i) {
    const S mass = S(random.uniform(0.5, 3));
    const S momentum = S(random.uniform(-8, 8));
    first.push_back(contact::booked_body(mass, momentum, unit));
    REQUIRE(abs(oracle::exact(first[i].momentum) - oracle::exact(momentum)) <=
            oracle::exact(unit) / 2);
    REQUIRE(denominator(Rational(oracle::exact(first[i].momentum) / oracle::exact(unit))) == 1);
  }
  for (const Booking booking : {Booking::formulas, Booking::impulses, Booking::grid}) {
    auto bodies = first;
    const auto total_of = [&] {
      Rational sum = 0;
      for (const auto& body : bodies) {
        sum += booking == Booking::grid ? oracle::exact(body.momentum)
                                        : oracle::exact(body.mass) * oracle::exact(body.velocity);
      }
      return sum;
    };
    const Rational before = total_of();
    double room = 0;  // what the roundings of all collisions can add up to
    for (int c = 0; c < generators::tried(40000); ++c) {
      const auto i = static_cast<std::size_t>(random.integer(0, int(n) - 1));
      const auto j = (i + static_cast<std::size_t>(random.integer(1, int(n) - 1))) % n;
      auto& a = bodies[i];
      auto& b = bodies[j];
      const auto was_a = a;
      const auto was_b = b;
      const double formula_a = room_of_formula(a, b, roundoff);
      const double formula_b = room_of_formula(b, a, roundoff);
      contact::collide_booked(a, b, booking, unit);
      // The quotient J / m and the sum are rounded, and |J| is no more than m|v| + m|v'|.
      const auto sum_room = [roundoff](const auto& was, const auto& is) {
        const double m = double(is.mass);
        return 1.1 * roundoff * m *
               (2 * std::abs(double(is.velocity)) + std::abs(double(was.velocity)));
      };
      if (booking == Booking::formulas) room += formula_a + formula_b;
      if (booking == Booking::impulses) room += sum_room(was_a, a) + sum_room(was_b, b);
      if (c >= generators::tried(2000)) continue;
      Rational change = 0, scale = 0;  // the bound that the comment gives
      for (const auto& [was, is] : {std::pair(was_a, a), std::pair(was_b, b)}) {
        const Rational m = oracle::exact(is.mass);
        change += booking == Booking::grid
                      ? oracle::exact(is.momentum) - oracle::exact(was.momentum)
                      : Rational(m * (oracle::exact(is.velocity) - oracle::exact(was.velocity)));
        scale += m * (abs(oracle::exact(was.velocity)) + abs(oracle::exact(is.velocity)));
      }
      REQUIRE(abs(change) <=
              (booking == Booking::grid ? Rational(0) : Rational(16 * u<S>() * scale)));
      // Each way gives the velocities of one physics. An impulse has five roundings, and what is
      // done with it two more; on a grid it is off by half a unit besides, and so is the momentum
      // that was kept.
      const auto right = after_collision(was_a, was_b);
      const double impulse = std::abs(double(a.velocity) - double(was_a.velocity)) * double(a.mass);
      const double by_impulse =
          8 * roundoff * impulse + (booking == Booking::grid ? double(unit) : 0.0);
      const auto close = [&](const auto& body, const auto& was, const Rational& v, double formula) {
        const double m = double(body.mass);
        const double wide = booking == Booking::formulas
                                ? formula
                                : by_impulse + 4 * roundoff * m * std::abs(double(was.velocity));
        REQUIRE(abs(oracle::exact(body.velocity) - v) * oracle::exact(body.mass) <=
                oracle::exact(wide + 4 * roundoff * m * std::abs(double(body.velocity))));
      };
      close(a, was_a, right[0], formula_a);
      close(b, was_b, right[1], formula_b);
    }
    const Rational drift = total_of() - before;
    INFO("booking " << int(booking) << ", drift " << oracle::nearest(drift) << ", room " << room);
    if (booking == Booking::grid) {
      CHECK(drift == 0);
    } else {
      CHECK(drift != 0);
      CHECK(abs(drift) <= oracle::exact(room));
    }
    CHECK(rounded<double>(contact::booked_momentum(bodies, booking)) ==
          oracle::nearest(total_of()));
  }
}

}  // namespace

TEST_CASE("over many collisions the momentum drifts no further than each rounding allows") {
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
