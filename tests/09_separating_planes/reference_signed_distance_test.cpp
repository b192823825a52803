// Every distance of the chapter against fractions. u is the unit roundoff.
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

namespace signed_distance_test {

using contact::Capsule;
using contact::HalfSpace;
using contact::Proximity;
using contact::SignedDistance;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using random_poses::direction;
using reference::box;
using reference::Box;
using reference::Kind;
using reference::kinds;
using reference::partner;
using reference::segment;
using reference::size_of;
using reference::V;
using reference::widest;
using shape_oracle::exact;
using shape_oracle::ExactBox;

namespace {

constexpr double u = 0x1p-53;

/// By how much more than `right` the two points are outside A and B, and the normal deviates from a
/// unit normal. Every answer must pass it.
template <class A, class B>
void check_signed_distance(const SignedDistance<double>& found, const A& squared_from_a,
                           const B& squared_from_b, double room) {
  CHECK(std::abs(found.normal.dot(found.normal) - 1) <= 16 * u);
  const V between = found.on_a - found.on_b - found.distance * found.normal;
  CHECK(between.cwiseAbs().maxCoeff() <= room);
  // √x − r ≤ room for a squared distance x from the core
  CHECK(squared_from_a(oracle::exact(found.on_a)) <= 1);
  CHECK(squared_from_b(oracle::exact(found.on_b)) <= 1);
}

/// Upper bound of a point's distance outside a body: (distance from its core / (radius + room))².
template <class Core>
auto out_of(const Core& core, double radius, double room) {
  return [core, radius, room](const Vector& p) {
    const Rational reach = oracle::exact(radius) + oracle::exact(room);
    return Rational(contact::exact_squared_distance<Rational>(p, core) / (reach * reach));
  };
}

}  // namespace

// A distance passes through the axes of a box and back (two dot products of three terms, each after
// a difference or a sum), a fraction of a segment and a length: fewer than 40 roundings in
// sequence, each of at most u of the coordinates. The rotation of a box has an error of up to 8 u.
// 64 u of the magnitudes of all coordinates covers them.
constexpr double distance_room = 64 * u;
TEST_CASE("signed distances of capsules are right to a few u, at any angle") {
  Random random(908);
  for (int i = 0; i < tried(6000); ++i) {
    const Kind kind = kinds[i % 6];
    Capsule<double> a{segment(random, kind), random.uniform(0, 1)};
    Capsule<double> b{partner(random, kind, a.core), random.uniform(0, 1)};
    if (random.chance(0.1)) a.core.end = a.core.start;
    const double room = distance_room * (size_of(a.core) + size_of(b.core) + a.radius + b.radius);
    const Rational squared =
        contact::exact_squared_distance<Rational>(oracle::exact(a.core), oracle::exact(b.core));
    const auto found = contact::signed_distance(a, b);
    const Rational radii = oracle::exact(a.radius) + oracle::exact(b.radius);
    CHECK(oracle::error(found.distance, oracle::Surd{-radii, 1, squared}) <= room);
    check_signed_distance(found, out_of(oracle::exact(a.core), a.radius, room),
                          out_of(oracle::exact(b.core), b.radius, room), room);
    CHECK(std::abs(contact::signed_distance(b, a).distance - found.distance) <= room);
  }
}

TEST_CASE("signed distances of capsules, spheres and boxes are right to a few u") {
  Random random(909);
  int inside = 0;
  for (int i = 0; i < tried(1200); ++i) {
    const Kind kind = kinds[i % 3];
    const Box b = box(random, kind);
    Capsule<double> a{segment(random, kind), random.uniform(0, 1)};
    if (i % 4 == 0) a.core.end = a.core.start;
    const double room = distance_room * (size_of(a.core) + size_of(b) + a.radius);
    const auto core = oracle::exact(a.core);
    const Rational squared = contact::exact_squared_distance<Rational>(core, exact(b));
    const auto found = contact::signed_distance(a, b);
    if (squared > 0) {
      CHECK(oracle::error(found.distance, oracle::Surd{-oracle::exact(a.radius), 1, squared}) <=
            room);
    } else {
      // The shortest of the exact translations: face normals, and cross products of the segment and
      // edges.
      ++inside;
      std::optional<oracle::Surd> best;
      const ExactBox eb = exact(b);
      const Vector d = core.end - core.start;
      for (int k = 0; k < 6; ++k) {
        const Vector axis = eb.axes.col(k % 3);
        const Vector n = k < 3 ? Vector(eb.axes.col((k + 1) % 3).cross(eb.axes.col((k + 2) % 3)))
                               : Vector(d.cross(axis));
        if (n.dot(n) == 0) continue;
        const Rational s = n.dot(Vector(core.start - eb.centre));
        const Rational e = n.dot(Vector(core.end - eb.centre));
        const Rational reach = contact::projected_radius<Rational>(eb, n);
        for (const Rational& g : {Rational(std::min<Rational>(s, e) - reach),
                                  Rational(-std::max<Rational>(s, e) - reach)}) {
          const auto way = oracle::divided_by_root(g, n.dot(n));
          if (!best || oracle::compare(way, *best) > 0) best = way;
        }
      }
      CHECK(oracle::error(found.distance, *best + -oracle::exact(a.radius)) <= room);
    }
    check_signed_distance(found, out_of(core, a.radius, room), out_of(exact(b), 0, room), room);
    const auto back = contact::signed_distance(b, a);
    CHECK(back.distance == found.distance);
    CHECK(back.normal == -found.normal);
  }
  CHECK(inside > tried(150));
}

TEST_CASE(
    "signed distances of boxes are right to a few u, parallel edges and nearly parallel ones "
    "included") {
  Random random(910);
  int apart = 0;
  int deep = 0;
  int edges = 0;
  for (int i = 0; i < tried(1800); ++i) {
    const Kind kind = kinds[i % 6];
    const Box a = box(random, kind);
    const Box b = partner(random, kind, a);
    const double room = distance_room * (size_of(a) + size_of(b));
    const auto right = widest(exact(a), exact(b));
    const auto found = contact::signed_distance(a, b);
    if (oracle::sign(right) > 0) {
      // The exact distance takes long; the separating plane and the two points enclose it.
      if (++apart % 24 == 0) {
        const Rational squared = contact::exact_squared_distance<Rational>(exact(a), exact(b));
        CHECK(oracle::error(found.distance, oracle::Surd{0, 1, squared}) <= room);
      }
      const V n = found.normal;
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (int k = 0; k < 8; ++k) {
        low = std::min(low, n.dot(contact::box_corner(a, k) - found.on_b));
        high = std::max(high, n.dot(contact::box_corner(b, k) - found.on_b));
      }
      // Close to touching, a direction from rounded points has an error of room / distance.
      const double tilt = room / std::max(found.distance, room);
      CHECK(low - high >=
            found.distance - room - 8 * tilt * (a.half_lengths.sum() + b.half_lengths.sum()));
    } else {
      ++deep;
      bool face = false;
      for (int k = 0; k < 3; ++k) {
        face = face || found.normal.cwiseAbs() == a.axes.col(k).cwiseAbs() ||
               found.normal.cwiseAbs() == b.axes.col(k).cwiseAbs();
      }
      edges += face ? 0 : 1;
      CHECK(oracle::error(found.distance, right) <= room);
    }
    check_signed_distance(found, out_of(exact(a), 0, room), out_of(exact(b), 0, room), room);
  }
  CHECK(apart > tried(300));
  CHECK(deep > tried(300));
  CHECK(edges > tried(30));
}

TEST_CASE("the normal of boxes that almost touch has full precision, at faces and between edges") {
  // A direction from two points at a distance of 1e-9, each with an error of an ulp, has half of
  // its digits; a body that rotates about such a plane penetrates it.
  Random random(917);
  int edges = 0;
  int faces = 0;
  for (int i = 0; i < tried(3000); ++i) {
    const Box a = box(random, Kind::any);
    Box b = box(random, Kind::any);
    const double size = size_of(a) + size_of(b);
    const double left = size * std::ldexp(random.uniform(1, 2), -random.integer(10, 40));
    const auto before = contact::signed_distance(a, b);
    if (!(before.distance > left)) continue;
    b.centre += before.normal * (before.distance - left);
    const auto widest = contact::detail::max_separation(a, b);
    const double room = distance_room * size;
    const auto found = contact::signed_distance(a, b);
    if (!(widest.separation > 64 * room)) continue;
    // Not at a corner or an end of an edge: there the line between the two points is the only
    // direction.
    const V aside = found.on_a - found.on_b - widest.normal * widest.separation;
    if (aside.norm() > 0x1p-50 * size) continue;
    (widest.axis < 6 ? faces : edges) += 1;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int k = 0; k < 8; ++k) {
      low = std::min(low, found.normal.dot(contact::box_corner(a, k) - found.on_b));
      high = std::max(high, found.normal.dot(contact::box_corner(b, k) - found.on_b));
    }
    CHECK(low - high >= found.distance - room);
  }
  CHECK(faces > tried(200));
  CHECK(edges > tried(200));
}

