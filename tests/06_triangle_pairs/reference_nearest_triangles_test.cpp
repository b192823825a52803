// The kinds of contact and the nearest features of two triangles, against fractions.
#include <06_triangle_pairs/common_points_truth.hpp>
#include <06_triangle_pairs/drawn.hpp>
#include <contact/nearest_triangles.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace nearest_triangles_tests {

using common_points_truth::Vertices;
using contact::ContactKind;
using contact::ExactFraction;
using contact::Feature;
using contact::FeatureKind;
using contact::Triangle;
using contact::Vector3;
using drawn::anywhere;
using drawn::whole;
using generators::Random;
using oracle::Rational;
using oracle::Vector;

// ---------------------------------------------------------------- kinds

TEST_CASE("the kind of a contact does not depend on the order of the features") {
  using enum FeatureKind;
  CHECK(contact::contact_kind(vertex, vertex) == ContactKind::point_point);
  CHECK(contact::contact_kind(edge, edge) == ContactKind::edge_edge);
  CHECK(contact::contact_kind(face, face) == ContactKind::face_face);
  CHECK(contact::contact_kind(vertex, edge) == ContactKind::point_edge);
  CHECK(contact::contact_kind(edge, vertex) == ContactKind::point_edge);
  CHECK(contact::contact_kind(vertex, face) == ContactKind::point_face);
  CHECK(contact::contact_kind(face, vertex) == ContactKind::point_face);
  CHECK(contact::contact_kind(edge, face) == ContactKind::edge_face);
  CHECK(contact::contact_kind(face, edge) == ContactKind::edge_face);
}

// ---------------------------------------------------------------- nearest features

/// The squared distance of a point of one triangle, given by weights, from the other, by testing
/// all features.
Rational squared_distance(const Vector& x, const Vertices& t) {
  const Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
  if (normal.dot(normal) != 0) {
    const Vector foot = x - normal * Rational(normal.dot(x - t[0]) / normal.dot(normal));
    if (common_points_truth::feature_at(foot, t)) return (x - foot).dot(x - foot);
  }
  Rational least = (x - t[0]).dot(x - t[0]);
  for (int i = 0; i < 3; ++i) {
    const Vector from = common_points_truth::at(t, i);
    const Vector step = common_points_truth::at(t, i + 1) - from;
    const Rational whole = step.dot(step);
    Rational along = whole == 0 ? Rational(0) : Rational(step.dot(x - from) / whole);
    along = std::min(std::max(along, Rational(0)), Rational(1));
    const Vector off = x - (from + step * along);
    least = std::min(least, Rational(off.dot(off)));
  }
  return least;
}
/// Off by at most half an ulp.
Rational rounded_rational(const ExactFraction& x) { return oracle::exact(x.nearest()); }

TEST_CASE("no point of a triangle is nearer to the other than the nearest features say") {
  Random random(21);
  for (int i = 0; i < generators::tried(600); ++i) {
    const Triangle<double> s{whole(random, 3), whole(random, 3), whole(random, 3)};
    const Triangle<double> t{whole(random, 3), whole(random, 3), whole(random, 3)};
    const auto near = contact::nearest_of_triangles_exactly(s, t);
    const Vertices a = common_points_truth::vertices(s), b = common_points_truth::vertices(t);
    if (near.squared_distance == ExactFraction(0)) {
      REQUIRE(!common_points_truth::candidates(a, b).empty());
      continue;
    }
    REQUIRE(near.kind != ContactKind::edge_face);
    REQUIRE(near.kind != ContactKind::face_face);
    // The two points are on the triangles, on these features, and have this distance.
    const Vector3<ExactFraction> off = near.on_first - near.on_second;
    REQUIRE(off.dot(off) == near.squared_distance);
    for (int u = 0; u <= 6; ++u) {
      for (int v = 0; u + v <= 6; ++v) {
        const Vector x = a[0] + (a[1] - a[0]) * Rational(u, 6) + (a[2] - a[0]) * Rational(v, 6);
        const Rational sampled = squared_distance(x, b);
        REQUIRE(rounded_rational(near.squared_distance) <= sampled * Rational(1.0 + 0x1p-52));
      }
    }
  }
}

