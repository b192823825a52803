// A sloping grid of tenths, which looks flat and is not flat as stored.
#include <contact/convex_hull.hpp>
#include <contact/gift_wrapping.hpp>
#include <cstdio>
#include <vector>

int main() {
  std::vector<contact::Vector3<double>> points;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double x = 0.1 * i, y = 0.1 * j;
      points.push_back({x, y, 0.3 * x + 0.7 * y});
    }
  }
  const auto report = [](const char* method, const contact::Hull& hull) {
    std::printf("%-25s %2zu vertices, %2d faces, vertices - edges + faces = %d%s\n", method,
                hull.vertices.size(), hull.face_count(),
                static_cast<int>(hull.vertices.size()) - hull.edge_count() + hull.face_count(),
                hull.closed ? "" : ", does not close");
  };
  using contact::RoundedSides;
  report("wrapping, double", contact::gift_wrap_with<RoundedSides<double>>(points));
  report("incremental, float", contact::convex_hull_with<RoundedSides<float>>(points));
  report("incremental, double", contact::convex_hull_with<RoundedSides<double>>(points));
  report("incremental, epsilon 1e-9",
         contact::convex_hull_with<RoundedSides<double>>(points, 1e-9));
  report("wrapping, exact", contact::gift_wrap(points));
  report("incremental, exact", contact::convex_hull(points));
}
