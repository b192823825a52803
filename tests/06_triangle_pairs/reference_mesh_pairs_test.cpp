#include <05_meshes/lines_at_meshes.hpp>
#include <06_triangle_pairs/common_points_truth.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <algorithm>
#include <contact/mesh_pairs.hpp>
#include <limits>
#include <stdexcept>

namespace mesh_pairs_test {

using contact::any_meeting;
using contact::meeting_triangles;
using contact::Mesh;
using contact::MeshTree;
using contact::PairCounts;
using contact::self_meeting_triangles;
using contact::Triangle;
using contact::TrianglePair;
using generators::Random;
using lines_at_meshes::mesh_kinds;
using lines_at_meshes::mesh_of_kind;
using lines_at_meshes::soup;
using lines_at_meshes::whole;
using Point = contact::Vector3<double>;
using Pairs = std::vector<TrianglePair>;

/// The x axis becomes y, y becomes z, z becomes x.
Mesh<double> turned(Mesh<double> mesh) {
  for (Point& v : mesh.vertices) v = Point(v.z(), v.x(), v.y());
  return mesh;
}
/// Each coordinate rounded to a whole number after multiplication.
Mesh<double> in_steps(Mesh<double> mesh, double steps) {
  for (Point& v : mesh.vertices) {
    for (double& x : v) x = std::round(steps * x);
  }
  return mesh;
}
Triangle<double> triangle(const Mesh<double>& mesh, int i) {
  return contact::triangle_of(mesh, static_cast<std::size_t>(i));
}
int count(const Mesh<double>& mesh) { return static_cast<int>(mesh.triangles.size()); }

/// A mesh of a kind and another that is likely to meet it: of the same kind, or the same one with
/// its axes exchanged or moved a little.
std::array<Mesh<double>, 2> two_of_kind(Random& random, int kind) {
  const Mesh<double> first = mesh_of_kind(random, kind);
  const int how = random.integer(0, 3);
  if (how == 0) return {first, mesh_of_kind(random, random.integer(0, mesh_kinds - 1))};
  if (how == 1) return {first, mesh_of_kind(random, kind)};
  if (how == 2) return {first, turned(first)};
  Point v = first.vertices[0];
  if (!contact::all_finite(v)) v = Point::Ones();
  return {first, contact::translated<double>(first, v / 4)};
}

template <class S>
void same_by_trees(int meshes, std::uint64_t seed) {
  Random random(seed);
  std::size_t met = 0;
  int apart = 0;
  for (int m = 0; m < generators::tried(meshes); ++m) {
    INFO("kind " << m % mesh_kinds << ", meshes " << m);
    const auto drawn = two_of_kind(random, m % mesh_kinds);
    const Mesh<S> a = contact::rounded_mesh<S>(drawn[0]), b = contact::rounded_mesh<S>(drawn[1]);
    const MeshTree<S> tree_a(a), tree_b(b);
    const Pairs pairs = meeting_triangles(a, b);
    REQUIRE(std::is_sorted(pairs.begin(), pairs.end()));
    REQUIRE(meeting_triangles(tree_a, tree_b) == pairs);
    REQUIRE(any_meeting(a, b) == !pairs.empty());
    REQUIRE(any_meeting(tree_a, tree_b) == !pairs.empty());
    met += pairs.size();
    if (pairs.empty()) ++apart;
  }
  CHECK(met > static_cast<std::size_t>(generators::tried(meshes)) * 20);
  CHECK(apart > generators::tried(meshes) / 20);
}

TEST_CASE("two trees find the pairs that each triangle against each finds") {
  same_by_trees<double>(420, 1);
  same_by_trees<float>(280, 2);
}

/// Each against each, by another method, without boxes.
Pairs by_integers(const Mesh<double>& a, const Mesh<double>& b) {
  Pairs pairs;
  for (int i = 0; i < count(a); ++i) {
    for (int j = 0; j < count(b); ++j) {
      if (pair_truth::meet_in_integers(triangle(a, i), triangle(b, j))) pairs.push_back({i, j});
    }
  }
  return pairs;
}

TEST_CASE("the pairs of meshes with whole coordinates are right in integers") {
  Random random(3);
  std::size_t met = 0;
  for (int m = 0; m < generators::tried(120); ++m) {
    INFO("meshes " << m);
    const auto dense = [&random](int) { return whole(random, 3); };
    const auto wide = [&random](int) { return whole(random, 1000); };
    const std::array<Mesh<double>, 4> meshes{
        soup(random, 12, 40, dense), soup(random, 30, 40, wide),
        in_steps(contact::torus_mesh(1, 0.4, 10, 6), 4),
        contact::translated<double>(contact::box_mesh({0, 0, 0}, {4, 4, 4}), whole(random, 4))};
    const auto& a = meshes[static_cast<std::size_t>(random.integer(0, 3))];
    const Mesh<double> b = turned(meshes[static_cast<std::size_t>(random.integer(0, 3))]);
    const Pairs right = by_integers(a, b);
    REQUIRE(meeting_triangles(a, b) == right);
    REQUIRE(meeting_triangles(MeshTree(a), MeshTree(b)) == right);
    met += right.size();
  }
  CHECK(met > 1000);
}

TEST_CASE("the pairs of the second mesh with the first are those of the first with the second") {
  Random random(4);
  for (int m = 0; m < generators::tried(200); ++m) {
    const auto [a, b] = two_of_kind(random, m % mesh_kinds);
    Pairs swapped = meeting_triangles(MeshTree(b), MeshTree(a));
    for (TrianglePair& pair : swapped) std::swap(pair.of_first, pair.of_second);
    std::sort(swapped.begin(), swapped.end());
    REQUIRE(swapped == meeting_triangles(MeshTree(a), MeshTree(b)));
  }
}

TEST_CASE("two trees lose no pair at any scale and distance from the origin") {
  Random random(6);
  std::size_t met = 0;
  for (int m = 0; m < generators::tried(300); ++m) {
    const auto drawn = [&random](int) { return whole(random, 3); };
    const Mesh<double> a = soup(random, 12, 20, drawn), b = soup(random, 12, 20, drawn);
    const Pairs right = meeting_triangles(a, b);
    met += right.size();
    const double scale = std::ldexp(1.0, random.integer(-1000, 900));
    const Point away = std::ldexp(1.0, random.integer(0, 48)) * whole(random, 1);
    const auto mapped = [&](Mesh<double> mesh) {
      for (Point& v : mesh.vertices) v = scale * (v + away);  // without rounding
      return mesh;
    };
    REQUIRE(meeting_triangles(MeshTree(mapped(a)), MeshTree(mapped(b))) == right);
  }
  CHECK(met > static_cast<std::size_t>(generators::tried(300)) * 20);
}

TEST_CASE("a small mesh far from the middle of a large one meets what it touches") {
  Random random(7);
  const Mesh<double> large = contact::ball_mesh(0x1p20, 3);
  const MeshTree large_tree(large);
  int met = 0;
  for (int m = 0; m < generators::tried(200); ++m) {
    const auto i = static_cast<std::size_t>(random.integer(0, count(large) - 1));
    const Point at = lines_at_meshes::point_at(random, contact::triangle_of(large, i));
    const double size = std::ldexp(1.0, random.integer(-40, 10));
    const Mesh<double> small =
        contact::translated<double>(lines_at_meshes::scaled(contact::octahedron_mesh(1), size), at);
    const Pairs right = meeting_triangles(large, small);
    REQUIRE(meeting_triangles(large_tree, MeshTree(small)) == right);
    met += right.empty() ? 0 : 1;
  }
  CHECK(met > generators::tried(200) / 2);
}

TEST_CASE("a small mesh that is near no triangle of a large one is not opened") {
  PairCounts counts;
  const MeshTree large(contact::ball_mesh(1, 5));
  const MeshTree small(contact::translated<double>(
      lines_at_meshes::scaled(contact::ball_mesh(1, 5), 0x1p-10), {0.5, 0.5, 0.5}));
  CHECK_FALSE(any_meeting(large, small, &counts));
  CHECK(counts.boxes < 200);
}

TEST_CASE("a mesh inside another one meets nothing, and touching meshes meet") {
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {4, 4, 4});
  const auto pairs = [&box](const Point& low, const Point& high) {
    return meeting_triangles(MeshTree(box), MeshTree(contact::box_mesh(low, high))).size();
  };
  CHECK(pairs({1, 1, 1}, {2, 2, 2}) == 0);
  CHECK(pairs({1, 1, 4 + 0x1p-50}, {2, 2, 5}) == 0);
  CHECK(pairs({4, 4, 4}, {5, 5, 5}) > 0);
}

