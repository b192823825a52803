// A ball rests 1 m from a wall; another of the same mass approaches from 2 m at 1 m/s. The times of
// the 3rd, 10th and 30th collision, and whether there are infinitely many.
#include <contact/two_balls_wall.hpp>
#include <cstdio>

int main() {
  for (const double e : {1.0, 0.5, 0.2, 0.17, 0.1}) {
    std::printf("e = %.2f:", e);
    const auto start = contact::two_balls_and_wall<double>({1, 0}, {1, -1}, 1.0, 1.0, e);
    for (const int limit : {3, 10, 30}) {
      double left = 1e6;
      const auto end = contact::two_balls_by_events(start, left, limit);
      if (left == 0) {
        std::printf("  %d in all", static_cast<int>(end.hits));
        break;
      }
      std::printf("  %d by %.6f s", limit, 1e6 - left);
    }
    std::printf("  -> %s\n", contact::collapses(1.0, 1.0, e) ? "infinitely many" : "finitely many");
  }
}
