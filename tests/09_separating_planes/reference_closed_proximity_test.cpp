// Every decision of the chapter against fractions. u is the unit roundoff.
//
// The oracle is independent of the book's methods: it finds the smallest distance of two bodies by
// testing all sets of active bounds (shape_oracle.hpp), and distinguishes overlap from touching by
// shrinking the bodies by less than any overlap of stored numbers.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/closed_proximity.hpp>
#include <contact/signed_distance.hpp>
#include <limits>

#include "random_poses.hpp"
#include "reference.hpp"
#include "shape_oracle.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace closed_proximity_test {

using contact::Capsule;
using contact::HalfSpace;
using contact::Matrix3;
using contact::OrientedBox;
using contact::Proximity;
using contact::Segment;
using contact::Sphere;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using random_poses::any_point;
using random_poses::direction;
using random_poses::turn;
using reference::box;
using reference::Box;
using reference::Kind;
using reference::kinds;
using reference::partner;
using reference::segment;
using reference::size_of;
using reference::sizes;
using reference::V;
using reference::widest;
using shape_oracle::exact;
using shape_oracle::ExactBox;
using shape_oracle::min_squared;
using shape_oracle::zonotope;
using support::contains;
using support::refusal;

namespace {

Proximity by_sign(int sign) {
  if (sign == 0) return Proximity::touching;
  return sign > 0 ? Proximity::disjoint : Proximity::overlapping;
}

/// The sign of √squared − reach.
int beyond(const Rational& squared, const Rational& reach) {
  return oracle::sign(Rational(squared - reach * reach));
}

/// By the oracle of active sets: separated, or overlapping even if shrunk, or touching.
Proximity by_active_sets(const ExactBox& a, const ExactBox& b) {
  if (min_squared(difference(zonotope(a), zonotope(b))) > 0) return Proximity::disjoint;
  ExactBox smaller = a;
  const Rational shrink = 1 - Rational(1) / (oracle::Integer(1) << 700);
  smaller.half_lengths = smaller.half_lengths * shrink;
  ExactBox other = b;
  other.half_lengths = other.half_lengths * shrink;
  const Rational apart = min_squared(difference(zonotope(smaller), zonotope(other)));
  return apart > 0 ? Proximity::touching : Proximity::overlapping;
}

}  // namespace

TEST_CASE("exact squared distances agree with all active sets") {
  Random random(901);
  for (int i = 0; i < tried(1200); ++i) {
    const Kind kind = kinds[i % 6];
    const Segment<double> a = segment(random, kind);
    const Segment<double> b = partner(random, kind, a);
    const auto ea = oracle::exact(a);
    const auto eb = oracle::exact(b);
    CHECK(contact::exact_squared_distance<Rational>(ea, eb) ==
          min_squared(difference(zonotope(ea), zonotope(eb))));
  }
  for (int i = 0; i < tried(120); ++i) {
    const Kind kind = kinds[i % 3];
    const Segment<double> a = segment(random, kind);
    const Box b = box(random, kind);
    const auto ea = oracle::exact(a);
    CHECK(contact::exact_squared_distance<Rational>(ea, exact(b)) ==
          min_squared(difference(zonotope(ea), zonotope(exact(b)))));
  }
  for (int i = 0; i < tried(16); ++i) {
    const Box a = box(random, kinds[i % 3]);
    const Box b = box(random, kinds[i % 3]);
    CHECK(contact::exact_squared_distance<Rational>(exact(a), exact(b)) ==
          min_squared(difference(zonotope(exact(a)), zonotope(exact(b)))));
  }
}

TEST_CASE("fractions of exact numbers obey the rules of fractions") {
  Random random(902);
  for (int i = 0; i < tried(2000); ++i) {
    const double x = random.magnitude(-60, 60);
    const double y = random.magnitude(-60, 60);
    const double z = random.chance(0.2) ? x : random.magnitude(-60, 60);
    const contact::ExactFraction fx(x), fy(y), fz(z);
    const Rational ex = oracle::exact(x), ey = oracle::exact(y), ez = oracle::exact(z);
    const auto got = (fx / fy - fz) * fy / fx + fz;
    const Rational right = (ex / ey - ez) * ey / ex + ez;
    CHECK(got.sign() == oracle::sign(right));
    CHECK(got.nearest() == oracle::nearest(right));
    CHECK((fx / fy < fz) == (ex / ey < ez));
    CHECK((fx * fz == fz * fz) == (ex == ez));
  }
}

