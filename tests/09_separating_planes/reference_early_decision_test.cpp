// Quick answers: GJK cut short, the filter of pairs of edges, the proof that cores meet, points
// pulled inside a smooth body, and the closed form of a sphere and a cylinder. u is the unit
// roundoff.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/closest_points.hpp>
#include <contact/early_decision.hpp>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <variant>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace early_decision_test {

using contact::ClosestPoints;
using contact::Cylinder;
using contact::OrientedBox;
using contact::Proximity;
using contact::Segment;
using generators::Random;
using generators::tried;
using pair_bodies::Kind;
using pair_bodies::V;
using pair_checks::case_of;
using pair_families::Family;
using pair_families::Pair;

namespace {

constexpr double u = 0x1p-53;

/// All 12 or 144 candidates, without a filter.
ClosestPoints<double> of_all_edges(const Segment<double>& a, const OrientedBox<double>& b,
                                   ClosestPoints<double> best) {
  for (int k = 0; k < 12; ++k) {
    contact::detail::keep_nearer<double>(best, contact::closest_points<double>(a, box_edge(b, k)));
  }
  return best;
}
ClosestPoints<double> of_all_edges(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  ClosestPoints<double> best{box_corner(a, 0), contact::closest_point<double>(box_corner(a, 0), b)};
  for (int k = 1; k < 8; ++k) {
    const V corner = box_corner(a, k);
    contact::detail::keep_nearer<double>(best, {corner, contact::closest_point<double>(corner, b)});
  }
  for (int k = 0; k < 8; ++k) {
    const V corner = box_corner(b, k);
    contact::detail::keep_nearer<double>(best, {contact::closest_point<double>(corner, a), corner});
  }
  for (int k = 0; k < 12; ++k) best = of_all_edges(box_edge(a, k), b, best);
  return best;
}
bool are_equal(const ClosestPoints<double>& p, const ClosestPoints<double>& q) {
  return p.on_a == q.on_a && p.on_b == q.on_b;
}

}  // namespace

TEST_CASE("GJK cut short is never wrong about cores with radii, and decides the clear ones") {
  int clear = 0, decided = 0;
  pair_checks::each_pair(
      981, tried(8), pair_checks::polytopes, [&](const Pair& pair, Family family) {
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          const Proximity early = contact::detail::early_decision(a, b);
          const bool known = early != Proximity::undecided;
          clear += family == Family::random ? 1 : 0;
          decided += family == Family::random && known ? 1 : 0;
          INFO(name(family) << "\n" << pair_checks::text_of(pair));
          if (known) CHECK(early == case_of(pair_truth::truth(a, b).sign));
        });
      });
  CHECK(decided >= clear * 9 / 10);
}

TEST_CASE("GJK cut short contradicts no proof about cylinders and ellipsoids") {
  int clear = 0, decided = 0;
  pair_checks::each_pair(982, tried(6), pair_checks::smooth, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const Proximity early = contact::detail::early_decision(a, b);
      const bool known = early != Proximity::undecided;
      clear += family == Family::random ? 1 : 0;
      decided += family == Family::random && known ? 1 : 0;
      const auto proved = pair_proofs::proved(pair.a, pair.b, oracle::exact(pair.normal),
                                              oracle::exact(pair.point));
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      if (known && proved) CHECK(early == case_of(*proved));
      const Proximity certified = contact::certified_proximity(a, b).state;
      if (known && certified != Proximity::undecided) CHECK(early == certified);
    });
  });
  CHECK(decided >= clear * 9 / 10);
}

TEST_CASE("nothing is decided early about what is no body") {
  const contact::Sphere<double> ball{V(0, 0, 0), 1}, negative{V(9, 0, 0), -1};
  const Cylinder<double> flat{{V(5, 0, 0), V(5, 0, 0)}, 1};
  const contact::ConvexHull<double> empty;
  CHECK(contact::detail::early_decision(ball, negative) == Proximity::undecided);
  CHECK(contact::detail::early_decision(ball, flat) == Proximity::undecided);
  CHECK(contact::detail::early_decision(ball, empty) == Proximity::undecided);
}

TEST_CASE("the filter of pairs of edges leaves the closest points as they are") {
  Random random(983);
  for (int i = 0; i < tried(6500); ++i) {
    const Family family = pair_families::all[static_cast<std::size_t>(i) % 13];
    const Pair pair = pair_families::pair(random, Kind::box, Kind::box, family);
    const auto& a = std::get<OrientedBox<double>>(pair.a);
    const auto& b = std::get<OrientedBox<double>>(pair.b);
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    const ClosestPoints<double> all = of_all_edges(a, b);
    CHECK(are_equal(contact::closest_points<double>(a, b), all));
    CHECK(are_equal(contact::closest_points<double>(a, b, pair.normal), all));
    const V any = random_poses::direction(random) * random.magnitude(-60, 60);
    CHECK(are_equal(contact::closest_points<double>(a, b, any), all));
  }
}

