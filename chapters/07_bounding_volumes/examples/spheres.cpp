// Five spheres around five sets of points: their radii, divided by the smallest one, and how many
// points the lecture's sphere misses if it is computed in float and nothing is rounded outwards.
#include <contact/enclosing_radius.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/measured_shapes.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/pairs_spared.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/vector.hpp>
#include <cstdio>
#include <vector>

namespace {

using namespace contact;
using Points = std::vector<Vector3<double>>;

Points scattered(int count) {
  Points points;
  for (const PlacedBody& body : scattered_bodies(count, 1, 2, 1)) {
    points.push_back(body.frame.origin);
  }
  return points;
}

// [show]
void show(const char* name, const Points& points) {
  const double smallest = smallest_sphere<double>(points).sphere.radius;
  std::printf("%-24s%9.3f%10.3f%12.3f%8.3f m", name, grown_sphere<double>(points).radius / smallest,
              centroid_sphere<double>(points).radius / smallest,
              box_centre_sphere<double>(points).radius / smallest, smallest);
  std::vector<Vector3<float>> rounded;
  for (const auto& p : points) rounded.push_back(p.cast<float>());
  const Sphere<float> as_given = sphere_grown_as_given<float>(rounded);
  int outside = 0;
  for (const auto& p : rounded) outside += contains(as_given, p) ? 0 : 1;
  std::printf("%9d of %zu\n", outside, points.size());
}
// [/show]

}  // namespace

int main() {
  std::printf("%-24s%9s%10s%12s%10s%17s\n", "radius / smallest", "lecture's", "centroid",
              "box centre", "smallest", "missed in float");
  show("a cube's corners", box_mesh({0, 0, 0}, {1, 1, 1}).vertices);
  show("a flat triangle", {{0, 0, 0}, {4, 0, 0}, {2, 0.5, 0}});
  Points lopsided(99, Vector3<double>(0, 0, 0));
  lopsided.push_back({1, 0, 0});
  show("99 in a point, 1 beside", lopsided);
  show("200 in a cube", scattered(200));
  show("the irregular mesh", measured_shapes().back().mesh.vertices);
}
