// The distance of any two shapes against exact arithmetic and closed forms.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>

#include "sound_scene.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::BallShape;
using contact::BoxShape;
using contact::CapsuleShape;
using contact::HalfSpaceShape;
using contact::HullShape;
using contact::Quaternion;
using contact::SceneBody;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using sound_scene::body_of;
using sound_scene::infinity;
using sound_scene::u;

namespace {

/// The distance of two bodies, which must be defined.
double gap_of(const SceneBody& a, const SceneBody& b) {
  const auto gap = contact::starting_gap(a, b);
  REQUIRE(gap);
  CHECK(*contact::starting_gap(b, a) == *gap);
  return *gap;
}

Rational squared(const oracle::Vector& v) { return v.dot(v); }

}  // namespace

TEST_CASE(
    "Two balls: the signed distance has the sign of exact arithmetic, except within the slack") {
  Random random(3);
  int touching = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const bool grid = random.chance(0.5);
    const auto number = [&] {
      return grid ? static_cast<double>(random.integer(-8, 8)) : random.uniform(-8, 8);
    };
    const auto vector = [&] {
      const double x = number();
      const double y = number();
      return Vector3<double>(x, y, number());
    };
    const Vector3<double> x = vector();
    const Vector3<double> y = vector();
    const double r = std::abs(number()) + 0.5;
    const double s = grid ? std::abs(number()) + 0.5 : std::abs((x - y).norm() - r) + 0.001;
    const SceneBody a = body_of("a", BallShape{r}, x);
    const SceneBody b = body_of("b", BallShape{s}, y);
    const double gap = gap_of(a, b);
    const double slack = contact::touching_slack(a, b);
    const oracle::Vector d = oracle::exact(x) - oracle::exact(y);
    const Rational reach = Rational(r) + Rational(s);
    const Rational beyond = squared(d) - reach * reach;  // its sign is that of the distance
    if (std::abs(gap) > slack) CHECK((gap > 0) == (beyond > 0));
    if (beyond == 0) {
      ++touching;
      CHECK(gap >= -slack);
    }
  }
  CHECK(touching > 0);
}

TEST_CASE("A rotated box or hull over a half-space: the deepest vertex decides") {
  Random random(4);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const double hx = random.uniform(0.1, 3);
    const double hy = random.uniform(0.1, 3);
    const double hz = random.uniform(0.1, 3);
    HullShape corners;
    for (int k = 0; k < 8; ++k)
      corners.points.emplace_back((k & 1) != 0 ? hx : -hx, (k & 2) != 0 ? hy : -hy,
                                  (k & 4) != 0 ? hz : -hz);
    const double x = random.uniform(-5, 5);
    const double y = random.uniform(-5, 5);
    const Vector3<double> place(x, y, random.uniform(-5, 5));
    SceneBody box = body_of("box", BoxShape{{hx, hy, hz}}, place);
    const double a = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    const double c = random.uniform(-1, 1);
    box.orientation = contact::normalised<double>({random.uniform(0.1, 1), {a, b, c}});
    SceneBody hull = box;
    hull.shape = corners;
    HalfSpaceShape ground;
    const double p = random.uniform(-1, 1);
    const double q = random.uniform(-1, 1);
    ground.normal = Vector3<double>(p, q, random.uniform(0.1, 1)).normalized();
    ground.offset = random.uniform(-2, 2);
    const SceneBody floor = body_of("floor", ground, {0, 0, 0}, false);
    double least = infinity;
    for (const Vector3<double>& corner : corners.points) {
      const Vector3<double> there = place + contact::matrix_of(box.orientation) * corner;
      least = std::min(least, ground.normal.dot(there) - ground.offset);
    }
    CHECK(std::abs(gap_of(box, floor) - least) <= 64 * u * 16);
    CHECK(std::abs(gap_of(hull, floor) - least) <= 64 * u * 16);
    // A ball that contains the box extends at least as far as the box's support in every direction.
    CHECK(contact::bounding_radius(box.shape) >=
          ground.normal.dot(place) - ground.offset - least - 64 * u * 16);
  }
}

TEST_CASE("A ball at a box: in front of a face, an edge and a corner, and inside") {
  const SceneBody box = body_of("box", BoxShape{{1, 2, 3}}, {10, 0, 0});
  const auto gap = [&](double x, double y, double z) {
    return gap_of(body_of("ball", BallShape{0.5}, {x, y, z}), box);
  };
  CHECK(gap(12, 0, 0) == 0.5);
  CHECK(gap(11.5, 0, 0) == 0);
  CHECK(gap(10, 0, -4) == 0.5);
  CHECK(gap(14, 6, 0) == 4.5);       // 3 and 4 beyond an edge
  CHECK(gap(13, -5, 9) == 6.5);      // 2, 3 and 6 beyond a corner: 7
  CHECK(gap(10.5, 0, 0) == -1);      // 0.5 below a face, and the radius
  CHECK(gap(10, 0, 2.75) == -0.75);  // 0.25 below the nearest face
  SceneBody turned = box;            // a quarter of a revolution about z: x and y are exchanged
  turned.orientation = {std::sqrt(0.5), {0, 0, std::sqrt(0.5)}};
  const double got = gap_of(body_of("ball", BallShape{0.5}, {13, 0, 0}), turned);
  CHECK(std::abs(got - 0.5) <= 64 * u);
}

