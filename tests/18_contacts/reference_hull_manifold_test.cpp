// hull_manifold.hpp, facing_part.hpp and face_overlap.hpp: invariants for any pair of bodies, and
// closed forms.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <contact/hull_manifold.hpp>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "09_separating_planes/pair_bodies.hpp"
#include "09_separating_planes/pair_families.hpp"
#include "09_separating_planes/random_poses.hpp"
#include "support/generators.hpp"

namespace hull_manifold_test {
namespace {

using contact::ContactManifold;
using contact::ConvexHull;
using contact::edge_feature;
using contact::OrientedBox;
using contact::PointFeatures;
using contact::Sphere;
using contact::Triangle;
using contact::vertex_feature;
using generators::Random;
using generators::tried;
using pair_bodies::Body;
using pair_bodies::Kind;
using pair_families::Family;

using V = contact::Vector3<double>;
using Hull = ConvexHull<double>;
constexpr std::array<Kind, 6> kinds = pair_bodies::polytope_kinds;

bool is_faceted(Kind kind) {
  return kind == Kind::hull || kind == Kind::triangle || kind == Kind::lozenge;
}

/// Calls f(a, b) for two polytopes with radii.
template <class F>
auto with(const Body& a, const Body& b, const F& f) {
  return std::visit(
      [&f](const auto& one, const auto& other) -> decltype(f(Triangle<double>{}, Hull{})) {
        using A = std::decay_t<decltype(one)>;
        using B = std::decay_t<decltype(other)>;
        if constexpr (contact::PolytopeCore<A> && contact::PolytopeCore<B>) {
          return f(one, other);
        } else {
          return {};
        }
      },
      a, b);
}

ContactManifold<double> manifold_of(const Body& a, const Body& b, double margin) {
  return with(a, b, [margin](const auto& one, const auto& other) {
    return contact::contact_manifold(one, other, margin);
  });
}
double distance_of(const Body& a, const Body& b) {
  return with(a, b, [](const auto& one, const auto& other) {
    return contact::signed_distance(one, other).distance;
  });
}

/// The largest extent of a core.
double core_of(const Body& body) {
  return std::visit(
      [](const auto& b) -> double {
        if constexpr (contact::PolytopeCore<std::decay_t<decltype(b)>>) {
          return contact::detail::core_extent(b);
        } else {
          return 0;
        }
      },
      body);
}

template <class S>
bool same(const ContactManifold<S>& one, const ContactManifold<S>& other) {
  if (one.normal != other.normal || one.points.size() != other.points.size()) return false;
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    if (one.points[i].point != other.points[i].point) return false;
    if (one.points[i].distance != other.points[i].distance) return false;
    if (one.points[i].features != other.points[i].features) return false;
  }
  return true;
}

double min_distance(const ContactManifold<double>& manifold) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& p : manifold.points) least = std::min(least, p.distance);
  return least;
}

/// One pair of each kinds and family after the other.
struct Drawn {
  pair_families::Pair pair;
  Family family;
  double size, core;
};
Drawn draw(Random& random, int i, bool any_kind) {
  const Family family = pair_families::all[static_cast<std::size_t>(i) % pair_families::all.size()];
  Kind a = kinds[static_cast<std::size_t>(random.integer(0, 5))];
  const Kind b = kinds[static_cast<std::size_t>(random.integer(0, 5))];
  if (!any_kind && !is_faceted(a) && !is_faceted(b)) a = Kind::hull;
  const auto pair = pair_families::pair(random, a, b, family);
  return {pair, family, std::max(pair_bodies::size_of(pair.a), pair_bodies::size_of(pair.b)),
          std::min(core_of(pair.a), core_of(pair.b))};
}

/// A prism with a regular polygon of n vertices, from height `low` to `high`.
Hull prism(int n, double radius, double low, double high) {
  Hull hull;
  for (const double z : {low, high}) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / n;
      hull.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  return hull;
}
Hull cuboid(const V& low, const V& high) {
  Hull hull;
  for (int i = 0; i < 8; ++i) {
    hull.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  return hull;
}
Hull moved(Hull hull, const V& by) {
  for (V& v : hull.vertices) v += by;
  return hull;
}
Hull tilted(Hull hull, double sine) {
  const double cosine = std::sqrt(1 - sine * sine);
  for (V& v : hull.vertices)
    v = V(cosine * v.x() - sine * v.z(), v.y(), sine * v.x() + cosine * v.z());
  return hull;
}

}  // namespace

