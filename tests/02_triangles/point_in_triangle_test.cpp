// All coordinates are whole numbers below 2^20, so that products and their differences are exact in
// double: every correct program decides them rightly, and there is no tolerance.
#include "point_in_triangle.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector2d;

struct Corners {
  Point a, b, c;
};

/// Twice the signed area of p, q, x in whole numbers.
std::int64_t area(const Point& p, const Point& q, const Point& x) {
  const auto whole = [](double number) { return static_cast<std::int64_t>(number); };
  return whole(q.x() - p.x()) * whole(x.y() - p.y()) - whole(q.y() - p.y()) * whole(x.x() - p.x());
}

/// The smallest of the areas that the point makes with the sides, counted positive inside.
std::int64_t depth(const Point& point, const Corners& t) {
  const std::int64_t sign = area(t.a, t.b, t.c) < 0 ? -1 : 1;
  return std::min(
      {sign * area(t.a, t.b, point), sign * area(t.b, t.c, point), sign * area(t.c, t.a, point)});
}

bool inside(const Point& point, const Corners& t) {
  return area(t.a, t.b, t.c) != 0 && depth(point, t) >= 0;
}

/// A yes or no says little about why it is wrong, so each call names the one mistake that this
/// question catches.
void check(const Point& point, const Corners& t, std::string_view mistake = "") {
  const bool right = inside(point, t);
  std::vector<Suspect<bool>> suspects;
  if (!mistake.empty())
    suspects.emplace_back(mistake,
                          std::function<bool(const bool&)>([](const bool&) { return true; }));
  ask("Is the point in the triangle?")
      .given("point", point)
      .given("a", t.a)
      .given("b", t.b)
      .given("c", t.c)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::point_in_triangle(point, t.a, t.b, t.c); })
      .equals(right);
}

int argument_of_extreme(const Eigen::Vector3d& values, bool largest) {
  Eigen::Index at = 0;
  largest ? values.maxCoeff(&at) : values.minCoeff(&at);
  return static_cast<int>(at);
}

void check_dropped(const Eigen::Vector3d& normal) {
  const double largest = normal.cwiseAbs().maxCoeff();
  ask("Which dimension is left out?")
      .given("normal", normal)
      .suspect("drops-smallest-dimension",
               [&] { return argument_of_extreme(normal.cwiseAbs(), false); })
      .suspect("signed-maximum", [&] { return argument_of_extreme(normal, true); })
      .answer([&] { return exercise::dropped_dimension(normal); })
      .satisfies("is 0, 1 or 2: a dimension in which the normal is largest, by size",
                 [&](int i) { return i >= 0 && i <= 2 && std::abs(normal[i]) == largest; });
}

const Corners kLeft{{0, 0}, {16, 0}, {0, 16}};
const Corners kRight{{0, 0}, {0, 16}, {16, 0}};

}  // namespace

TEST_CASE("the dropped dimension is the one in which the normal is largest") {
  check_dropped({1, 3, 9});
  check_dropped({9, 3, 1});
  check_dropped({3, 9, 1});
  check_dropped({3, 1, -9});
  check_dropped({-9, -3, -1});
  check_dropped({1, -9, 3});
  check_dropped({0, 4, -4});
  check_dropped({0.25, 0.25, 0.25});
}

TEST_CASE("a point inside is found for either orientation of the vertices") {
  check({4, 4}, kLeft);
  for (const Point& beside : {Point(-2, 4), Point(4, -2), Point(10, 10), Point(20, -2)}) {
    check(beside, kLeft);
  }
  check({4, 4}, kRight, "assumes-counter-clockwise");
  for (const Point& beside : {Point(-2, 4), Point(4, -2), Point(10, 10), Point(20, -2)}) {
    check(beside, kRight, "assumes-counter-clockwise");
  }
}

TEST_CASE("a point on an edge or a vertex is inside") {
  check({-2, 4}, kLeft);
  check({4, 4}, kLeft);
  for (const Point& on :
       {Point(8, 0), Point(0, 8), Point(8, 8), Point(0, 0), Point(16, 0), Point(0, 16)}) {
    check(on, kLeft, "touching-rejected");
  }
  check({0, 0}, {{0, 0}, {1, 0}, {0, 1}});
  check({4, 4}, kRight, "assumes-counter-clockwise");
  for (const Point& on :
       {Point(8, 0), Point(0, 8), Point(8, 8), Point(0, 0), Point(16, 0), Point(0, 16)}) {
    check(on, kRight, "touching-rejected");
  }
}

TEST_CASE("a triangle without area contains nothing") {
  check({4, 4}, kLeft);
  check({4, 4}, {{0, 0}, {8, 8}, {16, 16}}, "degenerate-accepted");
  check({20, 20}, {{0, 0}, {8, 8}, {16, 16}}, "degenerate-accepted");
  check({3, 5}, {{3, 5}, {3, 5}, {3, 5}}, "degenerate-accepted");
}

TEST_CASE("random points agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto point = [&] {
    return Point{double(random.integer(-500000, 500000)), double(random.integer(-500000, 500000))};
  };
  // Ties are another test's, on numbers where a method that divides makes no error either.
  const auto no_tie = [](const Point& x, const Point& a, const Point& b, const Point& c) {
    const auto whole_numbers = [](const Point& p) { return p == p.array().round().matrix(); };
    if (!(whole_numbers(x) && whole_numbers(a) && whole_numbers(b) && whole_numbers(c)))
      return false;
    const std::int64_t whole = std::abs(area(a, b, c));
    return whole > 0 && depth(x, {a, b, c}) != 0 && 1000 * std::abs(depth(x, {a, b, c})) >= whole;
  };
  const auto check_all = [](const Point& x, const Point& a, const Point& b, const Point& c) {
    check(x, {a, b, c});
  };
  for (int asked = 0; asked < 1000;) {
    const Point a = point();
    const Point b = point();
    const Point c = point();
    const Point x = point();
    if (std::abs(area(a, b, c)) < 1000000 || !no_tie(x, a, b, c)) continue;
    ++asked;
    shrinkable(check_all, no_tie, x, a, b, c);
  }
}
