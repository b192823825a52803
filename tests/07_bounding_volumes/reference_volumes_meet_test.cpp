// Whether two volumes meet: against fractions, and for oriented boxes how many that are apart the
// rounded test cannot tell.
#include <07_bounding_volumes/carried_truth.hpp>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <concepts>
#include <contact/volumes_meet.hpp>
#include <limits>
#include <map>
#include <support/generators.hpp>
#include <support/oracle.hpp>

namespace volumes_meet_test {
namespace {

using carried_truth::ExactMatrix;
using contact::Aabb;
using contact::may_meet;
using contact::OrientedBox;
using contact::Sphere;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using Point = contact::Vector3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <std::floating_point S>
S nudged(Random& random, S x, int count) {
  const int steps = random.integer(-count, count);
  for (int k = 0; k < std::abs(steps); ++k) {
    x = std::nextafter(
        x, steps > 0 ? std::numeric_limits<S>::infinity() : -std::numeric_limits<S>::infinity());
  }
  return x;
}

// ---------------------------------------------------------------- spheres

template <std::floating_point S>
bool meet_exactly(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector d = oracle::exact(a.centre) - oracle::exact(b.centre);
  const Rational r = oracle::exact(a.radius) + oracle::exact(b.radius);
  return d.dot(d) <= r * r;
}

/// Two spheres that touch to within a few ulps, at a power of two.
template <std::floating_point S>
std::array<Sphere<S>, 2> touching_spheres(Random& random, int power) {
  const Point at{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)};
  const Point away{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)};
  const S scale = std::ldexp(S(1), power);
  Sphere<S> a{generators::rounded<S>(at) * scale, S(random.uniform(0, 1)) * scale};
  Sphere<S> b{generators::rounded<S>(Point(at + away)) * scale, S(0)};
  b.radius = nudged(random, S(std::abs(S(away.norm()) * scale - a.radius)), 3);
  return {a, b};
}

template <std::floating_point S>
void check_spheres(std::uint64_t seed, int low, int high) {
  Random random(seed);
  std::map<bool, int> seen;
  const int count = generators::tried(20000);
  for (int i = 0; i < count; ++i) {
    const auto [a, b] = touching_spheres<S>(random, random.integer(low, high));
    const bool met = may_meet(a, b);
    ++seen[met];
    INFO("case " << i);
    REQUIRE(met == meet_exactly(a, b));
    REQUIRE(may_meet(b, a) == met);
  }
  CHECK(seen[true] > count / 10);
  CHECK(seen[false] > count / 10);
}

TEST_CASE("spheres that nearly touch are decided as fractions decide them") {
  check_spheres<double>(1, -900, 900);
  check_spheres<float>(2, -100, 100);
}

TEST_CASE("spheres of any bit pattern are decided as fractions decide them") {
  Random random(3);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Sphere<double> a{generators::any_vector(random),
                           std::abs(generators::any_finite(random))};
    Sphere<double> b{generators::any_vector(random), std::abs(generators::any_finite(random))};
    if (i % 2 == 0) {  // a comparable scale
      b.centre = a.centre * random.uniform(-1, 1);
      b.radius = std::ldexp(random.uniform(), std::ilogb(a.centre.cwiseAbs().maxCoeff()));
    }
    INFO("case " << i);
    REQUIRE(may_meet(a, b) == meet_exactly(a, b));
  }
}

TEST_CASE("spheres that touch at one point meet, also with radius 0 and at every scale") {
  for (const double scale : {0x1p-1074, 0x1p-500, 1.0, 0x1p1020}) {
    INFO("scale " << scale);
    const Sphere<double> a{Point(0, 0, 0), 2 * scale}, b{Point(3, 4, 0) * scale, 3 * scale};
    CHECK(may_meet(a, b));
    CHECK_FALSE(may_meet(a, {b.centre, std::nextafter(b.radius, 0)}));
    CHECK(may_meet<double>({b.centre, 0}, {b.centre, 0}));
  }
}

// ---------------------------------------------------------------- axis-aligned boxes

TEST_CASE("axis-aligned boxes may meet if they touch") {
  Random random(4);
  const auto side = [&random] { return double(random.integer(-3, 3)); };
  for (int i = 0; i < generators::tried(20000); ++i) {
    const Point p{side(), side(), side()}, q{side(), side(), side()};
    const Point r{side(), side(), side()}, s{side(), side(), side()};
    const Aabb<double> a{p.cwiseMin(q), p.cwiseMax(q)}, b{r.cwiseMin(s), r.cwiseMax(s)};
    bool common = true;  // of whole numbers: the largest low is a common point
    for (int k = 0; k < 3; ++k) {
      common = common && std::max(a.low[k], b.low[k]) <= std::min(a.high[k], b.high[k]);
    }
    REQUIRE(may_meet(a, b) == common);
  }
}

