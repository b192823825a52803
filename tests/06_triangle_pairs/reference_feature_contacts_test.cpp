// The first contact of two meshes and the features in contact, against fractions; and that the
// theorem fails without each of its hypotheses.
#include <06_triangle_pairs/common_points_truth.hpp>
#include <06_triangle_pairs/drawn.hpp>
#include <contact/feature_contacts.hpp>
#include <contact/mesh_shapes.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace feature_contacts_tests {

using common_points_truth::Vertices;
using contact::ContactKind;
using contact::ExactFraction;
using contact::FeatureKind;
using contact::FirstContact;
using contact::Mesh;
using contact::NamedFeature;
using contact::Triangle;
using contact::Vector3;
using drawn::anywhere;
using drawn::whole;
using generators::Random;
using oracle::Rational;
using oracle::Vector;

// ---------------------------------------------------------------- input

Mesh<double> tetrahedron(const std::array<Vector3<double>, 4>& v) {
  Mesh<double> mesh;
  mesh.vertices.assign(v.begin(), v.end());
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}
Mesh<double> one_triangle(const Triangle<double>& t) { return {{t.a, t.b, t.c}, {{0, 1, 2}}}; }
/// A body on the grid, at times flat, or a box.
Mesh<double> whole_body(Random& random) {
  if (random.chance(0.3)) {
    const Vector3<double> low = whole(random, 1);
    return contact::box_mesh(low, Vector3<double>(low + Vector3<double>(1, 1, 1) * 2));
  }
  return tetrahedron({whole(random, 2), whole(random, 2), whole(random, 2), whole(random, 2)});
}
struct Moving {
  Mesh<double> moving;
  Vector3<double> displacement;
  Mesh<double> resting;
};
Moving random_bodies(Random& random) {
  const auto body = [&random] {
    return tetrahedron({anywhere(random), anywhere(random), anywhere(random), anywhere(random)});
  };
  const Mesh<double> resting = body();
  const Vector3<double> to = anywhere(random);
  return {contact::translated<double>(body(), Vector3<double>(-3, 0, 0)),
          Vector3<double>(to + Vector3<double>(4, 0, 0)), resting};
}
Moving whole_bodies(Random& random) {
  const Mesh<double> resting = whole_body(random);
  const Vector3<double> to(random.integer(8, 12), random.integer(-3, 3), random.integer(-1, 1));
  return {contact::translated<double>(whole_body(random), Vector3<double>(-6, 0, 0)), to, resting};
}

// ---------------------------------------------------------------- truth

struct ExactMesh {
  std::vector<Vector> vertices;
  const std::vector<std::array<int, 3>>& triangles;

  ExactMesh(const Mesh<double>& mesh, const Vector3<double>& d, const Rational& t)
      : triangles(mesh.triangles) {
    for (const auto& x : mesh.vertices) {
      vertices.push_back(oracle::exact(x) + oracle::exact(d) * t);
    }
  }
  Vertices triangle(std::size_t i) const {
    const auto at = [this](int v) { return vertices[static_cast<std::size_t>(v)]; };
    return {at(triangles[i][0]), at(triangles[i][1]), at(triangles[i][2])};
  }
};
bool boxes_apart(const Vertices& s, const Vertices& t) {
  for (int k = 0; k < 3; ++k) {
    const auto [a, b] = std::minmax({s[0][k], s[1][k], s[2][k]});
    const auto [c, d] = std::minmax({t[0][k], t[1][k], t[2][k]});
    if (b < c || d < a) return true;
  }
  return false;
}
/// Whether the meshes have a common point at a time.
bool meet_at(const Moving& m, const Rational& t) {
  const ExactMesh a(m.moving, m.displacement, t), b(m.resting, {0, 0, 0}, 0);
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      const Vertices first = a.triangle(i), second = b.triangle(j);
      if (!boxes_apart(first, second) && !common_points_truth::candidates(first, second).empty()) {
        return true;
      }
    }
  }
  return false;
}

