// Right answers are computed in whole numbers. Every test asks for at least two different answers.
#include "orientation.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <08_convex_hull/whole.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector2d;

int sign(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

int by_angles(const Point& a, const Point& b, const Point& c) {
  const double pi = 3.14159265358979323846;
  double angle =
      std::atan2(c.y() - a.y(), c.x() - a.x()) - std::atan2(b.y() - a.y(), b.x() - a.x());
  if (angle > pi) angle -= 2 * pi;
  if (angle <= -pi) angle += 2 * pi;
  return a == b || a == c || std::abs(angle) == pi ? 0 : sign(angle);
}

int by_unwrapped_angles(const Point& a, const Point& b, const Point& c) {
  return sign(std::atan2(c.y() - a.y(), c.x() - a.x()) - std::atan2(b.y() - a.y(), b.x() - a.x()));
}

int with_epsilon(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a;
  const double area = u.x() * v.y() - u.y() * v.x();
  return std::abs(area) <= 1e-9 * u.norm() * v.norm() ? 0 : sign(area);
}

int by_slopes(const Point& a, const Point& b, const Point& c) {
  return sign((c.y() - b.y()) / (c.x() - b.x()) - (b.y() - a.y()) / (b.x() - a.x()));
}

void check(const Point& a, const Point& b, const Point& c) {
  const int right = whole::orientation(a, b, c);
  ask("Does the path from a over b to c turn left (1), right (-1) or neither (0)?")
      .given("a", a)
      .given("b", b)
      .given("c", c)
      .suspect("turn-by-slopes", [&] { return by_slopes(a, b, c); })
      .suspect("turn-reversed", [&] { return -right; })
      .suspect("angles-subtracted", [&] { return by_unwrapped_angles(a, b, c); })
      .suspect("angles-by-atan2", [&] { return by_angles(a, b, c); })
      .suspect("epsilon-orientation", [&] { return with_epsilon(a, b, c); })
      .answer([&] { return exercise::orientation(a, b, c); })
      .close_to(right, within(0.0));
}

constexpr double kFar = 0x1p25;

}  // namespace

TEST_CASE("left is plus and right is minus") {
  check({0, 0}, {4, 0}, {6, 3});
  check({0, 0}, {4, 0}, {6, -3});
  check({1, 1}, {3, 2}, {5, 9});
  check({1, 1}, {3, 2}, {5, 2});
}

TEST_CASE("three points on one line give zero") {
  check({0, 0}, {2, 1}, {6, 3});
  check({0, 0}, {2, 1}, {6, 4});
  check({3, 1}, {3, 1}, {5, 9});
  check({3, 1}, {5, 9}, {3, 1});
  check({3, 1}, {5, 9}, {5, 9});
}

TEST_CASE("steep and backward paths turn as others do") {
  check({0, 0}, {0, 4}, {-2, 6});
  check({0, 0}, {0, 4}, {2, 6});
  check({0, 0}, {-4, 1}, {-6, 5});
  check({0, 0}, {-4, 1}, {-6, -5});
  check({0, 0}, {3, 1}, {-2, 2});
  check({0, 0}, {3, 1}, {-2, -2});
  // Straight back: the angles of the two steps differ by −π, and slopes give the same sign.
  check({-2, -2}, {-2, 2}, {-2, 0});
}

TEST_CASE("a cross product of 1 counts on a long path") {
  check({0, 0}, {kFar - 1, kFar - 2}, {kFar, kFar - 1});
  check({0, 0}, {kFar, kFar - 1}, {kFar - 1, kFar - 2});
  check({-kFar, -kFar}, {0, 0}, {kFar, kFar - 1});
  check({-kFar, -kFar}, {kFar - 1, kFar - 2}, {kFar, kFar - 1});
  check({-kFar, -kFar}, {0, 0}, {kFar, kFar});
  // Different directions with the same rounded arctangent.
  check({kFar, -kFar}, {-21542497, 19078079}, {-29946953, 27106614});
  check({kFar, -kFar}, {-27202485, 6795957}, {-18583107, 1071584});
}

TEST_CASE("random points agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  const auto whole_numbers = [](const Point& a, const Point& b, const Point& c) {
    const auto whole = [](const Point& p) {
      return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= kFar;
    };
    return whole(a) && whole(b) && whole(c);
  };
  for (int i = 0; i < 400; ++i) {
    const int size = i % 2 == 0 ? 3 : 1 << 25;
    const auto point = [&] {
      return Point{double(random.integer(-size, size)), double(random.integer(-size, size))};
    };
    const Point a = point(), b = point(), c = point();
    shrinkable(check, whole_numbers, a, b, c);
  }
}