TEST_CASE("the filter of edges leaves the closest points of a segment and a box as they are") {
  Random random(984);
  for (int i = 0; i < tried(6500); ++i) {
    const Family family = pair_families::all[static_cast<std::size_t>(i) % 13];
    const Pair pair = pair_families::pair(random, Kind::capsule, Kind::box, family);
    const Segment<double> a = std::get<contact::Capsule<double>>(pair.a).core;
    const auto& b = std::get<OrientedBox<double>>(pair.b);
    V meeting;
    if (contact::detail::rounded_meeting<double>(a, b, meeting)) continue;
    ClosestPoints<double> best{a.start, contact::closest_point<double>(a.start, b)};
    contact::detail::keep_nearer<double>(best, {a.end, contact::closest_point<double>(a.end, b)});
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    CHECK(are_equal(contact::closest_points<double>(a, b), of_all_edges(a, b, best)));
  }
}

TEST_CASE("cores that GJK's tetrahedron proves to meet do so without rounding") {
  int proved = 0;
  pair_checks::each_pair(
      985, tried(6), pair_checks::polytopes, [&](const Pair& pair, Family family) {
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          if (!contact::detail::certainly_meet(contact::gjk(a, b), a, b)) return;
          ++proved;
          INFO(name(family) << "\n" << pair_checks::text_of(pair));
          CHECK(contact::detail::core_direction(a, b).normal == V::Zero());
        });
      });
  CHECK(proved > tried(100));
}

TEST_CASE(
    "a point on a flat cylinder or a thin ellipsoid is pulled to one that is certainly inside") {
  Random random(986);
  for (int i = 0; i < tried(4000); ++i) {
    pair_bodies::Frame f;
    f.centre = random_poses::any_point(random, 3);
    f.axes = random_poses::turn(random);
    for (int k = 0; k < 3; ++k) f.half(k) = random.uniform(0.2, 2);
    f.half(random.integer(0, 2)) *= std::abs(random.magnitude(-6, 0));
    const Kind kind = i % 2 == 0 ? Kind::cylinder : Kind::ellipsoid;
    const pair_bodies::Body body = pair_bodies::body_in(random, kind, f);
    const V n = random_poses::direction(random);
    const auto check = [&](const auto& round) {
      const V p = contact::support(round, n);
      const auto q =
          contact::detail::certainly_pulled(round, p, f.centre, contact::detail::coarse_pull);
      INFO(pair_checks::text_of(body));
      REQUIRE(q.has_value());
      CHECK(pair_proofs::inside(body, oracle::exact(*q)) >= 0);
      CHECK(V(*q - p).norm() <= 0x1p-30 * pair_bodies::size_of(body));
    };
    if (kind == Kind::cylinder) {
      check(std::get<Cylinder<double>>(body));
    } else {
      check(std::get<contact::Ellipsoid<double>>(body));
    }
  }
}

TEST_CASE("the signed distance of a sphere and a cylinder in closed form, also inside") {
  Random random(987);
  for (int i = 0; i < tried(6500); ++i) {
    const Family family = pair_families::all[static_cast<std::size_t>(i) % 13];
    if (family == Family::scaled) continue;
    const Pair pair = pair_families::pair(random, Kind::sphere, Kind::cylinder, family);
    const auto& a = std::get<contact::Sphere<double>>(pair.a);
    const auto& b = std::get<Cylinder<double>>(pair.b);
    const auto found = contact::signed_distance(a, b);
    const double room = 64 * u * (pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b));
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    CHECK(std::abs(found.normal.norm() - 1) <= 16 * u);
    CHECK(V(found.on_a - found.on_b - found.normal * found.distance).norm() <= room);
    if (family == Family::large || family == Family::thin) continue;
    // No plane separates them by more, and this one by as much.
    CHECK(std::abs(pair_proofs::gap_along(pair.a, pair.b, found.normal) - found.distance) <= room);
    CHECK(pair_proofs::distance_from(pair.b, found.on_b) <= room);
  }
}

TEST_CASE("a sphere on the core of a cylinder leaves it by the nearest surface") {
  const Cylinder<double> upright{{V(0, 0, -2), V(0, 0, 2)}, 1};
  const contact::Sphere<double> middle{V(0, 0, 0), 0.5}, high{V(0, 0, 1.5), 0.25};
  const auto side = contact::signed_distance(middle, upright);
  CHECK(side.distance == -1.5);
  CHECK(side.normal.z() == 0);
  CHECK(side.normal.norm() == 1);
  const auto cap = contact::signed_distance(high, upright);
  CHECK(cap.distance == -0.75);
  CHECK(cap.normal == V(0, 0, 1));
  CHECK(cap.on_b == V(0, 0, 2));
  const auto rim = contact::signed_distance(contact::Sphere<double>{V(4, 0, -6), 1}, upright);
  CHECK(rim.distance == 4);
  CHECK(rim.on_b == V(1, 0, -2));
}

}  // namespace early_decision_test