TEST_CASE("capsules and spheres: three cases, never wrong") {
  Random random(903);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < tried(6000); ++i) {
    const Kind kind = kinds[i % 6];
    Capsule<double> a{segment(random, kind), 0};
    Capsule<double> b{partner(random, kind, a.core), 0};
    if (random.chance(0.2)) a.core.end = a.core.start;
    if (random.chance(0.2)) b.core.end = b.core.start;
    const Rational squared =
        contact::exact_squared_distance<Rational>(oracle::exact(a.core), oracle::exact(b.core));
    if (kind == Kind::grid || kind == Kind::rational) {
      a.radius = random.integer(0, 3);
      b.radius = random.integer(0, 3);
      const double root = std::round(std::sqrt(oracle::nearest(squared)));
      if (oracle::exact(root * root) == squared) {  // to touch exactly
        b.radius = std::min(b.radius, root);
        a.radius = root - b.radius;
      }
    } else {
      // As close to touching as stored numbers allow, or random.
      const double distance = std::sqrt(oracle::nearest(squared));
      b.radius = distance * random.uniform();
      a.radius = distance - b.radius;
      if (random.chance(0.5)) {
        a.radius = std::abs(std::nextafter(a.radius, random.chance(0.5) ? 0.0 : 9.0));
      } else if (random.chance(0.5)) {
        a.radius *= random.uniform(0.5, 1.5);
      }
    }
    const int sign = beyond(squared, oracle::exact(a.radius) + oracle::exact(b.radius));
    const Proximity right = by_sign(sign);
    ++seen[sign + 1];
    CHECK(contact::proximity(a, b) == right);
    CHECK(contact::proximity(b, a) == right);
    if (a.core.start == a.core.end) {
      const Sphere<double> ball{a.core.start, a.radius};
      CHECK(contact::proximity(ball, b) == right);
      if (b.core.start == b.core.end) {
        CHECK(contact::proximity(ball, Sphere<double>{b.core.start, b.radius}) == right);
      }
    }
  }
  CHECK(seen[0] > tried(500));
  CHECK(seen[1] > tried(100));
  CHECK(seen[2] > tried(500));
}

TEST_CASE("capsules, spheres and boxes: three cases, never wrong") {
  Random random(904);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < tried(1500); ++i) {
    const Kind kind = kinds[i % 3];
    const Box b = box(random, kind);
    Capsule<double> a{segment(random, kind), 0};
    if (random.chance(0.3)) a.core.end = a.core.start;
    const Rational squared =
        contact::exact_squared_distance<Rational>(oracle::exact(a.core), exact(b));
    a.radius = kind == Kind::any ? std::sqrt(oracle::nearest(squared)) : random.integer(0, 3);
    const double root = std::round(std::sqrt(oracle::nearest(squared)));
    if (oracle::exact(root * root) == squared) a.radius = root;  // to touch exactly
    int right = beyond(squared, oracle::exact(a.radius));
    if (right == 0 && a.radius == 0) {
      // A core without thickness collides if it enters the box shrunk by a tiny amount.
      ExactBox smaller = exact(b);
      smaller.half_lengths =
          smaller.half_lengths * Rational(1 - Rational(1) / (oracle::Integer(1) << 700));
      right =
          min_squared(difference(zonotope(oracle::exact(a.core)), zonotope(smaller))) > 0 ? 0 : -1;
    }
    ++seen[right + 1];
    CHECK(contact::proximity(a, b) == by_sign(right));
    CHECK(contact::proximity(b, a) == by_sign(right));
    if (a.core.start == a.core.end) {
      CHECK(contact::proximity(Sphere<double>{a.core.start, a.radius}, b) == by_sign(right));
    }
  }
  for (const int count : seen) CHECK(count > tried(100));
}

