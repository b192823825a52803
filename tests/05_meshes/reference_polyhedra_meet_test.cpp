// Whether polyhedra meet: against cubes, whose boxes are compared, and edges against faces by
// separating axes in whole numbers.
#include <05_meshes/polycubes.hpp>
#include <05_meshes/polyhedra_truth.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/polyhedra_meet.hpp>
#include <limits>
#include <map>

namespace {

using contact::DecidedBy;
using contact::Mesh;
using contact::PolyhedraOrder;
using contact::PolyhedraTest;
using contact::Segment;
using contact::Triangle;
using generators::Random;
using polycubes::Point;
using polyhedra_truth::meet_by_axes;
using polyhedra_truth::Three;

// ---------------------------------------------------------------- edges and faces

TEST_CASE("an edge and a face meet unless an axis separates them") {
  using Whole = std::int64_t;
  Random random(1);
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(400000); ++i) {
    std::array<Three<Whole>, 5> p;
    const int range = 1 + i % 4;
    for (auto& v : p) {
      for (int k = 0; k < 3; ++k) v(k) = random.integer(-range, range);
    }
    if (i % 3 == 0) {  // in the plane of the face
      for (const std::size_t end : {0U, 1U}) {
        const int u = random.integer(-1, 2);
        const int v = random.integer(-1, 2);
        p[end] = p[2] + u * (p[3] - p[2]) + v * (p[4] - p[2]);
      }
    }
    const Three<Whole> n = (p[3] - p[2]).cross(p[4] - p[2]);
    const auto at = [&p](std::size_t k) { return Point(p[k].cast<double>()); };
    const bool met = contact::edge_meets_face(Segment<double>{at(0), at(1)}, {at(2), at(3), at(4)});
    if (n == Three<Whole>::Zero()) {
      REQUIRE_FALSE(met);
      continue;
    }
    INFO("case " << i);
    REQUIRE(met == meet_by_axes<Whole>({p[0], p[1]}, {p[2], p[3], p[4]}));
    ++seen[met];
  }
  CHECK(seen[true] > generators::tried(50000));
  CHECK(seen[false] > generators::tried(50000));
}

TEST_CASE("an edge that ends a last digit from a face is decided without error") {
  Random random(2);
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(3000); ++i) {
    std::array<Point, 5> p;
    for (Point& v : p) v = Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform()};
    const double u = random.chance(0.3) ? 0 : random.uniform();
    const double v = random.uniform(0, 1 - u);
    p[1] = p[2] + u * (p[3] - p[2]) + v * (p[4] - p[2]);  // on the face, as rounded
    if (i % 4 == 1) p[1] = 2 * p[1] - p[0];               // beyond it
    if (i % 4 == 2) p[0] = p[2] + 0.25 * (p[4] - p[2]);
    const double scale = i % 5 == 0 ? std::ldexp(1.0, random.integer(-900, 900)) : 1;
    for (Point& x : p) x *= scale;
    const bool met = contact::edge_meets_face(Segment<double>{p[0], p[1]}, {p[2], p[3], p[4]});
    INFO("case " << i);
    REQUIRE(met == polyhedra_truth::edge_meets_face({p[0], p[1]}, {p[2], p[3], p[4]}));
    ++seen[met];
  }
  CHECK(seen[true] > generators::tried(300));
  CHECK(seen[false] > generators::tried(300));
}

// ---------------------------------------------------------------- solids of cubes

/// A solid of cubes, moved by halves and then stretched along the axes.
struct Blocks {
  polycubes::Polycube cubes;
  Point offset, stretch;

  std::vector<contact::Aabb<double>> boxes() const {
    std::vector<contact::Aabb<double>> found;
    for (int i = 0; i < cubes.size; ++i) {
      for (int j = 0; j < cubes.size; ++j) {
        for (int k = 0; k < cubes.size; ++k) {
          if (!cubes.at(i, j, k)) continue;
          const Point low = Point(i, j, k) + offset, high = low + Point(1, 1, 1);
          found.push_back({stretch.cwiseProduct(low), stretch.cwiseProduct(high)});
        }
      }
    }
    return found;
  }
  Mesh<double> mesh(Random& random, const polycubes::Matrix& map) const {
    return polycubes::surface(random, cubes, map * stretch.asDiagonal(), offset);
  }
};

