// Integer planes with normals of integer length, so that right answers are known exactly; and
// random ones, where exact arithmetic gives the numerator. Every test expects at least two
// different answers, so that no constant passes.
#include "signed_distance.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::PlaneEquation;
using Vector = Eigen::Vector3d;

/// a·x + b·y + c·z + d, exact.
Exact exact_value(const PlaneEquation& p, const Vector& x) {
  return Exact(p.a) * Exact(x.x()) + Exact(p.b) * Exact(x.y()) + Exact(p.c) * Exact(x.z()) +
         Exact(p.d);
}

double length(const PlaneEquation& p) { return std::sqrt(p.a * p.a + p.b * p.b + p.c * p.c); }

double value(const PlaneEquation& p, const Vector& x) {
  return p.a * x.x() + p.b * x.y() + p.c * x.z() + p.d;
}

/// The exact numerator, rounded once, over the length, whose relative error is at most 3 u.
double right_distance(const PlaneEquation& p, const Vector& x) {
  return quotient<double>(exact_value(p, x), Exact(1)) / length(p);
}

/// Four roundings in the numerator (γ(4) < 5u of Σ|terms|), and as many in the length and the
/// quotient; with the oracle's own 5 u of the result, 16 u Σ|terms| / length is enough for any
/// order of summing. Normalising first rounds each coefficient by 4 u more: still below 16 u.
double bound(const PlaneEquation& p, const Vector& x) {
  const double terms =
      std::abs(p.a * x.x()) + std::abs(p.b * x.y()) + std::abs(p.c * x.z()) + std::abs(p.d);
  return 16 * 0x1p-53 * terms / length(p);
}

void check_distance(const PlaneEquation& plane, const Vector& point) {
  ask("What is the signed distance of the point from the plane?")
      .given("plane", plane)
      .given("point", point)
      .suspect("offset-sign", [&] { return (value(plane, point) - 2 * plane.d) / length(plane); })
      .suspect("normal-not-normalised", [&] { return value(plane, point); })
      .suspect("distance-without-sign",
               [&] { return std::abs(value(plane, point)) / length(plane); })
      .answer([&] { return exercise::signed_distance(plane, point); })
      .close_to(right_distance(plane, point), within(bound(plane, point)));
}

void check_side(const PlaneEquation& plane, const Vector& point) {
  const auto sign = [](double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); };
  // "On the plane" indicates a tolerance only if the distance is small.
  const bool near = std::abs(value(plane, point)) < 1e-3 * length(plane);
  ask("On which side of the plane is the point?")
      .given("plane", plane)
      .given("point", point)
      .suspect("offset-sign", [&] { return sign(value(plane, point) - 2 * plane.d); })
      .suspect_if("absolute-epsilon", [near](const int& got) { return near && got == 0; })
      .answer([&] { return exercise::side(plane, point); })
      .equals(exact_value(plane, point).sign());
}

// The normal (2, 3, 6) is 7 long.
const PlaneEquation kSeven{2, 3, 6, 0};

}  // namespace

TEST_CASE("the distance is in metres, whatever the length of the normal") {
  check_distance({0, 0, 1, 0}, {5, -2, 4});
  check_distance({0, 0, 2, 0}, {5, -2, 4});
  check_distance(kSeven, {2, 3, 6});
  check_distance(kSeven, {3, -2, 1});
}

TEST_CASE("the constant of the equation is on its left-hand side") {
  check_distance({0, 0, 1, -3}, {1, 1, 4});
  check_distance({2, 3, 6, 14}, {1, 1, 1});
}

TEST_CASE("behind the plane the distance is negative") {
  check_distance({0, 0, 1, -3}, {1, 1, 4});
  check_distance({0, 0, 1, -3}, {1, 1, -2});
  check_distance({2, 3, 6, 14}, {-8, -6, -7});
}

TEST_CASE("the side is front, back or on the plane") {
  check_side({0, 0, 1, -3}, {1, 1, 5});
  check_side({0, 0, 1, -3}, {1, 1, 2});
  check_side({0, 0, 1, -3}, {1, 1, 3});
  check_side({2, 3, 6, 14}, {-1, -2, -1});  // −2 − 6 − 6 + 14 = 0
}

TEST_CASE("a point near the plane is not on it") {
  check_side({0, 0, 1, -3}, {1, 1, 3});
  for (const double near : {0x1p-30, -0x1p-30, 0x1p-45, -0x1p-45}) {
    check_side({0, 0, 1, -3}, {1, 1, 3 + near});
    check_side({0, 0, 0x1p-20, 0}, {1, 1, near});
  }
}

TEST_CASE("random points agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto number = [&] { return random.uniform(-10, 10); };
  const auto is_plane = [](const PlaneEquation& plane, const Vector&) {
    return length(plane) >= 1e-3;
  };
  // A point within rounding error of the plane may be classified either way.
  const auto off_plane = [&](const PlaneEquation& plane, const Vector& point) {
    return is_plane(plane, point) &&
           std::abs(value(plane, point)) > 2 * bound(plane, point) * length(plane);
  };
  for (int asked = 0; asked < 500; ++asked) {
    const PlaneEquation plane{number(), number(), number(), number()};
    const Vector point{number(), number(), number()};
    if (!is_plane(plane, point)) continue;
    shrinkable(check_distance, is_plane, plane, point);
    if (off_plane(plane, point)) shrinkable(check_side, off_plane, plane, point);
  }
}
