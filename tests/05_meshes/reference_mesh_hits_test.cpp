#include <02_triangles/truth.hpp>
#include <05_meshes/lines_at_meshes.hpp>
#include <contact/watertight.hpp>

namespace {

using namespace lines_at_meshes;
using contact::MeshFeature;

/// A point in which the line meets the mesh: its t, and the lowest triangle that has it.
struct Right {
  int triangle;
  truth::Hit hit;
};

/// All of them, by whole numbers and another method: the crossing with each plane, edge by edge.
template <class S, class Line>
std::vector<Right> right_hits(const Line& line, const Mesh<S>& mesh) {
  std::vector<Right> all;
  if (!contact::is_finite(line)) return all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<S> t = contact::triangle_of(mesh, i);
    if (!contact::all_finite(t.a) || !contact::all_finite(t.b) || !contact::all_finite(t.c)) {
      continue;
    }
    if (const auto hit = truth::meet(line, t)) all.push_back({static_cast<int>(i), *hit});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Right& x, const Right& y) { return x.hit.t < y.hit.t; });
  const auto last = std::unique(all.begin(), all.end(),
                                [](const Right& x, const Right& y) { return x.hit.t == y.hit.t; });
  all.erase(last, all.end());
  return all;
}

template <class S>
void check_hit(const MeshHit<S>& got, const Right& right, const Mesh<S>& mesh) {
  REQUIRE(got.triangle == right.triangle);
  constexpr double rounding = std::is_same_v<S, float> ? 0x1p-23 : 0;
  const double t = oracle::nearest(right.hit.t);
  if (std::abs(t) < std::numeric_limits<S>::max()) {
    REQUIRE(oracle::error(double(got.hit.t), right.hit.t) <=
            (0x1p-40 + rounding) * std::max(1.0, std::abs(t)));
  }
  const auto& vertices = mesh.triangles[std::size_t(got.triangle)];
  int zeros = 0, kept = 0;
  for (int k = 0; k < 3; ++k) {
    const S weight = got.hit.barycentric[k];
    REQUIRE(weight >= S(0));
    REQUIRE(weight <= S(1));
    REQUIRE(oracle::error(double(weight), right.hit.weights[k]) <= 0x1p-30 + rounding);
    if (right.hit.weights[k] == 0) {
      REQUIRE(weight == S(0));
      ++zeros;
    } else {
      kept = k;
    }
  }
  if (zeros == 0) {
    REQUIRE(got.feature == MeshFeature::face);
    REQUIRE(got.feature_vertices == std::array{-1, -1});
  } else if (zeros == 2) {
    REQUIRE(got.feature == MeshFeature::vertex);
    REQUIRE(got.feature_vertices == std::array{vertices[std::size_t(kept)], -1});
    REQUIRE(got.point == mesh.vertices[std::size_t(vertices[std::size_t(kept)])]);
  } else {
    REQUIRE(got.feature == MeshFeature::edge);
    REQUIRE(got.feature_vertices[0] <= got.feature_vertices[1]);
    for (int k = 0; k < 3; ++k) {
      const int vertex = vertices[std::size_t(k)];
      const bool named = vertex == got.feature_vertices[0] || vertex == got.feature_vertices[1];
      if (right.hit.weights[k] != 0) REQUIRE(named);
    }
  }
  const Triangle<S> triangle = contact::triangle_of(mesh, std::size_t(got.triangle));
  for (int k = 0; k < 3; ++k) {
    REQUIRE(got.point[k] >= std::min({triangle.a[k], triangle.b[k], triangle.c[k]}));
    REQUIRE(got.point[k] <= std::max({triangle.a[k], triangle.b[k], triangle.c[k]}));
  }
}

template <class S>
void against_whole_numbers(int meshes, std::uint64_t seed) {
  Random random(seed);
  int met = 0, at_edges = 0, shared = 0;
  for (int m = 0; m < generators::tried(meshes); ++m) {
    const int kind = m % mesh_kinds;
    const Mesh<double> drawn = mesh_of_kind(random, kind);
    const Mesh<S> mesh = mesh_in<S>(drawn);
    for (int i = 0; i < 6; ++i) {
      INFO("kind " << kind << ", mesh " << m << ", line " << i);
      with_line<S>(line_at(random, drawn), [&](const auto& line) {
        const std::vector<Right> right = right_hits(line, mesh);
        const auto first = contact::first_mesh_hit(line, mesh);
        const auto all = contact::all_mesh_hits(line, mesh);
        REQUIRE(first.has_value() == !right.empty());
        REQUIRE(contact::any_mesh_hit(line, mesh) == !right.empty());
        REQUIRE(all.size() == right.size());
        for (std::size_t k = 0; k < all.size(); ++k) check_hit(all[k], right[k], mesh);
        if (!first) return;
        REQUIRE(same(*first, all[0]));
        ++met;
        if (first->feature != MeshFeature::face) ++at_edges;
        if (all.size() > 1) ++shared;
      });
    }
  }
  CHECK(met > generators::tried(meshes));
  CHECK(at_edges > generators::tried(meshes) / 2);
  CHECK(shared > generators::tried(meshes) / 2);
}

