// Decisions have no tolerance: the inputs are small integers and dyadic fractions, so that neither
// a right answer nor the oracle rounds. Every test expects a yes and a no.
#include "sphere_plane.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::RawPlane;
using Plane = contact::Plane<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;

/// (N·c − K)² ≤ r² N·N, exact.
bool exact_meets(const Sphere& sphere, const Vector& normal, double offset) {
  using V = contact::Vector3<Exact>;
  const V n = normal.cast<Exact>(), c = sphere.centre.cast<Exact>();
  const Exact value = n.dot(c) - Exact(offset), r(sphere.radius);
  return (value * value - r * r * n.dot(n)).sign() <= 0;
}

void check(const Sphere& sphere, const Plane& plane) {
  const auto value = [&] { return plane.normal.dot(sphere.centre) - plane.offset; };
  ask("Does the sphere meet the plane?")
      .given("sphere", sphere)
      .given("plane", plane)
      .suspect("touching-rejected", [&] { return std::abs(value()) < sphere.radius; })
      .suspect("half-space-for-plane", [&] { return value() <= sphere.radius; })
      .answer([&] { return exercise::meets(sphere, plane); })
      .equals(exact_meets(sphere, plane.normal, plane.offset));
}

void check_raw(const Sphere& sphere, const RawPlane& plane) {
  const auto value = [&] { return plane.normal.dot(sphere.centre) - plane.offset; };
  const auto square = [&] { return plane.normal.squaredNorm(); };
  const double r = sphere.radius;
  ask("Does the sphere meet the plane, whose normal is not a unit vector?")
      .given("sphere", sphere)
      .given("plane", plane)
      .suspect("touching-rejected", [&] { return value() * value() < r * r * square(); })
      .suspect("normal-not-normalised", [&] { return std::abs(value()) <= r; })
      .suspect("square-on-one-side", [&] { return std::abs(value()) <= r * square(); })
      .answer([&] { return exercise::meets_raw(sphere, plane); })
      .equals(exact_meets(sphere, plane.normal, plane.offset));
}

const Plane kLevel{{0, 0, 1}, 3};
// The normal (2, 3, 6) is 7 long; with offset 14 the plane is 2 from the origin.
const RawPlane kSeven{{2, 3, 6}, 14};

}  // namespace

TEST_CASE("a sphere near the plane meets it and one further away does not") {
  check({{5, 1, 4}, 1.5}, kLevel);
  check({{5, 1, 7}, 1.5}, kLevel);
  check({{5, 1, 3}, 0.5}, kLevel);
  check({{9, -4, 13}, 2}, kLevel);
}

TEST_CASE("a sphere that touches meets the plane") {
  check({{5, 1, 7}, 1.5}, kLevel);
  check({{5, 1, 4.5}, 1.5}, kLevel);
  check({{5, 1, 1.5}, 1.5}, kLevel);
  check({{5, 1, 3}, 0}, kLevel);
  check({{5, 1, 4.5}, 1.25}, kLevel);
}

TEST_CASE("the plane has two sides") {
  check({{5, 1, 2}, 1.5}, kLevel);
  check({{5, 1, -4}, 1.5}, kLevel);
  check({{5, 1, 4}, 1.5}, kLevel);
}

TEST_CASE("the length of a raw plane's normal is taken into account") {
  check_raw({{2, 3, 6}, 4}, kSeven);  // 49 − 14 = 35, and 35 / 7 = 5 > 4
  check_raw({{2, 3, 6}, 6}, kSeven);
  check_raw({{4, 6, 12}, 11}, kSeven);
  check_raw({{4, 6, 12}, 13}, kSeven);
  check_raw({{0.25, 0, 0}, 0.25}, {{0.5, 0, 0}, 0.5});
}

TEST_CASE("touching is decided exactly for integers, whatever the normal") {
  check_raw({{2, 3, 6}, 4.5}, kSeven);
  check_raw({{2, 3, 6}, 6}, kSeven);  // overlapping: a failure here is not due to touching
  check_raw({{2, 3, 6}, 5}, kSeven);  // 49 − 14 = 35 = 5 · 7
  check_raw({{0, 0, 0}, 2}, kSeven);
  check_raw({{0, 0, 0}, 1.75}, kSeven);
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    // Pythagorean quadruples, scaled: integer normals of integer length.
    constexpr std::array<std::array<int, 4>, 5> kNormals{
        {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}}};
    const auto& [x, y, z, length] = kNormals.at(static_cast<std::size_t>(random.integer(0, 4)));
    const auto integer = [&] { return double{1} * random.integer(-20, 20); };
    const Vector normal(x, y, z), centre{integer(), integer(), integer()};
    const double radius = random.integer(0, 9);
    const double side = random.chance(0.5) ? -1 : 1;
    const double touching = normal.dot(centre) + side * radius * length;
    const double away = random.integer(0, 1);
    check_raw({centre, radius}, {normal, touching + side * away});
  }
}
