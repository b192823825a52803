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

/// What decides between points with the same x.
enum class Tie { index, y_downwards };

/// The hull by two walks over the sorted points, right but for the order of ties.
Corners sorted_by_x(const Points& points, Tie tie) {
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  Corners order;
  for (std::size_t i = 0; i < points.size(); ++i) order.push_back(static_cast<int>(i));
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    if (at(i).x() != at(j).x() || tie == Tie::index) return at(i).x() < at(j).x();
    return at(i).y() > at(j).y();
  });
  const auto same = [&](int i, int j) { return at(i) == at(j); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  if (order.size() < 3) return order;
  Corners hull;
  for (int walk = 0; walk < 2; ++walk) {
    const std::size_t start = hull.size();
    for (const int i : order) {
      while (hull.size() >= start + 2 &&
             whole::orientation(at(hull[hull.size() - 2]), at(hull.back()), at(i)) <= 0) {
        hull.pop_back();
      }
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

/// Each vertex by the first index of its point, each once: what remains if equal points count once.
Corners without_copies(const Points& points, const Corners& got) {
  Corners first;
  for (const int i : got) {
    const auto found = std::find(points.begin(), points.end(), points[static_cast<std::size_t>(i)]);
    const int index = static_cast<int>(found - points.begin());
    if (first.empty() || first.back() != index) first.push_back(index);
  }
  while (first.size() > 1 && first.back() == first.front()) first.pop_back();
  return first;
}

bool keeps_copies(const Points& points, const Corners& got, const Corners& right) {
  if (!valid(points, got) || got == right) return false;
  const bool has_copy = std::any_of(got.begin(), got.end(), [&](int i) {
    return points[static_cast<std::size_t>(without_copies(points, {i})[0])] ==
               points[static_cast<std::size_t>(i)] &&
           without_copies(points, {i})[0] != i;
  });
  return has_copy && without_copies(points, got) == right;
}

/// All vertices, in order, and besides them only points that lie between two neighbours.
bool keeps_points_on_edges(const Points& points, const Corners& got, const Corners& right) {
  if (!valid(points, got) || right.size() < 3 || got.size() <= right.size() || got[0] != right[0])
    return false;
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  std::size_t edge = 0;
  for (std::size_t k = 1; k < got.size(); ++k) {
    const int to = right[(edge + 1) % right.size()];
    if (got[k] == to) {
      if (++edge == right.size()) return false;
      continue;
    }
    const Point a = at(right[edge]), b = at(to), p = at(got[k]);
    if (whole::orientation(a, b, p) != 0 || !((p - a).dot(p - b) < 0)) return false;
  }
  return edge + 1 == right.size();
}

/// All vertices but some at which the hull is nearly straight, and all of those that are missing
/// are such.
bool drops_thin_corners(const Points& points, const Corners& got, const Corners& right) {
  if (right.size() < 3 || got.empty() || got.size() >= right.size() || got[0] != right[0])
    return false;
  const auto at = [&](std::size_t k) {
    return points[static_cast<std::size_t>(right[k % right.size()])];
  };
  std::size_t next = 0;
  for (std::size_t k = 0; k < right.size(); ++k) {
    if (next < got.size() && got[next] == right[k]) {
      ++next;
      continue;
    }
    const Point u = at(k) - at(k + right.size() - 1), v = at(k + 1) - at(k);
    const double turn = std::abs(u.x() * v.y() - u.y() * v.x());
    if (!(u.dot(v) > 0) || turn > 1e-6 * u.norm() * v.norm()) return false;
  }
  return next == got.size();
}

void check(const Points& points) {
  const Corners right = whole::hull_2d(points);
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  ask("Which points are vertices of the hull, counter-clockwise?")
      .given("points", points)
      .suspect("hull-clockwise",
               [&] {
                 Corners reversed = right;
                 if (reversed.size() > 2) std::reverse(reversed.begin() + 1, reversed.end());
                 return reversed;
               })
      .suspect("ties-in-x", [&] { return sorted_by_x(points, Tie::index); })
      .suspect("ties-in-x", [&] { return sorted_by_x(points, Tie::y_downwards); })
      .suspect_if("duplicates-kept",
                  [&](const Corners& got) { return keeps_copies(points, got, right); })
      .suspect_if("half-hull",
                  [&](const Corners& got) {
                    // The first vertices of the right answer, up to the one of greatest x.
                    if (got.size() < 2 || got.size() >= right.size()) return false;
                    return std::equal(got.begin(), got.end(), right.begin()) &&
                           std::all_of(right.begin(), right.end(),
                                       [&](int i) { return at(i).x() <= at(got.back()).x(); });
                  })
      .suspect_if(
          "ends-kept-twice",
          [&](const Corners& got) {
            // Each walk with both of its ends.
            if (right.size() < 2) return false;
            const auto last = std::max_element(right.begin(), right.end(), [&](int i, int j) {
              return at(i).x() < at(j).x() || (at(i).x() == at(j).x() && at(i).y() < at(j).y());
            });
            Corners twice = right;
            twice.insert(twice.begin() + (last - right.begin()), *last);
            twice.push_back(right[0]);
            return got == twice;
          })
      .suspect_if("collinear-kept",
                  [&](const Corners& got) { return keeps_points_on_edges(points, got, right); })
      .suspect_if("epsilon-orientation",
                  [&](const Corners& got) { return drops_thin_corners(points, got, right); })
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
