// Convex pieces of a solid: each is convex, their interiors are disjoint, and together they are the
// solid, all decided exactly.
#include <05_meshes/solid_truth.hpp>
#include <contact/convex_pieces.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/quaternion.hpp>
#include <contact/sine_cosine.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using contact::ConvexPiece;
using contact::Exact;
using contact::ExactFraction;
using contact::Mesh;
using contact::Polygon;
using contact::Vector2;
using contact::Vector3;
using generators::Random;
using solid_truth::block;
using solid_truth::of_cubes;
using Cubes = std::set<std::array<int, 3>>;

// ---------------------------------------------------------------- solids

Cubes without(Cubes from, const Cubes& removed) {
  for (const auto& cube : removed) from.erase(cube);
  return from;
}
Cubes with(Cubes to, const Cubes& added) {
  to.insert(added.begin(), added.end());
  return to;
}
Mesh<double> prism_over(const std::vector<Vector2<double>>& outline) {
  return contact::prism_mesh(Polygon<double>{outline}, 0, 1);
}
/// Rotated and moved, so that no coordinate is whole and coplanar triangles are no longer so.
Mesh<double> rotated(const Mesh<double>& mesh) {
  return contact::transformed(
      mesh, contact::CoordinateFrame<double>{
                {0.1, 0.2, 0.3},
                contact::matrix_of(contact::exponential<double>(Vector3<double>(0.3, 0.7, -0.4)))});
}
/// By a matrix of determinant 8.
Mesh<double> sheared(Mesh<double> mesh) {
  for (Vector3<double>& v : mesh.vertices) {
    v = Vector3<double>(v.x() + 2 * v.y() - v.z(), v.y() + 3 * v.z(), v.z() + v.x());
  }
  return mesh;
}

/// A polygon's fan of triangles, and the same from behind: closed, without volume.
Mesh<double> sheet(const std::vector<Vector3<double>>& outline) {
  Mesh<double> mesh{outline, {}};
  for (int i = 1; i + 1 < int(outline.size()); ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({0, i + 1, i});
  }
  return mesh;
}

struct Solid {
  std::string name;
  Mesh<double> mesh;
  int pieces = 0;  ///< 0: any number
};

