// The fast decision of two boxes against fractions, and against the exact sign of every axis.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/closed_proximity.hpp>
#include <limits>
#include <variant>

#include "pair_families.hpp"
#include "random_poses.hpp"
#include "reference.hpp"
#include "shape_oracle.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace box_proximity_test {

using contact::Proximity;
using contact::detail::box_decision;
using contact::detail::exact_box_decision;
using contact::detail::rounded_box_decision;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using pair_families::Family;
using reference::Box;
using reference::V;
using shape_oracle::exact;

namespace {

Box as_box(const pair_bodies::Body& body) { return std::get<Box>(body); }

/// The sign of the largest separation along the fifteen axes, by fractions.
int exact_sign(const Box& a, const Box& b) {
  return oracle::sign(reference::widest(exact(a), exact(b)));
}
Proximity case_of(int sign) {
  if (sign == 0) return Proximity::touching;
  return sign > 0 ? Proximity::disjoint : Proximity::overlapping;
}

/// A box whose axes are oblique by up to `most` in every entry.
Box oblique(Random& random, Box box, double most) {
  for (int i = 0; i < 9; ++i) box.axes(i / 3, i % 3) += random.uniform(-most, most);
  return box;
}

}  // namespace

TEST_CASE("boxes of all families: the decision is that of fractions, and its axis proves it") {
  Random random(920);
  int seen[3] = {0, 0, 0};
  int fast = 0;
  constexpr int cases = 2600;
  for (int i = 0; i < tried(cases); ++i) {
    const Family family = pair_families::all[static_cast<std::size_t>(i) % 13];
    const auto pair =
        pair_families::pair(random, pair_bodies::Kind::box, pair_bodies::Kind::box, family);
    const Box a = as_box(pair.a), b = as_box(pair.b);
    const int sign = exact_sign(a, b);
    ++seen[sign + 1];
    const auto decision = box_decision(a, b);
    CHECK(decision.state == case_of(sign));
    CHECK(box_decision(b, a).state == case_of(sign));
    CHECK((decision.axis < 0) == (sign < 0));
    if (decision.axis >= 0) {
      CHECK(contact::detail::sign_of_separation(a, b, decision.axis) == sign);
    }
    fast += rounded_box_decision(a, b).state == Proximity::undecided ? 0 : 1;
  }
  CHECK(fast > tried(cases) / 2);
  CHECK(seen[0] > tried(300));
  CHECK(seen[1] > tried(20));
  CHECK(seen[2] > tried(300));
}

TEST_CASE("what the fast decision of two boxes calls certain is so, also with oblique axes") {
  // Without the share of `oblique` in the margin this fails.
  Random random(921);
  int decided = 0;
  for (int i = 0; i < tried(3000); ++i) {
    const double most = std::ldexp(random.uniform(0.5, 1), -random.integer(16, 40));
    Box a = oblique(random, reference::box(random, reference::Kind::any), most);
    const Box b = oblique(random, reference::box(random, reference::Kind::any), most);
    // To a distance of about the share from touching, along the widest axis.
    V n = contact::likely_axis(a, b);
    const double gap = contact::separation_along<double>(a, b, n) / n.dot(n);
    const double size = reference::size_of(a) + reference::size_of(b);
    a.centre -= n * gap;
    a.centre += n.normalized() * random.uniform(-8, 8) * most * size;
    const auto found = rounded_box_decision(a, b);
    if (found.state == Proximity::undecided) continue;
    ++decided;
    CHECK(found.state == exact_box_decision(a, b).state);
  }
  CHECK(decided > tried(300));
}

TEST_CASE(
    "boxes with nearly parallel edges that overlap deeply are decided without exact numbers") {
  // A rounded sign is in doubt for a short axis; the overlap of the faces decides for it.
  Random random(922);
  for (int i = 0; i < tried(2000); ++i) {
    const Box a = reference::box(random, reference::Kind::any);
    Box b = a;
    const double angle = std::ldexp(random.uniform(1, 2), -random.integer(20, 60));
    b.axes = contact::matrix_of(
                 contact::exponential<double>(V(random_poses::direction(random) * angle))) *
             a.axes;
    b.centre += random_poses::direction(random) * a.half_lengths.minCoeff();
    CHECK(rounded_box_decision(a, b).state == Proximity::overlapping);
  }
}

