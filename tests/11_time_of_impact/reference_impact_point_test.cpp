// The points in which translating bodies touch.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impact_point.hpp>
#include <contact/signed_distance.hpp>
#include <variant>

#include "moving_bodies.hpp"
#include "support/generators.hpp"

namespace impact_point_test {
namespace {

using contact::translating_impact;
using contact::TranslatingImpact;
using generators::Random;
using generators::tried;
using moving_bodies::Family;
using moving_bodies::V;

TEST_CASE("the point of impact is on both bodies, and the normal leads from B to A") {
  Random random(73);
  int points = 0;
  for (int i = 0; i < tried(1500); ++i) {
    const int kind_a = random.integer(0, moving_bodies::kinds - 1);
    const int kind_b = random.integer(0, moving_bodies::kinds - 1);
    const auto pair =
        moving_bodies::make(random, i % 2 == 0 ? Family::plain : Family::bullet, kind_a, kind_b);
    std::visit(
        [&](const auto& a, const auto& b) {
          const V &u = pair.displacement_a, &v = pair.displacement_b;
          const TranslatingImpact found = translating_impact(a, u, b, v);
          if (!found.meets || found.t == 0) return;
          ++points;
          const contact::TouchPoint at = contact::impact_point(found, a, u, b, v);
          INFO("pair " << i << ", kinds " << kind_a << " and " << kind_b);
          const contact::Sphere<double> point{at.point, 0};
          const double size = 1e-9 * (1 + u.norm() + v.norm());
          const auto distance = [&point](const moving_bodies::Body& body) {
            return std::visit(
                [&point](const auto& x) { return contact::signed_distance(point, x).distance; },
                body);
          };
          CHECK(std::abs(distance(moving_bodies::moved(pair.a, u * found.t))) <= size);
          CHECK(std::abs(distance(moving_bodies::moved(pair.b, v * found.t))) <= size);
          CHECK(std::abs(at.normal.norm() - 1) <= 1e-15);
          CHECK(at.normal.dot(V(u - v)) < 0);  // they approach along it
        },
        pair.a, pair.b);
  }
  CHECK(points > tried(400));
}

TEST_CASE("the point of impact of spheres is start + displacement t, less the radius") {
  const contact::Sphere<double> a{V(0, 0, 0), 1}, b{V(5, 0, 0), 2};
  const V way(4, 0, 0), rest(0, 0, 0);
  const auto at = contact::impact_point(translating_impact(a, way, b, rest), a, way, b, rest);
  CHECK((at.point - V(3, 0, 0)).norm() <= 1e-12);
  CHECK(at.normal == V(-1, 0, 0));
}

TEST_CASE("bodies that do not meet have no point of impact, those that overlap no normal") {
  const contact::Sphere<double> a{V(0, 0, 0), 1}, far{V(9, 0, 0), 1}, close{V(1, 0, 0), 1};
  const V rest(0, 0, 0);
  CHECK(contact::impact_point(translating_impact(a, rest, far, rest), a, rest, far, rest).point ==
        rest);
  CHECK(contact::impact_point(translating_impact(a, rest, close, rest), a, rest, close, rest)
            .normal == rest);
}

}  // namespace
}  // namespace impact_point_test
