// Whether polygons meet is computed in integers, from their edges, without any direction. Whether a
// direction separates is decided on the numbers as they are returned. The first questions of a test
// each bring one mistake to light that no question before did, so that the mistake is known by it.
#include "separating_axis.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <09_separating_planes/polygons_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using polygons_with_mistakes::Apart;
using polygons_with_mistakes::Axis;
using polygons_with_mistakes::meet;
using polygons_with_mistakes::Point;
using polygons_with_mistakes::Polygon;
using polygons_with_mistakes::Search;
using polygons_with_mistakes::sign_of_gap;

constexpr double kFar = 1000000;

void check_separates(const Point& direction, const Polygon& first, const Polygon& second) {
  const auto with = [&](Apart apart) {
    return
        [&, apart] { return polygons_with_mistakes::separates(direction, first, second, apart); };
  };
  ask("Is the first polygon before the second along the direction, and apart from it?")
      .given("direction", direction)
      .given("first", first)
      .given("second", second)
      .suspect("second-before-first", with(Apart::in_the_other_order))
      .suspect("either-order-separates", with(Apart::in_either_order))
      .suspect("some-vertices-apart", with(Apart::by_some_vertices))
      .suspect("centres-for-extents", with(Apart::by_centres))
      .suspect("first-vertices-alone", with(Apart::by_the_first_vertices))
      .suspect("maximum-from-zero", with(Apart::high_from_zero))
      .suspect("touching-called-apart", with(Apart::if_touching))
      .suspect("projection-rounded", with(Apart::by_unit))
      .suspect("absolute-epsilon", with(Apart::by_a_millionth))
      .suspect("projection-in-float", with(Apart::in_float))
      .answer([&] { return exercise::separates(direction, first, second); })
      .equals(polygons_with_mistakes::separates(direction, first, second));
}

/// Whether `n` is a direction of length 1 along which polygons that touch look apart.
bool is_rounded(const Point& n, const Polygon& first, const Polygon& second) {
  return std::abs(n.norm() - 1) < 1e-12 && meet(first, second) &&
         polygons_with_mistakes::separates(n, first, second, Apart::if_nearly_touching);
}

void check_axis(const Polygon& first, const Polygon& second) {
  const bool apart = !meet(first, second);
  const auto with = [&](const Search& search) {
    return [&, search] { return polygons_with_mistakes::separating_axis(first, second, search); };
  };
  const auto sign = [&](const Axis& n) {
    return n && n->allFinite() ? sign_of_gap(*n, first, second) : -1;
  };
  ask("Which direction separates the first polygon from the second?")
      .given("first", first)
      .given("second", second)
      .suspect("edge-for-its-normal", with({.edges = true}))
      .suspect("first-direction-decides", with({.first_decides = true}))
      .suspect("edge-normal-inwards", with({.inwards = true}))
      .suspect("last-edge-forgotten", with({.last_edge = false}))
      .suspect("directions-of-the-coordinates",
               [&] { return polygons_with_mistakes::by_boxes(first, second); })
      .suspect("direction-of-the-centres",
               [&] { return polygons_with_mistakes::by_centres(first, second); })
      .suspect("edges-of-one-polygon", with({.of_first = false}))
      .suspect("edges-of-one-polygon", with({.of_second = false}))
      .suspect("second-normal-not-reversed", with({.second_outwards = true}))
      .suspect("no-axis-without-edges", with({.along = false}))
      .suspect_if("second-before-first",
                  [&](const Axis& got) { return apart && got && sign(Point(-*got)) > 0; })
      .suspect_if("touching-called-apart",
                  [&](const Axis& got) { return got && !got->isZero(0) && sign(got) == 0; })
      .suspect_if("projection-rounded",
                  [&](const Axis& got) {
                    return got && sign(got) != 0 && got->allFinite() &&
                           is_rounded(*got, first, second);
                  })
      .answer([&] { return exercise::separating_axis(first, second); })
      .satisfies(apart
                     ? "is a direction n with n . p < n . q for all vertices p of the first and q "
                       "of the second, for the numbers as you return them"
                     : "is nothing, because the polygons have a point in common",
                 [&](const Axis& got) { return got ? sign(got) > 0 : !apart; });
}

/// In both orders, and with each vertex of the polygons as the first one.
void check_all_orders(Polygon first, Polygon second) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      check_axis(first, second);
      check_axis(second, first);
      std::rotate(second.begin(), second.begin() + 1, second.end());
    }
    std::rotate(first.begin(), first.begin() + 1, first.end());
  }
}

