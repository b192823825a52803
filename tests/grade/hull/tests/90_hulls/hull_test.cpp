// Indices that come back are looked at before anything is looked up with them.
#include "hull.hpp"

#include <algorithm>
#include <set>

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using Points = std::vector<Eigen::Vector2d>;

/// Whether every index is that of a point, and none comes twice.
bool are_indices(const std::vector<int>& got, std::size_t points) {
  const auto is_index = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < points; };
  return got.size() >= 3 && got.size() <= points && std::all_of(got.begin(), got.end(), is_index) &&
         std::set<int>(got.begin(), got.end()).size() == got.size();
}

/// Every other point is left of every edge: true of the hull's vertices in their order, and of
/// nothing else.
bool is_hull(const std::vector<int>& got, const Points& points) {
  if (!are_indices(got, points.size())) return false;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const int from = got[i], to = got[(i + 1) % got.size()];
    const Eigen::Vector2d a = points[static_cast<std::size_t>(from)];
    const Eigen::Vector2d u = points[static_cast<std::size_t>(to)] - a;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (static_cast<int>(j) == from || static_cast<int>(j) == to) continue;
      const Eigen::Vector2d v = points[j] - a;
      if (u.x() * v.y() - u.y() * v.x() <= 0) return false;
    }
  }
  return true;
}

void check(const Points& points) {
  ask("Which points are the vertices of the hull?")
      .given("points", points)
      .answer([&] { return exercise::hull(points); })
      .satisfies("names the vertices counter-clockwise",
                 [&](const std::vector<int>& got) { return is_hull(got, points); });
}

}  // namespace

TEST_CASE("the corners of a square, without the point inside") {
  check({{0, 0}, {1, 3}, {4, 0}, {4, 4}, {0, 4}});
  check({{1, 3}, {4, 4}, {4, 0}, {0, 4}, {0, 0}});
}

TEST_CASE("a triangle whose points come in any order") {
  check({{0, 0}, {3, 0}, {0, 3}});
  check({{0, 0}, {0, 3}, {3, 0}});
}

TEST_CASE("random points lie left of every edge") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 50; ++asked) {
    Points points;
    for (int i = 0; i < 20; ++i) points.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9));
    check(points);
  }
}
