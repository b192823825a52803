// Slabs: points between each pair and overlaps against fractions, volumes against closed forms.
#include <07_bounding_volumes/carried_truth.hpp>
#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <concepts>
#include <contact/slab_volumes.hpp>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>
#include <vector>

namespace slab_volumes_test {
namespace {

using carried_truth::inside;
using contact::Kdop;
using contact::kdop_normals;
using contact::kdop_of_points;
using contact::may_meet;
using contact::plane_dop_normals;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using Point = Vector3<double>;
template <class S>
using Points = std::vector<Vector3<S>>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <std::floating_point S>
Kdop<S> dop_of(const std::vector<Vector3<S>>& normals, const Points<S>& points) {
  return kdop_of_points<S>(normals, std::span<const Vector3<S>>(points));
}
template <std::floating_point S>
Vector3<S> any_point(Random& random, double size = 1) {
  return generators::rounded<S>(
      Point{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)});
}
template <std::floating_point S>
Points<S> any_points(Random& random, int n, double size = 1) {
  Points<S> points;
  for (int i = 0; i < n; ++i) points.push_back(any_point<S>(random, size));
  return points;
}
/// Normals as a reader may choose them: of any length and direction.
template <std::floating_point S>
std::vector<Vector3<S>> any_normals(Random& random) {
  if (random.chance(0.5)) return kdop_normals<S>(26);
  return any_points<S>(random, random.integer(1, 6), 3);
}

// ---------------------------------------------------------------- contains

template <std::floating_point S>
void check_contains(std::uint64_t seed) {
  Random random(seed);
  std::map<bool, int> seen;
  const int count = generators::tried(3000);
  for (int i = 0; i < count; ++i) {
    const auto normals = any_normals<S>(random);
    const Points<S> points = any_points<S>(random, 3);
    Kdop<S> dop = dop_of(normals, points);
    // Between a vertex, which is on some planes, and a point an ulp or more away.
    Vector3<S> p = points[std::size_t(random.integer(0, 2))];
    const int k = random.integer(0, 2);
    if (random.chance(0.7)) p[k] = std::nextafter(p[k], S(random.uniform(-3, 3)));
    if (random.chance(0.2)) p = any_point<S>(random);
    const bool found = contains(dop, p);
    ++seen[found];
    INFO("case " << i);
    REQUIRE(found == inside(dop, oracle::exact(p)));
  }
  CHECK(seen[true] > count / 20);
  CHECK(seen[false] > count / 20);
}

TEST_CASE("a point is between each pair of planes as fractions decide it") {
  check_contains<double>(1);
  check_contains<float>(2);
}

TEST_CASE("a point of any bit pattern is in slabs of any bit patterns as fractions decide it") {
  Random random(3);
  for (int i = 0; i < generators::tried(3000); ++i) {
    Kdop<double> dop;
    const Point p = generators::any_vector(random);
    for (int k = 0; k < 2; ++k) {
      dop.normals.push_back(generators::any_vector(random));
      const double bound = std::abs(generators::any_finite(random));
      dop.low.push_back(-bound);
      dop.high.push_back(bound);
    }
    INFO("case " << i);
    REQUIRE(contains(dop, p) == inside(dop, oracle::exact(p)));
  }
}

TEST_CASE("the slabs of points contain these points, in every family and for every k") {
  Random random(4);
  for (int i = 0; i < generators::tried(800); ++i) {
    const auto family = generators::all_families[std::size_t(i) % 8];
    Points<double> points;
    for (int n = 0; n < 4; ++n) points.push_back(generators::point(random, family));
    for (const int k : {6, 14, 18, 26}) {
      const Kdop<double> dop = dop_of(kdop_normals<double>(k), points);
      for (const Point& p : points) REQUIRE(contains(dop, p));
    }
  }
}

TEST_CASE("a point on a plane is between the pair, one ulp outside is not") {
  const Kdop<double> dop{{Point(1, 1, 1)}, {-3}, {3}};
  CHECK(contains(dop, Point(1, 1, 1)));
  CHECK(contains(dop, Point(-1, -1, -1)));
  CHECK_FALSE(contains(dop, Point(1, 1, std::nextafter(1, 2))));
  // Rounded, the sum is 3.
  CHECK_FALSE(contains(dop, Point(1, 2, 0x1p-80)));
  CHECK(contains(dop, Point(1, 2, -0x1p-80)));
}

TEST_CASE("without pairs every point is inside, and between swapped planes none is") {
  CHECK(contains(Kdop<double>{}, Point(1, 2, 3)));
  CHECK_FALSE(contains(Kdop<double>{{Point(1, 0, 0)}, {1}, {-1}}, Point(0, 0, 0)));
}

TEST_CASE("an infinite bound, as an overflow leaves it, excludes nothing; NaN is nowhere") {
  const Vector3<float> big = Vector3<float>::Constant(3e38F);
  Kdop<float> dop{{Vector3<float>(1, 1, 1)}, {0}, {std::numeric_limits<float>::infinity()}};
  CHECK(contains(dop, big));
  CHECK_FALSE(contains(dop, Vector3<float>(-big)));
  CHECK(may_meet(dop, dop));
  dop.low = {std::numeric_limits<float>::infinity()};
  CHECK_FALSE(contains(dop, big));
  const Kdop<double> cube =
      dop_of<double>(kdop_normals<double>(6), {Point(0, 0, 0), Point(1, 1, 1)});
  for (int k = 0; k < 3; ++k) {
    for (const double bad : {nan, infinity, -infinity}) {
      Point p(0.5, 0.5, 0.5);
      p[k] = bad;
      CHECK_FALSE(contains(cube, p));
      Kdop<double> broken = cube;
      broken.normals[1][k] = bad;
      CHECK_FALSE(contains(broken, Point(0.5, 0.5, 0.5)));
    }
    for (const auto bounds : {&Kdop<double>::low, &Kdop<double>::high}) {
      Kdop<double> broken = cube;
      (broken.*bounds)[std::size_t(k)] = nan;
      CHECK_FALSE(contains(broken, Point(0.5, 0.5, 0.5)));
      CHECK_FALSE(may_meet(broken, cube));
      CHECK_FALSE(may_meet(cube, broken));
    }
  }
}

// ---------------------------------------------------------------- may meet

template <std::floating_point S>
void check_common_points(std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < generators::tried(1500); ++i) {
    const auto normals = any_normals<S>(random);
    const double size = std::ldexp(1.0, random.integer(-30, 30));
    Points<S> first = any_points<S>(random, 3, size), second = any_points<S>(random, 3, size);
    second.push_back(first[1]);
    const Kdop<S> a = dop_of(normals, first), b = dop_of(normals, second);
    INFO("case " << i);
    REQUIRE(may_meet(a, b));
    REQUIRE(may_meet(b, a));
  }
}

