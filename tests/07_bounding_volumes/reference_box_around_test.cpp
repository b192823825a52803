// Oriented boxes around points along given axes, against fractions.
#include <07_bounding_volumes/box_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <contact/box_around.hpp>
#include <contact/principal_axes.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace box_around_tests {

using box_truth::Points;
using contact::box_with_axes;
using contact::Matrix3;
using contact::OrientedBox;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using support::refusal;

using volume_families::span_of;

/// A rotation, rounded to S: anything, near the axes of the world, or about one of them.
template <std::floating_point S>
Matrix3<S> rotation(Random& random) {
  const auto vector = [&random](double size) {
    return Vector3<S>(generators::rounded<S>(Vector3<double>{
        random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)}));
  };
  const int kind = random.integer(0, 3);
  Vector3<S> x = vector(1), y = vector(1);
  if (kind == 1) x = Vector3<S>::Unit(0) + vector(1e-6), y = Vector3<S>::Unit(1) + vector(1e-6);
  if (kind == 2) x.z() = 0, y = Vector3<S>::Unit(2);
  return contact::principal_axes_detail::orthonormal<S>(x, y);
}

/// The axes of the world in another order, with other signs, right-handed.
Matrix3<double> permuted(Random& random) {
  const int first = random.integer(0, 2), second = (first + random.integer(1, 2)) % 3;
  Matrix3<double> axes;
  axes.col(0) = Vector3<double>::Unit(first) * (random.chance(0.5) ? 1 : -1);
  axes.col(1) = Vector3<double>::Unit(second) * (random.chance(0.5) ? 1 : -1);
  axes.col(2) = Vector3<double>(axes.col(0)).cross(Vector3<double>(axes.col(1)));
  return axes;
}

TEMPLATE_TEST_CASE("a box with given axes contains the points that made it, as it is stored", "",
                   float, double) {
  using S = TestType;
  Random random(1);
  for (int i = 0; i < generators::tried(440); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const int count = random.integer(1, 12);
    Points<S> points = volume_families::points<S>(random, family, count);
    if (i % 3 == 0) points = volume_families::scaled<S>(points, S(std::ldexp(1.0, -100)));
    const OrientedBox<S> box = box_with_axes<S>(rotation<S>(random), span_of<S>(points));
    INFO(volume_families::name(family) << ", case " << i);
    REQUIRE(box_truth::all_inside(box, points));
  }
}

TEMPLATE_TEST_CASE("a half length is at most 500 u of the size larger than the points require", "",
                   float, double) {
  using S = TestType;
  Random random(2);
  const Rational room = 500 * oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(220); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const Points<S> points = volume_families::points<S>(random, family, 10);
    const OrientedBox<S> box = box_with_axes<S>(rotation<S>(random), span_of<S>(points));
    oracle::Vector most = oracle::Vector::Zero();
    Rational size = 0;
    for (const auto& p : points) {
      const oracle::Vector x = *box_truth::coordinates(box, p);
      for (int k = 0; k < 3; ++k) {
        most[k] = std::max(most[k], Rational(abs(x[k])));
        size = std::max(size, Rational(abs(x[k])));
      }
    }
    INFO(volume_families::name(family) << ", case " << i);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(oracle::exact(box.half_lengths[k]) <= most[k] + room * size);
    }
  }
}

TEST_CASE("along the axes of the world a half length is the smallest for the centre as stored") {
  Random random(3);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const auto points = volume_families::points<double>(random, family, 6);
    const Matrix3<double> axes = permuted(random);
    const auto box = box_with_axes<double>(axes, span_of<double>(points));
    REQUIRE(box_truth::all_inside(box, points));
    for (int k = 0; k < 3; ++k) {
      if (box.half_lengths[k] == 0) continue;
      auto less = box;
      less.half_lengths[k] = std::nextafter(less.half_lengths[k], 0.0);
      REQUIRE_FALSE(box_truth::all_inside(less, points));
    }
  }
}