TEST_CASE("exchanging two bodies gives the opposite normal and the same points, to the last bit") {
  Random random(1831);
  int several = 0;
  for (int i = 0; i < tried(6000); ++i) {
    const Drawn d = draw(random, i, false);
    if (d.family == Family::equal) continue;
    const double margin = random.uniform(0, 0.01) * d.core;
    const auto manifold = manifold_of(d.pair.a, d.pair.b, margin);
    const auto back = manifold_of(d.pair.b, d.pair.a, margin);
    CHECK(same(exchanged(back), manifold));
    several += manifold.points.size() > 1 ? 1 : 0;
  }
  CHECK(several > tried(250));
}

TEST_CASE("boxes and capsules in either order have the same manifold, to the last bit") {
  Random random(1832);
  for (int i = 0; i < tried(4000); ++i) {
    const Family family =
        pair_families::all[static_cast<std::size_t>(i) % pair_families::all.size()];
    if (family == Family::equal) continue;
    const Kind a = random.chance(0.5) ? Kind::box : Kind::capsule;
    const Kind b = random.chance(0.5) ? Kind::box : Kind::capsule;
    const auto pair = pair_families::pair(random, a, b, family);
    const double margin = random.uniform(0, 0.01);
    CHECK(
        same(exchanged(manifold_of(pair.b, pair.a, margin)), manifold_of(pair.a, pair.b, margin)));
  }
}

TEST_CASE("bodies have a point exactly if they are within the margin, and all points are") {
  Random random(1833);
  std::array<int, 4> counts{};
  for (int i = 0; i < tried(6000); ++i) {
    const Drawn d = draw(random, i, false);
    const double margin = random.uniform(0, 0.01) * d.core;
    const auto manifold = manifold_of(d.pair.a, d.pair.b, margin);
    const double distance = distance_of(d.pair.a, d.pair.b);
    CHECK(manifold.points.empty() == !(distance <= margin));
    CHECK(std::abs(manifold.normal.dot(manifold.normal) - 1) <= 1e-14);
    for (const auto& p : manifold.points) CHECK(p.distance <= margin);
    ++counts[std::min<std::size_t>(manifold.points.size(), 3)];
    if (manifold.points.empty()) continue;
    CHECK(min_distance(manifold) >= distance - 0x1p-10 * d.core - 1e-9 * d.size);
    CHECK(min_distance(manifold) <= distance + 0x1p-10 * d.core + 1e-9 * d.size);
  }
  for (const int count : counts) CHECK(count > tried(100));
}

TEST_CASE("a point lies midway between the surfaces of both bodies") {
  Random random(1834);
  double worst = 0;
  for (int i = 0; i < tried(4000); ++i) {
    const Drawn d = draw(random, i, false);
    if (d.family == Family::thin || d.family == Family::large) continue;
    const double margin = random.uniform(0, 0.01) * d.core;
    const auto manifold = manifold_of(d.pair.a, d.pair.b, margin);
    for (const auto& p : manifold.points) {
      const V half = manifold.normal * (p.distance / 2);
      const double a = distance_of(Sphere<double>{V(p.point + half), 0}, d.pair.a);
      const double b = distance_of(Sphere<double>{V(p.point - half), 0}, d.pair.b);
      worst = std::max(worst, std::max(a, b) / d.size);
    }
  }
  CHECK(worst <= 1e-9);
}

TEST_CASE("moving a body by the least distance along the normal makes the two touch") {
  Random random(1835);
  int moves = 0;
  for (int i = 0; i < tried(4000); ++i) {
    const Drawn d = draw(random, i, false);
    if (d.family == Family::thin || d.family == Family::large || d.family == Family::scaled)
      continue;
    const auto manifold = manifold_of(d.pair.a, d.pair.b, 0.01 * d.core);
    if (manifold.points.empty()) continue;
    const Body apart = pair_bodies::moved(d.pair.a, V(manifold.normal * -min_distance(manifold)));
    CHECK(std::abs(distance_of(apart, d.pair.b)) <= 0x1p-9 * d.core + 1e-9 * d.size);
    ++moves;
  }
  CHECK(moves > tried(1000));
}

