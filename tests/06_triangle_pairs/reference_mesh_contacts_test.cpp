#include <05_meshes/lines_at_meshes.hpp>
#include <06_triangle_pairs/common_points_truth.hpp>
#include <algorithm>
#include <contact/mesh_contacts.hpp>
#include <limits>
#include <set>
#include <tuple>

namespace mesh_contacts_test {

using contact::ContactKind;
using contact::contacts_of_pairs;
using contact::FeatureKind;
using contact::Mesh;
using contact::mesh_contacts;
using contact::MeshContact;
using contact::MeshTree;
using contact::NamedFeature;
using generators::Random;
using oracle::Rational;
using Point = contact::Vector3<double>;
using Contacts = std::vector<MeshContact<double>>;

Mesh<double> cube(const Point& low) { return contact::box_mesh(low, low + Point(4, 4, 4)); }
/// A pyramid with its apex below, over a square of side 2.
Mesh<double> pyramid(const Point& apex) {
  Mesh<double> mesh{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}, {0, 0, 0}},
                    {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}, {0, 1, 2}, {0, 2, 3}}};
  return contact::translated<double>(mesh, apex);
}

/// How many contacts there are of each kind: p2p, p2e, p2f, e2e, e2f, f2f.
using Kinds = std::array<int, 6>;
Kinds kinds(const Contacts& contacts) {
  Kinds count{};
  for (const auto& contact : contacts) ++count[static_cast<std::size_t>(contact.kind())];
  return count;
}
Kinds kinds(const Mesh<double>& a, const Mesh<double>& b) { return kinds(mesh_contacts(a, b)); }

TEST_CASE("a cube on a cube has the contacts that one counts by hand") {
  const Mesh<double> below = cube({0, 0, 0});
  CHECK(kinds(below, cube({0, 0, 4})) == Kinds{4, 0, 0, 0, 0, 0});  // exactly on it
  CHECK(kinds(below, cube({1, 2, 4})) == Kinds{0, 0, 2, 2, 0, 0});  // moved along two edges
  CHECK(kinds(below, cube({2, 0, 4})) == Kinds{0, 4, 0, 0, 0, 0});  // along one edge
  CHECK(kinds(below, cube({4, 0, 4})) == Kinds{2, 0, 0, 0, 0, 0});  // a whole edge
  CHECK(kinds(below, cube({4, 1, 4})) == Kinds{0, 2, 0, 0, 0, 0});  // edges of one line
  CHECK(kinds(below, cube({4, 4, 4})) == Kinds{1, 0, 0, 0, 0, 0});  // a vertex
  CHECK(kinds(below, cube({0, 0, 5})) == Kinds{});                  // above it
  CHECK(kinds(below, cube({1, 1, 2})) == Kinds{0, 0, 0, 0, 6, 0});  // inside each other
  CHECK(kinds(below, cube({0, 0, 0})) == Kinds{8, 0, 0, 0, 0, 0});  // the same
}

