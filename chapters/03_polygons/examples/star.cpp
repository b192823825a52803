// A five-pointed star and a frame with a hole: winding numbers, and what the two rules make of
// them.
#include <contact/point_in_polygon.hpp>
#include <cstdio>
#include <optional>
#include <string>

using contact::Polygon;
using contact::PolygonWithHoles;
using contact::Rule;
using contact::Vector2;
using contact::Where;

const char* text(Where where) {
  return where == Where::inside ? "inside" : where == Where::on ? "on" : "outside";
}

int main() {
  const Polygon<double> star{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}};
  std::printf("%-22s %8s  %-9s %s\n", "star", "winding", "even-odd", "non-zero");
  const auto ask = [&](const char* name, const Vector2<double>& p) {
    const std::optional<int> winding = contact::winding_number(star, p);
    std::printf("%-22s %8s  %-9s %s\n", name, winding ? std::to_string(*winding).c_str() : "-",
                text(contact::where(star, p, Rule::even_odd)),
                text(contact::where(star, p, Rule::non_zero)));
  };
  ask("the middle, (0, 0)", {0, 0});
  ask("a point, (0, 2)", {0, 2});
  ask("an edge, (0, 1)", {0, 1});
  ask("beside it, (2, 0)", {2, 0});

  const Polygon<double> outer{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Polygon<double> hole{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
  const PolygonWithHoles<double> frame{outer, {hole}};
  std::printf("\nframe with a hole: (2, 2) %s, (1, 2) %s, (0.5, 2) %s\n",
              text(contact::where(frame, {2, 2})), text(contact::where(frame, {1, 2})),
              text(contact::where(frame, {0.5, 2})));
}
