// Touching or overlapping of cores that meet: the plane or the differences that are found, checked
// in fractions.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/surrounding_set.hpp>
#include <cstddef>
#include <span>
#include <vector>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_truth.hpp"
#include "random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace surrounding_set_test {
namespace {

using contact::ConvexHull;
using contact::Exact;
using contact::ExactClosest;
using contact::ExactDifference;
using contact::PlaneOrSurrounding;
using generators::Random;
using generators::tried;
using oracle::Vector;
using pair_checks::rational_of;
using pair_families::Family;
using Point = contact::Vector3<double>;

/// Whether the origin is strictly inside the hull of the points, by the oracle of features.
bool inside_hull(const std::vector<Vector>& points) {
  const pair_truth::Core origin{{Vector(0, 0, 0)}, {}, {}, 0};
  return pair_truth::truth(pair_truth::core_of_points(points, 0), origin).sign < 0;
}

std::vector<Vector> differences_of(const PlaneOrSurrounding& found) {
  std::vector<Vector> w;
  for (const ExactDifference& x : found.surrounding) w.push_back(rational_of(x.w));
  return w;
}

/// Checks what is found of two cores that meet; true: they overlap.
template <class A, class B>
bool check_meeting(const A& a, const B& b, const PlaneOrSurrounding& found) {
  if (found.surrounding.empty()) {
    const Vector n = rational_of(found.normal);
    CHECK(n != Vector(0, 0, 0));
    for (const Vector& p : pair_truth::core_of(a).vertices) {
      for (const Vector& q : pair_truth::core_of(b).vertices) CHECK(n.dot(p - q) >= 0);
    }
    return false;
  }
  CHECK(contact::detail::is_zero(found.normal));
  const std::vector<Vector> w = differences_of(found);
  CHECK(w.size() >= 4);
  CHECK(w.size() <= 6);
  CHECK(inside_hull(w));
  for (std::size_t i = 0; i < w.size(); ++i) {  // none is superfluous
    std::vector<Vector> fewer = w;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK_FALSE(inside_hull(fewer));
  }
  return true;
}

template <class A, class B>
PlaneOrSurrounding of_meeting(const A& a, const B& b, const ExactClosest& closest) {
  const std::span<const ExactDifference> simplex(closest.vertex.data(),
                                                 static_cast<std::size_t>(closest.count));
  return plane_or_surrounding(a, b, simplex);
}

TEST_CASE("cores that meet have a plane between them or differences around the origin") {
  std::array<int, 2> seen{};
  std::array<int, 7> sizes{};
  int steps = 0;
  const auto check = [&](const auto& a, const auto& b, Family family, const auto& pair) {
    const ExactClosest closest = exact_gjk(a, b);
    if (!contact::detail::is_zero(closest.direction)) return;
    const PlaneOrSurrounding found = of_meeting(a, b, closest);
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    const bool overlap = check_meeting(a, b, found);
    CHECK(overlap == (pair_truth::truth(a, b).sign < 0));
    ++seen[overlap ? 1 : 0];
    ++sizes[found.surrounding.size()];
    steps = std::max(steps, found.steps);
    // Without a simplex to start from the case is the same.
    CHECK(check_meeting(a, b, plane_or_surrounding(a, b, {})) == overlap);
  };
  pair_checks::each_pair(920, std::max(1, tried(8)), pair_checks::polytopes,
                         [&](const auto& pair, auto family) {
                           pair_bodies::with_polytopes(pair.a, pair.b, [&](auto a, auto b) {
                             if constexpr (requires { a.radius; }) a.radius = 0;
                             if constexpr (requires { b.radius; }) b.radius = 0;
                             check(a, b, family, pair);
                           });
                         });
  CHECK(seen[0] > tried(50));
  CHECK(seen[1] > tried(50));
  CHECK(sizes[4] > 0);
  CHECK(sizes[5] > 0);
  CHECK(steps <= 30);
}

TEST_CASE("an octahedron and its centre need all six vertices") {
  ConvexHull<double> octahedron;
  for (int i = 0; i < 3; ++i) {
    octahedron.vertices.push_back(Point(Point::Unit(i) * 3));
    octahedron.vertices.push_back(Point(Point::Unit(i) * -2));
  }
  const contact::Sphere<double> centre{Point::Zero(), 0};
  const auto found = plane_or_surrounding(octahedron, centre, {});
  CHECK(found.surrounding.size() == 6);
  CHECK(inside_hull(differences_of(found)));
}

TEST_CASE("what spans no space has a plane: points, segments and flat bodies in one plane") {
  const auto has_plane = [](const auto& a, const auto& b) {
    const auto found = plane_or_surrounding(a, b, {});
    return !check_meeting(a, b, found);
  };
  const contact::Sphere<double> point{Point(1, 2, 3), 0};
  CHECK(has_plane(point, point));
  const contact::Capsule<double> along{{Point(0, 2, 3), Point(4, 2, 3)}, 0};
  CHECK(has_plane(point, along));
  CHECK(has_plane(along, along));
  const contact::Capsule<double> vertical{{Point(1, 2, 0), Point(1, 2, 4)}, 0};
  CHECK(has_plane(along, vertical));
  const contact::Triangle<double> flat{Point(0, 0, 3), Point(9, 0, 3), Point(0, 9, 3)};
  CHECK(has_plane(flat, flat));
  CHECK(has_plane(flat, along));
  CHECK_FALSE(has_plane(flat, vertical));
  CHECK(has_plane(flat, contact::Capsule<double>{{Point(1, 2, 3), Point(1, 2, 4)}, 0}));
}

TEST_CASE("hulls of many vertices that touch at one of each take few steps") {
  Random random(921);
  for (int i = 0; i < tried(20); ++i) {
    ConvexHull<double> a, b;
    for (int k = 0; k < 60; ++k) {
      const Point p = random_poses::any_point(random, 2), q = random_poses::any_point(random, 2);
      a.vertices.push_back(Point(p.x(), p.y(), std::abs(p.z()) + 1e-3));
      b.vertices.push_back(Point(q.x(), q.y(), -std::abs(q.z()) - 1e-3));
    }
    a.vertices.push_back(Point::Zero());
    b.vertices.push_back(Point::Zero());
    const auto found = of_meeting(a, b, exact_gjk(a, b));
    CHECK(found.surrounding.empty());
    const Vector n = rational_of(found.normal);
    CHECK(n != Vector(0, 0, 0));
    for (const Point& p : a.vertices) CHECK(n.dot(oracle::exact(p)) >= 0);
    for (const Point& q : b.vertices) CHECK(n.dot(oracle::exact(q)) <= 0);
    CHECK(found.steps <= 30);
  }
}

}  // namespace
}  // namespace surrounding_set_test