TEST_CASE("the nearest points are on the features that are named") {
  Random random(22);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Triangle<double> s{whole(random, 3), whole(random, 3), whole(random, 3)};
    const Triangle<double> t{whole(random, 3), whole(random, 3), whole(random, 3)};
    const auto near = contact::nearest_of_triangles_exactly(s, t);
    if (near.squared_distance == ExactFraction(0)) continue;
    const auto check = [](const Vector3<ExactFraction>& x, const Feature& f,
                          const Triangle<double>& of) {
      // A vertex is itself; a foot on an edge or a face has weights that are quotients: compare in
      // double.
      const std::array<Vector3<double>, 3> v{of.a, of.b, of.c};
      const auto k = static_cast<std::size_t>(f.index);
      const Vector3<double> p(x[0].nearest(), x[1].nearest(), x[2].nearest());
      if (f.kind == FeatureKind::vertex) REQUIRE(p == v[k]);
      if (f.kind == FeatureKind::edge) {
        const Vector3<double> step = v[(k + 1) % 3] - v[k], to = p - v[k];
        REQUIRE(step.cross(to).cwiseAbs().maxCoeff() < 1e-12);
        REQUIRE(step.dot(to) > 0);
        REQUIRE(step.dot(to) < step.dot(step));
      }
      if (f.kind == FeatureKind::face) {
        const Vector3<double> normal = (of.b - of.a).cross(of.c - of.a);
        REQUIRE(std::abs(normal.dot(p - of.a)) < 1e-11);
      }
    };
    check(near.on_first, near.of_first, s);
    check(near.on_second, near.of_second, t);
  }
}

TEMPLATE_TEST_CASE("the rounded distance is close to the exact one", "", float, double) {
  Random random(23);
  const double unit = std::is_same_v<TestType, float> ? 0x1p-20 : 0x1p-44;
  for (int i = 0; i < generators::tried(1000); ++i) {
    const auto any = [&] { return generators::rounded<TestType>(anywhere(random)); };
    const Triangle<TestType> s{any(), any(), any()}, t{any(), any(), any()};
    const auto got = contact::nearest_of_triangles(s, t);
    const auto right = contact::nearest_of_triangles_exactly(s, t);
    REQUIRE(std::abs(double(got.squared_distance) - right.squared_distance.nearest()) <= unit);
    const Vector3<double> off = (got.on_first - got.on_second).template cast<double>();
    REQUIRE(std::abs(off.dot(off) - double(got.squared_distance)) <= unit);
    REQUIRE((got.squared_distance == 0) ==
            (contact::common_points(s, t) != contact::CommonPoints::none));
  }
}

TEST_CASE("distances from 1e-150 to 1e150 neither vanish nor become NaN") {
  // A vertex over a face; two edges.
  const Triangle<double> s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::array<Triangle<double>, 2> others{
      Triangle<double>{{0.25, 0.25, 2}, {1, 0, 3}, {0, 1, 3}},
      Triangle<double>{{0.5, -1, 1}, {0.5, 1, 2}, {0.5, -1, 3}}};
  for (const Triangle<double>& t : others) {
    const auto right = contact::nearest_of_triangles(s, t);
    for (int e = -500; e <= 500; e += 50) {
      const double f = std::ldexp(1.0, e);
      const auto got = contact::nearest_of_triangles<double>({s.a * f, s.b * f, s.c * f},
                                                             {t.a * f, t.b * f, t.c * f});
      CHECK(got.squared_distance == std::ldexp(right.squared_distance, 2 * e));
      CHECK(got.on_first == right.on_first * f);
      CHECK(got.kind == right.kind);
    }
  }
  constexpr double huge = std::numeric_limits<double>::max();
  const auto far = contact::nearest_of_triangles<double>({{huge, 0, 0}, {huge, 1, 0}, {huge, 0, 1}},
                                                         {{-huge, 0, 0}, {-huge, 1, 0}, {0, 0, 1}});
  CHECK(far.squared_distance == std::numeric_limits<double>::infinity());
  CHECK(contact::all_finite(far.on_first));
  CHECK(contact::all_finite(far.on_second));
}

TEST_CASE("the distance of triangles that are not finite is NaN") {
  const Triangle<double> s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Triangle<double> t = s;
  t.a.x() = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(contact::nearest_of_triangles(s, t).squared_distance));
}

TEST_CASE("triangles that cross have the distance 0, and the fifteen pairs do not") {
  const Triangle<double> plate{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}};
  const Triangle<double> blade{{0, 0, -1}, {0.5, 0, 1}, {-0.5, 0, 1}};
  CHECK(contact::nearest_of_triangles(plate, blade).squared_distance == 0);
  CHECK(contact::nearest_of_triangles(plate, blade).kind == ContactKind::edge_face);
  CHECK(contact::nearest_of_apart_triangles(plate, blade).squared_distance == 1);
}

}  // namespace nearest_triangles_tests
