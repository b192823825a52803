// pair_orientations.hpp: right where its signs are, on small lattices and in exact arithmetic.
#include <06_triangle_pairs/lattice_pairs.hpp>
#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <contact/exact.hpp>
#include <contact/pair_orientations.hpp>
#include <support/generators.hpp>
#include <vector>

namespace pair_orientations_test {

using contact::meet_by_orientations;
using lattice_pairs::stored;
using lattice_pairs::Three;

TEST_CASE("orientations of small whole numbers decide all triangles with area of 2 x 2 x 2") {
  generators::Random random(1);
  int asked = 0;
  for (const Three& a : lattice_pairs::all_triangles(2)) {
    for (const Three& b : lattice_pairs::all_triangles(2)) {
      if (!lattice_pairs::has_area(a) || !lattice_pairs::has_area(b)) continue;
      const Three t = lattice_pairs::reordered(random, a), u = lattice_pairs::reordered(random, b);
      REQUIRE(meet_by_orientations(stored<double>(t), stored<double>(u)) ==
              lattice_pairs::meet(a, b));
      ++asked;
    }
  }
  REQUIRE(asked > 3000);
}

/// The triangles with area of a flat lattice of 4 x 4, on the plane 2x − y + 3z = 0 or z = 1.
std::vector<Three> flat_triangles(bool tilted) {
  std::vector<Three> all;
  const auto point = [tilted](long i) -> lattice_pairs::Point {
    const long x = i % 4, y = i / 4;
    return tilted ? lattice_pairs::Point{x - y, 2 * x + y, y} : lattice_pairs::Point{x, y, 1};
  };
  for (long i = 0; i < 16; ++i) {
    for (long j = 0; j < i; ++j) {
      for (long k = 0; k < j; ++k) {
        const Three t{point(i), point(j), point(k)};
        if (lattice_pairs::has_area(t)) all.push_back(t);
      }
    }
  }
  return all;
}

TEST_CASE("orientations of small whole numbers decide all triangles of a flat lattice of 4 x 4") {
  generators::Random random(2);
  for (const bool tilted : {false, true}) {
    const std::vector<Three> all = flat_triangles(tilted);
    REQUIRE(all.size() == 516);
    int meeting = 0, asked = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (!random.chance(generators::tried(16) / 64.0)) continue;
        const Three t = lattice_pairs::reordered(random, all[i]);
        const Three u = lattice_pairs::reordered(random, all[j]);
        const bool right = lattice_pairs::meet(t, u);
        REQUIRE(meet_by_orientations(stored<double>(t), stored<double>(u)) == right);
        meeting += right;
        ++asked;
      }
    }
    REQUIRE(meeting > asked / 4);
    REQUIRE(meeting < asked);
  }
}

bool has_area(const contact::Triangle<contact::Exact>& t) {
  const contact::Vector3<contact::Exact> n = contact::pair_orientations_detail::normal_of(t);
  return n[0].sign() != 0 || n[1].sign() != 0 || n[2].sign() != 0;
}

TEST_CASE("orientations in exact arithmetic decide triangles with area, rounded ones do not") {
  generators::Random random(3);
  int wrong = 0, asked = 0;
  for (const auto family : pair_families::all) {
    CAPTURE(pair_families::name(family));
    for (int i = 0; i < generators::tried(500); ++i) {
      const auto p = pair_families::pair<double>(random, family);
      const auto exact = [](const contact::Triangle<double>& t) {
        const auto point = [](const contact::Vector3<double>& v) {
          return contact::Vector3<contact::Exact>(v.x(), v.y(), v.z());
        };
        return contact::Triangle<contact::Exact>{point(t.a), point(t.b), point(t.c)};
      };
      if (!has_area(exact(p.first)) || !has_area(exact(p.second))) continue;
      const bool right = pair_truth::meet_in_integers(p.first, p.second);
      REQUIRE(meet_by_orientations(exact(p.first), exact(p.second)) == right);
      wrong += meet_by_orientations(p.first, p.second) != right;
      ++asked;
    }
  }
  REQUIRE(asked > generators::tried(5000));
  REQUIRE(wrong > asked / 50);
}

TEST_CASE("the apex is the vertex whose two edges reach the plane") {
  using contact::pair_orientations_detail::apex;
  using contact::pair_orientations_detail::Sides;
  for (int i = 0; i < 27; ++i) {
    const Sides s{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    if (*std::min_element(s.begin(), s.end()) == *std::max_element(s.begin(), s.end())) continue;
    CAPTURE(s[0], s[1], s[2]);
    const auto [index, front] = apex(s);
    const int sign = front ? 1 : -1;
    const int own = sign * s[index], next = sign * s[(index + 1U) % 3];
    const int last = sign * s[(index + 2U) % 3];
    if (*std::min_element(s.begin(), s.end()) == 0 || *std::max_element(s.begin(), s.end()) == 0) {
      // All on one side or on the plane: from the apex both edges end there, or it is there alone.
      REQUIRE(((own == 1 && next == 0 && last == 0) || (own == 0 && next == -1 && last == -1)));
    } else {
      REQUIRE(own == 1);
      REQUIRE(next <= 0);
      REQUIRE(last <= 0);
    }
  }
}

}  // namespace pair_orientations_test
