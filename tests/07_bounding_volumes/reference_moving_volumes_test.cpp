// Volumes of moving bodies: exact positions during the motion are in the result.
#include <07_bounding_volumes/carried_truth.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <concepts>
#include <contact/moving_volumes.hpp>
#include <contact/slab_volumes.hpp>
#include <limits>
#include <span>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>
#include <support/rounding.hpp>
#include <vector>

namespace moving_volumes_test {
namespace {

using carried_truth::any_quaternion;
using carried_truth::corners;
using carried_truth::ExactMatrix;
using carried_truth::inside;
using carried_truth::rotation_of;
using carried_truth::WholeQuaternion;
using contact::Aabb;
using contact::aabb_of_motion;
using contact::Capsule;
using contact::CoordinateFrame;
using contact::Kdop;
using contact::Quaternion;
using contact::sagitta;
using contact::Sphere;
using contact::swept;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using Point = Vector3<double>;

constexpr double rounding_unit = contact::tolerance::unit_roundoff<double>;

Point any_vector(Random& random, double size) {
  return Point{random.uniform(-size, size), random.uniform(-size, size),
               random.uniform(-size, size)};
}

// ---------------------------------------------------------------- displacements

template <std::floating_point S>
void check_swept_sphere(std::uint64_t seed, int low, int high) {
  Random random(seed);
  int missed = 0;
  const int count = generators::tried(800);
  for (int i = 0; i < count; ++i) {
    const S scale = std::ldexp(S(1), random.integer(low, high));
    const Sphere<S> sphere{generators::rounded<S>(any_vector(random, 1e3)) * scale,
                           S(random.uniform(0, 1)) * scale};
    const Vector3<S> d = generators::rounded<S>(any_vector(random, 1)) * scale;
    const Capsule<S> result = swept(sphere, d);
    const Capsule<S> plain{{sphere.centre, sphere.centre + d}, sphere.radius};
    // The point furthest in the direction in which the end of the core was rounded away from it.
    const Vector end = oracle::exact(sphere.centre) + oracle::exact(d);
    const Vector off = end - oracle::exact(result.core.end);
    const Point away{oracle::nearest(off[0]), oracle::nearest(off[1]), oracle::nearest(off[2])};
    INFO("case " << i);
    for (const int eighth : {0, 3, 8}) {
      for (const Point& to : {away, any_vector(random, 1)}) {
        if (!(to.cwiseAbs().maxCoeff() > 0)) continue;
        const Vector p = oracle::exact(sphere.centre) + Rational(eighth) / 8 * oracle::exact(d) +
                         oracle::exact(sphere.radius) * carried_truth::unit_near(to);
        REQUIRE(inside(result, p));
        missed += !inside(plain, p);
      }
    }
    Rational growth = oracle::exact(result.radius) - oracle::exact(sphere.radius);
    for (int k = 0; k < 3; ++k) growth -= abs(off[k]);
    REQUIRE(growth <= 8 * rounding::u<S>() * oracle::exact(result.radius) + rounding::eta<S>());
  }
  CHECK(missed > count / 8);
}

TEST_CASE("every position of a displaced sphere is in its capsule, but not with the same radius") {
  check_swept_sphere<double>(1, 0, 0);
  check_swept_sphere<double>(2, -500, 500);
  check_swept_sphere<float>(3, -60, 60);
}

TEST_CASE("a capsule whose end is not rounded keeps the radius of the sphere") {
  const Capsule<double> capsule = swept<double>({Point(1, 2, 3), 0.1}, Point(4, -5, 6));
  CHECK(capsule.radius == 0.1);
  CHECK(capsule.core.end == Point(5, -3, 9));
}

template <std::floating_point S>
void check_swept_kdop(std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < generators::tried(300); ++i) {
    std::vector<Vector3<S>> points, all;
    for (int n = 0; n < 3; ++n) {
      points.push_back(generators::rounded<S>(any_vector(random, 1e3)));
    }
    const Vector3<S> d = generators::rounded<S>(any_vector(random, 1));
    const auto normals = contact::kdop_normals<S>(26);
    const Kdop<S> dop = contact::kdop_of_points<S>(normals, std::span<const Vector3<S>>(points));
    const Kdop<S> result = swept(dop, d);
    INFO("case " << i);
    for (const Vector3<S>& point : points) {
      for (const int eighth : {0, 5, 8}) {
        const Vector p = oracle::exact(point) + Rational(eighth) / 8 * oracle::exact(d);
        REQUIRE(inside(result, p));
      }
    }
    for (std::size_t k = 0; k < normals.size(); ++k) {  // the next number would be too small
      const Rational along = oracle::exact(normals[k]).dot(oracle::exact(d));
      const S inner = std::nextafter(result.high[k], std::numeric_limits<S>::lowest());
      const Rational needed = oracle::exact(dop.high[k]) + std::max(along, Rational(0));
      REQUIRE(oracle::exact(inner) < needed);
    }
  }
}

TEST_CASE("every position of a displaced k-DOP is in the swept one, which is the smallest") {
  check_swept_kdop<double>(4);
  check_swept_kdop<float>(5);
}

TEST_CASE("a k-DOP swept by whole numbers is that of its points at both ends") {
  const std::vector<Point> points{Point(0, 0, 0), Point(1, 2, 3), Point(-4, 0, 1)};
  const Point d(5, -6, 7);
  std::vector<Point> all = points;
  for (const Point& p : points) all.push_back(p + d);
  const auto normals = contact::kdop_normals<double>(26);
  const auto result = swept(contact::kdop_of_points<double>(normals, points), d);
  const auto wanted = contact::kdop_of_points<double>(normals, all);
  CHECK(result.low == wanted.low);
  CHECK(result.high == wanted.high);
}

// ---------------------------------------------------------------- turns

TEST_CASE("in every orientation a body is in the box of its bounding radius") {
  Random random(6);
  for (int i = 0; i < generators::tried(300); ++i) {
    const Vector centre = oracle::exact(any_vector(random, 100));
    const Vector p = oracle::exact(any_vector(random, 1));
    double radius = std::sqrt(oracle::nearest(p.dot(p)));
    while (oracle::exact(radius) * oracle::exact(radius) < p.dot(p)) {
      radius = std::nextafter(radius, 10);
    }
    const Aabb<double> box = contact::aabb_in_any_orientation(oracle::nearest(centre), radius);
    REQUIRE(inside(box, centre + rotation_of(any_quaternion(random, 9)) * p));
    for (int k = 0; k < 3; ++k) {  // the orientation in which p is furthest along an axis
      Vector q = centre;
      q[k] += oracle::exact(radius);
      REQUIRE(inside(box, q));
    }
  }
}

/// r (1 − |a · b| / |a||b|): exactly, with one square root.
oracle::Surd exact_sagitta(const WholeQuaternion& a, const WholeQuaternion& b, const Rational& r) {
  const auto inner = [](const WholeQuaternion& p, const WholeQuaternion& q) {
    return Rational(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z);
  };
  const Rational lengths = inner(a, a) * inner(b, b);
  return {r, Rational(-r * abs(inner(a, b)) / lengths), lengths};
}
template <std::floating_point S>
WholeQuaternion as_stored(const Quaternion<S>& q) {
  return {oracle::exact(q.w), oracle::exact(q.v.x()), oracle::exact(q.v.y()),
          oracle::exact(q.v.z())};
}
template <std::floating_point S>
Quaternion<S> rounded(const Quaternion<double>& q) {
  return {S(q.w), generators::rounded<S>(q.v)};
}

template <std::floating_point S>
void check_sagitta(std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto turn = [&random] {
      return Quaternion<double>{random.uniform(-1, 1), any_vector(random, 1)};
    };
    const Quaternion<double> from = contact::normalised(turn());
    Quaternion<double> to = turn();
    if (i % 2 == 0) {  // a small turn
      const double e = std::ldexp(1.0, -random.integer(1, 60));
      to = {from.w + e * to.w, Point(from.v + e * to.v)};
    }
    if (i % 3 == 0) to = {-to.w, Point(-to.v)};
    const Quaternion<S> a = rounded<S>(from), b = rounded<S>(to);
    const S r = S(random.magnitude(-20, 20)), size = std::abs(r);
    const S bound = sagitta(a, b, size);
    const oracle::Surd exact = exact_sagitta(as_stored(a), as_stored(b), oracle::exact(size));
    INFO("case " << i);
    REQUIRE(oracle::compare({oracle::exact(bound), 0, 0}, exact) >= 0);
    // Above it by a rounding, and by a few u of the half chord r sin θ/2, which shrinks with θ.
    const double half_chord = std::sqrt(2 * oracle::nearest(exact) * double(size));
    const Rational ud = rounding::u<double>();
    const Rational room =
        64 * ud * oracle::exact(half_chord) + 1024 * ud * ud * oracle::exact(size);
    const Rational part = 1 / (1 + 4 * rounding::u<S>());
    REQUIRE(oracle::compare({oracle::exact(bound) * part - room, 0, 0}, exact) <= 0);
  }
}