TEST_CASE("bodies on a cube have the contacts that one counts by hand") {
  const Mesh<double> below = cube({0, 0, 0});
  const auto box = [](const Point& low, const Point& high) { return contact::box_mesh(low, high); };
  CHECK(kinds(below, box({1, 1, 4}, {3, 3, 5})) == Kinds{0, 0, 4, 0, 0, 0});    // a small box
  CHECK(kinds(box({1, 1, 4}, {3, 3, 5}), below) == Kinds{0, 0, 4, 0, 0, 0});    // under it
  CHECK(kinds(below, box({-1, -1, 4}, {5, 5, 5})) == Kinds{0, 0, 4, 0, 0, 0});  // a plate
  CHECK(kinds(below, box({-1, 1, 4}, {5, 3, 5})) == Kinds{0, 0, 0, 4, 0, 0});   // a bar
  CHECK(kinds(below, box({-1, 1, 3}, {5, 3, 5})) == Kinds{0, 0, 0, 0, 8, 0});   // through it
  CHECK(kinds(below, pyramid({2, 2, 4})) == Kinds{0, 0, 1, 0, 0, 0});  // an apex, on a diagonal
  CHECK(kinds(below, pyramid({1, 2, 4})) == Kinds{0, 0, 1, 0, 0, 0});  // an apex, beside it
  CHECK(kinds(below, pyramid({2, 0, 4})) == Kinds{0, 1, 0, 0, 0, 0});  // an apex, on an edge
  CHECK(kinds(below, pyramid({2, 2, 3})) == Kinds{0, 0, 0, 0, 4, 0});  // an apex through a face
  const Mesh<double> roof = contact::prism_mesh({{-1, 0}, {0, -1}, {1, 0}}, 1, 3);
  Mesh<double> keel = roof;  // an edge below, along x
  for (Point& v : keel.vertices) v = Point(v.z(), v.x() + 2, v.y() + 5);
  CHECK(kinds(below, keel) == Kinds{0, 0, 2, 0, 0, 0});  // an edge on a face
  CHECK(kinds(below, contact::translated<double>(keel, {2, 0, 0})) ==
        Kinds{0, 0, 1, 1, 0, 0});  // over the border
  CHECK(kinds(below, contact::translated<double>(keel, {0, -2, 0})) ==
        Kinds{0, 2, 0, 0, 0, 0});  // along an edge
}

TEST_CASE("each pair of triangles finds a contact again, and once it is in the list") {
  const Mesh<double> below = cube({0, 0, 0});
  // Four triangles at the apex times two of the square, on its diagonal.
  CHECK(contacts_of_pairs(below, pyramid({2, 2, 4})).size() == 8);
  CHECK(mesh_contacts(below, pyramid({2, 2, 4})).size() == 1);
  // Beside the diagonal, in one triangle of the square.
  CHECK(contacts_of_pairs(below, pyramid({1, 2, 4})).size() == 4);
}

TEST_CASE("contacts have the names of their features and exact vertices") {
  const Contacts found = mesh_contacts(cube({0, 0, 0}), cube({1, 2, 4}));
  REQUIRE(found.size() == 4);
  // Vertex i has the high x if bit 0 of i is set, y if bit 1 is, z if bit 2 is.
  CHECK(found[0].of_first == NamedFeature{FeatureKind::vertex, {7, -1, -1}});
  CHECK(found[0].of_second.kind == FeatureKind::face);
  CHECK(found[0].position == Point(4, 4, 4));
  CHECK(found[0].bound == 0);
  CHECK(found[1].of_first == NamedFeature{FeatureKind::edge, {5, 7, -1}});
  CHECK(found[1].of_second == NamedFeature{FeatureKind::edge, {0, 1, -1}});
  CHECK((found[1].position - Point(4, 2, 4)).cwiseAbs().maxCoeff() <= found[1].bound);
  CHECK(found[2].of_first == NamedFeature{FeatureKind::edge, {6, 7, -1}});
  CHECK(found[2].of_second == NamedFeature{FeatureKind::edge, {0, 2, -1}});
  CHECK((found[2].position - Point(1, 4, 4)).cwiseAbs().maxCoeff() <= found[2].bound);
  CHECK(found[3].of_first.kind == FeatureKind::face);
  CHECK(found[3].of_second == NamedFeature{FeatureKind::vertex, {0, -1, -1}});
  CHECK(found[3].position == Point(1, 2, 4));
}

// ---------------------------------------------------------------- in fractions

/// A contact without the names of faces, which only the reference has.
struct True {
  NamedFeature of_first, of_second;
  oracle::Vector position;
  auto key() const {
    return std::tie(of_first, of_second, position.x(), position.y(), position.z());
  }
  friend bool operator<(const True& p, const True& q) { return p.key() < q.key(); }
};
NamedFeature without_face(const NamedFeature& feature) {
  return feature.kind == FeatureKind::face ? NamedFeature{} : feature;
}

