// The mesh check against brute force, on meshes that are damaged at random.
#include <05_meshes/mesh_check_truth.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_shapes.hpp>
#include <limits>
#include <support/generators.hpp>

namespace {

using contact::check_mesh;
using contact::Mesh;
using contact::MeshFault;
using contact::MeshFaultKind;
using contact::MeshReport;
using contact::Vector3;
using generators::Random;
using mesh_check_truth::Fault;
using mesh_check_truth::Truth;
using oracle::Rational;

constexpr int kinds = static_cast<int>(MeshFaultKind::component_no_volume) + 1;

const char* name(MeshFaultKind kind) {
  static constexpr const char* names[kinds] = {
      "index_out_of_range", "vertex_not_finite", "repeated_index", "no_area",
      "same_triangle",      "boundary_edge",     "crowded_edge",   "same_direction",
      "several_fans",       "unused_vertex",     "equal_vertices", "component_inside_out",
      "component_no_volume"};
  return names[static_cast<int>(kind)];
}

Mesh<double> some_mesh(Random& random) {
  const auto whole = [&random](int low, int high) { return double(random.integer(low, high)); };
  switch (random.integer(0, 5)) {
    case 0: {
      const double x = whole(0, 4);
      const double y = whole(0, 4);
      const double z = whole(0, 4);
      return contact::box_mesh({x, y, z}, {x + 3, y + 2, z + 1});
    }
    case 1:
      return contact::octahedron_mesh(whole(1, 4));
    case 2:
      return contact::ball_mesh(2, 0);
    case 3:
      return contact::torus_mesh(3, 1, random.integer(3, 5), random.integer(3, 4));
    case 4:
      return contact::prism_mesh({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}, {0, 2}}, 0, 2);
    default:
      return contact::inside_out(contact::box_mesh({1, 1, 1}, {2, 2, 2}));
  }
}

void damage(Random& random, Mesh<double>& mesh) {
  if (mesh.triangles.empty() || mesh.vertices.empty()) return;
  const auto any_vertex = [&] {
    return random.integer(0, static_cast<int>(mesh.vertices.size()) - 1);
  };
  const auto i =
      static_cast<std::size_t>(random.integer(0, static_cast<int>(mesh.triangles.size()) - 1));
  const auto k = static_cast<std::size_t>(random.integer(0, 2));
  const int v = any_vertex();
  const int w = any_vertex();
  auto& t = mesh.triangles[i];
  switch (random.integer(0, 12)) {
    case 0:
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    case 1:
      std::swap(t[0], t[1]);
      break;
    case 2:
      mesh.triangles.push_back({t[1], t[2], t[0]});
      break;
    case 3:
      mesh.triangles.push_back({t[1], t[0], t[2]});
      break;
    case 4:
      t[k] = random.chance(0.5) ? -1 : static_cast<int>(mesh.vertices.size());
      break;
    case 5:
      t[k] = v;
      break;
    case 6:  // weld two vertices
      for (auto& s : mesh.triangles) std::replace(s.begin(), s.end(), v, w);
      break;
    case 7:  // a vertex of its own
      if (t[k] >= 0 && static_cast<std::size_t>(t[k]) < mesh.vertices.size()) {
        mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(t[k])]);
        t[k] = static_cast<int>(mesh.vertices.size()) - 1;
      }
      break;
    case 8:
      mesh.vertices[static_cast<std::size_t>(v)] = mesh.vertices[static_cast<std::size_t>(w)];
      break;
    case 9:
      if (random.chance(0.3)) {
        mesh.vertices[static_cast<std::size_t>(v)].y() = std::numeric_limits<double>::quiet_NaN();
      }
      break;
    case 10:
      mesh = contact::inside_out(mesh);
      break;
    case 11:
      mesh = contact::joined(mesh, some_mesh(random));
      break;
    default:
      if (random.chance(0.3)) {
        for (auto& p : mesh.vertices) p.z() = 0;
      }
  }
}