TEST_CASE("the sagitta of two orientations is a bound, off by a few u of half the chord") {
  check_sagitta<double>(7);
  check_sagitta<float>(8);
}

TEST_CASE("the sagitta of half a turn is the radius, and that of no turn is 0") {
  const Quaternion<double> none, half{0, Point(0, 0, 1)}, opposite{-1, Point(0, 0, 0)};
  CHECK(sagitta(none, half, 3.0) == 3);
  CHECK(sagitta(none, opposite, 3.0) <= 1e-300);
  const auto axes = [](const Quaternion<double>& q) { return contact::matrix_of(q); };
  CHECK(sagitta<double>(axes(none), axes(half), 3.0) >= 3);
  CHECK(sagitta<double>(axes(none), axes(half), 3.0) <= 3 * (1 + 1e-14));
  CHECK(sagitta<double>(axes(none), axes(opposite), 3.0) == 0);
}

TEST_CASE("the sagitta of two frames' axes is not below the exact one, nor much above") {
  Random random(9);
  for (int i = 0; i < generators::tried(500); ++i) {
    const WholeQuaternion from = any_quaternion(random, 20);
    WholeQuaternion turn = any_quaternion(random, 20);
    if (i % 2 == 0) turn.w = std::ldexp(1.0, random.integer(5, 40));
    const WholeQuaternion to = turn * from;
    const double bound = sagitta<double>(carried_truth::stored<double>(rotation_of(from)),
                                         carried_truth::stored<double>(rotation_of(to)), 1.0);
    const oracle::Surd exact = exact_sagitta(from, to, 1);
    INFO("case " << i);
    REQUIRE(oracle::compare({oracle::exact(bound), 0, 0}, exact) >= 0);
    const double most =
        oracle::nearest(exact) < 0.9 ? 2000 * rounding_unit : 1e-6;  // near a half turn
    REQUIRE(oracle::compare({oracle::exact(bound) - oracle::exact(most), 0, 0}, exact) <= 0);
  }
}