Blocks random_blocks(Random& random) {
  Blocks blocks;
  const int size = random.integer(1, 3);
  blocks.cubes = polycubes::random_polycube(random, size, random.uniform(0.1, 0.9));
  for (int k = 0; k < 3; ++k) {
    blocks.offset(k) = random.integer(-5, 3) / 2.0;
    blocks.stretch(k) = random.chance(0.3) ? 4 : 1;
  }
  return blocks;
}

/// Whether they have a point in common.
bool blocks_meet(const Blocks& a, const Blocks& b) {
  for (const auto& p : a.boxes()) {
    for (const auto& q : b.boxes()) {
      if ((p.low.array() <= q.high.array()).all() && (q.low.array() <= p.high.array()).all()) {
        return true;
      }
    }
  }
  return false;
}

TEST_CASE("solids of cubes meet where their cubes do, in either order of the tests") {
  Random random(3);
  std::map<DecidedBy, int> by;
  std::map<bool, int> seen;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Blocks a = random_blocks(random);
    const Blocks b = random_blocks(random);
    const polycubes::Matrix map = polycubes::random_map(random);
    const Mesh<double> first = a.mesh(random, map);
    const Mesh<double> second = b.mesh(random, map);
    const bool right = blocks_meet(a, b);
    INFO("case " << i);
    const PolyhedraTest test = contact::polyhedra_meet(first, second);
    REQUIRE(test.meet == right);
    REQUIRE(contact::polyhedra_meet(second, first).meet == right);
    REQUIRE(contact::polyhedra_meet(first, second, PolyhedraOrder::edges_first).meet == right);
    // Alone they miss some, and never find too many.
    for (const auto order : {PolyhedraOrder::vertices, PolyhedraOrder::edges}) {
      if (contact::polyhedra_meet(first, second, order).meet) REQUIRE(right);
    }
    const bool surfaces = contact::edges_meet_faces(first, second).has_value() ||
                          contact::edges_meet_faces(second, first).has_value();
    const bool inside = contact::vertices_inside(first, second).has_value() ||
                        contact::vertices_inside(second, first).has_value();
    REQUIRE(right == (surfaces || inside));
    ++by[test.decided_by];
    ++seen[right];
  }
  CHECK(seen[false] > generators::tried(500));
  CHECK(seen[true] > generators::tried(500));
  for (const auto decision : {DecidedBy::boxes, DecidedBy::vertex_of_a, DecidedBy::vertex_of_b,
                              DecidedBy::edge_of_a, DecidedBy::all}) {
    CHECK(by[decision] > 0);
  }
}

// ---------------------------------------------------------------- single pairs

Mesh<double> bar(int axis) {
  Point low(-1, -1, -1), high(1, 1, 1);
  low(axis) = -5;
  high(axis) = 5;
  return contact::box_mesh(low, high);
}