TEST_CASE("meshes without triangles meet nothing") {
  const Mesh<double> none, ball = contact::ball_mesh(1, 1);
  PairCounts counts;
  CHECK(meeting_triangles(none, ball, &counts).empty());
  CHECK(meeting_triangles(MeshTree(none), MeshTree(ball), &counts).empty());
  CHECK(meeting_triangles(MeshTree(ball), MeshTree(none), &counts).empty());
  CHECK_FALSE(any_meeting(MeshTree(none), MeshTree(none), &counts));
  CHECK(self_meeting_triangles(none, &counts).empty());
  CHECK(counts.boxes == 0);
  CHECK(counts.triangles == 0);
}

TEST_CASE("triangles that are not finite are left out of pairs") {
  const Mesh<double> ball = contact::ball_mesh(1, 1);
  Mesh<double> damaged = ball;
  damaged.vertices[2].y() = std::numeric_limits<double>::quiet_NaN();
  damaged.vertices[5].z() = std::numeric_limits<double>::infinity();
  Pairs right = meeting_triangles(ball, turned(ball));
  std::erase_if(right, [&damaged](const TrianglePair& pair) {
    const auto& t = damaged.triangles[static_cast<std::size_t>(pair.of_first)];
    return std::any_of(t.begin(), t.end(), [](int v) { return v == 2 || v == 5; });
  });
  CHECK_FALSE(right.empty());
  CHECK(meeting_triangles(damaged, turned(ball)) == right);
  CHECK(meeting_triangles(MeshTree(damaged), MeshTree(turned(ball))) == right);
}