// ---------------------------------------------------------------- oriented boxes

/// The largest gap along fifteen directions between two stored boxes, in fractions: not above 0 if
/// they meet, because the facets of the Minkowski difference of convex polyhedra are parallel to a
/// face of one or to an edge of each.
template <std::floating_point S>
Rational exact_gap(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  const ExactMatrix u = carried_truth::exact(a.axes), v = carried_truth::exact(b.axes);
  const Vector d = oracle::exact(a.centre) - oracle::exact(b.centre);
  const auto along = [&](const Vector& n) {
    Rational gap = abs(n.dot(d));
    for (int i = 0; i < 3; ++i) {
      gap -= oracle::exact(a.half_lengths[i]) * abs(n.dot(u.col(i)));
      gap -= oracle::exact(b.half_lengths[i]) * abs(n.dot(v.col(i)));
    }
    return gap;
  };
  Rational largest = along(u.col(0).cross(u.col(1)));
  for (int i = 0; i < 3; ++i) {
    largest = std::max(largest, along(u.col((i + 1) % 3).cross(u.col((i + 2) % 3))));
    largest = std::max(largest, along(v.col((i + 1) % 3).cross(v.col((i + 2) % 3))));
    for (int j = 0; j < 3; ++j) largest = std::max(largest, along(u.col(i).cross(v.col(j))));
  }
  return largest;
}
/// The s of the reference's comment, of which the bound is 16 u.
template <std::floating_point S>
Rational size_of(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  Rational m = 1, lengths = 0, most = 0;
  for (int i = 0; i < 3; ++i) {
    for (const auto& box : {a, b}) {
      Rational sum = 0;
      for (int k = 0; k < 3; ++k) sum += abs(oracle::exact(box.axes(k, i)));
      m = std::max(m, sum);
      lengths += oracle::exact(box.half_lengths[i]);
    }
    most = std::max(most, Rational(abs(oracle::exact(a.centre[i]) - oracle::exact(b.centre[i]))));
  }
  return m * m * (most + m * lengths);
}

