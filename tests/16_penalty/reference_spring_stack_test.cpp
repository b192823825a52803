// A stack on springs: sag and steps in fractions (class (a) of the oracle), frequencies against the
// closed form of equal bodies in intervals (class (c)).
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/penalty_step.hpp>
#include <contact/spring_stack.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace spring_stack_test {
namespace {

using contact::spring_stack;
using contact::SpringStack;
using contact::StackState;
using generators::Random;
using oracle::Interval;
using oracle::Rational;
using support::contains;
using support::refusal;

template <class S>
SpringStack<S> any_stack(Random& random, int range) {
  std::vector<S> masses;
  std::vector<S> stiffness;
  for (int n = random.integer(1, 8); n > 0; --n) {
    masses.push_back(S(std::abs(random.magnitude(-range, range))));
    stiffness.push_back(S(std::abs(random.magnitude(-range, range))));
  }
  return spring_stack(masses, stiffness);
}

SpringStack<Rational> whole_stack(Random& random) {
  std::vector<Rational> masses;
  std::vector<Rational> stiffness;
  for (int n = random.integer(1, 6); n > 0; --n) {
    masses.emplace_back(random.integer(1, 9));
    stiffness.emplace_back(random.integer(1, 50));
  }
  return {masses, stiffness};
}

StackState<Rational> any_state(Random& random, std::size_t n) {
  StackState<Rational> state;
  for (std::size_t i = 0; i < n; ++i) {
    state.displacement.emplace_back(random.integer(-20, 20), 4);
    state.velocity.emplace_back(random.integer(-20, 20), 4);
  }
  return state;
}

TEMPLATE_TEST_CASE("each contact of a stack carries the weight of all above it", "", float,
                   double) {
  using S = TestType;
  Random random(1671);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const auto stack = any_stack<S>(random, 12);
    const S g = S(random.uniform(0.1, 20));
    const auto sag = contact::stack_sag(stack, g);
    const auto rest = contact::stack_at_rest(stack, g);
    const int n = int(stack.size());
    Rational sum = 0;
    for (std::size_t b = 0; b < stack.size(); ++b) {
      Rational above = 0;
      for (std::size_t c = b; c < stack.size(); ++c) above += oracle::exact(stack.masses[c]);
      const Rational right = above * oracle::exact(g) / oracle::exact(stack.stiffness[b]);
      sum += right;
      REQUIRE(abs(oracle::exact(sag[b]) - right) <= (n + 2) * u * right);
      REQUIRE(abs(oracle::exact(rest.displacement[b]) - sum) <= (2 * n + 2) * u * sum);
      REQUIRE(rest.velocity[b] == S(0));
    }
  }
}

TEST_CASE("the lowest of n equal contacts sags n times as far, the top n (n + 1) / 2 times") {
  for (int n = 1; n <= 12; ++n) {
    const auto stack = spring_stack(std::vector<Rational>(std::size_t(n), Rational(3)),
                                    std::vector<Rational>(std::size_t(n), Rational(7)));
    const auto sag = contact::stack_sag(stack, Rational(10));
    const auto rest = contact::stack_at_rest(stack, Rational(10));
    CHECK(sag.front() == n * sag.back());
    CHECK(rest.displacement.back() == Rational(n * (n + 1), 2) * Rational(30, 7));
  }
}

TEST_CASE("a stack at rest stays at rest in explicit and in implicit steps, exactly") {
  Random random(1672);
  for (int i = 0; i < generators::tried(300); ++i) {
    const auto stack = whole_stack(random);
    const Rational g(random.integer(0, 10));
    const Rational h(random.integer(1, 40), 10);
    const auto rest = contact::stack_at_rest(stack, g);
    const auto one = contact::semi_implicit_stack_step(stack, rest, h, g);
    const auto other = contact::implicit_stack_step(stack, rest, h, g);
    REQUIRE(one.displacement == rest.displacement);
    REQUIRE(one.velocity == rest.velocity);
    REQUIRE(other.displacement == rest.displacement);
    REQUIRE(other.velocity == rest.velocity);
  }
}

