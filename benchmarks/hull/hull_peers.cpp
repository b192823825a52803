// Compares the book's hull with Qhull's, CGAL's and Bullet's: medians of several runs, and the
// result of each. usage: hull_peers [points] [runs]
#include "peers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>

namespace {

using Point = contact::Vector3<double>;
using Points = std::vector<Point>;
using Method = std::function<peers::Counts()>;

contact::HullShuffle dice;

double uniform() { return static_cast<double>(dice.next() >> 11) * 0x1p-52 - 1; }

Point in_ball() {
  for (;;) {
    const double x = uniform(), y = uniform();
    const Point p(x, y, uniform());
    if (p.squaredNorm() <= 1 && p.squaredNorm() > 0.01) return p;
  }
}

Points make(std::size_t count, const std::function<Point()>& draw) {
  Points points;
  while (points.size() < count) points.push_back(draw());
  return points;
}

void compare(const char* family, const Points& points, int runs) {
  std::vector<double> flat;
  for (const Point& p : points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  std::vector<std::pair<std::string, Method>> methods{
      {"Contact Hours, exact", [&points] {
         const contact::Hull hull = contact::convex_hull(points);
         return peers::Counts{hull.vertices.size(), static_cast<std::size_t>(hull.face_count())};
       }}};
#ifdef CONTACT_HAS_QHULL
  methods.emplace_back("Qhull, merging", [&flat] { return peers::qhull(flat); });
#endif
#ifdef CONTACT_HAS_CGAL
  methods.emplace_back("CGAL, exact predicates", [&flat] { return peers::cgal(flat); });
#endif
#ifdef CONTACT_HAS_BULLET
  methods.emplace_back("Bullet, whole numbers", [&flat] { return peers::bullet(flat); });
#endif
  std::vector<std::vector<double>> times(methods.size());
  std::vector<peers::Counts> counts(methods.size());
  // In turns, so that a slow moment of the machine does not fall on one method only.
  for (int run = 0; run <= runs; ++run) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto start = std::chrono::steady_clock::now();
      counts[m] = methods[m].second();
      const std::chrono::duration<double, std::milli> elapsed =
          std::chrono::steady_clock::now() - start;
      if (run > 0) times[m].push_back(elapsed.count());  // the first one warms up
    }
  }
  std::printf("%s, %zu points\n  %-24s %10s %19s %9s %9s\n", family, points.size(), "", "ms",
              "least - most", "vertices", "faces");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::sort(times[m].begin(), times[m].end());
    std::printf("  %-24s %10.1f %8.1f - %8.1f %9zu %9zu\n", methods[m].first.c_str(),
                times[m][times[m].size() / 2], times[m].front(), times[m].back(),
                counts[m].vertices, counts[m].faces);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? static_cast<std::size_t>(std::atol(argv[1])) : 100000;
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 7;
  compare("in a ball", make(count, in_ball), runs);
  compare("on a sphere",
          make(count,
               [] {
                 const Point p = in_ball();
                 return Point(p / p.norm());
               }),
          runs);
  const int side = static_cast<int>(std::cbrt(static_cast<double>(count)));
  int next = 0;
  compare("on a grid",
          make(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                   static_cast<std::size_t>(side),
               [&] {
                 const int i = next++;
                 return Point(i % side, i / side % side, i / (side * side));
               }),
          runs);
}