TEST_CASE("nearly parallel edges may separate boxes whose faces all overlap a little") {
  // Two bars, almost parallel, edge to edge: the depth along the faces is less than what the angle
  // between the bars can hide.
  Random random(923);
  int by_edges = 0;
  for (int i = 0; i < tried(2000); ++i) {
    Box a = reference::box(random, reference::Kind::any);
    a.half_lengths = V(1e-3, 1e-3, 1);
    Box b = a;
    const double angle = std::ldexp(random.uniform(1, 2), -random.integer(12, 30));
    const V across = (a.axes.col(0) + a.axes.col(1)).normalized();
    b.axes = contact::matrix_of(contact::exponential<double>(V(across * angle))) * a.axes;
    b.centre += across * (std::sqrt(8.0) * 1e-3 + random.uniform(-1, 1) * 1e-3 * angle);
    const int sign = exact_sign(a, b);
    const auto decision = box_decision(a, b);
    CHECK(decision.state == case_of(sign));
    by_edges += decision.axis >= 6 ? 1 : 0;
  }
  CHECK(by_edges > tried(300));
}

TEST_CASE("the kept axis of two boxes is a proof, and never changes the answer") {
  Random random(924);
  int kept = 0, steps = 0;
  for (int i = 0; i < tried(150); ++i) {
    Box a = reference::box(random, reference::Kind::any);
    const Box b = reference::box(random, reference::Kind::any);
    const V velocity = random_poses::direction(random) * 0.02;
    contact::SeparatingWitness witness;
    for (int step = 0; step < 60; ++step) {
      const int before = witness.box_axis;
      const Proximity answer = contact::proximity_with_witness(a, b, witness);
      CHECK(answer == contact::proximity(a, b));
      if (answer == Proximity::disjoint) {
        ++steps;
        kept += before == witness.box_axis ? 1 : 0;
        CHECK(contact::detail::sign_of_separation(a, b, witness.box_axis) == 1);
      }
      a.centre += velocity;
      a.axes = contact::matrix_of(contact::exponential<double>(velocity)) * a.axes;
    }
  }
  CHECK(kept > steps * 9 / 10);
}

TEST_CASE("any index is a witness: what it accepts is disjoint") {
  Random random(925);
  int accepted = 0;
  for (int i = 0; i < tried(4000); ++i) {
    const Family family = pair_families::all[static_cast<std::size_t>(i) % 13];
    const auto pair =
        pair_families::pair(random, pair_bodies::Kind::box, pair_bodies::Kind::box, family);
    const Box a = as_box(pair.a), b = as_box(pair.b);
    const int k = random.integer(0, 14);
    if (!contact::detail::box_axis_separates(a, b, k)) continue;
    ++accepted;
    CHECK(contact::proximity(a, b) == Proximity::disjoint);
  }
  CHECK(accepted > tried(200));
}

TEST_CASE("a body with a number that is not finite is undecided, with every other") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Box box{V(0, 0, 0), contact::Matrix3<double>::Identity(), V(1, 1, 1)};
  const contact::Sphere<double> ball{V(0, 0, 0), 1};
  const contact::Capsule<double> capsule{{V(0, 0, 0), V(1, 0, 0)}, 1};
  const contact::HalfSpace<double> half_space{{V(0, 0, 1), 0}};
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    Box bad_box = box;
    bad_box.axes(1, 2) = bad;
    contact::Sphere<double> bad_ball = ball;
    bad_ball.radius = bad;
    contact::Capsule<double> bad_capsule = capsule;
    bad_capsule.core.end.y() = bad;
    const auto all_undecided = [&](const auto& body) {
      CHECK(contact::proximity(body, box) == Proximity::undecided);
      CHECK(contact::proximity(capsule, body) == Proximity::undecided);
      CHECK(contact::proximity(body, half_space) == Proximity::undecided);
    };
    all_undecided(bad_box);
    all_undecided(bad_ball);
    all_undecided(bad_capsule);
    CHECK(contact::proximity(bad_ball, ball) == Proximity::undecided);
    CHECK(contact::proximity(ball, contact::HalfSpace<double>{{V(0, 0, 1), bad}}) ==
          Proximity::undecided);
  }
}

}  // namespace box_proximity_test
