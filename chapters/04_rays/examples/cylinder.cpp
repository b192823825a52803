// One cylinder, lines that meet its wall, its caps and its rim, and how many of 2,000 lines next to
// its wall two methods get wrong.
#include <cmath>
#include <contact/ray_cylinder.hpp>
#include <cstdio>

using contact::Cylinder;
using contact::Ray;
using contact::Vector3;

int main() {
  // [cylinder]
  const Cylinder<double> tin{{{0, 0, 0}, {0, 0, 2}}, 1};
  const auto show = [&tin](const char* name, const Ray<double>& ray) {
    const auto hit = contact::first_hit(ray, tin);
    if (!hit) {
      std::printf("%-22s no hit\n", name);
      return;
    }
    const char* face = hit->inside                            ? "inside"
                       : hit->face == contact::cylinder_wall  ? "wall"
                       : hit->face == contact::cylinder_start ? "cap at the start"
                                                              : "cap at the end";
    std::printf("%-22s t = %-4g %s\n", name, hit->t, face);
  };
  show("across", {{-3, 0, 1}, {1, 0, 0}});
  show("along the axis", {{0, 0, 5}, {0, 0, -1}});
  show("along the wall", {{1, 0, -1}, {0, 0, 1}});
  show("one ulp beside it", {{std::nextafter(1.0, 2.0), 0, -1}, {0, 0, 1}});
  show("in the plane of a cap", {{-3, 0, 2}, {1, 0, 0}});
  show("by the rim", {{-2, 0, 3}, {1, 0, -1}});
  show("from inside", {{0, 0.5, 1}, {0, 0, 1}});
  show("a direction of 0", {{0, 0.5, 1}, {0, 0, 0}});
  // [/cylinder]

  // Lines perpendicular to the axis that pass the wall closely, from further and further away.
  std::printf("\n%-10s %-20s %s\n", "distance", "textbook wrong", "book wrong");
  for (const double distance : {10.0, 1e3, 1e5, 1e7}) {
    int textbook = 0, book = 0;
    constexpr int count = 1000;
    for (int k = 1; k <= count; ++k) {
      const double step = std::ldexp(k, -45);  // exactly beside the wall
      for (const double y : {1 - step, 1 + step}) {
        const Ray<double> ray{{-distance, y, 1}, {1, 0, 0}};
        textbook += contact::passage_by_textbook(ray, tin).has_value() != (y <= 1) ? 1 : 0;
        book += contact::hits_cylinder(ray, tin) != (y <= 1) ? 1 : 0;
      }
    }
    std::printf("%-10g %4d of %-12d %d\n", distance, textbook, 2 * count, book);
  }
}