/// A mesh in fractions, which does not touch itself.
class TrueMesh {
 public:
  explicit TrueMesh(const Mesh<double>& mesh) : mesh_(mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      triangles_.push_back(common_points_truth::vertices(contact::triangle_of(mesh, i)));
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) add_edge(i, k);
    }
  }
  const auto& triangles() const { return triangles_; }
  const auto& edges() const { return edges_; }
  oracle::Vector vertex(int v) const {
    return oracle::exact(mesh_.vertices[static_cast<std::size_t>(v)]);
  }
  int vertices() const { return static_cast<int>(mesh_.vertices.size()); }

  /// The smallest feature that contains x.
  std::optional<NamedFeature> name(const oracle::Vector& x) const {
    std::optional<NamedFeature> smallest;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const auto feature = common_points_truth::feature_at(x, triangles_[i]);
      if (!feature) continue;
      const auto& t = mesh_.triangles[i];
      const auto k = static_cast<std::size_t>(feature->index);
      NamedFeature named;
      if (feature->kind == FeatureKind::vertex) named = {FeatureKind::vertex, {t[k], -1, -1}};
      if (feature->kind == FeatureKind::edge) {
        const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
        if (edges_.contains({low, high})) named = {FeatureKind::edge, {low, high, -1}};
      }
      if (!smallest || named < *smallest) smallest = named;
    }
    return smallest;
  }

 private:
  const Mesh<double>& mesh_;
  std::vector<common_points_truth::Vertices> triangles_;
  std::set<std::array<int, 2>> edges_;  ///< those that are not flat

  /// Adds edge k of triangle i if the other triangle is in another plane.
  void add_edge(std::size_t i, std::size_t k) {
    const auto& t = mesh_.triangles[i];
    const auto& at = triangles_[i];
    const int from = t[k], to = t[(k + 1) % 3];
    const oracle::Vector normal = (at[1] - at[0]).cross(at[2] - at[0]);
    for (const auto& other : mesh_.triangles) {
      for (std::size_t l = 0; l < 3; ++l) {
        if (other[l] != to || other[(l + 1) % 3] != from) continue;
        if (normal.dot(vertex(other[(l + 2) % 3]) - at[0]) == 0) continue;
        edges_.insert({std::min(from, to), std::max(from, to)});
      }
    }
  }
};

/// Where edges of one mesh cross planes of triangles of the other.
template <class Add>
void edges_through_faces(const TrueMesh& a, const TrueMesh& b, const Add& add) {
  for (const auto& [from, to] : a.edges()) {
    const oracle::Vector start = a.vertex(from), step = a.vertex(to) - start;
    for (const auto& t : b.triangles()) {
      const oracle::Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
      const Rational rate = normal.dot(step);
      if (rate == 0) continue;
      const Rational along = normal.dot(t[0] - start) / rate;
      if (along <= 0 || along >= 1) continue;
      const oracle::Vector x = start + step * along;
      if (common_points_truth::feature_at(x, t)) add(x);
    }
  }
}
/// Where edges cross that are not parallel.
template <class Add>
void edges_through_edges(const TrueMesh& a, const TrueMesh& b, const Add& add) {
  for (const auto& [p, q] : a.edges()) {
    for (const auto& [r, s] : b.edges()) {
      const oracle::Vector e = a.vertex(q) - a.vertex(p), f = b.vertex(s) - b.vertex(r);
      const oracle::Vector between = b.vertex(r) - a.vertex(p), normal = e.cross(f);
      const Rational whole = normal.dot(normal);
      if (whole == 0 || normal.dot(between) != 0) continue;
      const Rational of_e = normal.dot(between.cross(f)) / whole;
      const Rational of_f = normal.dot(between.cross(e)) / whole;
      if (of_e <= 0 || of_e >= 1 || of_f <= 0 || of_f >= 1) continue;
      add(oracle::Vector(a.vertex(p) + e * of_e));
    }
  }
}

