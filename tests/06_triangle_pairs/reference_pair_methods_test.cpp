// pair_methods.hpp: each method is right in exact arithmetic within its limits, and each limit that
// a comment names is real.
#include <06_triangle_pairs/lattice_pairs.hpp>
#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/pair_methods.hpp>
#include <support/generators.hpp>
#include <support/oracle.hpp>

namespace pair_methods_test {

using contact::Triangle;
using contact::Vector3;
using lattice_pairs::stored;
using lattice_pairs::Three;
using oracle::Rational;
using Exactly = Triangle<Rational>;

/// Two triangles with area of the lattice of n³ points, and whether they meet.
struct Asked {
  Exactly first, second;
  bool right;
  bool in_one_plane;
};
Asked any_pair(generators::Random& random, int n) {
  for (;;) {
    const Three t = lattice_pairs::any_triangle(random, n);
    const Three u = lattice_pairs::any_triangle(random, n);
    if (!lattice_pairs::has_area(t) || !lattice_pairs::has_area(u)) continue;
    using lattice_pairs::minus;
    const auto normal = lattice_pairs::cross(minus(t[1], t[0]), minus(t[2], t[0]));
    bool flat = true;
    for (const auto& p : u) flat = flat && lattice_pairs::dot(normal, minus(p, t[0])) == 0;
    return {stored<Rational>(t), stored<Rational>(u), lattice_pairs::meet(t, u), flat};
  }
}

/// How many pairs meet, do not, and are in one plane.
struct Seen {
  int meet = 0, apart = 0, in_one_plane = 0;
  void count(const Asked& asked) {
    ++(asked.right ? meet : apart);
    in_one_plane += asked.in_one_plane;
  }
  void require_all() const {
    REQUIRE(meet > 100);
    REQUIRE(apart > 100);
    REQUIRE(in_one_plane > 5);
  }
};

TEST_CASE(
    "the lecture's steps without rounding decide all pairs with area but those in one plane") {
  generators::Random random(1);
  Seen seen;
  for (int i = 0; i < generators::tried(8000); ++i) {
    const Asked asked = any_pair(random, 3);
    const auto found = contact::meet_by_steps(asked.first, asked.second);
    REQUIRE(found.coplanar == asked.in_one_plane);
    REQUIRE(found.meet == (asked.right && !asked.in_one_plane));
    REQUIRE(found.decided_in == (found.coplanar ? 0 : found.crosses_plane ? 4 : 2));
    seen.count(asked);
  }
  seen.require_all();
}

TEST_CASE("p and q are on the border of the first triangle and in the plane of the second") {
  generators::Random random(2);
  int two = 0, one = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Asked asked = any_pair(random, 3);
    const auto found = contact::meet_by_steps(asked.first, asked.second);
    if (!found.crosses_plane) continue;
    const auto normal = contact::pair_methods_detail::normal_of(asked.second);
    const auto& [a, b, c] = asked.first;
    for (const auto& x : {found.p, found.q}) {
      const Vector3<Rational> from_plane = x - asked.second.a;
      REQUIRE(normal.dot(from_plane) == 0);
      const auto on = [&x](const Vector3<Rational>& from, const Vector3<Rational>& to) {
        const Vector3<Rational> back = from - x, forth = to - x;
        const Vector3<Rational> across = back.cross(forth);
        return across.dot(across) == 0 && back.dot(forth) <= 0;
      };
      REQUIRE((on(a, b) || on(b, c) || on(c, a)));
    }
    ++(found.p == found.q ? one : two);
  }
  REQUIRE(two > 100);
  REQUIRE(one > 10);
}

TEST_CASE("intervals without rounding decide all pairs with area") {
  generators::Random random(3);
  Seen seen;
  for (int i = 0; i < generators::tried(8000); ++i) {
    const Asked asked = any_pair(random, 3);
    REQUIRE(contact::meet_by_intervals(asked.first, asked.second) == asked.right);
    seen.count(asked);
  }
  seen.require_all();
}

TEST_CASE("six edges without rounding decide all pairs with area but those in one plane") {
  generators::Random random(4);
  Seen seen;
  for (int i = 0; i < generators::tried(8000); ++i) {
    const Asked asked = any_pair(random, 3);
    REQUIRE(contact::meet_by_edges(asked.first, asked.second) ==
            (asked.right && !asked.in_one_plane));
    seen.count(asked);
  }
  seen.require_all();
}

TEST_CASE("seventeen axes without rounding decide all pairs with area") {
  generators::Random random(5);
  Seen seen;
  for (int i = 0; i < generators::tried(8000); ++i) {
    const Asked asked = any_pair(random, 3);
    REQUIRE(contact::meet_by_axes(asked.first, asked.second) == asked.right);
    seen.count(asked);
  }
  seen.require_all();
}

TEST_CASE("each rounded method is wrong for some pairs that touch") {
  generators::Random random(6);
  int steps = 0, intervals = 0, edges = 0, axes = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const auto [t, u] = pair_families::pair<double>(random, pair_families::Family::vertex_on_edge);
    const bool right = pair_truth::meet_in_integers(t, u);
    steps += contact::meet_by_steps(t, u).meet != right;
    intervals += contact::meet_by_intervals(t, u) != right;
    edges += contact::meet_by_edges(t, u) != right;
    axes += contact::meet_by_axes(t, u) != right;
  }
  REQUIRE(steps > 10);
  REQUIRE(intervals > 10);
  REQUIRE(edges > 10);
  REQUIRE(axes > 10);
}

TEST_CASE("an epsilon takes small triangles one above the other for coplanar ones") {
  const auto square = [](double size, double z) {
    return Triangle<double>{{0, 0, z}, {size, 0, z}, {0, size, z}};
  };
  REQUIRE_FALSE(contact::meet_by_intervals(square(1, 0), square(1, 0.1), 1e-6));
  REQUIRE_FALSE(contact::meet_by_intervals(square(0.001, 0), square(0.001, 0.1)));
  REQUIRE(contact::meet_by_intervals(square(0.001, 0), square(0.001, 0.1), 1e-6));
}

TEST_CASE("the steps have no answer for triangles in one plane, and say so") {
  const Triangle<double> t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, u{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  const auto found = contact::meet_by_steps(t, u);
  REQUIRE(found.coplanar);
  REQUIRE_FALSE(found.meet);
  REQUIRE(found.decided_in == 0);
  REQUIRE_FALSE(found.crosses_plane);
  REQUIRE_FALSE(contact::meet_by_edges(t, u));
  REQUIRE(contact::meet_by_intervals(t, u));
  REQUIRE(contact::meet_by_axes(t, u));
}

}  // namespace pair_methods_test