TEST_CASE("implicit forces of a stack are those of the new displacements, exactly") {
  Random random(1673);
  for (int i = 0; i < generators::tried(300); ++i) {
    const auto stack = whole_stack(random);
    const auto now = any_state(random, stack.size());
    const Rational g(random.integer(0, 10));
    const Rational h(random.integer(1, 400), 10);
    const auto next = contact::implicit_stack_step(stack, now, h, g);
    for (std::size_t b = 0; b < stack.size(); ++b) {
      REQUIRE(next.displacement[b] == now.displacement[b] + h * next.velocity[b]);
      const Rational below =
          next.displacement[b] - (b > 0 ? next.displacement[b - 1] : Rational(0));
      Rational force = stack.masses[b] * g - stack.stiffness[b] * below;
      if (b + 1 < stack.size())
        force += stack.stiffness[b + 1] * (next.displacement[b + 1] - next.displacement[b]);
      REQUIRE(stack.masses[b] * (next.velocity[b] - now.velocity[b]) == h * force);
    }
  }
}

TEST_CASE("implicit steps lose the energy of the differences, for every step length, exactly") {
  Random random(1674);
  for (int i = 0; i < generators::tried(500); ++i) {
    const auto stack = whole_stack(random);
    const auto now = any_state(random, stack.size());
    const Rational h{random.integer(1, 1000), random.integer(1, 100)};
    const auto next = contact::implicit_stack_step(stack, now, h, Rational(0));
    StackState<Rational> change = now;
    for (std::size_t b = 0; b < stack.size(); ++b) {
      change.displacement[b] = next.displacement[b] - now.displacement[b];
      change.velocity[b] = next.velocity[b] - now.velocity[b];
    }
    const Rational before = contact::stack_energy(stack, now);
    const Rational after = contact::stack_energy(stack, next);
    REQUIRE(before - after == contact::stack_energy(stack, change));
    REQUIRE((after < before || before == 0));
  }
}

TEST_CASE("rounded implicit steps of a stiff stack with masses 1e12 apart decay") {
  for (const double h : {1e-3, 1.0, 1e3}) {
    const std::vector<double> masses{1, 1e12, 1e-6, 1, 1e6};
    const auto stack = spring_stack(masses, {1e9, 1e3, 1e12, 1.0, 1e6});
    StackState<double> state = contact::unloaded(stack);
    state.velocity = {1, -1, 1, -1, 1};
    double before = contact::stack_energy(stack, state);
    for (int n = 0; n < 200; ++n) {
      state = contact::implicit_stack_step(stack, state, h, 0.0);
      const double after = contact::stack_energy(stack, state);
      REQUIRE(after <= before * (1 + 1e-9));
      before = after;
    }
  }
}

TEMPLATE_TEST_CASE("an implicit step of bodies pushed down loses no digits, whatever its length",
                   "", float, double) {
  using S = TestType;
  Random random(1679);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(400); ++i) {
    const auto stack = any_stack<S>(random, 15);
    SpringStack<Rational> exact;
    StackState<S> now = contact::unloaded(stack);
    StackState<Rational> start;
    for (std::size_t b = 0; b < stack.size(); ++b) {
      exact.masses.push_back(oracle::exact(stack.masses[b]));
      exact.stiffness.push_back(oracle::exact(stack.stiffness[b]));
      now.velocity[b] = S(random.uniform(0, 1));
      start.displacement.emplace_back(0);
      start.velocity.push_back(oracle::exact(now.velocity[b]));
    }
    const S h = S(std::abs(random.magnitude(-10, 20)));
    const S g = S(random.uniform(0, 10));
    const auto next = contact::implicit_stack_step(stack, now, h, g);
    const auto right =
        contact::implicit_stack_step<Rational>(exact, start, oracle::exact(h), oracle::exact(g));
    const Rational room = 16 * int(stack.size()) * u;
    for (std::size_t b = 0; b < stack.size(); ++b) {
      REQUIRE(abs(oracle::exact(next.velocity[b]) - right.velocity[b]) <= room * right.velocity[b]);
      REQUIRE(abs(oracle::exact(next.displacement[b]) - right.displacement[b]) <=
              room * right.displacement[b]);
    }
  }
}