TEST_CASE("bodies with a common point are never apart") {
  check_common_points<double>(5);
  check_common_points<float>(6);
}

TEST_CASE("slabs of whole numbers overlap exactly if the projections of the points do") {
  Random random(7);
  std::map<bool, int> seen;
  const int count = generators::tried(4000);
  for (int i = 0; i < count; ++i) {
    const auto points = [&random] {
      Points<double> all;
      for (int n = 0; n < 3; ++n) {
        all.push_back(Point{double(random.integer(-3, 3)), double(random.integer(-3, 3)),
                            double(random.integer(-3, 3))});
      }
      return all;
    };
    const Points<double> first = points(), second = points();
    const auto normals = kdop_normals<double>(26);
    bool overlap = true;
    for (const Point& n : normals) {
      double low = infinity, high = -infinity, low_2 = infinity, high_2 = -infinity;
      for (const Point& p : first) low = std::min(low, n.dot(p)), high = std::max(high, n.dot(p));
      for (const Point& p : second) {
        low_2 = std::min(low_2, n.dot(p));
        high_2 = std::max(high_2, n.dot(p));
      }
      overlap = overlap && low <= high_2 && low_2 <= high;
    }
    ++seen[overlap];
    INFO("case " << i);
    REQUIRE(may_meet(dop_of(normals, first), dop_of(normals, second)) == overlap);
  }
  CHECK(seen[true] > count / 20);
  CHECK(seen[false] > count / 20);
}