void compare(const Mesh<double>& mesh, std::array<int, kinds>& seen) {
  const MeshReport got = check_mesh(mesh);
  const Truth right = mesh_check_truth::truth(mesh);
  REQUIRE(got.closed == right.closed);
  REQUIRE(got.oriented == right.oriented);
  REQUIRE(got.manifold == right.manifold);
  REQUIRE(got.bounds_solid() == right.solid);
  REQUIRE(got.euler_characteristic == right.euler_characteristic);
  REQUIRE(got.components.size() == right.components.size());
  for (std::size_t c = 0; c < right.components.size(); ++c) {
    REQUIRE(got.components[c].triangles == right.components[c]);
    REQUIRE(got.components[c].volume_sign == right.volume_signs[c]);
    Mesh<double> alone = mesh;
    alone.triangles.clear();
    for (const int i : right.components[c]) {
      alone.triangles.push_back(mesh.triangles[static_cast<std::size_t>(i)]);
    }
    const MeshReport of_it = check_mesh(alone);
    REQUIRE(got.components[c].euler_characteristic == of_it.euler_characteristic);
    REQUIRE(got.components[c].closed == of_it.closed);
    REQUIRE(got.components[c].oriented == of_it.oriented);
  }
  std::multiset<Fault> faults;
  for (std::size_t i = 0; i < got.faults.size(); ++i) {
    const MeshFault& fault = got.faults[i];
    faults.insert({name(fault.kind), fault.triangles, fault.vertices});
    ++seen[static_cast<std::size_t>(fault.kind)];
    REQUIRE(text(fault, mesh).size() > 20);
    if (i > 0) REQUIRE(got.faults[i - 1].kind <= fault.kind);
  }
  REQUIRE(faults == right.faults);
}

TEST_CASE("what is wrong with a damaged mesh is found as by brute force") {
  Random random(510);
  std::array<int, kinds> seen{};
  for (int i = 0; i < generators::tried(10000); ++i) {
    INFO("case " << i);
    Mesh<double> mesh = some_mesh(random);
    for (int n = random.integer(0, 4); n > 0; --n) damage(random, mesh);
    compare(mesh, seen);
  }
  for (int kind = 0; kind < kinds; ++kind) {
    INFO(name(static_cast<MeshFaultKind>(kind)));
    CHECK(seen[static_cast<std::size_t>(kind)] > generators::tried(100));
  }
}

TEST_CASE("an empty mesh has no faults and bounds nothing") {
  const MeshReport report = check_mesh(Mesh<double>{});
  CHECK(report.ok());
  CHECK(report.closed);
  CHECK_FALSE(report.bounds_solid());
}

TEST_CASE("a triangle soup becomes a mesh when equal vertices are merged") {
  for (const Mesh<double>& mesh : {contact::box_mesh({-1, 0, -0.0}, {1, 2, 3}),
                                   contact::ball_mesh(1, 2), contact::torus_mesh(2, 1, 7, 5)}) {
    Mesh<double> soup = contact::triangle_soup(mesh);
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
      // Of every second triangle zeros have the other sign.
      for (double& x : soup.vertices[i]) x = i / 3 % 2 != 0 && x == 0 ? -x : x;
    }
    const MeshReport open = check_mesh(soup);
    CHECK_FALSE(open.closed);
    CHECK(open.components.size() == mesh.triangles.size());
    CHECK(open.count(MeshFaultKind::equal_vertices) == static_cast<int>(mesh.vertices.size()));
    const Mesh<double> merged = contact::merge_equal_vertices(soup);
    const MeshReport report = check_mesh(merged);
    CHECK(report.bounds_solid());
    CHECK(report.euler_characteristic == check_mesh(mesh).euler_characteristic);
    CHECK(contact::mesh_volume_exactly(merged) == contact::mesh_volume_exactly(mesh));
  }
  Mesh<double> signs{{{0.0, 0, 0}, {-0.0, 0, 0}}, {{0, 1, 7}, {-1, 1, 1}}};
  CHECK(contact::merge_equal_vertices(signs).triangles ==
        std::vector<std::array<int, 3>>{{0, 0, 7}, {-1, 0, 0}});
}

