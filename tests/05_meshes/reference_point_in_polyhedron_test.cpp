// Where points are, relative to closed meshes: against cubes (no ray), against fractions, and
// against the other five axes.
#include <05_meshes/families.hpp>
#include <05_meshes/polycubes.hpp>
#include <05_meshes/polyhedra_truth.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/mesh_columns.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <map>

namespace {

using contact::Mesh;
using contact::MeshColumns;
using contact::MeshLocation;
using contact::MeshTree;
using contact::Triangle;
using contact::Vector3;
using contact::Where;
using generators::Random;
using polycubes::Point;

// ---------------------------------------------------------------- views

/// The mesh and the point with x, y and z exchanged in a cycle.
Point cycled(const Point& p, int by) { return {p(by % 3), p((by + 1) % 3), p((by + 2) % 3)}; }
Mesh<double> cycled(Mesh<double> mesh, int by) {
  for (Point& v : mesh.vertices) v = cycled(v, by);
  return mesh;
}
Point mirrored(const Point& p) { return {p.x(), p.y(), -p.z()}; }
Mesh<double> mirrored(Mesh<double> mesh) {
  for (Point& v : mesh.vertices) v = mirrored(v);
  return contact::inside_out(mesh);
}

/// A mesh as seen along the six axes.
struct SixViews {
  std::vector<MeshColumns<double>> meshes;
  explicit SixViews(const Mesh<double>& mesh) {
    for (int by = 0; by < 3; ++by) {
      meshes.emplace_back(cycled(mesh, by));
      meshes.emplace_back(mirrored(cycled(mesh, by)));
    }
  }
  static Point view(const Point& p, std::size_t i) {
    const Point q = cycled(p, static_cast<int>(i / 2));
    return i % 2 == 0 ? q : mirrored(q);
  }
};

Mesh<double> scaled(Mesh<double> mesh, double by) {
  for (Point& v : mesh.vertices) v *= by;
  return mesh;
}

// ---------------------------------------------------------------- cubes

TEST_CASE("points in solids of cubes are located without error") {
  Random random(1);
  std::map<Where, int> seen;
  for (int i = 0; i < generators::tried(1500); ++i) {
    const int size = random.integer(1, 4);
    const auto cubes = polycubes::random_polycube(random, size, random.uniform(0.2, 0.9));
    const polycubes::Matrix map = polycubes::random_map(random);
    const double scale = i % 4 == 0 ? std::ldexp(1.0, random.integer(-500, 500)) : 1.0;
    const Mesh<double> mesh = scaled(polycubes::surface(random, cubes, map, Point::Zero()), scale);
    const MeshColumns<double> columns(mesh);
    for (int k = 0; k < 100; ++k) {
      const Point q = polycubes::random_point(random, size);
      const Point p = map * q * scale;
      const Where right = polycubes::where(cubes, q);
      INFO("case " << i << ", point " << k << ": " << p.transpose());
      const MeshLocation found = contact::locate_in_mesh(p, columns);
      REQUIRE(found.where == right);
      REQUIRE(found.winding == (right == Where::inside ? 1 : 0));
      REQUIRE(contact::locate_in_mesh(p, columns.tree()) == found);
      if (k < 20) REQUIRE(contact::locate_in_mesh(p, mesh) == found);
      ++seen[right];
    }
  }
  for (const auto where : {Where::inside, Where::on, Where::outside}) {
    CHECK(seen[where] > generators::tried(8000));
  }
}

TEST_CASE("points of floats in solids of cubes are located without error") {
  Random random(2);
  for (int i = 0; i < generators::tried(300); ++i) {
    const int size = random.integer(1, 3);
    const auto cubes = polycubes::random_polycube(random, size, random.uniform(0.2, 0.9));
    const polycubes::Matrix map = polycubes::random_map(random);
    const Mesh<float> mesh =
        contact::rounded_mesh<float>(polycubes::surface(random, cubes, map, Point::Zero()));
    const MeshColumns<float> columns(mesh);
    for (int k = 0; k < 50; ++k) {
      const Point q = polycubes::random_point(random, size);
      const Vector3<float> p = (map * q).cast<float>();
      REQUIRE(contact::locate_in_mesh(p, columns).where == polycubes::where(cubes, q));
      REQUIRE(contact::locate_in_mesh(p, columns.tree()) == contact::locate_in_mesh(p, columns));
      REQUIRE(contact::locate_in_mesh(p, mesh) == contact::locate_in_mesh(p, columns));
    }
  }
}

// ---------------------------------------------------------------- six axes, fractions

using Family = mesh_families::PointAt (*)(Random&);
constexpr Family families[] = {mesh_families::point_random,       mesh_families::point_level,
                               mesh_families::point_under_edge,   mesh_families::point_on_surface,
                               mesh_families::point_near_surface, mesh_families::point_far};

/// The point, with one coordinate moved by one double, every third time.
Point perhaps_moved(Random& random, Point p) {
  if (!random.chance(1.0 / 3)) return p;
  const int k = random.integer(0, 2);
  p(k) = std::nextafter(p(k), random.chance(0.5) ? 1e9 : -1e9);
  return p;
}

TEST_CASE("rays along all six axes find the same winding number") {
  Random random(3);
  std::map<const mesh_families::Body*, SixViews> views;
  std::map<Where, int> seen;
  for (int i = 0; i < generators::tried(60000); ++i) {
    const mesh_families::PointAt at = families[std::size_t(i) % std::size(families)](random);
    const Point p = perhaps_moved(random, at.point.cast<double>());
    const auto& six = views.try_emplace(at.body, at.body->in_double).first->second;
    const MeshLocation first = contact::locate_in_mesh(p, six.meshes[0].tree().mesh());
    INFO("case " << i << ": " << p.transpose());
    for (std::size_t v = 0; v < 6; ++v) {
      const Point q = SixViews::view(p, v);
      REQUIRE(contact::locate_in_mesh(q, six.meshes[v]) == first);
      REQUIRE(contact::locate_in_mesh(q, six.meshes[v].tree()) == first);
    }
    ++seen[first.where];
  }
  for (const auto where : {Where::inside, Where::on, Where::outside}) {
    CHECK(seen[where] > generators::tried(3000));
  }
}

TEST_CASE("the location is that of a ray in fractions that meets no edge") {
  Random random(4);
  for (int i = 0; i < generators::tried(1200); ++i) {
    const mesh_families::PointAt at = families[std::size_t(i) % std::size(families)](random);
    const Point p = perhaps_moved(random, at.point.cast<double>());
    const Mesh<double>& mesh = at.body->in_double;
    const std::optional<int> right = polyhedra_truth::winding(random, p, mesh);
    const MeshLocation found = contact::locate_in_mesh(p, mesh);
    INFO("case " << i << ": " << p.transpose());
    REQUIRE((found.where == Where::on) == !right.has_value());
    REQUIRE(found.winding == right.value_or(0));
  }
}

TEST_CASE("extreme scales change no location") {
  Random random(5);
  const Mesh<double> star = contact::star_mesh(0.5, 1, 0);
  for (const int power : {-1040, -1000, -500, 0, 500, 1000}) {
    const Mesh<double> mesh = scaled(star, std::ldexp(1.0, power));
    const MeshColumns<double> columns(mesh);
    for (int i = 0; i < generators::tried(240); ++i) {
      Point p = mesh_families::any_vertex(random, mesh);
      if (i % 3 != 0) p(random.integer(0, 2)) *= random.uniform(-1, 1);
      const std::optional<int> right = polyhedra_truth::winding(random, p, mesh);
      const MeshLocation found = contact::locate_in_mesh(p, mesh);
      INFO("2^" << power << ", case " << i);
      REQUIRE((found.where == Where::on) == !right.has_value());
      REQUIRE(found.winding == right.value_or(0));
      REQUIRE(contact::locate_in_mesh(p, columns) == found);
      REQUIRE(contact::locate_in_mesh(p, columns.tree()) == found);
    }
  }
}

TEST_CASE("columns and the tree locate points as all triangles do, in large and odd meshes") {
  constexpr double most = std::numeric_limits<double>::max();
  std::vector<Mesh<double>> meshes{
      contact::ball_mesh(1, 4),
      contact::torus_mesh(0.7, 0.3, 60, 30),
      contact::star_mesh(0.5, 1, 2),
      contact::box_mesh({-most, -most, -most}, {most, most, most}),
      contact::box_mesh({1, 1, 1}, {1 + 0x1p-52, 1 + 0x1p-52, 1 + 0x1p-51}),
      contact::box_mesh({0, 0, 0}, {5e-324, 1e-323, 5e-324}),
      contact::box_mesh({-1e300, -5e-324, -1}, {1e300, 5e-324, 1})};
  Mesh<double> far = contact::ball_mesh(1, 3);  // columns thinner than the spacing of numbers
  for (Point& v : far.vertices) v += Point(0x1p51, -0x1p50, 0x1p49);
  meshes.push_back(far);
  Mesh<double> flat = contact::ball_mesh(1, 2);
  for (Point& v : flat.vertices) v.x() = 0.5;
  meshes.push_back(flat);
  // 200 long triangles on end: a column lists most of them, and the tree is asked.
  Mesh<double> fan = contact::box_mesh({-4, -4, -4}, {4, 4, 4});
  for (int i = 0; i < 50; ++i) {
    const Mesh<double> thin{{{-3, -3, i / 50.0}, {3, -3, 0.5}, {-3, 3, i / 40.0}, {3, 3, -2}},
                            {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    fan = contact::joined(fan, thin);
  }
  meshes.push_back(fan);
  Random random(11);
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const Mesh<double>& mesh = meshes[m];
    const MeshColumns<double> columns(mesh);
    for (int i = 0; i < generators::tried(2000); ++i) {
      Point p = mesh_families::any_vertex(random, mesh);
      const Point q = mesh_families::any_vertex(random, mesh);
      const double share = random.integer(0, 8) / 8.0;
      if (i % 4 == 1) p = p * (1 - share) + q * share;
      if (i % 4 == 2) p(random.integer(0, 2)) = q(random.integer(0, 2));
      if (i % 4 == 3) p(random.integer(0, 2)) *= random.uniform(-1, 1);
      p = perhaps_moved(random, p);
      INFO("mesh " << m << ", case " << i << ": " << p.transpose());
      const MeshLocation right = contact::locate_in_mesh(p, mesh);
      REQUIRE(contact::locate_in_mesh(p, columns.tree()) == right);
      REQUIRE(contact::locate_in_mesh(p, columns) == right);
    }
  }
}

// ---------------------------------------------------------------- what meshes mean

TEST_CASE("shells add up, and the rule says which of them are inside") {
  const Mesh<double> large = contact::box_mesh({-2, -2, -2}, {2, 2, 2});
  const Mesh<double> small = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  const Mesh<double> twice = contact::joined(large, small);
  CHECK(contact::locate_in_mesh<double>({0, 0, 0}, twice) == MeshLocation{Where::inside, 2});
  CHECK(contact::locate_in_mesh<double>({0, 0, 0}, twice, contact::Rule::even_odd) ==
        MeshLocation{Where::outside, 2});
  const Mesh<double> hollow = contact::joined(large, contact::inside_out(small));
  CHECK(contact::locate_in_mesh<double>({0, 0, 0}, hollow) == MeshLocation{Where::outside, 0});
  CHECK(contact::locate_in_mesh<double>({1, 0, 0}, hollow) == MeshLocation{Where::on, 0});
  CHECK(contact::locate_in_mesh<double>({1.5, 0, 0}, hollow) == MeshLocation{Where::inside, 1});
  CHECK(contact::locate_in_mesh<double>({1.5, 0, 0}, contact::inside_out(hollow)) ==
        MeshLocation{Where::inside, -1});
  // Two boxes that share a face: on it, although both sides are inside.
  const Mesh<double> pair = contact::joined(small, contact::box_mesh({1, -1, -1}, {3, 1, 1}));
  CHECK(contact::locate_in_mesh<double>({1, 0.5, 0.25}, pair).where == Where::on);
  CHECK(contact::locate_in_mesh<double>({0.999, 0.5, 0.25}, pair).where == Where::inside);
}

TEST_CASE("no triangles, NaN and infinities are outside; flat meshes have no inside") {
  const Mesh<double> none;
  const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(contact::locate_in_mesh<double>({0, 0, 0}, none) == MeshLocation{});
  CHECK(contact::locate_in_mesh<double>({0, 0, 0}, MeshTree<double>(none)) == MeshLocation{});
  for (const double bad : {nan, infinity, -infinity}) {
    for (int k = 0; k < 3; ++k) {
      Point p(0, 0, 0);
      p(k) = bad;
      CHECK(contact::locate_in_mesh(p, box) == MeshLocation{});
      CHECK(contact::locate_in_mesh(p, MeshTree<double>(box)) == MeshLocation{});
      CHECK(contact::in_convex(p, box) == Where::outside);
      CHECK(contact::in_convex_by_planes(p, box) == Where::outside);
      CHECK(contact::in_by_parity(p, box) == Where::outside);
      CHECK(contact::in_by_random_rays(p, box).where == Where::outside);
      CHECK_FALSE(contact::winding_by_solid_angles(p, box).certain().has_value());
      Mesh<double> broken = box;
      broken.vertices[7](k) = bad;
      (void)contact::locate_in_mesh<double>({0.5, 0.25, 0}, broken);
      (void)contact::in_convex<double>({0.5, 0.25, 0}, broken);
    }
  }
  CHECK(contact::in_convex<double>({0, 0, 0}, none) == Where::outside);
  CHECK(contact::in_convex_by_planes<double>({0, 0, 0}, none) == Where::outside);
  CHECK(contact::winding_by_solid_angles<double>({0, 0, 0}, none).certain() == 0);
  // A triangle and its back: closed, without volume.
  const Mesh<double> flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  CHECK(contact::locate_in_mesh<double>({0.25, 0.25, 0}, flat).where == Where::on);
  CHECK(contact::locate_in_mesh<double>({0.25, 0.25, -1}, flat) == MeshLocation{});
  CHECK(contact::locate_in_mesh<double>({1, 1, 0}, flat) == MeshLocation{});
  // A triangle without area is a segment.
  const Mesh<double> segment{{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}, {{0, 1, 2}}};
  CHECK(contact::locate_in_mesh<double>({1.5, 1.5, 1.5}, segment).where == Where::on);
  CHECK(contact::locate_in_mesh<double>({3, 3, 3}, segment).where == Where::outside);
  CHECK(contact::locate_in_mesh<double>({1, 1, 0}, segment) == MeshLocation{});
}

// ---------------------------------------------------------------- the other methods

TEST_CASE("planes decide convex polyhedra exactly, and call most of a concave one outside") {
  Random random(6);
  std::map<Where, int> seen;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const mesh_families::Body& body = mesh_families::any(random, mesh_families::convex());
    const Mesh<double>& mesh = body.in_double;
    Point p = mesh_families::near_body(random, body, 1);
    if (i % 4 == 1) p = mesh_families::any_vertex(random, mesh);
    if (i % 4 == 2) p = mesh_families::on_edge(random, mesh);
    if (i % 4 == 3) p = mesh_families::on_face(random, mesh);
    p = perhaps_moved(random, p);
    const Where right = contact::locate_in_mesh(p, mesh).where;
    REQUIRE(contact::in_convex(p, mesh) == right);
    ++seen[right];
  }
  for (const auto where : {Where::inside, Where::on, Where::outside}) {
    CHECK(seen[where] > generators::tried(1000));
  }
  // One cube, mapped: its faces are pairs of coplanar triangles.
  for (int i = 0; i < generators::tried(300); ++i) {
    const auto cube = polycubes::random_polycube(random, 1, 1);
    const polycubes::Matrix map = polycubes::random_map(random);
    const Mesh<double> mesh = polycubes::surface(random, cube, map, Point::Zero());
    for (int k = 0; k < 20; ++k) {
      const Point q = polycubes::random_point(random, 1);
      REQUIRE(contact::in_convex<double>(map * q, mesh) == polycubes::where(cube, q));
    }
  }
  const Mesh<double> corner =
      contact::prism_mesh({{-2, -2}, {2, -2}, {2, 0}, {0, 0}, {0, 2}, {-2, 2}}, -1, 1);
  CHECK(contact::locate_in_mesh<double>({1, -1, 0}, corner).where == Where::inside);
  CHECK(contact::in_convex<double>({1, -1, 0}, corner) == Where::outside);
  CHECK(contact::in_convex_by_planes<double>({1, -1, 0}, corner) == Where::outside);
  CHECK(contact::in_convex<double>({-1, -1, 0}, corner) == Where::inside);
}

TEST_CASE("rounded planes lose their digits far from the origin") {
  Random random(7);
  const Point far(0x1.8p44, -0x1.4p44, 0x1.2p44);
  Mesh<double> mesh = contact::ball_mesh(1, 0);
  for (Point& v : mesh.vertices) v += far;
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    p += far;
    const Where right = contact::in_convex(p, mesh);
    REQUIRE(right == contact::locate_in_mesh(p, mesh).where);
    if (contact::in_convex_by_planes(p, mesh) != right) ++wrong;
  }
  CHECK(wrong > 0);
}