TEST_CASE("slabs that touch overlap, one ulp apart they do not, and an empty one meets nothing") {
  const Kdop<double> a{{Point(1, 1, 0)}, {-1}, {0.1}};
  CHECK(may_meet(a, Kdop<double>{a.normals, {0.1}, {2}}));
  CHECK(may_meet(Kdop<double>{a.normals, {0.1}, {2}}, a));
  CHECK_FALSE(may_meet(a, Kdop<double>{a.normals, {std::nextafter(0.1, 1)}, {2}}));
  CHECK_FALSE(may_meet(a, Kdop<double>{a.normals, {0}, {-0.5}}));
  CHECK_FALSE(may_meet(Kdop<double>{a.normals, {0}, {-0.5}}, a));
}

TEST_CASE("slabs of other normals, or of the same in another order, are refused") {
  const Kdop<double> a{{Point(1, 0, 0), Point(0, 1, 0)}, {0, 0}, {1, 1}};
  const Kdop<double> reversed{{Point(0, 1, 0), Point(1, 0, 0)}, {0, 0}, {1, 1}};
  const Kdop<double> fewer{{Point(1, 0, 0)}, {0}, {1}};
  for (const Kdop<double>& b : {reversed, fewer}) {
    CHECK(support::contains(support::refusal([&] { may_meet(a, b); }), "same order"));
  }
}

TEST_CASE("k-DOPs of the plane have 4 or 8 sides and normals without a z") {
  CHECK(plane_dop_normals<double>(4).size() == 2);
  CHECK(plane_dop_normals<float>(8).size() == 4);
  for (const Point& n : plane_dop_normals<double>(8)) CHECK(n.z() == 0);
  CHECK(support::contains(support::refusal([] { plane_dop_normals<double>(6); }), "4 or 8"));
}

// ---------------------------------------------------------------- volume and vertices

const Points<double> octahedron{Point(1, 0, 0),  Point(-1, 0, 0), Point(0, 1, 0),
                                Point(0, -1, 0), Point(0, 0, 1),  Point(0, 0, -1)};

TEST_CASE("volumes of k-DOPs of an octahedron are those of solids with a known volume") {
  // A cube; the octahedron itself; a rhombic dodecahedron; the octahedron again.
  const std::map<int, double> right{{6, 8}, {14, 4.0 / 3}, {18, 2}, {26, 4.0 / 3}};
  const std::map<int, std::size_t> vertices{{6, 8}, {14, 6}, {18, 14}, {26, 6}};
  for (const auto& [k, wanted] : right) {
    INFO("k " << k);
    const Kdop<double> dop = dop_of(kdop_normals<double>(k), octahedron);
    CHECK(std::abs(volume(dop) - wanted) <= 1e-14 * wanted);
    CHECK(kdop_vertices(dop).size() == vertices.at(k));
  }
}

TEST_CASE("a volume does not depend on the position, and scales with the cube of the size") {
  Random random(8);
  for (int i = 0; i < generators::tried(60); ++i) {
    const Points<double> points = any_points<double>(random, 8);
    const Point by{double(random.integer(-9, 9)), double(random.integer(-9, 9)), 5};
    for (const int k : {6, 14, 18, 26}) {
      const auto normals = kdop_normals<double>(k);
      const double here = volume(dop_of(normals, points));
      Points<double> moved, large, small;
      for (const Point& p : points) {
        moved.push_back(p + by);
        large.push_back(p * 0x1p300);
        small.push_back(p * 0x1p-300);
      }
      INFO("case " << i << ", k " << k);
      REQUIRE(std::abs(volume(dop_of(normals, moved)) - here) <= 1e-11);
      REQUIRE(volume(dop_of(normals, large)) == here * 0x1p900);
      REQUIRE(volume(dop_of(normals, small)) == here * 0x1p-900);
    }
  }
}