TEST_CASE("the step of a single body is that of implicit and semi-implicit Euler") {
  Random random(1675);
  for (int i = 0; i < generators::tried(300); ++i) {
    const Rational k(random.integer(1, 50));
    const Rational m(random.integer(1, 9));
    const Rational g(random.integer(0, 10));
    const Rational h(random.integer(1, 40), 10);
    const auto stack = spring_stack<Rational>({m}, {k});
    const auto now = any_state(random, 1);
    const auto implicit = contact::implicit_stack_step(stack, now, h, g);
    const auto semi = contact::semi_implicit_stack_step(stack, now, h, g);
    const auto step = [&](contact::PenaltyScheme scheme) {
      return contact::spring_step<Rational>(scheme, {now.displacement[0], now.velocity[0]}, {k, 0},
                                            m, h, g);
    };
    REQUIRE(implicit.velocity[0] == step(contact::PenaltyScheme::implicit_euler).approach);
    REQUIRE(semi.velocity[0] == step(contact::PenaltyScheme::semi_implicit_euler).approach);
    REQUIRE(semi.displacement[0] == step(contact::PenaltyScheme::semi_implicit_euler).penetration);
  }
}

TEST_CASE("natural frequencies of n equal bodies are 2 √(k/m) sin((2 j − 1) π / (4 n + 2))") {
  constexpr unsigned bits = 256;
  for (int n = 1; n <= 12; ++n) {
    const double k = 3;
    const double m = 0.7;
    const auto stack = spring_stack(std::vector<double>(std::size_t(n), m),
                                    std::vector<double>(std::size_t(n), k));
    for (int j = 1; j <= n; ++j) {
      const Interval wave =
          sin(Interval::pi(bits) * Interval(Rational(2 * j - 1, 4 * n + 2), bits));
      const Interval square =
          Interval(Rational(4 * oracle::exact(k) / oracle::exact(m)), bits) * wave * wave;
      const auto bounds = contact::frequency_bounds(stack, std::size_t(j - 1));
      REQUIRE(oracle::exact(bounds.below) <= square.high());
      REQUIRE(oracle::exact(bounds.above) >= square.low());
      REQUIRE(bounds.above == std::nextafter(bounds.below, 1e9));
      REQUIRE(contact::frequencies_below(stack, bounds.below) <= std::size_t(j - 1));
      REQUIRE(contact::frequencies_below(stack, bounds.above) >= std::size_t(j));
    }
  }
}

TEST_CASE("counts of frequencies are those of a determinant's roots, also at a root") {
  // Two bodies: ω⁴ m₁ m₂ − ω² ((k₁ + k₂) m₂ + k₂ m₁) + k₁ k₂ = 0.
  Random random(1676);
  int exact = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    const int m1 = random.integer(1, 4);
    const int m2 = random.integer(1, 4);
    int k1 = random.integer(1, 9);
    int k2 = random.integer(1, 9);
    double square = random.integer(0, 80) / 8.0;
    if (i % 4 == 0) {  // with these λ is a root
      const int root = random.integer(1, 9);
      square = root;
      k2 = 2 * root * m2;
      k1 = root * (2 * m2 + m1);
    }
    const auto stack = spring_stack<double>({double(m1), double(m2)}, {double(k1), double(k2)});
    const oracle::Quadratic q{m1 * m2, -((k1 + k2) * m2 + k2 * m1), k1 * k2};
    std::size_t below = 0;
    for (const oracle::Surd& root : q.roots()) {
      const int order = oracle::compare(root, {oracle::exact(square), 0, 0});
      below += order < 0 ? 1 : 0;
      exact += order == 0;
    }
    REQUIRE(contact::frequencies_below(stack, square) == below);
  }
  CHECK(exact > generators::tried(30));
}

