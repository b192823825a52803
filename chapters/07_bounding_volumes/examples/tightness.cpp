// The volume of each kind of bounding volume, divided by that of the hull, for five bodies. Boxes
// and slabs along the axes of the world depend on the orientation: the mean of 64 random ones.
#include <algorithm>
#include <contact/measured_shapes.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/pairs_spared.hpp>
#include <contact/volume_kinds.hpp>
#include <cstdio>
#include <vector>

namespace {

using namespace contact;

/// Ratios of all orientations.
struct Tightness {
  double mean = 0, smallest = 0, largest = 0;
};

// [tightness]
Tightness tightness_of(VolumeKind kind, const MeasuredShape& shape) {
  const double hull = volume(bounding_volume(VolumeKind::hull, shape.mesh.vertices));
  const BoundingVolume in_frame = bounding_volume(kind, shape.mesh.vertices);
  std::vector<double> ratios;
  for (const PlacedBody& body : scattered_bodies(64, 1, 1, 1)) {
    ratios.push_back(volume(carried(in_frame, body.frame)) / hull);
  }
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  Tightness result{0, *low, *high};
  for (const double ratio : ratios) result.mean += ratio / static_cast<double>(ratios.size());
  return result;
}
// [/tightness]

}  // namespace

int main() {
  const std::vector<MeasuredShape> shapes = measured_shapes();
  std::printf("volume / hull   ");
  for (const MeasuredShape& shape : shapes) std::printf("%8s", shape.name);
  std::printf("\n");
  for (const VolumeKind kind : all_volume_kinds) {
    if (kind == VolumeKind::hull) continue;
    std::printf("%-16s", name_of(kind));
    for (const MeasuredShape& shape : shapes) {
      std::printf("%8.2f", tightness_of(kind, shape).mean);
    }
    std::printf("\n");
  }
  std::printf("%-16s", "the body");
  for (const MeasuredShape& shape : shapes) {
    const double hull = volume(bounding_volume(VolumeKind::hull, shape.mesh.vertices));
    std::printf("%8.2f", mesh_volume(shape.mesh).value / hull);
  }
  std::printf("\n\nas it turns     ");
  for (const MeasuredShape& shape : shapes) std::printf("%14s", shape.name);
  std::printf("\n");
  for (const VolumeKind kind :
       {VolumeKind::aabb, VolumeKind::dop_14, VolumeKind::dop_18, VolumeKind::dop_26}) {
    std::printf("%-16s", name_of(kind));
    for (const MeasuredShape& shape : shapes) {
      const Tightness found = tightness_of(kind, shape);
      std::printf("%6.2f – %5.2f", found.smallest, found.largest);
    }
    std::printf("\n");
  }
}