using Named = std::pair<NamedFeature, NamedFeature>;
/// All pairs of features with a common point in both relative interiors: those of all vertices and
/// crossings in each common set, of the middle of each two of them, and of the middle of all.
std::set<Named> features_at(const Moving& m, const Rational& t) {
  const ExactMesh a(m.moving, m.displacement, t), b(m.resting, {0, 0, 0}, 0);
  const contact::FeatureNames of_a(m.moving), of_b(m.resting);
  std::set<Named> found;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      const Vertices s = a.triangle(i), u = b.triangle(j);
      if (boxes_apart(s, u)) continue;
      const std::vector<Vector> points = common_points_truth::candidates(s, u);
      const auto add = [&](const Vector& x) {
        found.insert({of_a.of(i, *common_points_truth::feature_at(x, s)),
                      of_b.of(j, *common_points_truth::feature_at(x, u))});
      };
      Vector sum = Vector::Zero();
      for (const Vector& p : points) {
        for (const Vector& q : points) add((p + q) / Rational(2));
        sum += p;
      }
      if (!points.empty()) add(sum / Rational(static_cast<int>(points.size())));
    }
  }
  return found;
}
std::set<Named> as_set(const std::vector<contact::FeatureContact>& contacts) {
  std::set<Named> found;
  for (const auto& c : contacts) found.insert({c.of_moving, c.of_resting});
  return found;
}
/// The number of contacts of a kind.
long count_kind(const std::vector<contact::FeatureContact>& contacts, ContactKind kind) {
  return std::count_if(contacts.begin(), contacts.end(),
                       [kind](const auto& c) { return c.kind == kind; });
}
bool is_sufficient_kind(ContactKind kind) {
  return kind != ContactKind::edge_face && kind != ContactKind::face_face;
}

// ---------------------------------------------------------------- the first contact

struct Seen {
  int found = 0;
  std::array<long, 6> kinds{};
};
void check_first(const Moving& m, Seen& seen) {
  const auto first = contact::first_contact(m.moving, m.displacement, m.resting);
  if (!first) {
    for (const int k : {0, 2, 3, 5, 8}) REQUIRE(!meet_at(m, Rational(k, 8)));
    return;
  }
  if (!first->apart_at_start) {
    REQUIRE(meet_at(m, 0));
    return;
  }
  ++seen.found;
  REQUIRE(first->exact_t.nearest() == first->t);
  REQUIRE(!first->realised_by.empty());
  REQUIRE(std::any_of(first->contacts.begin(), first->contacts.end(),
                      [](const auto& c) { return is_sufficient_kind(c.kind); }));
  for (const auto& c : first->realised_by) {
    REQUIRE((c.kind == ContactKind::point_face || c.kind == ContactKind::edge_edge));
  }
  for (std::size_t k = 0; k < 6; ++k) {
    seen.kinds[k] += count_kind(first->contacts, static_cast<ContactKind>(k));
  }
}

/// Whether a fraction of two small numbers is the time: on the grid it is.
std::optional<Rational> small_fraction(const ExactFraction& t) {
  for (int below = 1; below <= 4000; ++below) {
    const double above = std::round(t.nearest() * below);
    if (ExactFraction(above) / ExactFraction(below) == t) {
      return Rational(static_cast<long>(above), below);
    }
  }
  return std::nullopt;
}

/// The features of the first contact, and that there is none before; whether it could be checked.
bool check_at_time(const Moving& m) {
  const auto first = contact::first_contact(m.moving, m.displacement, m.resting);
  if (!first || !first->apart_at_start) return false;
  const auto t = small_fraction(first->exact_t);
  if (!t) return false;
  REQUIRE(as_set(first->contacts) == features_at(m, *t));
  for (const int k : {1, 10, 30}) {
    REQUIRE(!meet_at(m, *t * (1 - Rational(1, std::int64_t{1} << k))));
  }
  return true;
}

/// Whether this build tries so many cases that each kind must occur.
const bool tries_all = !generators::sanitized;

TEST_CASE("bodies on the grid are apart before the first contact and have these features at it") {
  Random random(24);
  Seen seen;
  int compared = 0;
  for (int i = 0; i < generators::tried(96); ++i) {
    const Moving m = whole_bodies(random);
    check_first(m, seen);
    if (check_at_time(m)) ++compared;
  }
  CHECK(compared > seen.found * 3 / 4);
  for (const long count : seen.kinds) CHECK((count > 0 || !tries_all));
}

