// cradle.hpp against rational arithmetic on the stored numbers (class (a) of the oracle). u
// is the unit roundoff of the type, η its smallest number. A bound in a comment of
// the reference is tested without an allowance.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/block_count.hpp>
#include <contact/collision_1d.hpp>
#include <contact/cradle.hpp>
#include <contact/tolerance.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::LineBody;
using generators::Random;
using oracle::Rational;
using reference::exactly;
using reference::pair;
using rounding::error;
using rounding::gamma;

TEST_CASE("equal balls are sorted in any order, without rounding") {
  Random random(1308);
  for (int i = 0; i < 500; ++i) {
    std::vector<LineBody<double>> row;
    std::vector<double> sorted;
    for (int n = random.integer(0, 8); n > 0; --n) {
      row.push_back(contact::line_body(1.25, random.uniform(-9, 9)));
      sorted.push_back(row.back().velocity);
    }
    std::sort(sorted.begin(), sorted.end());
    for (const auto order : {contact::PairOrder::left_to_right, contact::PairOrder::right_to_left,
                             contact::PairOrder::fastest_first}) {
      const auto outcome = contact::collide_row(row, 1.0, order, 1000);
      CHECK(outcome.settled);
      CHECK(outcome.velocities == sorted);
    }
  }
}

TEST_CASE("a row conserves momentum, gains no energy, and does not approach afterwards") {
  Random random(1309);
  for (int i = 0; i < 300; ++i) {
    std::vector<LineBody<double>> row;
    std::vector<LineBody<Rational>> exact;
    for (int n = random.integer(2, 6); n > 0; --n) {
      const double mass = random.integer(1, 9);
      row.push_back(contact::line_body(mass, random.uniform(-9, 9)));
      exact.push_back(exactly(row.back()));
    }
    const double e = random.chance(0.5) ? 1 : 0.875;
    const auto outcome = contact::collide_row(row, e, contact::PairOrder::fastest_first, 10000);
    CHECK(outcome.settled);
    Rational drift = 0;
    Rational size = 0;
    Rational before = 0;
    Rational after = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Rational m = exact[k].mass;
      const Rational v = oracle::exact(outcome.velocities[k]);
      drift += m * (v - exact[k].velocity);
      size += m * abs(exact[k].velocity);
      before += m * exact[k].velocity * exact[k].velocity;
      after += m * v * v;
      if (k > 0) CHECK(outcome.velocities[k - 1] <= outcome.velocities[k]);
    }
    // Intermediate speeds can grow by at most the root of the mass ratio: a factor of 3 for masses
    // up to 9, squared for momenta.
    CHECK(abs(drift) <= 9 * outcome.collisions * gamma<double>(8) * size * 2);
    CHECK(after <= before * (1 + outcome.collisions * gamma<double>(64)));
  }
  // In fractions the order decides, but not for equal balls.
  const std::vector<LineBody<Rational>> squeezed{{4, 1}, {1, 0}, {4, -1}};
  const auto left = contact::collide_row<Rational>(squeezed, Rational(1) / 2,
                                                   contact::PairOrder::left_to_right, 100);
  const auto right = contact::collide_row<Rational>(squeezed, Rational(1) / 2,
                                                    contact::PairOrder::right_to_left, 100);
  CHECK(left.velocities != right.velocities);
}

TEST_CASE("all pairs at once conserve momentum, and lose energy if a ball is hit from both sides") {
  const auto energy = [](const std::vector<LineBody<Rational>>& row, const auto& velocities) {
    Rational sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      sum += row[k].mass * velocities[k] * velocities[k] / 2;
    }
    return sum;
  };
  Random random(1319);
  int lost = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<LineBody<Rational>> row;
    std::vector<Rational> before;
    for (int n = random.integer(2, 6); n > 0; --n) {
      const int mass = random.integer(1, 4);
      row.push_back({mass, random.integer(-5, 5)});
      before.push_back(row.back().velocity);
    }
    const auto outcome = contact::collide_simultaneously<Rational>(row, 1, 12);
    Rational drift = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      drift += row[k].mass * (outcome.velocities[k] - before[k]);
    }
    CHECK(drift == 0);
    CHECK(energy(row, outcome.velocities) <= energy(row, before));
    lost += energy(row, outcome.velocities) < energy(row, before);
  }
  CHECK(lost > 20);
  // One ball in from the left: no ball is hit from both sides.
  const std::vector<LineBody<Rational>> cradle{{1, 2}, {1, 0}, {1, 0}, {1, 0}, {1, 0}};
  const auto one = contact::collide_simultaneously<Rational>(cradle, 1, 100);
  CHECK(one.settled);
  CHECK(
      one.velocities ==
      contact::collide_row<Rational>(cradle, 1, contact::PairOrder::fastest_first, 100).velocities);
  // The lesson's row, one in from each end: the middle ball is hit from both sides, and a fifth of
  // the energy remains.
  const std::vector<LineBody<Rational>> both{{1, 2}, {1, 0}, {1, 0}, {1, 0}, {1, -1}};
  const auto two = contact::collide_simultaneously<Rational>(both, 1, 100);
  CHECK(two.settled);
  CHECK(two.velocities == std::vector<Rational>{0, 0, 0, 0, 1});
}

TEST_CASE("pairs with a small e may collide without end") {
  // Three equal balls, the outer ones come in symmetrically: below e = 7 − 4 √3 = 0.0718 there are
  // infinitely many collisions.
  const auto row = [](double) { return std::vector<LineBody<double>>{{1, 1}, {1, 0}, {1, -1}}; };
  CHECK(contact::collide_row(row(0), 0.08, contact::PairOrder::fastest_first, 100).settled);
  CHECK_FALSE(contact::collide_row(row(0), 0.06, contact::PairOrder::fastest_first, 100).settled);
}

TEST_CASE("springs conserve momentum and energy, and two bodies collide as a pair") {
  using contact::ContactSpring;
  for (const auto law : {ContactSpring::linear, ContactSpring::hertz}) {
    const std::vector<LineBody<double>> two{{3, 2}, {1, -1}};
    const auto pair = contact::collide(two[0], two[1], 1.0);
    double coarse = 0;
    for (const int steps : {400, 800, 1600}) {
      const auto outcome = contact::row_on_springs(two, law, steps);
      CHECK(outcome.settled);
      const double error = std::abs(outcome.velocities[0] - pair.first);
      // Second order: half the step, about a quarter of the error. A contact that ends within a
      // step adds a little of its own.
      if (steps > 400) CHECK(error <= coarse / 2 + 1e-6);
      CHECK(error < 1e-3);
      coarse = error;
    }
    const std::vector<LineBody<double>> cradle{{1, 1}, {1, 0}, {1, 0}, {1, 0}, {1, 0}};
    const auto outcome = contact::row_on_springs(cradle, law, 4000);
    CHECK(outcome.settled);
    double momentum = 0;
    double energy = 0;
    for (const double v : outcome.velocities) {
      momentum += v;
      energy += v * v;
    }
    CHECK(std::abs(momentum - 1) < 1e-12);
    CHECK(std::abs(energy - 1) < 1e-4);
    // Unlike the ideal cradle: the first ball bounces back.
    CHECK(outcome.velocities[0] < -0.05);
    CHECK(outcome.velocities[4] < 0.995);
    CHECK(outcome.velocities[4] > 0.9);
  }
  CHECK(contact::row_on_springs<double>({}, ContactSpring::linear, 100).settled);
  CHECK(contact::row_on_springs<double>({{1, 5}, {2, 5}}, ContactSpring::hertz, 100).settled);
}
