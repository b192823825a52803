// two_contacts.hpp and contact_block.hpp: two contacts by cases, exactly, and in one iteration.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <contact/two_contacts.hpp>
#include <limits>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

using contact::solve_two_contacts;
using contact::TwoContactCase;
using contact::TwoContactImpulses;
using contact::TwoContactMatrix;
using generators::Random;
using generators::tried;
using oracle::Rational;
using reference::down;
using reference::problem;
using reference::Problem;
using reference::V;
using support::contains;
using support::refusal;

namespace {

/// A positive semidefinite matrix, up to rounding: of two vectors; often parallel, opposite or
/// small integers. Computed in S: GCC 12 with -O2 leaves out the rounding to float of two
/// neighbouring doubles that are used as doubles again, and the oracle would get other numbers.
template <class S>
TwoContactMatrix<S> any_matrix(Random& random) {
  const auto number = [&] {
    return S(random.chance(0.5) ? random.integer(-3, 3) : random.integer(-1000000, 1000000));
  };
  const S p = number();
  const S q = number();
  const S times = S(random.integer(-2, 2));
  const bool parallel = random.chance(0.3);
  const S r = parallel ? times * p : number();
  const S s = parallel ? times * q : number();
  return {p * p + q * q, p * r + q * s, r * r + s * s};
}

template <class S>
TwoContactMatrix<Rational> fractions(const TwoContactMatrix<S>& m) {
  return {oracle::exact(m.first), oracle::exact(m.coupling), oracle::exact(m.second)};
}

}  // namespace

TEST_CASE("two contacts in fractions: the four cases are the complementarity problem") {
  Random random(1830);
  std::array<int, 5> seen{};
  for (int i = 0; i < tried(4000); ++i) {
    const auto m = fractions(any_matrix<double>(random));
    const int range = random.chance(0.5) ? 2 : 1000;
    const Rational v = random.integer(-range, range);
    const Rational w = random.integer(-range, range);
    const auto got = solve_two_contacts<Rational>(m, v, w);
    const auto all = contact::solve_complementarity<Rational>(
        {{m.first, m.coupling}, {m.coupling, m.second}}, {v, w});
    REQUIRE(got.has_value() == all.has_value());
    ++seen[got ? static_cast<std::size_t>(got->pushes) : 4];
    if (!got) continue;
    const Rational x = got->first;
    const Rational y = got->second;
    const Rational one = m.first * x + m.coupling * y + v;
    const Rational two = m.coupling * x + m.second * y + w;
    CHECK((x >= 0 && y >= 0 && one >= 0 && two >= 0));
    CHECK(x * one == 0);
    CHECK(y * two == 0);
    const bool both = got->pushes == TwoContactCase::both;
    CHECK((x > 0) == (both || got->pushes == TwoContactCase::first));
    CHECK((y > 0) == (both || got->pushes == TwoContactCase::second));
  }
  for (const int count : seen) CHECK(count > tried(50));
}

TEST_CASE("two contacts in doubles: the exact case, and impulses with all digits") {
  Random random(1831);
  for (int i = 0; i < tried(4000); ++i) {
    auto m = any_matrix<double>(random);
    double v = random.integer(-9, 9);
    double w = random.chance(0.5) ? v : random.integer(-9, 9);
    // Almost the same contact twice, and scales.
    if (m.second > 0 && random.chance(0.3)) m.second = std::nextafter(m.second, 1e300);
    if (w != 0 && random.chance(0.3)) w = std::nextafter(w, random.chance(0.5) ? 10 : -10);
    const double scale = random.chance(0.3) ? 0x1p-440 : random.chance(0.3) ? 0x1p430 : 1;
    m = {m.first * scale, m.coupling * scale, m.second * scale};
    v *= scale;
    w *= scale;
    const auto got = solve_two_contacts<double>(m, v, w);
    const auto right =
        solve_two_contacts<Rational>(fractions(m), oracle::exact(v), oracle::exact(w));
    REQUIRE(got.has_value() == right.has_value());
    if (!got) continue;
    CHECK(got->pushes == right->pushes);
    const Rational room = oracle::exact(8 * reference::u);
    CHECK(abs(Rational(oracle::exact(got->first) - right->first)) <= room * right->first);
    CHECK(abs(Rational(oracle::exact(got->second) - right->second)) <= room * right->second);
  }
}

