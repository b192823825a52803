// Translating bodies: every answer is proved by the exact check of its proof, and the times of
// polytopes and of spheres are those of fractions.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/sphere_sphere_impact.hpp>
#include <contact/translating_impact.hpp>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "boxes.hpp"
#include "moving_bodies.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace translating_impact_test {
namespace {

using contact::translating_impact;
using contact::TranslatingImpact;
using generators::Random;
using generators::tried;
using moving_bodies::Family;
using moving_bodies::Pair;
using moving_bodies::V;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TranslatingImpact impact_of(const Pair& pair) {
  return std::visit(
      [&](const auto& a, const auto& b) {
        return translating_impact(a, pair.displacement_a, b, pair.displacement_b);
      },
      pair.a, pair.b);
}

/// Whether the proofs of an answer hold.
bool is_proved(const Pair& pair, const TranslatingImpact& found) {
  return std::visit(
      [&](const auto& a, const auto& b) {
        const V &u = pair.displacement_a, &v = pair.displacement_b;
        if (!found.meets) {
          return found.t == 1 && contact::separates_throughout(found.plane, a, u, b, v);
        }
        return contact::separates_until(found.plane, a, u, b, v, found.t) &&
               contact::meeting_proved_between(found.common, a, u, b, v, found.t, found.t_high);
      },
      pair.a, pair.b);
}

bool is_narrow(const TranslatingImpact& found) {
  return found.t_high - found.t <= 0x1p-40 * found.t_high ||
         std::nextafter(found.t, 1) >= found.t_high;
}

TEST_CASE("translating bodies of all kinds: no answer without a proof that holds") {
  Random random(11);
  std::array<int, moving_bodies::families.size()> meetings{}, others{};
  for (int i = 0; i < tried(10500); ++i) {
    const auto family = static_cast<std::size_t>(i) % moving_bodies::families.size();
    const int kind_a = random.integer(0, moving_bodies::kinds - 1);
    const int kind_b = random.integer(0, moving_bodies::kinds - 1);
    const Pair pair = moving_bodies::make(random, moving_bodies::families[family], kind_a, kind_b);
    const TranslatingImpact found = impact_of(pair);
    INFO("pair " << i << ", family " << family << ", kinds " << kind_a << " and " << kind_b);
    INFO("meets " << found.meets << ", t " << found.t << " to " << found.t_high);
    REQUIRE(is_proved(pair, found));
    if (found.meets) REQUIRE(is_narrow(found));
    CHECK_FALSE(std::signbit(found.t));
    (found.meets ? meetings : others)[family] += 1;
  }
  for (std::size_t k = 0; k < moving_bodies::families.size(); ++k) {
    INFO("family " << k);
    CHECK(meetings[k] > tried(100));
    CHECK(others[k] > tried(100));
  }
}

TEST_CASE("translating bodies that meet at the end of the step, up to some ulps: proved as well") {
  Random random(16);
  int meetings = 0, others = 0;
  for (int i = 0; i < tried(9000); ++i) {
    const Family family = i % 2 == 0 ? Family::plain : Family::flat;
    // Most pairs are of two boxes, whose vertices are rounded the most.
    const int kind_a = i % 4 < 3 ? 3 : random.integer(0, moving_bodies::kinds - 1);
    const int kind_b = i % 4 < 3 ? 3 : random.integer(0, moving_bodies::kinds - 1);
    Pair pair = moving_bodies::make(random, family, kind_a, kind_b);
    const TranslatingImpact whole = impact_of(pair);
    if (!whole.meets || whole.t == 0) continue;
    const double share = whole.t * (1 + random.integer(0, 64) * 0x1p-52);
    pair.displacement_a *= share;
    pair.displacement_b *= share;
    const TranslatingImpact found = impact_of(pair);
    INFO("pair " << i << ", kinds " << kind_a << " and " << kind_b);
    INFO("meets " << found.meets << ", t " << found.t << " to " << found.t_high);
    REQUIRE(is_proved(pair, found));
    ++(found.meets ? meetings : others);
  }
  CHECK(meetings > tried(300));
  CHECK(others > tried(300));
}

// ---------------------------------------------------------------- against other answers

contact::OrientedBox<double> oriented(const boxes::Box& box) {
  return {box.frame.origin, box.frame.axes, box.half_lengths};
}

TEST_CASE("translating boxes as bodies: decision and time are those of fractions") {
  Random random(12);
  int meetings = 0;
  int others = 0;
  for (int i = 0; i < tried(800); ++i) {
    const auto [a, b] = boxes::make(random, boxes::all_kinds[static_cast<std::size_t>(i) % 8]);
    const auto right = boxes::first_touch(a, b);
    const TranslatingImpact found =
        translating_impact(oriented(a), a.displacement, oriented(b), b.displacement);
    INFO("pair " << i);
    REQUIRE(found.meets == right.has_value());
    (found.meets ? meetings : others) += 1;
    if (!right) continue;
    CHECK(oracle::exact(found.t) <= *right);
    CHECK(oracle::exact(found.t_high) >= *right);
  }
  CHECK(meetings > tried(200));
  CHECK(others > tried(200));
}

TEST_CASE("exchanged translating bodies meet at the same time, with another proof at most") {
  Random random(13);
  for (int i = 0; i < tried(700); ++i) {
    const Family family = moving_bodies::families[static_cast<std::size_t>(i) % 7];
    const int kind_a = random.integer(0, moving_bodies::kinds - 1);
    const int kind_b = random.integer(0, moving_bodies::kinds - 1);
    const Pair pair = moving_bodies::make(random, family, kind_a, kind_b);
    const Pair exchanged{pair.b, pair.a, pair.displacement_b, pair.displacement_a};
    const TranslatingImpact one = impact_of(pair), other = impact_of(exchanged);
    INFO("pair " << i);
    REQUIRE(one.meets == other.meets);
    // Both intervals have the time of impact.
    CHECK(one.t <= other.t_high);
    CHECK(other.t <= one.t_high);
  }
}

TEST_CASE("the time of translating bodies is the same from twice as far at twice the speed") {
  Random random(14);
  const std::array<double, 4> scales{0x1p-480, 0x1p-90, 0x1p200, 0x1p490};
  for (int i = 0; i < tried(280); ++i) {
    const int kind_a = random.integer(0, moving_bodies::kinds - 1);
    const int kind_b = random.integer(0, moving_bodies::kinds - 1);
    const Pair pair = moving_bodies::make(random, Family::plain, kind_a, kind_b);
    const double scale = scales[static_cast<std::size_t>(i) % 4];
    const int power = std::ilogb(scale);
    const auto times = [power](const auto& body) -> moving_bodies::Body {
      return contact::gjk_detail::times_power_of_two(body, power);
    };
    const Pair scaled{std::visit(times, pair.a), std::visit(times, pair.b),
                      pair.displacement_a * scale, pair.displacement_b * scale};
    const TranslatingImpact one = impact_of(pair), other = impact_of(scaled);
    INFO("pair " << i << " times " << scale);
    REQUIRE(is_proved(scaled, other));
    REQUIRE(one.meets == other.meets);
    CHECK(one.t <= other.t_high);
    CHECK(other.t <= one.t_high);
  }
}

TEST_CASE("translating bodies of floats meet as the same bodies of doubles") {
  Random random(15);
  for (int i = 0; i < tried(200); ++i) {
    const auto coordinates = [&]() { return V(moving_bodies::in_cube(random, 2)); };
    const V p = coordinates(), q = coordinates(), u = coordinates(), v = coordinates();
    using F = contact::Vector3<float>;
    const contact::Sphere<float> ball{p.cast<float>(), 0.5F};
    const contact::Capsule<float> rod{{q.cast<float>(), u.cast<float>()}, 0.25F};
    const F way = v.cast<float>();
    const TranslatingImpact single = translating_impact(ball, way, rod, F(0, 0, 0));
    const TranslatingImpact twice =
        translating_impact(contact::Sphere<double>{ball.centre.cast<double>(), 0.5},
                           V(way.cast<double>()), contact::in_double(rod), V(0, 0, 0));
    CHECK(single.meets == twice.meets);
    CHECK(single.t == twice.t);
  }
}

// ---------------------------------------------------------------- single cases

const contact::OrientedBox<double> unit_box{V(0, 0, 0), contact::Matrix3<double>::Identity(),
                                            V(1, 1, 1)};

contact::OrientedBox<double> box_at(const V& centre) {
  return {centre, contact::Matrix3<double>::Identity(), V(1, 1, 1)};
}

TEST_CASE("a face that touches another for the last instant of the step meets it") {
  const auto other = box_at(V(4, 0.5, 0.25));
  CHECK(translating_impact(unit_box, V(2, 0, 0), other, V(0, 0, 0)).meets);
  CHECK_FALSE(translating_impact(unit_box, V(std::nextafter(2, 0), 0, 0), other, V(0, 0, 0)).meets);
}

TEST_CASE("boxes that slide along each other meet from the start, one ulp apart never") {
  const TranslatingImpact along =
      translating_impact(unit_box, V(3, 0, 0), box_at(V(0, 2, 0)), V(0, 0, 0));
  CHECK(along.meets);
  CHECK(along.t == 0);
  CHECK(along.t_high == 0);
  CHECK_FALSE(
      translating_impact(unit_box, V(3, 0, 0), box_at(V(0, std::nextafter(2, 3), 0)), V(0, 0, 0))
          .meets);
}

TEST_CASE("spheres that graze for an instant between two doubles meet") {
  // Centres on parallel paths exactly two radii apart; closest at a third of the step.
  const contact::Sphere<double> a{V(-1, 2, 0), 1}, b{V(0, 0, 0), 1};
  const TranslatingImpact graze = translating_impact(a, V(3, 0, 0), b, V(0, 0, 0));
  REQUIRE(graze.meets);
  CHECK(graze.t <= 1.0 / 3);
  CHECK(graze.t_high >= 1.0 / 3);
  CHECK(is_narrow(graze));
  const contact::Sphere<double> above{V(-1, std::nextafter(2, 3), 0), 1};
  CHECK_FALSE(translating_impact(above, V(3, 0, 0), b, V(0, 0, 0)).meets);
}

TEST_CASE("overlapping bodies meet at 0, also while they move apart or are at rest") {
  const contact::Sphere<double> ball{V(0.5, 0, 0), 1};
  for (const V& way : {V(5, 0, 0), V(0, 0, 0), V(-5, 0, 0), V(1e300, 0, 0)}) {
    const TranslatingImpact found = translating_impact(ball, way, unit_box, V(0, 0, 0));
    CHECK(found.meets);
    CHECK(found.t == 0);
  }
}

TEST_CASE("a displacement of 1e300 is no reason to pass through a plate") {
  const contact::OrientedBox<double> plate{V(0, 0, 0), contact::Matrix3<double>::Identity(),
                                           V(1e-9, 5, 5)};
  const contact::Sphere<double> bullet{V(-8, 0, 0), 0x1p-30};
  const TranslatingImpact found = translating_impact(bullet, V(1e300, 0, 0), plate, V(0, 0, 0));
  REQUIRE(found.meets);
  CHECK(found.t <= 8e-300);
  CHECK(is_narrow(found));
}

TEST_CASE("points with a radius of the smallest number meet only if their paths are as close") {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const contact::Sphere<double> a{V(-1, 0, 0), least}, b{V(1, 2 * least, 0), least};
  CHECK(translating_impact(a, V(4, 0, 0), b, V(0, 0, 0)).meets);
  const contact::Sphere<double> beside{V(1, 3 * least, 0), least};
  CHECK_FALSE(translating_impact(a, V(4, 0, 0), beside, V(0, 0, 0)).meets);
}

TEST_CASE("what is no body, and a displacement that is not finite, meet nothing") {
  const contact::Sphere<double> ball{V(0, 0, 0), 1};
  for (const V& way : {V(nan, 0, 0), V(0, infinity, 0)}) {
    CHECK_FALSE(translating_impact(ball, way, ball, V(0, 0, 0)).meets);
    CHECK_FALSE(translating_impact(ball, V(0, 0, 0), ball, way).meets);
  }
  for (const contact::Sphere<double>& none :
       {contact::Sphere<double>{V(0, nan, 0), 1}, contact::Sphere<double>{V(0, 0, 0), -1}}) {
    CHECK_FALSE(translating_impact(none, V(0, 0, 0), ball, V(0, 0, 0)).meets);
    CHECK_FALSE(translating_impact(ball, V(0, 0, 0), none, V(0, 0, 0)).meets);
  }
  CHECK_FALSE(
      translating_impact(contact::ConvexHull<double>{}, V(0, 0, 0), ball, V(0, 0, 0)).meets);
}

// ---------------------------------------------------------------- the check of proofs

TEST_CASE("a plane proves a time until which it separates, and none later") {
  const contact::Sphere<double> a{V(0, 0, 0), 1}, b{V(4, 0, 0), 1};
  const V way(4, 0, 0), rest(0, 0, 0);
  contact::SeparatingPlane plane;
  plane.normal = V(-1, 0, 0);
  CHECK(contact::separates_until(plane, a, way, b, rest, 0.5));
  CHECK_FALSE(contact::separates_until(plane, a, way, b, rest, std::nextafter(0.5, 1)));
  CHECK_FALSE(contact::separates_until(plane, a, way, b, rest, nan));
  CHECK_FALSE(contact::separates_until(plane, a, way, b, rest, 2));
  CHECK_FALSE(contact::separates_throughout(plane, a, way, b, rest));
  // In the whole step, both ends included: a touch at the end is no separation.
  CHECK_FALSE(contact::separates_throughout(plane, a, V(2, 0, 0), b, rest));
  CHECK(contact::separates_throughout(plane, a, V(std::nextafter(2, 0), 0, 0), b, rest));
  plane.normal = V(1, 0, 0);  // the wrong side
  CHECK_FALSE(contact::separates_until(plane, a, way, b, rest, 0.5));
  CHECK_FALSE(contact::separates_until({}, a, way, b, rest, 0.5));
  CHECK(contact::separates_until({}, a, way, b, rest, 0));
  // Bodies that touch at the start are not separated before any later time.
  plane.normal = V(-1, 0, 0);
  CHECK_FALSE(
      contact::separates_until(plane, contact::Sphere<double>{V(2, 0, 0), 1}, rest, b, rest, 0.5));
}

TEST_CASE("vertices at a time prove a meeting only in an interval that has the time") {
  const contact::Sphere<double> a{V(0, 0, 0), 1}, b{V(4, 0, 0), 1};
  const V way(4, 0, 0), rest(0, 0, 0);
  contact::CommonPointInMotion common{1, {0}, {0}, {0.5}};
  const auto proved = [&](double from, double to) {
    return contact::meeting_proved_between(common, a, way, b, rest, from, to);
  };
  CHECK(proved(0.5, 0.5));
  CHECK(proved(0, 1));
  CHECK_FALSE(proved(0.6, 1));
  CHECK_FALSE(proved(0, 0.4));
  CHECK_FALSE(proved(-1, 1));
  CHECK_FALSE(proved(nan, 1));
  common.times[0] = std::nextafter(0.5, 0);  // not yet
  CHECK_FALSE(proved(0, 1));
  common.times[0] = 0.5;
  common.of_a[0] = 1;  // a sphere has one vertex
  CHECK_FALSE(proved(0, 1));
  common.of_a[0] = -1;
  CHECK_FALSE(proved(0, 1));
  common = {};
  CHECK_FALSE(proved(0, 1));
}

}  // namespace
}  // namespace translating_impact_test