template <std::floating_point S>
OrientedBox<S> any_box(Random& random) {
  const auto axes = carried_truth::rotation_of(carried_truth::any_quaternion(random, 50));
  const Point centre{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
  const Point half{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
  OrientedBox<S> box{generators::rounded<S>(centre), carried_truth::stored<S>(axes),
                     generators::rounded<S>(half)};
  if (random.chance(0.3)) box.half_lengths[random.integer(0, 2)] = S(0);
  return box;
}
/// Moved by a vector, with rounding.
template <std::floating_point S>
OrientedBox<S> moved(const OrientedBox<S>& box, const Point& by) {
  return {generators::rounded<S>(Point(box.centre.template cast<double>() + by)), box.axes,
          box.half_lengths};
}
/// b moved to touch a to within a few u: a corner of one at a corner, on an edge or on a face of
/// the other, and both on two sides of a plane there, as far as rounding allows.
template <std::floating_point S>
OrientedBox<S> at_contact(Random& random, const OrientedBox<S>& a, const OrientedBox<S>& b) {
  const auto at = [](const OrientedBox<S>& box, const Point& n, double sign) {
    Point p = box.centre.template cast<double>();
    for (int i = 0; i < 3; ++i) {
      const Point axis = box.axes.col(i).template cast<double>();
      const double side = n.dot(axis) * sign > 0 ? 1 : -1;
      p += side * double(box.half_lengths[i]) * axis;
    }
    return p;
  };
  const Point u = a.axes.col(random.integer(0, 2)).template cast<double>();
  const Point v = b.axes.col(random.integer(0, 2)).template cast<double>();
  const std::array<Point, 4> directions{carried_truth::any_direction(random), u, v,
                                        Point(u.cross(v))};
  const Point n = directions[std::size_t(random.integer(0, 3))];
  const Point gap = n * (random.chance(0.5) ? 0 : random.magnitude(-56, -40));
  return moved(b, Point(at(a, n, 1) - at(b, n, -1) + gap));
}

struct Counts {
  int meet = 0, apart = 0, lost = 0;
};
template <std::floating_point S>
Counts check_boxes(std::uint64_t seed, int count, bool touching, int power) {
  Random random(seed);
  Counts counts;
  for (int i = 0; i < count; ++i) {
    const S scale = std::ldexp(S(1), power);
    OrientedBox<S> a = any_box<S>(random), b = any_box<S>(random);
    if (i % 4 == 0) b.axes = a.axes;  // parallel edges
    if (touching) b = at_contact(random, a, b);
    for (auto* box : {&a, &b}) {
      box->centre *= scale;
      box->half_lengths *= scale;
    }
    const Rational gap = exact_gap(a, b);
    const bool may = may_meet(a, b), met = gap <= 0;
    INFO("case " << i);
    REQUIRE((may || !met));
    const Rational bound = 33 * (rounding::u<double>() * size_of(a, b) + rounding::eta<double>());
    REQUIRE((!may || gap <= bound));
    counts.meet += met;
    counts.apart += !met;
    counts.lost += may && !met;
  }
  return counts;
}

TEST_CASE("boxes within rounding of a touch are never wrongly apart, and lose a bounded gap") {
  const int count = generators::tried(800);
  for (const int power : {0, 500, -500, -1040}) {
    INFO("2^" << power);
    const Counts counts = check_boxes<double>(5, count, true, power);
    CHECK(counts.meet > count / 10);
    CHECK(counts.apart > count / 10);
  }
  const Counts counts = check_boxes<float>(6, count, true, 0);
  CHECK(counts.meet > count / 10);
  CHECK(counts.apart > count / 10);
}

TEST_CASE("of random boxes that are apart all are said to be") {
  const int count = generators::tried(1000);
  const Counts of_double = check_boxes<double>(7, count, false, 0);
  CHECK(of_double.lost == 0);
  CHECK(of_double.apart > count / 10);
  CHECK(check_boxes<float>(8, count, false, 0).lost == 0);
}

TEST_CASE("boxes that are oblique as stored are compared as they are stored") {
  // The axes of a are no rotation: its face x + y = ±1 is not perpendicular to a stored axis.
  OrientedBox<double> a{Point(0, 0, 0), {}, Point(1, 1, 1)};
  a.axes << 1, 0, 0, -1, 1, 0, 0, 0, 1;
  OrientedBox<double> b{Point(1, 1, 0), contact::Matrix3<double>::Identity(), Point(0, 0, 0)};
  b.centre = Point(0.625, 0.5, 0);  // x + y > 1
  CHECK_FALSE(may_meet(a, b));
  b.centre = Point(0.5, 0.5, 0);
  CHECK(may_meet(a, b));
  b.centre = Point(1, -2, 1);  // a corner
  CHECK(may_meet(a, b));
}

TEST_CASE("queries with a number that is not finite say no, and an overflow says maybe") {
  const Sphere<double> ball{Point(0, 0, 0), 1};
  const Aabb<double> box{Point(-1, -1, -1), Point(1, 1, 1)};
  const OrientedBox<double> turned{Point(0, 0, 0), contact::Matrix3<double>::Identity(),
                                   Point(1, 1, 1)};
  for (const double bad : {nan, infinity, -infinity}) {
    CHECK_FALSE(may_meet(ball, {Point(bad, 0, 0), 1}));
    CHECK_FALSE(may_meet(ball, {Point(0, 0, 0), bad}));
    for (int k = 0; k < 3; ++k) {
      OrientedBox<double> broken = turned;
      broken.centre[k] = bad;
      CHECK_FALSE(may_meet(turned, broken));
      broken = turned;
      broken.half_lengths[k] = bad;
      CHECK_FALSE(may_meet(broken, turned));
      broken = turned;
      broken.axes(k, 1) = bad;
      CHECK_FALSE(may_meet(turned, broken));
    }
  }
  CHECK_FALSE(may_meet<double>(ball, {Point(0, 0, 0), -0.5}));
  CHECK_FALSE(may_meet(box, {Point(nan, 0, 0), Point(1, 1, 1)}));
  CHECK_FALSE(may_meet({Point(0, 0, 0), Point(1, nan, 1)}, box));
  OrientedBox<double> far = turned;
  far.centre.x() = std::numeric_limits<double>::max();
  far.half_lengths *= std::numeric_limits<double>::max();
  CHECK(may_meet(turned, far));
}

}  // namespace
}  // namespace volumes_meet_test