TEST_CASE("hits of a mesh are those of whole numbers: which, in which order, on what") {
  against_whole_numbers<double>(420, 81);
  against_whole_numbers<float>(420, 82);
}

TEST_CASE("t and weights are right however far away the line starts") {
  Random random(83);
  int met = 0;
  const int lines = generators::tried(200);
  for (int i = 0; i < lines; ++i) {
    INFO("line " << i);
    Mesh<double> mesh;
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(in_cube(random));
    mesh.triangles = {{0, 1, 2}};
    const Point target = 0.4 * mesh.vertices[0] + 0.35 * mesh.vertices[1] + 0.25 * mesh.vertices[2];
    const Point start = std::ldexp(1.0, random.integer(0, 40)) * in_cube(random);
    const auto check = [&](const auto& line) {
      const std::vector<Right> right = right_hits(line, mesh);
      const auto first = contact::first_mesh_hit(line, mesh);
      REQUIRE(first.has_value() == !right.empty());
      if (!first) return;
      check_hit(*first, right[0], mesh);
      ++met;
    };
    check(Ray<double>{start, target - start});
    check(Segment<double>{start, target + random.uniform(0, 1) * (target - start)});
  }
  CHECK(met > lines);
}

TEST_CASE("an edge, a vertex and a diagonal count once") {
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {2, 2, 2});
  // Through two opposite corners, along the diagonal of the cube.
  const auto corners = contact::all_mesh_hits(Ray<double>{{-1, -1, -1}, {1, 1, 1}}, box);
  REQUIRE(corners.size() == 2);
  CHECK(corners[0].feature == MeshFeature::vertex);
  CHECK(corners[0].point == Point(0, 0, 0));
  CHECK(corners[1].point == Point(2, 2, 2));
  // Through the middle of an edge and out through the opposite one.
  const auto edges = contact::all_mesh_hits(Ray<double>{{-1, -1, 1}, {1, 1, 0}}, box);
  REQUIRE(edges.size() == 2);
  CHECK(edges[0].feature == MeshFeature::edge);
  CHECK(edges[0].hit.t == 1);
  CHECK(edges[1].hit.t == 3);
  // Each triangle by itself: two at each edge.
  const auto by_triangles = [&box](const Ray<double>& ray) {
    return contact::all_hits_by_triangles(ray, box, [](const auto& line, const auto& triangle) {
      return contact::intersect_moller_trumbore(line, triangle);
    });
  };
  CHECK(by_triangles({{-1, -1, 1}, {1, 1, 0}}).size() == 4);
  CHECK(by_triangles({{-1, -1, -1}, {1, 1, 1}}).size() > 2);
  // It touches an edge from outside: one hit, although the line is never inside.
  CHECK(contact::all_mesh_hits(Ray<double>{{-1, 1, 1}, {1, -1, 0}}, box).size() == 1);
}

TEST_CASE("a line in the plane of a face meets the edges of the flat region") {
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {2, 2, 2});
  const auto along = contact::all_mesh_hits(Ray<double>{{-1, 0.5, 2}, {1, 0, 0}}, box);
  REQUIRE(along.size() == 2);
  CHECK(along[0].hit.t == 1);
  CHECK(along[1].hit.t == 3);
  CHECK(along[0].feature == MeshFeature::edge);
  // It ends in the face: nothing but the edge where it enters.
  const Segment<double> into{{-1, 0.5, 2}, {1, 0.5, 2}};
  CHECK(contact::all_mesh_hits(into, box).size() == 1);
  // All of it is in the face.
  CHECK_FALSE(contact::any_mesh_hit(Segment<double>{{0.5, 0.5, 2}, {1.5, 0.5, 2}}, box));
  // Along an edge: its two faces are both seen edge-on, their neighbours are met at its ends.
  const auto edge = contact::all_mesh_hits(Ray<double>{{-1, 0, 0}, {1, 0, 0}}, box);
  REQUIRE(edge.size() == 2);
  CHECK(edge[0].feature == MeshFeature::vertex);
  // A flat mesh by itself has no neighbours in another plane.
  CHECK_FALSE(contact::any_mesh_hit(Ray<double>{{1, -1, 0.5}, {0, 1, 0}}, flat_square(2, 0)));
}

