// A box on a box, an apex on a diagonal, two tori that cross, and the same as soups: how many pairs
// each with each and two trees compare, how many meet, and the contacts, each once.
#include <array>
#include <contact/mesh_contacts.hpp>
#include <contact/mesh_shapes.hpp>
#include <cstddef>
#include <cstdio>

using namespace contact;

// [show]
void show(const char* name, const Mesh<double>& a, const Mesh<double>& b) {
  const MeshTree<double> tree_a(a), tree_b(b);
  PairCounts counts;
  const auto pairs = meeting_triangles(tree_a, tree_b, &counts);
  const auto contacts = mesh_contacts(tree_a, tree_b);
  std::array<int, 6> of_kind{};
  for (const auto& contact : contacts) ++of_kind[static_cast<std::size_t>(contact.kind())];
  std::printf("%-24s %9zu %7zu %6zu %5zu %7zu %5zu", name, a.triangles.size() * b.triangles.size(),
              counts.boxes, counts.triangles, pairs.size(),
              contacts_of_pairs(tree_a, tree_b).size(), contacts.size());
  const char* kinds[6] = {"p2p", "p2e", "p2f", "e2e", "e2f", "f2f"};
  for (std::size_t k = 0; k < 6; ++k) {
    if (of_kind[k] > 0) std::printf("  %s %d", kinds[k], of_kind[k]);
  }
  std::printf("\n");
}
// [/show]

int main() {
  std::printf("                         each with    two trees        pairs           once\n");
  std::printf("                           each   boxes  tested  meet  points  contacts\n");
  const Mesh<double> box = box_mesh({0, 0, 0}, {3, 4, 2});
  show("box on box", box, translated(box, {0, 0, 2}));
  show("shifted by a half", box, translated(box, {1.5, 0, 2}));
  show("along both sides", box, translated(box, {1, 1, 2}));
  show("pushed in", box, translated(box, {1, 1, 1.5}));
  show("edge on edge", box, translated(box, {3, 0, 2}));
  const Mesh<double> tip = octahedron_mesh(1);
  show("a tip on a face", box, translated(tip, {1, 1, 3}));
  show("a tip on a diagonal", box, translated(tip, {1.5, 2, 3}));
  const Mesh<double> torus = torus_mesh(1, 0.375, 160, 80);
  Mesh<double> upright = torus;
  for (auto& v : upright.vertices) v = Vector3<double>(v.x() + 0.7, -v.z(), v.y() + 0.1);
  show("two tori", torus, upright);
  show("two tori, linked", torus, translated(upright, {0.3, 0, 0}));
  show("boxes as soups", triangle_soup(box), triangle_soup(translated(box, {1, 1, 2})));
  show("tori as soups", triangle_soup(torus), triangle_soup(upright));
}
