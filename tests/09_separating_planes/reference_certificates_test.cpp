// The checks of proofs about two bodies: they accept what proves, and nothing that was tampered
// with and no longer does. What is true is decided in fractions.
#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <contact/certificates.hpp>
#include <contact/proximity.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "support/generators.hpp"

namespace certificates_test {
namespace {

using contact::CommonPointProof;
using contact::Exact;
using contact::meeting_proved;
using contact::Member;
using contact::overlap_proved;
using contact::Proximity;
using contact::separates;
using contact::separates_weakly;
using contact::SeparatingPlane;
using generators::Random;
using generators::tried;
using pair_families::Family;
using pair_families::Pair;
using Point = contact::Vector3<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// x with one bit changed.
double flipped(Random& random, double x) {
  const auto bit = std::uint64_t{1} << random.integer(0, 63);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ bit);
}
Exact times(const Exact& x, double factor) { return x * Exact(factor); }

bool any_two(pair_bodies::Kind a, pair_bodies::Kind b) { return a <= b; }

// ---------------------------------------------------------------- planes

/// A plane with one number changed: a bit of a normal, or an exact one by a share of 2^-80 to 1.
SeparatingPlane tampered(Random& random, SeparatingPlane plane) {
  const int i = random.integer(0, 2);
  if (contact::detail::is_zero(plane.exact_normal)) {
    plane.normal(i) = flipped(random, plane.normal(i));
  } else {
    Exact& x = plane.exact_normal(i);
    x = x + times(abs(plane.exact_normal(random.integer(0, 2))),
                  std::ldexp(random.uniform(-1, 1), random.integer(-80, 0)));
  }
  return plane;
}

TEST_CASE("a plane separates two bodies exactly if it does in fractions, with a bit changed too") {
  Random random(900);
  int refused = 0, accepted = 0, weak = 0;
  pair_checks::each_pair(901, tried(8), any_two, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const auto answer = contact::certified_proximity(a, b);
      if (answer.state != Proximity::disjoint && answer.state != Proximity::touching) return;
      CHECK(separates_weakly(answer.plane, a, b));
      const SeparatingPlane plane = tampered(random, answer.plane);
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      const bool is_plane = contact::all_finite(plane.normal) &&
                            !contact::detail::is_zero(contact::detail::normal_of(plane));
      const int sign =
          is_plane ? pair_proofs::gap_sign(pair.a, pair.b, pair_checks::normal_of(plane)) : -1;
      CHECK(separates(plane, a, b) == (sign > 0));
      CHECK(separates_weakly(plane, a, b) == (sign >= 0));
      ++(sign < 0 ? refused : (sign > 0 ? accepted : weak));
    });
  });
  CHECK(refused > tried(300));
  CHECK(accepted > tried(300));
  CHECK(weak > 0);
}

TEST_CASE("a plane of a body that is none, or without a normal, separates nothing") {
  const contact::Sphere<double> a{{3, 0, 0}, 1}, b{{0, 0, 0}, 1};
  const SeparatingPlane plane{{1, 0, 0}, contact::Vector3<Exact>::Zero()};
  CHECK(separates(plane, a, b));
  CHECK_FALSE(separates(plane, b, a));
  CHECK_FALSE(separates({}, a, b));
  CHECK_FALSE(separates_weakly({}, a, b));
  CHECK_FALSE(separates({{nan, 0, 0}, contact::Vector3<Exact>::Zero()}, a, b));
  CHECK_FALSE(separates({{infinity, 0, 0}, contact::Vector3<Exact>::Zero()}, a, b));
  CHECK_FALSE(separates(plane, contact::Sphere<double>{{nan, 0, 0}, 1}, b));
  CHECK_FALSE(separates(plane, contact::Sphere<double>{{3, 0, 0}, -1}, b));
  CHECK_FALSE(separates(plane, contact::ConvexHull<double>{}, b));
}

TEST_CASE("spheres in contact are separated weakly by one plane, and by none a bit off") {
  const contact::Sphere<double> a{{2, 0, 0}, 1}, b{{0, 0, 0}, 1};
  const auto plane = [](double y) {
    return SeparatingPlane{{1, y, 0}, contact::Vector3<Exact>::Zero()};
  };
  CHECK(separates_weakly(plane(0), a, b));
  CHECK_FALSE(separates(plane(0), a, b));
  CHECK_FALSE(separates_weakly(plane(std::numeric_limits<double>::denorm_min()), a, b));
}

// ---------------------------------------------------------------- common points

/// A common point with one thing changed.
CommonPointProof tampered(Random& random, CommonPointProof common) {
  const auto i = static_cast<std::size_t>(random.integer(0, std::max(common.count - 1, 0)));
  Member& member = random.chance(0.5) ? common.of_a[i] : common.of_b[i];
  switch (random.integer(0, 4)) {
    case 0:
      common.exact_weights.clear();
      common.weights[i] = flipped(random, common.weights[i]);
      break;
    case 1:
      if (common.exact_weights.empty()) break;
      common.exact_weights[i] = times(common.exact_weights[i], random.uniform(-0.5, 2));
      break;
    case 2:
      member.vertex = random.integer(-2, 8);
      break;
    case 3:
      --common.count;
      break;
    default: {
      const int k = random.integer(0, 2);
      member.point(k) = flipped(random, member.point(k));
    }
  }
  return common;
}

