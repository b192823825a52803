// The lecture's first rule on points with ties at the top, and the rule that repairs it.
#include <array>
#include <contact/convex_hull.hpp>
#include <cstdio>
#include <vector>

using Point = contact::Vector3<double>;

int main() {
  const std::vector<Point> points{{1, 0, 5}, {0, 0, 5},  {4, 0, 5},
                                  {2, 3, 0}, {2, -3, 0}, {2, 0, -2}};
  const contact::Hull hull = contact::convex_hull(points);
  const auto key = [&points](std::size_t i) {
    return std::array{points[i].z(), points[i].x(), points[i].y()};
  };
  std::size_t highest = 0, lexicographic = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].z() > points[highest].z()) highest = i;
    if (key(i) > key(lexicographic)) lexicographic = i;
  }
  const auto report = [&](const char* rule, std::size_t i) {
    bool vertex = false;
    for (const int v : hull.vertices) vertex = vertex || v == static_cast<int>(i);
    std::printf("%-28s point %zu (%g, %g, %g): %s\n", rule, i, points[i].x(), points[i].y(),
                points[i].z(), vertex ? "a vertex" : "no vertex");
  };
  report("first of the highest:", highest);
  report("highest, then x, then y:", lexicographic);
}
