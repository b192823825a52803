// A house as it might come out of a modelling program, with three faults, and what the check says.
#include <contact/mesh_check.hpp>
#include <contact/mesh_shapes.hpp>
#include <cstdio>

namespace {

void report(const char* title, const contact::Mesh<double>& mesh) {
  const contact::MeshReport found = contact::check_mesh(mesh);
  std::printf("%s: closed %s, oriented %s, manifold %s, components %zu, V - E + F = %d\n", title,
              found.closed ? "yes" : "no", found.oriented ? "yes" : "no",
              found.manifold ? "yes" : "no", found.components.size(), found.euler_characteristic);
  for (const contact::MeshFault& fault : found.faults) {
    std::printf("  %s\n", text(fault, mesh).c_str());
  }
}

}  // namespace

int main() {
  using namespace contact;
  // [check]
  // The front of a house, as a prism.
  const Mesh<double> house = prism_mesh({{0, 0}, {4, 0}, {4, 3}, {2, 5}, {0, 3}}, 0, 6);
  report("house", house);
  std::printf("  volume %g m^3\n", mesh_volume_exactly(house).nearest());

  Mesh<double> damaged = house;
  damaged.triangles.erase(damaged.triangles.begin() + 4);                 // a hole in the wall
  std::swap(damaged.triangles[8][0], damaged.triangles[8][1]);            // one triangle reversed
  damaged = joined(damaged, inside_out(box_mesh({6, 0, 0}, {8, 1, 1})));  // a shed, inside out
  report("damaged", damaged);
  // [/check]

  // [soup]
  // A file of triangles with their own vertices is open everywhere, until equal ones are merged.
  const Mesh<double> soup = triangle_soup(house);
  std::printf("soup: %d boundary edges of %zu\n",
              check_mesh(soup).count(MeshFaultKind::boundary_edge), mesh_edges(soup).size());
  const Mesh<double> merged = merge_equal_vertices(soup);
  std::printf("merged: %d boundary edges of %zu, bounds a solid: %s\n",
              check_mesh(merged).count(MeshFaultKind::boundary_edge), mesh_edges(merged).size(),
              check_mesh(merged).bounds_solid() ? "yes" : "no");
  // [/soup]
}