TEST_CASE("nothing is met by nothing") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Mesh<double> box = contact::box_mesh({0, 0, 0}, {2, 2, 2});
  CHECK_FALSE(contact::first_mesh_hit(Ray<double>{{1, 1, 2}, {0, 0, 0}}, box));
  CHECK_FALSE(contact::first_mesh_hit(Segment<double>{{1, 1, 2}, {1, 1, 2}}, box));
  CHECK_FALSE(contact::first_mesh_hit(Ray<double>{{1, 1, 5}, {0, 0, -infinity}}, box));
  CHECK_FALSE(contact::first_mesh_hit(Ray<double>{{std::nan(""), 1, 5}, {0, 0, -1}}, box));
  CHECK_FALSE(contact::any_mesh_hit(Ray<double>{{1, 1, 5}, {0, 0, -1}}, Mesh<double>{}));
  CHECK(contact::all_mesh_hits(Ray<double>{{1, 1, 5}, {0, 0, -1}}, Mesh<double>{}).empty());
}

TEST_CASE("a determinant that overflows is not a t of 0") {
  // The products of the larger triangle are beyond the largest double, those of the smaller are
  // not.
  Mesh<double> mesh;
  for (const double size : {0x1p291, 0x1p288}) {
    const int at = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {{size, -size, -size}, {size, 2 * size, -size}, {size, -size, 2 * size}});
    mesh.triangles.push_back({at, at + 1, at + 2});
  }
  const Ray<double> ray{{0, 0, 0}, {0x1p444, 0, 0}};
  const auto all = contact::all_mesh_hits(ray, mesh);
  REQUIRE(all.size() == 2);
  CHECK(all[0].triangle == 1);
  CHECK(all[0].hit.t == 0x1p-156);
  CHECK(all[1].hit.t == 0x1p-153);
  CHECK(same(*contact::first_mesh_hit(ray, mesh), all[0]));
}

TEST_CASE("the order of two meetings is that of their exact t, shared vertex and edge or not") {
  Random random(84);
  int shared = 0, other_ties = 0, different = 0;
  for (int m = 0; m < generators::tried(280); ++m) {
    const Mesh<double> mesh = mesh_of_kind(random, m % mesh_kinds);
    for (int i = 0; i < 10; ++i) {
      with_line<double>(line_at(random, mesh), [&](const auto& line) {
        const contact::detail::MeshLine prepared(line);
        std::vector<contact::detail::MeshMeeting> met;
        contact::detail::each_meeting(prepared, mesh, [&met](const auto& meeting) {
          met.push_back(meeting);
          return met.size() == 8;
        });
        for (const auto& x : met) {
          for (const auto& y : met) {
            if (x.triangle == y.triangle) continue;
            const auto of_x = contact::detail::double_triangle(mesh, x.triangle);
            const auto of_y = contact::detail::double_triangle(mesh, y.triangle);
            const int exact = contact::detail::compare_times(line, of_x, of_y);
            REQUIRE(contact::detail::compare_meetings(line, x, y, of_x, of_y) == exact);
            if (contact::detail::meet_at_shared_feature(x, y, of_x, of_y)) {
              ++shared;
            } else {
              ++(exact == 0 ? other_ties : different);
            }
          }
        }
      });
    }
  }
  CHECK(shared > 0);
  CHECK(other_ties > 0);
  CHECK(different > 0);
}

TEST_CASE("triangles one by one leak or count twice where the mesh is met once") {
  Random random(83);
  const Mesh<double> ball = contact::ball_mesh(1.0, 2);
  int more = 0, fewer = 0, watertight_more = 0;
  const int count = generators::tried(2000);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(random.integer(0, 319));
    const auto [a, b, c] = contact::triangle_of(ball, k);
    const Point through = a + random.uniform() * (b - a);
    const Point from = 3 * in_cube(random);
    const Ray<double> ray{from, through - from};
    const std::size_t right = contact::all_mesh_hits(ray, ball).size();
    const auto plain =
        contact::all_hits_by_triangles(ray, ball, [](const auto& line, const auto& triangle) {
          return contact::intersect_moller_trumbore(line, triangle);
        });
    const auto watertight =
        contact::all_hits_by_triangles(ray, ball, [](const auto& line, const auto& triangle) {
          return contact::intersect_watertight(line, triangle);
        });
    if (plain.size() > right) ++more;
    if (plain.size() < right) ++fewer;
    if (watertight.size() > right) ++watertight_more;
  }
  CHECK(more > 0);
  CHECK(fewer > 0);
  CHECK(watertight_more > 0);
}

}  // namespace
