// triangles_meet.hpp against integers on small lattices, at every scale, and against exact
// arithmetic where differences are not exact.
#include <06_triangle_pairs/lattice_pairs.hpp>
#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/triangles_meet.hpp>
#include <limits>
#include <support/generators.hpp>

namespace triangles_meet_test {

using contact::Triangle;
using contact::triangles_meet;
using contact::triangles_meet_unfiltered;
using contact::Vector3;
using lattice_pairs::stored;
using lattice_pairs::Three;
using Points = std::array<Vector3<double>, 6>;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

Triangle<double> first_of(const Points& p) { return {p[0], p[1], p[2]}; }
Triangle<double> second_of(const Points& p) { return {p[3], p[4], p[5]}; }
bool meet(const Points& p) { return triangles_meet(first_of(p), second_of(p)); }

TEST_CASE("all triangles, segments and points of a lattice of 2 x 2 x 2 meet where they do") {
  generators::Random random(1);
  const auto all = lattice_pairs::all_triangles(2);
  int meeting = 0;
  for (const Three& a : all) {
    for (const Three& b : all) {
      const bool right = lattice_pairs::meet(a, b);
      const Three t = lattice_pairs::reordered(random, a), u = lattice_pairs::reordered(random, b);
      REQUIRE(triangles_meet(stored<double>(t), stored<double>(u)) == right);
      REQUIRE(triangles_meet(stored<float>(t), stored<float>(u)) == right);
      if (random.chance(0.1)) {
        REQUIRE(triangles_meet_unfiltered(stored<double>(t), stored<double>(u)) == right);
      }
      meeting += right;
    }
  }
  REQUIRE(meeting > 5000);
  REQUIRE(meeting < 12000);
}

TEST_CASE("triangles, segments and points of larger lattices meet where they do") {
  generators::Random random(2);
  for (const int n : {3, 4, 6}) {
    int meeting = 0;
    const int pairs = generators::tried(60000);
    for (int i = 0; i < pairs; ++i) {
      const Three t = lattice_pairs::any_triangle(random, n);
      const Three u = lattice_pairs::any_triangle(random, n);
      const bool right = lattice_pairs::meet(t, u);
      REQUIRE(triangles_meet(stored<double>(t), stored<double>(u)) == right);
      meeting += right;
    }
    REQUIRE(meeting > pairs / 5);
    REQUIRE(meeting < pairs * 4 / 5);
  }
}

TEST_CASE("the scale of two triangles does not change whether they meet") {
  generators::Random random(3);
  for (int i = 0; i < generators::tried(60000); ++i) {
    const Three t = lattice_pairs::any_triangle(random, 3);
    const Three u = lattice_pairs::any_triangle(random, 3);
    const bool right = lattice_pairs::meet(t, u);
    const double unit = std::ldexp(1.0, random.integer(-1074, 1022));
    CAPTURE(unit);
    REQUIRE(triangles_meet(stored<double>(t, unit), stored<double>(u, unit)) == right);
    const float small = std::ldexp(1.0F, random.integer(-149, 126));
    REQUIRE(triangles_meet(stored<float>(t, small), stored<float>(u, small)) == right);
  }
}

TEST_CASE("the scale of two rounded triangles does not change whether they meet") {
  generators::Random random(9);
  for (int i = 0; i < generators::tried(30000); ++i) {
    const auto family = pair_families::all[static_cast<std::size_t>(i) % pair_families::all.size()];
    const auto pair = pair_families::rounded_pair<double>(random, family);
    const int exponent = i % 4 == 0 ? random.integer(-700, 800) : random.integer(-400, -330);
    const auto scaled = pair_families::scaled(pair, exponent);
    CAPTURE(pair_families::name(family), exponent);
    REQUIRE(triangles_meet(scaled.first, scaled.second) == triangles_meet(pair.first, pair.second));
  }
}

/// A coordinate: few different ones, of which sums and differences are not exact.
double wild(generators::Random& random, int kind) {
  constexpr std::array<double, 8> near{0, 1, 0x1p-60, 0x1p60, 1 + 0x1p-52, 3, 0x1p-30, 0.1};
  constexpr std::array<double, 8> wide{0, 1, smallest, largest, 0x1p-1022, 0x1p500, 0x1p-500, 1};
  constexpr std::array<double, 8> tenths{0, 0.1, 0.2, 0.3, 0.7, 0.1 + 0.2, 1, 0.6};
  const auto i = static_cast<std::size_t>(random.integer(0, 7));
  constexpr std::array<double, 8> powers{0,        1,       0x1p600,  0x1p-700,
                                         0x1p-600, 0x1p500, 0x1p-500, 0x1p400};
  const double x = kind == 0 ? near[i] : kind == 1 ? wide[i] : kind == 2 ? tenths[i] : powers[i];
  return random.chance(0.3) ? -x : x;
}

TEST_CASE("triangles with coordinates of very different sizes meet where exact numbers say") {
  generators::Random random(4);
  int meeting = 0;
  const int pairs = generators::tried(8000);
  for (int i = 0; i < pairs; ++i) {
    Points p;
    for (auto& v : p) {
      for (double& x : v) x = wild(random, i % 4);
    }
    const bool right = pair_truth::meet_exactly(first_of(p), second_of(p));
    REQUIRE(meet(p) == right);
    REQUIRE(triangles_meet_unfiltered(first_of(p), second_of(p)) == right);
    meeting += right;
  }
  REQUIRE(meeting > pairs / 10);
  REQUIRE(meeting < pairs * 9 / 10);
}

TEST_CASE("pairs of all families, moved and rounded, meet where exact numbers say") {
  generators::Random random(5);
  for (const auto family : pair_families::all) {
    CAPTURE(pair_families::name(family));
    for (int i = 0; i < generators::tried(400); ++i) {
      const auto p = pair_families::rounded_pair<double>(random, family);
      REQUIRE(triangles_meet(p.first, p.second) == pair_truth::meet_exactly(p.first, p.second));
      const auto q = pair_families::rounded_pair<float>(random, family);
      REQUIRE(triangles_meet(q.first, q.second) == pair_truth::meet_exactly(q.first, q.second));
    }
  }
}

TEST_CASE("triangles in a tilted plane with rounded coordinates meet where exact numbers say") {
  generators::Random random(6);
  int meeting = 0;
  const int pairs = generators::tried(3000);
  for (int i = 0; i < pairs; ++i) {
    Points p;
    for (auto& v : p) {
      const double x = random.uniform(), y = random.uniform();
      v = i % 3 == 0 ? Vector3<double>(x, x, y) : Vector3<double>(x, y, i % 3 == 1 ? 0.1 : -x);
    }
    if (i % 7 == 0) p[4] = p[3];
    if (i % 5 == 0) p[2] = p[1];
    const bool right = pair_truth::meet_exactly(first_of(p), second_of(p));
    REQUIRE(meet(p) == right);
    meeting += right;
  }
  REQUIRE(meeting > pairs / 3);
}

TEST_CASE("the order of six vertices and of two triangles does not change whether they meet") {
  generators::Random random(7);
  constexpr std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int i = 0; i < generators::tried(3000); ++i) {
    const auto family = pair_families::all[static_cast<std::size_t>(i) % pair_families::all.size()];
    const auto pair = pair_families::rounded_pair<double>(random, family);
    const Points p{pair.first.a,  pair.first.b,  pair.first.c,
                   pair.second.a, pair.second.b, pair.second.c};
    const bool right = meet(p);
    for (const auto& o : orders) {
      for (const auto& q : orders) {
        const Triangle<double> t{p[o[0]], p[o[1]], p[o[2]]};
        const Triangle<double> u{p[3 + q[0]], p[3 + q[1]], p[3 + q[2]]};
        REQUIRE(triangles_meet(t, u) == right);
        REQUIRE(triangles_meet(u, t) == right);
      }
    }
  }
}

