// disc_collision.hpp against rational arithmetic on the stored numbers, with one square root where
// there is one. u is the unit roundoff of the type. A bound that a comment of
// the reference gives is tested as it stands, without an allowance.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/disc_collision.hpp>
#include <limits>
#include <stdexcept>

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

namespace {

/// √x, slightly rounded up: for bounds only.
Rational root_up(const Rational& x) { return oracle::enclose(Surd{0, 1, x}, 64).high; }

}  // namespace

TEMPLATE_TEST_CASE("the line of centres has length 1 and the right direction", "", float, double) {
  using S = TestType;
  Random random(1);
  for (int i = 0; i < 600; ++i) {
    Vector2<S> a = vector_of<S>(random, 4);
    Vector2<S> b = vector_of<S>(random, 4);
    if (i % 4 == 1) b = a + vector_of<S>(random, 1e-6);
    if (i % 4 == 2) {
      a = Vector2<S>{any_finite<S>(random), any_finite<S>(random)};
      b = Vector2<S>{any_finite<S>(random), any_finite<S>(random)};
    }
    if (i % 4 == 3) {
      a = Vector2<S>{std::numeric_limits<S>::denorm_min() * S(random.integer(0, 9)), S(0)};
      b = Vector2<S>{S(0), std::numeric_limits<S>::denorm_min() * S(random.integer(0, 9))};
    }
    const auto axis = contact::line_of_centres(a, b);
    REQUIRE(axis.has_value() == (a != b));
    if (!axis) continue;
    const Rational dx = oracle::exact(a.x()) - oracle::exact(b.x());
    const Rational dy = oracle::exact(a.y()) - oracle::exact(b.y());
    const Rational square = dx * dx + dy * dy;
    for (const auto& [got, d] : {std::pair(axis->x(), dx), std::pair(axis->y(), dy)}) {
      const Surd right = oracle::divided_by_root(d, square);
      CHECK(oracle::error(static_cast<double>(got), right) <=
            6 * static_cast<double>(contact::tolerance::unit_roundoff<S>));
    }
  }
}

TEMPLATE_TEST_CASE("approach is decided exactly for every finite input", "", float, double) {
  using S = TestType;
  Random random(2);
  int ties = 0;
  for (int i = 0; i < 1500; ++i) {
    auto [a, b] = pair_of<S>(random, all_kinds[static_cast<std::size_t>(i) % all_kinds.size()]);
    if (i % 3 == 1) {
      for (Vector2<S>* v : {&a.centre, &b.centre, &a.velocity, &b.velocity}) {
        *v = Vector2<S>{any_finite<S>(random), any_finite<S>(random)};
      }
    }
    if (i % 3 == 2) {
      const Vector2<S> d = a.centre - b.centre;
      a.velocity = b.velocity + Vector2<S>{-d.y(), d.x()};  // tangential, or nearly
    }
    const int right = -oracle::sign(exact_pair(a, b).approach());
    ties += right == 0;
    CHECK(contact::closing_sign(a, b) == right);
    CHECK(contact::approaching(a, b) == (right < 0));
  }
  CHECK(ties > 20);
}

TEST_CASE("an exact type decides the same way") {
  const Disc<Rational> a{1, 1, {Rational(1, 3), 0}, {-1, 0}};
  const Disc<Rational> b{1, 1, {0, 0}, {0, 0}};
  CHECK(contact::closing_sign(a, b) == -1);
  CHECK(contact::kinetic_energy(a) == Rational(1, 2));
}

