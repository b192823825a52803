// oriented_box.hpp against rational arithmetic.
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/oriented_box.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <set>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>
#include <utility>

namespace oriented_box_test {

using contact::CoordinateFrame;
using contact::Matrix3;
using contact::OrientedBox;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using support::contains;
using support::refusal;
using V = Vector3<double>;

/// Each coordinate from -size to size.
template <class S>
Vector3<S> any_point(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {S(x), S(y), static_cast<S>(random.uniform(-size, size))};
}

/// The stored axes of some frame.
template <class S>
CoordinateFrame<S> any_frame(Random& random, double size) {
  Vector3<S> normal = any_point<S>(random, 1);
  if (normal == Vector3<S>::Zero()) normal = Vector3<S>::UnitX();
  return contact::frame_on_normal<S>(any_point<S>(random, size), normal);
}

Matrix3<Rational> exact(const Matrix3<double>& m) {
  Matrix3<Rational> r;
  for (int k = 0; k < 3; ++k) r.col(k) = oracle::exact(V(m.col(k)));
  return r;
}

TEMPLATE_TEST_CASE(
    "the axis-aligned box of an oriented box contains its corners, and is hardly larger", "", float,
    double) {
  using S = TestType;
  Random random(12);
  for (int i = 0; i < generators::tried(2000); ++i) {
    Vector3<S> normal = any_point<S>(random, 1);
    if (normal == Vector3<S>::Zero()) normal = Vector3<S>::UnitX();
    const auto frame = contact::frame_on_normal<S>(any_point<S>(random, 1e3), normal);
    const Vector3<S> half = any_point<S>(random, i % 2 == 0 ? 1 : 1e-40).cwiseAbs();
    const contact::OrientedBox<S> oriented{frame.origin, frame.axes, half};
    const auto box = contact::aabb_of_oriented_box(oriented);
    for (int k = 0; k < 3; ++k) {
      Rational reach = 0;
      for (int j = 0; j < 3; ++j)
        reach += abs(oracle::exact(frame.axes(k, j))) * oracle::exact(half(j));
      const Rational centre = oracle::exact(frame.origin(k));
      CHECK(oracle::exact(box.low(k)) <= centre - reach);
      CHECK(oracle::exact(box.high(k)) >= centre + reach);
      const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
      const Rational room = 16 * u * reach + 2 * u * (abs(centre) + reach) +
                            4 * oracle::exact(std::numeric_limits<S>::denorm_min());
      CHECK(oracle::exact(box.high(k)) <= centre + reach + room);
    }
  }
}

TEST_CASE("corners, edges and the pose of a box") {
  Random random(13);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<double>);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const auto own = any_frame<double>(random, 3);
    const OrientedBox<double> box =
        contact::oriented_box_from_axes<double>(own.origin, own.axes, {0.5, 2, 3});
    const OrientedBox<Rational> right{oracle::exact(box.centre), exact(box.axes),
                                      oracle::exact(box.half_lengths)};
    for (int k = 0; k < 8; ++k) {
      oracle::Vector corner = right.centre, size = right.centre.cwiseAbs();
      for (int j = 0; j < 3; ++j) {
        const oracle::Vector step = right.axes.col(j) * right.half_lengths(j);
        corner += (k >> j & 1) != 0 ? step : oracle::Vector(-step);
        size += step.cwiseAbs();
      }
      REQUIRE(contact::box_corner(right, k) == corner);
      const oracle::Vector got = oracle::exact(contact::box_corner(box, k));
      for (int j = 0; j < 3; ++j) REQUIRE(abs(got(j) - corner(j)) <= 7 * u * size(j) * 2);
    }
    // Every edge goes from one corner to another along an axis, and none is twice the same.
    std::set<std::pair<int, int>> edges;
    for (int k = 0; k < 12; ++k) {
      const auto edge = contact::box_edge(right, k);
      REQUIRE(edge.end - edge.start ==
              oracle::Vector(right.axes.col(k / 4) * right.half_lengths(k / 4) * Rational(2)));
      std::pair<int, int> ends{-1, -1};
      for (int j = 0; j < 8; ++j) {
        if (contact::box_corner(right, j) == edge.start) ends.first = j;
        if (contact::box_corner(right, j) == edge.end) ends.second = j;
      }
      REQUIRE((ends.first >= 0 && ends.second >= 0));
      edges.insert(ends);
    }
    REQUIRE(edges.size() == 12);
    const auto frame = any_frame<double>(random, 3);
    const CoordinateFrame<Rational> right_frame{oracle::exact(frame.origin), exact(frame.axes)};
    const auto moved = contact::transformed(right, right_frame);
    for (int k = 0; k < 8; ++k)
      REQUIRE(contact::box_corner(moved, k) ==
              contact::position_in_world(right_frame, contact::box_corner(right, k)));
    REQUIRE(contact::transformed(box, CoordinateFrame<double>{}).axes == box.axes);
    const auto rounded = contact::transformed(box, frame);
    REQUIRE(rounded.half_lengths == box.half_lengths);
    for (int j = 0; j < 9; ++j)
      REQUIRE(abs(oracle::exact(rounded.axes(j % 3, j / 3)) - moved.axes(j % 3, j / 3)) <= 6 * u);
  }
}

TEST_CASE("an invalid oriented box is refused, with the argument and the value") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double largest = std::numeric_limits<double>::max();
  const Matrix3<double> identity = Matrix3<double>::Identity();
  const auto make = [](const V& centre, const Matrix3<double>& axes, const V& half_lengths) {
    return refusal([&] { contact::oriented_box_from_axes<double>(centre, axes, half_lengths); });
  };
  CHECK(contains(make(V(0, nan, 0), identity, V(1, 1, 1)), "centre"));
  CHECK(contains(make(V(0, 0x1p300, 0), identity, V(1, 1, 1)), "out of range"));
  CHECK(contains(make(V(0, 0, 0), identity, V(1, 0, 1)), "half_lengths = 0"));
  CHECK(contains(make(V(0, 0, 0), Matrix3<double>(-identity), V(1, 1, 1)), "axes = (-1"));
  CHECK(contains(make(V(0, 0, 0), Matrix3<double>(identity * 1.001), V(1, 1, 1)), "orthonormal"));
  const auto bound = [](const OrientedBox<double>& box) {
    return refusal([&] { contact::aabb_of_oriented_box<double>(box); });
  };
  CHECK(contains(bound({V(0, nan, 0), identity, V(1, 1, 1)}), "centre = (0, nan, 0)"));
  CHECK(contains(bound({V(0, 0, 0), identity, V(1, -1, 1)}), "half_lengths = (1, -1, 1)"));
  CHECK(contains(bound({V(0, 0, 0), identity, V(1, largest, 1)}), "its box overflows"));
  CHECK(contains(bound({V(largest, 0, 0), identity, V(1e300, 1, 1)}), "its box overflows"));
  Random random(15);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const auto frame = any_frame<double>(random, 3);
    CHECK(contact::oriented_box_from_axes<double>(frame.origin, frame.axes, V(1, 2, 3)).axes ==
          frame.axes);
  }
}

}  // namespace oriented_box_test
