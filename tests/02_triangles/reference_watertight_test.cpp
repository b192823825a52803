// watertight.hpp: between two triangles no ray is lost.
#include <02_triangles/adversarial.hpp>
#include <02_triangles/families.hpp>
#include <02_triangles/truth.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/barycentric.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <limits>
#include <support/generators.hpp>
#include <support/oracle.hpp>

#include "reference.hpp"

using contact::Ray;
using contact::Triangle;
using contact::Vector3;
using generators::Family;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::absolute;
using reference::u;

TEST_CASE(
    "the flat cross product has the right sign for every pair of doubles that does not over- or "
    "underflow") {
  Random random(21);
  int ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto near_one = [&] {
      return 1.0 + random.integer(-4, 4) * std::numeric_limits<double>::epsilon();
    };
    const auto wide = [&] { return random.magnitude(-200, 200); };
    contact::Vector2<double> p{i % 2 == 0 ? near_one() : wide(), 0},
        q{i % 2 == 0 ? near_one() : wide(), 0};
    p.y() = i % 2 == 0 ? near_one() : wide();
    q.y() = i % 2 == 0 ? near_one() : wide();
    const Rational right =
        oracle::exact(p.x()) * oracle::exact(q.y()) - oracle::exact(p.y()) * oracle::exact(q.x());
    const double got = contact::cross2_right_sign(p, q);
    REQUIRE((got > 0) - (got < 0) == oracle::sign(right));
    REQUIRE(contact::cross2_right_sign(q, p) == -got);
    ties += p.x() * q.y() == p.y() * q.x() && right != 0;
  }
  REQUIRE(ties > 500);  // the plain difference would be 0
}

namespace {

/// Of the rays aimed between two triangles, those that hit neither by a method.
template <class S, class Method>
int leaks(int rays, std::uint64_t seed, const Method& method) {
  Random random(seed);
  int leaked = 0;
  for (int i = 0; i < rays; ++i) {
    const families::Aimed aimed = families::at_shared_edge(random);
    const Ray<S> ray = generators::rounded<S>(aimed.ray);
    const bool hit = method(ray, generators::rounded<S>(aimed.triangles[0])).has_value() ||
                     method(ray, generators::rounded<S>(aimed.triangles[1])).has_value();
    leaked += !hit;
  }
  return leaked;
}

const auto watertight = [](const auto& ray, const auto& t) {
  return contact::intersect_watertight(ray, t);
};

}  // namespace

TEST_CASE("between two triangles there is no gap for the exact test, so a miss is a leak") {
  REQUIRE(leaks<float>(20000, 22, [](const auto& ray, const auto& t) {
            return contact::intersect_exact(ray, t);
          }) == 0);
}

TEST_CASE("of a million rays between two triangles, the watertight test in float leaks none") {
  REQUIRE(leaks<float>(1000000, 23, watertight) == 0);
}

TEST_CASE("the watertight test in double leaks none") {
  REQUIRE(leaks<double>(200000, 24, watertight) == 0);
}

TEST_CASE("the rounded methods in float leak, at about the rate that the ladder shows") {
  const auto by_edges = [](const auto& ray, const auto& t) {
    return contact::intersect_by_edges(ray, t);
  };
  const auto by_dropping = [](const auto& ray, const auto& t) {
    return contact::intersect_by_dropping(ray, t);
  };
  const auto moller = [](const auto& ray, const auto& t) {
    return contact::intersect_moller_trumbore(ray, t);
  };
  const int of_edges = leaks<float>(20000, 25, by_edges);
  const int of_dropping = leaks<float>(20000, 25, by_dropping);
  const int of_moller = leaks<float>(20000, 25, moller);
  UNSCOPED_INFO("leaks of 20000: edge tests " << of_edges << ", dropped dimension " << of_dropping
                                              << ", Möller-Trumbore " << of_moller);
  REQUIRE(of_edges > 1000);
  REQUIRE(of_dropping > 1000);
  REQUIRE(of_moller > 500);
}

