// A box, and lines through its faces, edges, vertices and along them: the first hit, any hit, all
// hits, and what each triangle says by itself.
#include <contact/mesh_hits.hpp>
#include <contact/mesh_shapes.hpp>
#include <cstdio>

using namespace contact;

int main() {
  // [first-any-all]
  const Mesh<double> box = box_mesh({0, 0, 0}, {2, 2, 2});
  const auto show = [&box](const char* name, const auto& line) {
    std::printf("%-26s any: %-5sall:", name, any_mesh_hit(line, box) ? "yes," : "no,");
    const auto all = all_mesh_hits(line, box);
    for (const MeshHit<double>& hit : all) {
      const char* feature = hit.feature == MeshFeature::face   ? "face"
                            : hit.feature == MeshFeature::edge ? "edge"
                                                               : "vertex";
      std::printf(" t = %g %s,", hit.hit.t, feature);
    }
    const auto alone = all_hits_by_triangles(line, box, [](const auto& l, const auto& triangle) {
      return intersect_moller_trumbore(l, triangle);
    });
    std::printf("%s by triangles: %zu\n", all.empty() ? " none," : "", alone.size());
  };
  show("through two faces", Ray<double>{{0.5, 0.75, 5}, {0, 0, -1}});
  show("through a diagonal", Ray<double>{{1, 1, 5}, {0, 0, -1}});
  show("through two edges", Ray<double>{{-1, -1, 1}, {1, 1, 0}});
  show("through two vertices", Ray<double>{{-1, -1, -1}, {1, 1, 1}});
  show("touches an edge", Ray<double>{{-1, 1, 1}, {1, -1, 0}});
  show("in the plane of a face", Ray<double>{{-1, 0.5, 2}, {1, 0, 0}});
  show("a segment that ends there", Segment<double>{{0.5, 0.75, 5}, {0.5, 0.75, 2}});
  show("a segment inside", Segment<double>{{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}});
  // [/first-any-all]
}
