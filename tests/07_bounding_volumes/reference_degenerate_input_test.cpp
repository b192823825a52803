// What the comments of the headers say of degenerate input: 0, infinite numbers, NaN, overflow.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/moving_volumes.hpp>
#include <contact/pairs_spared.hpp>
#include <contact/smallest_rectangle.hpp>
#include <contact/welzl_sphere.hpp>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

namespace degenerate_input {
namespace {

using namespace contact;
using Point = Vector3<double>;
using Axes = Matrix3<double>;
using Box = Aabb<double>;
using Oriented = OrientedBox<double>;
using Dop = Kdop<double>;
using Number = BoundedDoubleDouble;
using Refusal = std::invalid_argument;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr std::array<double, 3> not_finite{infinity, -infinity, nan};
const Axes world = Axes::Identity(), no_axes = Axes::Zero();
const Point zero(0, 0, 0), ones(1, 1, 1);

Dop cube(double h) { return {kdop_normals<double>(6), {-h, -h, -h}, {h, h, h}}; }
/// The cube of half edge 1 with the planes of an octahedron that cut its corners.
Dop cut_cube() {
  return {kdop_normals<double>(14), {-1, -1, -1, -2, -2, -2, -2}, {1, 1, 1, 2, 2, 2, 2}};
}
std::vector<Point> tetrahedron(double size) {
  return {zero, Point(size, 0, 0), Point(0, size, 0), Point(0, 0, size)};
}

TEST_CASE("bounded double-doubles have no sign after an infinite number, NaN or a division by 0") {
  CHECK(Number(infinity).certain_sign() == 1);
  CHECK(Number(nan).certain_sign() == 0);
  for (const double x : not_finite) {
    for (const double y : {1.0, -2.0, x}) {
      const Number a(x), b(y);
      for (const Number& z : {a + b, a - b, a * b, a / b, b / a}) CHECK(z.certain_sign() == 0);
    }
    CHECK((Number(x) * 0.0).is_zero());
  }
  CHECK((Number(0) / Number(infinity)).is_zero());
  for (const Number& y : {Number(0), Number(1e-20, 0, 1), Number(nan)}) {
    for (const double x : {0.0, 1.0}) CHECK((Number(x) / y).bound == infinity);
  }
}

TEST_CASE("the lecture's tests for a point in a box: an axis 0, and numbers that are not finite") {
  const Oriented box{zero, world, ones};
  CHECK(inside_six_planes(Oriented{zero, no_axes, ones}, Point(9, 9, 9)));
  CHECK(between_each_pair(Oriented{zero, no_axes, ones}, Point(9, 9, 9)));
  for (const double x : not_finite) {
    Oriented far = box, wide = box, broken = box;
    far.centre.y() = wide.half_lengths.y() = broken.axes(1, 1) = x;
    for (const Oriented& b : {far, wide}) CHECK_FALSE(inside_six_planes(b, zero));
    CHECK((!std::isnan(x) || !inside_six_planes(broken, zero)));
    CHECK_FALSE(inside_six_planes(box, Point(0, x, 0)));
    CHECK_FALSE(between_each_pair(box, Point(0, x, 0)));
    for (const Oriented& b : {far, broken}) CHECK_FALSE(between_each_pair(b, zero));
    CHECK(between_each_pair(wide, zero) == (x == infinity));
  }
}

TEST_CASE("k-DOPs carried along: ends that are infinite or NaN, empty ones, overflow") {
  Dop open = cut_cube(), endless = cube(1), empty = cut_cube(), none = cut_cube();
  open.high[0] = endless.high[0] = infinity;
  CHECK(std::abs(carried(open, {}).high[0] - 2) < 1e-12);
  empty.low[0] = 1, empty.high[0] = -1;
  CHECK_NOTHROW(carried(empty, {}));
  CHECK(carried(Dop{}, {}).low.empty());
  for (const double x : {infinity, nan}) {
    none.low[3] = x;
    CHECK_THROWS_AS(carried(none, {}), Refusal);
  }
  for (const Dop& dop : {endless, cube(1e308)}) CHECK_THROWS_AS(carried(dop, {}), Refusal);
}

TEST_CASE("axes that are 0, large or not finite: their stretch, boxes and rotations with them") {
  CHECK(std::abs(stretch_of(no_axes) / 0x1p-500 - 1) < 1e-14);
  CHECK(stretch_of(Axes(1e160 * world)) == infinity);
  CHECK(sagitta(world, Axes(Point(-1, -1, 1).asDiagonal()), largest) == infinity);
  for (const double x : not_finite) {
    for (int k = 0; k < 9; ++k) {
      Axes axes = world;
      axes(k / 3, k % 3) = x;
      CHECK_FALSE(std::isfinite(stretch_of(axes)));
      CHECK_THROWS_AS(carried(Oriented{zero, axes, ones}, {}), Refusal);
      CHECK_THROWS_AS(sagitta(world, axes, 1.0), Refusal);
      CHECK_THROWS_AS(sagitta(axes, world, 1.0), Refusal);
    }
  }
}

TEST_CASE("volumes of motions: no rotation, no normal, no box, overflow") {
  const Quaternion<double> one{1, zero}, half_turn{0, Point(1, 0, 0)};
  CHECK_THROWS_AS(sagitta(one, Quaternion<double>{0, zero}, 1.0), Refusal);
  CHECK_THROWS_AS(sagitta(one, half_turn, largest), Refusal);
  Dop dop = cube(1);
  dop.high[0] = dop.high[1] = largest;
  dop.normals[1].setZero();
  CHECK(swept(dop, Point(largest, 1, 0)).high[0] == infinity);
  CHECK(swept(dop, Point(largest, 1, 0)).high[1] == largest);
  CHECK(swept(cube(-1), Point(3, 0, 0)).high[0] == 2);  // low stays 1
  CHECK_NOTHROW(aabb_of_motion(Box{ones, zero}, Box{zero, Point(1, nan, 1)}, 0.0));
}

TEST_CASE("facets and volumes of k-DOPs: of any size, empty, without an end, NaN, no normal") {
  for (const auto& [size, facets, cubic] :
       std::vector<std::array<double, 3>>{{1e-308, 6, 0},
                                          {1, 6, 8},
                                          {1e150, 6, infinity},
                                          {1e306, 6, infinity},
                                          {5e307, 0, infinity},
                                          {largest, 0, infinity},
                                          {0, 0, 0},
                                          {-1, 0, 0}}) {
    CAPTURE(size);
    CHECK(static_cast<double>(kdop_facets(cube(size)).size()) == facets);
    CHECK(kdop_vertices(cube(size)).empty() == (facets == 0));
    CHECK(static_cast<float>(volume(cube(size))) == static_cast<float>(cubic));
  }
  Dop open = cut_cube(), empty = open, less = open;
  open.high[4] = infinity;
  CHECK(kdop_facets(open).size() == 13);
  for (const double x : {infinity, nan}) {
    empty.low[0] = x;
    CHECK(kdop_facets(empty).empty());
    CHECK(volume(empty) == 0);
  }
  for (const double x : {0.0, infinity, nan}) {
    less.normals[3] = x * ones;
    CHECK(kdop_facets(less).size() == 12);
  }
  Dop octagon{plane_dop_normals<double>(8), {-1, -1, -1.5, -1.5}, {1, 1, 1.5, 1.5}};
  for (const auto& [end, vertices] :
       std::vector<std::array<double, 2>>{{1.5, 8}, {infinity, 7}, {-infinity, 0}, {nan, 0}}) {
    octagon.high[2] = end;
    CHECK(static_cast<double>(plane_dop_vertices(octagon).size()) == vertices);
  }
  for (double& x : octagon.high) x = 1e308;
  CHECK(plane_dop_vertices(octagon).empty());
}

TEST_CASE("comparisons of boxes and rectangles that are none") {
  const Box unit{zero, ones}, inside_out{Point(0.6, 0, 0), Point(0.4, 1, 1)};
  CHECK(may_meet(unit, inside_out));
  CHECK(may_meet(unit, Box{Point(-infinity, 0, 0), Point(infinity, 1, 1)}));
  const Vector2<double> none(0, 0), half(1, 1);
  CHECK_FALSE(contains(Rectangle<double>{none, none, half}, none));
}

TEST_CASE("Welzl's sphere where products overflow or underflow") {
  const auto radius = [](const std::vector<Point>& p) { return welzl_sphere<double>(p).radius; };
  CHECK(radius({zero, Point(1e200, 0, 0)}) == infinity);
  CHECK(radius({zero, Point(1e-200, 0, 0)}) == 0);
  for (const double size : {1e100, 1e-100}) CHECK(std::isnan(radius(tetrahedron(size))));
}

TEST_CASE("volumes in cubic metres: flat, inside out, infinite, NaN, overflow") {
  const auto ball = [](double r) { return volume(Sphere<double>{Point(nan, 0, 0), r}); };
  const auto box = [](const Point& edges) { return volume(Box{zero, edges}); };
  const auto oriented = [](const Point& half, const Axes& axes = world) {
    return volume(Oriented{zero, axes, half});
  };
  CHECK((ball(0) == 0 && ball(-1) < 0 && ball(1e103) == infinity && std::isnan(ball(nan))));
  for (const Point& flat : {Point(1e200, 1e200, 0), Point(infinity, 0, 1), Point(nan, 1, 0)}) {
    CHECK((box(flat) == 0 && oriented(flat) == 0));
  }
  for (const Point& large : {Point(1e200, 1e200, 1), Point(1, infinity, 1)}) {
    CHECK((box(large) == infinity && oriented(large) == infinity));
  }
  CHECK((box(Point(-1, 1, 1)) == -1 && oriented(Point(-1, 1, 1)) == -8));
  CHECK((std::isnan(box(Point(1, nan, 1))) && std::isnan(oriented(Point(1, nan, 1)))));
  CHECK(volume(Box{Point(0, 0, -largest), Point(1e-200, 1e-200, largest)}) == 0);
  CHECK(oriented(ones, no_axes) == 0);
  CHECK_FALSE(std::isfinite(oriented(ones, Axes(infinity * world))));
  CHECK((mesh_of(Hull{}, {}).triangles.empty() && volume(Hull{}, {}) == 0));
  CHECK(volume(convex_hull(tetrahedron(1)), tetrahedron(1e200)) == infinity);
  const std::vector<Point> thin{
      {0, 0, 0}, {0x1p400, 0, 0}, {0x1p400, 0x1p400, 0}, {0x1p400, 0, 0x1p200}};
  CHECK(std::abs(volume(convex_hull(tetrahedron(1)), thin)) == 0x1p1000 / 6);
}

TEST_CASE("solids without triangles, kinds and shapes that do not exist, no pairs, no axes") {
  const Mesh<double> mesh = mesh_of(convex_hull(tetrahedron(1)), tetrahedron(1));
  Mesh<double> broken = mesh;
  for (Point& p : broken.vertices) p.x() = nan;
  for (const Mesh<double>& none : {Mesh<double>{}, broken}) {
    CHECK_FALSE(solids_meet(MeshTree<double>(mesh), MeshTree<double>(none)));
  }
  for (const VolumeKind kind : {VolumeKind(-1), VolumeKind(10)}) {
    CHECK_THROWS_AS(name_of(kind), Refusal);
    CHECK_THROWS_AS(SceneCounts{}.spared(kind), Refusal);
    CHECK_THROWS_AS(SceneCounts{}.false_alarms(kind), Refusal);
    CHECK_THROWS_AS(bounding_volume(kind, mesh.vertices), Refusal);
  }
  const std::vector<MeasuredShape> shapes{{"one", mesh}};
  CHECK(count_pairs(shapes, std::vector<PlacedBody>(1)).pairs == 0);
  for (const int shape : {-1, 1}) {
    CHECK_THROWS_AS(count_pairs(shapes, std::vector<PlacedBody>{{shape, {}}}), Refusal);
  }
  for (const VolumeKind kind : all_volume_kinds) {
    const BoundingVolume made = bounding_volume(kind, mesh.vertices);
    const auto carry = [&] { return carried(made, {zero, no_axes}); };
    if (std::holds_alternative<Oriented>(made.shape)) CHECK_THROWS_AS(carry(), Refusal);
    if (!std::holds_alternative<Oriented>(made.shape)) CHECK(volume(carry()) < 1e-300);
  }
}

}  // namespace
}  // namespace degenerate_input