TEST_CASE("parity is wrong where the ray meets an edge or a vertex, and right elsewhere") {
  const Mesh<double> ball = contact::octahedron_mesh(1);
  CHECK(contact::crossings_by_triangles<double>({0, 0, 0}, ball, {1, 0, 0}) == 4);
  CHECK(contact::crossings_by_triangles<double>({0.25, 0.25, 0}, ball, {1, 0, 0}) == 2);
  CHECK(contact::in_by_parity<double>({0, 0, 0}, ball) == Where::outside);
  CHECK(contact::in_by_parity<double>({0, 0, 0}, ball, {3, 2, 1}) == Where::inside);
  Random random(8);
  int asked = 0;
  for (int i = 0; i < generators::tried(10000); ++i) {
    const mesh_families::PointAt at = mesh_families::point_random(random);
    const Point p = at.point.cast<double>();
    const Mesh<double>& mesh = at.body->in_double;
    const MeshLocation right = contact::locate_in_mesh(p, mesh);
    if (right.where == Where::on) continue;
    ++asked;
    REQUIRE(contact::in_by_parity<double>(p, mesh, {0.3, 0.5, 0.7}) == right.where);
    const contact::RandomRays by_rays = contact::in_by_random_rays(p, mesh);
    REQUIRE(by_rays.where == right.where);
    REQUIRE(by_rays.cast >= 3);
  }
  CHECK(asked > generators::tried(9000));
}

