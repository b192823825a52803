// Scenes of 100 bodies in random positions and orientations, of one shape or of all five: how many
// of the 4,950 pairs may meet by each kind of bounding volume, and how many bodies do.
#include <contact/measured_shapes.hpp>
#include <contact/pairs_spared.hpp>
#include <contact/shapes.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/volume_kinds.hpp>
#include <cstddef>
#include <cstdio>
#include <span>
#include <vector>

namespace {

using namespace contact;

// [scene]
/// A scene in a cube whose edge is seven mean radii, so that about a pair in 15 has spheres that
/// meet.
SceneCounts scene_of(std::span<const MeasuredShape> shapes) {
  double radius = 0;
  for (const MeasuredShape& shape : shapes) {
    radius += smallest_sphere<double>(shape.mesh.vertices).sphere.radius;
  }
  radius /= static_cast<double>(shapes.size());
  const int kinds_of_bodies = static_cast<int>(shapes.size());
  return count_pairs(shapes, scattered_bodies(100, kinds_of_bodies, 7 * radius, 1));
}
// [/scene]

template <class Number>
void print_row(const char* name, const std::vector<SceneCounts>& scenes, const Number& number) {
  std::printf("%-22s", name);
  for (const SceneCounts& scene : scenes) std::printf("%7d", number(scene));
  std::printf("\n");
}

}  // namespace

int main() {
  // The grown spheres of these shapes are like the smallest ones.
  std::vector<VolumeKind> kinds(all_volume_kinds.begin(), all_volume_kinds.end());
  std::erase(kinds, VolumeKind::grown_sphere);
  const std::vector<MeasuredShape> shapes = measured_shapes();
  std::vector<SceneCounts> scenes;
  std::printf("pairs that may meet   ");
  for (const MeasuredShape& shape : shapes) {
    scenes.push_back(scene_of({&shape, 1}));
    std::printf("%7s", shape.name);
  }
  scenes.push_back(scene_of(shapes));
  std::printf("%7s\n", "all");
  print_row("without a volume", scenes, [](const SceneCounts& s) { return s.pairs; });
  for (const VolumeKind kind : kinds) {
    print_row(name_of(kind), scenes,
              [kind](const SceneCounts& s) { return s.may_meet[static_cast<std::size_t>(kind)]; });
  }
  print_row("bodies that meet", scenes, [](const SceneCounts& s) { return s.meet; });

  std::printf("\nof 100 pairs whose volumes meet, the bodies of so many do not\n");
  for (const VolumeKind kind : kinds) {
    print_row(name_of(kind), scenes, [kind](const SceneCounts& s) {
      const int all = s.may_meet[static_cast<std::size_t>(kind)];
      return (200 * s.false_alarms(kind) + all) / (2 * all);  // rounded
    });
  }
  int missed = 0;
  for (const SceneCounts& scene : scenes) {
    for (const int of_kind : scene.missed) missed += of_kind;
  }
  std::printf("\npairs that meet and that a kind called apart: %d\n", missed);
}
