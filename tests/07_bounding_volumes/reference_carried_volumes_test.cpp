// Volumes carried along: the exact image of what is in the volume is in the result, which a result
// without the margins does not achieve.
#include <07_bounding_volumes/carried_truth.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <concepts>
#include <contact/carried_volumes.hpp>
#include <contact/slab_volumes.hpp>
#include <limits>
#include <span>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>
#include <support/rounding.hpp>
#include <vector>

namespace carried_volumes_test {
namespace {

using carried_truth::any_frame;
using carried_truth::corners;
using carried_truth::image;
using carried_truth::inside;
using contact::Aabb;
using contact::aabb_of_carried;
using contact::carried;
using contact::CoordinateFrame;
using contact::Kdop;
using contact::Matrix3;
using contact::OrientedBox;
using contact::Sphere;
using contact::stretch_of;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using Point = Vector3<double>;

Point any_vector(Random& random, double size) {
  return Point{random.uniform(-size, size), random.uniform(-size, size),
               random.uniform(-size, size)};
}
/// The unit vector that stored axes lengthen most, by iteration in long double.
template <std::floating_point S>
Point longest_direction(const Matrix3<S>& axes, const Point& start) {
  const Matrix3<long double> a = axes.template cast<long double>();
  // A rounded rotation lengthens all vectors nearly alike: iterate with what differs from 1.
  const Matrix3<long double> off = a.transpose() * a - Matrix3<long double>::Identity();
  const Matrix3<long double> power = off + off.cwiseAbs().sum() * Matrix3<long double>::Identity();
  Vector3<long double> x = start.cast<long double>();
  for (int i = 0; i < 60; ++i) {
    const Vector3<long double> next = power * x;
    const long double length = next.norm();
    if (!(length > 0)) break;
    x = next / length;
  }
  return x.cast<double>();
}
template <std::floating_point S>
Rational largest_coordinate(const CoordinateFrame<S>& frame, const Point& p) {
  Rational largest = 0;
  for (int k = 0; k < 3; ++k) {
    largest = std::max(largest, Rational(abs(oracle::exact(frame.origin[k]))));
    largest = std::max(largest, Rational(abs(oracle::exact(p[k]))));
  }
  return largest;
}

// ---------------------------------------------------------------- spheres

template <std::floating_point S>
void check_sphere(std::uint64_t seed, int low, int high) {
  Random random(seed);
  int missed_as_it_is = 0;
  const int count = generators::tried(1000);
  for (int i = 0; i < count; ++i) {
    const S scale = std::ldexp(S(1), random.integer(low, high));
    CoordinateFrame<S> frame = any_frame<S>(random);
    frame.origin *= i % 2 == 0 ? S(0) : scale;
    const Sphere<S> sphere{generators::rounded<S>(any_vector(random, i % 4 == 0 ? 0 : 2)) * scale,
                           S(random.uniform(0, 2)) * scale};
    const Sphere<S> result = carried(sphere, frame);
    const Sphere<S> as_it_is{contact::position_in_world(frame, sphere.centre), sphere.radius};
    bool missed = false;
    INFO("case " << i);
    for (int n = 0; n < 4; ++n) {
      const Point start = carried_truth::any_direction(random);
      const Vector direction =
          carried_truth::unit_near(n < 2 ? longest_direction(frame.axes, start) : start);
      const Rational r = n % 2 == 0 ? oracle::exact(sphere.radius) : -oracle::exact(sphere.radius);
      const Vector p = image(frame, oracle::exact(sphere.centre) + Vector(r * direction));
      REQUIRE(inside(result, p));
      missed = missed || !inside(as_it_is, p);
    }
    missed_as_it_is += missed;
    const Rational growth = oracle::exact(result.radius) - oracle::exact(sphere.radius);
    const Rational size = largest_coordinate(frame, sphere.centre.template cast<double>());
    REQUIRE(growth <= rounding::u<S>() * (20 * oracle::exact(sphere.radius) + 75 * size) +
                          64 * rounding::eta<S>());
  }
  CHECK(missed_as_it_is > count / 4);
}

TEST_CASE("the image of a sphere is in the carried one, but often not with the same radius") {
  check_sphere<double>(1, 0, 0);
  check_sphere<double>(2, -900, 900);
  check_sphere<float>(3, -60, 60);
}

TEST_CASE("the image of a subnormal sphere is in the carried one") {
  check_sphere<double>(4, -1070, -1060);
}

TEST_CASE("the stretch bounds how much axes lengthen any vector, also oblique ones") {
  Random random(5);
  int columns_miss = 0;
  const int count = generators::tried(600);
  for (int i = 0; i < count; ++i) {
    Matrix3<double> axes = any_frame<double>(random).axes;
    if (i % 2 == 0) axes(random.integer(0, 2), random.integer(0, 2)) += random.magnitude(-50, -1);
    const Rational s = oracle::exact(stretch_of(axes));
    Rational longest = 0;
    for (int j = 0; j < 3; ++j) {
      const Vector column = carried_truth::exact(axes).col(j);
      longest = std::max(longest, Rational(column.dot(column)));
    }
    bool missed = false;
    INFO("case " << i);
    for (int n = 0; n < 4; ++n) {
      const Point start = carried_truth::any_direction(random);
      const Vector x = carried_truth::unit_near(n < 3 ? longest_direction(axes, start) : start);
      const Vector y = carried_truth::exact(axes) * x;
      REQUIRE(y.dot(y) <= s * s);
      missed = missed || y.dot(y) > longest;
    }
    columns_miss += missed;
  }
  CHECK(columns_miss > count / 4);
  CHECK(stretch_of(Matrix3<double>(Matrix3<double>::Identity())) <= 1 + 0x1p-48);
}

// ---------------------------------------------------------------- boxes

template <std::floating_point S>
Aabb<S> any_box(Random& random, S scale) {
  const Point p = any_vector(random, 2), q = any_vector(random, 2);
  return {generators::rounded<S>(Point(p.cwiseMin(q))) * scale,
          generators::rounded<S>(Point(p.cwiseMax(q))) * scale};
}

template <std::floating_point S>
void check_boxes(std::uint64_t seed, int low, int high) {
  Random random(seed);
  int missed_as_it_is = 0, missed_again = 0, missed_nearest = 0;
  const int count = generators::tried(300);
  for (int i = 0; i < count; ++i) {
    const S scale = std::ldexp(S(1), random.integer(low, high));
    CoordinateFrame<S> frame = any_frame<S>(random), second = any_frame<S>(random);
    frame.origin *= scale * S(0x1p-20);
    second.origin *= scale * S(0x1p-20);
    const Aabb<S> box = any_box<S>(random, scale);
    const OrientedBox<S> once = carried(box, frame);
    const OrientedBox<S> twice = carried(once, second);
    const Aabb<S> around = aabb_of_carried(box, frame);
    // As often written: everything rounded to nearest.
    const Vector3<S> middle = (box.low + box.high) / S(2);
    const OrientedBox<S> plain{contact::position_in_world(frame, middle), frame.axes,
                               Vector3<S>(box.high - middle)};
    const OrientedBox<S> again = contact::transformed(once, second);
    Aabb<S> arvo{frame.origin, frame.origin};
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        const S a = frame.axes(k, j) * box.low[j], b = frame.axes(k, j) * box.high[j];
        arvo.low[k] += std::min(a, b);
        arvo.high[k] += std::max(a, b);
      }
    }
    bool missed = false, missed_second = false, missed_around = false;
    INFO("case " << i);
    for (const Vector& corner : corners(box)) {
      const Vector p = image(frame, corner);
      REQUIRE(inside(once, p));
      REQUIRE(inside(around, p));
      missed = missed || !inside(plain, p);
      missed_around = missed_around || !inside(arvo, p);
    }
    for (const Vector& corner : corners(once)) {
      const Vector p = image(second, corner);
      REQUIRE(inside(twice, p));
      missed_second = missed_second || !inside(again, p);
    }
    missed_as_it_is += missed;
    missed_again += missed_second;
    missed_nearest += missed_around;
    // The growth: some u of the size.
    const S size = scale * S(0x1p13);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(twice.half_lengths[k] - once.half_lengths[k] <=
              S(200) * contact::tolerance::unit_roundoff<S> * size);
      REQUIRE(arvo.low[k] - around.low[k] <= S(40) * contact::tolerance::unit_roundoff<S> * size);
    }
  }
  CHECK(missed_as_it_is > count / 4);
  CHECK(missed_again > count / 4);
  CHECK(missed_nearest > count / 4);
}