// ---------------------------------------------------------------- a motion that turns

/// A motion by N equal turns, of which each is a rotation by fractions, at most π in all.
struct Motion {
  WholeQuaternion start, turn;
  int turns = 1;
  Vector from, to;

  ExactMatrix rotation(int n) const {
    WholeQuaternion q = start;
    for (int i = 0; i < n; ++i) q = turn * q;
    return rotation_of(q);
  }
  Vector position(int n, const Vector& p) const {
    const Rational t = Rational(n) / turns;
    return Vector(from + t * (to - from)) + Vector(rotation(n) * p);
  }
};
Motion any_motion(Random& random) {
  Motion motion{any_quaternion(random, 5), any_quaternion(random, 3), random.integer(2, 8), {}, {}};
  // An angle of at most π / N, with tan of its half at most |v| / w.
  motion.turn.w = 3 * motion.turns + random.integer(0, 20);
  motion.turn.w *= random.chance(0.3) ? 1000 : 1;
  const double distance = random.chance(0.3) ? 0 : 2;
  motion.from = oracle::exact(any_vector(random, 2));
  motion.to = motion.from + oracle::exact(any_vector(random, distance));
  return motion;
}
template <std::floating_point S>
CoordinateFrame<S> frame_at(const Motion& motion, int n) {
  const Vector origin = motion.position(n, Vector(0, 0, 0));
  CoordinateFrame<S> frame;
  for (int k = 0; k < 3; ++k) frame.origin[k] = rounding::nearest<S>(origin[k]);
  frame.axes = carried_truth::stored<S>(motion.rotation(n));
  return frame;
}

template <std::floating_point S>
void check_motion(std::uint64_t seed) {
  Random random(seed);
  int missed = 0;
  const int count = generators::tried(150);
  for (int i = 0; i < count; ++i) {
    Motion motion = any_motion(random);
    const Point half = any_vector(random, 2).cwiseAbs();
    const Aabb<S> body{generators::rounded<S>(Point(-half)), generators::rounded<S>(half)};
    const auto from = frame_at<S>(motion, 0), to = frame_at<S>(motion, motion.turns);
    motion.from = oracle::exact(from.origin);
    motion.to = oracle::exact(to.origin);
    const Aabb<S> result = aabb_of_motion(body, from, to);
    const Aabb<S> ends =
        enclosing_box(contact::aabb_of_carried(body, from), contact::aabb_of_carried(body, to));
    bool outside = false;
    INFO("case " << i);
    for (const Vector& corner : corners(body)) {
      for (int n = 0; n <= motion.turns; ++n) {
        const Vector p = motion.position(n, corner);
        REQUIRE(inside(result, p));
        outside = outside || !inside(ends, p);
      }
    }
    missed += outside;
  }
  CHECK(missed > count / 4);
}

