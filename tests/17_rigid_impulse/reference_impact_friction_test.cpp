// impact_friction.hpp: impacts with friction by Newton's, Poisson's and Stronge's laws, in exact
// fractions.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impact_friction.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_body.hpp>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Vector3;
using generators::Random;
using oracle::Rational;
using reference::fraction;
using reference::positive;
using reference::u;

namespace {

contact::PlanarContact<Rational> random_contact(Random& random) {
  contact::PlanarContact<Rational> c;
  c.slip = random.chance(0.1) ? Rational(0) : fraction(random);
  c.normal = -positive(random);
  c.k_tt = positive(random);
  c.k_nn = positive(random);
  do {
    c.k_tn = fraction(random) / 4;
  } while (!(c.k_tn * c.k_tn < c.k_tt * c.k_nn));
  return c;
}

/// Every path: velocities follow from impulses, and Coulomb's law holds on each segment.
void check_path(const contact::PlanarContact<Rational>& c, const contact::Impact<Rational>& impact,
                const Rational& friction) {
  for (std::size_t i = 0; i < impact.count; ++i) {
    const auto& p = impact.path[i];
    REQUIRE(p.slip == c.slip + c.k_tt * p.tangential + c.k_tn * p.impulse);
    REQUIRE(p.normal == c.normal + c.k_tn * p.tangential + c.k_nn * p.impulse);
    if (i == 0) continue;
    const auto& q = impact.path[i - 1];
    const Rational dn = p.impulse - q.impulse;
    const Rational dt = p.tangential - q.tangential;
    REQUIRE(dn >= 0);
    REQUIRE(abs(dt) <= friction * dn);
    const Rational slip = p.slip + q.slip;  // of one sign on the whole segment
    REQUIRE(p.slip * q.slip >= 0);
    if (slip != 0 && dn > 0) REQUIRE(dt == (slip > 0 ? Rational(-friction) : friction) * dn);
  }
}

}  // namespace

TEST_CASE("impacts with friction obey Coulomb's law at every moment, and each law its own rule") {
  Random random(1712);
  int newton_gains = 0;
  int reversed = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto c = random_contact(random);
    const Rational e = Rational(random.integer(0, 4)) / 4;
    const Rational friction = Rational(random.integer(0, 8)) / 4;
    const auto newton = contact::newton_impact(c, e, friction);
    const auto poisson = contact::poisson_impact(c, e, friction);
    check_path(c, newton, friction);
    check_path(c, poisson, friction);
    REQUIRE(newton.end().normal == -e * c.normal);
    // Up to greatest compression the two agree.
    std::size_t turn = 0;
    while (newton.path[turn].normal != 0 || turn == 0) ++turn;
    REQUIRE(poisson.path[turn].impulse == newton.path[turn].impulse);
    REQUIRE(poisson.end().impulse == (1 + e) * poisson.path[turn].impulse);
    REQUIRE(contact::energy_change(poisson) <= 0);
    newton_gains += contact::energy_change(newton) > 0;
    reversed += newton.end().slip * c.slip < 0;

    const contact::PlanarContact<double> d{oracle::nearest(c.slip), oracle::nearest(c.normal),
                                           oracle::nearest(c.k_tt), oracle::nearest(c.k_tn),
                                           oracle::nearest(c.k_nn)};
    const double ed = oracle::nearest(e);
    const auto stronge = contact::stronge_impact(d, ed, oracle::nearest(friction));
    // Greatest compression of the stored contact; e² of its work is given back.
    std::size_t middle = 1;
    while (stronge.path[middle].normal != 0) ++middle;
    const double pressed = -contact::detail::normal_work(stronge, 0, middle);
    const double back = contact::detail::normal_work(stronge, middle, stronge.count - 1);
    // Segments of opposite sign do not occur after greatest compression; before it the work can
    // cancel by as much as friction closes the contact.
    double size = 0;
    for (std::size_t k = 0; k + 1 < stronge.count; ++k) {
      size += (std::abs(stronge.path[k].normal) + std::abs(stronge.path[k + 1].normal)) *
              stronge.path[k + 1].impulse;
    }
    REQUIRE(std::abs(back - ed * ed * pressed) <= 64 * u * size);
    REQUIRE(contact::energy_change(stronge) <= 64 * u * size * 4);
    // Without coupling or friction all three are equivalent.
    auto plain = c;
    if (i % 2 == 0) plain.k_tn = 0;
    const Rational none = i % 2 == 0 ? friction : Rational(0);
    const auto one = contact::newton_impact(plain, e, none);
    const auto two = contact::poisson_impact(plain, e, none);
    REQUIRE(one.end().impulse == two.end().impulse);
    REQUIRE(one.end().tangential == two.end().tangential);
    REQUIRE(contact::energy_change(one) <= 0);
  }
  CHECK(newton_gains > 20);
  CHECK(reversed > 20);
}

TEST_CASE("Stronge's law is Newton's and Poisson's without coupling") {
  Random random(1713);
  for (int i = 0; i < 500; ++i) {
    const contact::PlanarContact<double> c{random.uniform(-3, 3), -random.uniform(0.1, 3),
                                           random.uniform(0.2, 3), 0, random.uniform(0.2, 3)};
    const double e = random.uniform();
    const double friction = random.uniform(0, 2);
    const auto one = contact::newton_impact(c, e, friction).end();
    const auto other = contact::stronge_impact(c, e, friction).end();
    CHECK(std::abs(one.impulse - other.impulse) <= 32 * u * one.impulse);
    CHECK(std::abs(one.tangential - other.tangential) <=
          64 * u * (friction * one.impulse + std::abs(c.slip) / c.k_tt));
  }
}