TEST_CASE("the image of a box is in the carried box, but often not with unchanged half lengths") {
  check_boxes<double>(6, 0, 0);
  check_boxes<double>(7, -900, 900);
  check_boxes<float>(8, -50, 50);
}

TEST_CASE("turning a cube by an eighth about an axis makes its box wider by the root of 2") {
  CoordinateFrame<double> frame;
  const double h = std::sqrt(0.5);
  frame.axes << h, -h, 0, h, h, 0, 0, 0, 1;
  const Aabb<double> cube{Point(-1, -1, -1), Point(1, 1, 1)};
  const Aabb<double> around = aabb_of_carried(cube, frame);
  CHECK(std::abs(around.high.x() - std::sqrt(2.0)) <= 1e-14);
  CHECK(std::abs(around.high.z() - 1) <= 1e-14);
  // Carried from step to step, eight steps make it 2^(8/2) times as wide.
  Aabb<double> again = cube;
  for (int i = 0; i < 8; ++i) again = aabb_of_carried(again, frame);
  CHECK(std::abs(again.high.x() - 16) <= 1e-10);
}

// ---------------------------------------------------------------- k-DOPs

/// The exact vertices of a k-DOP of few normals: the intersections of three planes that are inside.
template <std::floating_point S>
std::vector<Vector> exact_vertices(const Kdop<S>& dop) {
  std::vector<Vector> found;
  const std::size_t n = dop.normals.size();
  const auto at = [&dop](std::size_t k, int side) {
    return oracle::exact(side == 0 ? dop.low[k] : dop.high[k]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const Vector p = oracle::exact(dop.normals[i]), q = oracle::exact(dop.normals[j]),
                     r = oracle::exact(dop.normals[k]);
        const Vector qr = q.cross(r), rp = r.cross(p), pq = p.cross(q);
        const Rational volume = p.dot(qr);
        if (volume == 0) continue;
        for (int sides = 0; sides < 8; ++sides) {
          const Vector sum = Vector(at(i, sides & 1) * qr) + Vector(at(j, sides >> 1 & 1) * rp) +
                             Vector(at(k, sides >> 2) * pq);
          const Vector x = sum / volume;
          if (inside(dop, x)) found.push_back(x);
        }
      }
    }
  }
  return found;
}

