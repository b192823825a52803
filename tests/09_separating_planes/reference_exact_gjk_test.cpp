// The exact distance of two cores, from any start, against all features in fractions.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/exact_gjk.hpp>
#include <cstddef>
#include <vector>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_truth.hpp"
#include "random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace exact_gjk_test {
namespace {

using contact::ConvexHull;
using contact::DifferenceIndex;
using contact::Exact;
using contact::exact_gjk;
using contact::ExactClosest;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using pair_checks::rational_of;
using Point = contact::Vector3<double>;

/// Without its radius, so that the distance is that of the cores.
template <class Body>
Body core(Body body) {
  if constexpr (requires { body.radius; }) body.radius = 0;
  return body;
}

/// Up to four differences, often the same ones.
template <class A, class B>
std::vector<DifferenceIndex> any_start(Random& random, const A& a, const B& b) {
  std::vector<DifferenceIndex> start;
  const int count = random.integer(0, 4);
  for (int i = 0; i < count; ++i) {
    const int p = random.integer(0, vertex_count(a) - 1);
    start.push_back({p, random.integer(0, vertex_count(b) - 1)});
  }
  return start;
}

TEST_CASE("the exact distance of cores is that of all features, from any start") {
  Random random(910);
  int apart = 0, meeting = 0;
  pair_checks::each_pair(911, tried(4), pair_checks::polytopes, [&](const auto& pair, auto family) {
    pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& x, const auto& y) {
      const auto a = core(x);
      const auto b = core(y);
      const auto truth = pair_truth::truth(a, b);
      const ExactClosest found = exact_gjk(a, b, any_start(random, a, b));
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      REQUIRE((truth.sign <= 0) == contact::detail::is_zero(found.direction));
      ++(truth.sign > 0 ? apart : meeting);
      if (truth.sign <= 0) {
        CHECK(rounded_distance(found) == 0);
        CHECK(rounded_difference(found) == Point::Zero());
        CHECK(rounded_direction(found) == Point::Zero());
        return;
      }
      const Vector v = rational_of(found.direction);
      const Rational h = rational_of(found.offset);
      CHECK(oracle::compare({0, h / v.dot(v), v.dot(v)}, truth.distance) == 0);
      const double right = oracle::nearest(truth.distance);
      CHECK(std::abs(rounded_distance(found) - right) <= 0x1p-51 * right);
      for (int i = 0; i < 3; ++i) {
        CHECK(rounded_difference(found)(i) == oracle::nearest(Rational(v(i) * h / v.dot(v))));
      }
      CHECK(rounded_direction(found).cwiseAbs().maxCoeff() == 1);
    });
  });
  CHECK(apart > tried(400));
  CHECK(meeting > tried(100));
}

TEST_CASE("the closest point is a mean of the vertices of the simplex with weights above 0") {
  Random random(912);
  pair_checks::each_pair(913, tried(1), pair_checks::polytopes, [&](const auto& pair, auto) {
    pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const ExactClosest found = exact_gjk(a, b, any_start(random, a, b));
      Vector sum = Vector::Zero();
      Rational weights = 0;
      REQUIRE(found.count >= 1);
      REQUIRE(found.count <= 4);
      for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
        const Rational weight = rational_of(found.weights[i]);
        CHECK(weight > 0);
        const auto& of = found.vertex[i].of;
        const Vector w = pair_truth::core_of(a).vertices[static_cast<std::size_t>(of.a)] -
                         pair_truth::core_of(b).vertices[static_cast<std::size_t>(of.b)];
        CHECK(w == rational_of(found.vertex[i].w));
        sum += w * weight;
        weights += weight;
      }
      // Σ λ w / Σ λ = h V / V², or 0.
      const Vector v = rational_of(found.direction);
      const Rational h = rational_of(found.offset);
      CHECK(Vector(sum * v.dot(v)) == Vector(v * h * weights));
    });
  });
}

/// Points on a sphere, of which many are almost equally far along any direction.
ConvexHull<double> round_hull(Random& random, int count, const Point& centre) {
  ConvexHull<double> hull;
  for (int i = 0; i < count; ++i) {
    hull.vertices.push_back(centre + random_poses::direction(random));
  }
  for (int i = 0; i < 8; ++i) {  // and some that differ by a few ulps
    const Point& p = hull.vertices[static_cast<std::size_t>(random.integer(0, count - 1))];
    hull.vertices.push_back(generators::detail::nudged(random, p, 2));
  }
  return hull;
}

TEST_CASE("the farthest vertex of a large hull is that of a scan without a filter") {
  Random random(914);
  int close = 0;
  for (int i = 0; i < tried(2400); ++i) {
    const double distance = std::ldexp(1.0, random.integer(-4, 40));
    const auto hull = round_hull(random, 60, Point(random_poses::direction(random) * distance));
    // Along a vertex from the centre, or between two vertices that are almost equally far.
    const Point n = random.chance(0.5) ? Point(hull.vertices[0] - hull.vertices[1])
                                       : random_poses::direction(random);
    const auto exact = contact::exact_vector<double>(n);
    const int scanned = exact_support_vertex(hull, exact);
    const int found = contact::detail::farthest_vertex(hull, exact);
    CHECK(exact.dot(exact_vertex(hull, found)) == exact.dot(exact_vertex(hull, scanned)));
    if (support_vertex(hull, n) != scanned) ++close;
  }
  CHECK(close > 0);  // where rounding alone finds another
}

TEST_CASE("the farthest vertex is found at the ends of the range of doubles too") {
  for (const double scale : {0x1p-1074, 0x1p-1000, 0x1p1000, 0x1p1023}) {
    ConvexHull<double> hull;
    for (int i = 0; i < 9; ++i) hull.vertices.push_back(Point(0, scale, -scale));
    hull.vertices.push_back(Point(scale, scale, scale));
    for (const double length : {0x1p-1074, 1.0, 0x1p1023}) {
      const auto n = contact::exact_vector<double>(Point(length, 0, 0));
      INFO(scale << " along " << length);
      CHECK(contact::detail::farthest_vertex(hull, n) == 9);
    }
  }
}

}  // namespace
}  // namespace exact_gjk_test