TEST_CASE("a cavity is no fault; the same shell outside is") {
  const Mesh<double> outer = contact::box_mesh({0, 0, 0}, {9, 9, 9});
  const Mesh<double> hole = contact::inside_out(contact::box_mesh({1, 1, 1}, {2, 2, 2}));
  const MeshReport hollow = check_mesh(contact::joined(outer, hole));
  CHECK(hollow.ok());
  CHECK(hollow.bounds_solid());
  CHECK(hollow.euler_characteristic == 4);
  CHECK(hollow.components.at(1).volume_sign == -1);
  const Mesh<double> away = contact::inside_out(contact::box_mesh({11, 1, 1}, {12, 2, 2}));
  const MeshReport wrong = check_mesh(contact::joined(outer, away));
  CHECK(wrong.count(MeshFaultKind::component_inside_out) == 1);
  CHECK_FALSE(wrong.bounds_solid());
}

TEST_CASE("each edge once, with the triangles on its two sides") {
  for (const Mesh<double>& mesh : {contact::ball_mesh(1, 1), contact::torus_mesh(2, 1, 5, 4)}) {
    const auto edges = contact::mesh_edges(mesh);
    CHECK(edges.size() * 2 == mesh.triangles.size() * 3);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const contact::MeshEdge& e = edges[i];
      CHECK(e.count == 2);
      CHECK(e.vertices[0] < e.vertices[1]);
      if (i > 0) CHECK(edges[i - 1].vertices < e.vertices);
      for (std::size_t k = 0; k < 2; ++k) {
        const auto& t = mesh.triangles[static_cast<std::size_t>(e.triangles[k])];
        const auto from = std::find(t.begin(), t.end(), e.vertices[k]) - t.begin();
        CHECK(t[static_cast<std::size_t>((from + 1) % 3)] == e.vertices[1 - k]);
        CHECK(t[static_cast<std::size_t>((from + 2) % 3)] == contact::third_vertex(t, e.vertices));
      }
    }
  }
  const Mesh<double> one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 1, 0}, {0, 0, 1}, {0, 1, 9}}};
  const auto edges = contact::mesh_edges(one);
  REQUIRE(edges.size() == 3);
  CHECK(edges[0].triangles == std::array<int, 2>{-1, 0});
  CHECK(edges[1].triangles == std::array<int, 2>{0, -1});
}

template <class S>
void check_volumes(std::uint64_t seed) {
  Random random(seed);
  int certain = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    Mesh<double> mesh = some_mesh(random);
    const int power = sizeof(S) == 4 ? 30 : 300;
    const double scale = std::ldexp(random.uniform(1, 2), random.integer(-power, power));
    const double shift = random.chance(0.5) ? 0 : random.magnitude(0, 20);
    for (Vector3<double>& v : mesh.vertices) {
      if (i % 5 == 0) v.z() *= 0x1p-60;
      v = (v.array() + shift).matrix() * scale;
    }
    const Mesh<S> rounded = contact::rounded_mesh<S>(mesh);
    const Mesh<double> stored = contact::rounded_mesh<double>(rounded);
    std::vector<int> all;
    for (int k = 0; k < static_cast<int>(mesh.triangles.size()); ++k) all.push_back(k);
    const Rational right = mesh_check_truth::six_volumes(stored, all) / 6;
    REQUIRE(contact::mesh_volume_exactly(rounded).nearest() == oracle::nearest(right));
    const contact::Bounded got = contact::mesh_volume(rounded);
    if (!std::isfinite(got.value) || !std::isfinite(got.bound)) continue;
    REQUIRE(oracle::error(got.value, right) <= got.bound);
    if (got.certain_sign() != 0) ++certain;
  }
  CHECK(certain > generators::tried(1500));
}
TEST_CASE("a volume is within its bound, in double") { check_volumes<double>(511); }
TEST_CASE("a volume is within its bound, in float") { check_volumes<float>(512); }

TEST_CASE("a fault in words") {
  Mesh<double> mesh = contact::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const MeshReport report = check_mesh(mesh);
  REQUIRE(report.faults.size() == 3);
  CHECK(text(report.faults[0], mesh) ==
        "edge 4-6 from (0, 0, 1) to (0, 1, 1) belongs to triangle 0 alone: the surface ends there");
}

}  // namespace
