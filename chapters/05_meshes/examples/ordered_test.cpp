// The ordered test of two polyhedra on 1,000 pairs of bodies: which test decides, how many tests of
// each kind that takes, and what is missed without one of them.
#include <array>
#include <contact/mesh_shapes.hpp>
#include <contact/polyhedra_meet.hpp>
#include <cstdint>
#include <cstdio>
#include <vector>

using contact::Mesh;
using contact::PolyhedraOrder;
using contact::PolyhedraTest;

namespace {

/// splitmix64, so that every machine tests the same pairs: a number in [−1, 1).
double next_number(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

/// A star, a ring, a bar or a small ball.
Mesh<double> next_body(std::uint64_t& state) {
  static const std::vector<Mesh<double>> bodies{
      contact::star_mesh(0.5, 1, 0), contact::torus_mesh(0.75, 0.25, 12, 6),
      contact::box_mesh({-1.5, -0.125, -0.125}, {1.5, 0.125, 0.125}), contact::ball_mesh(0.125, 0)};
  const auto kind = static_cast<std::size_t>(2 * (next_number(state) + 1));
  return bodies[kind];
}

/// The body with its axes exchanged, moved by up to 1 m along each.
Mesh<double> moved(Mesh<double> body, std::uint64_t& state) {
  const double x = next_number(state);
  const double y = next_number(state);
  const double z = next_number(state);
  for (auto& v : body.vertices) v = contact::Vector3<double>(v.z() + x, v.x() + y, v.y() + z);
  return body;
}

}  // namespace

int main() {
  // [ordered-test]
  struct Tally {
    std::array<int, 6> decided{};
    contact::PolyhedraCounts counts;
    int missed = 0;
  };
  const std::array orders{PolyhedraOrder::lecture, PolyhedraOrder::edges_first,
                          PolyhedraOrder::vertices, PolyhedraOrder::edges};
  std::array<Tally, 4> tallies;
  std::uint64_t state = 5;
  for (int pair = 0; pair < 1000; ++pair) {
    const Mesh<double> a = next_body(state);
    const Mesh<double> second = next_body(state);
    const Mesh<double> b = moved(second, state);
    const bool meet = polyhedra_meet(a, b).meet;
    for (std::size_t i = 0; i < orders.size(); ++i) {
      const PolyhedraTest test = polyhedra_meet(a, b, orders[i]);
      ++tallies[i].decided[static_cast<std::size_t>(test.decided_by)];
      tallies[i].counts.boxes += test.counts.boxes;
      tallies[i].counts.crossings += test.counts.crossings;
      tallies[i].counts.edge_face += test.counts.edge_face;
      if (test.meet != meet) ++tallies[i].missed;
    }
  }
  // [/ordered-test]
  const auto row = [&tallies](const char* name, const auto& number) {
    constexpr std::array widths{10, 14, 16, 13};
    std::printf("%-24s", name);
    for (std::size_t i = 0; i < widths.size(); ++i)
      std::printf("%*ld", widths[i], static_cast<long>(number(tallies[i])));
    std::printf("\n");
  };
  std::printf("%-24s%10s%14s%16s%13s\n", "1,000 pairs", "lecture", "edges first", "only vertices",
              "only edges");
  row("decided by boxes", [](const Tally& t) { return t.decided[0]; });
  row("... by a vertex inside", [](const Tally& t) { return t.decided[1] + t.decided[2]; });
  row("... by edge and face", [](const Tally& t) { return t.decided[3] + t.decided[4]; });
  row("... by none: apart", [](const Tally& t) { return t.decided[5]; });
  row("pairs missed", [](const Tally& t) { return t.missed; });
  row("box tests", [](const Tally& t) { return t.counts.boxes; });
  row("crossing tests", [](const Tally& t) { return t.counts.crossings; });
  row("edge-face tests", [](const Tally& t) { return t.counts.edge_face; });
}