TEST_CASE("two contacts of any size: the exact case, and impulses with all digits or refused") {
  Random random(1835);
  const Rational largest = oracle::exact(std::numeric_limits<double>::max());
  const Rational smallest = oracle::exact(std::numeric_limits<double>::denorm_min());
  const Rational room = oracle::exact(8 * reference::u);
  std::array<int, 5> seen{};
  for (int i = 0; i < tried(4000); ++i) {
    auto m = any_matrix<double>(random);
    if (m.second > 0 && random.chance(0.2)) m.second = std::nextafter(m.second, 1e300);
    const int p = random.integer(-480, 480);
    const int q = random.chance(0.3) ? p : random.integer(-480, 480);
    m = {std::ldexp(m.first, 2 * p), std::ldexp(m.coupling, p + q), std::ldexp(m.second, 2 * q)};
    const int size = random.integer(-900, 900);
    const double v = std::ldexp(random.integer(-9, 9), std::clamp(size + p, -1070, 1015));
    const double w = std::ldexp(random.integer(-9, 9), std::clamp(size + q, -1070, 1015));
    const auto right =
        solve_two_contacts<Rational>(fractions(m), oracle::exact(v), oracle::exact(w));
    if (right && (right->first > largest || right->second > largest)) {
      CHECK(contains(refusal([&] { solve_two_contacts<double>(m, v, w); }), "overflow"));
      ++seen[4];
      continue;
    }
    const auto got = solve_two_contacts<double>(m, v, w);
    REQUIRE(got.has_value() == right.has_value());
    if (!got) continue;
    ++seen[static_cast<std::size_t>(got->pushes)];
    CHECK(got->pushes == right->pushes);
    const auto off = [&](double x, const Rational& exact) {
      return abs(Rational(oracle::exact(x) - exact)) <= room * exact + smallest;
    };
    CHECK(off(got->first, right->first));
    CHECK(off(got->second, right->second));
  }
  for (const int count : seen) CHECK(count > tried(50));
}

TEST_CASE("impulses of very heavy and very light bodies are not lost") {
  const auto heavy = solve_two_contacts<double>({1e-160, -0.5e-160, 1e-160}, -1, -1);
  CHECK(std::abs(heavy->first - 2e160) <= 1e145);
  const auto light = solve_two_contacts<double>({1e160, 0, 1e160}, -1, -1);
  CHECK(std::abs(light->first * 1e160 - 1) <= 1e-15);
  const auto heavier = solve_two_contacts<double>({1e-170, 0, 1e-170}, -1, -1);
  CHECK(std::abs(heavier->second * 1e-170 - 1) <= 1e-15);
  const auto fast = solve_two_contacts<double>({1e200, 1e100, 1e200}, -1e200, -1e200);
  CHECK(std::abs(fast->second - 1) <= 1e-15);
  // In single precision too.
  const auto single = solve_two_contacts<float>({1e-25f, 0, 1e-25f}, -1, -1);
  CHECK(std::abs(single->first * 1e-25f - 1) <= 1e-6f);
}

TEST_CASE("a box that falls flat stops, and a tilted one is pushed at one corner") {
  // Half lengths 1 and 1/2, mass 1, moment 5/12: each contact 1 + 12/5, the coupling 1 − 12/5.
  const TwoContactMatrix<Rational> m{Rational(17) / 5, Rational(-7) / 5, Rational(17) / 5};
  const auto flat = solve_two_contacts<Rational>(m, -1, -1);
  REQUIRE(flat.has_value());
  CHECK(flat->pushes == TwoContactCase::both);
  CHECK(flat->first == Rational(1) / 2);
  CHECK(flat->second == Rational(1) / 2);
  const auto tilted = solve_two_contacts<Rational>(m, -1, 5);
  REQUIRE(tilted.has_value());
  CHECK(tilted->pushes == TwoContactCase::first);
  CHECK(tilted->first == Rational(5) / 17);
}

TEST_CASE("the jaws of a vice have no solution, and invalid numbers are refused") {
  CHECK_FALSE(solve_two_contacts<double>({1, -1, 1}, -1, -1).has_value());
  CHECK(solve_two_contacts<double>({1, -1, 1}, -1, 1).has_value());
  CHECK(solve_two_contacts<double>({1, 1, 1}, -1, -1)->pushes == TwoContactCase::first);
  CHECK_FALSE(solve_two_contacts<double>({0, 0, 0}, -1, 0).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(refusal([&] { solve_two_contacts<double>({1, nan, 1}, -1, -1); }), "finite"));
  CHECK(contains(refusal([&] { solve_two_contacts<double>({-1, 0, 1}, -1, -1); }), "negative"));
  CHECK(contains(refusal([&] {
                   solve_two_contacts<double>({1e-300, 0, 1}, -1e300, 0);
                 }),
                 "overflow"));
}

