#include <05_meshes/lines_at_meshes.hpp>
#include <contact/mesh_tree.hpp>
#include <set>
#include <stdexcept>

namespace {

using namespace lines_at_meshes;
using contact::Aabb;
using contact::BoxNode;
using contact::MeshTree;
using contact::TreeCounts;

template <class S>
void as_without(int meshes, std::uint64_t seed) {
  Random random(seed);
  int met = 0, at_edges = 0;
  for (int m = 0; m < generators::tried(meshes); ++m) {
    const int kind = m % mesh_kinds;
    const Mesh<double> drawn = mesh_of_kind(random, kind);
    const Mesh<S> mesh = mesh_in<S>(drawn);
    const MeshTree<S> tree(mesh);
    for (int i = 0; i < 20; ++i) {
      INFO("kind " << kind << ", mesh " << m << ", line " << i);
      with_line<S>(line_at(random, drawn), [&](const auto& line) {
        const auto all = contact::all_mesh_hits(line, mesh);
        const auto by_tree = tree.all(line);
        const auto first = tree.first(line);
        REQUIRE(tree.any(line) == !all.empty());
        REQUIRE(first.has_value() == !all.empty());
        REQUIRE(by_tree.size() == all.size());
        for (std::size_t k = 0; k < all.size(); ++k) REQUIRE(same(by_tree[k], all[k]));
        if (!first) return;
        REQUIRE(same(*first, all[0]));
        ++met;
        if (first->feature != contact::MeshFeature::face) ++at_edges;
      });
    }
  }
  CHECK(met > generators::tried(meshes) * 5);
  CHECK(at_edges > generators::tried(meshes) * 2);
}

TEST_CASE("the tree answers as all triangles one by one, to the last bit") {
  as_without<double>(700, 91);
  as_without<float>(700, 92);
}

/// Rays from inside a closed mesh, at its vertices and edges as rounded: each meets it.
void no_leak(const Mesh<double>& mesh, const Point& inside, double wobble, int count,
             std::uint64_t seed) {
  Random random(seed);
  const MeshTree<double> tree(mesh);
  const int last = static_cast<int>(mesh.triangles.size()) - 1;
  for (int i = 0; i < generators::tried(count); ++i) {
    const auto k = static_cast<std::size_t>(random.integer(0, last));
    const auto [a, b, c] = contact::triangle_of(mesh, k);
    const double along = random.chance(0.3) ? 0 : random.uniform();
    const Point target = a + along * (b - a);
    const Point start = inside + wobble * in_cube(random);
    const Ray<double> ray{start, target - start};
    INFO("ray " << i);
    REQUIRE(tree.any(ray));
    REQUIRE(tree.first(ray));
  }
}

TEST_CASE("no ray from inside leaks at an edge or a vertex") {
  no_leak(contact::ball_mesh(1.0, 4), {0, 0, 0}, 0.25, 20000, 93);
  no_leak(contact::star_mesh(0.5, 1.5, 3), {0, 0, 0}, 0.125, 20000, 94);
  Mesh<double> far = contact::ball_mesh(1.0, 3);
  for (Point& v : far.vertices) v += Point(0x1p30, -0x1p28, 0x1p20);
  no_leak(far, {0x1p30, -0x1p28, 0x1p20}, 0.25, 10000, 95);
  no_leak(scaled(contact::ball_mesh(1.0, 2), 0x1p490), {0, 0, 0}, 0x1p488, 100, 96);
}

TEST_CASE("a visit finds every triangle whose box passes, each once") {
  Random random(1);
  const Mesh<double> mesh = contact::ball_mesh(1.0, 4);
  const MeshTree<double> tree(mesh);
  for (int i = 0; i < generators::tried(200); ++i) {
    const double x = random.uniform(-1.2, 1.2);
    const double y = random.uniform(-1.2, 1.2);
    const auto enters = [&](const Aabb<double>& box) {
      return box.low.x() <= x && x <= box.high.x() && box.low.y() <= y && y <= box.high.y();
    };
    std::set<int> visited;
    TreeCounts counts;
    const bool stopped = tree.visit(
        enters,
        [&](int triangle) {
          REQUIRE(visited.insert(triangle).second);
          return false;
        },
        &counts);
    CHECK_FALSE(stopped);
    CHECK(counts.triangles == visited.size());
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      const auto [a, b, c] = contact::triangle_of(mesh, k);
      const Aabb<double> box{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
      if (enters(box)) REQUIRE(visited.contains(static_cast<int>(k)));
    }
    CHECK(visited.size() < mesh.triangles.size() / 4);
  }
  int seen = 0;
  CHECK(tree.visit([](const auto&) { return true; },
                   [&seen](int, const Triangle<double>&) { return ++seen == 3; }));
  CHECK(seen == 3);
}

TEST_CASE("boxes are the smallest ones, and every triangle is in one leaf") {
  Random random(97);
  for (int kind = 0; kind < mesh_kinds; ++kind) {
    const Mesh<double> mesh = mesh_of_kind(random, kind);
    const MeshTree<double> tree(mesh);
    const auto& [nodes, order] = tree.boxes();
    std::set<int> items;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const BoxNode<double>& node = nodes[n];
      const auto first = static_cast<std::size_t>(node.first);
      Aabb<double> box;
      if (node.count == 0) {
        REQUIRE(first > n);
        box = contact::enclosing_box(nodes[first].box, nodes[first + 1].box);
      }
      for (std::size_t i = first; i < first + static_cast<std::size_t>(node.count); ++i) {
        REQUIRE(items.insert(order[i]).second);
        const auto [a, b, c] = contact::triangle_of(mesh, static_cast<std::size_t>(order[i]));
        const Aabb<double> one{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
        box = i == first ? one : contact::enclosing_box(box, one);
      }
      REQUIRE(node.box.low == box.low);
      REQUIRE(node.box.high == box.high);
    }
    std::size_t finite = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto [a, b, c] = contact::triangle_of(mesh, i);
      if (contact::all_finite(a) && contact::all_finite(b) && contact::all_finite(c)) ++finite;
    }
    CHECK(items.size() == finite);
  }
}