TEMPLATE_TEST_CASE("components add up to the velocity", "", float, double) {
  using S = TestType;
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const auto n = *contact::line_of_centres(vector_of<S>(random, 1), Vector2<S>(S(2), S(0)));
    const Vector2<S> v = vector_of<S>(random, 9);
    const auto parts = contact::components(v, n);
    const Rational x = oracle::exact(n.x());
    const Rational y = oracle::exact(n.y());
    const Rational along = (x * oracle::exact(v.x()) + y * oracle::exact(v.y())) / (x * x + y * y);
    const Rational size = root_up(oracle::exact(v.x()) * oracle::exact(v.x()) +
                                  oracle::exact(v.y()) * oracle::exact(v.y()));
    CHECK(error(parts.normal, along) <= 16 * u<S>() * size);
    CHECK(error(parts.tangential.x(), oracle::exact(v.x()) - along * x) <= 16 * u<S>() * size);
    CHECK(error(parts.tangential.y(), oracle::exact(v.y()) - along * y) <= 16 * u<S>() * size);
  }
}

TEMPLATE_TEST_CASE("velocities after a collision are those of rational arithmetic", "", float,
                   double) {
  using S = TestType;
  Random random(4);
  int hits = 0;
  for (int i = 0; i < 800; ++i) {
    auto [a, b] = pair_of<S>(random, all_kinds[static_cast<std::size_t>(i) % all_kinds.size()]);
    if (i % 7 == 3) a.mass = static_cast<S>(a.mass * S(1e12));
    const S e = i % 3 == 0 ? S(1) : i % 3 == 1 ? S(0) : static_cast<S>(random.uniform());
    const auto after = contact::collide_discs(a, b, e);
    const Pair p = exact_pair(a, b);
    const bool hit = p.approach() > 0;
    CHECK(after.hit == hit);
    if (!hit) {
      CHECK(after.velocity_a == a.velocity);
      CHECK(after.velocity_b == b.velocity);
      CHECK(after.impulse == Vector2<S>::Zero());
      continue;
    }
    ++hits;
    const Rational ma = oracle::exact(a.mass);
    const Rational mb = oracle::exact(b.mass);
    const Rational push = (1 + oracle::exact(e)) * p.approach() / p.distance2();
    const Rational room = 64 * u<S>() * root_up(p.speed2());
    Rational before = 0;
    Rational energy = 0;
    Rational energy_after = 0;
    Rational energy_room = 0;
    for (int k = 0; k < 2; ++k) {
      const Rational d = k == 0 ? p.dx : p.dy;
      const Rational va = oracle::exact(a.velocity(k)) + push * d * mb / (ma + mb);
      const Rational vb = oracle::exact(b.velocity(k)) - push * d * ma / (ma + mb);
      const Rational room_a = room + 2 * u<S>() * abs(va);
      const Rational room_b = room + 2 * u<S>() * abs(vb);
      CHECK(error(after.velocity_a(k), va) <= room_a);
      CHECK(error(after.velocity_b(k), vb) <= room_b);
      CHECK(error(after.impulse(k), push * d * ma * mb / (ma + mb)) <= room * ma * mb / (ma + mb));
      // Momentum is conserved up to the errors of the velocities; energy is as e says.
      const Rational wa = oracle::exact(after.velocity_a(k));
      const Rational wb = oracle::exact(after.velocity_b(k));
      const Rational drift =
          ma * (wa - oracle::exact(a.velocity(k))) + mb * (wb - oracle::exact(b.velocity(k)));
      CHECK(abs(drift) <= ma * room_a + mb * room_b);
      energy += ma * oracle::exact(a.velocity(k)) * oracle::exact(a.velocity(k)) / 2 +
                mb * oracle::exact(b.velocity(k)) * oracle::exact(b.velocity(k)) / 2;
      energy_after += (ma * wa * wa + mb * wb * wb) / 2;
      // ½ m (v + r)² − ½ m v² ≤ m |v| r + ½ m r².
      energy_room +=
          ma * (abs(va) * room_a + room_a * room_a) + mb * (abs(vb) * room_b + room_b * room_b);
    }
    const Rational k = oracle::exact(e);
    const Rational lost =
        ma * mb / (ma + mb) * (1 - k * k) * p.approach() * p.approach() / p.distance2() / 2;
    CHECK(abs(energy - lost - energy_after) <= energy_room);
  }
  CHECK(hits > 200);
}

