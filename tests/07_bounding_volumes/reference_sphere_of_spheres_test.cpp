// Spheres of spheres: contained as fractions decide, and not larger than necessary.
#include <07_bounding_volumes/carried_truth.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <concepts>
#include <contact/sphere_of_spheres.hpp>
#include <limits>
#include <map>
#include <span>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>
#include <support/rounding.hpp>
#include <vector>

namespace sphere_of_spheres_test {
namespace {

using contact::encloses;
using contact::enclosing_sphere;
using contact::grown_sphere_of_spheres;
using contact::Sphere;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using Point = contact::Vector3<double>;

template <std::floating_point S>
bool encloses_exactly(const Sphere<S>& outer, const Sphere<S>& inner) {
  const Vector d = oracle::exact(outer.centre) - oracle::exact(inner.centre);
  const Rational room = oracle::exact(outer.radius) - oracle::exact(inner.radius);
  return room >= 0 && d.dot(d) <= room * room;
}
template <std::floating_point S>
Sphere<S> any_sphere(Random& random, int power, double largest_radius = 1) {
  const Point centre{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
  const double radius = random.chance(0.2) ? 0 : random.uniform(0, largest_radius);
  const S scale = std::ldexp(S(1), power);
  return {generators::rounded<S>(centre) * scale, S(radius) * scale};
}
/// An inner sphere that touches the outer one from inside to within a few ulps.
template <std::floating_point S>
std::array<Sphere<S>, 2> touching_inside(Random& random, int power) {
  const Sphere<S> inner = any_sphere<S>(random, power);
  Sphere<S> outer = any_sphere<S>(random, power);
  const Point d = (outer.centre - inner.centre).template cast<double>();
  outer.radius = S(d.stableNorm()) + inner.radius;
  for (int k = random.integer(-3, 3); k != 0; k += k > 0 ? -1 : 1) {
    outer.radius = std::nextafter(outer.radius, k > 0 ? std::numeric_limits<S>::infinity() : S(0));
  }
  return {outer, inner};
}

template <std::floating_point S>
void check_encloses(std::uint64_t seed, int low, int high) {
  Random random(seed);
  std::map<bool, int> seen;
  const int count = generators::tried(10000);
  for (int i = 0; i < count; ++i) {
    const auto [outer, inner] = touching_inside<S>(random, random.integer(low, high));
    const bool found = encloses(outer, inner);
    ++seen[found];
    INFO("case " << i);
    REQUIRE(found == encloses_exactly(outer, inner));
  }
  CHECK(seen[true] > count / 10);
  CHECK(seen[false] > count / 10);
}

TEST_CASE("one sphere encloses another as fractions decide it") {
  check_encloses<double>(1, -900, 900);
  check_encloses<float>(2, -100, 100);
}

TEST_CASE("a sphere that touches from inside is enclosed, and an equal one encloses itself") {
  for (const double scale : {0x1p-1074, 1.0, 0x1p1020}) {
    INFO("scale " << scale);
    const Sphere<double> outer{Point(0, 0, 0), 7 * scale}, inner{Point(3, 4, 0) * scale, 2 * scale};
    CHECK(encloses(outer, inner));
    CHECK_FALSE(encloses(outer, {inner.centre, std::nextafter(inner.radius, 8 * scale)}));
    CHECK(encloses(inner, inner));
    CHECK_FALSE(encloses(inner, outer));
  }
}

TEST_CASE("encloses is false for numbers that are not finite and for negative radii") {
  const Sphere<double> ball{Point(0, 0, 0), 1};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_FALSE(encloses({Point(0, 0, 0), bad}, ball));
    CHECK_FALSE(encloses(ball, {Point(0, bad, 0), 0}));
  }
  CHECK_FALSE(encloses(ball, {Point(0, 0, 0), -1.0}));
}

// ---------------------------------------------------------------- two

/// Whether the sphere about two exceeds the smallest one, (|c| + r + r') / 2, by at most 16 u of
/// the largest coordinate or radius.
template <std::floating_point S>
bool is_tight(const Sphere<S>& about, const Sphere<S>& a, const Sphere<S>& b) {
  Rational size = 0;
  for (const Sphere<S>& s : {a, b}) {
    size = std::max(size, oracle::exact(s.radius));
    for (int k = 0; k < 3; ++k) size = std::max(size, Rational(abs(oracle::exact(s.centre[k]))));
  }
  const Rational room = 16 * rounding::u<S>() * size + 4 * rounding::eta<S>();
  const Vector d = oracle::exact(a.centre) - oracle::exact(b.centre);
  // 2 (R − room) ≤ |c| + r + r'
  const Rational rest =
      2 * (oracle::exact(about.radius) - room) - oracle::exact(a.radius) - oracle::exact(b.radius);
  return rest <= 0 || rest * rest <= d.dot(d);
}
template <std::floating_point S>
void check_two(std::uint64_t seed, int low, int high) {
  Random random(seed);
  int textbook_misses = 0;
  const int count = generators::tried(3000);
  for (int i = 0; i < count; ++i) {
    const int power = random.integer(low, high);
    const Sphere<S> a = any_sphere<S>(random, power), b = any_sphere<S>(random, power, 3);
    const Sphere<S> about = enclosing_sphere(a, b);
    INFO("case " << i);
    REQUIRE(encloses_exactly(about, a));
    REQUIRE(encloses_exactly(about, b));
    if (encloses_exactly(a, b) || encloses_exactly(b, a)) {
      const Sphere<S>& larger = encloses_exactly(a, b) ? a : b;
      REQUIRE(about.centre == larger.centre);
      REQUIRE(about.radius == larger.radius);
      continue;
    }
    REQUIRE(is_tight(about, a, b));
    // Half of the sum, rounded, about the rounded centre.
    const S distance = contact::Vector3<S>(a.centre - b.centre).stableNorm();
    const Sphere<S> textbook{about.centre, (distance + a.radius + b.radius) / S(2)};
    textbook_misses += !encloses_exactly(textbook, a) || !encloses_exactly(textbook, b);
  }
  CHECK(textbook_misses > count / 10);
}

TEST_CASE("the sphere of two contains both and is as small as its rounded centre allows") {
  check_two<double>(3, -800, 800);
  check_two<double>(4, -1072, -1060);
  check_two<float>(5, -100, 100);
}

TEST_CASE("the sphere of two spheres of any bit patterns contains both, or is refused") {
  Random random(6);
  int made = 0;
  for (int i = 0; i < generators::tried(600); ++i) {
    const Sphere<double> a{generators::any_vector(random),
                           std::abs(generators::any_finite(random))};
    const Sphere<double> b{generators::any_vector(random),
                           std::abs(generators::any_finite(random))};
    Sphere<double> about;
    const auto refused = support::refusal([&] { about = enclosing_sphere(a, b); });
    INFO("case " << i << " " << refused);
    if (!refused.empty()) {
      REQUIRE(support::contains(refused, "overflow"));
      continue;
    }
    ++made;
    REQUIRE(encloses_exactly(about, a));
    REQUIRE(encloses_exactly(about, b));
  }
  CHECK(made > generators::tried(300));
}

TEST_CASE("a sphere that touches the larger one from inside leaves it unchanged") {
  const Sphere<double> outer{Point(0, 0, 0), 7}, inner{Point(3, 4, 0), 2};
  CHECK(enclosing_sphere(outer, inner).radius == 7);
  CHECK(enclosing_sphere(inner, outer).centre == outer.centre);
  // An ulp more, and the result is larger than both.
  const Sphere<double> larger{Point(3, 4, 0), std::nextafter(2, 3)};
  CHECK(enclosing_sphere(outer, larger).radius > 7);
}

// ---------------------------------------------------------------- many

template <std::floating_point S>
void check_many(std::uint64_t seed, int low, int high) {
  Random random(seed);
  for (int i = 0; i < generators::tried(300); ++i) {
    const int power = random.integer(low, high);
    std::vector<Sphere<S>> spheres;
    const int n = random.integer(1, 12);
    for (int k = 0; k < n; ++k) spheres.push_back(any_sphere<S>(random, power));
    const Sphere<S> about = grown_sphere_of_spheres(std::span<const Sphere<S>>(spheres));
    bool needed = about.radius == S(0);
    const Sphere<S> smaller{about.centre, std::nextafter(about.radius, S(0))};
    INFO("case " << i);
    Rational width = 0;  // a lower bound on the diameter
    for (const Sphere<S>& a : spheres) {
      REQUIRE(encloses_exactly(about, a));
      needed = needed || !encloses_exactly(smaller, a);
      for (const Sphere<S>& b : spheres) {
        for (int k = 0; k < 3; ++k) {
          width = std::max(width, Rational(oracle::exact(a.centre[k]) + oracle::exact(a.radius) -
                                           oracle::exact(b.centre[k]) + oracle::exact(b.radius)));
        }
      }
    }
    REQUIRE((needed || low < -1022));  // the radius of subnormal spheres may be a number larger
    REQUIRE(oracle::exact(about.radius) <= width + 2 * rounding::eta<S>());
  }
}

TEST_CASE("the grown sphere contains all spheres, and no smaller radius does about its centre") {
  check_many<double>(7, -900, 900);
  check_many<double>(9, -1072, -1068);
  check_many<float>(8, -100, 100);
}

TEST_CASE("one sphere is its own grown sphere, and one that contains all others is theirs") {
  const Sphere<double> outer{Point(1, 2, 3), 9};
  const std::vector<Sphere<double>> spheres{{Point(1, 2, 4), 1}, outer, {Point(5, 2, 3), 5}};
  CHECK(grown_sphere_of_spheres(std::span<const Sphere<double>>(&outer, 1)).radius == 9);
  CHECK(grown_sphere_of_spheres(std::span<const Sphere<double>>(spheres)).centre == outer.centre);
  CHECK(grown_sphere_of_spheres(std::span<const Sphere<double>>(spheres)).radius == 9);
}

TEST_CASE("spheres that cannot be enclosed are refused by name") {
  const Sphere<double> good{Point(0, 0, 0), 1};
  const double infinity = std::numeric_limits<double>::infinity();
  const auto said = [&](const Sphere<double>& s) {
    return support::refusal([&] { enclosing_sphere(good, s); });
  };
  CHECK(support::contains(said({Point(0, infinity, 0), 1}), "centre"));
  CHECK(support::contains(said({Point(0, 0, 0), -1.0}), "radius"));
  const Sphere<double> left{Point(-0x1.8p1023, 0, 0), 0x1p1023};
  const Sphere<double> right{Point(0x1.8p1023, 0, 0), 0x1p1023};
  CHECK(support::contains(support::refusal([&] { enclosing_sphere(left, right); }), "overflow"));
  CHECK(support::contains(
      support::refusal([] { grown_sphere_of_spheres(std::span<const Sphere<double>>()); }),
      "spheres"));
}

}  // namespace
}  // namespace sphere_of_spheres_test
