// Right answers are computed in whole numbers, by wrapping. Every test asks for several answers.
#include "hull_2d.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <08_convex_hull/whole.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector2d;
using Points = std::vector<Point>;
using Corners = std::vector<int>;

bool valid(const Points& points, const Corners& got) {
  return std::all_of(got.begin(), got.end(),
                     [&](int i) { return i >= 0 && i < static_cast<int>(points.size()); });
}

void check(const Points& points) {
  const Corners right = whole::hull_2d(points);
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  const auto has = [](const Corners& list, int i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  ask("Which points are vertices of the hull, counter-clockwise?")
      .given("points", points)
      .suspect("hull-clockwise",
               [&] {
                 Corners reversed = right;
                 if (reversed.size() > 2) std::reverse(reversed.begin() + 1, reversed.end());
                 return reversed;
               })
      .suspect_if("duplicates-kept",
                  [&](const Corners& got) {
                    if (!valid(points, got)) return false;
                    for (std::size_t i = 0; i < got.size(); ++i) {
                      for (std::size_t j = 0; j < i; ++j) {
                        if (got[i] != got[j] && at(got[i]) == at(got[j])) return true;
                      }
                      // Or a later one of equal points instead of the first.
                      for (const int j : right) {
                        if (!has(right, got[i]) && at(got[i]) == at(j)) return true;
                      }
                    }
                    return false;
                  })
      .suspect_if("half-hull",
                  [&](const Corners& got) {
                    // The first vertices of the right answer, up to the one of greatest x.
                    if (got.size() < 2 || got.size() >= right.size()) return false;
                    return std::equal(got.begin(), got.end(), right.begin()) &&
                           std::all_of(right.begin(), right.end(),
                                       [&](int i) { return at(i).x() <= at(got.back()).x(); });
                  })
      .suspect_if("ties-in-x",
                  [&](const Corners& got) {
                    if (!valid(points, got)) return false;
                    // A point with the same x as a right vertex is returned instead of it or beside
                    // it.
                    for (const int i : got) {
                      if (has(right, i)) continue;
                      for (const int j : right) {
                        if (at(i).x() == at(j).x() && (i < j || !has(got, j))) return true;
                      }
                    }
                    return !got.empty() && !right.empty() && got[0] != right[0] &&
                           at(got[0]).x() == at(right[0]).x();
                  })
      .suspect_if("collinear-kept",
                  [&](const Corners& got) {
                    return got.size() > right.size() && valid(points, got) &&
                           std::all_of(right.begin(), right.end(),
                                       [&](int i) { return has(got, i); });
                  })
      .suspect_if("epsilon-orientation",
                  [&](const Corners& got) {
                    return got.size() < right.size() && valid(points, got) &&
                           std::all_of(got.begin(), got.end(),
                                       [&](int i) { return has(right, i); });
                  })
      .answer([&] { return exercise::hull_2d(points); })
      .close_to(right, within(0.0));
}

constexpr double kFar = 0x1p25;

}  // namespace

TEST_CASE("the vertices come counter-clockwise from the leftmost") {
  check({{4, 3}, {0, 0}, {5, -2}, {2, 1}});
  check({{1, 0}, {7, 1}, {0, 2}, {6, 5}, {3, 3}, {4, -1}});
  check({{0, 0}, {3, 8}, {9, 1}});
}

TEST_CASE("points on an edge are no vertices") {
  check({{0, 0}, {2, -1}, {4, -2}, {8, 5}, {4, 3}});
  check({{0, 1}, {3, 4}, {1, 2}, {2, 3}, {5, 0}});
  check({{-6, 0}, {6, -6}, {0, -3}, {2, -4}, {7, 1}});
}

TEST_CASE("points with the same x are sorted by y") {
  check({{0, 4}, {0, 0}, {0, 2}, {5, 1}});
  check({{0, 2}, {0, 5}, {0, 0}, {4, 3}, {4, 6}, {4, -1}});
  check({{3, 0}, {3, 3}, {0, 3}, {0, 0}});
}

TEST_CASE("equal points count once") {
  check({{0, 0}, {4, 1}, {4, 1}, {1, 5}, {0, 0}});
  check({{7, 2}, {7, 2}, {7, 2}});
  check({{1, 1}, {5, 2}, {1, 1}, {5, 2}});
}

TEST_CASE("no points, one point and points on a line have a hull too") {
  check({});
  check({{3, -2}});
  check({{4, 4}, {0, 0}, {2, 2}, {1, 1}});
  check({{2, 7}, {2, -3}, {2, 0}});
}

TEST_CASE("a vertex just outside an edge is kept") {
  check({{-kFar, -kFar}, {0, -1}, {kFar, kFar - 1}, {-kFar, kFar}});
  check({{-kFar, -kFar}, {0, 0}, {kFar, kFar}, {-kFar, kFar}});
  check({{0, 0}, {kFar - 1, kFar - 2}, {kFar, kFar - 1}, {3, kFar}});
}

TEST_CASE("random points agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  const auto whole_numbers = [](const Points& points) {
    return std::all_of(points.begin(), points.end(), [](const Point& p) {
      return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= 0x1p25;
    });
  };
  for (int round = 0; round < 150; ++round) {
    const int size = round % 3 == 0 ? 1 << 25 : 2 + round % 7;
    Points points;
    for (int n = random.integer(1, 25); n > 0; --n) {
      const double x = random.integer(-size, size);
      points.push_back({x, double(random.integer(-size, size))});
    }
    shrinkable(check, whole_numbers, points);
  }
}
