// collision_1d.hpp against rational arithmetic on the stored numbers (class (a) of the oracle). u
// is the unit roundoff of the type, η its smallest number. A bound in a comment of
// the reference is tested without an allowance.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/block_count.hpp>
#include <contact/collision_1d.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::LineBody;
using generators::any_finite;
using generators::Random;
using oracle::Rational;
using reference::exactly;
using reference::infinity;
using reference::Kind;
using reference::pair;
using rounding::error;
using rounding::eta;
using rounding::gamma;
using rounding::nearest;
using support::contains;
using support::refusal;

namespace {

constexpr std::array<Kind, 5> all_kinds{Kind::random, Kind::whole, Kind::alike, Kind::slow,
                                        Kind::spread};

}  // namespace

TEMPLATE_TEST_CASE("velocities after a collision keep their bound", "", float, double) {
  using S = TestType;
  Random random(1301);
  for (int i = 0; i < 4000; ++i) {
    const auto p = pair<S>(random, all_kinds[static_cast<std::size_t>(i) % all_kinds.size()]);
    const auto right = contact::collide(exactly(p.first), exactly(p.second), oracle::exact(p.e));
    const auto got = contact::collide(p.first, p.second, p.e);
    const auto exact = contact::collide_exactly(p.first, p.second, p.e);
    const Rational room = gamma<S>(8) * (abs(oracle::exact(p.first.velocity)) +
                                         abs(oracle::exact(p.second.velocity))) +
                          eta<S>();
    CHECK(got.collided == right.collided);
    CHECK(error(got.first, right.first) <= room);
    CHECK(error(got.second, right.second) <= room);
    CHECK(exact.first == nearest<S>(right.first));
    CHECK(exact.second == nearest<S>(right.second));
    // Momentum: by the errors of both velocities.
    const Rational m1 = oracle::exact(p.first.mass);
    const Rational m2 = oracle::exact(p.second.mass);
    const Rational drift = m1 * (oracle::exact(got.first) - oracle::exact(p.first.velocity)) +
                           m2 * (oracle::exact(got.second) - oracle::exact(p.second.velocity));
    CHECK(abs(drift) <= (m1 + m2) * room);
  }
}

TEMPLATE_TEST_CASE("properties that rounding does not affect", "", float, double) {
  using S = TestType;
  Random random(1302);
  for (int i = 0; i < 4000; ++i) {
    const auto p = pair<S>(random, all_kinds[static_cast<std::size_t>(i) % all_kinds.size()]);
    const auto after = contact::collide(p.first, p.second, p.e);
    const auto first = contact::line_body(p.first.mass, after.first);
    const auto second = contact::line_body(p.second.mass, after.second);
    CHECK_FALSE(contact::approaching(first, second));
    if (after.collided && p.e == 0) CHECK(after.first == after.second);
    if (after.collided && p.e == 1 && p.first.mass == p.second.mass) {
      CHECK(after.first == p.second.velocity);
      CHECK(after.second == p.first.velocity);
    }
    // The mirrored collision.
    const auto mirrored =
        contact::collide(contact::line_body(p.second.mass, -p.second.velocity),
                         contact::line_body(p.first.mass, -p.first.velocity), p.e);
    CHECK(mirrored.first == -after.second);
    CHECK(mirrored.second == -after.first);
    // A wall keeps its velocity, the other rebounds from it.
    const auto wall = contact::line_body(infinity<S>, p.second.velocity);
    const auto off_wall = contact::collide(p.first, wall, p.e);
    CHECK(off_wall.second == wall.velocity);
    if (wall.velocity == 0 && off_wall.collided) CHECK(off_wall.first == -p.e * p.first.velocity);
    CHECK(off_wall.first <= off_wall.second);
  }
}

TEST_CASE("two walls are left as they are") {
  const auto left = contact::line_body(infinity<double>, 2.0);
  const auto right = contact::line_body(infinity<double>, -1.0);
  const auto after = contact::collide(left, right, 0.5);
  CHECK_FALSE(after.collided);
  CHECK(after.first == 2);
  CHECK(after.second == -1);
  CHECK(contact::collision_impulse(left, right, 0.5) == 0);
  CHECK(contact::energy_lost(left, right, 0.5) == 0);
}

TEMPLATE_TEST_CASE("impulse, energy and restitution keep their bounds", "", float, double) {
  using S = TestType;
  Random random(1303);
  for (int i = 0; i < 4000; ++i) {
    const auto p = pair<S>(random, all_kinds[static_cast<std::size_t>(i) % 4]);
    const auto a = exactly(p.first);
    const auto b = exactly(p.second);
    const Rational e = oracle::exact(p.e);
    const auto near = [](S got, const Rational& right, int roundings) {
      return error(got, right) <= gamma<S>(roundings) * abs(right);
    };
    CHECK(near(contact::reduced_mass(p.first.mass, p.second.mass),
               a.mass * b.mass / (a.mass + b.mass), 3));
    const auto share = contact::mass_shares(p.first.mass, p.second.mass);
    CHECK(near(share.first, a.mass / (a.mass + b.mass), 2));
    CHECK(near(share.second, b.mass / (a.mass + b.mass), 2));
    CHECK(near(contact::collision_impulse(p.first, p.second, p.e),
               contact::collision_impulse(a, b, e), 7));
    CHECK(near(contact::energy_lost(p.first, p.second, p.e), contact::energy_lost(a, b, e), 11));
    CHECK(near(contact::kinetic_energy(p.first), contact::kinetic_energy(a), 2));
    CHECK(near(contact::closing_speed(p.first, p.second), a.velocity - b.velocity, 1));
    const S w1 = static_cast<S>(random.uniform(-9, 9));
    const S w2 = static_cast<S>(random.uniform(-9, 9));
    const auto measured = contact::restitution_of(p.first, p.second, w1, w2);
    CHECK(measured.has_value() == contact::approaching(p.first, p.second));
    if (measured) {
      CHECK(
          near(*measured, (oracle::exact(w2) - oracle::exact(w1)) / (a.velocity - b.velocity), 3));
    }
  }
}

