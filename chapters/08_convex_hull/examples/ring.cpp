// The cost of moving points to new conflict lists: by a walk, or by testing every new triangle. The
// points are a ring, a few points above its middle, and one below.
#include <array>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

using Point = contact::Vector3<double>;

/// Exact orientation, with a counter.
class CountingSides : public contact::ExactSides {
 public:
  using ExactSides::ExactSides;
  static inline std::int64_t asked = 0;
  int side(const Plane& plane, int a, int b, int c, int d) const {
    ++asked;
    return ExactSides::side(plane, a, b, c, d);
  }
};

int main() {
  contact::HullShuffle random;
  const auto uniform = [&random] { return static_cast<double>(random.next() >> 11) * 0x1p-52 - 1; };
  std::printf("%8s %20s %20s\n", "points", "all tests", "moves alone, in turn");
  for (const int n : {125, 500, 2000}) {
    std::vector<Point> points{{0, 0, -3}};
    for (int i = 1; i <= 10; ++i) points.emplace_back(1e-3 * uniform(), 1e-3 * uniform(), 0.05 * i);
    while (static_cast<int>(points.size()) < n) {
      const double x = uniform(), y = uniform(), size = std::sqrt(x * x + y * y);
      if (size < 1 && size > 0.1) points.emplace_back(x / size, y / size, 1e-6 * uniform());
    }
    const int orders = 4;
    std::int64_t walking = 0, in_turn = 0;
    for (int order = 0; order < orders; ++order) {
      for (std::size_t i = points.size(); i > 1; --i)
        std::swap(points[i - 1], points[random.below(i)]);
      const CountingSides sides(points);
      CountingSides::asked = 0;
      contact::IncrementalHull<CountingSides> hull(sides, contact::first_simplex(points).points, n);
      for (int p = 0; p < n; ++p) hull.add_conflict(p, std::array{0, 1, 2, 3});
      std::vector<int> before(points.size());
      for (int p = 0; p < n; ++p) {
        if (hull.conflict_face(p) < 0) continue;
        for (int q = 0; q < n; ++q) before[static_cast<std::size_t>(q)] = hull.conflict_face(q);
        hull.add(p, hull.conflict_face(p), [](int, int) {});
        // What the moved points would have tested if they tried the new triangles in turn.
        const std::int64_t so_far = CountingSides::asked;
        std::vector<bool> gone(hull.all().size(), false);
        for (const int t : hull.removed()) gone[static_cast<std::size_t>(t)] = true;
        for (int q = 0; q < n; ++q) {
          const int t = before[static_cast<std::size_t>(q)];
          if (q == p || t < 0 || !gone[static_cast<std::size_t>(t)]) continue;
          for (const int made : hull.made()) {
            if (hull.side(hull.all()[static_cast<std::size_t>(made)], q) > 0) break;
          }
        }
        in_turn += CountingSides::asked - so_far;
        CountingSides::asked = so_far;
      }
      walking += CountingSides::asked;
    }
    std::printf("%8d %20lld %20lld\n", n, static_cast<long long>(walking / orders),
                static_cast<long long>(in_turn / orders));
  }
}