/// The vertices of the hull of some points, counter-clockwise, from any of them.
Polygon hull(std::vector<Point> points, int first) {
  std::sort(points.begin(), points.end(), [](const Point& p, const Point& q) {
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon around;
  const auto half = [&](auto from, auto to) {
    const std::size_t begin = around.size();
    for (auto p = from; p != to; ++p) {
      while (around.size() >= begin + 2 &&
             polygons_with_mistakes::area(around[around.size() - 2], around.back(), *p) <= 0)
        around.pop_back();
      around.push_back(*p);
    }
    around.pop_back();
  };
  half(points.begin(), points.end());
  half(points.rbegin(), points.rend());
  std::rotate(around.begin(), around.begin() + first % std::ssize(around), around.end());
  return around;
}

}  // namespace

TEST_CASE("a direction separates the first polygon from the second or not") {
  check_separates({3, 2}, {{0, 0}, {4, 1}, {2, 5}}, {{9, 2}, {14, 3}, {7, 9}});
  check_separates({0, 1}, {{0, -2}, {5, -1}, {4, 5}, {0, 3}},
                  {{-1, -5}, {0, -7}, {3, -9}, {5, -4}});
  check_separates({-5, -5}, {{0, -2}, {5, 4}, {-3, 2}, {-3, -1}}, {{6, -3}, {6, 2}, {-2, -1}});
  check_separates({4, -2}, {{8, 0}, {1, 1}, {1, -2}}, {{0, 3}, {7, -5}, {7, -3}});
  check_separates({-3, 5}, {{4, -2}, {4, 0}, {-3, -2}}, {{-9, -7}, {-8, -10}, {-5, -6}, {-4, -4}});
  check_separates({1, 0}, {{0, 0}, {9, 1}, {2, 5}}, {{4, 2}, {2, 7}, {1, 3}});
  check_separates({-2, 1}, {{0, 0}, {9, 1}, {2, 5}}, {{-4, 2}, {-2, 7}, {-3, 9}});
  check_separates({1, 0}, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{5, 0}, {9, 0}, {9, 4}, {5, 4}});
}

TEST_CASE("all numbers of a projection may be negative") {
  check_separates({1, 1}, {{-9, -8}, {-7, -8}, {-8, -5}}, {{-4, -7}, {-1, -9}, {-2, -3}});
  check_separates({-1, 0}, {{9, 2}, {14, 3}, {7, 9}}, {{0, 0}, {4, 1}, {2, 5}});
  check_separates({-1, -1}, {{9, 2}, {14, 3}, {7, 9}}, {{5, 5}, {8, 4}, {9, 9}});
}

TEST_CASE("touching is not apart, and the zero direction separates nothing") {
  check_separates({2, 1}, {{-4, -6}, {0, 1}, {-6, -2}}, {{2, -3}, {6, -3}, {9, 3}, {4, -1}});
  check_separates({0, 0}, {{0, 0}, {4, 1}, {2, 5}}, {{9, 2}, {14, 3}, {7, 9}});
  check_separates({1, 0}, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{4, 7}, {9, 7}, {9, 9}});
  check_separates({1, 0}, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{5, 7}, {9, 7}, {9, 9}});
  check_separates({0, 0}, {{3, 4}}, {{5, 6}});
}

TEST_CASE("whole numbers are decided without rounding") {
  check_separates({-1, -2}, {{22, -13}, {32, -26}, {29, -20}}, {{12, -16}, {0, -16}, {10, -24}});
  check_separates({4, 2}, {{-7, -9}, {-5, -9}, {-5, -3}, {-11, -1}, {-10, -7}},
                  {{-4, -1}, {-1, -1}, {-2, 6}, {-7, 6}, {-7, 1}});
  const Point steep(2 * kFar, 2 * kFar - 1);
  const Polygon below{{0, 0}, {-4, 1}, {-3, -5}}, above{{1, -1}, {3, 0}, {2, 9}};
  check_separates(steep, below, above);
  Polygon far_below = below, far_above = above;
  for (Point& p : far_below) p += Point(608790, -706693);
  for (Point& q : far_above) q += Point(608790, -706693);
  check_separates(steep, far_below, far_above);
  check_separates(-steep, far_above, far_below);
  check_separates(-steep, far_below, far_above);
  check_separates(steep, {{0, 0}, {1, -1}, {-3, -5}}, above);
}

TEST_CASE("an edge of the first polygon separates, whichever it is") {
  check_axis({{-7, 7}, {1, 5}, {-4, 11}, {-5, 11}}, {{-4, 3}, {-3, 2}, {1, 3}});
  check_axis({{-5, 2}, {-9, 7}, {-9, 1}, {-7, 0}}, {{1, -8}, {5, -2}, {-2, -3}});
  check_axis({{3, -3}, {3, -1}, {-2, -2}, {1, -3}}, {{-4, -4}, {0, -11}, {4, -8}});
  check_axis({{3, -1}, {0, -9}, {3, -8}, {7, -1}}, {{6, 1}, {4, 7}, {1, 9}, {2, 5}});
  check_axis({{-5, -8}, {-9, -3}, {-12, -9}, {-9, -10}}, {{-2, -1}, {-5, -1}, {-1, -4}});
  check_axis({{-6, 1}, {-3, 0}, {-9, 5}}, {{-3, 3}, {-7, 4}, {-4, 2}});
  check_axis({{5, 0}, {3, -7}, {8, 1}}, {{2, -1}, {3, -5}, {3, -1}});
  check_all_orders({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{12, 2}, {14, 5}, {11, 7}});
}

