// How little of a fine mesh a tree of boxes tests.
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <cstdio>

using namespace contact;

int main() {
  std::printf("%-18s %s\n", "triangles", "tested for a first hit");
  for (int subdivisions = 2; subdivisions <= 6; ++subdivisions) {
    const MeshTree<double> tree(ball_mesh(1.0, subdivisions));
    TreeCounts counts;
    constexpr int lines = 1000;
    for (int k = 0; k < lines; ++k) {
      const Vector3<double> start(3, (k % 40) / 20.0 - 1, (k / 40) / 12.5 - 1);
      tree.first(Ray<double>{start, {-1, 0.0625, 0.03125}}, &counts);
    }
    std::printf("%-18zu %.1f boxes, %.1f triangles\n", tree.mesh().triangles.size(),
                double(counts.boxes) / lines, double(counts.triangles) / lines);
  }
}
