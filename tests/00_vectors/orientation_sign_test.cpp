// Right answers are exact signs. A predicate has no tolerance: random paths are used only where the
// rounded formula is certain, and every named one has differences and products that are exact in
// double precision. Every test expects at least two different answers.
#include "orientation_sign.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/orientation.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector2d;

int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

double plain(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
}

void check(const Point& a, const Point& b, const Point& c) {
  const int right = contact::orient_2d_exactly(a, b, c);
  ask("In which direction does the path turn at b?")
      .given("a", a)
      .given("b", b)
      .given("c", c)
      .suspect("dot-for-cross", [&] { return sign((b - a).dot(c - b)); })
      .suspect("turn-reversed", [&] { return -right; })
      .suspect("products-before-differences",
               [&] { return sign(contact::orientation_expanded<double>(a, b, c)); })
      .suspect("absolute-epsilon",
               [&] { return std::abs(plain(a, b, c)) < 1e-6 ? 0 : sign(plain(a, b, c)); })
      .suspect("angles-subtracted",
               [&] {
                 return sign(std::atan2(c.y() - b.y(), c.x() - b.x()) -
                             std::atan2(b.y() - a.y(), b.x() - a.x()));
               })
      .answer([&] { return exercise::orientation_sign(a, b, c); })
      .equals(right);
}

}  // namespace

TEST_CASE("left, right and straight on") {
  check({0, 0}, {1, 0}, {2, 2});
  check({0, 0}, {1, 0}, {2, -2});
  check({0, 0}, {1, 0}, {3, 0});
  check({0, 0}, {2, 0}, {1, 0});
  check({0, 0}, {2, 0}, {1, 1});
  check({1, 2}, {1, 2}, {3, 4});
}

TEST_CASE("in every direction of the path") {
  // Bent to the left and to the right by less than a right angle, starting in eight directions.
  const std::array<Point, 8> steps{Point{2, 0},  Point{2, 2},   Point{0, 2},  Point{-2, 2},
                                   Point{-2, 0}, Point{-2, -2}, Point{0, -2}, Point{2, -2}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Point a(3, -1);
    const Point b = a + steps[i];
    check(a, b, b + steps[(i + 1) % 8]);
    check(a, b, b + steps[(i + 7) % 8]);
    check(a, b, b + steps[(i + 4) % 8]);
  }
}

TEST_CASE("a straight path is straight, also along a slope") {
  check({0, 0}, {3, 7}, {9, 21});
  check({0, 0}, {3, 7}, {9, 20});
  check({-5, 2}, {-2, 0.75}, {7, -3});
  check({0.5, 0.25}, {12, 6}, {24, 12});
  check({-5, 2}, {-2, 0.75}, {7, -2});
}

TEST_CASE("a tiny path turns like a large one") {
  for (const double scale : {0x1p-20, 0x1p-40, 0x1p-100, 0x1p40}) {
    check(scale * Point{0, 0}, scale * Point{1, 0}, scale * Point{2, 1});
    check(scale * Point{0, 0}, scale * Point{1, 0}, scale * Point{2, -1});
    check(scale * Point{0, 0}, scale * Point{1, 1}, scale * Point{3, 3});
  }
}

TEST_CASE("a path far from the origin turns like one near it") {
  for (const double far : {0x1p30, -0x1p34, 0x1p40}) {
    const Point position(far, far + 12345);
    for (const Point& c : {Point{2, 1}, Point{2, -1}, Point{2, 0}, Point{1, 1}}) {
      check(position, position + Point{1, 0}, position + c);
      check(position, position + Point{0.25, 0.125}, position + c);
    }
  }
}

TEST_CASE("random paths agree with exact arithmetic") {
  generators::Random random(seed(0));
  int asked = 0;
  while (asked < 300) {
    const Point a{random.uniform(-9, 9), random.uniform(-9, 9)};
    const Point b{random.uniform(-9, 9), random.uniform(-9, 9)};
    const double share = random.uniform(0.5, 3);
    const double bend = random.chance(0.5) ? random.uniform(-9, 9) : random.magnitude(-30, -10);
    const Point c = a + share * (b - a) + Point{0, bend};
    // Two rounded differences, a product and the last difference: 5 u of each product. Doubled, and
    // taken over all pairings of the three points.
    const double size = (a - b).norm() * (c - b).norm() + (a - b).norm() * (c - a).norm();
    if (!(std::abs(plain(a, b, c)) > 20 * 0x1p-53 * size)) continue;
    check(a, b, c);
    ++asked;
  }
}
