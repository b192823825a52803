// disc_events.hpp and billiard_table.hpp against rational arithmetic on the stored numbers, with
// one square root where there is one. u is the unit roundoff of the type. A bound that a comment of
// the reference gives is tested as it stands, without an allowance.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <contact/billiard_table.hpp>
#include <contact/disc_collision.hpp>
#include <contact/disc_events.hpp>
#include <limits>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::Disc;
using contact::Vector2;
using generators::any_finite;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using reference::all_kinds;
using reference::exact_pair;
using reference::Pair;
using reference::pair_of;
using reference::vector_of;
using rounding::error;
using rounding::u;

TEMPLATE_TEST_CASE("the touch is decided exactly, and its time is within its bound", "", float,
                   double) {
  using S = TestType;
  Random random(8);
  int met = 0;
  int missed = 0;
  for (int i = 0; i < 1500; ++i) {
    auto [a, b] = pair_of<S>(random, all_kinds[static_cast<std::size_t>(i) % all_kinds.size()]);
    if (i % 11 == 5) {
      for (Vector2<S>* v : {&a.centre, &b.centre, &a.velocity, &b.velocity}) {
        *v = Vector2<S>{any_finite<S>(random), any_finite<S>(random)};
      }
      a.radius = std::abs(any_finite<S>(random));
    }
    if (i % 11 == 7) {  // large and slow, small and fast: some squares underflow, others do not
      const int most = std::numeric_limits<S>::max_exponent - 28;
      const int length = random.integer(-most, most);
      const int speed = random.integer(-most, most);
      for (Disc<S>* d : {&a, &b}) {
        d->radius = std::ldexp(d->radius, length);
        for (int k = 0; k < 2; ++k) {
          d->centre(k) = std::ldexp(d->centre(k), length);
          d->velocity(k) = std::ldexp(d->velocity(k), speed);
        }
      }
    }
    const Pair p = exact_pair(a, b);
    const auto time = contact::time_to_touch(a, b);
    const bool meet = p.approach() > 0 && (p.gap() <= 0 || p.depth() >= 0);
    if (!meet) {
      ++missed;
      CHECK_FALSE(time);
      continue;
    }
    ++met;
    const Surd right = p.gap() <= 0
                           ? Surd{0, 0, 0}
                           : Surd{p.approach() / p.speed2(), Rational(-1) / p.speed2(), p.depth()};
    const Rational value = oracle::enclose(right, 2500).high;
    if (!time) {  // later than the largest number
      CHECK(value * (1 + 300 * u<S>()) >= oracle::exact(std::numeric_limits<S>::max()));
      continue;
    }
    CHECK(error(*time, value) <=
          256 * u<S>() * value + oracle::exact(contact::tolerance::underflow_unit<S>));
  }
  CHECK(met > 300);
  CHECK(missed > 300);
}

TEST_CASE("extreme distances and speeds are computed like ordinary ones") {
  // The square of 2^-541 is 0; times the square of 2^480 it would be 2^-122.
  const int length = GENERATE(480, -541);
  const int speed = -61 - length;
  const auto scaled = [&](double x, double y, double vx) {
    contact::Disc<double> disc{1, 1, {x, y}, {vx, 0}};
    disc.radius = std::ldexp(disc.radius, length);
    disc.centre *= std::ldexp(1.0, length);
    disc.velocity *= std::ldexp(1.0, speed);
    return disc;
  };
  const auto time = contact::time_to_touch(scaled(-3, 0.5, 1), scaled(0, 0, 0));
  REQUIRE(time);
  const double right = 3 - std::sqrt(3.75);  // of |(−3 + t, 0.5)| = 2
  CHECK(std::abs(std::ldexp(*time, speed - length) - right) <= 512 * u<double>() * right);
}

TEST_CASE("on a table each event is a touch, in order, and energy is conserved") {
  const contact::Table<double> table{2, 1.5, 1, 1};
  Random random(9);
  for (int round = 0; round < 20; ++round) {
    std::vector<Disc<double>> discs;
    for (int i = 0; i < 4; ++i) {
      discs.push_back(contact::disc<double>(random.uniform(0.5, 2), 0.1,
                                            {0.3 + 0.4 * i, random.uniform(0.2, 1.3)},
                                            vector_of<double>(random, 2)));
    }
    const auto energy = [&] {
      double sum = 0;
      for (const auto& d : discs) sum += contact::kinetic_energy(d);
      return sum;
    };
    const double before = energy();
    double last = 0;
    int events = 0;
    const auto seen = [&](const contact::TableEvent<double>& event, const auto& now) {
      CHECK(event.time >= last);
      last = event.time;
      ++events;
      const auto& first = now[static_cast<std::size_t>(event.first)];
      // Times are off by 256 u of themselves at most, speeds are below 8 m/s, times below 3 s.
      const double room = 2 * 8 * 3 * 260 * 0x1p-53;
      if (event.second >= 0) {
        const auto& second = now[static_cast<std::size_t>(event.second)];
        CHECK(std::abs((first.centre - second.centre).norm() - 0.2) <= room);
      } else {
        CHECK(std::abs(contact::detail::clearance(table, first, event.second)) <= room);
      }
      for (const auto& d : now) {
        for (int cushion = -1; cushion >= -4; --cushion) {
          CHECK(contact::detail::clearance(table, d, cushion) >= -room);
        }
      }
    };
    CHECK(contact::play(table, discs, 3.0, 200, seen) == 3.0);
    CHECK(events > 3);
    // 66 u of the velocities for each event, and twice that of the energy.
    CHECK(std::abs(energy() - before) <= events * 4 * 66 * 2 * 0x1p-53 * before);
  }
}

TEST_CASE("fixed time steps find a touch late, and miss a fast one") {
  const contact::Table<double> table{10, 2, 1, 1};
  const std::vector<Disc<double>> start{contact::disc<double>(1, 0.1, {1, 1}, {8, 0}),
                                        contact::disc<double>(1, 0.1, {5, 1.15}, {0, 0})};
  const auto after = [&](double step) {
    auto discs = start;
    contact::play_in_steps(table, discs, 0.6, step, [](double, const auto&) {});
    return discs[1].velocity;
  };
  auto discs = start;
  contact::play(table, discs, 0.6, 10, [](const auto&, const auto&) {});
  const auto right = discs[1].velocity;
  CHECK(right.norm() > 1);
  const double fine = (after(1.0 / 4096) - right).norm();
  const double coarse = (after(1.0 / 128) - right).norm();
  CHECK(fine > 0);
  CHECK(coarse > fine);
  CHECK(after(0.15) == Vector2<double>(0, 0));
  CHECK_FALSE(contact::next_event<double>(table, {contact::disc<double>(1, 0.1, {1, 1}, {0, 0})}));
}
