// Translating bodies against half-spaces: the signs of the separation at both times are exact.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/half_space_impact.hpp>
#include <contact/offset_plane.hpp>
#include <limits>
#include <variant>

#include "moving_bodies.hpp"
#include "support/generators.hpp"

namespace half_space_impact_test {
namespace {

using contact::HalfSpace;
using contact::translating_impact;
using contact::TranslatingImpact;
using generators::Random;
using generators::tried;
using moving_bodies::Family;
using moving_bodies::V;

HalfSpace<double> half_space(Random& random, bool whole) {
  V normal = moving_bodies::in_cube(random, 1) + V(0, 0, 0.01);
  if (whole) normal = V::Unit(random.integer(0, 2));
  const double offset = whole ? random.integer(-2, 2) : random.uniform(-2, 2);
  return {{contact::normalised(normal), offset}};
}

TEST_CASE("a translating body and a half-space: separated at t, met at t_high, exactly") {
  Random random(71);
  int meetings = 0, others = 0, starts = 0;
  for (int i = 0; i < tried(6000); ++i) {
    const Family family = i % 3 == 0 ? Family::whole : (i % 3 == 1 ? Family::plain : Family::flat);
    const int kind = random.integer(0, moving_bodies::kinds - 1);
    const auto pair = moving_bodies::make(random, family, kind, 0);
    const HalfSpace<double> half = half_space(random, family == Family::whole);
    std::visit(
        [&](const auto& a) {
          const V &u = pair.displacement_a, &v = pair.displacement_b;
          const TranslatingImpact found = translating_impact(a, u, half, v);
          const contact::detail::HalfSpaceMotion motion(a, half,
                                                        contact::detail::exact_relative(u, v));
          INFO("body " << i << ", kind " << kind << ", t " << found.t << " to " << found.t_high);
          if (!found.meets) {
            ++others;
            REQUIRE((motion.sign_at(0) > 0 && motion.sign_at(1) > 0));
            return;
          }
          ++(found.t_high == 0 ? starts : meetings);
          REQUIRE(motion.sign_at(found.t_high) <= 0);
          if (found.t_high == 0) return;
          REQUIRE(motion.sign_at(found.t) > 0);
          REQUIRE((found.t_high - found.t <= 0x1p-40 * found.t_high ||
                   std::nextafter(found.t, 1) >= found.t_high));
        },
        pair.a);
  }
  CHECK(meetings > tried(800));
  CHECK(others > tried(800));
  CHECK(starts > tried(800));
}

TEST_CASE("a sphere meets a half-space when it meets its plane from the front") {
  Random random(72);
  for (int i = 0; i < tried(2000); ++i) {
    const contact::Sphere<double> ball{moving_bodies::in_cube(random, 3), random.uniform(0, 1)};
    const V way = moving_bodies::in_cube(random, 6);
    HalfSpace<double> half = half_space(random, false);
    half.boundary.offset = std::min(half.boundary.offset, half.boundary.normal.dot(ball.centre));
    const auto hit = contact::sphere_plane_impact(ball, way, half.boundary);
    const TranslatingImpact found = translating_impact(ball, way, half, V(0, 0, 0));
    // The plane's distance takes the stored normal as a unit vector, the half-space its length.
    if (hit && std::abs(hit->t - 1) < 1e-12) continue;
    REQUIRE(found.meets == hit.has_value());
    if (hit) CHECK(std::abs(found.t - hit->t) <= 1e-11);
  }
}

TEST_CASE("cylinders and ellipsoids meet a half-space at the time of their support") {
  const HalfSpace<double> floor{{V(0, 0, 1), 0}};
  const contact::Cylinder<double> upright{{V(0, 0, 3), V(0, 0, 5)}, 1};
  const contact::Ellipsoid<double> egg{V(0, 0, 5), contact::Matrix3<double>::Identity(),
                                       V(1, 1, 2)};
  for (const TranslatingImpact& found :
       {translating_impact(upright, V(0, 0, -6), floor, V(0, 0, 0)),
        translating_impact(egg, V(1, 0, 0), floor, V(0, 0, 6))}) {
    REQUIRE(found.meets);
    CHECK(found.t <= 0.5);
    CHECK(found.t_high >= 0.5);
  }
}

TEST_CASE("a body that ends on the half-space meets it, and one that moves away from it does not") {
  const HalfSpace<double> floor{{V(0, 0, 1), 0}};
  const contact::Sphere<double> ball{V(0, 0, 3), 1};
  CHECK(translating_impact(ball, V(0, 0, -2), floor, V(0, 0, 0)).meets);
  CHECK_FALSE(translating_impact(ball, V(0, 0, std::nextafter(-2, 0)), floor, V(0, 0, 0)).meets);
  CHECK_FALSE(translating_impact(ball, V(0, 0, 9), floor, V(0, 0, 0)).meets);
  CHECK_FALSE(translating_impact(ball, V(0, 0, -5), floor, V(0, 0, -5)).meets);
  const contact::Sphere<double> inside{V(0, 0, -3), 1};
  CHECK(translating_impact(inside, V(0, 0, 9), floor, V(0, 0, 0)).t == 0);
}

TEST_CASE("a half-space or displacement that is not finite meets nothing") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const contact::Sphere<double> ball{V(0, 0, 0), 1};
  const HalfSpace<double> floor{{V(0, 0, 1), 0}};
  CHECK(translating_impact(ball, V(0, 0, 0), floor, V(0, 0, 0)).meets);
  CHECK_FALSE(translating_impact(ball, V(0, 0, nan), floor, V(0, 0, 0)).meets);
  CHECK_FALSE(translating_impact(ball, V(0, 0, 0), floor, V(nan, 0, 0)).meets);
  for (const HalfSpace<double>& none :
       {HalfSpace<double>{{V(0, 0, 0), 0}}, HalfSpace<double>{{V(0, nan, 1), 0}},
        HalfSpace<double>{{V(0, 0, 1), nan}}}) {
    CHECK_FALSE(translating_impact(ball, V(0, 0, 0), none, V(0, 0, 0)).meets);
  }
}

}  // namespace
}  // namespace half_space_impact_test