TEST_CASE("a common point proves nothing that is not true in fractions, tampered with or not") {
  Random random(902);
  int refused = 0, accepted = 0;
  pair_checks::each_pair(903, tried(8), any_two, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const auto answer = contact::certified_proximity(a, b);
      if (answer.state == Proximity::undecided || answer.common.count == 0) return;
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      CHECK(overlap_proved(answer.common, a, b) == (answer.state == Proximity::overlapping));
      CHECK(meeting_proved(answer.common, a, b) == (answer.state != Proximity::disjoint));
      const CommonPointProof common = tampered(random, answer.common);
      const bool overlap = overlap_proved(common, a, b), meeting = meeting_proved(common, a, b);
      if (answer.state != Proximity::disjoint) ++(meeting ? accepted : refused);
      CHECK((!overlap || meeting));
      if (!meeting) return;
      const int side = pair_checks::side_of_common(pair.a, pair.b, common);
      CHECK(side <= 0);
      CHECK((!overlap || side < 0));
    });
  });
  CHECK(refused > tried(200));
  CHECK(accepted > tried(200));
}

/// The differences ± along the axes of two boxes of half length 1 about the origin: as points of
/// the bodies, so that no vertex is near.
CommonPointProof octahedron() {
  CommonPointProof common;
  for (int i = 0; i < 3; ++i) {
    for (const double sign : {1.0, -1.0}) {
      const auto at = static_cast<std::size_t>(common.count++);
      common.of_a[at] = {-1, Point(Point::Unit(i) * sign)};
      common.of_b[at] = {-1, Point::Zero()};
    }
  }
  return common;
}

TEST_CASE("of the six vertices of an octahedron around the origin none can be left out") {
  contact::OrientedBox<double> box;
  box.half_lengths = Point(1, 1, 1);
  const CommonPointProof common = octahedron();
  CHECK(overlap_proved(common, box, box));
  for (std::size_t i = 0; i < 6; ++i) {
    CommonPointProof five = common;
    five.of_a[i] = five.of_a[5];
    five.count = 5;
    CHECK_FALSE(overlap_proved(five, box, box));
    five.weights.fill(1);
    CHECK_FALSE(overlap_proved(five, box, box));
  }
}

TEST_CASE("a radius counts for vertices of the core, and not for points of the body") {
  const contact::Sphere<double> a{{0, 0, 0}, 1}, b{{2.5, 0, 0}, 1};
  CommonPointProof common;
  common.count = 1;
  common.weights[0] = 1;
  common.of_b[0].vertex = 0;
  common.of_a[0] = {-1, Point(1, 0, 0)};  // 1.5 m from the centre of b, whose radius is 1 m
  CHECK_FALSE(meeting_proved(common, a, b));
  const contact::Sphere<double> closer{{2, 0, 0}, 1}, in{{1.75, 0, 0}, 1};
  CHECK(meeting_proved(common, a, closer));
  CHECK_FALSE(overlap_proved(common, a, closer));
  CHECK(overlap_proved(common, a, in));
  common.of_a[0].point = Point(std::nextafter(1.0, 2.0), 0, 0);  // no point of a
  CHECK_FALSE(meeting_proved(common, a, in));
}

TEST_CASE("members, counts and weights that are none prove nothing") {
  const contact::Sphere<double> a{{0, 0, 0}, 1}, b{{1, 0, 0}, 1};
  CommonPointProof good;
  good.count = 2;
  good.of_a[0].vertex = good.of_a[1].vertex = good.of_b[0].vertex = good.of_b[1].vertex = 0;
  good.weights = {1, 1, 0, 0, 0, 0};
  CHECK(overlap_proved(good, a, b));
  const auto refused = [&](const auto& change) {
    CommonPointProof bad = good;
    change(bad);
    return !overlap_proved(bad, a, b) && !meeting_proved(bad, a, b);
  };
  CHECK(refused([](CommonPointProof& c) { c.count = 0; }));
  CHECK(refused([](CommonPointProof& c) { c.count = 7; }));
  CHECK(refused([](CommonPointProof& c) { c.count = -1; }));
  CHECK(refused([](CommonPointProof& c) { c.of_a[1].vertex = 1; }));
  CHECK(refused([](CommonPointProof& c) { c.of_b[1].vertex = -2; }));
  CHECK(refused([](CommonPointProof& c) { c.of_a[1] = {-1, Point(nan, 0, 0)}; }));
  CHECK(refused([](CommonPointProof& c) { c.weights = {1, -0.5, 0, 0, 0, 0}; }));
  CHECK(refused([](CommonPointProof& c) { c.weights = {1, nan, 0, 0, 0, 0}; }));
  CHECK(refused([](CommonPointProof& c) { c.weights = {infinity, 1, 0, 0, 0, 0}; }));
  CHECK(refused([](CommonPointProof& c) { c.weights = {0, 0, 0, 0, 0, 0}; }));
  CHECK(refused([](CommonPointProof& c) { c.exact_weights = {Exact(1)}; }));
  CHECK(refused([](CommonPointProof& c) { c.exact_weights = {Exact(1), Exact(-0.5)}; }));
}

TEST_CASE("a point near a common one is close to both bodies") {
  pair_checks::each_pair(904, tried(2), any_two, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const auto answer = contact::certified_proximity(a, b);
      if (answer.state != Proximity::touching && answer.state != Proximity::overlapping) return;
      const Point p = near_common_point(answer.common, a, b);
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      const double size = pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b);
      const contact::Sphere<double> around{p, 0x1p-44 * size};
      CHECK(contact::proximity(around, a) != Proximity::disjoint);
      CHECK(contact::proximity(around, b) != Proximity::disjoint);
    });
  });
}

}  // namespace
}  // namespace certificates_test
