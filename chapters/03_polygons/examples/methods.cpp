// Four points and one polygon, by all methods of the chapter: deep inside, at the level of a
// vertex, on an edge, and an ulp from an edge.
#include <cmath>
#include <contact/point_in_polygon.hpp>
#include <cstdio>

using contact::Polygon;
using contact::Vector2;
using contact::Where;

const char* text(Where where) {
  return where == Where::inside ? "inside" : where == Where::on ? "on" : "outside";
}

int main() {
  const Polygon<double> polygon{{0, 0}, {0.7, 0.1}, {0.9, 0.9}, {0.4, 0.3}, {0.1, 0.8}};
  // As stored, the first is exactly on the first edge.
  const Vector2<double> middle(0.35, 0.05), below(0.35, std::nextafter(0.05, 0.0));
  std::printf("%-20s %-9s %-9s %-9s %s\n", "", "deep", "level", "on edge", "ulp below");
  const auto row = [&](const char* name, const auto& method) {
    std::printf("%-20s %-9s %-9s %-9s %s\n", name, text(method({0.3, 0.2})),
                text(method({0.3, 0.1})), text(method(middle)), text(method(below)));
  };
  row("angle sum",
      [&](const Vector2<double>& p) { return contact::where_by_angle_sum(polygon, p); });
  row("quadrants",
      [&](const Vector2<double>& p) { return contact::where_by_quadrants(polygon, p); });
  row("crossings with ends",
      [&](const Vector2<double>& p) { return contact::where_by_crossings_with_ends(polygon, p); });
  row("crossings",
      [&](const Vector2<double>& p) { return contact::where_by_crossings(polygon, p); });
  row("scanline", [&](const Vector2<double>& p) { return contact::where_by_scanline(polygon, p); });
  row("exact winding", [&](const Vector2<double>& p) { return contact::where(polygon, p); });
}