TEST_CASE("a set that is flat along an axis of the world gets half length 0") {
  Random random(4);
  for (int i = 0; i < generators::tried(500); ++i) {
    auto points = volume_families::points<double>(random, volume_families::Family::in_box, 5);
    const int flat = random.integer(0, 2);
    const double at = random.magnitude(-1074, 1000);
    for (auto& p : points) p[flat] = at;
    const auto box = box_with_axes<double>(permuted(random), span_of<double>(points));
    REQUIRE(box.half_lengths.minCoeff() == 0);
    REQUIRE(box_truth::all_inside(box, points));
  }
}

TEST_CASE("a set of equal points gets a box without extent, along any axes") {
  Random random(5);
  for (int i = 0; i < generators::tried(300); ++i) {
    const Points<double> points(3, generators::any_vector(random));
    const auto box = box_with_axes<double>(rotation<double>(random), span_of<double>(points));
    REQUIRE(box.half_lengths == Vector3<double>::Zero());
    REQUIRE(contact::contains(box, points.front()));
  }
}

TEMPLATE_TEST_CASE("contains() says of points on and next to the border what fractions say", "",
                   float, double) {
  using S = TestType;
  Random random(6);
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Points<S> points = volume_families::points<S>(
        random, volume_families::all[static_cast<std::size_t>(i) % 10], 5);
    OrientedBox<S> box = box_with_axes<S>(rotation<S>(random), span_of<S>(points));
    if (i % 4 == 0) {  // whole numbers, so that points are exactly on faces
      box.axes = Matrix3<S>::Identity();
      for (int k = 0; k < 3; ++k) box.half_lengths[k] = S(random.integer(0, 3));
      box.centre = Vector3<S>::Zero();
    }
    if (i % 4 == 1) box.axes.col(0) *= S(-1);  // left-handed
    Vector3<S> p = contact::box_corner(box, random.integer(0, 7));
    const int k = random.integer(0, 2);
    p += S(random.uniform(-1, 1)) * box.half_lengths[k] * Vector3<S>(box.axes.col(k));
    const int j = random.integer(0, 2);
    p[j] = std::nextafter(p[j], S(random.integer(-1, 1)) * std::numeric_limits<S>::max());
    const bool inside = contact::contains(box, p);
    ++seen[inside];
    INFO("case " << i);
    REQUIRE(inside == box_truth::inside(box, p));
  }
  CHECK(seen[true] > generators::tried(300));
  CHECK(seen[false] > generators::tried(300));
}

TEST_CASE("contains() is right about bit patterns of any size") {
  Random random(7);
  for (int i = 0; i < generators::tried(1500); ++i) {
    OrientedBox<double> box;
    box.centre = generators::any_vector(random);
    box.half_lengths = generators::any_vector(random).cwiseAbs();
    for (int k = 0; k < 3; ++k) box.axes.col(k) = generators::any_vector(random);
    const Vector3<double> p = i % 2 == 0 ? box.centre : generators::any_vector(random);
    REQUIRE(contact::contains(box, p) == box_truth::inside(box, p));
  }
}

TEST_CASE("what is not finite, a negative half length and dependent axes contain nothing") {
  const OrientedBox<double> box{Vector3<double>::Zero(), Matrix3<double>::Identity(),
                                Vector3<double>::Ones()};
  const Vector3<double> p(0.5, 0.5, 0.5);
  REQUIRE(contact::contains(box, p));
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (int k = 0; k < 3; ++k) {
      auto broken = box;
      broken.centre[k] = bad;
      CHECK_FALSE(contact::contains(broken, p));
      broken = box;
      broken.half_lengths[k] = bad;
      CHECK_FALSE(contact::contains(broken, p));
      broken = box;
      broken.axes(k, 0) = bad;
      CHECK_FALSE(contact::contains(broken, p));
      Vector3<double> q = p;
      q[k] = bad;
      CHECK_FALSE(contact::contains(box, q));
      CHECK_FALSE(contact::inside_six_planes(box, q));
      CHECK_FALSE(contact::between_each_pair(box, q));
    }
  }
  auto broken = box;
  broken.half_lengths[1] = -1;
  CHECK_FALSE(contact::contains(broken, Vector3<double>(0, 0, 0)));
  broken = box;
  broken.axes.col(1) = box.axes.col(0);
  CHECK_FALSE(contact::contains(broken, Vector3<double>(0, 0, 0)));
}