TEST_CASE("A ball at a capsule: beside the segment and beyond its ends") {
  const SceneBody rod = body_of("rod", CapsuleShape{0.25, 2}, {0, 0, 1});
  const auto gap = [&](double x, double y, double z) {
    return gap_of(body_of("ball", BallShape{0.5}, {x, y, z}), rod);
  };
  CHECK(gap(1.75, 0, 2.5) == 1);
  CHECK(gap(0, 0, 4) == 0.25);
  CHECK(gap(3, 0, 7) == 4.25);
  CHECK(gap(0, 0, 0) == -0.75);
}

TEST_CASE("Two half-spaces have no distance") {
  const SceneBody floor = body_of("floor", HalfSpaceShape{}, {0, 0, 0}, false);
  CHECK_FALSE(contact::starting_gap(floor, floor));
}

TEST_CASE(
    "The distance between tetrahedra: face to face, vertex to face, edge to edge, and "
    "overlapping") {
  const HullShape shape{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  const auto gap = [&](double x, double y, double z) {
    return gap_of(body_of("a", shape, {0, 0, 0}), body_of("b", shape, {x, y, z}));
  };
  // From -2 to 2 along each axis the differences of two points of them reach: a cuboctahedron.
  CHECK(gap(2.5, 0, 0) == 0.5);
  CHECK(gap(2, 0, 0) == 0);
  CHECK(gap(1.75, 0, 0) == -0.25);
  CHECK(std::abs(gap(3, 3, 0) - std::sqrt(2.0)) <= 16 * u);       // beyond the corner (2, 2, 0)
  CHECK(std::abs(gap(2, 2, 2) - 2 / std::sqrt(3.0)) <= 16 * u);   // over x + y + z = 4
  CHECK(std::abs(gap(1, 1, 1) - -1 / std::sqrt(3.0)) <= 16 * u);  // below it
  CHECK(gap(0, 0, 0) == -2);
}

TEST_CASE("The hull of a box's corners has the distances of the box") {
  Random random(31);
  int apart = 0;
  for (int i = 0; i < generators::tried(160); ++i) {
    const auto size = [&] { return random.uniform(0.1, 1.0); };
    const auto somewhere = [&](const contact::SceneShape& shape) {
      SceneBody body = body_of("body", shape, {0, 0, 0}, false);
      for (int k = 0; k < 3; ++k) body.position(k) = random.uniform(-1.5, 1.5);
      Quaternion<double>& turned = body.orientation;
      turned.w = random.uniform(-1.0, 1.0);
      for (int k = 0; k < 3; ++k) turned.v(k) = random.uniform(-1.0, 1.0);
      const double length = std::sqrt(turned.w * turned.w + turned.v.squaredNorm());
      turned.w /= length;
      turned.v /= length;
      return body;
    };
    Vector3<double> half_lengths;
    for (int k = 0; k < 3; ++k) half_lengths(k) = size();
    const SceneBody box = somewhere(BoxShape{half_lengths});
    SceneBody hull = box;
    HullShape corners;
    for (int k = 0; k < 8; ++k) {
      const Vector3<double> signs((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1,
                                  (k & 4) != 0 ? 1 : -1);
      corners.points.emplace_back(signs.cwiseProduct(half_lengths));
    }
    hull.shape = corners;
    const double width = size();
    const double height = size();
    const double length = size();
    for (const contact::SceneShape& shape : {contact::SceneShape(BallShape{width}),
                                             contact::SceneShape(BoxShape{{width, height, 0.3}}),
                                             contact::SceneShape(CapsuleShape{width, length})}) {
      const SceneBody other = somewhere(shape);
      const double wanted = gap_of(box, other);
      CHECK(std::abs(gap_of(hull, other) - wanted) <= 0x1p-44);
      apart += wanted > 0 ? 1 : 0;
    }
  }
  CHECK(apart > generators::tried(96));
  CHECK(apart < generators::tried(448));
}

TEST_CASE("Distances between boxes and capsules are those of the closed forms, in either order") {
  const SceneBody box = body_of("box", BoxShape{{1, 2, 3}}, {0, 0, 0});
  const SceneBody rod = body_of("rod", CapsuleShape{0.5, 1}, {0, 0, 0});
  const auto told = [](const SceneBody& a, SceneBody b, const Vector3<double>& at) {
    b.position = at;
    const auto one = contact::starting_gap(a, b);
    const auto other = contact::starting_gap(b, a);
    REQUIRE(one.has_value());
    CHECK(one == other);
    return *one;
  };
  CHECK(told(box, box, {2.25, 0, 0}) == 0.25);
  CHECK(told(box, box, {2, 0, 0}) == 0);
  CHECK(told(box, box, {1.75, 0.5, 0.5}) == -0.25);
  CHECK(told(box, rod, {1.75, 0, 0}) == 0.25);
  CHECK(told(box, rod, {0, 0, 4.25}) == -0.25);
  CHECK(told(rod, rod, {1.5, 0, 0.5}) == 0.5);
  CHECK(told(rod, rod, {0.75, 0, 1}) == -0.25);
}