TEST_CASE("every position of a turning body is in its box, but often not in that of both ends") {
  check_motion<double>(10);
  check_motion<float>(11);
}

TEST_CASE("a point that turns by half a circle needs all of the margin") {
  // From (1, 0, 0) to (−1, 0, 0), past (0, 1, 0): the boxes at the ends are two points.
  const Aabb<double> point{Point(1, 0, 0), Point(1, 0, 0)};
  CoordinateFrame<double> from, to;
  to.axes << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  const Aabb<double> box = aabb_of_motion(point, from, to);
  CHECK(box.high.y() >= 1);
  CHECK(box.high.y() <= 1 + 1e-14);
}

TEST_CASE("without a turn the box of a motion is that of both ends") {
  const Aabb<double> body{Point(-1, -2, -3), Point(1, 2, 3)};
  CoordinateFrame<double> from, to;
  to.origin = Point(5, 6, 7);
  const Aabb<double> box = aabb_of_motion(body, from, to);
  const Aabb<double> ends =
      enclosing_box(contact::aabb_of_carried(body, from), contact::aabb_of_carried(body, to));
  CHECK(box.low == ends.low);
  CHECK(box.high == ends.high);
}

TEST_CASE("a chord is furthest from its arc in the middle, for every turn up to half a circle") {
  // The lemma of the proof, with an enclosure of each distance.
  using oracle::Interval;
  for (int angle = 1; angle <= 15; ++angle) {
    const Rational h = Rational(angle) / 10;  // half the turn, below π / 2
    for (int n = 0; n < 10; ++n) {
      const Rational phi = h * n / 10;
      const auto less = oracle::decide_sign(
          [&](unsigned bits) {
            const Interval half(h, bits), at(phi, bits), one(Rational(1), bits);
            const Interval x = cos(at) - cos(half), y = sin(at) - at / half * sin(half);
            const Interval middle = one - cos(half);
            return x * x + y * y - middle * middle;
          },
          512);
      REQUIRE((n == 0 || less.sign == -1));
    }
  }
}

TEST_CASE("motions that cannot be bounded are refused by name") {
  using support::contains;
  using support::refusal;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere<double> ball{Point(0, 0, 0), 1};
  const Quaternion<double> none, zero{0, Point(0, 0, 0)};
  const auto identity = CoordinateFrame<double>{}.axes;
  for (const double bad : {infinity, nan}) {
    CHECK(contains(refusal([&] { swept(ball, Point(bad, 0, 0)); }), "displacement"));
    CHECK(contains(refusal([&] { swept(Kdop<double>{}, Point(bad, 0, 0)); }), "displacement"));
    CHECK(contains(refusal([&] { sagitta(none, none, bad); }), "bounding_radius"));
    CHECK(contains(refusal([&] { sagitta(none, {bad, Point(0, 0, 0)}, 1.0); }), "orientation"));
    CHECK(contains(refusal([&] { sagitta<double>(identity, identity, bad); }), "bounding_radius"));
    CHECK_FALSE(refusal([&] { contact::aabb_in_any_orientation(Point(0, bad, 0), 1.0); }).empty());
  }
  CHECK(contains(refusal([&] { swept(ball, Point(infinity, 0, 0)); }), "displacement"));
  CHECK(contains(refusal([&] {
                   const double largest = std::numeric_limits<double>::max();
                   swept<double>({Point(largest, 0, 0), 1}, Point(largest, 0, 0));
                 }),
                 "overflows"));
  CHECK(contains(refusal([&] {
                   swept(Kdop<double>{{Point(1, 0, 0)}, {nan}, {1}}, Point(1, 0, 0));
                 }),
                 "must be a number"));
  CHECK(contains(refusal([&] { sagitta(none, none, -1.0); }), "bounding_radius"));
  CHECK(contains(refusal([&] { sagitta(none, zero, 1.0); }), "orientation"));
  auto oblique = identity;
  oblique(0, 1) = 0.9;
  CHECK(contains(refusal([&] { sagitta<double>(identity, oblique, 1.0); }), "orthonormal"));
  const Aabb<double> box{Point(0, 0, 0), Point(1, 1, 1)};
  CHECK(contains(refusal([&] { aabb_of_motion(box, box, -1.0); }), "margin"));
  CHECK(
      contains(refusal([&] { contact::aabb_in_any_orientation(Point(0, 0, 0), -1.0); }), "radius"));
}

}  // namespace
}  // namespace moving_volumes_test
