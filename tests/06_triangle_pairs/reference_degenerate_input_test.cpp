// What the headers' comments say of triangles without area, empty meshes, NaN, infinity, overflow
// and underflow.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/exact_fraction.hpp>
#include <contact/feature_contacts.hpp>
#include <contact/mesh_contacts.hpp>
#include <contact/mesh_features.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/nearest_triangles.hpp>
#include <contact/pair_methods.hpp>
#include <contact/triangle_box.hpp>
#include <contact/triangle_features.hpp>
#include <contact/triangles_meet.hpp>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace degenerate_input {
namespace {

using contact::FeatureKind;
using contact::Mesh;
using contact::MeshTree;
using contact::Triangle;
using contact::TrianglePair;
using contact::Vector3;
using Point = Vector3<double>;
using Pairs = std::vector<TrianglePair>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

const Triangle<double> flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const Triangle<double> crossing_line{{1, 1, -1}, {1, 1, 0}, {1, 1, 1}};
const Triangle<double> line_apart{{5, 5, -1}, {5, 5, 0}, {5, 5, 1}};

Triangle<double> point(double x, double y, double z) { return {{x, y, z}, {x, y, z}, {x, y, z}}; }
Mesh<double> mesh_of(const Triangle<double>& t) { return {{t.a, t.b, t.c}, {{0, 1, 2}}}; }

TEST_CASE("the edge of a vertex and itself") {
  for (const int v : {0, 1, 2}) CHECK(contact::edge_between(v, v) == v);
}

TEST_CASE("the nearest points of triangles without area in fractions, and of NaN") {
  using contact::ExactFraction;
  using contact::nearest_triangles_detail::in_fractions;
  const auto squared = [](const Triangle<double>& t, const Triangle<double>& u) {
    return contact::nearest_of_apart_triangles<ExactFraction>(in_fractions(t), in_fractions(u))
        .squared_distance;
  };
  CHECK(squared(flat, point(1, 1, 3)) == ExactFraction(9));
  CHECK(squared(point(1, 0, 3), {{0, 0, 1}, {3, 0, 1}, {2, 0, 1}}) == ExactFraction(4));
  CHECK(squared(line_apart, {{0, 5, 3}, {9, 5, 3}, {1, 5, 3}}) == ExactFraction(4));
  const Triangle<double> with_nan{{0, 0, 5}, {9, 0, 9}, {0, nan, 9}};
  CHECK(contact::nearest_of_apart_triangles(flat, with_nan).squared_distance == 25);
  CHECK(std::isnan(contact::nearest_of_triangles(flat, with_nan).squared_distance));
}

TEST_CASE("the lecture's steps with a first triangle without area") {
  CHECK(contact::meet_by_steps(crossing_line, flat).meet);
  CHECK_FALSE(contact::meet_by_steps(line_apart, flat).meet);
  CHECK(contact::meet_by_steps(point(1, 1, 0), flat).coplanar);
  CHECK(contact::meet_by_steps(point(1, 1, 1), flat).decided_in == 2);
}

TEST_CASE("intervals with an epsilon that is no small number, and without area") {
  const Triangle<double> crossing{{1, 1, -1}, {1, 1, 1}, {1, 2, 1}};
  const Triangle<double> above{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}};
  for (const double epsilon : {0.0, -1.0, nan}) {
    CHECK(contact::meet_by_intervals(flat, crossing, epsilon));
    CHECK_FALSE(contact::meet_by_intervals(flat, above, epsilon));
  }
  CHECK(contact::meet_by_intervals(flat, above, infinite));
  CHECK(contact::meet_by_intervals(flat, line_apart));
  CHECK_FALSE(contact::triangles_meet(flat, line_apart));
}

TEST_CASE("an edge or a triangle with a NaN meets nothing, but another edge of the pair may") {
  const Point below(1, 1, -1), over(1, 1, 1), aside(9, 9, nan);
  CHECK(contact::meet_by_edges<double>({below, over, aside}, flat));
  CHECK_FALSE(contact::triangles_meet<double>({below, over, aside}, flat));
  CHECK_FALSE(contact::meet_by_edges<double>({Point(1, nan, -1), over, {1, 2, 1}}, flat));
  CHECK_FALSE(contact::meet_by_edges<double>({flat.a, flat.b, {0, nan, 0}}, crossing_line));
}

TEST_CASE("a box meets a triangle of NaN in rounded arithmetic only") {
  const contact::Aabb<double> box{{0, 0, 0}, {1, 1, 1}};
  CHECK(contact::triangle_meets_box_rounded(point(nan, nan, nan), box));
  CHECK_FALSE(contact::triangle_meets_box(point(nan, nan, nan), box));
}

