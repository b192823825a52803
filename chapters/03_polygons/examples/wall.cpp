// A bullet and a wall with a notch: the movement vector against a polygon in space, at three
// scales.
#include <contact/polygon_in_space.hpp>
#include <cstdio>

using contact::Segment;
using contact::SpacePolygon;
using contact::Vector3;
using contact::Where;

int main() {
  const SpacePolygon<double> wall{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {1, 0.5, 1}, {0, 2, 1}};
  const auto text = [](const auto& hit) {
    return !hit ? "no hit" : hit->where == Where::on ? "on an edge" : "inside";
  };
  std::printf("%-8s %-12s %-12s %s\n", "scale", "at", "dropping", "exact");
  for (const double scale : {1.0, 1e-150, 1e150}) {
    SpacePolygon<double> scaled;
    for (const Vector3<double>& v : wall) scaled.push_back(scale * v);
    for (const double y : {0.25, 0.5, 1.0}) {
      const Segment<double> path{scale * Vector3<double>(1, y, 0),
                                 scale * Vector3<double>(1, y, 4)};
      std::printf("%-8g (1, %-4g)    %-12s %s\n", scale, y,
                  text(contact::intersect_polygon_by_dropping(path, scaled)),
                  text(contact::intersect_polygon(path, scaled)));
    }
  }
}
