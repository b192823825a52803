// contact_manifold.hpp against closed forms and fractions.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_manifold.hpp>
#include <contact/exact_distance.hpp>
#include <vector>

#include "09_separating_planes/random_poses.hpp"
#include "09_separating_planes/shape_oracle.hpp"
#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Capsule;
using contact::HalfSpace;
using contact::Matrix3;
using contact::Sphere;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using random_poses::direction;
using reference::box;
using reference::Box;
using reference::u;
using reference::V;
using reference::vector;

namespace {

double size_of(const Box& b) { return b.centre.cwiseAbs().sum() + b.half_lengths.sum(); }

/// Whether a point is in the box, or at most `room` outside, exactly.
bool near_box(const V& p, const Box& b, double room) {
  return contact::exact_squared_distance<Rational>(oracle::exact(p), shape_oracle::exact(b)) <=
         oracle::exact(room) * oracle::exact(room);
}

const HalfSpace<double> floor_at_zero{{V(0, 0, 1), 0}};

}  // namespace

TEST_CASE("a box on a floor: the corners within the margin, at most the four lowest") {
  const Box flat{V(1, 2, 1), Matrix3<double>::Identity(), V(3, 2, 1)};
  const auto rest = contact::contact_manifold(flat, floor_at_zero, 0.0);
  REQUIRE(rest.points.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(rest.points[i].point == contact::box_corner(flat, static_cast<int>(i)));
    CHECK(rest.points[i].distance == 0);
  }
  Random random(1801);
  for (int i = 0; i < tried(500); ++i) {
    const Box b = box(random);
    const HalfSpace<double> h{{direction(random), random.uniform(-1, 1)}};
    const double margin = random.uniform(0, 0.5);
    const double room = 32 * u * (size_of(b) + 1);
    const auto manifold = contact::contact_manifold(b, h, margin);
    const Vector n = oracle::exact(h.boundary.normal);
    std::vector<Rational> height;
    for (int k = 0; k < 8; ++k) {
      height.push_back(n.dot(contact::box_corner<Rational>(shape_oracle::exact(b), k)) -
                       oracle::exact(h.boundary.offset));
    }
    std::sort(height.begin(), height.end());
    std::size_t right = 0;
    while (right < 4 && height[right] <= oracle::exact(margin)) ++right;
    REQUIRE(manifold.points.size() == right);
    std::vector<double> got;
    for (const auto& p : manifold.points) {
      got.push_back(p.distance);
      // Midway: at equal distances from the box's corner and the floor.
      CHECK(near_box(V(p.point + manifold.normal * (p.distance / 2)), b, room));
      CHECK(std::abs(contact::signed_distance(h.boundary, p.point) - p.distance / 2) <= room);
    }
    std::sort(got.begin(), got.end());
    for (std::size_t k = 0; k < got.size(); ++k) CHECK(oracle::error(got[k], height[k]) <= room);
  }
}

TEST_CASE("a box on a box: the corners of the overlap of two rectangles, in closed form") {
  Random random(1802);
  for (int i = 0; i < tried(2000); ++i) {
    const V half(random.integer(1, 4), random.integer(1, 4), 2);
    const V other(random.integer(1, 4), random.integer(1, 4), 2);
    const double x = random.integer(-3, 3);
    const double y = random.integer(-3, 3);
    const double depth = random.integer(0, 1) / 16.0;
    const Box a{V(x, y, 4 - depth), Matrix3<double>::Identity(), half};
    const Box b{V(0, 0, 0), Matrix3<double>::Identity(), other};
    const double left = std::max(x - half.x(), -other.x());
    const double right = std::min(x + half.x(), other.x());
    const double front = std::max(y - half.y(), -other.y());
    const double back = std::min(y + half.y(), other.y());
    if (right - left <= 1 || back - front <= 1) continue;  // then a side may be less deep
    const auto manifold = contact::contact_manifold(a, b, 0.0);
    CHECK(manifold.normal == V(0, 0, 1));
    REQUIRE(manifold.points.size() == 4);
    std::vector<std::array<double, 2>> got;
    for (const auto& p : manifold.points) {
      CHECK(p.distance == -depth);
      CHECK(p.point.z() == 2 - depth / 2);
      got.push_back({p.point.x(), p.point.y()});
    }
    std::sort(got.begin(), got.end());
    const std::vector<std::array<double, 2>> wanted{
        {left, front}, {left, back}, {right, front}, {right, back}};
    CHECK(got == wanted);
  }
}