TEST_CASE("a closed mesh is hit by every ray that starts inside it") {
  // An octahedron, moved off the origin and slightly deformed, so that nothing about it is exact.
  // Rays from inside are aimed at its vertices and edges, where a crack would be.
  Random random(26);
  for (int round = 0; round < 400; ++round) {
    std::array<Vector3<float>, 6> corners;
    const Vector3<float> centre = 8 * families::random_point(random);
    for (std::size_t i = 0; i < 6; ++i) {
      Vector3<float> axis = Vector3<float>::Zero();
      axis(static_cast<Eigen::Index>(i / 2)) = i % 2 == 0 ? 1.0f : -1.0f;
      corners[i] = centre + axis + 0.2f * families::random_point(random);
    }
    for (int shot = 0; shot < 50; ++shot) {
      const auto one = static_cast<std::size_t>(random.integer(0, 5));
      auto other = static_cast<std::size_t>(random.integer(0, 5));
      if (other / 2 == one / 2) other = (other + 2) % 6;
      const double share = random.chance(0.3) ? 0.0 : random.uniform();
      const Vector3<float> origin = centre + 0.1f * families::random_point(random);
      const Ray<float> ray =
          families::towards(origin, families::between(corners[one], corners[other], share));
      bool hit = false;
      for (std::size_t x = 0; x < 2; ++x) {
        for (std::size_t y = 2; y < 4; ++y) {
          for (std::size_t z = 4; z < 6; ++z) {
            hit = hit || contact::intersect_watertight(
                             ray, Triangle<float>{corners[x], corners[y], corners[z]});
          }
        }
      }
      REQUIRE(hit);
    }
  }
}

TEST_CASE("the watertight test is right beyond its rounding errors, with t within its bound") {
  // The sheared x of a vertex is x − (d_x/d_z) z: at most four roundings a term. An edge function
  // multiplies two such, five more with its difference; sum, quotient, z, product, sum of three and
  // the last division bring it to less than 20. The terms are those of the sheared products.
  Random random(27);
  const Rational c = 20 * oracle::exact(u);
  int values = 0, decided = 0;
  for (int i = 0; i < 8000; ++i) {
    const Family family =
        generators::all_families[static_cast<std::size_t>(i) % generators::all_families.size()];
    const Triangle<double> triangle = generators::proper_triangle(random, family);
    const Ray<double> ray = generators::ray(random, family, triangle);
    if (ray.direction.isZero(0)) continue;
    const auto got = contact::intersect_watertight(ray, triangle);
    const auto right = truth::meet(ray, triangle);

    const Vector o = oracle::exact(ray.origin), d = oracle::exact(ray.direction);
    const int z = contact::largest_dimension(ray.direction), x = (z + 1) % 3, y = (z + 2) % 3;
    const Triangle<Rational> exact = oracle::exact(triangle);
    std::array<contact::Vector2<Rational>, 3> seen, size;
    std::array<Rational, 3> depth;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector p = (k == 0 ? exact.a : k == 1 ? exact.b : exact.c) - o;
      const Rational shift_x = d[x] / d[z] * p[z], shift_y = d[y] / d[z] * p[z];
      seen[k] = {p[x] - shift_x, p[y] - shift_y};
      size[k] = {absolute(p[x]) + absolute(shift_x), absolute(p[y]) + absolute(shift_y)};
      depth[k] = p[z] / d[z];
    }
    Rational sum = 0, sum_terms = 0, t = 0, t_terms = 0;
    bool clear = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t m = (k + 1) % 3, n = (k + 2) % 3;
      const Rational edge = contact::cross2(seen[m], seen[n]);
      const Rational terms = size[m].x() * size[n].y() + size[m].y() * size[n].x();
      clear = clear && absolute(edge) > c * terms;
      sum += edge;
      sum_terms += terms;
      t += edge * depth[k];
      t_terms += terms * absolute(depth[k]);
    }
    if (absolute(sum) <= 1024 * c * sum_terms) continue;
    t /= sum;
    const Rational bound = c * (t_terms + absolute(t) * sum_terms) / absolute(sum);
    CAPTURE(generators::name(family), i);
    if (clear && absolute(t) > bound) {
      REQUIRE(got.has_value() == right.has_value());
      ++decided;
    }
    if (got && right) {
      REQUIRE(oracle::error(got->t, right->t) <= bound);
      ++values;
    }
  }
  CAPTURE(values, decided);
  REQUIRE(values > 400);
  REQUIRE(decided > 3000);
}