TEST_CASE("refitting: the boxes are those of the moved items, and their cost is measured") {
  const Mesh<double> mesh = contact::star_mesh(0.5, 1.5, 3);
  std::vector<Aabb<double>> boxes;
  std::vector<int> items;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = contact::triangle_of(mesh, i);
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
    items.push_back(static_cast<int>(i));
  }
  auto tree = contact::build_box_hierarchy<double>(boxes, items, 4);
  const auto built = tree;
  const double cost = contact::hierarchy_cost<double>(tree, boxes);
  // The half edge of the cube, and the share of positions at which it meets a node.
  const auto half = [](const Aabb<double>& box) -> Point { return (box.high - box.low) / 2; };
  const Point root = half(tree.nodes[0].box);
  double t = root.sum() / double(boxes.size());
  for (const Aabb<double>& box : boxes) t += half(box).sum() / 3 / double(boxes.size());
  double sum = 0;
  for (std::size_t n = 1; n < built.nodes.size(); ++n)
    sum += ((half(built.nodes[n].box).array() + t) / (root.array() + t)).prod();
  CHECK(std::abs(cost - sum) < 1e-12 * sum);
  // Twice the size: nothing is rounded, so the boxes double, and the cost is the same.
  for (Aabb<double>& box : boxes) box = {Point(2 * box.low), Point(2 * box.high)};
  contact::refit_box_hierarchy<double>(tree, boxes);
  REQUIRE(tree.order == built.order);
  for (std::size_t n = 0; n < built.nodes.size(); ++n) {
    REQUIRE(tree.nodes[n].box.low == 2 * built.nodes[n].box.low);
    REQUIRE(tree.nodes[n].box.high == 2 * built.nodes[n].box.high);
  }
  CHECK(contact::hierarchy_cost<double>(tree, boxes) == cost);
}

TEST_CASE("the same triangle many times, and sizes that halve: the tree does not get deep") {
  Mesh<double> mesh;
  for (int i = 0; i < 3000; ++i) {
    const double size = i < 1500 ? 1 : std::ldexp(1.0, -i % 1000);
    const int at = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{size, 0, 0}, {0, size, 0}, {0, 0, size}});
    mesh.triangles.push_back({at, at + 1, at + 2});
  }
  const MeshTree<double> tree(mesh);
  const auto& nodes = tree.boxes().nodes;
  std::vector<int> depth(nodes.size(), 1);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    REQUIRE(depth[n] <= contact::detail::box_tree_depth);
    if (nodes[n].count > 0) continue;
    const auto first = static_cast<std::size_t>(nodes[n].first);
    depth[first] = depth[first + 1] = depth[n] + 1;
  }
  const Ray<double> ray{{4, 4, 4}, {-1, -1, -1}};
  const auto first = tree.first(ray);
  REQUIRE(first);
  CHECK(first->triangle == 0);
  CHECK(tree.all(ray).size() == contact::all_mesh_hits(ray, mesh).size());
}

TEST_CASE("a first hit tests few boxes and triangles") {
  Random random(98);
  const MeshTree<double> tree(contact::ball_mesh(1.0, 5));
  TreeCounts counts;
  for (int i = 0; i < 1000; ++i) {
    const Point start = 3 * in_cube(random);
    const Point target = in_cube(random);
    tree.first(Ray<double>{start, target - start}, &counts);
  }
  CHECK(counts.boxes < 100 * 1000);
  CHECK(counts.triangles < 20 * 1000);
}

TEST_CASE("an empty mesh, and a vertex that does not exist") {
  const MeshTree<double> none{Mesh<double>{}};
  CHECK_FALSE(none.first(Ray<double>{{0, 0, 0}, {1, 0, 0}}));
  CHECK_FALSE(none.visit([](const auto&) { return true; }, [](int) { return true; }));
  CHECK_THROWS_AS(MeshTree<double>(Mesh<double>{{{0, 0, 0}}, {{0, 0, 1}}}), std::invalid_argument);
  CHECK_THROWS_AS(MeshTree<double>(Mesh<double>{{{0, 0, 0}}, {{0, -1, 0}}}), std::invalid_argument);
}

}  // namespace
