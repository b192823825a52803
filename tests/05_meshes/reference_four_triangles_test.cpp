#include <05_meshes/lines_at_meshes.hpp>
#include <contact/four_triangles.hpp>
#include <contact/mesh_times.hpp>
#include <contact/mesh_tree.hpp>

namespace four_triangles {

using namespace lines_at_meshes;
using contact::Determinant;
using contact::detail::FourTriangles;

struct Counts {
  int met = 0, missed = 0, left = 0;
};

/// Compares a line with the triangles of a mesh, four at a time: none that is met may be missed.
template <class Line>
Counts compare(const Line& line, const Mesh<double>& mesh) {
  const contact::MeshTree<double> tree(mesh);
  const auto& triangles = tree.ordered_triangles();
  Counts counts;
  if (triangles.empty()) return counts;
  const contact::detail::WideFrame frame(tree.boxes().nodes[0].box);
  const auto wide = contact::detail::wide_line(line, frame);
  if (!wide.tame || wide.misses) return counts;
  for (std::size_t from = 0; from < triangles.size(); from += 4) {
    FourTriangles four;
    four.count = static_cast<int>(std::min<std::size_t>(4, triangles.size() - from));
    for (std::size_t i = 0; i < static_cast<std::size_t>(four.count); ++i) {
      four.put(frame, i, triangles[from + i]);
    }
    const unsigned left = contact::detail::possible_hits(four, wide);
    REQUIRE(left >> four.count == 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(four.count); ++i) {
      const bool meets = contact::intersect_exact(line, triangles[from + i]).has_value();
      const bool is_left = (left >> i & 1) != 0;
      REQUIRE((is_left || !meets));
      ++(meets ? counts.met : is_left ? counts.left : counts.missed);
    }
  }
  return counts;
}

TEST_CASE("of four triangles compared in floats, none that the line meets is lost") {
  Random random(1201);
  Counts sum;
  const int meshes = generators::tried(280);
  for (int m = 0; m < meshes; ++m) {
    const int kind = m % mesh_kinds;
    const Mesh<double> mesh = mesh_of_kind(random, kind);
    for (int i = 0; i < 10; ++i) {
      INFO("kind " << kind << ", mesh " << m << ", line " << i);
      with_line<double>(line_at(random, mesh), [&](const auto& line) {
        const Counts counts = compare(line, mesh);
        sum.met += counts.met;
        sum.missed += counts.missed;
        sum.left += counts.left;
      });
    }
  }
  CHECK(sum.met > meshes * 20);
  CHECK(sum.missed > sum.left);
}

TEST_CASE("of the triangles of a ball that a random ray misses, fewer than 1 in 500 are left") {
  Random random(1202);
  const Mesh<double> mesh = contact::ball_mesh(1.0, 3);
  Counts sum;
  for (int i = 0; i < generators::tried(200); ++i) {
    const Counts counts = compare(Ray<double>{3 * in_cube(random), in_cube(random)}, mesh);
    sum.missed += counts.missed;
    sum.left += counts.left;
  }
  CHECK(sum.left * 500 < sum.missed);
}

/// Counts the determinants of a query whose sign integers of fixed size give; it must be that of
/// exact numbers.
template <class Line>
int quick_signs(const Line& line, const Triangle<double>& triangle) {
  if (!contact::is_finite(line)) return 0;
  const auto exact = contact::detail::differences_of<contact::Exact>(line, triangle);
  int given = 0;
  for (const Determinant which : {Determinant::of_a, Determinant::of_b, Determinant::of_c,
                                  Determinant::start, Determinant::end, Determinant::denominator}) {
    if (which == Determinant::end && !contact::has_end<Line>) continue;
    const std::optional<int> quick = contact::detail::quick_sign(line, triangle, which);
    if (!quick) continue;
    REQUIRE(*quick == contact::detail::exact_determinant(exact, which).sign());
    ++given;
  }
  return given;
}

TEST_CASE("integers of fixed size give the signs of exact numbers") {
  Random random(1203);
  int given = 0, asked = 0;
  const int meshes = generators::tried(140);
  for (int m = 0; m < meshes; ++m) {
    const int kind = m % mesh_kinds;
    if (kind == 12) continue;  // not finite
    const Mesh<double> mesh = mesh_of_kind(random, kind);
    for (int i = 0; i < 10; ++i) {
      INFO("kind " << kind << ", mesh " << m << ", line " << i);
      const int last = static_cast<int>(mesh.triangles.size()) - 1;
      const auto at = static_cast<std::size_t>(random.integer(0, last));
      const Triangle<double> triangle = contact::triangle_of(mesh, at);
      with_line<double>(line_at(random, mesh), [&](const auto& line) {
        given += quick_signs(line, triangle);
        asked += 5;
      });
    }
  }
  CHECK(given * 2 > asked);
}

}  // namespace four_triangles
