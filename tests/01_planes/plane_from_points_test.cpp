// Right planes come from exact arithmetic, with one rounding at each coordinate of N = (b − a) × (c
// − a); only its length is computed in rounded arithmetic.
#include "plane_from_points.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Plane = contact::Plane<double>;
using Vector = Eigen::Vector3d;

Plane right_plane(const Vector& a, const Vector& b, const Vector& c) {
  using V = contact::Vector3<Exact>;
  const V exact_a = a.cast<Exact>();
  const V n = V(b.cast<Exact>() - exact_a).cross(V(c.cast<Exact>() - exact_a));
  const auto rounded = [](const Exact& x) { return quotient<double>(x, Exact(1)); };
  const Vector normal(rounded(n.x()), rounded(n.y()), rounded(n.z()));
  return {normal.normalized(), rounded(n.dot(exact_a)) / normal.norm()};
}

/// Each edge is rounded by u of the largest coordinate L (none for integers), so N is off by about
/// 4 u L (|e₁| + |e₂|) + 4 u |e₁||e₂|, over |N| in the unit normal. The offset adds L times that
/// and 4 u L of its own. 16 instead of 4 allows for other edges than e₁ and e₂.
Plane bound(const Vector& a, const Vector& b, const Vector& c) {
  const Vector e1 = b - a, e2 = c - a;
  const double largest = std::max({a.norm(), b.norm(), c.norm()});
  const double length = e1.norm() * e2.norm() + largest * (e1.norm() + e2.norm());
  const double turn = 16 * 0x1p-53 * length / e1.cross(e2).norm();
  return {Vector::Constant(turn), largest * (turn + 16 * 0x1p-53)};
}

Plane plain(const Vector& a, const Vector& b, const Vector& c) {
  const Vector n = (b - a).cross(c - a).normalized();
  return {n, n.dot(a)};
}

void check(const Vector& a, const Vector& b, const Vector& c) {
  ask("Which plane goes through a, b and c?")
      .given("a", a)
      .given("b", b)
      .given("c", c)
      .suspect("normal-reversed", [&] { return plain(a, c, b); })
      .suspect("normal-not-normalised",
               [&] {
                 const Vector n = (b - a).cross(c - a);
                 return Plane{n, n.dot(a)};
               })
      .suspect("offset-sign",
               [&] {
                 const Plane p = plain(a, b, c);
                 return Plane{p.normal, -p.offset};
               })
      .answer([&] { return exercise::plane_from_points(a, b, c); })
      .close_to(right_plane(a, b, c), within(bound(a, b, c)));
}

/// Code that refuses this input treats small as degenerate.
void check_not_refused(const Vector& a, const Vector& b, const Vector& c) {
  const auto plane_or_nothing = [&]() -> std::optional<Plane> {
    try {
      return exercise::plane_from_points(a, b, c);
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  };
  ask("Which plane goes through a, b and c?")
      .given("a", a)
      .given("b", b)
      .given("c", c)
      .suspect_if("absolute-epsilon", [](const std::optional<Plane>& got) { return !got; })
      .answer(plane_or_nothing)
      .close_to(std::optional(right_plane(a, b, c)), within(std::optional(bound(a, b, c))));
}

void check_refused(const Vector& a, const Vector& b, const Vector& c) {
  ask("Which plane goes through a, b and c?")
      .given("a", a)
      .given("b", b)
      .given("c", c)
      .suspect_if("degenerate-not-refused", [](const Plane&) { return true; })
      .answer([&] { return exercise::plane_from_points(a, b, c); })
      .throws_invalid_argument();
}

}  // namespace

TEST_CASE("the normal is on the side from which the points are counter-clockwise") {
  check({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  check({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  check({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
}

TEST_CASE("the normal is a unit vector") {
  check({0, 0, 0}, {3, 0, 0}, {0, 5, 0});
  check({0, 0, 0}, {0, 0.25, 0}, {0, 0, 0.25});
}

TEST_CASE("the offset is the signed distance of the plane from the origin") {
  check({0, 0, 3}, {1, 0, 3}, {0, 1, 3});
  check({0, 0, 3}, {0, 1, 3}, {1, 0, 3});
  check({7, 0, 0}, {0, 7, 0}, {0, 0, 7});
}

TEST_CASE("points on one line are refused") {
  check_refused({0, 0, 0}, {1, 2, 3}, {2, 4, 6});
  check_refused({1, 1, 1}, {2, 3, 4}, {-1, -3, -5});
  check_refused({1, 2, 3}, {1, 2, 3}, {4, 5, 6});
  check_refused({4, 5, 6}, {1, 2, 3}, {1, 2, 3});
  check_refused({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
}

TEST_CASE("a tiny triangle has a plane") {
  check({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  check({1, 2, 0}, {0, 1, 0}, {1, 0, -1});
  // Powers of two change only the size.
  for (const double scale : {0x1p-20, 0x1p-30, 0x1p-40}) {
    check_not_refused({scale, 0, 0}, {0, scale, 0}, {0, 0, scale});
    check_not_refused({scale, 2 * scale, 0}, {0, scale, 0}, {scale, 0, -scale});
  }
}

TEST_CASE("random triangles agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] {
    return Vector{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8)};
  };
  for (int asked = 0; asked < 500;) {
    const Vector a = vector(), b = vector(), c = vector();
    // The normal of a sliver is uncertain for every rounded method.
    if ((b - a).cross(c - a).norm() < 1) continue;
    ++asked;
    check(a, b, c);
  }
}