TEST_CASE("boxes that are apart cost one comparison") {
  const MeshTree near_tree(contact::ball_mesh(1, 4));
  const MeshTree far_tree(contact::translated<double>(contact::ball_mesh(1, 4), {2.5, 0, 0}));
  PairCounts counts;
  CHECK(meeting_triangles(near_tree, far_tree, &counts).empty());
  CHECK(counts.boxes == 1);
  CHECK(counts.triangles == 0);
}

TEST_CASE("counts of boxes and triangles are added, and by each with each are all pairs") {
  const Mesh<double> ball = contact::ball_mesh(1, 2),
                     other = contact::translated<double>(ball, {0.5, 0.25, 0.125});
  PairCounts all, tree;
  const Pairs pairs = meeting_triangles(ball, other, &all);
  CHECK(all.boxes == ball.triangles.size() * other.triangles.size());
  CHECK(all.triangles > pairs.size());
  meeting_triangles(MeshTree(ball), MeshTree(other), &tree);
  CHECK(tree.triangles >= all.triangles);
  CHECK(tree.triangles < all.triangles * 11 / 10);
  CHECK(tree.boxes < all.boxes / 10);
  const PairCounts once = tree;
  meeting_triangles(MeshTree(ball), MeshTree(other), &tree);
  CHECK(tree.boxes == 2 * once.boxes);
  CHECK(tree.triangles == 2 * once.triangles);
}

TEST_CASE("a search for any pair does not stay where surfaces are close and do not meet") {
  // Two balls, a little apart but for an eighth, in which they cross.
  const Mesh<double> inner = contact::ball_mesh(1, 5);
  for (int octant = 0; octant < 8; ++octant) {
    Mesh<double> outer = inner;
    for (Point& v : outer.vertices) {
      const bool there = (v.x() > 0) == (octant % 2 > 0) && (v.y() > 0) == (octant / 2 % 2 > 0) &&
                         (v.z() > 0) == (octant / 4 > 0);
      v *= there ? 0.999 : 1.001;
    }
    PairCounts any, all;
    const MeshTree a(inner), b(outer);
    CHECK(any_meeting(a, b, &any));
    meeting_triangles(a, b, &all);
    CHECK(any.triangles < all.triangles / 20);
  }
}

