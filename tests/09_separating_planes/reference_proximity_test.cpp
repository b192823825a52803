// Decisions for every pair of kinds that other tests do not ask for: half-spaces, floats, numbers
// that are none, scales, and witnesses, which must not change the answer.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/proximity.hpp>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <variant>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace proximity_test {
namespace {

using contact::certified_proximity;
using contact::certified_proximity_with_witness;
using contact::CertifiedProximity;
using contact::HalfSpace;
using contact::Proximity;
using contact::proximity;
using contact::ProximityWitness;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using pair_bodies::Body;
using pair_checks::case_of;
using pair_families::Pair;
using Point = contact::Vector3<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

bool any_two(pair_bodies::Kind a, pair_bodies::Kind b) { return a <= b; }

// ---------------------------------------------------------------- half-spaces

/// The least n · x of a body less k: its sign is the case, and over |n| it is the distance.
Surd above(const Body& body, const HalfSpace<double>& half) {
  const Surd low = -pair_proofs::support(body, Vector(-oracle::exact(half.boundary.normal)));
  return low + Rational(-oracle::exact(half.boundary.offset));
}

/// A half-space that a body almost touches, or touches exactly if its support is a double.
HalfSpace<double> near_half_space(Random& random, const Body& body) {
  Point n = random.chance(0.5) ? random_poses::direction(random)
                               : Point(Point::Unit(random.integer(0, 2)));
  if (random.chance(0.2)) n = n * std::ldexp(1.0, random.integer(-40, 40));
  HalfSpace<double> half{{n, 0}};
  double offset = oracle::nearest(above(body, half));
  for (int k = random.integer(-2, 2); k != 0; k += k > 0 ? -1 : 1) {
    offset = std::nextafter(offset, k > 0 ? infinity : -infinity);
  }
  half.boundary.offset = random.chance(0.3) ? offset + random.uniform(-1, 1) : offset;
  return half;
}

TEST_CASE("every body against a half-space: never undecided and never wrong, with a proof") {
  Random random(930);
  std::array<int, 3> seen{};
  int without = 0;
  for (int i = 0; i < tried(3000); ++i) {
    const auto kind = pair_bodies::all_kinds[static_cast<std::size_t>(i) % 8];
    const auto family = pair_families::all[static_cast<std::size_t>(i / 8) % 13];
    const Body body = pair_families::pair(random, kind, kind, family).a;
    const HalfSpace<double> half = near_half_space(random, body);
    const Surd gap = above(body, half);
    const int sign = oracle::sign(gap);
    ++seen[static_cast<std::size_t>(sign + 1)];
    INFO(pair_checks::text_of(body) << " offset " << half.boundary.offset);
    std::visit(
        [&](const auto& a) {
          const CertifiedProximity found = certified_proximity(a, half);
          REQUIRE(found.state == case_of(sign));
          CHECK(proximity(half, a) == found.state);
          CHECK(proximity(a, half) == found.state);
          CHECK(separates(found.plane, a, half) == (sign > 0));
          CHECK(separates_weakly(found.plane, a, half) == (sign >= 0));
          const CertifiedProximity swapped = certified_proximity(half, a);
          CHECK(separates(swapped.plane, half, a) == (sign > 0));
          CHECK(separates_weakly(swapped.plane, half, a) == (sign >= 0));
          if (sign > 0) {
            const Vector n = oracle::exact(half.boundary.normal);
            const auto at_most = [&](const Rational& x) {  // x ≤ gap/|n|
              return oracle::compare(Surd{0, x, n.dot(n)}, gap) <= 0;
            };
            CHECK(at_most(oracle::exact(found.low)));
            CHECK((found.high == infinity ||
                   oracle::compare(Surd{0, oracle::exact(found.high), n.dot(n)}, gap) >= 0));
          }
          const bool proved = sign < 0 ? overlap_proved(found.common, a, half)
                                       : meeting_proved(found.common, a, half);
          if (sign > 0) CHECK_FALSE(proved);
          if (sign <= 0 && !proved) ++without;
          if constexpr (contact::PolytopeCore<std::decay_t<decltype(a)>>) {
            CHECK(proved == (sign <= 0));
            CHECK(overlap_proved(exchanged(found.common), half, a) == (sign < 0));
          }
        },
        body);
  }
  for (const int count : seen) CHECK(count > tried(100));
  // Smooth bodies that touch, or are in by less than doubles are apart.
  CHECK(without < tried(600));
}

TEST_CASE("only the normal of a half-space separates from it") {
  const contact::Sphere<double> a{Point(0, 0, 3), 1};
  const HalfSpace<double> half{{Point(0, 0, 1), 0}};
  const auto plane = [](const Point& n) {
    return contact::SeparatingPlane{n, contact::Vector3<contact::Exact>::Zero()};
  };
  CHECK(separates(plane({0, 0, 7}), a, half));
  CHECK_FALSE(separates(plane({0, 0, -1}), a, half));
  CHECK_FALSE(separates(plane({0, 0x1p-1074, 1}), a, half));
  CHECK_FALSE(separates({}, a, half));
}

// ---------------------------------------------------------------- numbers

TEST_CASE("what is no body is disjoint from everything, without bounds") {
  const contact::OrientedBox<double> box{Point::Zero(), contact::Matrix3<double>::Identity(),
                                         Point(1, 1, 1)};
  const auto none = [&](const auto& body) {
    const auto found = certified_proximity(body, box);
    ProximityWitness witness;
    return found.state == Proximity::disjoint && found.low == infinity &&
           certified_proximity(box, body).state == Proximity::disjoint &&
           certified_proximity(body, HalfSpace<double>{{Point(0, 0, 1), 9}}).state ==
               Proximity::disjoint &&
           certified_proximity_with_witness(body, box, witness).state == Proximity::disjoint &&
           !separates(found.plane, body, box) && !meeting_proved(found.common, body, box);
  };
  CHECK(none(contact::ConvexHull<double>{}));
  CHECK(none(contact::ConvexHull<double>{{Point(0, nan, 0)}, 1}));
  CHECK(none(contact::Lozenge<double>{Point::Zero(), Point(1, 0, 0), Point(infinity, 0, 0), 1}));
  CHECK(none(contact::Lozenge<double>{Point::Zero(), Point(1, 0, 0), Point(0, 1, 0), -1}));
  CHECK(none(contact::Triangle<double>{Point(nan, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}));
  CHECK(none(contact::Cylinder<double>{{Point(1, 0, 0), Point(1, 0, 0)}, 1}));
  CHECK(none(contact::Ellipsoid<double>{Point::Zero(), contact::Matrix3<double>::Identity(),
                                        Point(1, nan, 1)}));
  const contact::Triangle<double> triangle{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  CHECK(proximity(triangle, HalfSpace<double>{{Point::Zero(), 1}}) == Proximity::disjoint);
  CHECK(proximity(triangle, HalfSpace<double>{{Point(0, 0, 1), nan}}) == Proximity::disjoint);
}

/// The body in float.
template <class Body>
auto in_float(const Body& b) {
  const auto p = [](const Point& x) { return contact::Vector3<float>(x.cast<float>()); };
  if constexpr (std::same_as<Body, contact::OrientedBox<double>>) {
    return contact::OrientedBox<float>{p(b.centre), b.axes.template cast<float>(),
                                       p(b.half_lengths)};
  } else if constexpr (std::same_as<Body, contact::Capsule<double>>) {
    return contact::Capsule<float>{{p(b.core.start), p(b.core.end)}, float(b.radius)};
  } else if constexpr (std::same_as<Body, contact::Lozenge<double>>) {
    return contact::Lozenge<float>{p(b.corner), p(b.first_edge), p(b.second_edge), float(b.radius)};
  } else {
    contact::ConvexHull<float> hull;
    for (const Point& v : b.vertices) hull.vertices.push_back(p(v));
    hull.radius = float(b.radius);
    return hull;
  }
}
template <class A, class B>
void check_floats(pair_bodies::Kind first, pair_bodies::Kind second, std::uint64_t seed) {
  Random random(seed);
  std::array<int, 3> seen{};
  for (int i = 0; i < tried(200); ++i) {
    const auto family = i % 2 == 0 ? pair_families::Family::touching : pair_families::Family::grid;
    const Pair pair = pair_families::pair(random, first, second, family);
    const auto a = in_float(std::get<A>(pair.a));
    const auto b = in_float(std::get<B>(pair.b));
    const int sign =
        pair_truth::truth(contact::detail::as_double(a), contact::detail::as_double(b)).sign;
    ++seen[static_cast<std::size_t>(sign + 1)];
    CHECK(proximity(a, b) == case_of(sign));
    CHECK(certified_proximity(b, a).state == case_of(sign));
  }
  for (const int count : seen) CHECK(count > 0);
}

TEST_CASE("bodies of floats are decided as exactly as those of doubles") {
  using pair_bodies::Kind;
  check_floats<contact::OrientedBox<double>, contact::OrientedBox<double>>(Kind::box, Kind::box,
                                                                           931);
  check_floats<contact::Capsule<double>, contact::ConvexHull<double>>(Kind::capsule, Kind::hull,
                                                                      932);
  check_floats<contact::Lozenge<double>, contact::OrientedBox<double>>(Kind::lozenge, Kind::box,
                                                                       933);
}

TEST_CASE("bodies touch at every scale at which they can be stored") {
  for (const double s : {0x1p-1074, 0x1p-1022, 0x1p-500, 1.0, 0x1p500, 0x1p1019}) {
    INFO("scale " << s);
    const contact::Triangle<double> flat{Point(0, 0, 0), Point(4 * s, 0, 0), Point(0, 4 * s, 0)};
    const contact::Sphere<double> ball{Point(s, s, 2 * s), 2 * s};
    CHECK(proximity(flat, ball) == Proximity::touching);
    CHECK(proximity(flat, contact::Sphere<double>{ball.centre, s}) == Proximity::disjoint);
    CHECK(proximity(flat, contact::Sphere<double>{ball.centre, 3 * s}) == Proximity::overlapping);
    const contact::ConvexHull<double> tip{
        {Point(s, s, 0), Point(2 * s, s, s), Point(s, 2 * s, s), Point(s, s, 2 * s)}, 0};
    CHECK(proximity(flat, tip) == Proximity::touching);
    const contact::Lozenge<double> beam{Point(s, s, -s), Point(0, 0, 2 * s), Point(-4 * s, 0, 0),
                                        0};
    CHECK(proximity(flat, beam) == Proximity::overlapping);
  }
}

// ---------------------------------------------------------------- witnesses

/// Anything at all.
ProximityWitness any_witness(Random& random) {
  ProximityWitness witness;
  const std::array<double, 4> strange{nan, infinity, 0, -1};
  const auto number = [&] {
    return random.chance(0.1) ? strange[static_cast<std::size_t>(random.integer(0, 3))]
                              : random.uniform(-1, 1);
  };
  for (int i = 0; i < 3; ++i) {
    witness.normal(i) = number();
    witness.simplex.direction(i) = number();
  }
  witness.simplex.count = random.integer(-1, 6);
  for (std::size_t i = 0; i < 4; ++i) {
    witness.simplex.a[i] = random.integer(-2, 9);
    witness.simplex.b[i] = random.integer(-2, 9);
    witness.weights[i] = number();
  }
  return witness;
}

TEST_CASE("no witness, whatever it says, changes how two bodies lie to each other") {
  Random random(934);
  int used = 0, undecided = 0, all = 0;
  pair_checks::each_pair(935, tried(3), any_two, [&](const Pair& pair, auto family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      ++all;
      const CertifiedProximity without = certified_proximity(a, b);
      ProximityWitness witness = any_witness(random);
      const ProximityWitness given = witness;
      const CertifiedProximity with = certified_proximity_with_witness(a, b, witness);
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      if (without.state == Proximity::undecided || with.state == Proximity::undecided) {
        ++undecided;
        return;
      }
      CHECK(with.state == without.state);
      CHECK(pair_checks::fault_of(pair.a, pair.b, with).empty());
      if (witness.weights == given.weights && with.state == Proximity::disjoint) ++used;
      // The witness that is left gives the same answer once more.
      CHECK(certified_proximity_with_witness(a, b, witness).state == with.state);
    });
  });
  CHECK(used > tried(6));
  CHECK(undecided < all / 8);
}

TEST_CASE("a witness is used as long as it proves, and replaced when it does not") {
  const contact::Triangle<double> floor{Point(-9, -9, 0), Point(9, -9, 0), Point(0, 9, 0)};
  const auto falling = [](double height) {
    return contact::Lozenge<double>{Point(-1, -1, height), Point(2, 0, 0), Point(0, 2, 0), 0.5};
  };
  ProximityWitness witness;
  CHECK(certified_proximity_with_witness(falling(3), floor, witness).state == Proximity::disjoint);
  const Point normal = witness.normal;
  CHECK(normal.z() > 0);
  CHECK(certified_proximity_with_witness(falling(1), floor, witness).state == Proximity::disjoint);
  CHECK(witness.normal == normal);
  CHECK(certified_proximity_with_witness(falling(0.5), floor, witness).state ==
        Proximity::touching);
  CHECK(certified_proximity_with_witness(falling(0.25), floor, witness).state ==
        Proximity::overlapping);
  CHECK(witness.normal == Point::Zero());
  CHECK(certified_proximity_with_witness(falling(1), floor, witness).state == Proximity::disjoint);
}

}  // namespace
}  // namespace proximity_test