TEST_CASE("so are triangles that move in their common plane or on their common line") {
  Random random(27);
  Seen seen;
  int compared = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const auto triangle = [&](int x) {
      Triangle<double> t{whole(random, 2), whole(random, 2), whole(random, 2)};
      for (auto* v : {&t.a, &t.b, &t.c}) {
        v->x() += x;
        if (i % 3 == 0) v->y() = 0;
        v->z() = i % 2 == 0 ? 0 : v->x() + v->y();
      }
      return one_triangle(t);
    };
    const double y = i % 3 == 0 ? 0 : random.integer(-2, 2);
    const Moving m{triangle(-5), {10, y, i % 2 == 0 ? 0 : 10 + y}, triangle(0)};
    check_first(m, seen);
    if (check_at_time(m)) ++compared;
  }
  CHECK(compared == seen.found);
  CHECK(compared > generators::tried(400) / 2);
}

TEST_CASE("a vertex that moves in the plane of a triangle arrives at an edge") {
  const Mesh<double> one = one_triangle({{-3, 1, 0}, {-5, 0, 0}, {-5, 2, 0}});
  const Mesh<double> other = one_triangle({{0, 0, 0}, {0, 3, 0}, {5, 0, 0}});
  const auto first = contact::first_contact(one, {4, 0, 0}, other);
  REQUIRE(first);
  CHECK(first->t == 0.75);
  REQUIRE(first->contacts.size() == 1);
  CHECK(first->contacts[0].kind == ContactKind::point_edge);
}