std::set<True> true_contacts(const Mesh<double>& first, const Mesh<double>& second) {
  const TrueMesh a(first), b(second);
  std::set<True> contacts;
  const auto add = [&](const oracle::Vector& x) {
    const auto f = a.name(x), g = b.name(x);
    if (f && g) contacts.insert({*f, *g, x});
  };
  for (int v = 0; v < a.vertices(); ++v) add(a.vertex(v));
  for (int v = 0; v < b.vertices(); ++v) add(b.vertex(v));
  edges_through_faces(a, b, add);
  edges_through_faces(b, a, add);
  edges_through_edges(a, b, add);
  return contacts;
}

/// A body with whole coordinates: a box, an octahedron, a concave prism, a pyramid or a star.
Mesh<double> any_body(Random& random) {
  const auto in = [&random](int low, int high) { return double(random.integer(low, high)); };
  Mesh<double> mesh;
  switch (random.integer(0, 4)) {
    case 0: {
      const double x = in(1, 4), y = in(1, 4), z = in(1, 4);
      mesh = contact::box_mesh({0, 0, 0}, {x, y, z});
      break;
    }
    case 1:
      mesh = contact::octahedron_mesh(in(1, 3));
      break;
    case 2:
      mesh = contact::prism_mesh({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 0, in(1, 3));
      break;
    case 3:
      mesh = pyramid({in(0, 1), 0, 0});
      break;
    default:
      mesh = contact::prism_mesh({{0, 0}, {2, 1}, {4, 0}, {3, 2}, {4, 4}, {2, 3}, {0, 4}, {1, 2}},
                                 0, in(1, 3));
  }
  const int turns = random.integer(0, 2);
  for (Point& v : mesh.vertices) {
    for (int i = 0; i < turns; ++i) v = Point(v.z(), v.x(), v.y());
  }
  const double x = in(-2, 2), y = in(-2, 2), z = in(-2, 2);
  return contact::translated<double>(mesh, {x, y, z});
}

TEST_CASE("the contacts of bodies that touch, overlap or cross are right in fractions") {
  Random random(11);
  Kinds all{};
  for (int m = 0; m < generators::tried(160); ++m) {
    INFO("bodies " << m);
    const Mesh<double> a = any_body(random), b = any_body(random);
    const std::set<True> right = true_contacts(a, b);
    const Contacts found = mesh_contacts(a, b);
    REQUIRE(found.size() == right.size());
    for (const auto& contact : found) {
      const NamedFeature f = without_face(contact.of_first), g = without_face(contact.of_second);
      const Rational bound = oracle::exact(contact.bound);
      const auto near = std::count_if(right.begin(), right.end(), [&](const True& one) {
        const oracle::Vector off = one.position - oracle::exact(contact.position);
        return one.of_first == f && one.of_second == g && abs(off.x()) <= bound &&
               abs(off.y()) <= bound && abs(off.z()) <= bound;
      });
      REQUIRE(near == 1);
      const bool is_vertex = f.kind == FeatureKind::vertex || g.kind == FeatureKind::vertex;
      REQUIRE(contact.bound <= (is_vertex ? 0 : 1e-10));
    }
    for (std::size_t k = 0; k < 6; ++k) all[k] += kinds(found)[k];
  }
  for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] > 0);
  CHECK(all[5] == 0);
}

// ---------------------------------------------------------------- what must not matter