TEST_CASE("six planes and three slabs agree with contains() away from the border") {
  Random random(8);
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(20000); ++i) {
    OrientedBox<double> box{
        Vector3<double>{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)},
        rotation<double>(random),
        Vector3<double>{random.uniform(0.1, 3), random.uniform(0.1, 3), random.uniform(0.1, 3)}};
    Vector3<double> p = box.centre;
    for (int k = 0; k < 3; ++k) {
      double at = random.uniform(-1.5, 1.5);
      if (std::abs(std::abs(at) - 1) < 1e-9) at = 0;
      p += at * box.half_lengths[k] * Vector3<double>(box.axes.col(k));
    }
    const bool inside = contact::contains(box, p);
    ++seen[inside];
    REQUIRE(contact::inside_six_planes(box, p) == inside);
    REQUIRE(contact::between_each_pair(box, p) == inside);
  }
  CHECK(seen[true] > generators::tried(4000));
  CHECK(seen[false] > generators::tried(4000));
}

TEST_CASE("a box whose half lengths are not rounded outwards misses points that made it") {
  // Why box_with_axes() extends them: the same box with the rounded extents.
  Random random(9);
  int missed = 0;
  for (int i = 0; i < generators::tried(800); ++i) {
    const auto points = volume_families::points<double>(random, volume_families::Family::in_box, 8);
    auto box = box_with_axes<double>(rotation<double>(random), span_of<double>(points));
    box.half_lengths.setZero();
    for (const auto& p : points) {
      for (int k = 0; k < 3; ++k) {
        const double y = Vector3<double>(box.axes.col(k)).dot(Vector3<double>(p - box.centre));
        box.half_lengths[k] = std::max(box.half_lengths[k], std::abs(y));
      }
    }
    missed += box_truth::all_inside(box, points) ? 0 : 1;
  }
  CHECK(missed > generators::tried(200));
}

TEST_CASE("boxes are made at the largest and the smallest scales") {
  Random random(10);
  for (const int exponent : {-1074, -1060, -1022, -500, 500, 1000, 1020}) {
    for (int i = 0; i < generators::tried(16); ++i) {
      Points<double> points;
      for (int n = 0; n < 6; ++n) {
        points.push_back(std::ldexp(1.0, exponent) *
                         Vector3<double>{double(random.integer(-4, 4)),
                                         double(random.integer(-4, 4)),
                                         double(random.integer(-4, 4))});
      }
      const auto box = box_with_axes<double>(rotation<double>(random), span_of<double>(points));
      INFO("2^" << exponent);
      REQUIRE(box_truth::all_inside(box, points));
    }
  }
}

TEST_CASE("box_with_axes() names the argument that it does not take") {
  using support::contains;
  const Points<double> points{Vector3<double>(1, 2, 3), Vector3<double>(4, 5, 7)};
  const Matrix3<double> axes = Matrix3<double>::Identity();
  CHECK(contains(refusal([&] { box_with_axes<double>(axes, {}); }), "points = {}"));
  Points<double> broken = points;
  broken[1].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(refusal([&] { box_with_axes<double>(axes, span_of<double>(broken)); }),
                 "points = (4, nan, 7)"));
  Matrix3<double> longer = axes;
  longer(0, 0) = 1.0001;
  CHECK(contains(refusal([&] { box_with_axes<double>(longer, span_of<double>(points)); }), "axes"));
  Matrix3<double> left = axes;
  left(2, 2) = -1;
  CHECK(contains(refusal([&] { box_with_axes<double>(left, span_of<double>(points)); }), "axes"));
  const double most = std::numeric_limits<double>::max();
  const Points<double> far{Vector3<double>(most, most, most), Vector3<double>(-most, -most, -most)};
  Random random(11);
  CHECK(contains(
      refusal([&] { box_with_axes<double>(rotation<double>(random), span_of<double>(far)); }),
      "overflows"));
}

}  // namespace box_around_tests
