// What each step of GJK knows of the distance of two hulls: a lower and an upper bound.
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/gjk.hpp>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

namespace {

using contact::Vector3;

// Points with whole coordinates from -100 to 100 that lie close to a ball, and their hull.
contact::ConvexHull<double> rough_ball(int count, const Vector3<double>& centre) {
  std::vector<Vector3<double>> points;
  std::uint32_t state = 1;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;
    return static_cast<int>(state >> 16) % 201 - 100;
  };
  while (static_cast<int>(points.size()) < count) {
    const double x = next(), y = next(), z = next();
    const double squared = x * x + y * y + z * z;
    if (squared < 8100 || squared > 10000) continue;
    points.push_back(centre + Vector3<double>(x, y, z) / 100);
  }
  return contact::convex_hull_from_points<double>(std::span<const Vector3<double>>(points));
}

}  // namespace

int main() {
  const auto a = rough_ball(60, {0, 0, 0});
  const auto b = rough_ball(60, {2.5, 1, 0.5});
  std::printf("step  vertices  at least, m   at most, m\n");
  int step = 0;
  for (const contact::GjkStep<double>& s : contact::gjk_steps(a, b)) {
    const double upper = std::sqrt(s.closest.dot(s.closest));
    std::printf("%4d  %8d  %11.9f  %11.9f\n", ++step, s.count,
                std::fmax(0, s.next.dot(s.closest) / upper), upper);
  }
  std::printf("the distance: %.9f m\n", contact::gjk(a, b).distance);
}