TEST_CASE("vertices alone miss crossed bars, edges alone miss a body inside") {
  const Mesh<double> x = bar(0), y = bar(1);
  CHECK(contact::polyhedra_meet(x, y, PolyhedraOrder::vertices).meet == false);
  CHECK(contact::polyhedra_meet(x, y).decided_by == DecidedBy::edge_of_a);
  CHECK(contact::polyhedra_meet(x, y, PolyhedraOrder::edges).meet);

  const Mesh<double> room = contact::box_mesh({-9, -9, -9}, {9, 9, 9});
  CHECK(contact::polyhedra_meet(x, room, PolyhedraOrder::edges).meet == false);
  CHECK(contact::polyhedra_meet(x, room).decided_by == DecidedBy::vertex_of_a);
  CHECK(contact::polyhedra_meet(room, x).decided_by == DecidedBy::vertex_of_b);
  const PolyhedraTest edges_first = contact::polyhedra_meet(room, x, PolyhedraOrder::edges_first);
  CHECK(edges_first.decided_by == DecidedBy::vertex_of_b);

  // Around the bar, not in it: a hollow room.
  const Mesh<double> hollow =
      contact::joined(room, contact::inside_out(contact::box_mesh({-8, -8, -8}, {8, 8, 8})));
  for (const auto order : {PolyhedraOrder::lecture, PolyhedraOrder::edges_first}) {
    const PolyhedraTest test = contact::polyhedra_meet(x, hollow, order);
    CHECK_FALSE(test.meet);
    CHECK(test.decided_by == DecidedBy::all);
  }
  // Two components, of which only the second is inside.
  const Mesh<double> far = contact::box_mesh({20, 0, 0}, {21, 1, 1});
  const Mesh<double> pair = contact::joined(far, contact::box_mesh({0, 0, 0}, {0.5, 0.5, 0.5}));
  CHECK(contact::polyhedra_meet(pair, room, PolyhedraOrder::edges_first).meet);
}

TEST_CASE("touching counts, a gap of one last digit does not") {
  const Mesh<double> a = contact::box_mesh({0, 0, 0}, {1, 1, 1});
  const double above = std::nextafter(1.0, 2.0);
  for (const double z : {1.0, above}) {
    // Face, edge and vertex contact; an octahedron's vertex on a face.
    const bool touches = z == 1;
    CHECK(contact::polyhedra_meet(a, contact::box_mesh({0.25, 0.25, z}, {0.5, 0.5, 2})).meet ==
          touches);
    CHECK(contact::polyhedra_meet(a, contact::box_mesh({-2, 1, z}, {2, 2, 2})).meet == touches);
    CHECK(contact::polyhedra_meet(a, contact::box_mesh({1, 1, z}, {2, 2, 2})).meet == touches);
    Mesh<double> ball = contact::octahedron_mesh(1);
    for (Point& v : ball.vertices) v += Point(0.5, 0.5, 2);
    ball.vertices[5].z() = z;
    for (const auto order : {PolyhedraOrder::lecture, PolyhedraOrder::edges_first}) {
      CHECK(contact::polyhedra_meet(a, ball, order).meet == touches);
    }
  }
}

TEST_CASE("pairs are named: the first edge and the first face") {
  const auto found = contact::edges_meet_faces(bar(0), bar(1));
  REQUIRE(found.has_value());
  CHECK(found->edge == std::array<int, 2>{0, 1});
  CHECK_FALSE(contact::vertices_inside(bar(0), bar(1)).has_value());
  CHECK(contact::vertices_inside(bar(0), contact::box_mesh({-9, -9, -9}, {9, 9, 9})) == 0);
}

TEST_CASE("no triangles, and coordinates that are not finite, meet nothing") {
  const Mesh<double> none;
  const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  for (const auto order : {PolyhedraOrder::lecture, PolyhedraOrder::edges_first,
                           PolyhedraOrder::vertices, PolyhedraOrder::edges}) {
    CHECK_FALSE(contact::polyhedra_meet(none, box, order).meet);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Mesh<double> broken = box;
      broken.vertices[3].y() = bad;
      CHECK_FALSE(contact::polyhedra_meet(broken, box, order).meet);
      CHECK_FALSE(contact::polyhedra_meet(box, broken, order).meet);
    }
  }
  // A vertex that no triangle uses does not count.
  Mesh<double> loose = contact::box_mesh({3, 3, 3}, {4, 4, 4});
  loose.vertices.push_back({0, 0, 0});
  CHECK_FALSE(contact::polyhedra_meet(loose, box).meet);
  CHECK(contact::polyhedra_meet(contact::rounded_mesh<float>(box),
                                contact::rounded_mesh<float>(bar(0)))
            .meet);
}

}  // namespace