/// Whether two triangles have more in common than vertices and edges that they share: in fractions.
bool beyond_shared(const Triangle<double>& s, const Triangle<double>& t) {
  using contact::FeatureKind;
  const auto common = common_points_truth::common_vertices(common_points_truth::vertices(s),
                                                           common_points_truth::vertices(t));
  return common.size() > 2 || std::any_of(common.begin(), common.end(), [](const auto& point) {
           return point.of_first.kind != FeatureKind::vertex ||
                  point.of_second.kind != FeatureKind::vertex;
         });
}
Pairs self_in_fractions(const Mesh<double>& mesh) {
  Pairs pairs;
  for (int i = 0; i < count(mesh); ++i) {
    for (int j = i + 1; j < count(mesh); ++j) {
      if (!pair_truth::meet_in_integers(triangle(mesh, i), triangle(mesh, j))) continue;
      if (beyond_shared(triangle(mesh, i), triangle(mesh, j))) pairs.push_back({i, j});
    }
  }
  return pairs;
}

TEST_CASE("the pairs of one mesh that meet beyond what they share are right in fractions") {
  Random random(5);
  for (int m = 0; m < generators::tried(40); ++m) {
    INFO("mesh " << m);
    const int size = random.integer(1, 4);
    const Mesh<double> mesh = soup(random, random.integer(5, 12), 14,
                                   [&random, size](int) { return whole(random, size); });
    const Pairs right = self_in_fractions(mesh);
    REQUIRE(self_meeting_triangles(mesh) == right);
    REQUIRE(self_meeting_triangles(contact::triangle_soup(mesh)) == right);
    REQUIRE(self_meeting_triangles(contact::rounded_mesh<float>(mesh)) == right);
  }
}

TEST_CASE("surfaces that do not cross themselves have no pair that meets") {
  for (const Mesh<double>& mesh :
       {contact::ball_mesh(1, 3), contact::torus_mesh(1, 0.4, 40, 20),
        contact::star_mesh(0.5, 1, 2), contact::box_mesh({0, 0, 0}, {1, 2, 3}),
        contact::octahedron_mesh(1), lines_at_meshes::flat_square(8, 1)}) {
    CHECK(self_meeting_triangles(mesh).empty());
    CHECK(self_meeting_triangles(contact::triangle_soup(mesh)).empty());
  }
}

TEST_CASE("two meshes as one: the pairs that meet are those between them") {
  const Mesh<double> a = contact::torus_mesh(1, 0.4, 30, 15);
  const Mesh<double> b = contact::translated<double>(turned(a), {0.7, 0, 0.1});
  Pairs right = meeting_triangles(MeshTree(a), MeshTree(b));
  for (TrianglePair& pair : right) pair.of_second += count(a);
  CHECK(right.size() > 50);
  CHECK(self_meeting_triangles(contact::joined(a, b)) == right);
}

TEST_CASE("folded, equal and touching triangles of one mesh meet, neighbours do not") {
  const auto pairs = [](std::vector<Point> vertices, std::vector<std::array<int, 3>> triangles) {
    return self_meeting_triangles(Mesh<double>{std::move(vertices), std::move(triangles)}).size();
  };
  const std::vector<Point> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 1, 1}};
  CHECK(pairs(square, {{0, 1, 2}, {0, 2, 3}}) == 0);  // an edge, in one plane
  CHECK(pairs(square, {{0, 1, 2}, {0, 2, 5}}) == 0);  // an edge, folded by less
  CHECK(pairs(square, {{0, 1, 2}, {0, 1, 3}}) == 1);  // an edge, folded onto the other
  CHECK(pairs(square, {{0, 1, 2}, {1, 2, 0}}) == 1);  // the same twice
  CHECK(pairs(square, {{0, 1, 4}, {2, 3, 4}}) == 0);  // a vertex, in one plane
  CHECK(pairs(square, {{0, 1, 4}, {0, 1, 2}}) == 1);  // one inside the other
  CHECK(pairs(square, {{0, 2, 3}, {4, 1, 5}}) == 1);  // a vertex in the middle of an edge
  CHECK(pairs(square, {{0, 4, 5}, {0, 2, 3}}) == 1);  // edges that overlap
  CHECK(pairs(square, {{0, 2, 4}, {0, 2, 3}, {0, 1, 4}}) ==
        1);  // without area; 0 4 2 and 0 2 3: no
  CHECK(pairs({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 1}, {1, 1, -1}}, {{0, 1, 2}, {0, 3, 4}}) ==
        1);  // a vertex, and the edge in front of it crosses
}

TEST_CASE("a triangle with an index out of range cannot be searched") {
  Mesh<double> mesh = contact::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles[3][1] = 8;
  CHECK_THROWS_AS(self_meeting_triangles(mesh), std::invalid_argument);
}

}  // namespace mesh_pairs_test