TEST_CASE("boxes: three cases, never wrong") {
  Random random(905);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < tried(6000); ++i) {
    const Kind kind = kinds[i % 6];
    const Box a = box(random, kind);
    const Box b = partner(random, kind, a);
    const int right = oracle::sign(widest(exact(a), exact(b)));
    ++seen[right + 1];
    CHECK(contact::proximity(a, b) == by_sign(right));
    CHECK(contact::proximity(b, a) == by_sign(right));
  }
  CHECK(seen[0] > tried(500));
  CHECK(seen[1] > tried(100));
  CHECK(seen[2] > tried(500));
}

TEST_CASE("boxes: the fifteen axes agree with all active sets") {
  Random random(906);
  int touching = 0;
  for (int i = 0; i < tried(48); ++i) {
    const Kind kind = i % 2 == 0 ? Kind::grid : kinds[i % 6];
    const Box a = box(random, kind);
    const Box b = partner(random, kind, a);
    const Proximity right = by_active_sets(exact(a), exact(b));
    touching += right == Proximity::touching ? 1 : 0;
    CHECK(contact::proximity(a, b) == right);
  }
  CHECK(touching >= tried(3));
}

TEST_CASE("half-spaces: three cases, never wrong") {
  Random random(907);
  int touching = 0;
  for (int i = 0; i < tried(6000); ++i) {
    const Kind kind = kinds[i % 3];
    HalfSpace<double> h{{direction(random), random.uniform(-3, 3)}};
    if (kind == Kind::grid) h = {{V::Unit(random.integer(0, 2)), double(random.integer(-4, 4))}};
    const Box a = box(random, kind);
    Capsule<double> c{segment(random, kind), double(random.integer(0, 3))};
    if (i % 4 == 3) {  // as close to touching as stored numbers allow
      h.boundary.offset =
          std::min(contact::signed_distance<double>({h.boundary.normal, 0}, c.core.start),
                   contact::signed_distance<double>({h.boundary.normal, 0}, c.core.end)) -
          c.radius;
    }
    const Vector n = oracle::exact(h.boundary.normal);
    const Rational k = oracle::exact(h.boundary.offset);
    Rational lowest = n.dot(contact::box_corner<Rational>(exact(a), 0));
    for (int corner = 1; corner < 8; ++corner) {
      lowest = std::min<Rational>(lowest, n.dot(contact::box_corner<Rational>(exact(a), corner)));
    }
    const int box_right = oracle::sign(Rational(lowest - k));
    touching += box_right == 0 ? 1 : 0;
    CHECK(contact::proximity(a, h) == by_sign(box_right));
    CHECK(contact::proximity(h, a) == by_sign(box_right));
    const Rational end =
        std::min<Rational>(n.dot(oracle::exact(c.core.start)), n.dot(oracle::exact(c.core.end))) -
        k;
    // end − r √(n·n)
    const int right = oracle::sign(oracle::Surd{end, -oracle::exact(c.radius), n.dot(n)});
    CHECK(contact::proximity(c, h) == by_sign(right));
    const Rational first = n.dot(oracle::exact(c.core.start)) - k;
    CHECK(contact::proximity(Sphere<double>{c.core.start, c.radius}, h) ==
          by_sign(oracle::sign(oracle::Surd{first, -oracle::exact(c.radius), n.dot(n)})));
  }
  CHECK(touching > tried(100));
}