TEST_CASE("meshes without triangles, with triangles without area or not finite") {
  const Mesh<double> empty, plane = mesh_of(flat);
  CHECK(contact::self_meeting_triangles(empty).empty());
  CHECK(contact::mesh_contacts(empty, plane).empty());
  CHECK(contact::contacts_of_pairs(plane, empty).empty());
  const Mesh<double> lines{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {1, 1, 0}},
                           {{0, 1, 2}, {0, 1, 3}, {1, 1, 0}, {4, 4, 4}, {0, 3, 0}}};
  CHECK(contact::self_meeting_triangles(lines) == Pairs{{0, 3}, {0, 4}, {2, 4}});
  CHECK(contact::mesh_contacts(mesh_of(point(1, 1, 0)), plane).size() == 1);
  CHECK(contact::contacts_of_pairs(mesh_of(crossing_line), plane).size() == 1);
  for (const double x : {nan, infinite, -infinite}) {
    const Mesh<double> mesh = mesh_of({{1, 1, -1}, {1, 1, 1}, {1, x, 1}});
    CHECK(contact::mesh_contacts(mesh, plane).empty());
    CHECK(contact::contacts_of_pairs(mesh, plane).empty());
  }
}

TEST_CASE("a triangle without area or with a wrong index has no flat edge") {
  const Mesh<double> mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 0, 0}},
                          {{0, 1, 2}, {2, 1, 3}, {1, 0, 4}, {0, 0, 1}, {0, 2, 77}}};
  const contact::FeatureNames names(mesh);
  CHECK(names.is_flat(0, 1));
  CHECK(names.face(1) == 0);
  for (const std::size_t i : {2U, 3U, 4U}) {
    CHECK(names.face(i) == static_cast<int>(i));
    for (const int edge : {0, 1, 2}) CHECK_FALSE(names.is_flat(i, edge));
  }
  CHECK(names.of(3, {FeatureKind::edge, 0}).vertices == std::array{0, 0, -1});
}

/// Eight triangles side by side in the plane z = 0, longer than the largest number.
template <class S>
Mesh<S> strip() {
  constexpr S far = std::numeric_limits<S>::max();
  Mesh<S> mesh;
  for (int i = 0; i < 8; ++i) {
    const S y = static_cast<S>(3 * i);
    for (const auto& [x, up] : {std::pair(-far, 0), {far, 0}, {far, 1}}) {
      mesh.vertices.push_back({x, y + static_cast<S>(up), 0});
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}
TEST_CASE("a tree of a mesh that is longer than the largest number") {
  const Mesh<double> needle = mesh_of({{1, 6.25, -1}, {1, 6.25, 1}, {2, 6.25, 1}});
  const MeshTree<double> tree(strip<double>());
  CHECK(contact::meeting_triangles(tree, MeshTree<double>(needle)) == Pairs{{2, 0}});
  CHECK(contact::self_meeting_triangles(MeshTree<float>(strip<float>())).empty());
}

TEST_CASE("a first contact without displacement is that of the start") {
  CHECK_FALSE(contact::first_contact(mesh_of(line_apart), Point::Zero(), mesh_of(flat)));
  const auto found = contact::first_contact(mesh_of(crossing_line), Point::Zero(), mesh_of(flat));
  REQUIRE(found);
  CHECK_FALSE(found->apart_at_start);
}

TEST_CASE("the first contact of meshes of every size") {
  std::mt19937 random(2);
  const auto whole = [&] { return static_cast<double>(static_cast<int>(random() % 31) - 15); };
  int met = 0;
  for (int i = 0; i < 30; ++i) {
    const auto any = [&] { return Point{whole(), whole(), whole()}; };
    const Mesh<double> a{{any(), any(), any()}, {{0, 1, 2}}}, b{{any(), any(), any()}, {{0, 1, 2}}};
    const Point d = any();
    const auto scaled = [&](double size) {
      Mesh<double> first = a, second = b;
      for (Point& v : first.vertices) v *= size;
      for (Point& v : second.vertices) v *= size;
      return contact::first_contact(first, Point(d * size), second);
    };
    const auto plain = scaled(1);
    met += plain && plain->apart_at_start;
    for (const double size : {0x1p1020, 0x1p-1074}) {
      const auto found = scaled(size);
      REQUIRE(found.has_value() == plain.has_value());
      if (!found) continue;
      REQUIRE(found->exact_t == plain->exact_t);
      const auto same = [](const contact::FeatureContact& c, const contact::FeatureContact& e) {
        return c.of_moving == e.of_moving && c.of_resting == e.of_resting;
      };
      REQUIRE(std::ranges::equal(found->contacts, plain->contacts, same));
    }
  }
  CHECK(met > 3);
}

TEST_CASE("a first contact at a time that is rounded to 0") {
  // At z = 0 after 2^-1076 of the displacement, so at x = 2^-76.
  const Mesh<double> moving = mesh_of(point(0, 0, smallest));
  for (const double edge : {0x1p-80, 0x1p-74}) {
    const Mesh<double> resting = mesh_of({{edge, -1, 0}, {edge, 1, 0}, {1, 0, 0}});
    const auto found = contact::first_contact(moving, {0x1p1000, 0, -4}, resting);
    REQUIRE(found.has_value() == (edge < 0x1p-76));
    if (!found) continue;
    CHECK(found->t == 0);
    CHECK(found->exact_t.sign() > 0);
    CHECK(found->realised_by.size() == 1);
  }
}

}  // namespace
}  // namespace degenerate_input