// ---------------------------------------------------------------- solid angles

template <class S>
void check_solid_angles(int count, std::uint64_t seed) {
  Random random(seed);
  int certain = 0, off_surface = 0;
  for (int i = 0; i < generators::tried(count); ++i) {
    const mesh_families::PointAt at = families[std::size_t(i) % std::size(families)](random);
    const Vector3<S> p = at.point.template cast<S>();
    Mesh<S> mesh;
    if constexpr (std::is_same_v<S, float>) {
      mesh = at.body->in_float;
    } else {
      mesh = at.body->in_double;
    }
    const MeshLocation right = contact::locate_in_mesh(p, mesh);
    const contact::SolidAngleWinding sum = contact::winding_by_solid_angles(p, mesh);
    INFO("case " << i << ": " << sum.winding << " ± " << sum.bound);
    if (right.where == Where::on) {
      REQUIRE_FALSE(sum.certain().has_value());
      continue;
    }
    ++off_surface;
    REQUIRE(std::abs(sum.winding - right.winding) <= sum.bound);
    if (!sum.certain()) continue;
    ++certain;
    REQUIRE(*sum.certain() == right.winding);
    REQUIRE(contact::where_by_solid_angles(p, mesh) == right.where);
  }
  CHECK(certain > off_surface / 2);
}

TEST_CASE("the bound of the solid angles holds") {
  check_solid_angles<double>(12000, 9);
  check_solid_angles<float>(12000, 10);
}

TEST_CASE("solid angles are certain at a thousand roundings from a face, and never on it") {
  const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  for (int power = -52; power < -10; ++power) {
    const Point p(0.25, 0.125, 1 - std::ldexp(1.0, power));
    const auto sum = contact::winding_by_solid_angles(p, box);
    INFO("2^" << power);
    if (power >= -43) CHECK(sum.certain() == 1);
    CHECK(std::abs(sum.winding - 1) <= sum.bound);
  }
  for (const Point& p : {Point(0.25, 0.125, 1), Point(1, 1, 0.5), Point(1, 1, 1)}) {
    CHECK_FALSE(contact::winding_by_solid_angles(p, box).certain().has_value());
  }
}

}  // namespace