/// What is left of a contact if vertices are numbered otherwise.
std::vector<std::array<double, 5>> nameless(const Contacts& contacts) {
  std::vector<std::array<double, 5>> all;
  for (const auto& c : contacts) {
    all.push_back({double(c.kind()), c.position.x(), c.position.y(), c.position.z(), c.bound});
  }
  std::sort(all.begin(), all.end());
  return all;
}
/// The same triangles in another order, each beginning with another vertex, some reversed.
Mesh<double> reordered(Random& random, Mesh<double> mesh) {
  for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
    const auto k = static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1));
    std::swap(mesh.triangles[i - 1], mesh.triangles[k]);
  }
  for (auto& t : mesh.triangles) {
    std::rotate(t.begin(), t.begin() + random.integer(0, 2), t.end());
    if (random.chance(0.5)) std::swap(t[1], t[2]);
  }
  return mesh;
}
std::array<Mesh<double>, 2> two_tori(double shift) {
  const Mesh<double> torus = contact::torus_mesh(1, 0.4, 24, 12);
  Mesh<double> other = torus;
  for (Point& v : other.vertices) v = Point(v.z() + shift, v.x() + shift / 2, v.y() - shift / 4);
  return {torus, other};
}

TEST_CASE("the order of triangles and of their vertices changes no contact") {
  Random random(12);
  for (int m = 0; m < generators::tried(100); ++m) {
    const auto [a, b] =
        m % 10 == 0 ? two_tori(0.7) : std::array{any_body(random), any_body(random)};
    const auto right = nameless(mesh_contacts(a, b));
    REQUIRE(nameless(mesh_contacts(reordered(random, a), reordered(random, b))) == right);
  }
}

TEST_CASE("a soup has the contacts of the mesh that it was") {
  Random random(13);
  for (int m = 0; m < generators::tried(100); ++m) {
    const auto [a, b] =
        m % 10 == 0 ? two_tori(0.7) : std::array{any_body(random), any_body(random)};
    const auto right = nameless(mesh_contacts(a, b));
    REQUIRE(nameless(mesh_contacts(contact::triangle_soup(a), contact::triangle_soup(b))) == right);
    REQUIRE(contacts_of_pairs(contact::triangle_soup(a), contact::triangle_soup(b)).size() ==
            contacts_of_pairs(a, b).size());
  }
}

TEST_CASE("two meshes swapped have the same contacts with their features swapped") {
  Random random(14);
  for (int m = 0; m < generators::tried(100); ++m) {
    const auto [a, b] =
        m % 10 == 0 ? two_tori(0.7) : std::array{any_body(random), any_body(random)};
    Contacts swapped = mesh_contacts(b, a);
    for (auto& c : swapped) std::swap(c.of_first, c.of_second);
    std::sort(swapped.begin(), swapped.end(), [](const auto& x, const auto& y) {
      return std::tie(x.of_first, x.of_second) < std::tie(y.of_first, y.of_second);
    });
    const Contacts found = mesh_contacts(a, b);
    REQUIRE(swapped.size() == found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(swapped[i].of_first == found[i].of_first);
      REQUIRE(swapped[i].of_second == found[i].of_second);
      REQUIRE(swapped[i].position == found[i].position);
      REQUIRE(swapped[i].bound == found[i].bound);
    }
  }
}

TEST_CASE("the diagonals of flat faces change no contact") {
  const auto with_other_diagonals = [](Mesh<double> box) {
    for (std::size_t i = 0; i < box.triangles.size(); i += 2) {
      const auto [a, b, c] = box.triangles[i];
      const int d = box.triangles[i + 1][2];
      box.triangles[i] = {a, b, d};
      box.triangles[i + 1] = {b, c, d};
    }
    return box;
  };
  Random random(15);
  const auto any_box = [&random] {
    const Point low = lines_at_meshes::whole(random, 3);
    const double x = random.integer(1, 4), y = random.integer(1, 4), z = random.integer(1, 4);
    return contact::box_mesh(low, low + Point(x, y, z));
  };
  int contacts = 0;
  for (int m = 0; m < generators::tried(200); ++m) {
    const Mesh<double> a = any_box(), b = any_box();
    const Contacts found = mesh_contacts(a, b);
    const Contacts other = mesh_contacts(with_other_diagonals(a), with_other_diagonals(b));
    REQUIRE(kinds(found) == kinds(other));
    contacts += static_cast<int>(found.size());
  }
  CHECK(contacts > generators::tried(200));
}

