// Solids cut into convex pieces: how many notches and pieces they have, and that no volume is lost.
#include <contact/convex_pieces.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_shapes.hpp>
#include <cstdio>
#include <vector>

using namespace contact;

int main() {
  const auto prism = [](const std::vector<Vector2<double>>& outline) {
    return prism_mesh(Polygon<double>{outline}, 0, 1);
  };
  const Mesh<double> box = box_mesh({0, 0, 0}, {4, 4, 4});
  const auto cavity = inside_out(box_mesh({1, 1, 1}, {3, 3, 3}));

  // [pieces]
  const auto show = [](const char* name, const Mesh<double>& mesh) {
    const std::vector<ConvexPiece> pieces = convex_pieces(mesh);
    const ExactFraction lost = mesh_volume_exactly(mesh) - volume_of_pieces(pieces);
    std::printf("%-16s %3d triangles %3d notches %3d pieces, %g m^3, lost: %s\n", name,
                static_cast<int>(mesh.triangles.size()), static_cast<int>(notches(mesh).size()),
                static_cast<int>(pieces.size()), mesh_volume_exactly(mesh).nearest(),
                lost.sign() == 0 ? "exactly 0" : "some");
  };
  // [/pieces]
  show("box", box);
  show("U", prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  show("cavity", joined(box, cavity));
  show("star", star_mesh(1, 2, 0));
  show("torus", torus_mesh(2, 0.5, 6, 5));
  show("crossing itself", joined(box, box_mesh({2, 2, 2}, {6, 6, 6})));
}