TEST_CASE("an edge of the second polygon may be the only one") {
  check_axis({{-1, 5}, {0, 5}, {-2, 13}, {-4, 8}}, {{4, 5}, {0, 1}, {4, 3}});
  check_axis({{3, -5}, {-2, -3}, {-5, -3}, {-5, -6}, {-4, -8}},
             {{1, -11}, {3, -8}, {4, -4}, {-1, -10}});
  check_all_orders({{9, 3}, {12, 2}, {12, 4}}, {{0, 0}, {8, -9}, {8, 12}});
}

TEST_CASE("polygons that meet have no separating direction") {
  const Polygon square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  check_axis(square, {{11, 2}, {14, 5}, {10, 7}});
  check_axis(square, {{9, 9}, {15, 11}, {12, 18}});
  check_all_orders(square, {{2, 2}, {14, 5}, {4, 7}});
  check_all_orders(square, {{2, 2}, {7, 5}, {4, 7}});
  check_all_orders(square, {{-3, 4}, {12, 3}, {12, 6}});
  check_all_orders(square, {{9, 2}, {14, 5}, {9, 7}});
  check_all_orders(square, {{9, 4}, {14, 5}, {13, 7}});
  check_all_orders(square, square);
  check_all_orders({{0, 0}, {7, 3}, {2, 8}}, {{14, 6}, {7, 3}, {9, 1}});
  check_all_orders({{0, 0}, {7, 3}, {2, 8}}, {{14, 6}, {21, 9}, {9, 15}});
  const double steep = kFar - 1;
  check_all_orders({{-kFar, -kFar}, {kFar, steep}, {-kFar, kFar}},
                   {{-1, -2}, {0, -1}, {kFar, -kFar}});
  check_all_orders({{-kFar, -kFar}, {kFar, steep}, {-kFar, kFar}},
                   {{0, -kFar}, {kFar, steep}, {kFar, kFar}});
}

TEST_CASE("points and segments are polygons too") {
  check_axis({{2, 3}}, {{5, 7}});
  check_axis({{0, 0}, {4, 2}}, {{6, 3}, {10, 5}});
  check_all_orders({{0, 0}, {4, 2}}, {{6, 3}});
  check_all_orders({{0, 0}, {4, 2}}, {{4, 2}, {8, 4}});
  check_all_orders({{0, 0}, {4, 2}}, {{2, 1}});
  check_all_orders({{0, 0}, {4, 2}}, {{1, 1}, {5, 3}});
  check_all_orders({{0, 0}, {4, 2}}, {{3, 0}, {1, 2}});
  check_all_orders({{0, 0}, {4, 2}}, {{3, 0}, {9, 2}});
  check_all_orders({{0, 0}, {4, 2}}, {{3, 0}});
  check_all_orders({{4, 2}}, {{4, 2}});
  check_all_orders({{4, 2}}, {{-4, -2}});
  const Polygon triangle{{0, 0}, {9, 2}, {3, 8}};
  for (const Point& p : {Point(4, 3), Point(6, 5), Point(9, 2), Point(7, 5), Point(18, 4)})
    check_all_orders(triangle, {p});
  check_all_orders(triangle, {{-2, 3}, {14, 5}});
  check_all_orders(triangle, {{3, 2}, {5, 3}});
  check_all_orders(triangle, {{9, 2}, {18, 4}});
  check_all_orders(triangle, {{10, 3}, {18, 4}});
}

TEST_CASE("random polygons agree with integers") {
  generators::Random random(seed(0));
  const auto judged = [](const Polygon& first, const Polygon& second) {
    return polygons_with_mistakes::is_convex(first, kFar) &&
           polygons_with_mistakes::is_convex(second, kFar);
  };
  const auto judged_direction = [&](const Point& n, const Polygon& first, const Polygon& second) {
    return judged(first, second) && polygons_with_mistakes::is_whole(n, 2 * kFar);
  };
  for (int asked = 0; asked < 600; ++asked) {
    const int size = asked % 4 == 0 ? 490000 : asked % 2 == 0 ? 9 : 4;
    const auto point = [&](int limit) {
      const double x = random.integer(-limit, limit);
      return Point(x, random.integer(-limit, limit));
    };
    const auto polygon = [&](const Point& centre) {
      std::vector<Point> points;
      const int count = random.integer(1, 6);
      for (int i = 0; i < count; ++i) points.push_back(centre + point(size));
      return hull(points, random.integer(0, 5));
    };
    const Point from = point(size), to = point(size);
    const Polygon first = polygon(from), second = polygon(to);
    shrinkable(check_axis, judged, first, second);
    const Point along = random.chance(0.5) ? Point(to - from) : point(2 * size);
    shrinkable(check_separates, judged_direction, along, first, second);
  }
}