TEST_CASE("scaling two bodies by a power of two scales their manifold, to the last bit") {
  Random random(1836);
  for (int i = 0; i < tried(600); ++i) {
    const Drawn d = draw(random, i, true);
    if (d.family == Family::scaled) continue;
    const double margin = random.uniform(0, 0.01) * d.core;
    const auto manifold = manifold_of(d.pair.a, d.pair.b, margin);
    for (const int power : {-480, 480}) {
      auto there = manifold_of(pair_bodies::scaled(d.pair.a, power),
                               pair_bodies::scaled(d.pair.b, power), std::ldexp(margin, power));
      for (auto& p : there.points) {
        p.point = contact::detail::times_power_of_two(p.point, -power);
        p.distance = std::ldexp(p.distance, -power);
      }
      CHECK(same(there, manifold));
    }
  }
}

TEST_CASE("the part of a hull that faces along a face's normal is that face") {
  Random random(1838);
  int faces = 0;
  for (int i = 0; i < tried(300); ++i) {
    Hull hull;
    const int count = random.integer(4, 12);
    const bool on_grid = random.chance(0.5);  // then faces have more than three vertices
    for (int k = 0; k < count; ++k) {
      const V p = random_poses::any_point(random, 2);
      hull.vertices.push_back(on_grid ? V(p.array().round()) : p);
    }
    const contact::Hull whole = contact::convex_hull(hull.vertices);
    if (whole.dimension < 3) continue;
    for (int f = 0; f < whole.face_count(); ++f) {
      std::vector<int> right(whole.face(f).begin(), whole.face(f).end());
      const auto part = contact::facing_part(hull, contact::detail::normal_of_polygon(hull, right),
                                             contact::detail::flatness<double>);
      std::vector<V> got;
      for (const int v : part.vertices) got.push_back(hull.vertices[std::size_t(v)]);
      REQUIRE(got.size() == right.size());
      std::size_t first = 0;  // where the face begins
      while (first < got.size() && got[first] != hull.vertices[std::size_t(right[0])]) ++first;
      for (std::size_t k = 0; k < got.size(); ++k) {
        CHECK(got[(first + k) % got.size()] == hull.vertices[std::size_t(right[k])]);
      }
      ++faces;
    }
  }
  CHECK(faces > tried(1000));
}

TEST_CASE("a box as a hull has the contact points of the box") {
  Random random(1837);
  for (int i = 0; i < tried(1000); ++i) {
    const int x = random.integer(-3, 3);
    const int y = random.integer(-3, 3);
    const double depth = random.integer(-1, 1) / 16.0;
    const V half(random.integer(1, 4), random.integer(1, 4), 2);
    const V other(random.integer(1, 4), random.integer(1, 4), 2);
    const OrientedBox<double> a{V(x, y, 4 - depth), contact::Matrix3<double>::Identity(), half};
    const OrientedBox<double> b{V(0, 0, 0), contact::Matrix3<double>::Identity(), other};
    const double wide = std::min(x + half.x(), other.x()) - std::max(x - half.x(), -other.x());
    const double long_ = std::min(y + half.y(), other.y()) - std::max(y - half.y(), -other.y());
    if (wide <= 1 || long_ <= 1) continue;
    const auto of_boxes = contact::contact_manifold(a, b, 0.1);
    const auto of_hulls = contact::contact_manifold(cuboid(V(a.centre - half), V(a.centre + half)),
                                                    cuboid(V(-other), other), 0.1);
    const auto of_both = contact::contact_manifold(a, cuboid(V(-other), other), 0.1);
    REQUIRE(of_boxes.points.size() == 4);
    for (const auto& found : {of_hulls, of_both}) {
      CHECK(found.normal == of_boxes.normal);
      REQUIRE(found.points.size() == 4);
      for (const auto& p : of_boxes.points) {
        CHECK(std::any_of(found.points.begin(), found.points.end(), [&p](const auto& q) {
          return (p.point - q.point).norm() <= 1e-14 && std::abs(p.distance - q.distance) <= 1e-14;
        }));
      }
    }
  }
}

TEST_CASE("a prism on a larger one has all vertices of its base, with their features") {
  const Hull table = prism(9, 5, -1, 0);
  for (int n = 3; n <= 12; ++n) {
    const Hull standing = prism(n, 1, 0, 2);
    for (const double sine : {0.0, 1e-15, -1e-12, 1e-8}) {
      const auto manifold = contact::contact_manifold(tilted(standing, sine), table, 1e-6);
      REQUIRE(manifold.points.size() == static_cast<std::size_t>(n));
      CHECK((manifold.normal - V(0, 0, 1)).norm() <= 1e-12 + std::abs(sine));
      std::vector<int> vertices;
      for (const auto& p : manifold.points) {
        CHECK(p.features.of_b == contact::SurfaceFeature{});
        CHECK(p.features.of_a.first == p.features.of_a.second);
        vertices.push_back(p.features.of_a.first);
      }
      std::sort(vertices.begin(), vertices.end());
      for (int i = 0; i < n; ++i) CHECK(vertices[static_cast<std::size_t>(i)] == i);
    }
  }
}

