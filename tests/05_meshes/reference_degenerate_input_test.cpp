// What the comments say of degenerate input: empty, no area or direction, not finite, overflow.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/box_tree.hpp>
#include <contact/convex_pieces.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/moving_mesh_certified.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <contact/polyhedra_meet.hpp>
#include <contact/triangulate.hpp>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace degenerate_input {

using namespace contact;
using P = Vector3<double>;
using Frame = CoordinateFrame<double>;
using Line = Segment<double>;
using Box = Aabb<double>;
using Motion = RigidMotion<double>;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double large = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

const Mesh<double> empty;
const Mesh<double> cube = box_mesh({0, 0, 0}, {1, 1, 1});
const Mesh<double> flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
const Mesh<double> face{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
const Line through{{0.3, 0.4, -1}, {0.3, 0.4, 3}};

Frame at(double x) { return {P(x, 0, 0), Matrix3<double>::Identity()}; }
Motion moving(const P& by, const P& rotation) { return {Frame{}, by, rotation}; }
bool none_finite(const P& v) { return !is_finite(v[0]) && !is_finite(v[1]) && !is_finite(v[2]); }

TEST_CASE("degenerate input: trees of boxes") {
  BoxHierarchy<double> none;
  refit_box_hierarchy<double>(none, {});
  CHECK(none.nodes.empty());
  CHECK(build_box_hierarchy<double>({}, {}, 4).nodes.empty());
  CHECK(hierarchy_cost<double>(none, {}) == 0);
  const auto fail = [](const auto&) -> bool { throw std::logic_error("called"); };
  CHECK_FALSE(visit_box_hierarchy<double>(none, fail, fail));
  CHECK_FALSE(MeshTree<double>(empty).visit(fail, [](int) { return true; }));
  std::vector<int> items(60);
  for (int i = 0; i < 60; ++i) items[std::size_t(i)] = i;
  for (const double odd : {nan, inf, -inf, large, tiny}) {
    std::vector<Box> boxes;
    for (int i = 0; i < 60; ++i) {
      const P p(i % 3 == 0 ? odd : i, i % 5, i % 4 == 0 ? -odd : 0.5 * i);
      boxes.push_back({p, p});
    }
    auto tree = build_box_hierarchy<double>(boxes, items, 4);
    const double cost = hierarchy_cost<double>(tree, boxes);
    CHECK((!is_finite(odd) || (cost > 0 && cost < double(tree.nodes.size()))));
    std::sort(tree.order.begin(), tree.order.end());
    CHECK(tree.order == items);
  }
}

TEST_CASE("degenerate input: cells and pieces") {
  HomogeneousPoint point;
  CHECK(side_of_plane(exact_plane_through({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), point) == 0);
  point.scaled = Vector3<Exact>(Exact(large) * 2.0, Exact(large) * -2.0, Exact(tiny) * 0.5);
  CHECK(nearest(point) == P(inf, -inf, 0));
  ConvexPiece piece;
  CHECK(piece.volume().sign() == 0);
  CHECK(volume_of_pieces({}).sign() == 0);
  piece.vertices = {point, point};
  piece.facets = {{}, {0}, {0, 1}};
  CHECK(piece.volume().sign() == 0);
  CHECK(rounded_piece(piece).triangles.empty());
  CHECK(rounded_piece(piece).vertices[0] == P(inf, -inf, 0));
}

TEST_CASE("degenerate input: checks and edges of meshes") {
  CHECK(check_mesh(empty).ok());
  CHECK_FALSE(check_mesh(empty).bounds_solid());
  CHECK(check_mesh(empty).count(MeshFaultKind::no_area) == 0);
  const Mesh<double> mesh{
      {{0, 0, 0}, {-0.0, 0, 0}, {nan, 0, 0}, {nan, 0, 0}, {inf, 0, 0}, {inf, 0, 0}},
      {{1, 3, 5}, {-1, 9, 1}}};
  CHECK(merge_equal_vertices(mesh).triangles ==
        std::vector<std::array<int, 3>>{{0, 3, 5}, {-1, 9, 0}});
  CHECK(mesh_edges(mesh).size() == 3);
  CHECK(mesh_edges(flat).size() == 3);
  CHECK(third_vertex({4, 5, 4}, {4, 5}) == 4);
  CHECK(third_vertex({7, 2, 3}, {7, 8}) == 2);
  const MeshFault fault{MeshFaultKind::vertex_not_finite, {}, {4}};
  CHECK(text(fault, mesh) == "vertex 4 is not finite: (inf, 0, 0)");
}

TEST_CASE("degenerate input: changed meshes") {
  Mesh<double> odd = face;
  odd.vertices = {{nan, -inf, 0}, {large, 0, tiny}, {0, 1, 0}, {9, 9, 9}};
  CHECK(transformed<double>(empty, at(1)).vertices.empty());
  CHECK(none_finite(transformed<double>(odd, at(0)).vertices[0]));
  CHECK(transformed<double>(odd, at(large)).vertices[1].x() == inf);
  for (const P& v : transformed<double>(face, at(nan)).vertices) CHECK(std::isnan(v.x()));
  CHECK(translated<double>(odd, P(large, 0, 0)).vertices[1] == P(inf, 0, tiny));
  for (const P& v : translated<double>(cube, P(0, nan, 0)).vertices) CHECK(std::isnan(v.y()));
  CHECK(triangle_soup<double>(odd).vertices.size() == 3);
  odd.triangles = {{-1, 7, 2}};
  CHECK(joined<double>(face, odd).triangles[1] == std::array{2, 10, 5});
  CHECK(inside_out<double>(odd).triangles[0] == std::array{-1, 2, 7});
  CHECK(rounded_mesh<float>(odd).vertices[1] == P(inf, 0, 0).cast<float>());
}

TEST_CASE("degenerate input: lines and points at meshes") {
  const auto method = [](const Line& line, const Triangle<double>& triangle) {
    return intersect_moller_trumbore(line, triangle);
  };
  using Query = std::pair<Line, Mesh<double>>;
  const std::vector<Query> misses{{through, empty},
                                  {{{0.5, 0, -1}, {0.5, 0, 1}}, flat},
                                  {{{0.3, 0.4, 0}, {0.3, 0.4, 0}}, cube},
                                  {{{0.3, 0.4, -1}, {0.3, 0.4, inf}}, cube},
                                  {{{0.3, nan, -1}, {0.3, 0.4, 1}}, cube}};
  for (const auto& [line, mesh] : misses) {
    CHECK_FALSE(any_mesh_hit(line, mesh));
    CHECK(all_mesh_hits(line, mesh).empty());
    CHECK(all_hits_by_triangles<double>(line, mesh, method).empty());
    CHECK_FALSE(segment_against_moving_mesh(line, mesh, at(0), at(0)));
    CHECK_FALSE(segment_against_mesh_by_delta<double>(line, mesh, Matrix4<double>::Identity()));
    CHECK_FALSE(segment_against_present_mesh(line, mesh, at(0)));
    CHECK_FALSE(moving_by_substeps(line, mesh, Motion{}, 3));
  }
  const P inside(0.3, 0.4, 0.6);
  for (const P& direction : {P(0, 0, 0), P(nan, 1, 0), P(inf, 1, 0.5), P(1, 0, -inf)}) {
    CHECK(crossings_by_triangles(inside, cube, direction) == 0);
    CHECK(in_by_parity(inside, cube, direction) == Where::outside);
  }
  Mesh<double> odd = cube;
  odd.vertices[7].z() = inf;
  for (const P& p : {P(nan, 0.4, 0.6), P(0.3, inf, 0.6), P(0.3, 0.4, -inf)}) {
    CHECK(crossings_by_triangles(p, cube, P(1, 0, 0)) == 0);
    CHECK(where_by_solid_angles(p, cube) == Where::outside);
    CHECK(in_by_random_rays(p, cube).cast == 0);
  }
  CHECK(where_by_solid_angles(inside, odd) == Where::outside);
  CHECK(where_by_solid_angles(inside, empty) == Where::outside);
  for (const double bound : {inf, nan}) CHECK_FALSE(SolidAngleWinding{1, bound}.certain());
  CHECK_FALSE(polyhedra_meet(cube, odd).meet);
  odd = cube;
  odd.vertices.push_back(P(nan, 0, 0));  // no triangle uses it
  CHECK(polyhedra_meet(cube, odd).meet);
  CHECK(certified_moving_hit(through, odd, Motion{}).verdict == MotionVerdict::undecided);
  CHECK_THROWS_AS(triangulate_in_space<double>(
                      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, nan}, {2, 1, 0}, {1, 2, 0}}}),
                  std::invalid_argument);
}