TEST_CASE("segments of one line meet end to end") {
  const Mesh<double> one = one_triangle({{-3, 0, 0}, {-2, 0, 0}, {-2, 0, 0}});
  const Mesh<double> other = one_triangle({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  const auto first = contact::first_contact(one, {4, 0, 0}, other);
  REQUIRE(first);
  CHECK(first->t == 0.5);
  REQUIRE(first->contacts.size() == 1);
  CHECK(first->contacts[0].kind == ContactKind::point_point);
}

TEST_CASE("random bodies are apart before the first contact and meet just after it") {
  Random random(25);
  Seen seen;
  for (int i = 0; i < generators::tried(40); ++i) {
    const Moving m = random_bodies(random);
    check_first(m, seen);
    const auto first = contact::first_contact(m.moving, m.displacement, m.resting);
    if (!first) continue;
    const Rational t = oracle::exact(first->t);
    for (const int k : {1, 4, 30, 48}) {
      REQUIRE(!meet_at(m, t * (1 - Rational(1, std::int64_t{1} << k))));
    }
    // A body without a flat part goes on into the other.
    REQUIRE(meet_at(m, t * (1 + Rational(1, std::int64_t{1} << 48))));
    REQUIRE(first->contacts.size() == 1);
  }
  CHECK(seen.kinds[static_cast<std::size_t>(ContactKind::point_face)] > 0);
  CHECK(seen.kinds[static_cast<std::size_t>(ContactKind::edge_edge)] > 0);
  CHECK(seen.kinds[static_cast<std::size_t>(ContactKind::edge_face)] == 0);
  CHECK(seen.kinds[static_cast<std::size_t>(ContactKind::face_face)] == 0);
}

TEST_CASE("the first contact is the same at every scale, and with the meshes exchanged") {
  Random random(26);
  for (int i = 0; i < generators::tried(200); ++i) {
    const Moving m = i % 2 == 0 ? whole_bodies(random) : random_bodies(random);
    const auto first = contact::first_contact(m.moving, m.displacement, m.resting);
    const double f = std::ldexp(1.0, random.integer(-480, 480));
    Moving s = m;
    for (auto& x : s.moving.vertices) x *= f;
    for (auto& x : s.resting.vertices) x *= f;
    s.displacement *= f;
    const auto as_scaled = contact::first_contact(s.moving, s.displacement, s.resting);
    const auto exchanged =
        contact::first_contact(m.resting, Vector3<double>(-m.displacement), m.moving);
    REQUIRE(as_scaled.has_value() == first.has_value());
    REQUIRE(exchanged.has_value() == first.has_value());
    if (!first) continue;
    REQUIRE(as_scaled->exact_t == first->exact_t);
    REQUIRE(exchanged->exact_t == first->exact_t);
    REQUIRE(as_set(as_scaled->contacts) == as_set(first->contacts));
    REQUIRE(as_set(as_scaled->realised_by) == as_set(first->realised_by));
    std::set<Named> reversed;
    for (const auto& [f1, f2] : as_set(exchanged->contacts)) reversed.insert({f2, f1});
    REQUIRE(reversed == as_set(first->contacts));
  }
}

TEST_CASE("the first contact of bodies on the grid is the same far from the origin") {
  // Rounded, the positions at the contact are off by more than the room that whole numbers need.
  Random random(28);
  int found = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const Moving m = whole_bodies(random);
    const auto first = contact::first_contact(m.moving, m.displacement, m.resting);
    const Vector3<double> far(std::ldexp(1.0, random.integer(20, 50)),
                              std::ldexp(-1.0, random.integer(20, 50)), 0);
    const auto away =
        contact::first_contact(contact::translated<double>(m.moving, far), m.displacement,
                               contact::translated<double>(m.resting, far));
    REQUIRE(away.has_value() == first.has_value());
    if (!first) continue;
    ++found;
    REQUIRE(away->exact_t == first->exact_t);
    REQUIRE(as_set(away->contacts) == as_set(first->contacts));
    REQUIRE(as_set(away->realised_by) == as_set(first->realised_by));
  }
  CHECK(found > generators::tried(400) / 2);
}

TEST_CASE("a box that lands on a box touches with four vertices, and no diagonal is an edge") {
  const auto first = contact::first_contact(contact::box_mesh({1, 1, 6}, {2, 2, 7}), {0, 0, -4},
                                            contact::box_mesh({0, 0, 0}, {4, 4, 4}));
  REQUIRE(first);
  CHECK(first->t == 0.5);
  CHECK(count_kind(first->contacts, ContactKind::point_face) == 4);
  CHECK(count_kind(first->contacts, ContactKind::edge_face) == 4);
  CHECK(count_kind(first->contacts, ContactKind::face_face) == 1);
  CHECK(first->contacts.size() == 9);
  CHECK(first->realised_by.size() == 4);
  for (const auto& c : first->contacts) CHECK(c.position.z() == 4);
}

TEST_CASE("boxes of any size and position touch with their faces, at a time that is rounded") {
  Random random(29);
  for (int i = 0; i < generators::tried(400); ++i) {
    const auto box = [&random](double x) {
      const Vector3<double> low(x + random.uniform(), -random.uniform(), -random.uniform());
      return contact::box_mesh(
          low, Vector3<double>(random.uniform(x + 1, x + 2), random.uniform(), random.uniform()));
    };
    const auto first = contact::first_contact(box(-4), {random.uniform(5, 9), 0, 0}, box(0));
    REQUIRE(first);
    REQUIRE(first->apart_at_start);
    REQUIRE(!first->realised_by.empty());
    REQUIRE(count_kind(first->contacts, ContactKind::face_face) == 1);
  }
}

TEST_CASE("all six kinds occur when a box lands on another flush with two of its sides") {
  const auto first = contact::first_contact(contact::box_mesh({0, 0, 5}, {3, 2, 6}), {0, 0, -2},
                                            contact::box_mesh({0, 0, 0}, {4, 4, 4}));
  REQUIRE(first);
  CHECK(count_kind(first->contacts, ContactKind::point_point) == 1);
  CHECK(count_kind(first->contacts, ContactKind::point_edge) == 2);
  CHECK(count_kind(first->contacts, ContactKind::point_face) == 1);
  CHECK(count_kind(first->contacts, ContactKind::edge_edge) == 2);
  CHECK(count_kind(first->contacts, ContactKind::edge_face) == 2);
  CHECK(count_kind(first->contacts, ContactKind::face_face) == 1);
  CHECK(first->contacts.size() == 9);
}

TEST_CASE("a vertex that slides along a line of an edge arrives at its end") {
  const Mesh<double> needle = one_triangle({{-3, 0, 0}, {-4, 0, 1}, {-4, 0, -1}});
  const Mesh<double> other = one_triangle({{0, 0, 0}, {2, 0, 0}, {1, 5, 0}});
  const auto first = contact::first_contact(needle, {4, 0, 0}, other);
  REQUIRE(first);
  CHECK(first->t == 0.75);
  REQUIRE(first->contacts.size() == 1);
  CHECK(first->contacts[0].kind == ContactKind::point_point);
}

TEST_CASE("bodies that pass each other, or do not move far enough, have no first contact") {
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {1, 1, 1});
  const Mesh<double> above = contact::box_mesh({0, 0, 3}, {1, 1, 4});
  CHECK(!contact::first_contact(above, {0, 0, -1.5}, box));
  CHECK(!contact::first_contact(above, {9, 0, 0}, box));
  CHECK(!contact::first_contact(above, {0, 0, 0}, box));
  CHECK(!contact::first_contact(above, {0, 0, -9}, Mesh<double>{}));
  CHECK(contact::first_contact(above, {0, 0, -2}, box)->t == 1);
  CHECK(!contact::first_contact(above, {0, 0, -std::numeric_limits<double>::infinity()}, box));
}