TEST_CASE("equal smooth discs, elastic, one at rest, leave at right angles") {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Disc<double> a{1, 0.5, vector_of<double>(random, 1), vector_of<double>(random, 5)};
    const Disc<double> b{1, 0.5, {0, 0}, {0, 0}};
    const auto after = contact::collide_discs(a, b, 1.0);
    const double speed2 = a.velocity.squaredNorm();
    // Each velocity is off by 66 u |v| at most in each of two coordinates.
    const double room = 2 * std::sqrt(2.0) * 66 * 0x1p-53 * speed2 * 1.001;
    CHECK(std::abs(after.velocity_a.dot(after.velocity_b)) <= room);
  }
  // Not so for unequal masses or for e < 1, unless m_A = e m_B.
  const Disc<double> a{1, 0.5, {-0.6, -0.8}, {2, 0}};
  const auto product = [&](double mass, double e, Vector2<double> velocity) {
    const Disc<double> b{mass, 0.5, {0, 0}, velocity};
    const auto after = contact::collide_discs(a, b, e);
    return after.velocity_a.dot(after.velocity_b);
  };
  CHECK(std::abs(product(1, 1, {0, 0})) < 1e-15);
  CHECK(product(2, 1, {0, 0}) < -0.1);   // larger than 90°
  CHECK(product(0.5, 1, {0, 0}) > 0.1);  // smaller than 90°
  CHECK(product(1, 0.5, {0, 0}) > 0.1);
  CHECK(std::abs(product(2, 0.5, {0, 0})) < 1e-15);
  // For a moving target, v_A'·v_B' = v_A·v_B.
  CHECK(std::abs(product(1, 1, {0.5, 0.5}) - 1) < 1e-14);
  CHECK(std::abs(product(1, 1, {0, 0.5})) < 1e-14);
}

TEST_CASE("special cases of a collision") {
  using D = Disc<double>;
  // Equal discs exchange their velocities exactly if head-on.
  auto after = contact::collide_discs(D{2, 1, {-1, 0}, {3, 0}}, D{2, 1, {1, 0}, {-1, 0}}, 1.0);
  CHECK(after.velocity_a == Vector2<double>(-1, 0));
  CHECK(after.velocity_b == Vector2<double>(3, 0));
  // A second test of the same discs finds them separating.
  const auto again = contact::collide_discs(D{2, 1, {-1, 0}, after.velocity_a},
                                            D{2, 1, {1, 0}, after.velocity_b}, 1.0);
  CHECK_FALSE(again.hit);
  // No axis.
  CHECK_FALSE(contact::collide_discs(D{1, 1, {2, 3}, {1, 0}}, D{1, 1, {2, 3}, {-1, 0}}, 1.0).hit);
  // An immovable disc.
  const double wall = std::numeric_limits<double>::infinity();
  after = contact::collide_discs(D{1, 1, {-1, 0}, {3, 2}}, D{wall, 1, {1, 0}, {0, 0}}, 1.0);
  CHECK(after.velocity_a == Vector2<double>(-3, 2));
  CHECK(after.velocity_b == Vector2<double>(0, 0));
  // Near the largest number.
  after =
      contact::collide_discs(D{1, 1, {0, -1}, {1, 1.7e308}}, D{1, 1, {0, 1}, {2, -1.7e308}}, 1.0);
  CHECK(after.velocity_a == Vector2<double>(1, -1.7e308));
  CHECK(after.velocity_b == Vector2<double>(2, 1.7e308));
  CHECK(contact::off_cushion<double>({3, 2}, {-1, 0}, 0.5) == Vector2<double>(-1.5, 2));
  CHECK(contact::off_cushion<double>({-3, 2}, {-1, 0}, 0.5) == Vector2<double>(-3, 2));
}

TEST_CASE("invalid discs are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_NOTHROW(contact::disc<double>(1, 0, {0, 0}, {0, 0}));
  CHECK_THROWS_AS(contact::disc<double>(0, 1, {0, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, -1, {0, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, nan, {0, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, 1, {nan, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, 1, {0, 0}, {0, nan}), std::invalid_argument);
}