TEST_CASE("single precision decides exactly too") {
  Random random(1832);
  for (int i = 0; i < tried(1000); ++i) {
    const auto m = any_matrix<float>(random);
    const float v = static_cast<float>(random.uniform(-1, 1));
    const float w = random.chance(0.5) ? v : static_cast<float>(random.uniform(-1, 1));
    const auto got = solve_two_contacts<float>(m, v, w);
    const auto right =
        solve_two_contacts<Rational>(fractions(m), oracle::exact(v), oracle::exact(w));
    REQUIRE(got.has_value() == right.has_value());
    if (got) CHECK(got->pushes == right->pushes);
  }
}

namespace {

/// A rod above the ground, with contacts at both ends.
Problem<double> rod(Random& random, double friction) {
  Problem<double> p;
  const double half = random.uniform(0.5, 2);
  const V zero(0, 0, 0);
  const V velocity(random.uniform(-1, 1), 0, -1);
  p.bodies = {
      contact::immovable<double>(zero, zero, zero),
      contact::rigid_body<double>(1, contact::box_inertia<double>(1, {2 * half, 0.1, 0.1}),
                                  V(0, 0, 0.05), velocity, V(0, random.uniform(-0.4, 0.4), 0))};
  for (const double x : {-half, half})
    p.contacts.push_back({1, 0, V(x, 0, 0), V(0, 0, 1), friction, 0});
  return p;
}

}  // namespace

TEST_CASE("block solve needs one iteration for the two ends of a rod, one by one needs many") {
  Random random(1833);
  for (int i = 0; i < tried(200); ++i) {
    const auto p = rod(random, 0);
    contact::SolverSettings<double> limits{1000, 1e-12};
    const auto one_by_one = contact::solve_contacts<double>(p.bodies, p.contacts, {}, limits);
    limits.block = true;
    const auto block = contact::solve_contacts<double>(p.bodies, p.contacts, {}, limits);
    CHECK(block.report.settled);
    CHECK(block.report.iterations <= 2);  // the second finds nothing to change
    CHECK(one_by_one.report.iterations > 10);
    CHECK((block.bodies[1].velocity - one_by_one.bodies[1].velocity).norm() <= 1e-11);
  }
}

TEST_CASE("a ball in a slot: a block whose matrix is singular but for rounding") {
  const V zero(0, 0, 0);
  Random random(1836);
  int positive = 0;  // determinants, by rounding
  for (int i = 0; i < tried(200); ++i) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const V n = V(x, y, 1).normalized();
    const V other = -n * (1 + random.integer(-2, 2) * 0x1p-52);
    const std::vector<reference::Body> bodies{
        contact::immovable<double>(zero, zero, zero),
        contact::rigid_body<double>(1, contact::box_inertia<double>(1, V(1, 1, 1)), zero, zero,
                                    zero)};
    const TwoContactMatrix<double> m{n.dot(n), n.dot(other), other.dot(other)};
    positive += solve_two_contacts<double>(m, -0.1, -0.1) ? 1 : 0;
    for (const bool block : {false, true}) {
      contact::SolverSettings<double> limits{100, 1e-12};
      limits.block = block;
      const auto got = contact::solve_contacts<double>(
          bodies, {{1, 0, zero, n, 0, 0.1}, {1, 0, zero, other, 0, 0.1}}, {}, limits);
      CHECK_FALSE(got.report.settled);
      CHECK(reference::energy(got.bodies) <= 1e-20);
      CHECK(got.report.rounding <= 1e-10);
    }
  }
  CHECK(positive > 0);
  // The same contact twice is singular too, and is solved.
  const auto twice = contact::detail::is_regular<double>({1, 1 - 0x1p-50, 1});
  CHECK_FALSE(twice);
  CHECK(contact::detail::is_regular<double>({1e200, -0.999999e-100, 1e-300}));
  CHECK(contact::detail::is_regular<double>({3.4, -1.4, 3.4}));
}

TEST_CASE("block solve keeps what holds after any number of iterations") {
  Random random(1834);
  for (int i = 0; i < tried(150); ++i) {
    auto p = down(problem(random, random.integer(2, 4), random.integer(1, 3)));
    const auto once = p.contacts;  // each contact twice, and a second point of the same bodies
    p.contacts.clear();
    for (auto c : once) {
      c.friction = random.uniform(0, 1);
      p.contacts.push_back(c);
      if (random.chance(0.7)) c.point += V(random.uniform(-1, 1), 0.5, 0);
      p.contacts.push_back(c);
    }
    contact::SolverSettings<double> limits{random.integer(1, 40), 1e-10, random.uniform(0.5, 1.8)};
    limits.block = true;
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, limits);
    CHECK(reference::energy(got.bodies) <= reference::energy(p.bodies) * (1 + 1e-12));
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      CHECK(got.impulses[k].normal >= 0);
      CHECK(got.impulses[k].tangential.norm() <=
            p.contacts[k].friction * got.impulses[k].normal * (1 + 64 * reference::u));
    }
  }
}