TEMPLATE_TEST_CASE("bounds of a frequency are neighbours and count right, at every scale", "",
                   float, double) {
  using S = TestType;
  Random random(1677);
  for (int i = 0; i < generators::tried(60); ++i) {
    const auto stack = any_stack<S>(random, i % 2 == 0 ? 3 : 30);
    const auto j = std::size_t(random.integer(0, int(stack.size()) - 1));
    const auto bounds = contact::frequency_bounds(stack, j);
    REQUIRE(bounds.above == std::nextafter(bounds.below, std::numeric_limits<S>::infinity()));
    REQUIRE(contact::frequencies_below(stack, bounds.below) <= j);
    REQUIRE(contact::frequencies_below(stack, bounds.above) > j);
  }
}

TEST_CASE("a stack needs a shorter step than one of its bodies, and keeps its bound with it") {
  for (const int n : {1, 2, 5, 10}) {
    const auto stack = spring_stack(std::vector<double>(std::size_t(n), 2.0),
                                    std::vector<double>(std::size_t(n), 50.0));
    const double limit = contact::stack_step_limit(stack);
    const double alone = contact::step_limit(contact::PenaltyScheme::semi_implicit_euler,
                                             contact::spring_damper(50.0, 0.0), 2.0);
    if (n > 1) CHECK(limit < alone * 0.62);
    CHECK(limit > alone * 0.5);
    const auto after = [&](double h) {
      StackState<double> state = contact::unloaded(stack);
      for (std::size_t b = 0; b < stack.size(); ++b) state.velocity[b] = b % 2 == 0 ? 1 : -1;
      for (int s = 0; s < 20000; ++s)
        state = contact::semi_implicit_stack_step(stack, state, h, 0.0);
      return contact::stack_energy(stack, state);
    };
    CHECK(after(limit * 0.99) < 1e6);
    CHECK(!(after(limit * 1.01) < 1e100));
  }
}

TEMPLATE_TEST_CASE("the step limit of a stack is below 2 / ω by at most 8 u", "", float, double) {
  using S = TestType;
  Random random(1678);
  const double u = double(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(60); ++i) {
    const auto stack = any_stack<S>(random, 8);
    const S limit = contact::stack_step_limit(stack);
    // ω² < 4 / h² for all n frequencies, and not for 4 / (h (1 + 16 u))².
    const Rational h = oracle::exact(limit);
    SpringStack<Rational> exact;
    for (std::size_t b = 0; b < stack.size(); ++b) {
      exact.masses.push_back(oracle::exact(stack.masses[b]));
      exact.stiffness.push_back(oracle::exact(stack.stiffness[b]));
    }
    REQUIRE(contact::frequencies_below<Rational>(exact, 4 / (h * h)) == stack.size());
    const Rational longer = h * (1 + 8 * oracle::exact(u));
    REQUIRE(contact::frequencies_below<Rational>(exact, 4 / (longer * longer)) < stack.size());
  }
}

TEST_CASE("an invalid stack is refused") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(contains(refusal([] { spring_stack<double>({}, {}); }), "masses"));
  CHECK(contains(refusal([] { spring_stack<double>({1}, {1, 1}); }), "2 springs"));
  CHECK(contains(refusal([] { spring_stack<double>({1, 0}, {1, 1}); }), "masses"));
  CHECK(contains(refusal([&] { spring_stack<double>({1, 1}, {1, inf}); }), "stiffness"));
  const auto stack = spring_stack<double>({1}, {1});
  CHECK(contains(refusal([&] { contact::frequency_bounds(stack, 1); }), "j = 1"));
  const auto fast = spring_stack<double>({1e-300}, {1e300});
  CHECK(contains(refusal([&] { contact::frequency_bounds(fast, 0); }), "overflows"));
}

}  // namespace
}  // namespace spring_stack_test