template <std::floating_point S>
void check_kdop(std::uint64_t seed, int power) {
  Random random(seed);
  const int count = generators::tried(24);
  for (int i = 0; i < count; ++i) {
    const S scale = std::ldexp(S(1), power);
    std::vector<Vector3<S>> normals = contact::kdop_normals<S>(i % 3 == 0 ? 6 : 14);
    if (i % 3 == 2) {  // normals of the reader's own
      normals.clear();
      for (int n = 0; n < 5; ++n) normals.push_back(generators::rounded<S>(any_vector(random, 3)));
    }
    std::vector<Vector3<S>> points;
    for (int n = 0; n < 6; ++n) {
      points.push_back(generators::rounded<S>(any_vector(random, 1)) * scale);
    }
    const Kdop<S> dop = contact::kdop_of_points<S>(normals, std::span<const Vector3<S>>(points));
    CoordinateFrame<S> frame = any_frame<S>(random);
    frame.origin = generators::rounded<S>(any_vector(random, 1)) * scale;
    const Kdop<S> result = carried(dop, frame);
    REQUIRE(result.normals == dop.normals);
    std::vector<Rational> low, high;
    INFO("case " << i);
    for (const Vector& vertex : exact_vertices(dop)) {
      const Vector p = image(frame, vertex);
      REQUIRE(inside(result, p));
      for (std::size_t k = 0; k < normals.size(); ++k) {
        const Rational at = oracle::exact(normals[k]).dot(p);
        if (low.size() <= k) {
          low.push_back(at);
          high.push_back(at);
        }
        low[k] = std::min(low[k], at);
        high[k] = std::max(high[k], at);
      }
    }
    // And no slab is wider than rounding requires.
    const Rational room = oracle::exact(scale) * rounding::u<S>() * 20000;
    for (std::size_t k = 0; k < normals.size(); ++k) {
      REQUIRE(oracle::exact(result.high[k]) - high[k] <= room);
      REQUIRE(low[k] - oracle::exact(result.low[k]) <= room);
    }
  }
}