TEST_CASE("more pairs of planes never make a volume larger") {
  Random random(9);
  for (int i = 0; i < generators::tried(60); ++i) {
    const Points<double> points = any_points<double>(random, 12);
    const auto at = [&points](int k) { return volume(dop_of(kdop_normals<double>(k), points)); };
    const double box = at(6), room = 1 + 1e-13;
    REQUIRE(at(14) <= box * room);
    REQUIRE(at(18) <= box * room);
    REQUIRE(at(26) <= std::min(at(14), at(18)) * room);
  }
}

TEST_CASE("a pair of planes that is given twice, or implied by another, changes no volume") {
  Kdop<double> dop = dop_of(kdop_normals<double>(14), octahedron);
  const double once = volume(dop);
  dop.normals.push_back(-2 * dop.normals[3]);
  dop.low.push_back(-2 * dop.high[3]);
  dop.high.push_back(-2 * dop.low[3]);
  dop.normals.push_back(dop.normals[4]);
  dop.low.push_back(dop.low[4] - 1);
  dop.high.push_back(dop.high[4] + 1);
  CHECK(volume(dop) == once);
  CHECK(kdop_facets(dop).size() == 8);
}

TEST_CASE("vertices of a k-DOP are on three of its planes and inside all, to within rounding") {
  Random random(10);
  for (int i = 0; i < generators::tried(100); ++i) {
    const Kdop<double> dop =
        dop_of(i % 2 == 0 ? kdop_normals<double>(26) : any_normals<double>(random),
               any_points<double>(random, 8));
    for (const Point& v : kdop_vertices(dop)) {
      int on = 0;
      for (std::size_t k = 0; k < dop.normals.size(); ++k) {
        const double at = dop.normals[k].dot(v), room = 1e-10;
        REQUIRE(at >= dop.low[k] - room);
        REQUIRE(at <= dop.high[k] + room);
        on += std::abs(at - dop.low[k]) <= room || std::abs(at - dop.high[k]) <= room;
      }
      REQUIRE(on >= 3);
    }
  }
}

TEST_CASE("an empty, a flat and an endless k-DOP have the volumes 0, 0 and infinity") {
  const auto axes = kdop_normals<double>(6);
  CHECK(volume(Kdop<double>{axes, {0, 0, 1}, {1, 1, 0}}) == 0);
  CHECK(kdop_vertices(Kdop<double>{axes, {0, 0, 1}, {1, 1, 0}}).empty());
  CHECK(volume(Kdop<double>{axes, {0, 0, 1}, {1, 1, 1}}) == 0);
  CHECK(volume(Kdop<double>{axes, {0, 0, nan}, {1, 1, 1}}) == 0);
  CHECK(volume(Kdop<double>{axes, {0, 0, 0}, {1, 1, infinity}}) == infinity);
  CHECK(volume(dop_of(plane_dop_normals<double>(8), octahedron)) == infinity);
  CHECK(kdop_facets(dop_of(plane_dop_normals<double>(8), octahedron)).empty());
}

TEST_CASE("the base of a prism is a polygon in the plane") {
  const auto area = [](const std::vector<contact::Vector2<double>>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto& q = p[(i + 1) % p.size()];
      sum += p[i].x() * q.y() - p[i].y() * q.x();
    }
    return sum / 2;
  };
  // |x| ≤ 1, |y| ≤ 1, |x ± y| ≤ 3/2: a square without four corners of area 1/8.
  const Kdop<double> octagon{plane_dop_normals<double>(8), {-1, -1, -1.5, -1.5}, {1, 1, 1.5, 1.5}};
  const auto vertices = plane_dop_vertices(octagon);
  CHECK(vertices.size() == 8);
  CHECK(area(vertices) == Catch::Approx(3.5));
  CHECK(plane_dop_vertices(
            dop_of(plane_dop_normals<float>(4), Points<float>{Vector3<float>(1, 1, 7)}))
            .empty());
  const Kdop<double> strip{{Point(1, 0, 0)}, {0}, {1}};
  CHECK(plane_dop_vertices(strip).empty());
}

}  // namespace
}  // namespace slab_volumes_test