TEST_CASE("the formulas satisfy the equations that they were derived from") {
  // In fractions: momentum, the two speeds, the energy before and after, and the loss.
  Random random(1304);
  for (int i = 0; i < 1000; ++i) {
    const auto p = pair<double>(random, all_kinds[static_cast<std::size_t>(i) % 4]);
    const auto a = exactly(p.first);
    const auto b = exactly(p.second);
    const Rational e = oracle::exact(p.e);
    const auto after = contact::collide(a, b, e);
    CHECK(a.mass * a.velocity + b.mass * b.velocity ==
          a.mass * after.first + b.mass * after.second);
    const LineBody<Rational> a_after{a.mass, after.first};
    const LineBody<Rational> b_after{b.mass, after.second};
    CHECK(contact::kinetic_energy(a) + contact::kinetic_energy(b) -
              contact::kinetic_energy(a_after) - contact::kinetic_energy(b_after) ==
          contact::energy_lost(a, b, e));
    CHECK(b.mass * (after.second - b.velocity) == contact::collision_impulse(a, b, e));
    if (after.collided) {
      CHECK(after.second - after.first == e * (a.velocity - b.velocity));
      CHECK(*contact::restitution_of(a, b, after.first, after.second) == e);
    }
    // In the frame of a train the loss is the same.
    const Rational train = random.integer(-99, 99);
    CHECK(contact::energy_lost<Rational>({a.mass, a.velocity + train}, {b.mass, b.velocity + train},
                                         e) == contact::energy_lost(a, b, e));
  }
}

TEST_CASE("no finite input gives a NaN, and only true overflow gives infinity") {
  Random random(1305);
  for (int i = 0; i < 3000; ++i) {
    const auto mass = [&random] {
      const double m = std::abs(any_finite(random));
      return m > 0 ? m : 1.0;
    };
    const double m1 = mass();
    const double m2 = mass();
    const auto first = contact::line_body(m1, any_finite(random));
    const auto second = contact::line_body(m2, any_finite(random));
    const double e = random.uniform();
    const auto right = contact::collide(exactly(first), exactly(second), oracle::exact(e));
    const auto got = contact::collide(first, second, e);
    const Rational room = gamma<double>(8) * (abs(oracle::exact(first.velocity)) +
                                              abs(oracle::exact(second.velocity))) +
                          eta<double>();
    for (const auto& [x, exact] : {std::pair{got.first, right.first}, {got.second, right.second}}) {
      CHECK_FALSE(std::isnan(x));
      if (std::isfinite(x)) {
        CHECK(error(x, exact) <= room);
      } else {
        CHECK(abs(exact) + room >= oracle::exact(std::numeric_limits<double>::max()));
      }
    }
    const auto sound = [](double x, const Rational& exact) {
      if (std::isnan(x)) return false;
      const double largest = oracle::nearest(exact * (1 + gamma<double>(11)));
      const double least = oracle::nearest(exact * (1 - gamma<double>(11)));
      return x <= std::nextafter(largest, infinity<double>) && x >= std::nextafter(least, 0.0);
    };
    if (m1 > 1e-290 && m2 > 1e-290) {
      CHECK(sound(contact::collision_impulse(first, second, e),
                  contact::collision_impulse(exactly(first), exactly(second), oracle::exact(e))));
      CHECK(sound(contact::energy_lost(first, second, e),
                  contact::energy_lost(exactly(first), exactly(second), oracle::exact(e))));
      CHECK(sound(contact::kinetic_energy(first), contact::kinetic_energy(exactly(first))));
    }
    CHECK(contact::approaching(first, second) ==
          (oracle::exact(first.velocity) > oracle::exact(second.velocity)));
  }
}

TEST_CASE("a construction refuses bad input, naming the argument and the value") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double mass : {0.0, -0.0, -1.0, -infinity<double>, nan}) {
    const auto message = refusal([mass] { contact::line_body(mass, 1.0); });
    CHECK((contains(message, "mass = ") && contains(message, contact::number_text(mass).c_str())));
  }
  CHECK(contains(refusal([] { contact::line_body(1.0, infinity<double>); }), "velocity = inf"));
  CHECK(refusal([] { contact::line_body(infinity<double>, 0.0); }).empty());
  for (const double e : {-0.1, 1.5, nan, infinity<double>}) {
    const auto message = refusal([e] { contact::require_restitution("e", e); });
    CHECK((contains(message, "e = ") && contains(message, "from 0 to 1")));
  }
  CHECK(refusal([] { contact::require_restitution("e", 0.0); }).empty());
  CHECK(refusal([] { contact::require_restitution("e", 1.0); }).empty());
}