TEST_CASE("the image of a k-DOP is in the carried one, and touches each of its planes") {
  check_kdop<double>(9, 0);
  check_kdop<double>(10, 400);
  check_kdop<double>(11, -400);
  check_kdop<float>(12, 0);
}

TEST_CASE("a carried k-DOP grows with each turn, the more the fewer normals it has") {
  CoordinateFrame<double> frame;
  const double h = std::sqrt(0.5);
  frame.axes << h, -h, 0, h, h, 0, 0, 0, 1;
  const std::vector<Point> cube{Point(-1, -1, -1), Point(1, -1, -1), Point(-1, 1, -1),
                                Point(1, 1, -1),   Point(-1, -1, 1), Point(1, -1, 1),
                                Point(-1, 1, 1),   Point(1, 1, 1)};
  const auto grown = [&](int k) {
    const auto dop = contact::kdop_of_points<double>(contact::kdop_normals<double>(k), cube);
    return volume(carried(dop, frame)) / volume(dop);
  };
  CHECK(std::abs(grown(6) - 2) <= 1e-13);
  CHECK(grown(14) < grown(6));
  // The diagonals of the faces are among the normals: the turned cube is a k-DOP.
  CHECK(std::abs(grown(18) - 1) <= 1e-13);
  CHECK(std::abs(grown(26) - 1) <= 1e-13);
}

// ---------------------------------------------------------------- refusals

TEST_CASE("what cannot be carried is refused by name") {
  using support::contains;
  using support::refusal;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CoordinateFrame<double> world;
  const Aabb<double> cube{Point(-1, -1, -1), Point(1, 1, 1)};
  CHECK(contains(refusal([&] { carried(Sphere<double>{Point(0, 0, 0), -1.0}, world); }), "radius"));
  CHECK(contains(refusal([&] { carried(Aabb<double>{cube.high, cube.low}, world); }), "low"));
  CHECK(contains(refusal([&] {
                   aabb_of_carried(Aabb<double>{cube.high, cube.low}, world);
                 }),
                 "low"));
  OrientedBox<double> box = carried(cube, world);
  box.half_lengths.y() = -1;
  CHECK(contains(refusal([&] { carried(box, world); }), "half_lengths"));
  CHECK(contains(refusal([&] {
                   carried(contact::kdop_of_points<double>(contact::plane_dop_normals<double>(8),
                                                           std::vector<Point>{Point(0, 0, 0)}),
                           world);
                 }),
                 "must bound a body"));
  CoordinateFrame<double> oblique;
  oblique.axes(0, 1) = 0.9;
  CHECK(contains(refusal([&] { carried(cube, oblique); }), "orthonormal"));
  CHECK(contains(refusal([&] { carried(carried(cube, world), oblique); }), "orthonormal"));
  const auto dop = contact::kdop_of_points<double>(contact::kdop_normals<double>(6),
                                                   std::vector<Point>{cube.low, cube.high});
  for (const double bad : {infinity, -infinity, nan}) {
    for (int k = 0; k < 3; ++k) {
      CoordinateFrame<double> displaced, broken;
      displaced.origin[k] = bad;
      broken.axes(k, 1) = bad;
      for (const auto& frame : {displaced, broken}) {
        CHECK_FALSE(refusal([&] { carried(Sphere<double>{Point(1, 1, 1), 1}, frame); }).empty());
        CHECK_FALSE(refusal([&] { carried(cube, frame); }).empty());
        CHECK_FALSE(refusal([&] { carried(carried(cube, world), frame); }).empty());
        CHECK_FALSE(refusal([&] { aabb_of_carried(cube, frame); }).empty());
        CHECK_FALSE(refusal([&] { carried(dop, frame); }).empty());
      }
    }
  }
  CoordinateFrame<double> far;
  far.origin = Point::Constant(std::numeric_limits<double>::max());
  const Aabb<double> large{Point::Constant(-1e308), Point::Constant(1e308)};
  CHECK(contains(refusal([&] { aabb_of_carried(large, far); }), "overflow"));
}

}  // namespace
}  // namespace carried_volumes_test