TEST_CASE("the rod that gains energy: 1 kg, 2 m, at 45 degrees, its end meeting the floor") {
  // The lower right end of the rod at (−0.6, −1) m/s, ω = −1 rad/s, μ = 1/2, e = 1. In fractions:
  // r = (s, −s) with s² = 1/2 and I = 1/3, so k_tt = k_nn = 5/2 and k_tn = 3/2. The centre moves at
  // v = (s − 3/5, s − 1), and the energy before is ½|v|² + ½ I ω².
  const contact::PlanarContact<Rational> c{Rational(-3) / 5, -1, Rational(5) / 2, Rational(3) / 2,
                                           Rational(5) / 2};
  const double s = std::sqrt(0.5);
  const double before = ((s - 0.6) * (s - 0.6) + (s - 1) * (s - 1)) / 2 + 1.0 / 6;
  const auto factor = [&](const contact::Impact<Rational>& impact) {
    return 1 + oracle::nearest(contact::energy_change(impact)) / before;
  };
  const Rational half = Rational(1) / 2;
  const auto joint = contact::joint_impact<Rational>(c, 1, half);
  REQUIRE(joint.has_value());
  CHECK(joint->end().slip == 0);
  CHECK(contact::energy_change(*joint) == Rational(9) / 80);  // 0.1125 J
  CHECK(std::abs(factor(*joint) - 1.52) < 0.005);
  const auto newton = contact::newton_impact<Rational>(c, 1, half);
  CHECK(newton.end().normal == 1);
  CHECK(std::abs(factor(newton) - 1.25) < 0.005);
  CHECK(std::abs(factor(contact::poisson_impact<Rational>(c, 1, half)) - 0.59) < 0.005);
  const contact::PlanarContact<double> d{-0.6, -1, 2.5, 1.5, 2.5};
  CHECK(std::abs(1 + contact::energy_change(contact::stronge_impact(d, 1.0, 0.5)) / before - 0.74) <
        0.005);
  // The slip stops and, since μ is below k_tn/k_tt = 3/5, reverses.
  REQUIRE(newton.count == 4);
  CHECK(newton.path[1].slip == 0);
  CHECK(newton.path[3].slip > 0);
  // Friction after the normal impulse: e = 1 is demanded, and the result differs.
  const auto clamped = contact::clamped_impact<Rational>(c, 1, half);
  REQUIRE(clamped.count == 3);
  CHECK(clamped.path[1].normal == 1);
  CHECK(clamped.end().normal == Rational(16) / 25);  // p_t is −0.24 N·s: 1 − 1.5 · 0.24
}

TEST_CASE("the planar contact of a rod agrees with that of its two bodies") {
  const double s = std::sqrt(0.5);
  const double inertia = 1.0 * 2 * 2 / 12;
  const Vector3<double> r(s, -s, 0);
  const Vector3<double> w(0, 0, -1);
  const auto rod =
      contact::rigid_body<double>(1, contact::detail::diagonal<double>(inertia, inertia, inertia),
                                  {0, s, 0}, Vector3<double>(-0.6, -1, 0) - w.cross(r), w);
  const auto floor = contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  const auto c = contact::planar_contact<double>(rod, floor, {{s, 0, 0}, {0, 1, 0}}, {1, 0, 0});
  CHECK(std::abs(c.slip + 0.6) <= 8 * u);
  CHECK(std::abs(c.normal + 1) <= 8 * u);
  CHECK(std::abs(c.k_tt - 2.5) <= 32 * u);
  CHECK(std::abs(c.k_tn - 1.5) <= 32 * u);
  CHECK(std::abs(c.k_nn - 2.5) <= 32 * u);
  const double before = contact::kinetic_energy(rod);
  const auto impact = contact::newton_impact(c, 1.0, 0.5);
  const auto after = contact::after_impulse<double>(
      rod, {impact.end().tangential, impact.end().impulse, 0}, {s, 0, 0});
  CHECK(std::abs(contact::kinetic_energy(after) - before - contact::energy_change(impact)) <=
        64 * u);
  CHECK(std::abs(contact::kinetic_energy(after) / before - 1.25) < 0.005);
}

TEST_CASE("an impact that does not close, or jams at first, has an answer") {
  const contact::PlanarContact<Rational> apart{1, 1, 1, 0, 1};
  CHECK(contact::newton_impact<Rational>(apart, 1, 1).count == 1);
  CHECK(contact::poisson_impact<Rational>(apart, 1, 1).count == 1);
  CHECK(contact::clamped_impact<Rational>(apart, 1, 1).count == 1);
  CHECK(contact::energy_change(contact::joint_impact<Rational>(apart, 1, 1).value()) == 0);
  // Jamming: friction closes the contact, k_nn − μ k_tn = 1 − 2·3/4 < 0 during the slip.
  const contact::PlanarContact<Rational> jam{1, -1, 1, Rational(3) / 4, 1};
  const auto impact = contact::poisson_impact<Rational>(jam, 1, 2);
  check_path(jam, impact, 2);
  REQUIRE(impact.count == 4);
  CHECK(impact.path[1].normal < -1);  // closing faster than at the first touch
  CHECK(impact.end().normal > 0);
  CHECK(contact::energy_change(impact) < 0);
}