TEST_CASE("degenerate input: frames, paths and motions") {
  const auto matrix = [](double x) { return homogeneous_matrix(at(x)); };
  for (const double x : {nan, inf}) {
    CHECK_FALSE(all_finite(inverse_of_frame_matrix<double>(matrix(x))));
    CHECK_FALSE(all_finite(delta_matrix<double>(matrix(0), matrix(x))));
    CHECK_FALSE(all_finite(delta_matrix_rows<double>(matrix(0), matrix(x).transpose())));
    CHECK(none_finite(carried_column<double>(matrix(0), P(x, 0, 0))));
    CHECK(none_finite(carried_row<double>(P(x, 0, 0), matrix(0))));
    CHECK(none_finite(carried_in_body(at(0), at(0), P(x, 0, 0))));
    CHECK_FALSE(all_finite(chord_in_body(through, at(x), at(0)).start));
    CHECK_FALSE(segment_against_moving_mesh(through, cube, at(0), at(x)));
    CHECK_FALSE(segment_against_present_mesh(through, cube, at(x)));
    CHECK_FALSE(segment_against_mesh_by_delta<double>(through, cube, matrix(x)));
    for (int k = 0; k < 9; ++k) {
      Frame odd = frame_on_normal<double>(P(0, 0, 0), P(1, 2, 3));
      odd.axes(k / 3, k % 3) = x;
      CHECK(none_finite(motion_between(at(0), odd).rotation));
      odd = Frame{};
      odd.origin[k % 3] = x;
      CHECK(delta_matrix_rounding(at(0), odd, P(1, 2, 3)) == inf);
      CHECK(carried_in_body_rounding(at(0), odd, P(1, 2, 3)) == inf);
      CHECK_FALSE(moving_by_substeps(through, cube, moving(P::Zero(), odd.origin), 3));
      const Motion away = moving(odd.origin, P(0, 0, 1));
      CHECK_FALSE(all_finite(path_in_body<double>(away, through, 0.5)));
      CHECK_FALSE(all_finite(frame_at<double>(away, 0.5).origin));
    }
  }
  CHECK(carried_in_body_rounding(at(0), at(large), P(large, 0, 0)) == inf);  // the sum overflows
  CHECK(perpendicular_part<double>(P(1, 2, 3), P(0, 0, 0)) == P(1, 2, 3));
  const Motion rotation = moving(P::Zero(), P(0, 0, 1));
  CHECK(frame_at<double>(Motion{}, 0.5).axes == Frame{}.axes);
  CHECK(chord_bound<double>(1, 1, 1, 0) == inf);
  CHECK(std::isnan(chord_bound<double>(0, 1, 1, 0)));
  CHECK(chord_bound<double>(rotation, through, 0) == inf);
  CHECK(chord_bound<double>(Motion{}, through, 0) == 0);
  CHECK(certified_moving_hit(through, empty, rotation).verdict == MotionVerdict::free);
  CHECK(certified_moving_hit(through, cube, rotation, 0).chords == 1);
}

}  // namespace degenerate_input