TEST_CASE("the points of two boxes lie midway between both surfaces, for any pose") {
  Random random(1803);
  int faces = 0;
  int edges = 0;
  for (int i = 0; i < tried(600); ++i) {
    const Box a = box(random);
    const Box b = box(random);
    const double room = 128 * u * (size_of(a) + size_of(b));
    const auto manifold = contact::contact_manifold(a, b, 0.0);
    const auto between = contact::signed_distance(a, b);
    if (between.distance > room) CHECK(manifold.points.empty());
    if (between.distance < -room) CHECK_FALSE(manifold.points.empty());
    CHECK(manifold.points.size() <= 8);
    faces += manifold.points.size() > 1 ? 1 : 0;
    edges += manifold.points.size() == 1 ? 1 : 0;
    for (const auto& p : manifold.points) {
      CHECK(p.distance <= room);
      const V half = manifold.normal * (p.distance / 2);
      CHECK(near_box(V(p.point + half), a, room));
      CHECK(near_box(V(p.point - half), b, room));
    }
    const auto back = contact::contact_manifold(b, a, 0.0);
    CHECK(back.points.empty() == manifold.points.empty());
  }
  CHECK(faces > tried(60));
  CHECK(edges > tried(8));
}

TEST_CASE("where corners meet the normal is the same in every run") {
  const Box a{V(2, 2, 2), Matrix3<double>::Identity(), V(1, 1, 1)};
  const Box b{V(0, 0, 0), Matrix3<double>::Identity(), V(1, 1, 1)};
  const auto corner = contact::contact_manifold(a, b, 0.0);
  REQUIRE(corner.points.size() == 1);
  CHECK(corner.normal == V(1, 0, 0));
  CHECK(corner.points[0].point == V(1, 1, 1));
  CHECK(corner.points[0].distance == 0);
  const auto back = contact::contact_manifold(b, a, 0.0);
  CHECK(back.normal == V(-1, 0, 0));
  CHECK(back.points.size() == 1);
  // A between on the diagonal: no face normal shows the distance, and the margin applies to the
  // true distance.
  const Box off{V(2.01, 2.01, 2.01), Matrix3<double>::Identity(), V(1, 1, 1)};
  CHECK(contact::contact_manifold(off, b, 0.015).points.empty());
  const auto near = contact::contact_manifold(off, b, 0.02);
  REQUIRE(near.points.size() == 1);
  CHECK(std::abs(near.points[0].distance - 0.01 * std::sqrt(3.0)) <= 1e-15);
  CHECK((near.normal - V(1, 1, 1).normalized()).norm() <= 1e-13);
}

TEST_CASE("a lying capsule has two points, and a standing one has one") {
  const Capsule<double> lying{{V(-3, 0, 1), V(3, 0, 1)}, 1};
  const Box table{V(0, 0, -1), Matrix3<double>::Identity(), V(2, 2, 1)};
  const auto on_table = contact::contact_manifold(lying, table, 0.01);
  REQUIRE(on_table.points.size() == 2);
  CHECK(on_table.points[0].point == V(-2, 0, 0));
  CHECK(on_table.points[1].point == V(2, 0, 0));
  CHECK(on_table.normal == V(0, 0, 1));
  const auto on_floor = contact::contact_manifold(lying, floor_at_zero, 0.01);
  REQUIRE(on_floor.points.size() == 2);
  CHECK(on_floor.points[1].point == V(3, 0, 0));
  const Capsule<double> standing{{V(0, 0, 1), V(0.1, 0, 5)}, 1};
  CHECK(contact::contact_manifold(standing, floor_at_zero, 0.01).points.size() == 1);
  CHECK(contact::contact_manifold(standing, table, 0.01).points.size() == 1);
  const Capsule<double> above{{V(-1, 0, 3), V(9, 0, 3)}, 1};
  const auto pair = contact::contact_manifold(above, lying, 0.0);
  REQUIRE(pair.points.size() == 2);
  CHECK(pair.points[0].point == V(-1, 0, 2));
  CHECK(pair.points[1].point == V(3, 0, 2));
  CHECK(pair.normal == V(0, 0, 1));
  const Capsule<double> crossing{{V(0, -4, 3), V(0, 4, 3)}, 1};
  CHECK(contact::contact_manifold(crossing, lying, 0.0).points.size() == 1);
  const Sphere<double> ball{V(0, 0, 3), 1};
  for (const auto& manifold :
       {contact::contact_manifold(ball, lying, 0.0), contact::contact_manifold(ball, table, 2.0),
        contact::contact_manifold(ball, floor_at_zero, 2.0),
        contact::contact_manifold(ball, Sphere<double>{V(0, 0, 0), 2}, 0.0)}) {
    REQUIRE(manifold.points.size() == 1);
    CHECK(manifold.normal == V(0, 0, 1));
  }
  CHECK(contact::contact_manifold(floor_at_zero, ball, 2.0).normal == V(0, 0, -1));
  CHECK(contact::contact_manifold(ball, floor_at_zero, 1.0).points.empty());
}