TEST_CASE("a face over the edge of a table is clipped, and each point says by what") {
  const Hull table = cuboid(V(-4, -4, -1), V(0, 4, 0));
  const Hull block = cuboid(V(-1, -1, 0), V(1, 1, 2));
  const auto manifold = contact::contact_manifold(block, table, 0.0);
  REQUIRE(manifold.points.size() == 4);
  const auto at = [&manifold](const V& point) {
    for (const auto& p : manifold.points)
      if (p.point == point) return p.features;
    return PointFeatures{vertex_feature(99), {}};
  };
  CHECK(at(V(-1, -1, 0)) == PointFeatures{vertex_feature(0), {}});
  CHECK(at(V(-1, 1, 0)) == PointFeatures{vertex_feature(2), {}});
  CHECK(at(V(0, -1, 0)) == PointFeatures{edge_feature(0, 1), edge_feature(5, 7)});
  CHECK(at(V(0, 1, 0)) == PointFeatures{edge_feature(2, 3), edge_feature(5, 7)});
  // A vertex of the table under the block's face.
  const auto over_corner = contact::contact_manifold(moved(block, V(0, 4, 0)), table, 0.0);
  REQUIRE(over_corner.points.size() == 4);
  CHECK(std::any_of(over_corner.points.begin(), over_corner.points.end(), [](const auto& p) {
    return p.point == V(0, 4, 0) && p.features == PointFeatures{{}, vertex_feature(7)};
  }));
}

