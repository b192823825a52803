// compound_contacts.hpp: a floor of tiles is a floor, and corners have several normals.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/compound_contacts.hpp>
#include <contact/hull_manifold.hpp>
#include <limits>
#include <vector>

#include "support/generators.hpp"

namespace compound_contacts_test {
namespace {

using contact::compound_contacts;
using contact::CompoundBody;
using contact::ConvexHull;
using generators::Random;
using generators::tried;

using V = contact::Vector3<double>;
using Hull = ConvexHull<double>;
using Compound = CompoundBody<double>;
using Pairs = std::vector<contact::PieceManifold<double>>;

Hull cuboid(const V& low, const V& high) {
  Hull hull;
  for (int i = 0; i < 8; ++i) {
    hull.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  return hull;
}
Hull ball(const V& centre, double radius) { return {{centre}, radius}; }
/// A box rotated about the vertical axis.
Hull block(const V& centre, const V& half, double sine) {
  const double cosine = std::sqrt(1 - sine * sine);
  Hull hull = cuboid(V(-half), half);
  for (V& v : hull.vertices) {
    v = V(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()) + centre;
  }
  return hull;
}
/// A floor from −4 to 4, 1 thick, as one piece or as tiles of 1 by 1.
Compound floor_of(bool tiles) {
  if (!tiles) return {{cuboid(V(-4, -4, -1), V(4, 4, 0))}};
  Compound floor;
  for (int x = -4; x < 4; ++x) {
    for (int y = -4; y < 4; ++y) {
      floor.pieces.push_back(cuboid(V(x, y, -1), V(x + 1, y + 1, 0)));
    }
  }
  return floor;
}
const Compound ell{
    {cuboid(V(-4, -1, -1), V(4, 1, 0)), cuboid(V(2, -1, 0), V(4, 1, 3))}};  // floor and wall

std::size_t point_count(const Pairs& pairs) {
  std::size_t count = 0;
  for (const auto& pair : pairs) count += pair.manifold.points.size();
  return count;
}
bool has_normal(const Pairs& pairs, const V& n) {
  return std::any_of(pairs.begin(), pairs.end(), [&n](const auto& pair) {
    return (pair.manifold.normal - n).norm() <= 0x1p-18;
  });
}
bool all_normals(const Pairs& pairs, const V& n) {
  return std::all_of(pairs.begin(), pairs.end(), [&n](const auto& pair) {
    return (pair.manifold.normal - n).norm() <= 0x1p-18;
  });
}

}  // namespace

TEST_CASE("a ball on tiles has the one contact that it has on a floor") {
  Random random(1861);
  const Compound tiles = floor_of(true);
  int naive = 0;
  for (int i = 0; i < tried(60); ++i) {
    // Often on a joint, or close to it.
    const int joint = random.integer(-3, 3);
    const double off = random.magnitude(-30, -2);
    const double x = random.chance(0.3) ? joint : joint + off;
    const double y = random.uniform(-3, 3);
    const double depth = random.uniform(-0.009, 0.01);
    const Compound above{{ball(V(x, y, 0.5 - depth), 0.5)}};
    const Pairs found = compound_contacts(above, tiles, 0.01);
    REQUIRE(point_count(found) == 1);
    CHECK(all_normals(found, V(0, 0, 1)));
    CHECK(std::abs(found[0].manifold.points[0].distance + depth) <= 1e-12);
    for (const Hull& tile : tiles.pieces) {
      const auto one = contact::contact_manifold(above.pieces[0], tile, 0.01);
      if (!one.points.empty() && one.normal.z() < 1 - 1e-9) ++naive;
    }
  }
  CHECK(naive > tried(10));  // each piece alone has contacts with the edges inside
}

TEST_CASE("a box that slides over tiles meets no inner face, also where it has sunk in") {
  Random random(1862);
  const Compound tiles = floor_of(true);
  const Compound whole = floor_of(false);
  int sideways = 0;
  for (int i = 0; i < tried(60); ++i) {
    const double x = random.uniform(-2, 2);
    const double depth = random.uniform(0, 0.01);
    const double sine = random.chance(0.5) ? 0 : random.uniform(-1, 1);
    const int joint = random.integer(-1, 1);
    const double edge =
        joint + 0.25 + random.uniform(0, 0.01);  // its right side just beyond a joint
    const Compound box{{block(V(sine == 0 ? edge : x, 0.3, 0.5 - depth), V(0.75, 0.5, 0.5), sine)}};
    const Pairs found = compound_contacts(box, tiles, 0.0);
    const Pairs right = compound_contacts(box, whole, 0.0);
    REQUIRE(!found.empty());
    CHECK(all_normals(found, V(0, 0, 1)));
    // The box's four lower corners are among the points.
    REQUIRE(point_count(right) == 4);
    int held = 0;
    for (const auto& p : right[0].manifold.points) {
      for (const auto& pair : found) {
        for (const auto& q : pair.manifold.points) {
          if ((p.point - q.point).norm() <= 0.011) {
            ++held;
            CHECK(std::abs(p.distance - q.distance) <= 1e-12);
          }
        }
      }
    }
    CHECK(held >= 4);
    for (const Hull& tile : tiles.pieces) {
      const auto one = contact::contact_manifold(box.pieces[0], tile, 0.0);
      if (!one.points.empty() && one.normal.z() < 0.5) ++sideways;
    }
  }
  CHECK(sideways > tried(5));  // as each tile alone would have it
}

TEST_CASE("a box in the inner corner of an L touches the floor and the wall") {
  for (const double depth : {0.0, 0.004}) {
    const Compound box{{cuboid(V(1 + depth, -0.5, -depth), V(2 + depth, 0.5, 1 - depth))}};
    const Pairs found = compound_contacts(box, ell, 0.001);
    CHECK(has_normal(found, V(0, 0, 1)));
    CHECK(has_normal(found, V(-1, 0, 0)));
    CHECK(point_count(found) == 8);
  }
}

TEST_CASE("a mesh of an L has the contacts of its pieces") {
  // The profile of `ell` in the plane of x and z, from y = −1 to 1.
  const std::vector<V> profile{V(-4, 0, -1), V(4, 0, -1), V(4, 0, 3),
                               V(2, 0, 3),   V(2, 0, 0),  V(-4, 0, 0)};
  contact::Mesh<double> mesh;
  for (const double y : {-1.0, 1.0}) {
    for (const V& p : profile) mesh.vertices.emplace_back(p.x(), y, p.z());
  }
  for (const auto& t : {std::array<int, 3>{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}}) {
    mesh.triangles.push_back({t[0], t[1], t[2]});
    mesh.triangles.push_back({t[2] + 6, t[1] + 6, t[0] + 6});
  }
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    mesh.triangles.push_back({next, i, i + 6});
    mesh.triangles.push_back({next, i + 6, next + 6});
  }
  const Compound body = contact::compound_from_mesh(mesh);
  CHECK(body.pieces.size() == 2);
  const Compound box{{cuboid(V(1, -0.5, 0), V(2, 0.5, 1))}};
  const Pairs found = compound_contacts(box, body, 0.001);
  CHECK(has_normal(found, V(0, 0, 1)));
  CHECK(has_normal(found, V(-1, 0, 0)));
  const Compound lying{{cuboid(V(-3, -0.5, 0), V(-2, 0.5, 1))}};
  CHECK(all_normals(compound_contacts(lying, body, 0.001), V(0, 0, 1)));
}

TEST_CASE("a wedge in a groove has a contact, although its edge is inside") {
  const auto ramp = [](double side) {
    Hull hull;
    for (const double y : {-2.0, 2.0}) {
      hull.vertices.emplace_back(0, y, 0);
      hull.vertices.emplace_back(side, y, 1);
      hull.vertices.emplace_back(side, y, -1);
      hull.vertices.emplace_back(0, y, -1);
    }
    return hull;
  };
  Hull wedge;
  for (const double y : {-0.5, 0.5}) {
    wedge.vertices.emplace_back(0, y, 0);
    wedge.vertices.emplace_back(-0.2, y, 1);
    wedge.vertices.emplace_back(0.2, y, 1);
  }
  const Compound groove{{ramp(-1), ramp(1)}};
  for (const double height : {-0.001, 0.0, 0.001}) {
    Hull there = wedge;
    for (V& v : there.vertices) v.z() += height;
    const Pairs found = compound_contacts(Compound{{there}}, groove, 0.01);
    CHECK(point_count(found) >= 2);
    for (const auto& pair : found) CHECK(pair.manifold.normal.z() > 0.1);
  }
}

TEST_CASE(
    "compound bodies have a contact whenever two of their pieces have, in every run the same") {
  Random random(1864);
  const Compound floor = floor_of(true);
  for (int i = 0; i < tried(60); ++i) {
    const V at(random.integer(-2, 2) / 2.0, random.integer(-2, 2) / 2.0, random.uniform(-0.2, 0.6));
    const Compound body{{block(at, V(0.5, 0.25, 0.25), random.uniform(-1, 1)),
                         block(V(at + V(0, 0, 0.5)), V(0.25, 0.25, 0.25), 0)}};
    const Compound& other = i % 2 == 0 ? floor : ell;
    bool touches = false;
    for (const Hull& one : body.pieces) {
      for (const Hull& piece : other.pieces) {
        touches = touches || !contact::contact_manifold(one, piece, 0.01).points.empty();
      }
    }
    const Pairs found = compound_contacts(body, other, 0.01);
    CHECK(found.empty() == !touches);
    for (const auto& pair : found) CHECK_FALSE(pair.manifold.points.empty());
    const Pairs again = compound_contacts(body, other, 0.01);
    REQUIRE(again.size() == found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(again[k].manifold.normal == found[k].manifold.normal);
      REQUIRE(again[k].manifold.points.size() == found[k].manifold.points.size());
      for (std::size_t p = 0; p < found[k].manifold.points.size(); ++p) {
        CHECK(again[k].manifold.points[p].point == found[k].manifold.points[p].point);
      }
    }
  }
}

TEST_CASE("a foot under the middle of a bar hides no contact of the bar's ends") {
  const Compound table{{cuboid(V(-12, -2, -1), V(12, 2, 0))}};
  for (const double deep : {-0.005, 0.005}) {
    // The foot is 1 cm high, so the bar itself is 1 cm above it or in the table with its ends.
    const double low = deep < 0 ? 0.01 : -deep;
    const Compound bar{{cuboid(V(-10, -1, low), V(10, 1, low + 1)),
                        cuboid(V(-0.5, -1, low - 0.01), V(0.5, 1, low))}};
    const Pairs pairs = compound_contacts(bar, table, 0.02);
    double left = 0, right = 0;
    for (const auto& pair : pairs) {
      for (const auto& p : pair.manifold.points) {
        left = std::min(left, p.point.x());
        right = std::max(right, p.point.x());
      }
    }
    CAPTURE(deep);
    CHECK(std::abs(left + 10) < 1e-12);
    CHECK(std::abs(right - 10) < 1e-12);
  }
}

TEST_CASE("several points between the same two bodies: a table with four legs") {
  Compound table{{cuboid(V(-1, -1, 1), V(1, 1, 1.1))}};
  for (const double x : {-0.9, 0.8}) {
    for (const double y : {-0.9, 0.8}) {
      table.pieces.push_back(cuboid(V(x, y, 0), V(x + 0.1, y + 0.1, 1)));
    }
  }
  const Pairs on_floor = compound_contacts(table, floor_of(false), 1e-6);
  CHECK(on_floor.size() == 4);
  CHECK(point_count(on_floor) == 16);
  CHECK(all_normals(on_floor, V(0, 0, 1)));
  const contact::HalfSpace<double> ground{{V(0, 0, 1), 0}};
  CHECK(point_count(compound_contacts(table, ground, 1e-6)) == 16);
  // The tiles share their vertices, and each counts once.
  CHECK(point_count(compound_contacts(floor_of(true), contact::HalfSpace<double>{{V(0, 0, 1), -1}},
                                      1e-6)) == 81);
}

TEST_CASE("exchanging two compound bodies exchanges their contacts, to the last bit") {
  Random random(1863);
  for (int i = 0; i < tried(200); ++i) {
    const double x = random.uniform(-3, 3);
    const double z = random.uniform(-0.01, 0.5);
    const Compound a{{block(V(x, 0, 0.5 + z), V(0.5, 0.4, 0.5), random.uniform(-1, 1)),
                      block(V(x, 0, 1.5 + z), V(0.7, 0.4, 0.5), random.uniform(-1, 1))}};
    const Pairs one = compound_contacts(a, ell, 0.1);
    const Pairs other = compound_contacts(ell, a, 0.1);
    REQUIRE(one.size() == other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      CHECK(one[k].piece_a == other[k].piece_b);
      CHECK(one[k].piece_b == other[k].piece_a);
      CHECK(one[k].manifold.normal == -other[k].manifold.normal);
      REQUIRE(one[k].manifold.points.size() == other[k].manifold.points.size());
      for (std::size_t p = 0; p < one[k].manifold.points.size(); ++p) {
        CHECK(one[k].manifold.points[p].point == other[k].manifold.points[p].point);
        CHECK(one[k].manifold.points[p].distance == other[k].manifold.points[p].distance);
      }
    }
  }
}

TEST_CASE("compound bodies without pieces, or with pieces that are none, have no contact") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const contact::HalfSpace<double> ground{{V(0, 0, 1), 0}};
  for (const Compound& bad : {Compound{}, Compound{{Hull{}}}, Compound{{ball(V(nan, 0, 0), 1)}}}) {
    CHECK(compound_contacts(bad, ell, 1.0).empty());
    CHECK(compound_contacts(ell, bad, 1.0).empty());
    CHECK(compound_contacts(bad, ground, 1.0).empty());
  }
}

}  // namespace compound_contacts_test