TEST_CASE("a witness saves time and never changes the answer") {
  Random random(913);
  int kept = 0;
  int apart = 0;
  const auto follow = [&](auto a, auto b, const auto& move) {
    contact::SeparatingWitness witness;
    const V velocity = direction(random) * 0.02;
    for (int step = 0; step < 100; ++step) {
      const V before = witness.axis;
      const Proximity answer = contact::proximity_with_witness(a, b, witness);
      const Proximity right = contact::proximity(a, b);
      CHECK(answer == right);
      if (right == Proximity::disjoint) {
        ++apart;
        kept += witness.axis == before ? 1 : 0;
        CHECK((witness.axis == before || contact::surely_separates(a, b, witness.axis) ||
               contact::signed_distance(a, b).distance < 1e-12));
      }
      move(a, velocity);
    }
  };
  const auto move_box = [](Box& b, const V& v) {
    b.centre += v;
    b.axes = contact::matrix_of(contact::exponential<double>(v)) * b.axes;
  };
  const auto move_capsule = [](Capsule<double>& c, const V& v) {
    c.core.start += v;
    c.core.end += v * 1.5;
  };
  for (int i = 0; i < tried(100); ++i) {
    follow(box(random, Kind::any), box(random, Kind::any), move_box);
    follow(Capsule<double>{segment(random, Kind::any), 0.3}, box(random, Kind::any), move_capsule);
    follow(Capsule<double>{segment(random, Kind::any), 0.3},
           Capsule<double>{segment(random, Kind::any), 0.4}, move_capsule);
  }
  CHECK(kept > apart * 9 / 10);
}

TEST_CASE("a certificate is a proof: whatever direction it accepts separates in fractions") {
  Random random(914);
  int accepted = 0;
  for (int i = 0; i < tried(4000); ++i) {
    const Box a = box(random, kinds[i % 6]);
    const Box b = partner(random, kinds[i % 6], a);
    const V n = random.chance(0.5) ? contact::likely_axis(a, b) : direction(random);
    if (!contact::surely_separates(a, b, n)) continue;
    ++accepted;
    const Vector e = oracle::exact(n);
    const Rational separation = e.dot(Vector(exact(a).centre - exact(b).centre)) -
                                contact::projected_radius<Rational>(exact(a), e) -
                                contact::projected_radius<Rational>(exact(b), e);
    CHECK(separation > 0);
  }
  CHECK(accepted > tried(500));
  const Sphere<double> ball{V(0, 0, 2), 1};
  CHECK_FALSE(contact::surely_separates(ball, Sphere<double>{V(0, 0, -2), 1}, V(0, 0, 0)));
  // The radius must not be lost if squares underflow.
  CHECK_FALSE(contact::surely_separates(ball, Sphere<double>{V(0, 0, 1), 1}, V(0, 0, 0x1p-560)));
}

TEST_CASE("the same in float, with errors of float's u") {
  Random random(915);
  constexpr double float_u = 0x1p-24;
  for (int i = 0; i < tried(1000); ++i) {
    const Box a = box(random, Kind::any);
    const Box b = box(random, Kind::any);
    const auto narrow = [](const Box& x) {
      return OrientedBox<float>{x.centre.cast<float>(), x.axes.cast<float>(),
                                x.half_lengths.cast<float>()};
    };
    const auto found = contact::signed_distance(narrow(a), narrow(b));
    CHECK(std::abs(double(found.distance) - contact::signed_distance(a, b).distance) <=
          96 * float_u * (size_of(a) + size_of(b)));
    const Sphere<float> ball{a.centre.cast<float>(), 0.5F};
    CHECK(std::abs(double(contact::signed_distance(ball, narrow(b)).distance) -
                   contact::signed_distance(Sphere<double>{a.centre, 0.5}, b).distance) <=
          96 * float_u * (size_of(a.centre) + size_of(b)));
  }
}

TEST_CASE("invalid bodies are refused, with the argument's name and value") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(refusal([&] { contact::sphere_from_radius<double>(V(0, nan, 0), 1); }), "centre"));
  CHECK(contains(refusal([&] { contact::sphere_from_radius<double>(V(0, 0, 0), -1); }),
                 "radius = -1"));
  CHECK(contains(refusal([&] { contact::sphere_from_radius<double>(V(0, 0x1p300, 0), 1); }),
                 "out of range"));
  CHECK(contains(refusal([&] { contact::half_space_behind<double>({V(0, 0, 2), 1}); }), "normal"));
  CHECK(contains(refusal([&] {
                   contact::half_space_behind<double>({V(0, 0, 1), nan});
                 }),
                 "offset"));
  Random random(916);
  for (int i = 0; i < 1000; ++i) {
    const V n = direction(random);
    CHECK(contact::half_space_behind<double>({n, 1}).boundary.normal == n);
  }
}

}  // namespace closed_proximity_test