TEST_CASE("surfaces that cross in general position have as many contacts as pairs that meet") {
  // Each pair has a segment of a closed curve, each of whose ends is where an edge passes through a
  // triangle: an end of two segments.
  for (int m = 1; m < 20; ++m) {
    const auto [a, b] = two_tori(0.05 + 0.07 * m);
    const Contacts found = mesh_contacts(a, b);
    const auto pairs = contact::meeting_triangles(a, b);
    CHECK(found.size() == pairs.size());
    CHECK(contacts_of_pairs(a, b).size() == 2 * pairs.size());
    CHECK(kinds(found) == Kinds{0, 0, 0, 0, static_cast<int>(pairs.size()), 0});
  }
}

TEST_CASE("without trees, with trees and in float the contacts are the same") {
  Random random(16);
  for (int m = 0; m < generators::tried(100); ++m) {
    const Mesh<double> a = any_body(random), b = any_body(random);
    const Contacts found = mesh_contacts(a, b);
    REQUIRE(nameless(mesh_contacts(MeshTree(a), MeshTree(b))) == nameless(found));
    const auto in_float =
        mesh_contacts(contact::rounded_mesh<float>(a), contact::rounded_mesh<float>(b));
    REQUIRE(in_float.size() == found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(in_float[i].of_first == found[i].of_first);
      REQUIRE(in_float[i].of_second == found[i].of_second);
      const Point off = in_float[i].position.cast<double>() - found[i].position;
      REQUIRE(off.cwiseAbs().maxCoeff() <= double(in_float[i].bound) + found[i].bound);
    }
  }
}

TEST_CASE("triangles that are not finite take no part, also not in edges") {
  const Mesh<double> below = cube({0, 0, 0});
  Mesh<double> damaged = below;
  damaged.vertices.push_back({0, std::numeric_limits<double>::quiet_NaN(), 0});
  damaged.vertices.push_back({std::numeric_limits<double>::infinity(), 0, 0});
  damaged.triangles.push_back({4, 8, 7});  // at the diagonal of the upper face
  damaged.triangles.push_back({9, 6, 7});
  CHECK(nameless(mesh_contacts(damaged, cube({1, 2, 4}))) ==
        nameless(mesh_contacts(below, cube({1, 2, 4}))));
  CHECK(mesh_contacts(Mesh<double>{}, below).empty());
  CHECK(mesh_contacts(below, Mesh<double>{}).empty());
  CHECK(contacts_of_pairs(Mesh<double>{}, below).empty());
}

TEST_CASE("a vertex inside a flat face is a contact, an edge there is none") {
  const Mesh<double> floor = lines_at_meshes::flat_square(4, 2);  // z = 1, vertices at whole x, y
  const auto plate = [](double low, double high) {
    return contact::box_mesh({low, low, 1}, {high, high, 2});
  };
  // Its four vertices, and the inner ones of the floor: of the sheet's, 9 are under it.
  CHECK(kinds(floor, plate(0.5, 3.5)) == Kinds{0, 0, 13, 0, 0, 0});
  CHECK(kinds(floor, plate(1.25, 1.75)) == Kinds{0, 0, 4, 0, 0, 0});
}

TEST_CASE("a mesh that crosses itself there has a contact for each of its features") {
  // Two triangles cross along the x axis, and a vertex is there.
  const Mesh<double> strips{
      {{-2, -1, 0}, {2, -1, 0}, {0, 3, 0}, {-2, 0, -1}, {2, 0, -1}, {0, 0, 3}},
      {{0, 1, 2}, {3, 4, 5}}};
  const Mesh<double> other{{{0, 0, 0}, {1, 1, 1}, {-1, 1, 1}}, {{0, 1, 2}}};
  const Contacts found = mesh_contacts(strips, other);
  CHECK(std::count_if(found.begin(), found.end(),
                      [](const auto& c) { return c.position == Point(0, 0, 0); }) == 2);
}

}  // namespace mesh_contacts_test