TEST_CASE("a first contact that differs from another by less than an ulp is found") {
  // Two spikes come down on a plate that is tilted by 2^-60.
  Mesh<double> spikes = tetrahedron({Vector3<double>(0, 0, 1), {-1, -1, 2}, {1, -1, 2}, {0, 1, 2}});
  spikes = contact::joined(spikes, contact::translated<double>(spikes, {4, 0, 0}));
  const Mesh<double> plate{{{-9, -9, 0}, {9, -9, 0}, {0x1p4, 9, 0x1p-56}, {-0x1p4, 9, -0x1p-56}},
                           {{0, 1, 2}, {0, 2, 3}}};
  const auto first = contact::first_contact(spikes, {0, 0, -2}, plate);
  REQUIRE(first);
  REQUIRE(first->contacts.size() == 1);
  CHECK(first->contacts[0].of_moving.kind == FeatureKind::vertex);
  CHECK(first->contacts[0].of_moving.vertices[0] == 4);
  CHECK(first->exact_t < ExactFraction(0.5));
  CHECK(first->t == 0.5);
}

// ---------------------------------------------------------------- the hypotheses of the theorem

TEST_CASE("without a start apart, an edge through a face can be the only contact") {
  const Mesh<double> plate = one_triangle({{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}});
  const Mesh<double> bar = one_triangle({{0, 0, -1}, {0, 0, 1}, {0, 0, 0.5}});
  const Mesh<double> blade = one_triangle({{0, 0, -1}, {0.5, 0, 1}, {-0.5, 0, 1}});
  for (const Mesh<double>& m : {bar, blade}) {
    const auto start = contact::first_contact(m, {1, 0, 0}, plate);
    REQUIRE(start);
    CHECK(!start->apart_at_start);
    CHECK(start->t == 0);
    CHECK(start->realised_by.empty());
    CHECK(count_kind(start->contacts, ContactKind::edge_face) > 0);
    for (const auto& c : start->contacts) CHECK(!is_sufficient_kind(c.kind));
  }
}

TEST_CASE("without continuity, the end of a step can have an edge through a face alone") {
  const Mesh<double> plate = one_triangle({{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}});
  const Mesh<double> blade = one_triangle({{0, 0, 2}, {0.5, 0, 4}, {-0.5, 0, 4}});
  const Vector3<double> jump(0, 0, -3);
  const auto before = contact::first_contact(blade, {0, 0, 0}, plate);
  CHECK(!before);
  const auto after =
      contact::first_contact(contact::translated<double>(blade, jump), {0, 0, 0}, plate);
  REQUIRE(after);
  CHECK(after->realised_by.empty());
  // The continuous motion between the two has a vertex on a face.
  const auto between = contact::first_contact(blade, jump, plate);
  REQUIRE(between);
  REQUIRE(between->contacts.size() == 1);
  CHECK(between->contacts[0].kind == ContactKind::point_face);
}

TEST_CASE("without borders, a vertex on an edge is neither point to face nor edge to edge") {
  const Mesh<double> plate = one_triangle({{-4, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  const Mesh<double> spike = one_triangle({{0, 0, 2}, {1, -1, 4}, {-1, -1, 4}});
  const auto first = contact::first_contact(spike, {0, 0, -3}, plate);
  REQUIRE(first);
  REQUIRE(first->contacts.size() == 1);
  CHECK(first->contacts[0].kind == ContactKind::point_edge);
  CHECK(count_kind(first->realised_by, ContactKind::point_face) == 1);
  CHECK(count_kind(first->realised_by, ContactKind::edge_edge) == 2);
}

}  // namespace feature_contacts_tests