std::vector<Solid> solids() {
  const Cubes five = block({0, 0, 0}, {5, 5, 3});
  const Cubes dent = without(five, block({1, 1, 1}, {4, 4, 3}));
  const Cubes tunnel = without(five, block({1, 1, 0}, {4, 4, 3}));
  const Cubes bars = with(block({0, 2, 2}, {5, 3, 3}), block({2, 0, 2}, {3, 5, 3}));
  const Cubes three_bars = with(bars, block({2, 2, 0}, {3, 3, 5}));
  const Mesh<double> ell = prism_over({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {4, 4, 4});
  const auto cavity = [](int low, int high) {
    const auto all = [](int x) { return Vector3<double>(x, x, x); };
    return contact::inside_out(contact::box_mesh(all(low), all(high)));
  };
  return {
      {"box", box, 1},
      {"octahedron", contact::octahedron_mesh(1), 1},
      {"ball", contact::ball_mesh(1.7, 1), 1},
      {"L", ell, 2},
      {"U", prism_over({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), 3},
      {"star", contact::star_mesh(1, 2, 0), 0},
      {"dents", contact::star_mesh(1, 0.5, 0), 0},
      {"dented box", of_cubes(dent), 5},
      {"tunnel", of_cubes(tunnel), 4},
      {"crossed bars", of_cubes(bars), 3},
      {"three bars", of_cubes(three_bars), 0},
      {"torus", contact::torus_mesh(2, 0.5, 5, 4), 0},
      {"cavity", contact::joined(box, cavity(1, 3)), 6},
      {"shells in shells",
       contact::joined(contact::joined(box, cavity(1, 3)),
                       contact::transformed(contact::octahedron_mesh(0.5),
                                            contact::CoordinateFrame<double>{{2, 2, 2}})),
       0},
      {"touching at a face", contact::joined(box, contact::box_mesh({1, 1, 4}, {3, 3, 6})), 2},
      {"glued", contact::joined(box, contact::box_mesh({0, 0, 4}, {4, 4, 5})), 2},
      {"touching at an edge", of_cubes({{0, 0, 0}, {1, 1, 0}}), 2},
      {"touching at a vertex", of_cubes({{0, 0, 0}, {1, 1, 1}}), 2},
      {"two apart", contact::joined(box, contact::box_mesh({9, 0, 0}, {10, 4, 4})), 2},
      {"L, rotated", rotated(ell), 0},
      {"tunnel, sheared", sheared(of_cubes(tunnel)), 4},
      {"a thin wall",
       contact::joined(contact::box_mesh({0, 0, 0}, {1, 1, 1}),
                       contact::inside_out(contact::box_mesh(
                           {0x1p-50, 0x1p-50, 0x1p-50}, {1 - 0x1p-50, 1 - 0x1p-50, 1 - 0x1p-50}))),
       6},
      {"huge",
       rotated(contact::joined(contact::box_mesh({-4e150, -4e150, -4e150}, {4e150, 4e150, 4e150}),
                               contact::inside_out(contact::octahedron_mesh(1e150)))),
       0},
      {"tiny", contact::star_mesh(1e-150, 2e-150, 0), 0},
      {"flat", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, 0},
      {"flat, across its box", sheet({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}), 0},
      {"flat tetrahedron, across its box",
       {{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {2, 2, 4}}, {{0, 1, 2}, {3, 2, 1}, {0, 3, 1}, {0, 2, 3}}},
       0},
      {"bent sheet", sheet({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {0, 1, 3}}), 0},
      {"box and a sheet beside it", contact::joined(box, sheet({{4, 4, 4}, {5, 4, 5}, {4, 5, 5}})),
       0},
      {"sheet in a box", contact::joined(box, sheet({{1, 1, 1}, {2, 1, 2}, {1, 2, 2}})), 0},
      {"sheet across a box",
       contact::joined(box, sheet({{0, 0, 0}, {4, 0, 4}, {4, 4, 4}, {0, 4, 0}})), 0},
      {"sheet in a face of a box", contact::joined(box, sheet({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}})),
       1},
      {"nothing", {}, 0},
  };
}

// ---------------------------------------------------------------- checks

/// The side of a point, whose coordinates are doubles, of a piece: +1 inside, 0 on its surface, −1
/// outside.
int side_of(const ConvexPiece& piece, const Vector3<double>& p) {
  contact::HomogeneousPoint point;
  for (int k = 0; k < 3; ++k) point.scaled[k] = Exact(p[k]);
  int side = 1;
  for (const contact::ExactPlane& plane : piece.planes) {
    side = std::min(side, -contact::side_of_plane(plane, point));
  }
  return side;
}

void require_convex(const ConvexPiece& piece) {
  REQUIRE(piece.planes.size() == piece.facets.size());
  REQUIRE(piece.planes.size() >= 4);
  REQUIRE(piece.volume().sign() > 0);
  std::map<std::array<int, 2>, int> edges;
  for (std::size_t i = 0; i < piece.facets.size(); ++i) {
    const std::vector<int>& facet = piece.facets[i];
    REQUIRE(facet.size() >= 3);
    std::set<int> on;
    for (std::size_t v = 0; v < piece.vertices.size(); ++v) {
      const int side = contact::side_of_plane(piece.planes[i], piece.vertices[v]);
      REQUIRE(side <= 0);
      if (side == 0) on.insert(int(v));
    }
    // The facet's vertices are exactly those on its plane.
    REQUIRE(on == std::set<int>(facet.begin(), facet.end()));
    REQUIRE(on.size() == facet.size());
    for (std::size_t k = 0; k < facet.size(); ++k) {
      ++edges[{facet[k], facet[(k + 1) % facet.size()]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    REQUIRE(count == 1);
    REQUIRE(edges.count({edge[1], edge[0]}) == 1);
  }
  REQUIRE(int(piece.vertices.size()) - int(edges.size() / 2) + int(piece.facets.size()) == 2);
}

/// The piece that has a point inside it is the only one, and there is one, or a piece with the
/// point on its surface, if and only if the point is in the solid.
void require_partition(const std::vector<ConvexPiece>& pieces, const Mesh<double>& mesh,
                       Random& random, int points) {
  if (mesh.vertices.empty()) return;
  Vector3<double> low = mesh.vertices[0], high = low;
  for (const auto& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  for (int i = 0; i < points; ++i) {
    Vector3<double> p;
    for (int k = 0; k < 3; ++k) {
      const double t = i % 2 == 0 ? random.uniform() : random.integer(0, 8) / 8.0;
      p[k] = low[k] + (high[k] - low[k]) * t;
    }
    int inside = 0, on = 0;
    for (const ConvexPiece& piece : pieces) {
      const int side = side_of(piece, p);
      inside += side > 0 ? 1 : 0;
      on += side == 0 ? 1 : 0;
    }
    REQUIRE(inside + (on > 0 ? 1 : 0) <= 1);
    const auto winding = solid_truth::winding(oracle::exact(p), mesh, random);
    if (winding) REQUIRE(inside + (on > 0 ? 1 : 0) == *winding);
  }
}

ExactFraction volume_by_mesh(const Mesh<double>& mesh) {
  return contact::mesh_volume_exactly(mesh);
}

TEST_CASE("named solids: convex pieces, no volume lost, no point in two") {
  Random random(541);
  for (const Solid& solid : solids()) {
    INFO(solid.name);
    const std::vector<ConvexPiece> pieces = contact::convex_pieces(solid.mesh);
    INFO(pieces.size() << " pieces");
    if (solid.pieces > 0) CHECK(int(pieces.size()) == solid.pieces);
    for (const ConvexPiece& piece : pieces) require_convex(piece);
    CHECK(contact::volume_of_pieces(pieces) == volume_by_mesh(solid.mesh));
    require_partition(pieces, solid.mesh, random, generators::tried(60));
  }
}

TEST_CASE("random sets of cubes: the volume is their number") {
  Random random(542);
  for (int i = 0; i < generators::tried(100); ++i) {
    Cubes cubes;
    const double share = random.uniform(0.2, 0.9);
    for (const auto& cube : block({0, 0, 0}, {3, 3, 3})) {
      if (random.chance(share)) cubes.insert(cube);
    }
    Mesh<double> mesh = of_cubes(cubes);
    if (i % 2 == 1) mesh = sheared(mesh);
    const std::vector<ConvexPiece> pieces = contact::convex_pieces(mesh);
    for (const ConvexPiece& piece : pieces) require_convex(piece);
    // count.
    const ExactFraction volume = contact::volume_of_pieces(pieces);
    REQUIRE(volume == volume_by_mesh(mesh));
    REQUIRE(volume == ExactFraction(int(cubes.size()) * (i % 2 == 1 ? 8 : 1)));
    require_partition(pieces, mesh, random, 10);
  }
}

TEST_CASE("sheets without volume, wherever they are, change no volume") {
  Random random(544);
  for (int i = 0; i < generators::tried(60); ++i) {
    Cubes cubes;
    const double share = i % 3 == 0 ? 0 : random.uniform(0.2, 0.9);
    for (const auto& cube : block({0, 0, 0}, {2, 2, 2})) {
      if (random.chance(share)) cubes.insert(cube);
    }
    Mesh<double> mesh = of_cubes(cubes);
    const int sheets = random.integer(1, 3);
    for (int k = 0; k < sheets; ++k) {
      std::vector<Vector3<double>> outline(std::size_t(random.integer(3, 4)));
      for (Vector3<double>& v : outline) {
        for (int axis = 0; axis < 3; ++axis) v[axis] = random.integer(0, 4) / 2.0;
      }
      mesh = contact::joined(mesh, sheet(outline));
    }
    const std::vector<ConvexPiece> pieces = contact::convex_pieces(mesh);
    for (const ConvexPiece& piece : pieces) require_convex(piece);
    REQUIRE(contact::volume_of_pieces(pieces) == ExactFraction(int(cubes.size())));
    require_partition(pieces, mesh, random, 10);
  }
}

TEST_CASE("random prisms over star-shaped polygons, on a grid and rotated") {
  Random random(543);
  for (int i = 0; i < generators::tried(60); ++i) {
    const int n = random.integer(4, 9);
    std::vector<Vector2<double>> outline;
    for (int k = 0; k < n; ++k) {
      const auto turn = contact::sine_cosine(6.283185307179586 * k / n);
      const double radius = random.uniform(1, 8);
      const auto snapped = [&](double x) { return i % 2 == 0 ? std::nearbyint(8 * x) : x; };
      outline.push_back({snapped(radius * turn.cosine), snapped(radius * turn.sine)});
    }
    Mesh<double> mesh = prism_over(outline);
    if (i % 4 == 3) mesh = rotated(mesh);
    const std::vector<ConvexPiece> pieces = contact::convex_pieces(mesh);
    for (const ConvexPiece& piece : pieces) require_convex(piece);
    REQUIRE(contact::volume_of_pieces(pieces) == volume_by_mesh(mesh));
    require_partition(pieces, mesh, random, 10);
  }
}

TEST_CASE("notches are the edges at which the solid is concave") {
  CHECK(contact::notches(contact::box_mesh({0, 0, 0}, {1, 2, 3})).empty());
  CHECK(contact::notches(contact::ball_mesh(1, 2)).empty());
  const Mesh<double> ell = prism_over({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const auto found = contact::notches(ell);
  REQUIRE(found.size() == 1);
  for (const int vertex : found[0].vertices) {
    const Vector3<double> v = ell.vertices[std::size_t(vertex)];
    CHECK(Vector2<double>(v.x(), v.y()) == Vector2<double>(1, 1));
  }
  CHECK(contact::notches(contact::inside_out(contact::box_mesh({0, 0, 0}, {1, 1, 1}))).size() ==
        12);
  CHECK(contact::notches(contact::star_mesh(1, 2, 0)).size() == 30);
  // One ulp decides.
  Mesh<double> roof{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}};
  CHECK(contact::notches(roof).empty());
  roof.vertices[3].z() = std::numeric_limits<double>::denorm_min();
  CHECK(contact::notches(roof).size() == 1);
  roof.vertices[3].z() = -roof.vertices[3].z();
  CHECK(contact::notches(roof).empty());
}

TEST_CASE("pieces in double are closed meshes with nearly the same volume") {
  for (const Mesh<double>& mesh :
       {contact::star_mesh(1, 2, 0), contact::torus_mesh(2, 0.5, 5, 4)}) {
    double sum = 0;
    for (const ConvexPiece& piece : contact::convex_pieces(mesh)) {
      const Mesh<double> rounded = contact::rounded_piece(piece);
      const auto report = contact::check_mesh(rounded);
      CHECK(report.closed);
      CHECK(report.oriented);
      sum += contact::mesh_volume_exactly(rounded).nearest();
    }
    CHECK(std::abs(sum - contact::mesh_volume_exactly(mesh).nearest()) < 1e-13);
  }
}

TEST_CASE("a mesh that crosses itself loses volume, which the sum shows") {
  const Mesh<double> two = contact::joined(contact::box_mesh({0, 0, 0}, {2, 2, 2}),
                                           contact::box_mesh({1, 1, 1}, {3, 3, 3}));
  CHECK_FALSE(contact::volume_of_pieces(contact::convex_pieces(two)) ==
              contact::mesh_volume_exactly(two));
}

TEST_CASE("meshes that are not closed or not finite are refused by name") {
  Mesh<double> mesh = contact::box_mesh({0, 0, 0}, {1, 1, 1});
  Mesh<double> open = mesh;
  open.triangles.pop_back();
  CHECK_THROWS_AS(contact::convex_pieces(open), std::invalid_argument);
  Mesh<double> flipped = mesh;
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  CHECK_THROWS_AS(contact::convex_pieces(flipped), std::invalid_argument);
  Mesh<double> missing = mesh;
  missing.triangles[0][0] = 8;
  CHECK_THROWS_AS(contact::convex_pieces(missing), std::invalid_argument);
  mesh.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(contact::convex_pieces(mesh), std::invalid_argument);
}

}  // namespace
