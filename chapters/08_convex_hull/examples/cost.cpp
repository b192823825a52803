// Counts the orientation tests of gift wrapping and of the incremental algorithm.
#include <contact/convex_hull.hpp>
#include <contact/gift_wrapping.hpp>
#include <cstdint>
#include <cstdio>
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

/// Points in a ball, or on its surface.
std::vector<Point> draw(int count, bool on_surface) {
  contact::HullShuffle random;
  const auto uniform = [&random] { return static_cast<double>(random.next() >> 11) * 0x1p-52 - 1; };
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    const double x = uniform(), y = uniform(), z = uniform();
    const Point p(x, y, z);
    if (p.squaredNorm() > 1 || p.squaredNorm() < 0.01) continue;
    points.push_back(on_surface ? Point(p / p.norm()) : p);
  }
  return points;
}

/// One line of a table.
void count(const std::vector<Point>& points) {
  CountingSides::asked = 0;
  const contact::Hull hull = contact::convex_hull_with<CountingSides>(points);
  const std::int64_t incremental = CountingSides::asked;
  CountingSides::asked = 0;
  contact::gift_wrap_with<CountingSides>(points);
  std::printf("%8zu %9zu %16lld %16lld\n", points.size(), hull.vertices.size(),
              static_cast<long long>(CountingSides::asked), static_cast<long long>(incremental));
}

int main() {
  for (const bool on_surface : {false, true}) {
    std::printf("%s\n%8s %9s %16s %16s\n", on_surface ? "on a sphere" : "in a ball", "points",
                "vertices", "wrapping", "incremental");
    for (const int n : {125, 500, 2000}) count(draw(n, on_surface));
  }
  std::printf("some on a sphere, the others within half of it\n");
  for (const int n : {500, 2000}) {
    for (const int part : {16, 4, 2, 1}) {
      std::vector<Point> points = draw(n / part, true);
      for (const Point& p : draw(n - n / part, false)) points.push_back(p / 2);
      count(points);
    }
  }
}