TEST_CASE("signed distances to half-spaces") {
  Random random(911);
  for (int i = 0; i < tried(800); ++i) {
    const HalfSpace<double> h{{direction(random), random.uniform(-3, 3)}};
    const Box a = box(random, Kind::any);
    const double room = distance_room * (size_of(a) + 4);
    const Vector n = oracle::exact(h.boundary.normal);
    Rational lowest = n.dot(contact::box_corner<Rational>(exact(a), 0));
    for (int k = 1; k < 8; ++k) {
      lowest = std::min<Rational>(lowest, n.dot(contact::box_corner<Rational>(exact(a), k)));
    }
    const auto found = contact::signed_distance(a, h);
    CHECK(oracle::error(found.distance, lowest - oracle::exact(h.boundary.offset)) <= room);
    CHECK(std::abs(contact::signed_distance(h.boundary, found.on_b)) <= room);
    CHECK(contact::exact_squared_distance<Rational>(oracle::exact(found.on_a), exact(a)) <=
          oracle::exact(room * room));
    const auto back = contact::signed_distance(h, a);
    CHECK(back.normal == -found.normal);
    CHECK(back.on_a == found.on_b);
  }
}

TEST_CASE("a translation along the normal separates overlapping bodies") {
  Random random(912);
  for (int i = 0; i < tried(3000); ++i) {
    Box a = box(random, kinds[i % 6]);
    const Box b = partner(random, kinds[i % 6], a);
    const auto found = contact::signed_distance(a, b);
    if (found.distance > 0) continue;
    const double room = 2 * distance_room * (size_of(a) + size_of(b));
    a.centre += found.normal * (room - found.distance);
    CHECK(contact::proximity(a, b) == Proximity::disjoint);
  }
}

}  // namespace signed_distance_test