TEST_CASE("the features of a point do not depend on which body has the reference face") {
  const Hull table = prism(8, 5, -1, 0);
  const Hull block = moved(prism(6, 2, 0, 1), V(4, 0.5, 0));
  const auto features_of = [](const ContactManifold<double>& manifold) {
    std::vector<PointFeatures> all;
    for (const auto& p : manifold.points) all.push_back(p.features);
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto flat = features_of(contact::contact_manifold(block, table, 1e-6));
  CHECK(flat.size() > 4);
  for (const double sine : {0x1p-26, -0x1p-26}) {
    CHECK(features_of(contact::contact_manifold(tilted(block, sine), table, 1e-6)) == flat);
    CHECK(features_of(contact::contact_manifold(block, tilted(table, sine), 1e-6)) == flat);
  }
}

TEST_CASE("two parallel ridges touch along the overlap of their edges") {
  // Roofs with their ridges along x: one with its ridge up, one with its ridge down above it.
  const auto roof = [](double from, double to, double top, double down) {
    Hull hull;
    for (const double x : {from, to}) {
      hull.vertices.emplace_back(x, -1, top + down);
      hull.vertices.emplace_back(x, 1, top + down);
      hull.vertices.emplace_back(x, 0, top);
    }
    return hull;
  };
  const Hull below = roof(-2, 3, 0, -1);
  const auto manifold = contact::contact_manifold(roof(1, 5, 0.25, 1), below, 0.5);
  REQUIRE(manifold.points.size() == 2);
  CHECK(manifold.normal == V(0, 0, 1));
  CHECK(manifold.points[0].distance == 0.25);
  CHECK(manifold.points[1].distance == 0.25);
  CHECK(std::min(manifold.points[0].point.x(), manifold.points[1].point.x()) == 1);
  CHECK(std::max(manifold.points[0].point.x(), manifold.points[1].point.x()) == 3);
  // Crossed ridges touch at one point: of two edges.
  Hull crossed = roof(-2, 2, 0.25, 1);
  for (V& v : crossed.vertices) v = V(v.y(), v.x(), v.z());
  const auto one = contact::contact_manifold(crossed, below, 0.5);
  REQUIRE(one.points.size() == 1);
  CHECK((one.points[0].point - V(0, 0, 0.125)).norm() <= 1e-15);
  CHECK(one.points[0].features == PointFeatures{edge_feature(2, 5), edge_feature(2, 5)});
}

TEST_CASE("a triangle on a triangle has the corners of their overlap") {
  const Triangle<double> below{V(-4, -4, 0), V(4, -4, 0), V(0, 4, 0)};
  const Triangle<double> above{V(-1, -2, 0.25), V(1, -2, 0.25), V(0, 0, 0.25)};
  const auto manifold = contact::contact_manifold(above, below, 0.5);
  CHECK(manifold.normal == V(0, 0, 1));
  REQUIRE(manifold.points.size() == 3);
  for (const auto& p : manifold.points) CHECK(p.distance == 0.25);
  CHECK(contact::contact_manifold(below, above, 0.5).normal == V(0, 0, -1));
  CHECK(contact::contact_manifold(above, below, 0.125).points.empty());
}

TEST_CASE("a vertex on a vertex has one point, and the same normal in every run and order") {
  const Hull below = cuboid(V(-1, -1, -1), V(0, 0, 0));
  const Hull above = cuboid(V(0, 0, 0), V(1, 1, 1));
  const auto manifold = contact::contact_manifold(above, below, 0.0);
  REQUIRE(manifold.points.size() == 1);
  CHECK(manifold.points[0].point == V(0, 0, 0));
  CHECK(manifold.points[0].distance == 0);
  // It separates: all of A is in front of the plane, all of B behind.
  for (const V& v : above.vertices) CHECK(manifold.normal.dot(v) >= 0);
  for (const V& v : below.vertices) CHECK(manifold.normal.dot(v) <= 0);
  CHECK(same(exchanged(contact::contact_manifold(below, above, 0.0)), manifold));
  const auto apart = contact::contact_manifold(moved(above, V(0.01, 0.02, 0.02)), below, 0.05);
  REQUIRE(apart.points.size() == 1);
  CHECK((apart.normal - V(1, 2, 2) / 3).norm() <= 1e-13);
  CHECK(apart.points[0].features == PointFeatures{vertex_feature(0), vertex_feature(7)});
}

TEST_CASE("a hull on a floor has each vertex within the margin") {
  const contact::HalfSpace<double> ground{{V(0, 0, 1), 0}};
  Hull hull = prism(5, 1, 0.5, 2);
  hull.radius = 0.5;
  const auto manifold = contact::contact_manifold(hull, ground, 0.0);
  REQUIRE(manifold.points.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(manifold.points[i].features == PointFeatures{vertex_feature(int(i)), {}});
    CHECK(manifold.points[i].point.z() == 0);
  }
  CHECK(contact::contact_manifold(ground, hull, 0.0).normal == V(0, 0, -1));
  CHECK(contact::contact_manifold(tilted(hull, 0.1), ground, 0.0).points.size() == 2);
}

TEST_CASE("bodies that are none have no contact") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Hull good = cuboid(V(-1, -1, -1), V(1, 1, 1));
  const contact::HalfSpace<double> ground{{V(0, 0, 1), 0}};
  for (const Hull& bad : {Hull{}, Hull{{V(nan, 0, 0), V(1, 0, 0)}, 0}, Hull{{V(0, 0, 0)}, nan},
                          Hull{{V(0, 0, std::numeric_limits<double>::infinity())}, 0}}) {
    CHECK(contact::contact_manifold(good, bad, 1.0).points.empty());
    CHECK(contact::contact_manifold(bad, good, 1.0).points.empty());
    CHECK(contact::contact_manifold(bad, ground, -1e300).points.empty());
  }
  CHECK(contact::contact_manifold(good, good, nan).points.empty());
}

TEST_CASE("hulls in float have the manifold of those in double, but for rounding") {
  const auto narrow = [](const Hull& hull) {
    ConvexHull<float> made;
    for (const V& v : hull.vertices) made.vertices.push_back(v.cast<float>());
    return made;
  };
  const Hull table = prism(8, 5, -1, 0);
  for (int n = 3; n <= 9; ++n) {
    const Hull block = moved(prism(n, 2, 0, 1), V(4, 0.5, 0));
    const auto wide = contact::contact_manifold(block, table, 1e-3);
    const auto found = contact::contact_manifold(narrow(block), narrow(table), 1e-3f);
    REQUIRE(found.points.size() == wide.points.size());
    // In an order of their own: rounding decides which of two equal faces is the reference face.
    for (const auto& p : wide.points) {
      CHECK(std::any_of(found.points.begin(), found.points.end(), [&p](const auto& q) {
        return (q.point.template cast<double>() - p.point).norm() <= 1e-5;
      }));
    }
  }
}

}  // namespace hull_manifold_test
