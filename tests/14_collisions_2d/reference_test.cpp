// Every reference function of the chapter against rational arithmetic on the stored numbers, with
// one square root where there is one. u is the unit roundoff of the type. A bound that a comment of
// the reference gives is tested as it stands, without an allowance.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <contact/billiard_table.hpp>
#include <contact/disc_collision.hpp>
#include <contact/disc_events.hpp>
#include <contact/momentum_triangle.hpp>
#include <contact/pieces.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::Disc;
using contact::Vector2;
using contact::Vector3;
using generators::any_finite;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using rounding::error;
using rounding::gamma;
using rounding::u;

namespace {

/// √x rounded up a little: for bounds only.
Rational root_up(const Rational& x) { return oracle::enclose(Surd{0, 1, x}, 64).high; }

struct Pair {
  Rational dx, dy, wx, wy, reach;
  Rational distance2() const { return dx * dx + dy * dy; }
  Rational speed2() const { return wx * wx + wy * wy; }
  Rational gap() const { return distance2() - reach * reach; }
  Rational approach() const { return -(dx * wx + dy * wy); }
  Rational depth() const {
    const Rational cross = dx * wy - dy * wx;
    return reach * reach * speed2() - cross * cross;
  }
};
template <class S>
Pair exact_pair(const Disc<S>& a, const Disc<S>& b) {
  using oracle::exact;
  return {exact(a.centre.x()) - exact(b.centre.x()), exact(a.centre.y()) - exact(b.centre.y()),
          exact(a.velocity.x()) - exact(b.velocity.x()),
          exact(a.velocity.y()) - exact(b.velocity.y()), exact(a.radius) + exact(b.radius)};
}

template <class S>
Vector2<S> vector_of(Random& random, double size) {
  return Vector2<S>{static_cast<S>(random.uniform(-size, size)),
                    static_cast<S>(random.uniform(-size, size))};
}

enum class Kind { anywhere, touching, grazing, grid, far };
constexpr std::array<Kind, 5> all_kinds{Kind::anywhere, Kind::touching, Kind::grazing, Kind::grid,
                                        Kind::far};

/// Two discs: anywhere; with the centres as far apart as the radii, to rounding; on paths that
/// graze to within a few ulps; on whole numbers; touching and far from the origin.
template <class S>
std::array<Disc<S>, 2> pair_of(Random& random, Kind kind) {
  const auto number = [&](double low, double high) {
    return static_cast<S>(random.uniform(low, high));
  };
  Disc<S> a{number(0.1, 9), number(0.1, 1), vector_of<S>(random, 3), vector_of<S>(random, 5)};
  Disc<S> b{number(0.1, 9), number(0.1, 1), vector_of<S>(random, 3), vector_of<S>(random, 5)};
  if (kind == Kind::grid) {
    const auto whole = [&] { return S(random.integer(-4, 4)); };
    a.centre = Vector2<S>{whole(), whole()};
    b.centre = Vector2<S>{whole(), whole()};
    a.velocity = Vector2<S>{whole(), whole()};
    b.velocity = Vector2<S>{whole(), whole()};
    a.radius = S(random.integer(0, 3));
    b.radius = S(random.integer(0, 3));
    return {a, b};
  }
  if (kind == Kind::far) b.centre += vector_of<S>(random, 1e6);
  if (kind == Kind::touching || kind == Kind::far) {
    const auto n = contact::line_of_centres(vector_of<S>(random, 1), Vector2<S>(S(0), S(2)));
    a.centre = b.centre + *n * S(a.radius + b.radius);
  }
  if (kind == Kind::grazing) {
    const auto n = *contact::line_of_centres(vector_of<S>(random, 1), Vector2<S>(S(0), S(2)));
    const Vector2<S> along{-n.y(), n.x()};
    S reach = a.radius + b.radius;
    for (int k = random.integer(-3, 3); k != 0; k += k > 0 ? -1 : 1) {
      reach = std::nextafter(reach, k > 0 ? S(9) : S(0));
    }
    a.centre = b.centre + n * reach - along * number(0.1, 4);
    a.velocity = b.velocity + along * number(0.1, 4);
  }
  return {a, b};
}

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

TEMPLATE_TEST_CASE("whether discs approach is decided right for every finite input", "", float,
                   double) {
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
    CHECK(error(parts.across.x(), oracle::exact(v.x()) - along * x) <= 16 * u<S>() * size);
    CHECK(error(parts.across.y(), oracle::exact(v.y()) - along * y) <= 16 * u<S>() * size);
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
      // What is conserved: momentum to the errors of the velocities, energy as e says.
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
  CHECK(product(2, 1, {0, 0}) < -0.1);   // wider
  CHECK(product(0.5, 1, {0, 0}) > 0.1);  // narrower
  CHECK(product(1, 0.5, {0, 0}) > 0.1);
  CHECK(std::abs(product(2, 0.5, {0, 0})) < 1e-15);
  // For a target that moves, v_A'·v_B' is what v_A·v_B was.
  CHECK(std::abs(product(1, 1, {0.5, 0.5}) - 1) < 1e-14);
  CHECK(std::abs(product(1, 1, {0, 0.5})) < 1e-14);
}

TEST_CASE("special cases of a collision") {
  using D = Disc<double>;
  // Head-on equals exchange their velocities exactly.
  auto after = contact::collide_discs(D{2, 1, {-1, 0}, {3, 0}}, D{2, 1, {1, 0}, {-1, 0}}, 1.0);
  CHECK(after.velocity_a == Vector2<double>(-1, 0));
  CHECK(after.velocity_b == Vector2<double>(3, 0));
  // A second look at the same discs finds them parting.
  const auto again = contact::collide_discs(D{2, 1, {-1, 0}, after.velocity_a},
                                            D{2, 1, {1, 0}, after.velocity_b}, 1.0);
  CHECK_FALSE(again.hit);
  // No axis.
  CHECK_FALSE(contact::collide_discs(D{1, 1, {2, 3}, {1, 0}}, D{1, 1, {2, 3}, {-1, 0}}, 1.0).hit);
  // A disc that nothing turns.
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

TEST_CASE("what is no disc is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_NOTHROW(contact::disc<double>(1, 0, {0, 0}, {0, 0}));
  CHECK_THROWS_AS(contact::disc<double>(0, 1, {0, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, -1, {0, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, nan, {0, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, 1, {nan, 0}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::disc<double>(1, 1, {0, 0}, {0, nan}), std::invalid_argument);
}

TEMPLATE_TEST_CASE("shares of a momentum are those of rational arithmetic", "", float, double) {
  using S = TestType;
  Random random(6);
  int parallel = 0;
  for (int i = 0; i < 600; ++i) {
    Vector2<S> total = vector_of<S>(random, 9);
    Vector2<S> a = vector_of<S>(random, 1);
    Vector2<S> b = vector_of<S>(random, 1);
    if (i % 4 == 1) b = a * S(random.integer(-3, 3));
    if (i % 4 == 2) b = Vector2<S>{std::nextafter(a.x(), S(2)), a.y()};
    if (i % 4 == 3) {
      a = contact::detail::times_power<S>(a, -60);
      total = contact::detail::times_power<S>(total, 90);
    }
    if (b == Vector2<S>::Zero()) continue;
    const auto cross = [](const Vector2<S>& x, const Vector2<S>& y) {
      return Rational(oracle::exact(x.x()) * oracle::exact(y.y()) -
                      oracle::exact(x.y()) * oracle::exact(y.x()));
    };
    const Rational sine = cross(a, b);
    const auto got = contact::share_momentum(total, a, b);
    REQUIRE(got.has_value() == (sine != 0));
    if (!got) {
      ++parallel;
      continue;
    }
    for (int k = 0; k < 2; ++k) {
      const Rational right_a = cross(total, b) / sine * oracle::exact(a(k));
      const Rational right_b = cross(a, total) / sine * oracle::exact(b(k));
      CHECK(error(got->a(k), right_a) <= 10 * u<S>() * abs(right_a));
      CHECK(error(got->b(k), right_b) <= 10 * u<S>() * abs(right_b));
    }
  }
  CHECK(parallel > 50);
  const auto none = contact::share_momentum<Rational>({1, 0}, {1, 2}, {2, 4});
  CHECK_FALSE(none);
  const auto exact = contact::share_momentum<Rational>({1, 0}, {1, 1}, {1, -2});
  REQUIRE(exact);
  CHECK(exact->a + exact->b == Vector2<Rational>(1, 0));
}

TEST_CASE("pieces that fly apart keep the momentum and gain the energy") {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const double m1 = random.uniform(0.1, 240);
    const double m2 = random.uniform(0.1, 9);
    const double energy = i % 5 == 0 ? 0 : random.uniform(0, 1e3);
    const Vector3<double> v{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Vector3<double> way{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    const auto after = contact::fly_apart<double>(m1, m2, v, energy, way);
    const Rational a = oracle::exact(m1);
    const Rational b = oracle::exact(m2);
    Rational gained = 0;
    Rational size = 0;
    for (int k = 0; k < 3; ++k) {
      const Rational before = oracle::exact(v(k));
      const Rational first = oracle::exact(after.first(k));
      const Rational second = oracle::exact(after.second(k));
      const Rational scale = a * (abs(before) + abs(first)) + b * (abs(before) + abs(second));
      CHECK(abs(a * first + b * second - (a + b) * before) <= 16 * u<double>() * scale);
      gained += (a * first * first + b * second * second - (a + b) * before * before) / 2;
      size += a * first * first + b * second * second + (a + b) * before * before;
    }
    // Velocities off by a few u each: energies by twice as much of themselves.
    CHECK(abs(gained - oracle::exact(energy)) <= 32 * u<double>() * (size + oracle::exact(energy)));
    const Vector3<double> apart = after.second - after.first;
    CHECK(std::abs(contact::energy_apart<double>(m1, m2, apart) - energy) <=
          64 * 0x1p-53 * (energy + oracle::nearest(size)));
  }
  CHECK_THROWS_AS(contact::fly_apart<double>(1, 1, {0, 0, 0}, -1, {1, 0, 0}),
                  std::invalid_argument);
  CHECK_THROWS_AS(contact::fly_apart<double>(1, 1, {0, 0, 0}, 1, {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::fly_apart<double>(0, 1, {0, 0, 0}, 1, {1, 0, 0}), std::invalid_argument);
}

TEMPLATE_TEST_CASE("the time to the touch is decided right and rounded little", "", float, double) {
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
    if (i % 11 == 7) {  // slow giants, fast dwarfs: squares of one kind vanish, of the other do not
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

TEST_CASE("far apart and very slow, or very near and fast, two discs touch as they do at hand") {
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

TEST_CASE("on a table each event is a true touch, and energy and order are kept") {
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
    // 66 u of the velocities an event, and twice that of the energy.
    CHECK(std::abs(energy() - before) <= events * 4 * 66 * 2 * 0x1p-53 * before);
  }
}

TEST_CASE("fixed steps find a touch late, and miss a fast one") {
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