TEST_CASE("a vertex the smallest number off a face, an edge or a vertex does not touch it") {
  const Triangle<double> face{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto with = [](const Vector3<double>& v) {
    return Triangle<double>{v, {v.x() - 1, v.y() - 1, 3}, {v.x() - 1, v.y() - 2, 3}};
  };
  const auto touches = [&](double x, double y, double z) {
    return triangles_meet(face, with({x, y, z})) && triangles_meet(with({x, y, z}), face);
  };
  REQUIRE(touches(1, 1, 0));
  REQUIRE(touches(1, 1, -0.0));
  REQUIRE_FALSE(touches(1, 1, smallest));
  REQUIRE(touches(1, 1, -smallest));
  REQUIRE(touches(2, 2, 0));
  REQUIRE_FALSE(touches(std::nextafter(2, 3), 2, 0));
  REQUIRE(touches(std::nextafter(2, 1), 2, 0));
  REQUIRE(touches(4, 0, 0));
  REQUIRE_FALSE(touches(std::nextafter(4, 5), 0, 0));
  REQUIRE_FALSE(touches(0, -smallest, 0));
}

TEST_CASE("triangles as large as numbers can be meet where they do") {
  const Triangle<double> face{{-largest, -largest, 0}, {largest, -largest, 0}, {0, largest, 0}};
  const auto through = [](double x, double y) {
    return Triangle<double>{{x, y, largest}, {x, y, -largest}, {-largest, largest, largest}};
  };
  REQUIRE(triangles_meet(face, through(0, 0)));
  REQUIRE(triangles_meet(face, through(0, largest)));
  REQUIRE(triangles_meet(face, through(-largest, -largest)));
  REQUIRE_FALSE(triangles_meet(face, through(-largest, largest)));
  REQUIRE(triangles_meet(face, face));
}

TEST_CASE("a triangle with a coordinate that is not finite meets nothing") {
  generators::Random random(8);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Three t = lattice_pairs::any_triangle(random, 3);
    for (const double bad :
         {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
      Triangle<double> first = stored<double>(t), second = stored<double>(t);
      if (i % 2 == 0) second.a = {0.25, 0.5, 2};
      auto& v = i % 3 == 0 ? first.a : i % 3 == 1 ? first.b : first.c;
      v[random.integer(0, 2)] = bad;
      REQUIRE_FALSE(triangles_meet(first, second));
      REQUIRE_FALSE(triangles_meet(second, first));
      REQUIRE_FALSE(triangles_meet(first, first));
      REQUIRE_FALSE(triangles_meet_unfiltered(first, second));
    }
  }
}

}  // namespace triangles_meet_test
