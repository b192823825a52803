// A scene of one body of each kind: what a ray meets first, and all that it meets.
#include <contact/first_in_scene.hpp>
#include <cstdio>
#include <vector>

using contact::Primitive;
using contact::Ray;

int main() {
  using namespace contact;
  // [scene]
  const std::vector<Primitive<double>> scene{
      Triangle<double>{{18, -1, -1}, {18, 2, -1}, {18, -1, 2}},
      Cone<double>{{15, 0, 0}, {16, 0, 0}, 1},
      Capsule<double>{{{13, 0, -1}, {13, 0, 1}}, 1},
      Cylinder<double>{{{10, 0, -1}, {10, 0, 1}}, 1},
      OrientedBox<double>{{7, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}},
      Aabb<double>{{3, -1, -1}, {4, 1, 1}},
      Sphere<double>{{0, 0, 0}, 1},
      Sphere<double>{{0, 0, 0}, 1},  // the same again: the lower index wins
  };
  const char* const names[] = {"triangle",     "cone", "capsule", "cylinder",
                               "oriented box", "box",  "ball",    "ball"};
  const Ray<double> ray{{-4, 0, 0}, {2, 0, 0}};
  const auto first = first_in_scene<double>(ray, scene);
  std::printf("first: body %zu, the %s, at t = %g\n", first->index, names[first->index],
              first->hit.t);
  for (const auto& [index, hit] : all_in_scene<double>(ray, scene)) {
    std::printf("  t = %-5g x = %-4g body %zu, %s\n", hit.t, hit.point.x(), index, names[index]);
  }
  // [/scene]
  const auto inside = first_in_scene<double>(Ray<double>{{10, 0, 0}, {1, 0, 0}}, scene);
  std::printf("from inside body %zu: t = %g, inside: %s\n", inside->index, inside->hit.t,
              inside->hit.inside ? "yes" : "no");
}
